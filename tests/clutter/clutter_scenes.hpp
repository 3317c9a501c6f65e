#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "symscene/clutter/clutter_objects.hpp"

namespace symscene {

/// The surface of a box around the origin, outside counter-clockwise.
inline TriangleMesh box_surface(const Eigen::Vector3f& size) {
  TriangleMesh mesh;
  mesh.vertices.resize(8, 3);
  for (int k = 0; k < 8; ++k)
    mesh.vertices.row(k) << (k & 1 ? 0.5F : -0.5F) * size.x(), (k & 2 ? 0.5F : -0.5F) * size.y(),
        (k & 4 ? 0.5F : -0.5F) * size.z();
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
      2, 4, 6, 1, 3, 5, 3, 7, 5;
  return mesh;
}

inline ClutterObject box_object(const std::string& name, const Eigen::Vector3f& size) {
  const TriangleMesh surface = box_surface(size);
  return {name, 0.1, surface, {surface.vertices}};
}

/// Three boxes that the hand can hold.
inline std::vector<ClutterObject> box_objects() {
  return {box_object("cube", {0.05F, 0.05F, 0.05F}), box_object("tower", {0.04F, 0.05F, 0.12F}),
          box_object("brick", {0.04F, 0.09F, 0.05F})};
}

}  // namespace symscene
