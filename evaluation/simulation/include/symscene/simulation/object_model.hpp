#pragma once

#include <string>
#include <vector>

#include "symscene/core/triangle_mesh.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene {

/// An object that can stand on a table, procedural or scanned, in its own frame. [m]
struct ObjectModel {
  std::string name;
  TriangleMesh mesh;                    ///< closed; with colours if they are known
  std::vector<TrueAxis> rotational;     ///< the known ones
  std::vector<TruePlane> reflectional;  ///< the known ones
  bool sphere = false;                  ///< every axis through its centre is a symmetry
};

}  // namespace symscene
