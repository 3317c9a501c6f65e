#pragma once

#include <string>

namespace symscene {

/// Throws InputError unless each link in the text has at most one parent and none is its own
/// ancestor. urdfdom keeps one of several parents, and never frees the memory of links in a loop.
/// Accepts what is no robot in URDF: urdfdom says why it is none.
void require_trees(const std::string& text, const std::string& file);

}  // namespace symscene
