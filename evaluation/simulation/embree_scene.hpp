#pragma once

#if __has_include(<embree4/rtcore.h>)  // Ubuntu 24.04; Debian 12 has Embree 3
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <array>
#include <span>
#include <vector>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Meshes and Embree's tree over them. Geometry k of the tree is mesh k.
class EmbreeScene {
 public:
  explicit EmbreeScene(std::span<const TriangleMesh> meshes);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCScene scene() const { return scene_; }
  const TriangleMesh& mesh(Index k) const { return meshes_[k]; }
  std::array<Eigen::Vector3d, 3> corners(Index mesh, Index triangle) const;

 private:
  void attach(const TriangleMesh& mesh);
  void release();

  std::vector<TriangleMesh> meshes_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace symscene
