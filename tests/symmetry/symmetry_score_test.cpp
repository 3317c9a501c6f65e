#include "symmetry/symmetry_score.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

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
