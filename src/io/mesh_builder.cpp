#include "mesh_builder.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "color.hpp"
#include "symscene/core/error.hpp"
#include "weld.hpp"

namespace symscene {
namespace {

/// Bounds the memory that a small file takes by using the same data many times.
constexpr std::size_t most_values = 150'000'000;
constexpr std::uint8_t white = 255;

template <class Value>
Eigen::Index rows(const std::vector<Value>& values) {
  return static_cast<Eigen::Index>(values.size() / 3);
}

}  // namespace

void ModelBuilder::require_room(std::size_t count) const {
  if (count <= most_values) return;
  throw InputError(name_, "a mesh of at most 50 million vertices and triangles", "more");
}

void ModelBuilder::add_vertex(const Eigen::Vector3f& position) {
  require_room(positions_.size());
  positions_.insert(positions_.end(), position.data(), position.data() + 3);
}

void ModelBuilder::color_vertex(const Eigen::Vector3f& zero_to_one) {
  colors_.resize(positions_.size() - 3, white);
  for (const float channel : zero_to_one) colors_.push_back(to_color(channel * 255.0F));
}

void ModelBuilder::add_polygon(std::span<const Index> corners) {
  require_room(corners_.size() + 3 * corners.size());
  for (std::size_t k = 2; k < corners.size(); ++k) {
    corners_.insert(corners_.end(), {corners[0], corners[k - 1], corners[k]});
  }
}

TriangleMesh ModelBuilder::build() const {
  const auto largest = std::max_element(corners_.begin(), corners_.end());
  if (largest == corners_.end()) throw InputError(name_, "a mesh", "no triangle");
  if (*largest >= vertices()) {
    throw InputError(name_, fmt::format("faces of {} vertices", vertices()),
                     fmt::format("vertex {}", *largest));
  }
  TriangleMesh mesh;
  using RowPoints = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
  mesh.vertices = Eigen::Map<const RowPoints>(positions_.data(), rows(positions_), 3);
  mesh.triangles = Eigen::Map<const decltype(mesh.triangles)>(corners_.data(), rows(corners_), 3);
  if (!colors_.empty()) {
    mesh.colors = Colors::Constant(mesh.vertices.rows(), 3, white);
    mesh.colors.topRows(rows(colors_)) = Eigen::Map<const Colors>(colors_.data(), rows(colors_), 3);
  }
  TriangleMesh welded = weld_vertices(mesh);
  if (welded.triangles.rows() == 0) throw InputError(name_, "a mesh", "no triangle with an area");
  return welded;
}

}  // namespace symscene
