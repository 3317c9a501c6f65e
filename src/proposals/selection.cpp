#include "symscene/proposals/selection.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t max_exact_rivals = 24;

/// Which objects exclude one another, and what each is worth.
struct Rivalry {
  std::vector<double> worth;
  std::vector<std::vector<std::size_t>> rivals;  ///< ascending
};

double shared_part(const SceneObject& a, const SceneObject& b) {
  const std::size_t smaller = std::min(a.points.size(), b.points.size());
  return smaller == 0 ? 0.0
                      : static_cast<double>(intersection_size(a.points, b.points)) /
                            static_cast<double>(smaller);
}

Rivalry rivalry_of(const std::vector<SceneObject>& objects, std::vector<double> worth,
                   double max_overlap) {
  Rivalry rivalry;
  rivalry.worth = std::move(worth);
  rivalry.rivals.resize(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (shared_part(objects[i], objects[j]) <= max_overlap) continue;
      rivalry.rivals[i].push_back(j);
      rivalry.rivals[j].push_back(i);
    }
  }
  for (std::vector<std::size_t>& rivals : rivalry.rivals) std::sort(rivals.begin(), rivals.end());
  return rivalry;
}

/// Objects that exclude one another directly or through others.
std::vector<std::vector<std::size_t>> groups_of(const Rivalry& rivalry) {
  std::vector<bool> visited(rivalry.worth.size(), false);
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t start = 0; start < visited.size(); ++start) {
    if (visited[start]) continue;
    std::vector<std::size_t> group{start};
    visited[start] = true;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (const std::size_t rival : rivalry.rivals[group[next]]) {
        if (visited[rival]) continue;
        visited[rival] = true;
        group.push_back(rival);
      }
    }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Tries with and without each member in turn, as long as what is left could still win.
class ExactSearch {
 public:
  ExactSearch(const Rivalry& rivalry, const std::vector<std::size_t>& group)
      : rivalry_(rivalry), group_(group) {}

  std::vector<std::size_t> run() {
    double left = 0.0;
    for (const std::size_t member : group_) left += rivalry_.worth[member];
    extend(0, 0.0, left);
    return best_;
  }

 private:
  void extend(std::size_t next, double worth, double left) {
    if (worth > best_worth_) {
      best_worth_ = worth;
      best_ = chosen_;
    }
    if (next == group_.size() || worth + left <= best_worth_) return;
    const std::size_t member = group_[next];
    const double member_worth = rivalry_.worth[member];
    const auto& rivals = rivalry_.rivals[member];
    const bool admissible = std::none_of(chosen_.begin(), chosen_.end(), [&](std::size_t other) {
      return std::binary_search(rivals.begin(), rivals.end(), other);
    });
    if (admissible) {
      chosen_.push_back(member);
      extend(next + 1, worth + member_worth, left - member_worth);
      chosen_.pop_back();
    }
    extend(next + 1, worth, left - member_worth);
  }

  const Rivalry& rivalry_;
  const std::vector<std::size_t>& group_;
  std::vector<std::size_t> chosen_;
  std::vector<std::size_t> best_;
  double best_worth_ = -1.0;
};

/// By falling worth, then exchanges as long as one gains: a member that is out for its rivals that
/// are in, or one that is in for those that only it keeps out.
class LocalSearch {
 public:
  LocalSearch(const Rivalry& rivalry, std::vector<std::size_t> group)
      : rivalry_(rivalry), group_(std::move(group)), is_chosen_(rivalry.worth.size(), false) {
    std::stable_sort(group_.begin(), group_.end(), [&](std::size_t a, std::size_t b) {
      return rivalry_.worth[a] > rivalry_.worth[b];
    });
  }

  std::vector<std::size_t> run() {
    for (const std::size_t member : group_) {
      if (chosen_rivals(member).empty()) is_chosen_[member] = true;
    }
    for (bool gained = true; gained;) {
      gained = false;
      for (const std::size_t member : group_)
        gained = (is_chosen_[member] ? make_way(member) : force_in(member)) || gained;
    }
    std::vector<std::size_t> chosen;
    for (const std::size_t member : group_) {
      if (is_chosen_[member]) chosen.push_back(member);
    }
    return chosen;
  }

 private:
  static constexpr double least_gain = 1e-9;

  std::vector<std::size_t> chosen_rivals(std::size_t member) const {
    std::vector<std::size_t> chosen;
    for (const std::size_t rival : rivalry_.rivals[member]) {
      if (is_chosen_[rival]) chosen.push_back(rival);
    }
    return chosen;
  }

  bool force_in(std::size_t member) {
    const std::vector<std::size_t> rivals = chosen_rivals(member);
    double gain = rivalry_.worth[member];
    for (const std::size_t rival : rivals) gain -= rivalry_.worth[rival];
    if (gain <= least_gain) return false;
    for (const std::size_t rival : rivals) is_chosen_[rival] = false;
    is_chosen_[member] = true;
    return true;
  }

  bool make_way(std::size_t member) {
    is_chosen_[member] = false;
    double gain = -rivalry_.worth[member];
    std::vector<std::size_t> added;
    for (const std::size_t rival : group_) {
      const auto& rivals = rivalry_.rivals[rival];
      if (!std::binary_search(rivals.begin(), rivals.end(), member)) continue;
      if (!chosen_rivals(rival).empty()) continue;
      is_chosen_[rival] = true;
      added.push_back(rival);
      gain += rivalry_.worth[rival];
    }
    if (gain > least_gain) return true;
    for (const std::size_t rival : added) is_chosen_[rival] = false;
    is_chosen_[member] = true;
    return false;
  }

  const Rivalry& rivalry_;
  std::vector<std::size_t> group_;
  std::vector<bool> is_chosen_;
};

