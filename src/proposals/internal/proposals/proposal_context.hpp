#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// What the other proposals of a scene say of one: a part is known by the whole that it lies in,
/// and two objects in one by how well each of them does. An estimate is estimated_probability().
struct ProposalContext {
  double estimate = 0.0;       ///< of itself, by its own measures
  double whole = 0.0;          ///< greatest estimate of a set that holds it
  double whole_share = 0.0;    ///< its size by that set's
  double part = 0.0;           ///< greatest estimate of a set that it holds
  double rival = 0.0;          ///< greatest estimate of a set that crosses it
  double rest = 0.0;           ///< greatest estimate of a set that is the rest of that whole
  double split = 0.0;          ///< greatest lesser estimate of two sets that make it up
  double covered = 0.0;        ///< share that good sets in it cover, best first, none over another
  double covered_score = 0.0;  ///< the same, each by its estimate
  double pieces = 0.0;         ///< how many these are
  double wholes = 0.0;         ///< ln(1 + the number of sets that hold it)
  double parts = 0.0;          ///< ln(1 + the number of sets that it holds)

  /// Calls visit(name, value) for every field, in this order.
  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("estimate", self.estimate);
    visit("whole", self.whole);
    visit("whole_share", self.whole_share);
    visit("part", self.part);
    visit("rival", self.rival);
    visit("rest", self.rest);
    visit("split", self.split);
    visit("covered", self.covered);
    visit("covered_score", self.covered_score);
    visit("pieces", self.pieces);
    visit("wholes", self.wholes);
    visit("parts", self.parts);
  }
  static constexpr std::size_t count = 12;
};

/// How many points every two of some sets share.
class SharedCounts {
 public:
  /// The sets are ascending.
  explicit SharedCounts(std::span<const PointIndices* const> sets);

  std::size_t sets() const { return sizes_.size(); }
  double size(std::size_t a) const { return sizes_[a]; }
  double shared(std::size_t a, std::size_t b) const { return counts_[(a * sizes_.size()) + b]; }
  bool holds(std::size_t whole, std::size_t part) const;  ///< nearly, and is greater
  bool are_apart(std::size_t a, std::size_t b) const;     ///< nearly

 private:
  std::vector<std::uint32_t> sizes_;
  std::vector<std::uint32_t> counts_;  ///< N×N
};

/// One a set; `estimates` are the sets'.
std::vector<ProposalContext> proposal_contexts(const SharedCounts& sets,
                                               std::span<const double> estimates);

}  // namespace symscene
