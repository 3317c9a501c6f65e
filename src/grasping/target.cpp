#include "target.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace symscene {
namespace {

constexpr double spacing = 0.003;             // of samples within large triangles [m]
constexpr double longest_small_edge = 0.007;  // of triangles that their corners stand for [m]
constexpr float block_edge = 0.03F;           // [m]
constexpr float merged_edge = 0.004F;         // of cubes whose samples of like normals merge [m]

struct Corners {
  Eigen::Vector3f a, b, c;

  Corners(const TriangleMesh& mesh, Eigen::Index t)
      : a(mesh.vertices.row(mesh.triangles(t, 0)).transpose()),
        b(mesh.vertices.row(mesh.triangles(t, 1)).transpose()),
        c(mesh.vertices.row(mesh.triangles(t, 2)).transpose()) {}

  Eigen::Vector3f area_vector() const { return 0.5F * (b - a).cross(c - a); }
  double longest_edge() const { return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}); }
};

struct Sample {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f area_vector = Eigen::Vector3f::Zero();
  bool observed = false;
};

/// Centroids of the n² equal parts of a triangle.
void append_parts(const Corners& corners, bool observed, std::vector<Sample>& samples) {
  const int n = static_cast<int>(std::ceil(corners.longest_edge() / spacing));
  const Eigen::Vector3f u = (corners.b - corners.a) / static_cast<float>(n);
  const Eigen::Vector3f v = (corners.c - corners.a) / static_cast<float>(n);
  const Eigen::Vector3f part = corners.area_vector() / static_cast<float>(n * n);
  const auto append = [&](int i, int j, float offset) {
    samples.push_back(
        {corners.a + (static_cast<float>(i) + offset) * u + (static_cast<float>(j) + offset) * v,
         part, observed});
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      append(i, j, 1.0F / 3.0F);
      if (i + j + 1 < n) append(i, j, 2.0F / 3.0F);
    }
  }
}

void add_to_corners(const TriangleMesh& mesh, Eigen::Index t, bool observed,
                    std::vector<Sample>& samples) {
  const Eigen::Vector3f third = Corners(mesh, t).area_vector() / 3.0F;
  for (Eigen::Index k = 0; k < 3; ++k) {
    Sample& corner = samples[mesh.triangles(t, k)];
    corner.area_vector += third;
    corner.observed = corner.observed || observed;
  }
}

