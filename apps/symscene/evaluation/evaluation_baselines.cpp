#include "evaluation_baselines.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "symscene/baselines/euclidean_sweep.hpp"
#include "symscene/baselines/felzenszwalb.hpp"
#include "symscene/baselines/lccp.hpp"
#include "symscene/core/error.hpp"

namespace symscene::app {
namespace {

struct NamedBaseline {
  std::string name;
  BaselineMethod method;
};

std::vector<NamedBaseline> known_baselines() {
  std::vector<NamedBaseline> baselines = {
      {"felzenszwalb", [](const PointCloud& cloud) { return felzenszwalb_sweep(cloud); }},
      {"euclidean", [](const PointCloud& cloud) { return euclidean_sweep(cloud); }}};
  if (has_lccp())
    baselines.push_back({"lccp", [](const PointCloud& cloud) { return lccp_sweep(cloud); }});
  return baselines;
}

}  // namespace

std::string baseline_names() {
  std::string names = "all, none";
  for (const NamedBaseline& baseline : known_baselines()) names += ", " + baseline.name;
  return names;
}

std::vector<BaselineMethod> baseline_methods(const std::string& names) {
  const std::vector<NamedBaseline> known = known_baselines();
  std::vector<BaselineMethod> chosen;
  if (names == "none") return chosen;
  if (names == "all") {
    for (const NamedBaseline& baseline : known) chosen.push_back(baseline.method);
    return chosen;
  }
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    const auto baseline =
        std::find_if(known.begin(), known.end(),
                     [&](const NamedBaseline& candidate) { return candidate.name == name; });
    if (baseline == known.end()) {
      throw InputError("--baselines", fmt::format("some of {}", baseline_names()),
                       fmt::format("\"{}\"", name));
    }
    chosen.push_back(baseline->method);
  }
  return chosen;
}

}  // namespace symscene::app
