#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "symscene/viewer/run_page.hpp"

namespace symscene {

/// A closed box with the given size that stands on z = 0. [m]
inline TriangleMesh standing_box(float x, float y, float z) {
  TriangleMesh mesh;
  mesh.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.row(i) << ((i & 1) != 0 ? x : -x) / 2, ((i & 2) != 0 ? y : -y) / 2,
        (i & 4) != 0 ? z : 0.0F;
  }
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6,
      0, 6, 2, 1, 3, 7, 1, 7, 5;
  return mesh;
}

inline Eigen::Isometry3d placed_at(double x, double y, double z, double yaw = 0.0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  pose.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

/// An arm of one link turns, and carries the first of two boxes from the table into a bin.
inline RunRecording carried_box(int moments = 41) {
  RunRecording run;
  run.solids = {{"link", standing_box(0.5F, 0.1F, 0.1F), RecordedKind::robot},
                {"hand", standing_box(0.05F, 0.1F, 0.1F), RecordedKind::hand},
                {"sugar", standing_box(0.05F, 0.08F, 0.17F), RecordedKind::object},
                {"brick", standing_box(0.2F, 0.06F, 0.07F), RecordedKind::object},
                {"bin", standing_box(0.3F, 0.3F, 0.02F), RecordedKind::bin},
                {"table", standing_box(1.5F, 1.5F, 0.01F), RecordedKind::table}};
  for (int i = 0; i < moments; ++i) {
    const double yaw = std::numbers::pi / 2 * i / (moments - 1);
    const Eigen::Isometry3d turn = placed_at(0.0, 0.0, 0.0, yaw);
    run.times.push_back(0.1 * i);
    run.poses.push_back({turn * placed_at(0.25, 0.0, 0.3), turn * placed_at(0.5, 0.0, 0.2),
                         turn * placed_at(0.5, 0.0, 0.02), placed_at(0.4, -0.3, 0.0),
                         placed_at(0.0, 0.5, 0.0), placed_at(0.2, 0.0, -0.01)});
  }
  TriangleMesh believed = run.solids[2].mesh;
  believed.vertices.col(0).array() += 0.505F;
  run.beliefs = {{0.1, {{"object 1", believed, "box 0.93"}}}, {4.0, {}}};
  run.events = {{0.1, "Look 1", RecordedOutcome::note},
                {2.0, "The hand met the brick", RecordedOutcome::failure},
                {4.0, "Picked the sugar", RecordedOutcome::success}};
  run.left = {"brick: out of reach"};
  return run;
}

}  // namespace symscene
