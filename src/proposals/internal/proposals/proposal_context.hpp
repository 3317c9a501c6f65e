#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symscene/core/types.hpp"
#include "symscene/proposals/proposal_options.hpp"

namespace symscene {

/// Features of a proposal's relations to the others of its scene: those that contain it (wholes),
/// that it contains (parts), and that cross it (conflicts). An estimate is the
/// estimated_probability() of a proposal from its own features. The thresholds are
/// ProposalContextOptions.
struct ProposalContext {
  double estimate = 0.0;     ///< its own estimate
  double whole = 0.0;        ///< greatest estimate of a whole
  double whole_share = 0.0;  ///< its size divided by that of this whole
  double part = 0.0;         ///< greatest estimate of a part
  double rival = 0.0;        ///< greatest estimate of a conflicting proposal
  double rest = 0.0;         ///< greatest estimate of a part that splits that whole with it
  double split = 0.0;        ///< greatest, over pairs of parts that split it, of the lower estimate
  double covered = 0.0;      ///< share of its points in pieces: likely, disjoint parts, best first
  double covered_score = 0.0;  ///< the same, each piece weighted by its estimate
  double pieces = 0.0;         ///< number of pieces
  double wholes = 0.0;         ///< ln(1 + number of wholes)
  double parts = 0.0;          ///< ln(1 + number of parts)

  /// Calls visit(name, value) for every feature, in this order, which is that of the models.
  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, Visit&& visit) {
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
};

/// The number of points that every two proposals share.
class SharedCounts {
 public:
  /// `proposals` are ascending indices.
  explicit SharedCounts(std::span<const PointIndices* const> proposals,
                        const ProposalContextOptions& options = {});
  /// From the numbers of points of N proposals, and N×N numbers of shared points.
  SharedCounts(std::vector<std::uint32_t> sizes, std::vector<std::uint32_t> shared,
               const ProposalContextOptions& options = {});

  std::size_t count() const { return sizes_.size(); }
  const ProposalContextOptions& options() const { return options_; }
  double size(std::size_t a) const { return sizes_[a]; }
  double shared(std::size_t a, std::size_t b) const { return counts_[(a * sizes_.size()) + b]; }
  /// Whether `part` lies in `whole`, but for a small share, and is clearly smaller.
  bool contains(std::size_t whole, std::size_t part) const;
  bool are_disjoint(std::size_t a, std::size_t b) const;
  /// Whether two proposals overlap, neither contains the other and they are not nearly the same.
  bool conflict(std::size_t a, std::size_t b) const;

 private:
  ProposalContextOptions options_;
  std::vector<std::uint32_t> sizes_;
  std::vector<std::uint32_t> counts_;  ///< N×N
};

/// One context per proposal, from the estimates of all.
std::vector<ProposalContext> proposal_contexts(const SharedCounts& proposals,
                                               std::span<const double> estimates);

}  // namespace symscene
