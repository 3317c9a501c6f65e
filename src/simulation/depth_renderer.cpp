#include "symscene/simulation/depth_renderer.hpp"

#if __has_include(<embree4/rtcore.h>)  // Ubuntu 24.04; Debian 12 has Embree 3
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace symscene {

struct DepthRenderer::Implementation {
  std::vector<TriangleMesh> meshes;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Implementation() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  void attach(const TriangleMesh& mesh) {
    const auto vertices = static_cast<std::size_t>(mesh.vertices.rows());
    const auto triangles = static_cast<std::size_t>(mesh.triangles.rows());
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
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
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  RTCHit cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    RTCRayHit query{};
    query.ray.org_x = static_cast<float>(origin.x());
    query.ray.org_y = static_cast<float>(origin.y());
    query.ray.org_z = static_cast<float>(origin.z());
    query.ray.dir_x = static_cast<float>(direction.x());
    query.ray.dir_y = static_cast<float>(direction.y());
    query.ray.dir_z = static_cast<float>(direction.z());
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = ~0U;  // builds that honour masks never hit with 0
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &query);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect1(scene, &context, &query);
#endif
    return query.hit;
  }
};

namespace {

struct Triangle {
  Eigen::Vector3d a, b, c;
};

Triangle triangle(const TriangleMesh& mesh, Index t) {
  const auto corner = [&](int k) -> Eigen::Vector3d {
    return mesh.vertices.row(mesh.triangles(t, k)).transpose().cast<double>();
  };
  return {corner(0), corner(1), corner(2)};
}

Eigen::Vector3d interpolated_color(const TriangleMesh& mesh, const RTCHit& hit) {
  if (mesh.colors.rows() == 0) return Eigen::Vector3d::Constant(200.0);
  const auto color = [&](int k) -> Eigen::Vector3d {
    return mesh.colors.row(mesh.triangles(hit.primID, k)).transpose().cast<double>();
  };
  const double u = hit.u, v = hit.v;
  return (1.0 - u - v) * color(0) + u * color(1) + v * color(2);
}

}  // namespace

DepthRenderer::DepthRenderer(std::span<const TriangleMesh> meshes)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->meshes.assign(meshes.begin(), meshes.end());
  implementation_->device = rtcNewDevice(nullptr);
  if (implementation_->device == nullptr) throw std::runtime_error("the ray caster does not start");
  implementation_->scene = rtcNewScene(implementation_->device);
  rtcSetSceneFlags(implementation_->scene, RTC_SCENE_FLAG_ROBUST);
  for (const TriangleMesh& mesh : meshes) implementation_->attach(mesh);
  rtcCommitScene(implementation_->scene);
}

DepthRenderer::~DepthRenderer() = default;
DepthRenderer::DepthRenderer(DepthRenderer&&) noexcept = default;
DepthRenderer& DepthRenderer::operator=(DepthRenderer&&) noexcept = default;

SensorFrame DepthRenderer::render(const CameraIntrinsics& camera,
                                  const Eigen::Isometry3d& T_world_camera) const {
  SensorFrame frame;
  frame.T_world_camera = T_world_camera;
  frame.depth.assign(camera.pixels(), 0.0F);
  frame.objects.assign(camera.pixels(), SensorFrame::nothing);
  frame.cosines.assign(camera.pixels(), 0.0F);
  frame.colors = Colors::Zero(static_cast<Eigen::Index>(camera.pixels()), 3);
  const Eigen::Vector3d origin = T_world_camera.translation();
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const Eigen::Vector3d ray = T_world_camera.linear() * camera.ray(u, v);
      const RTCHit hit = implementation_->cast(origin, ray);
      if (hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
      const TriangleMesh& mesh = implementation_->meshes[hit.geomID];
      // The caster says which triangle; the depth is computed here, in double, because the caster's
      // own differs in its last bits with the processor.
      const auto [a, b, c] = triangle(mesh, hit.primID);
      const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
      const double along = normal.dot(ray);
      if (along == 0.0) continue;
      const double cosine = std::abs(along) / ray.norm();
      const Eigen::Vector3d color = interpolated_color(mesh, hit) * (0.6 + 0.4 * cosine);
      const std::size_t pixel = std::size_t{v} * camera.width + u;
      frame.depth[pixel] = static_cast<float>(normal.dot(a - origin) / along);
      frame.objects[pixel] = hit.geomID;
      frame.cosines[pixel] = static_cast<float>(cosine);
      for (int k = 0; k < 3; ++k) {
        frame.colors(static_cast<Eigen::Index>(pixel), k) =
            static_cast<std::uint8_t>(std::clamp(color[k], 0.0, 255.0));
      }
    }
  }
  return frame;
}

}  // namespace symscene
