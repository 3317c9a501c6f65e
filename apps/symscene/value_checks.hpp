#pragma once

#include <string>
#include <vector>

#include "symscene/core/options.hpp"

namespace symscene::app {

// Checks of the text behind an option. Each returns "" or what was expected and found, which the
// parser prints behind the name of the option.

std::string check_whole_number(const std::string& text, const Range& range);
/// The ending of a file's name: none, or one of `endings`, of which an empty list allows any.
std::string check_ending(const std::string& name, const std::vector<std::string>& endings);
std::string check_choice(const std::string& text, const std::vector<std::string>& choices);
/// Values of depth images per metre: from 10 m to a micrometre per value.
std::string check_depth_scale(const std::string& text);

}  // namespace symscene::app
