#include "proposals/proposal_context.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.hpp"

namespace symscene {
namespace {

/// The parts of a proposal by falling estimate, and the features that they give it.
class Parts {
 public:
  Parts(const SharedCounts& proposals, std::span<const double> estimates, std::size_t whole)
      : proposals_(proposals), estimates_(estimates), whole_(whole) {
    for (std::size_t b = 0; b < proposals.count(); ++b) {
      if (b != whole && proposals.contains(whole, b)) parts_.push_back(b);
    }
    std::stable_sort(parts_.begin(), parts_.end(),
                     [&](std::size_t a, std::size_t b) { return estimates_[a] > estimates_[b]; });
  }

  std::size_t count() const { return parts_.size(); }
  double best() const { return parts_.empty() ? 0.0 : estimates_[parts_.front()]; }

  /// The greatest estimate of a part that splits the whole with `other`.
  double best_rest(std::size_t other) const {
    const double min_size = proposals_.options().min_split_share * proposals_.size(whole_);
    for (const std::size_t part : parts_) {
      if (proposals_.are_disjoint(part, other) &&
          proposals_.size(part) + proposals_.size(other) > min_size)
        return estimates_[part];
    }
    return 0.0;
  }

  double best_split() const {
    double best = 0.0;
    for (const std::size_t part : parts_) {
      if (estimates_[part] <= best) break;
      best = std::max(best, std::min(estimates_[part], best_rest(part)));
    }
    return best;
  }

  struct Cover {
    double share = 0.0;
    double score = 0.0;
    double pieces = 0.0;
  };
  Cover cover() const {
    const ProposalContextOptions& options = proposals_.options();
    Cover cover;
    std::vector<std::size_t> pieces;
    for (const std::size_t part : parts_) {
      if (estimates_[part] < options.min_piece_estimate ||
          pieces.size() == static_cast<std::size_t>(options.max_pieces))
        break;
      const bool is_free = std::all_of(pieces.begin(), pieces.end(), [&](std::size_t piece) {
        return proposals_.shared(part, piece) <= options.max_piece_overlap * proposals_.size(part);
      });
      if (!is_free) continue;
      pieces.push_back(part);
      const double share = proposals_.size(part) / proposals_.size(whole_);
      cover.share += share;
      cover.score += estimates_[part] * share;
    }
    cover.pieces = static_cast<double>(pieces.size());
    return cover;
  }

 private:
  const SharedCounts& proposals_;
  std::span<const double> estimates_;
  std::size_t whole_;
  std::vector<std::size_t> parts_;
};

/// The wholes of a proposal and its conflicts.
struct Others {
  std::optional<std::size_t> best_whole;  ///< its index
  double whole = 0.0;                     ///< its estimate
  double wholes = 0.0;                    ///< their number
  double rival = 0.0;                     ///< greatest estimate of a conflicting proposal
};

Others compare_with_others(const SharedCounts& proposals, std::span<const double> estimates,
                           std::size_t a) {
  Others others;
  for (std::size_t b = 0; b < proposals.count(); ++b) {
    if (a == b || proposals.are_disjoint(a, b)) continue;
    if (proposals.contains(b, a)) {
      others.wholes += 1.0;
      if (estimates[b] > others.whole) {
        others.whole = estimates[b];
        others.best_whole = b;
      }
    } else if (proposals.conflict(a, b)) {
      others.rival = std::max(others.rival, estimates[b]);
    }
  }
  return others;
}

}  // namespace

SharedCounts::SharedCounts(std::span<const PointIndices* const> proposals,
                           const ProposalContextOptions& options)
    : options_(options), counts_(proposals.size() * proposals.size()) {
  Index end = 0;
  for (const PointIndices* points : proposals) {
    sizes_.push_back(static_cast<std::uint32_t>(points->size()));
    if (!points->empty()) end = std::max(end, points->back() + 1);
  }
  std::vector<std::vector<std::uint32_t>> proposals_of(end);  // by point, ascending
  for (std::size_t a = 0; a < proposals.size(); ++a) {
    for (const Index i : *proposals[a]) proposals_of[i].push_back(static_cast<std::uint32_t>(a));
  }
  for (const std::vector<std::uint32_t>& own : proposals_of) {
    for (const std::uint32_t a : own) {
      for (const std::uint32_t b : own) {
        if (b > a) break;
        ++counts_[(a * proposals.size()) + b];
      }
    }
  }
  for (std::size_t a = 0; a < proposals.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b)
      counts_[(b * proposals.size()) + a] = counts_[(a * proposals.size()) + b];
  }
}

SharedCounts::SharedCounts(std::vector<std::uint32_t> sizes, std::vector<std::uint32_t> shared,
                           const ProposalContextOptions& options)
    : options_(options), sizes_(std::move(sizes)), counts_(std::move(shared)) {}

bool SharedCounts::contains(std::size_t whole, std::size_t part) const {
  return size(part) < options_.max_part_share * size(whole) &&
         shared(whole, part) > options_.contained_share * size(part);
}

bool SharedCounts::are_disjoint(std::size_t a, std::size_t b) const {
  return shared(a, b) <= options_.disjoint_share * std::min(size(a), size(b));
}

bool SharedCounts::conflict(std::size_t a, std::size_t b) const {
  return !are_disjoint(a, b) && !contains(a, b) && !contains(b, a) &&
         shared(a, b) < options_.max_part_share * std::max(size(a), size(b));
}

std::vector<ProposalContext> proposal_contexts(const SharedCounts& proposals,
                                               std::span<const double> estimates) {
  std::vector<std::optional<Parts>> parts(proposals.count());
  parallel_for_each(parts.size(),
                    [&](std::size_t a) { parts[a].emplace(proposals, estimates, a); });
  std::vector<ProposalContext> contexts(proposals.count());
  parallel_for_each(contexts.size(), [&](std::size_t a) {
    const Others others = compare_with_others(proposals, estimates, a);
    const Parts::Cover cover = parts[a]->cover();
    const auto& whole = others.best_whole;
    contexts[a] = {.estimate = estimates[a],
                   .whole = others.whole,
                   .whole_share = whole ? proposals.size(a) / proposals.size(*whole) : 0.0,
                   .part = parts[a]->best(),
                   .rival = others.rival,
                   .rest = whole ? parts[*whole]->best_rest(a) : 0.0,
                   .split = parts[a]->best_split(),
                   .covered = cover.share,
                   .covered_score = cover.score,
                   .pieces = cover.pieces,
                   .wholes = std::log1p(others.wholes),
                   .parts = std::log1p(static_cast<double>(parts[a]->count()))};
  });
  return contexts;
}

}  // namespace symscene
