#include <fmt/format.h>

#include "symscene/exploration/exploration_output.hpp"

namespace symscene {
namespace {

constexpr double square_centimetres = 1e4;  // per m²
constexpr double much_inferred = 0.2;       // share of an object's surface that is worth a sentence
constexpr double little_seen = 0.5;         // share of a true object's surface that is

double share_of(double part, double all) { return all > 0.0 ? part / all : 0.0; }

std::string inferred_text(const NextViews& left) {
  return fmt::format(
      "{:.0f} % of the surface of {} known object{} ({:.0f} cm²) is inferred, not seen",
      100.0 * share_of(left.inferred_area, left.object_area), left.areas.size(),
      left.areas.size() == 1 ? "" : "s", square_centimetres * left.inferred_area);
}

std::string best_text(const NextViews& left) {
  if (left.ranked.empty()) return "no view is left that could show more";
  const RankedView& best = left.ranked.front();
  return fmt::format(
      "the best further view, from candidate {}, would show {:.1f} cm², weighted: {:.1f} cm² "
      "inferred, {:.1f} cm² disputed, {:.1f} cm² unknown",
      best.candidate, square_centimetres * best.gain.total(),
      square_centimetres * best.gain.inferred, square_centimetres * best.gain.disputed,
      square_centimetres * best.gain.unknown);
}

void add_inferred_objects(const NextViews& left, std::vector<std::string>& sentences) {
  for (std::size_t k = 0; k < left.areas.size(); ++k) {
    const double share = share_of(left.areas[k].inferred, left.areas[k].all);
    if (share >= much_inferred)
      sentences.push_back(
          fmt::format("object {}: {:.0f} % of its surface is inferred", k, 100.0 * share));
  }
}

void add_unseen_objects(const TableExploration& exploration, const Tabletop& table,
                        std::vector<std::string>& sentences) {
  for (std::size_t k = 0; k < table.objects.size(); ++k) {
    if (exploration.seen[k] < little_seen)
      sentences.push_back(fmt::format("{}: {:.0f} % of its true surface was seen",
                                      table.objects[k].object.name, 100.0 * exploration.seen[k]));
  }
}

}  // namespace

const char* description(ExplorationEnd end) {
  switch (end) {
    case ExplorationEnd::views:
      return "as many views were taken as were asked for";
    case ExplorationEnd::enough:
      return "no further view is expected to show much more";
    case ExplorationEnd::no_view:
      return "all candidate views were taken";
  }
  return "";
}

const char* gain_unit(ExplorationPolicy policy) {
  return ranking_policy(policy).value_or(ViewPolicy::symmetry) == ViewPolicy::symmetry ? "cm²"
                                                                                       : "voxels";
}

double shown_gain(double gain, ExplorationPolicy policy) {
  const bool is_area =
      ranking_policy(policy).value_or(ViewPolicy::symmetry) == ViewPolicy::symmetry;
  return (is_area ? square_centimetres : 1.0) * gain;
}

std::string format_explored_view(const ExploredView& view, std::size_t number,
                                 ExplorationPolicy policy) {
  std::string text = fmt::format("view {} from candidate {}: ", number, view.step.view);
  if (view.step.gain)
    text += fmt::format("gain {:.{}f} {}, ", shown_gain(view.step.gain->total(), policy),
                        ranking_policy(policy) == ViewPolicy::symmetry ? 1 : 0, gain_unit(policy));
  return text + fmt::format("{} object{}, observed {:.2f}, completed {:.2f}", view.objects.size(),
                            view.objects.size() == 1 ? "" : "s", view.step.observed,
                            view.step.completed);
}

std::vector<std::string> format_left_unknown(const TableExploration& exploration,
                                             const Tabletop& table) {
  const NextViews& left = exploration.left();
  std::vector<std::string> sentences{inferred_text(left), best_text(left)};
  sentences.push_back(fmt::format("the border of space that was never seen has {:.0f} cm²",
                                  square_centimetres * left.unknown_area));
  add_inferred_objects(left, sentences);
  add_unseen_objects(exploration, table, sentences);
  return sentences;
}

}  // namespace symscene
