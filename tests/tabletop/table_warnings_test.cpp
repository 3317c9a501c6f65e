#include "tabletop/table_warnings.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

/// A table at z = 0 with objects on it, and other planes above it, each tilted or not.
TableScene scene_with_others(std::vector<bool> tilted) {
  TableScene scene;
  scene.planes.status = SupportStatus::several;
  scene.objects.cloud.positions.setZero(1, 3);
  tilted.insert(tilted.begin(), false);
  for (std::size_t k = 0; k < tilted.size(); ++k) {
    SupportPlane support;
    support.plane = {Eigen::Vector3d::UnitZ(), -static_cast<double>(k)};
    support.is_tilted = tilted[k];
    scene.planes.supports.push_back(support);
  }
  return scene;
}

TEST(TableWarnings, ListOtherPlanesInOneSentence) {
  const auto warnings = table_warnings(scene_with_others({false, false}));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("0.0000,0.0000,1.0000,-1.0000 "), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("0.0000,0.0000,1.0000,-2.0000 "), std::string::npos) << warnings[0];
}

TEST(TableWarnings, LeaveOutTiltedPlanesWhereALevelOneIsFound) {
  const auto warnings = table_warnings(scene_with_others({true, false, true}));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("0.0000,0.0000,1.0000,-2.0000 "), std::string::npos) << warnings[0];
  EXPECT_EQ(warnings[0].find("0.0000,0.0000,1.0000,-1.0000 "), std::string::npos) << warnings[0];
  EXPECT_TRUE(table_warnings(scene_with_others({true, true})).empty());
  // Without a level one the camera was not held upright: each of them may be the table.
  TableScene tilted = scene_with_others({true, true});
  tilted.planes.supports[0].is_tilted = true;
  EXPECT_EQ(table_warnings(tilted).size(), 1U);
}

}  // namespace
}  // namespace symscene
