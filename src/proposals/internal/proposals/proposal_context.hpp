#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "symscene/core/types.hpp"
#include "symscene/proposals/object_features.hpp"
#include "symscene/proposals/proposal_options.hpp"

namespace symscene {

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