/// The set of greatest worth without two rivals, as flags.
std::vector<bool> best_set(const Rivalry& rivalry) {
  std::vector<bool> chosen(rivalry.worth.size(), false);
  for (const std::vector<std::size_t>& group : groups_of(rivalry)) {
    const std::vector<std::size_t> winners = group.size() <= max_exact_rivals
                                                 ? ExactSearch(rivalry, group).run()
                                                 : LocalSearch(rivalry, group).run();
    for (const std::size_t winner : winners) chosen[winner] = true;
  }
  return chosen;
}

/// Whether `part` lies in `whole` and is clearly smaller.
bool is_part(const SceneObject& part, const SceneObject& whole) {
  constexpr double inside = 0.8;
  constexpr double largest_part = 0.85;
  const auto size = static_cast<double>(part.points.size());
  const auto common = static_cast<double>(intersection_size(part.points, whole.points));
  return common > inside * size && size < largest_part * static_cast<double>(whole.points.size());
}

/// The share of an object that others inside it hold together, which could all stay side by side:
/// by falling score, those that overlap too much with one before them do not count.
double share_held_by_parts(const std::vector<SceneObject>& objects, std::size_t whole,
                           double max_overlap) {
  std::vector<std::size_t> parts;
  PointIndices held;
  for (std::size_t i = 0; i < objects.size(); ++i) {  // objects come by falling score
    const bool rivals_another = std::any_of(parts.begin(), parts.end(), [&](std::size_t part) {
      return shared_part(objects[i], objects[part]) > max_overlap;
    });
    if (i == whole || rivals_another || !is_part(objects[i], objects[whole])) continue;
    parts.push_back(i);
    PointIndices joined;
    std::set_union(held.begin(), held.end(), objects[i].points.begin(), objects[i].points.end(),
                   std::back_inserter(joined));
    held = std::move(joined);
  }
  const PointIndices& points = objects[whole].points;
  return static_cast<double>(intersection_size(held, points)) / static_cast<double>(points.size());
}

Rejection rejection_of(const SceneObject& object, const char* reason, double value, double bound) {
  const char* kind = !object.rotational.empty()     ? "rotational"
                     : !object.reflectional.empty() ? "reflectional"
                                                    : "surface";
  return {kind, reason, value, bound, object.points.size(), object.points};
}

std::vector<SceneObject> without_composites(std::vector<SceneObject> objects,
                                            const SelectionOptions& options,
                                            std::vector<Rejection>& rejected) {
  std::vector<double> held(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i)
    held[i] = share_held_by_parts(objects, i, options.max_overlap);
  std::vector<SceneObject> kept;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (held[i] > options.min_parts_cover) {
      rejected.push_back(rejection_of(objects[i], "composite", held[i], options.min_parts_cover));
    } else {
      kept.push_back(std::move(objects[i]));
    }
  }
  return kept;
}

/// The greatest share of an object that a chosen one holds.
double greatest_overlap(const std::vector<SceneObject>& objects, std::size_t loser,
                        const std::vector<bool>& chosen) {
  double greatest = 0.0;
  for (std::size_t j = 0; j < objects.size(); ++j) {
    if (chosen[j]) greatest = std::max(greatest, shared_part(objects[loser], objects[j]));
  }
  return greatest;
}

/// What is chosen; the others are rejected.
std::vector<SceneObject> winners(std::vector<SceneObject> objects, const std::vector<bool>& chosen,
                                 double max_overlap, std::vector<Rejection>& rejected) {
  std::vector<SceneObject> selected;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (chosen[i]) continue;
    rejected.push_back(
        rejection_of(objects[i], "overlap", greatest_overlap(objects, i, chosen), max_overlap));
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (chosen[i]) selected.push_back(std::move(objects[i]));
  }
  return selected;
}

}  // namespace

void SelectionOptions::validate() const {
  require_option(min_score >= 0.0 && min_score <= 1.0, "min_score", "a probability in [0, 1]",
                 min_score);
  require_option(max_overlap >= 0.0 && max_overlap <= 1.0, "max_overlap", "a share in [0, 1]",
                 max_overlap);
  require_option(min_parts_cover >= 0.0 && min_parts_cover <= 1.0, "min_parts_cover",
                 "a share in [0, 1]", min_parts_cover);
  require_option(score_exponent >= 0.0 && score_exponent <= 20.0, "score_exponent",
                 "a number in [0, 20]", score_exponent);
}

std::vector<SceneObject> select_consistent(std::vector<SceneObject> objects,
                                           const SelectionOptions& options,
                                           std::vector<Rejection>& rejected) {
  objects = without_composites(std::move(objects), options, rejected);
  std::vector<double> worth;
  for (const SceneObject& object : objects) {
    worth.push_back(static_cast<double>(object.points.size()) *
                    std::pow(object.score, options.score_exponent));
  }
  const Rivalry rivalry = rivalry_of(objects, std::move(worth), options.max_overlap);
  return winners(std::move(objects), best_set(rivalry), options.max_overlap, rejected);
}

std::vector<SceneObject> select_probable(std::vector<SceneObject> objects,
                                         const SelectionOptions& options,
                                         std::vector<Rejection>& rejected) {
  std::vector<SceneObject> probable;
  std::vector<double> worth;
  for (SceneObject& object : objects) {
    if (object.score <= options.min_score) {
      rejected.push_back(rejection_of(object, "score", object.score, options.min_score));
      continue;
    }
    worth.push_back(object.score - options.min_score);
    probable.push_back(std::move(object));
  }
  const Rivalry rivalry = rivalry_of(probable, std::move(worth), options.max_overlap);
  return winners(std::move(probable), best_set(rivalry), options.max_overlap, rejected);
}

}  // namespace symscene
