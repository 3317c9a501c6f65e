#include "urdf_tree.hpp"

#ifdef SYMSCENE_HAS_URDF
#include <map>

#include <fmt/format.h>
#include <tinyxml.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

const char* link_of(const TiXmlElement& joint, const char* role) {
  const TiXmlElement* element = joint.FirstChildElement(role);
  return element != nullptr ? element->Attribute("link") : nullptr;
}

using Parents = std::map<std::string, std::string>;  ///< parent of each child link

Parents parents_of_links(const TiXmlElement& robot, const std::string& file) {
  Parents parents;
  for (const TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const char* parent = link_of(*joint, "parent");
    const char* child = link_of(*joint, "child");
    if (parent == nullptr || child == nullptr) continue;
    if (!parents.emplace(child, parent).second)
      throw InputError(file, "links with one parent", fmt::format("link {} with another", child));
  }
  return parents;
}

/// If the way from the link over its parents does not end.
bool is_in_or_below_loop(std::string link, const Parents& parents) {
  for (std::size_t steps = 0; steps <= parents.size(); ++steps) {
    const auto above = parents.find(link);
    if (above == parents.end()) return false;
    link = above->second;
  }
  return true;
}

}  // namespace

void require_trees(const std::string& text, const std::string& file) {
  TiXmlDocument document;
  document.Parse(text.c_str());
  const TiXmlElement* robot = document.FirstChildElement("robot");
  if (robot == nullptr) return;
  const Parents parents = parents_of_links(*robot, file);
  for (const auto& [child, parent] : parents) {
    if (is_in_or_below_loop(child, parents))
      throw InputError(file, "links that make a tree",
                       fmt::format("a loop of joints above link {}", child));
  }
}

}  // namespace symscene

#endif
