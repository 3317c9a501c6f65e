#include "sweep_look.hpp"

#include <algorithm>

#include "contact_watch.hpp"

namespace symscene {
namespace {

std::vector<CameraMoment> swept(ArmCell& cell, const Arm& arm, const LookMotion& motion, int frames,
                                const LookImages& images, ContactWatch& watch) {
  follow_watched(cell, arm, motion.there, watch);
  const double begin = cell.time();
  const double interval = motion.sweep.duration() / std::max(1, frames - 1);
  std::vector<CameraMoment> moments{images.moment(cell)};
  cell.follow(arm, motion.sweep, [&] {
    if (cell.time() - begin >= interval * static_cast<double>(moments.size()))
      moments.push_back(images.moment(cell));
    watch.note(true);
    return false;
  });
  moments.resize(std::min(moments.size(), static_cast<std::size_t>(frames)));
  follow_watched(cell, arm, motion.back, watch);
  return moments;
}

}  // namespace

TakenLook sweep_look(ArmCell& cell, const Arm& arm, const LookMotion& motion, int frames,
                     LookImages& images, TablePerception& perception) {
  ContactWatch watch(cell);
  const std::vector<CameraMoment> moments = swept(cell, arm, motion, frames, images, watch);
  const double covered = images.add(cell, moments, perception);
  return {covered / static_cast<double>(moments.size()), watch.touched()};
}

}  // namespace symscene
