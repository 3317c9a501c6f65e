#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"

namespace symscene {

/// When objects of successive results are the same one. Objects are compared in the cells of a
/// grid that their points occupy.
struct ObjectIdentityOptions {
  double cell_spacings = 3.0;
  double min_overlap = 0.2;
  double min_left = 0.3;
  int max_absence = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("cell_spacings", self.cell_spacings, "", between(1.0, 100.0),
          "edge of a cell, in median distances between neighbouring points of the first cloud");
    visit("min_overlap", self.min_overlap, "", between(0.0, 1.0),
          "intersection over union of the cells from which an object is the one of an earlier "
          "result");
    visit("min_left", self.min_left, "", between(0.0, 1.0),
          "share of an object's cells that still hold points, below which the object is gone");
    visit("max_absence", self.max_absence, "results", at_least(1.0),
          "results in a row without an object, after which it is not recognised any more");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// What changed of an object since the result before.
enum class ObjectChangeKind {
  appeared,  ///< no earlier object was there
  returned,  ///< an object that was unclear or gone is found where it was
  unclear,   ///< its points are there, but no object of the result matches it
  gone       ///< its points are not there any more
};

std::string to_string(ObjectChangeKind kind);

/// Numbers of objects start at 1 and are never used again for another object.
using ObjectNumber = std::uint32_t;

struct ObjectChange {
  ObjectNumber number = 0;
  ObjectChangeKind kind = ObjectChangeKind::appeared;
};

/// The objects of a result as those of the results before.
struct IdentifiedObjects {
  std::vector<ObjectNumber> numbers;  ///< of the result's objects, in their order
  std::vector<ObjectChange> changes;  ///< in the order of the numbers
};

/// Recognises objects from result to result of one scene, by the space that they occupy.
class ObjectIdentities {
 public:
  /// Throws InputError if an option is out of its range.
  explicit ObjectIdentities(const ObjectIdentityOptions& options = {});

  /// Numbers the objects of a result. All results must be in the same world frame.
  IdentifiedObjects identify(const SegmentationResult& result);

 private:
  using Cell = std::uint64_t;

  struct Known {
    std::vector<Cell> cells;  ///< ascending, when it was last found
    std::optional<ObjectChangeKind> absent =
        {};           ///< unclear or gone; none if the last result has it
    int absence = 0;  ///< results in a row without it
  };

  std::vector<Cell> cells_of(const PointCloud& cloud, std::span<const Index> points) const;
  std::vector<ObjectNumber> matched(const std::vector<std::vector<Cell>>& objects) const;
  void find(ObjectNumber number, std::vector<Cell> cells, IdentifiedObjects& identified);
  void miss(ObjectNumber number, std::span<const Cell> all, IdentifiedObjects& identified);

  ObjectIdentityOptions options_;
  double cell_ = 0.0;  ///< 0 before the first cloud [m]
  ObjectNumber last_ = 0;
  std::map<ObjectNumber, Known> known_;
};

}  // namespace symscene
