#pragma once

#include <string>

#include "scene_evaluation.hpp"

namespace symscene::bench {

/// The tables of scenes and kinds of objects.
std::string scene_header();
std::string scene_row(const std::string& name, const SceneScore& score);
std::string kind_table(const SceneScore& total);

/// The totals as one line of JSON, for scripts that compare settings.
std::string json_line(std::uint64_t seed, std::size_t scenes, const SceneScore& total);

}  // namespace symscene::bench
