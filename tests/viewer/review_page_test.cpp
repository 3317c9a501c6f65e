#include "symscene/viewer/review_page.hpp"

#include <gtest/gtest.h>

#include <limits>

#include <nlohmann/json.hpp>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

ReviewedModel triangle(const std::string& name) {
  ReviewedModel model;
  model.name = name;
  model.mesh.vertices.resize(3, 3);
  model.mesh.vertices << 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F;
  model.mesh.triangles.resize(1, 3);
  model.mesh.triangles << 0, 1, 2;
  model.millimetres = 1000.0;
  model.diameter = 1.5;
  model.diagonal = 2.0;
  model.symmetries.push_back(
      {ReviewedSymmetry::Kind::axis, 3, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), 0.01});
  return model;
}

nlohmann::json payload_of(const std::string& page) {
  const std::string before = "id=\"payload\">";
  const std::size_t begin = page.find(before) + before.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(ReviewPage, HoldsResidualsInMillimetresAndPercent) {
  const auto model = payload_of(render_review_page({triangle("a")}, "t")).at("models").at(0);
  EXPECT_EQ(model.at("diagonal_mm"), 2000.0);
  const auto& symmetry = model.at("symmetries").at(0);
  EXPECT_EQ(symmetry.at("kind"), "axis");
  EXPECT_EQ(symmetry.at("order"), 3);
  EXPECT_DOUBLE_EQ(symmetry.at("residual_mm").get<double>(), 10.0);
  EXPECT_DOUBLE_EQ(symmetry.at("residual_percent").get<double>(), 0.5);
}

TEST(ReviewPage, KeepsNamesOutOfTheMarkup) {
  const std::string name = "</script><script>alert(1)</script>";
  const std::string page = render_review_page({triangle(name)}, name);
  EXPECT_EQ(page.find(name), std::string::npos);
  EXPECT_EQ(payload_of(page).at("models").at(0).at("name"), name);
}

TEST(ReviewPage, ShowsAModelWithoutTrianglesAsPoints) {
  ReviewedModel model = triangle("cloud");
  model.mesh.triangles.resize(0, 3);
  const auto shown = payload_of(render_review_page({model}, "t")).at("models").at(0);
  EXPECT_TRUE(shown.at("surface").is_null());
  EXPECT_TRUE(shown.contains("points"));
}

TEST(ReviewPage, RefusesPositionsThatAreNotFinite) {
  ReviewedModel model = triangle("a");
  model.mesh.vertices(1, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(render_review_page({model}, "t"), InputError);
}

}  // namespace
}  // namespace symscene
