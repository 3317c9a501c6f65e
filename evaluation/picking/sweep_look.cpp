#include "sweep_look.hpp"

#include <algorithm>

#include "contact_watch.hpp"

namespace symscene {
namespace {

std::vector<CameraMoment> swept(ArmCell& cell, const Arm& arm, const LookMotion& motion, int frames,
                                const LookImages& images, ContactWatch& watch) {
  const auto watched = [&] {
    watch.note(true);
    return false;
  };
  cell.follow(arm, motion.there, watched);
  const double begin = cell.time();
  const double interval = motion.sweep.duration() / std::max(1, frames - 1);
  std::vector<CameraMoment> moments{images.moment(cell)};
  cell.follow(arm, motion.sweep, [&] {
    if (cell.time() - begin >= interval * static_cast<double>(moments.size()))
      moments.push_back(images.moment(cell));
    return watched();
  });
  moments.resize(std::min(moments.size(), static_cast<std::size_t>(frames)));
  cell.follow(arm, motion.back, watched);
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
