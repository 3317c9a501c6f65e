#include "symmetry/symmetry_score.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "random_features.hpp"

namespace symscene {
namespace {

// Probabilities from the tables of version 0.1.0, before they became the files in models/.
constexpr std::array axis_reference{
    0.83824710218593568,  0.33488582717889454, 0.18395681317175139, 0.63918683650681341,
    0.083795314501617341, 0.18663500340376304, 0.14314790666695479, 0.53220215339455823,
    0.20996690677907867,  0.76984374644570308, 0.5738511494990145,  0.10750084509692422,
    0.17576654174672574,  0.434932602992888,   0.88135738924716944, 0.43691506283568465,
    0.79983077003822434,  0.93403102866338394, 0.59394323887998646, 0.2347192916441421,
    0.39617005575158504,  0.61876005569511039, 0.85152237840191258, 0.1447992807335067};
constexpr std::array plane_reference{
    0.022787043855577033,  0.002134147776033918,   0.0055386741778455885,  0.021066291919604699,
    0.0028655344440446638, 0.00075092739209416549, 0.0021602358239426319,  0.00545237481469504,
    0.0010906382807076838, 0.0022398221182726723,  0.00094156557674001501, 0.018428666210482645,
    0.0038760751223230151, 0.0028970613654451102,  0.051066602379815147,   0.033225640717182495,
    0.0013829178704078799, 0.0053269905682958914,  0.00089137337749383338, 0.0025788358091152507,
    0.0025272253923205026, 0.0027337535241704776,  0.017280851878907943,   0.040921408218923816};

TEST(SymmetryScore, OfTheEmbeddedModelsIsThatOfTheFormerTables) {
  Random axes(29), planes(29);
  for (const double expected : axis_reference)
    EXPECT_DOUBLE_EQ(axis_probability(testing::random_features<AxisFeatures>(axes)), expected);
  for (const double expected : plane_reference)
    EXPECT_DOUBLE_EQ(plane_probability(testing::random_features<PlaneFeatures>(planes)), expected);
}

TEST(SymmetryScore, ComesFromTheModelThatIsGiven) {
  const TreeModel even("axis", axis_model().features(), 0.0F, {});
  EXPECT_EQ(axis_probability({}, even), 0.5);
  EXPECT_NE(axis_probability({}), 0.5);
}

TEST(SymmetryScore, ModelsRecordTheirOrigin) {
  for (const TreeModel* model : {&axis_model(), &plane_model()}) {
    EXPECT_GT(model->trees(), 0U);
    EXPECT_FALSE(model->origin().command.empty());
    EXPECT_FALSE(model->origin().data.empty());
  }
}

}  // namespace
}  // namespace symscene
