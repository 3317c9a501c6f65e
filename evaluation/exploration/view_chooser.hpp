#pragma once

#include <span>
#include <vector>

#include "core/random.hpp"
#include "symscene/exploration/exploration.hpp"
#include "true_coverage.hpp"

namespace symscene {

/// What a choice is made from.
struct ExploredScene {
  const Scene& scene;
  const SegmentationResult& result;
  const TrueCoverage& truth;  ///< for the oracle only
};

/// Chooses one view after the other, none twice.
class ViewChooser {
 public:
  /// The candidates must outlive it. `first` was looked from; the fixed arc goes on from there in
  /// the order of the candidates.
  ViewChooser(ExplorationPolicy policy, std::span<const Eigen::Isometry3d> candidates,
              std::size_t first, const NextViewOptions& options, Random random);

  /// The next candidate, or none if all were chosen.
  std::optional<std::size_t> next(const ExploredScene& known);

 private:
  std::size_t chosen(const ExploredScene& known);
  std::size_t ranked(const ExploredScene& known, ViewPolicy policy) const;
  std::size_t along_arc() const;
  std::size_t drawn();
  std::size_t most_unseen(const ExploredScene& known) const;

  ExplorationPolicy policy_;
  std::span<const Eigen::Isometry3d> candidates_;
  std::size_t first_;
  NextViewOptions options_;
  Random random_;
  std::vector<std::uint8_t> visited_;
};

}  // namespace symscene
