#include "evaluation_baselines.hpp"

#include <algorithm>
#include <chrono>
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

/// `sweep(cloud, values)` as a method whose time is that of a further run at its middle value: its
/// values share work.
template <class Sweep>
BaselineMethod timed(const Sweep& sweep) {
  return [sweep](const PointCloud& cloud) {
    BaselineSweep found = sweep(cloud, {});
    if (found.values.empty()) return found;
    const auto begin = std::chrono::steady_clock::now();
    sweep(cloud, {found.values[found.values.size() / 2]});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    found.seconds = taken.count();
    return found;
  };
}

std::vector<NamedBaseline> known_baselines() {
  using Values = std::vector<double>;
  std::vector<NamedBaseline> baselines = {
      {"felzenszwalb", timed([](const PointCloud& cloud, const Values& values) {
         return felzenszwalb_sweep(cloud, {}, values);
       })},
      {"euclidean", timed([](const PointCloud& cloud, const Values& values) {
         return euclidean_sweep(cloud, {}, values);
       })}};
  if (has_lccp()) {
    baselines.push_back({"lccp", timed([](const PointCloud& cloud, const Values& values) {
                           return lccp_sweep(cloud, {}, values);
                         })});
  }
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
