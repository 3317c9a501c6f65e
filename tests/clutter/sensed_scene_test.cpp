#include "clutter/sensed_scene.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

/// The view from the side of a bare table, with all depths multiplied by `scale`.
ClutterView view_of_bare_table(double scale) {
  const CameraIntrinsics camera = clutter_camera();
  const Eigen::Isometry3d T_world_camera = clutter_view_poses(1).front();
  ClutterView view{{0.0, std::vector<float>(camera.pixels()), {}}, T_world_camera};
  const double height = T_world_camera.translation().z() - clutter::table_height;
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const double descent = -(T_world_camera.linear() * camera.ray(u, v)).z();
      const double depth = descent > 0.0 ? height / descent : 0.0;
      if (depth < 1.0)
        view.frame.depth[std::size_t{v} * camera.width + u] = static_cast<float>(scale * depth);
    }
  }
  return view;
}

Scene scene_of_bare_table(double scale, TableKnowledge table) {
  const ClutterView view = view_of_bare_table(scale);
  ClutterMethodOptions options;
  options.table = table;
  return sensed_scene({&view, 1}, options);
}

TEST(SensedScene, IsEmptyWhereTheTableIsSeenOffItsGivenPlane) {
  const Scene scene = scene_of_bare_table(1.1, TableKnowledge::plane);
  EXPECT_TRUE(scene.cloud.empty());
  EXPECT_EQ(scene.warnings, std::vector<std::string>{"no surface is seen at the table"});
}

TEST(SensedScene, OfABareTableIsEmptyWhereItsPlaneIsSeen) {
  for (const auto& [scale, table] :
       {std::pair{1.0, TableKnowledge::plane}, std::pair{1.1, TableKnowledge::scale}}) {
    const Scene scene = scene_of_bare_table(scale, table);
    EXPECT_TRUE(scene.table);
    EXPECT_TRUE(scene.cloud.empty());
  }
}

}  // namespace
}  // namespace symscene
