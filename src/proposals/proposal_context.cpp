#include "proposals/proposal_context.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.hpp"

namespace symscene {
namespace {

constexpr double nearly_all = 0.95, nearly_none = 0.05;  // of the points of the lesser set
constexpr double clearly_less = 0.9;                     // of the points of a set that holds it
constexpr double most = 0.85;  // of a set's points, if two are to make it up
constexpr double good = 0.2;   // estimate of a set that may cover a part
constexpr std::size_t most_pieces = 9;

/// What lies in a set, best first, and what is told of the set from that.
class Inside {
 public:
  Inside(const SharedCounts& sets, std::span<const double> estimates, std::size_t whole)
      : sets_(sets), estimates_(estimates), whole_(whole) {
    for (std::size_t b = 0; b < sets.sets(); ++b) {
      if (b != whole && sets.holds(whole, b)) parts_.push_back(b);
    }
    std::stable_sort(parts_.begin(), parts_.end(),
                     [&](std::size_t a, std::size_t b) { return estimates_[a] > estimates_[b]; });
  }

  std::size_t count() const { return parts_.size(); }
  double best() const { return parts_.empty() ? 0.0 : estimates_[parts_.front()]; }

  /// The greatest estimate of a part that makes the whole up with `other`.
  double best_rest(std::size_t other) const {
    for (const std::size_t part : parts_) {
      if (sets_.are_apart(part, other) &&
          sets_.size(part) + sets_.size(other) > most * sets_.size(whole_))
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

  void cover(ProposalContext& context) const {
    std::vector<std::size_t> taken;
    for (const std::size_t part : parts_) {
      if (estimates_[part] < good || taken.size() == most_pieces) break;
      const bool is_free = std::all_of(taken.begin(), taken.end(), [&](std::size_t other) {
        return sets_.shared(part, other) <= 0.1 * sets_.size(part);
      });
      if (!is_free) continue;
      taken.push_back(part);
      const double share = sets_.size(part) / sets_.size(whole_);
      context.covered += share;
      context.covered_score += estimates_[part] * share;
    }
    context.pieces = static_cast<double>(taken.size());
  }

 private:
  const SharedCounts& sets_;
  std::span<const double> estimates_;
  std::size_t whole_;
  std::vector<std::size_t> parts_;
};

}  // namespace

SharedCounts::SharedCounts(std::span<const PointIndices* const> sets)
    : counts_(sets.size() * sets.size()) {
  Index end = 0;
  for (const PointIndices* set : sets) {
    sizes_.push_back(static_cast<std::uint32_t>(set->size()));
    if (!set->empty()) end = std::max(end, set->back() + 1);
  }
  std::vector<std::vector<std::uint32_t>> sets_of(end);  // by point
  for (std::size_t a = 0; a < sets.size(); ++a) {
    for (const Index i : *sets[a]) sets_of[i].push_back(static_cast<std::uint32_t>(a));
  }
  for (const std::vector<std::uint32_t>& own : sets_of) {
    for (const std::uint32_t a : own) {
      for (const std::uint32_t b : own) {
        if (b > a) break;  // they ascend
        ++counts_[(a * sets.size()) + b];
      }
    }
  }
  for (std::size_t a = 0; a < sets.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b)
      counts_[(b * sets.size()) + a] = counts_[(a * sets.size()) + b];
  }
}

bool SharedCounts::holds(std::size_t whole, std::size_t part) const {
  return size(part) < clearly_less * size(whole) && shared(whole, part) > nearly_all * size(part);
}

bool SharedCounts::are_apart(std::size_t a, std::size_t b) const {
  return shared(a, b) <= nearly_none * std::min(size(a), size(b));
}

std::vector<ProposalContext> proposal_contexts(const SharedCounts& sets,
                                               std::span<const double> estimates) {
  std::vector<std::optional<Inside>> insides(sets.sets());
  parallel_for_each(sets.sets(), [&](std::size_t a) { insides[a].emplace(sets, estimates, a); });
  std::vector<ProposalContext> contexts(sets.sets());
  parallel_for_each(sets.sets(), [&](std::size_t a) {
    ProposalContext& context = contexts[a];
    context.estimate = estimates[a];
    std::size_t best_whole = a;
    for (std::size_t b = 0; b < sets.sets(); ++b) {
      if (a == b || sets.are_apart(a, b)) continue;
      if (sets.holds(b, a)) {
        context.wholes += 1.0;
        if (estimates[b] > context.whole) {
          context.whole = estimates[b];
          best_whole = b;
        }
      } else if (!sets.holds(a, b) &&
                 sets.shared(a, b) < clearly_less * std::max(sets.size(a), sets.size(b))) {
        context.rival = std::max(context.rival, estimates[b]);
      }
    }
    context.wholes = std::log1p(context.wholes);
    if (best_whole != a) {
      context.whole_share = sets.size(a) / sets.size(best_whole);
      context.rest = insides[best_whole]->best_rest(a);
    }
    const Inside& inside = *insides[a];
    context.part = inside.best();
    context.parts = std::log1p(static_cast<double>(inside.count()));
    context.split = inside.best_split();
    inside.cover(context);
  });
  return contexts;
}

}  // namespace symscene
