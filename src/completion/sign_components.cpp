#include "sign_components.hpp"

#include <algorithm>
#include <cstdint>

#include "symscene/core/types.hpp"

namespace symscene {
namespace {

constexpr Index unlabelled = ~Index{0};

/// Labels of the nodes, by components of equal sign that share edges of the lattice, and their
/// sizes in the order of their first nodes.
class SignComponents {
 public:
  SignComponents(const NodeGrid& grid, const std::vector<float>& field)
      : grid_(grid), field_(field), labels_(grid.nodes(), unlabelled) {
    for (std::size_t node = 0; node < labels_.size(); ++node) {
      if (labels_[node] == unlabelled) fill_from(node);
    }
  }

  Index label(std::size_t node) const { return labels_[node]; }
  bool is_inside(Index label) const { return field_[firsts_[label]] < 0.0F; }
  std::size_t size(Index label) const { return sizes_[label]; }
  std::size_t count() const { return sizes_.size(); }

 private:
  void fill_from(std::size_t first) {
    const auto label = static_cast<Index>(sizes_.size());
    firsts_.push_back(first);
    labels_[first] = label;
    std::size_t size = 1;
    flood(grid_, {first}, [&](std::size_t node, std::size_t next) {
      if (labels_[next] != unlabelled || (field_[next] < 0.0F) != (field_[node] < 0.0F))
        return false;
      labels_[next] = label;
      ++size;
      return true;
    });
    sizes_.push_back(size);
  }

  const NodeGrid& grid_;
  const std::vector<float>& field_;
  std::vector<Index> labels_;
  std::vector<std::size_t> firsts_, sizes_;
};

/// Reverses the sign at the nodes of the components that are to flip.
template <class IsToFlip>
void flip(const NodeGrid& grid, const SignComponents& components, const IsToFlip& is_to_flip,
          std::vector<float>& field) {
  const float least = 1e-4F * grid.spacing;  // a distance of zero has a side too
  std::vector<std::uint8_t> flips(components.count(), 0);
  for (Index label = 0; label < components.count(); ++label)
    flips[label] = is_to_flip(label) ? 1 : 0;
  for (std::size_t node = 0; node < field.size(); ++node) {
    if (flips[components.label(node)] == 0) continue;
    const float distance = std::max(std::abs(field[node]), least);
    field[node] = field[node] < 0.0F ? distance : -distance;
  }
}

}  // namespace

void remove_small_pieces(const NodeGrid& grid, double min_share, std::vector<float>& field) {
  const SignComponents components(grid, field);
  std::size_t largest = 0;
  for (Index label = 0; label < components.count(); ++label) {
    if (components.is_inside(label)) largest = std::max(largest, components.size(label));
  }
  const double fewest = min_share * static_cast<double>(largest);
  const auto is_small_piece = [&](Index label) {
    return components.is_inside(label) && static_cast<double>(components.size(label)) < fewest;
  };
  flip(grid, components, is_small_piece, field);
}

void fill_pockets(const NodeGrid& grid, std::vector<float>& field) {
  const SignComponents components(grid, field);
  const Index outside = components.label(0);
  const auto is_pocket = [&](Index label) {
    return !components.is_inside(label) && label != outside;
  };
  flip(grid, components, is_pocket, field);
}

}  // namespace symscene
