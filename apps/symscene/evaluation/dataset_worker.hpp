#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "symscene/core/stage_timer.hpp"
#include "symscene/dataset/scene_maker.hpp"

namespace symscene::app {

/// The report of a process that made a scene to the process that collects the scenes.
struct SceneReport {
  std::size_t objects = 0;
  std::vector<std::string> warnings;
  std::vector<StageTime> stages;
};

/// Makes scene `index` with one thread and writes its folder. Returns its report as text for
/// parse_report(). Throws std::runtime_error if no seed made a good scene.
std::string make_and_write_scene(const std::filesystem::path& dir, const DatasetOptions& options,
                                 Split split, std::span<const ObjectModel> models,
                                 std::size_t index);

SceneReport parse_report(const std::string& text);

}  // namespace symscene::app
