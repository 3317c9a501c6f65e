#include "pick_table.hpp"

#include <array>
#include <map>

#include <fmt/format.h>

namespace symscene::app {
namespace {

struct Reason {
  std::size_t count = 0;
  std::string detail;  ///< of the first
};

struct ObjectReach {
  std::size_t grasps = 0, reached = 0, rejected = 0;
  std::array<Reason, pick_rejections> reasons;
};

/// "7: the arm would collide (link5 meets the table by 12 mm); 2: no path was found to it".
std::string reasons_text(const ObjectReach& object) {
  std::string text;
  for (std::size_t i = 0; i < pick_rejections; ++i) {
    const Reason& reason = object.reasons.at(i);
    if (reason.count == 0) continue;
    if (!text.empty()) text += "; ";
    text += fmt::format("{}: {}", reason.count, description(static_cast<PickRejection>(i)));
    if (!reason.detail.empty()) text += fmt::format(" ({})", reason.detail);
  }
  return text;
}

}  // namespace

std::string format_reach(std::span<const Grasp> grasps, std::span<const std::size_t> reached,
                         std::span<const RejectedPick> rejected) {
  std::map<int, ObjectReach> objects;
  for (const Grasp& grasp : grasps) ++objects[grasp.object].grasps;
  for (const std::size_t grasp : reached) ++objects[grasps[grasp].object].reached;
  for (const RejectedPick& pick : rejected) {
    ObjectReach& object = objects[grasps[pick.grasp].object];
    Reason& reason = object.reasons.at(static_cast<std::size_t>(pick.reason));
    ++object.rejected;
    if (reason.count++ == 0) reason.detail = pick.detail;
  }
  std::string table = " id  grasps  reached  not tried  not reached";
  for (const auto& [id, object] : objects) {
    table += fmt::format("\n{:>3}  {:>6}  {:>7}  {:>9}  {}", id, object.grasps, object.reached,
                         object.grasps - object.reached - object.rejected, reasons_text(object));
    table.erase(table.find_last_not_of(' ') + 1);
  }
  return table;
}

std::string format_motion(const PickMotion& motion, std::size_t number, const Grasp& grasp) {
  return fmt::format(
      "object {}, grasp {} with quality {:.2f}: {:.2f} s to it, {:.2f} s straight on, {:.2f} s "
      "away",
      grasp.object, number, grasp.quality, motion.to_pre_grasp.duration(),
      motion.approach.duration(), motion.retreat.duration());
}

}  // namespace symscene::app
