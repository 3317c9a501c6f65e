#include "embree_scene.hpp"

#include <algorithm>
#include <stdexcept>

namespace symscene {

EmbreeScene::EmbreeScene(std::span<const TriangleMesh> meshes)
    : meshes_(meshes.begin(), meshes.end()), device_(rtcNewDevice(nullptr)) {
  if (device_ == nullptr) throw std::runtime_error("the ray caster does not start");
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  try {
    for (const TriangleMesh& mesh : meshes_) attach(mesh);
  } catch (...) {
    release();
    throw;
  }
  rtcCommitScene(scene_);
}

EmbreeScene::~EmbreeScene() { release(); }

void EmbreeScene::release() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void EmbreeScene::attach(const TriangleMesh& mesh) {
  const auto vertices = static_cast<std::size_t>(mesh.vertices.rows());
  const auto triangles = static_cast<std::size_t>(mesh.triangles.rows());
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles));
  if (positions == nullptr || indices == nullptr) {
    rtcReleaseGeometry(geometry);
    throw std::runtime_error("no memory for the ray caster's geometry");
  }
  for (std::size_t i = 0; i < vertices; ++i) {
    const Eigen::Vector3f p = mesh.vertices.row(static_cast<Eigen::Index>(i)).transpose();
    std::copy_n(p.data(), 3, positions + 3 * i);
  }
  std::copy_n(mesh.triangles.data(), 3 * triangles, indices);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
}

std::array<Eigen::Vector3d, 3> EmbreeScene::corners(Index mesh, Index triangle) const {
  const TriangleMesh& of = meshes_[mesh];
  const auto corner = [&](int k) -> Eigen::Vector3d {
    return of.vertices.row(of.triangles(triangle, k)).transpose().cast<double>();
  };
  return {corner(0), corner(1), corner(2)};
}

}  // namespace symscene