std::vector<Sample> vertices(const TriangleMesh& mesh) {
  std::vector<Sample> samples(static_cast<std::size_t>(mesh.vertices.rows()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].position = mesh.vertices.row(static_cast<Eigen::Index>(i)).transpose();
  return samples;
}

/// The cube of a grid, with further bits below its coordinates, as one number to sort by.
std::uint64_t cube_key(const Eigen::Vector3f& position, float edge, std::uint64_t below = 0) {
  constexpr int half_range = 1 << 19;  // cubes on either side of the origin
  const Eigen::Array3i cube = (position / edge).array().floor().cast<int>();
  const auto bits = [](int coordinate) {
    return static_cast<std::uint64_t>(std::clamp(coordinate + half_range, 0, 2 * half_range - 1));
  };
  return ((((bits(cube.x()) << 20U) | bits(cube.y())) << 20U | bits(cube.z())) << 3U) | below;
}

using KeyedSample = std::pair<std::uint64_t, std::size_t>;

void sort_by_block(std::vector<Sample>& samples) {
  std::vector<KeyedSample> order(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    order[i] = {cube_key(samples[i].position, block_edge), i};
  std::sort(order.begin(), order.end());
  std::vector<Sample> sorted;
  sorted.reserve(samples.size());
  for (const auto& [key, i] : order) sorted.push_back(samples[i]);
  samples = std::move(sorted);
}

/// Which of ±x, ±y and ±z is nearest to a normal.
std::uint64_t side_of(const Eigen::Vector3f& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<std::uint64_t>(axis) + (normal[axis] < 0.0F ? 1 : 0);
}

/// One sample for those in a cube that face the same way, so that both sides of a wall remain.
std::vector<Sample> merged(const std::vector<Sample>& samples) {
  std::vector<KeyedSample> parts(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    parts[i] = {cube_key(samples[i].position, merged_edge, side_of(samples[i].area_vector)), i};
  std::sort(parts.begin(), parts.end());
  std::vector<Sample> means;
  for (std::size_t begin = 0, end = 0; begin < parts.size(); begin = end) {
    Sample sum;
    float weights = 0.0F;
    for (; end < parts.size() && parts[end].first == parts[begin].first; ++end) {
      const Sample& sample = samples[parts[end].second];
      const float weight = sample.area_vector.norm();
      sum.position += weight * sample.position;
      sum.area_vector += sample.area_vector;
      sum.observed = sum.observed || sample.observed;
      weights += weight;
    }
    sum.position /= weights;
    means.push_back(sum);
  }
  return means;
}

PointBlock block_of(const Points& positions, Eigen::Index begin, Eigen::Index end) {
  const auto rows = positions.middleRows(begin, end - begin);
  const Eigen::RowVector3f low = rows.colwise().minCoeff();
  const Eigen::RowVector3f high = rows.colwise().maxCoeff();
  const Eigen::RowVector3f centre = 0.5F * (low + high);
  return {centre.transpose(),
          std::sqrt((rows.rowwise() - centre).rowwise().squaredNorm().maxCoeff()), begin, end};
}

std::vector<PointBlock> blocks_of(const Points& positions) {
  std::vector<PointBlock> blocks;
  const auto key_of = [&](Eigen::Index i) { return cube_key(positions.row(i), block_edge); };
  Eigen::Index begin = 0;
  for (Eigen::Index i = 1; i <= positions.rows(); ++i) {
    if (i < positions.rows() && key_of(i) == key_of(begin)) continue;
    blocks.push_back(block_of(positions, begin, i));
    begin = i;
  }
  return blocks;
}

SurfaceSamples as_samples(std::vector<Sample> list) {
  sort_by_block(list);
  SurfaceSamples samples;
  const auto count = static_cast<Eigen::Index>(list.size());
  samples.positions.resize(count, 3);
  samples.normals.resize(count, 3);
  samples.areas.resize(count);
  samples.observed.resize(list.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const Sample& sample = list[static_cast<std::size_t>(i)];
    samples.positions.row(i) = sample.position.transpose();
    samples.areas[i] = sample.area_vector.norm();
    samples.normals.row(i) = sample.area_vector.normalized().transpose();
    samples.observed[static_cast<std::size_t>(i)] = sample.observed;
  }
  if (count > 0) samples.blocks = blocks_of(samples.positions);
  return samples;
}

}  // namespace

SurfaceSamples surface_samples(const ObjectSurface& surface) {
  const TriangleMesh& mesh = surface.mesh;
  std::vector<Sample> samples = vertices(mesh);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const bool observed = surface.observed[static_cast<std::size_t>(t)] != 0;
    const Corners corners(mesh, t);
    if (corners.longest_edge() <= longest_small_edge)
      add_to_corners(mesh, t, observed, samples);
    else
      append_parts(corners, observed, samples);
  }
  std::erase_if(samples, [](const Sample& sample) { return !(sample.area_vector.norm() > 0.0F); });
  return as_samples(merged(samples));
}

SurfaceSamples surface_samples(const Points& points) {
  std::vector<Sample> samples(static_cast<std::size_t>(points.rows()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = {points.row(static_cast<Eigen::Index>(i)).transpose(), Eigen::Vector3f::Zero(),
                  true};
  return as_samples(std::move(samples));
}

Eigen::Vector3d mean_seen_normal(std::span<const SurfaceSamples> surfaces) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0.0;
  for (const SurfaceSamples& samples : surfaces) {
    for (Eigen::Index i = 0; i < samples.size(); ++i) {
      if (samples.observed[static_cast<std::size_t>(i)] == 0) continue;
      sum += samples.areas[i] * samples.normals.row(i).transpose().cast<double>();
      area += samples.areas[i];
    }
  }
  // That of a sphere from one side is 1/2.
  constexpr double least_mean = 0.25;
  return sum.norm() > least_mean * area ? sum.normalized() : Eigen::Vector3d::Zero();
}

GraspTarget grasp_target(const GraspScene& scene, std::size_t id,
                         const std::vector<SurfaceSamples>& samples) {
  const GraspObject& object = scene.objects[id];
  return {static_cast<int>(id),
          object,
          samples[id],
          object.solid ? *object.solid : solid_properties(object.surface.mesh),
          scene.table ? scene.table->normal : Eigen::Vector3d::UnitZ(),
          mean_seen_normal(samples)};
}

}  // namespace symscene
