#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "facts.hpp"
#include "results.hpp"
#include "symscene/io/result.hpp"

namespace symscene::app {
namespace {

void add_masks(Facts& facts, const SegmentationResult& result) {
  std::vector<std::size_t> sizes;
  std::set<Index> covered;
  for (const SceneObject& object : result.objects) {
    sizes.push_back(object.points.size());
    covered.insert(object.points.begin(), object.points.end());
  }
  facts.add_member("mask_sizes", sizes);
  facts.add_member("points_in_masks", covered.size());
  if (sizes.empty()) return;
  std::sort(sizes.begin(), sizes.end());
  facts.add_row("masks", fmt::format("{} to {} points, median {}; {} of {} points in one or more",
                                     sizes.front(), sizes.back(), sizes[sizes.size() / 2],
                                     covered.size(), result.cloud.size()));
}

void add_symmetries(Facts& facts, const SegmentationResult& result) {
  std::size_t axes = 0;
  std::size_t planes = 0;
  for (const SceneObject& object : result.objects) {
    axes += object.rotational.size();
    planes += object.reflectional.size();
  }
  facts.add("symmetries", fmt::format("{} axes, {} planes", axes, planes), "rotational", axes);
  facts.add_member("reflectional", planes);
}

void add_rejected(Facts& facts, const SegmentationResult& result) {
  std::map<std::string, std::size_t> reasons;
  for (const Rejection& rejection : result.rejected) {
    ++reasons[rejection.kind + " " + rejection.reason];
  }
  std::string text = fmt::format("{} hypotheses", result.rejected.size());
  for (const auto& [reason, count] : reasons) {
    text += fmt::format("{} {} by {}", reason == reasons.begin()->first ? ":" : ",", count, reason);
  }
  facts.add("rejected", text, "rejected", reasons);
}

void add_timings(Facts& facts, const SegmentationResult& result) {
  double total = 0.0;
  const StageTime* longest = nullptr;
  Facts::Json seconds = Facts::Json::object();
  for (const StageTime& time : result.timings) {
    total += time.seconds;
    seconds[time.stage] = time.seconds;
    if (longest == nullptr || time.seconds > longest->seconds) longest = &time;
  }
  facts.add_member("times", seconds);
  if (longest == nullptr) return;
  facts.add_row("times", fmt::format("{:.0f} ms, {:.0f} of them {}", 1e3 * total,
                                     1e3 * longest->seconds, longest->stage));
}

}  // namespace

Facts result_facts(const std::filesystem::path& dir) {
  const SegmentationResult result = read_result(dir);
  Facts facts("result");
  facts.add_row("result", folder_name(dir));
  facts.add("objects", fmt::format("{}", result.objects.size()), "objects", result.objects.size());
  facts.add_member("points", result.cloud.size());
  add_masks(facts, result);
  add_symmetries(facts, result);
  add_rejected(facts, result);
  add_timings(facts, result);
  if (!result.objects.empty()) facts.add_row("", "\n" + format_objects(result));
  return facts;
}

}  // namespace symscene::app
