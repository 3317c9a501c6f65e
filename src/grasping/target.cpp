#include "target.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "sorted_order.hpp"

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
  double longest_edge() const {
    return std::sqrt(
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  }
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

void add_to_corners(const TriangleMesh& mesh, Eigen::Index t, const Corners& corners, bool observed,
                    std::vector<Sample>& samples) {
  const Eigen::Vector3f third = corners.area_vector() / 3.0F;
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

/// The cube of a grid that holds a point.
Eigen::Array3i cube_of(const Eigen::Vector3f& position, float edge) {
  constexpr float half_range = 1 << 19;  // cubes on either side of the origin
  const Eigen::Array3f cube = position.array() / edge;
  return cube.floor().max(-half_range).min(half_range - 1.0F).cast<int>();
}

/// The cubes of samples as numbers that grow with x, then y, then z. They leave three bits free.
std::vector<std::uint64_t> numbered_cubes(const std::vector<Sample>& samples, float edge) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Eigen::Vector3f min = Eigen::Vector3f::Constant(infinity), max = -min;
  for (const Sample& sample : samples) {
    min = min.cwiseMin(sample.position);
    max = max.cwiseMax(sample.position);
  }
  const Eigen::Array3i low = cube_of(min, edge);
  using Numbers = Eigen::Array<std::uint64_t, 3, 1>;
  const Numbers size = (cube_of(max, edge) - low + 1).cast<std::uint64_t>();
  std::vector<std::uint64_t> numbers;
  numbers.reserve(samples.size());
  for (const Sample& sample : samples) {
    const Numbers at = (cube_of(sample.position, edge) - low).cast<std::uint64_t>();
    numbers.push_back((at.x() * size.y() + at.y()) * size.z() + at.z());
  }
  return numbers;
}

/// Which of ±x, ±y and ±z is nearest to a normal.
std::uint64_t side_of(const Eigen::Vector3f& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<std::uint64_t>(axis) + (normal[axis] < 0.0F ? 1 : 0);
}

/// One sample for those in a cube that face the same way, so that both sides of a wall remain.
std::vector<Sample> merged(const std::vector<Sample>& samples) {
  std::vector<std::uint64_t> parts = numbered_cubes(samples, merged_edge);
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i] = parts[i] << 3U | side_of(samples[i].area_vector);
  const std::vector<Index> order = sorted_order(parts);
  std::vector<Sample> means;
  means.reserve(samples.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    Sample sum;
    float weights = 0.0F;
    for (; end < order.size() && parts[order[end]] == parts[order[begin]]; ++end) {
      const Sample& sample = samples[order[end]];
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

/// The blocks of points that end at these rows, with their balls.
PointBlocks with_balls(const Points& positions, std::vector<Eigen::Index> ends) {
  PointBlocks blocks;
  blocks.ends = std::move(ends);
  const auto count = static_cast<Eigen::Index>(blocks.ends.size());
  blocks.centres.resize(count, 3);
  blocks.radii.resize(count);
  for (Eigen::Index b = 0; b < count; ++b) {
    const auto rows = positions.middleRows(blocks.begin(b), blocks.end(b) - blocks.begin(b));
    const Eigen::RowVector3f centre =
        0.5F * (rows.colwise().minCoeff() + rows.colwise().maxCoeff());
    blocks.centres.row(b) = centre;
    blocks.radii[b] = std::sqrt((rows.rowwise() - centre).rowwise().squaredNorm().maxCoeff());
  }
  return blocks;
}

SurfaceSamples as_samples(const std::vector<Sample>& list) {
  const std::vector<std::uint64_t> cubes = numbered_cubes(list, block_edge);
  const std::vector<Index> order = sorted_order(cubes);
  SurfaceSamples samples;
  const auto count = static_cast<Eigen::Index>(list.size());
  samples.positions.resize(count, 3);
  samples.normals.resize(count, 3);
  samples.areas.resize(count);
  samples.observed.resize(list.size());
  std::vector<Eigen::Index> ends;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Sample& sample = list[order[i]];
    const auto row = static_cast<Eigen::Index>(i);
    samples.positions.row(row) = sample.position.transpose();
    samples.areas[row] = sample.area_vector.norm();
    samples.normals.row(row) = sample.area_vector.normalized().transpose();
    samples.observed[i] = sample.observed;
    if (i + 1 == order.size() || cubes[order[i]] != cubes[order[i + 1]]) ends.push_back(row + 1);
  }
  samples.blocks = with_balls(samples.positions, std::move(ends));
  return samples;
}

/// Away from the table; without one the mean normal of what was seen, which points roughly to the
/// camera, as the frame of a single image says nothing about up.
Eigen::Vector3d up_direction(const GraspScene& scene, const Eigen::Vector3d& seen_from) {
  if (scene.table) return scene.table->normal;
  return seen_from.isZero() ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : seen_from;
}

}  // namespace

SurfaceSamples surface_samples(const ObjectSurface& surface) {
  const TriangleMesh& mesh = surface.mesh;
  std::vector<Sample> samples = vertices(mesh);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const bool observed = surface.observed[static_cast<std::size_t>(t)] != 0;
    const Corners corners(mesh, t);
    if (corners.longest_edge() <= longest_small_edge)
      add_to_corners(mesh, t, corners, observed, samples);
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
  return as_samples(samples);
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

GraspTarget grasp_target(const GraspScene& scene, std::size_t id, const SurfaceSamples& samples,
                         const Eigen::Vector3d& seen_from) {
  const GraspObject& object = scene.objects[id];
  return {static_cast<int>(id),
          object,
          samples,
          object.solid ? *object.solid : solid_properties(object.surface.mesh),
          up_direction(scene, seen_from),
          seen_from};
}

}  // namespace symscene
