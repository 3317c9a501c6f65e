#pragma once

#include <string>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A thing that can stand on a table, in its own frame: as built, or as scanned.
struct ObjectModel {
  std::string name;
  TriangleMesh mesh;                    ///< closed; coloured where colours are known
  std::vector<TrueAxis> rotational;     ///< as far as they are known
  std::vector<TruePlane> reflectional;  ///< as far as they are known
  bool sphere = false;                  ///< any axis through its centre is right
};

}  // namespace symscene
