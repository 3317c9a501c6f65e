#pragma once

#include <optional>
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

/// The view to take next.
struct ViewChoice {
  std::optional<std::size_t> candidate;  ///< none if all were visited
  NextViews views = {};  ///< that it was chosen from; empty if the policy ranks none
};

/// Chooses one view after the other, none twice.
class ViewChooser {
 public:
  /// The candidates must outlive it. The fixed arc starts at `first` and goes on in the order of
  /// the candidates.
  ViewChooser(ExplorationPolicy policy, std::span<const Eigen::Isometry3d> candidates,
              std::size_t first, const NextViewOptions& options, Random random);

  /// Must be called with every view that is taken.
  void visit(std::size_t candidate) { visited_[candidate] = 1; }
  ViewChoice next(const ExploredScene& known);
  ExplorationPolicy policy() const { return policy_; }

  /// The candidates that were not visited, ranked. Empty, and not enough, where nothing is known.
  NextViews ranked(const ExploredScene& known, ViewPolicy policy) const;

 private:
  std::size_t chosen(const ExploredScene& known, const NextViews& views);
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
