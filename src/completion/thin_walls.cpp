#include "thin_walls.hpp"

#include "core/as_rows.hpp"
#include "core/median.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr Index most_probes = 2000;
constexpr double min_inner = 0.05;     // share of the points that look into the cavity
constexpr double min_walled = 0.05;    // share of these with a wall behind them
constexpr float facing_away = -0.5F;   // cosine between the normals of a wall's two faces
constexpr float wall_in_cells = 1.2F;  // least thickness, so that no path leads through a wall

/// The thickness of the wall behind a point, if there is one. [m]
std::optional<float> wall_behind(const SurfacePoints& points, std::size_t i, const CellList& cells,
                                 float max_thickness) {
  const Eigen::Vector3f& position = points.positions[i];
  const Eigen::Vector3f& normal = points.normals[i];
  std::optional<float> thickness;
  cells.for_each_within(position, max_thickness, [&](Index k, float) {
    const float depth = normal.dot(position - points.positions[k]);
    if (depth <= 0.0F || normal.dot(points.normals[k]) > facing_away) return;
    if (!thickness || depth < *thickness) thickness = depth;
  });
  return thickness;
}

/// Nodes of the cavity: from those before its points through the nodes that `is_open`.
template <class IsOpen>
std::vector<std::uint8_t> cavity_nodes(const NodeGrid& grid, std::vector<std::size_t> open,
                                       const IsOpen& is_open) {
  std::vector<std::uint8_t> reached(grid.nodes(), 0);
  for (const std::size_t seed : open) reached[seed] = 1;
  flood(grid, std::move(open), [&](std::size_t, std::size_t next) {
    if (reached[next] != 0 || !is_open(next)) return false;
    reached[next] = 1;
    return true;
  });
  return reached;
}

}  // namespace

std::optional<Vessel> find_vessel(const SurfacePoints& points, const ConvexBound& bound,
                                  const ThinWallBounds& bounds) {
  Vessel vessel;
  vessel.inner.assign(points.size(), 0);
  std::size_t inner = 0;
  std::vector<float> walls;
  const CellList cells(as_rows(points.positions), bounds.max_thickness);
  const PointIndices probes = evenly_spread(static_cast<Index>(points.size()), most_probes);
  for (const Index i : probes) {
    if (points.positions[i].z() < bounds.lowest) continue;
    if (bound.exit_distance(points.positions[i], points.normals[i]) < bounds.min_depth) continue;
    vessel.inner[i] = 1;
    ++inner;
    if (const auto wall = wall_behind(points, i, cells, bounds.max_thickness))
      walls.push_back(*wall);
  }
  const auto reaches = [](std::size_t part, std::size_t whole, double share) {
    return static_cast<double>(part) >= share * static_cast<double>(whole);
  };
  if (walls.empty() || !reaches(inner, probes.size(), min_inner) ||
      !reaches(walls.size(), inner, min_walled))
    return std::nullopt;
  vessel.thickness = *median(std::move(walls));
  return vessel;
}

void hollow_out(const NodeGrid& grid, const Vessel& vessel, const NearestPoints& nearest,
                const NodeDistances& distances, std::vector<float>& field) {
  const float thickness = std::max(vessel.thickness, wall_in_cells * grid.spacing);
  std::vector<std::size_t> before_inner;
  for (std::size_t node = 0; node < field.size(); ++node) {
    const Index point = nearest.point[node];
    if (point == NearestPoints::none || vessel.inner[point] == 0) continue;
    if (distances.surface[node] > 0.0F && distances.bound[node] < 0.0F)
      before_inner.push_back(node);
  }
  const std::vector<std::uint8_t> cavity = cavity_nodes(
      grid, std::move(before_inner),
      [&](std::size_t node) { return field[node] < 0.0F && distances.surface[node] < -thickness; });
  for (std::size_t node = 0; node < field.size(); ++node) {
    const float behind_wall = -distances.surface[node] - thickness;
    const float above_floor = -distances.bound[node] - thickness;
    const float hollow = cavity[node] != 0 ? std::min(behind_wall, above_floor) : behind_wall;
    field[node] = std::max(field[node], hollow);
  }
}

}  // namespace symscene
