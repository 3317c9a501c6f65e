#include "tables.hpp"

#include <fmt/format.h>

namespace symscene::bench {
namespace {

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 100.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// Precision and recall in percent; a dash where there is nothing to find or nothing was found.
std::string rates(const DetectionCounts& counts) {
  const auto rate = [](std::size_t part, std::size_t whole) {
    return whole == 0 ? std::string("-") : fmt::format("{:.0f}", percent(part, whole));
  };
  return fmt::format("{:>4} {:>4}", rate(counts.correct, counts.found),
                     rate(counts.correct, counts.ground_truth));
}

}  // namespace

std::string scene_header() {
  return fmt::format("{:<16} {:>7} {:>5} {:>8} | {:^9} | {:^9} | {:>5} | {:^9} | {:^9} | {:>7}\n",
                     "", "", "", "", "IoU>0.9", "IoU>0.75", "mean", "axes", "planes", "") +
         fmt::format(
             "{:<16} {:>7} {:>5} {:>8} | {:>4} {:>4} | {:>4} {:>4} | {:>5} | {:>4} {:>4} "
             "| {:>4} {:>4} | {:>7}\n",
             "scene", "objects", "found", "returned", "P%", "R%", "P%", "R%", "IoU", "P%", "R%",
             "P%", "R%", "time s");
}

std::string scene_row(const std::string& name, const SceneScore& score) {
  const DetectionCounts& masks = score.counts.detections(Metric::masks_90);
  return fmt::format("{:<16} {:>7} {:>5} {:>8} | {} | {} | {:>5.2f} | {} | {} | {:>7.2f}\n", name,
                     masks.ground_truth, masks.correct, masks.found, rates(masks),
                     rates(score.counts.detections(Metric::masks_75)), score.counts.mean_overlap(),
                     rates(score.counts.detections(Metric::axes_near)),
                     rates(score.counts.detections(Metric::planes_near)), score.seconds);
}

std::string kind_table(const SceneScore& total) {
  std::string text = fmt::format("{:<16} {:>7} {:>10} {:>11} {:>9} {:>13}\n", "kind", "objects",
                                 "R% at 0.9", "R% at 0.75", "mean IoU", "symmetries R%");
  for (const auto& [name, kind] : total.kinds) {
    text += fmt::format("{:<16} {:>7} {:>10.0f} {:>11.0f} {:>9.2f} {:>13.0f}\n", name, kind.objects,
                        percent(kind.count(Outcome::found), kind.objects),
                        percent(kind.over_75, kind.objects), kind.mean_overlap(),
                        percent(kind.symmetries_met, kind.symmetries));
  }
  return text;
}

std::string json_line(std::uint64_t seed, std::size_t scenes, const SceneScore& total) {
  const auto rates_of = [&](const char* name, Metric metric) {
    const DetectionCounts& s = total.counts.detections(metric);
    return fmt::format(R"("{}": {{"precision": {:.4f}, "recall": {:.4f}, "f": {:.4f}}}, )", name,
                       s.precision(), s.recall(), s.f_measure());
  };
  return fmt::format(
             R"({{"seed": {}, "scenes": {}, {}{}{}{}"mean_iou": {:.4f}, "seconds": {:.3f}}})", seed,
             scenes, rates_of("iou_90", Metric::masks_90), rates_of("iou_75", Metric::masks_75),
             rates_of("axes", Metric::axes_near), rates_of("planes", Metric::planes_near),
             total.counts.mean_overlap(), total.seconds) +
         "\n";
}

}  // namespace symscene::bench
