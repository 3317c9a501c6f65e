#include "symscene/workflow/object_identities.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/spacing.hpp"

namespace symscene {
namespace {

constexpr double fallback_spacing = 0.005;  // of a cloud of a single point [m]

/// Three coordinates of 21 bits each.
std::uint64_t key_of(const Eigen::Vector3f& position, double cell) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = static_cast<std::int64_t>(
        std::clamp(std::floor(static_cast<double>(position[axis]) / cell), -1e6, 1e6));
    key = key << 21 | static_cast<std::uint64_t>(place + (1 << 20));
  }
  return key;
}

std::size_t shared_cells(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) {
  std::size_t shared = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    shared += a[i] == b[j] ? 1 : 0;
    const bool advance_a = a[i] <= b[j], advance_b = b[j] <= a[i];
    i += advance_a ? 1 : 0;
    j += advance_b ? 1 : 0;
  }
  return shared;
}

double overlap(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) {
  const auto shared = static_cast<double>(shared_cells(a, b));
  const double united = static_cast<double>(a.size() + b.size()) - shared;
  return united > 0.0 ? shared / united : 0.0;
}

}  // namespace

std::string to_string(ObjectChangeKind kind) {
  switch (kind) {
    case ObjectChangeKind::appeared:
      return "appeared";
    case ObjectChangeKind::returned:
      return "returned";
    case ObjectChangeKind::unclear:
      return "unclear";
    case ObjectChangeKind::gone:
      return "gone";
  }
  return "unknown";
}

ObjectIdentities::ObjectIdentities(const ObjectIdentityOptions& options) : options_(options) {
  options_.validate();
}

std::vector<ObjectIdentities::Cell> ObjectIdentities::cells_of(
    const PointCloud& cloud, std::span<const Index> points) const {
  std::vector<Cell> cells;
  cells.reserve(points.size());
  for (const Index i : points) cells.push_back(key_of(cloud.position(i), cell_));
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// The number of the known object that each object is, 0 for none: pairs by falling overlap.
std::vector<ObjectNumber> ObjectIdentities::matched(
    const std::vector<std::vector<Cell>>& objects) const {
  std::vector<std::tuple<double, ObjectNumber, std::size_t>> pairs;
  for (const auto& [number, known] : known_) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const double share = overlap(known.cells, objects[i]);
      if (share > 0.0 && share >= options_.min_overlap) pairs.emplace_back(-share, number, i);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<ObjectNumber> numbers(objects.size(), 0);
  for (const auto& [share, number, i] : pairs) {
    const bool is_taken = std::find(numbers.begin(), numbers.end(), number) != numbers.end();
    if (numbers[i] == 0 && !is_taken) numbers[i] = number;
  }
  return numbers;
}

void ObjectIdentities::find(ObjectNumber number, std::vector<Cell> cells,
                            IdentifiedObjects& identified) {
  const auto [place, is_new] = known_.try_emplace(number);
  Known& known = place->second;
  if (is_new || known.absent)
    identified.changes.push_back(
        {number, is_new ? ObjectChangeKind::appeared : ObjectChangeKind::returned});
  known = {std::move(cells), {}};
}

void ObjectIdentities::miss(ObjectNumber number, std::span<const Cell> all,
                            IdentifiedObjects& identified) {
  Known& known = known_.at(number);
  const auto left = static_cast<double>(shared_cells(known.cells, all));
  const ObjectChangeKind kind = left < options_.min_left * static_cast<double>(known.cells.size())
                                    ? ObjectChangeKind::gone
                                    : ObjectChangeKind::unclear;
  if (known.absent != kind) identified.changes.push_back({number, kind});
  known.absent = kind;
  ++known.absence;
}

IdentifiedObjects ObjectIdentities::identify(const SegmentationResult& result) {
  if (cell_ == 0.0 && !result.cloud.empty()) {
    const std::optional<float> spacing = median_spacing(result.cloud.positions);
    cell_ = options_.cell_spacings *
            (spacing && *spacing > 0.0F ? static_cast<double>(*spacing) : fallback_spacing);
  }
  std::vector<std::vector<Cell>> objects;
  for (const SceneObject& object : result.objects)
    objects.push_back(cells_of(result.cloud, object.points));
  PointIndices everything(static_cast<std::size_t>(result.cloud.size()));
  std::iota(everything.begin(), everything.end(), Index{0});
  const std::vector<Cell> all = cells_of(result.cloud, everything);

  IdentifiedObjects identified{matched(objects), {}};
  for (std::size_t i = 0; i < objects.size(); ++i) {
    ObjectNumber& number = identified.numbers[i];
    if (number == 0) number = ++last_;
    find(number, std::move(objects[i]), identified);
  }
  for (const auto& [number, known] : known_) {
    if (std::find(identified.numbers.begin(), identified.numbers.end(), number) ==
        identified.numbers.end())
      miss(number, all, identified);
  }
  std::erase_if(known_,
                [&](const auto& known) { return known.second.absence >= options_.max_absence; });
  std::sort(identified.changes.begin(), identified.changes.end(),
            [](const ObjectChange& a, const ObjectChange& b) { return a.number < b.number; });
  return identified;
}

}  // namespace symscene
