#include "scene_cache.hpp"

#include <fmt/format.h>

#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/scene.hpp"

namespace symscene::bench {
namespace {

/// The names and values of all options as text, the key of a cached scene.
class OptionText {
 public:
  template <class Value>
  void operator()(const char* name, const Value& value, const char*, const Range&, const char*) {
    text_ += fmt::format("{}={} ", name, value);
  }
  template <class Group>
  void operator()(const char* name, const Group& group) {
    text_ += fmt::format("{}: ", name);
    visit_options(group, *this);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// FNV-1a, the same on every machine.
std::uint64_t digest(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

std::string cache_name(const SimulationOptions& options) {
  OptionText all;
  visit_options(options, all);
  return fmt::format("seed{}_objects{}_{:016x}", options.tabletop.seed, options.tabletop.objects,
                     digest(all.text()));
}

}  // namespace

TrueScene simulated_scene(const SimulationOptions& options, const std::filesystem::path& cache) {
  const std::filesystem::path folder = cache / cache_name(options);
  if (!cache.empty() && std::filesystem::exists(folder / "truth.json")) {
    TrueScene cached;
    cached.scene = read_scene(folder);
    cached.truth = read_truth(folder / "truth.json", cached.scene.cloud.size());
    return cached;
  }
  SimulatedScene simulated = simulate_tabletop(options);
  if (!cache.empty())
    write_scene(folder, simulated.scene, {.truth_json = format_truth(simulated.truth)});
  return {std::move(simulated.scene), std::move(simulated.truth)};
}

}  // namespace symscene::bench
