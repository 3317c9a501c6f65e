#include "simulation/depth_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "embree_scene.hpp"

namespace symscene {

struct DepthRenderer::Implementation : EmbreeScene {
  using EmbreeScene::EmbreeScene;

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
    rtcIntersect1(scene(), &query);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect1(scene(), &context, &query);
#endif
    return query.hit;
  }
};

namespace {

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
    : implementation_(std::make_unique<Implementation>(meshes)) {}

DepthRenderer::~DepthRenderer() = default;
DepthRenderer::DepthRenderer(DepthRenderer&&) noexcept = default;
DepthRenderer& DepthRenderer::operator=(DepthRenderer&&) noexcept = default;

SensorFrame DepthRenderer::render(const CameraIntrinsics& camera,
                                  const Eigen::Isometry3d& T_world_camera) const {
  return render(camera, T_world_camera, {});
}

SensorFrame DepthRenderer::render(const CameraIntrinsics& camera,
                                  const Eigen::Isometry3d& T_world_camera,
                                  std::span<const Eigen::Vector2d> rays) const {
  SensorFrame frame;
  frame.T_world_camera = T_world_camera;
  frame.depth.assign(camera.pixels(), 0.0F);
  frame.objects.assign(camera.pixels(), SensorFrame::nothing);
  frame.cosines.assign(camera.pixels(), 0.0F);
  frame.colors = Colors::Zero(static_cast<Eigen::Index>(camera.pixels()), 3);
  const Eigen::Vector3d origin = T_world_camera.translation();
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const std::size_t pixel = std::size_t{v} * camera.width + u;
      const Eigen::Vector3d ray_camera =
          rays.empty() ? camera.ray(u, v) : Eigen::Vector3d(rays[pixel].homogeneous());
      if (!ray_camera.allFinite()) continue;
      const Eigen::Vector3d ray = T_world_camera.linear() * ray_camera;
      const RTCHit hit = implementation_->cast(origin, ray);
      if (hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
      const TriangleMesh& mesh = implementation_->mesh(hit.geomID);
      // Embree finds the triangle; the depth is computed here in double precision, as Embree's own
      // depends on the processor in its last bits.
      const auto [a, b, c] = implementation_->corners(hit.geomID, hit.primID);
      const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
      const double along = normal.dot(ray);
      if (along == 0.0) continue;
      const double cosine = std::abs(along) / ray.norm();
      const Eigen::Vector3d color = interpolated_color(mesh, hit) * (0.6 + 0.4 * cosine);
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
