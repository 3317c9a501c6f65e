#include "symscene/dataset/split.hpp"

#include <algorithm>
#include <numeric>

#include "core/random.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): maps neighbouring numbers to unrelated ones.
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

std::string family(const ObjectModel& model) { return model.name.substr(0, model.name.find('-')); }

}  // namespace

const char* to_string(Split split) { return split == Split::training ? "training" : "test"; }

Split parse_split(const std::string& text, const std::string& where) {
  if (text == "training" || text == "tune") return Split::training;
  if (text == "test" || text == "report") return Split::test;
  throw InputError(where, "the split training or test", text);
}

std::uint64_t scene_seed(std::uint64_t dataset_seed, Split split, std::size_t index,
                         std::size_t attempt) {
  const std::uint64_t own = split == Split::test ? 1U : 0U;
  std::uint64_t mixed = dataset_seed;
  for (const std::uint64_t part : {own, std::uint64_t{index}, std::uint64_t{attempt}})
    mixed = scrambled(scrambled(mixed) ^ part);
  // The lowest bit distinguishes the splits.
  return ((mixed >> 12U) << 1U) | own;
}

int object_count(std::uint64_t dataset_seed, Split split, std::size_t index, int min_objects,
                 int max_objects) {
  std::vector<int> counts(static_cast<std::size_t>(max_objects - min_objects + 1));
  std::iota(counts.begin(), counts.end(), min_objects);
  constexpr std::uint64_t stream = std::uint64_t{1} << 40U;  // distinct from the seeds of scenes
  Random random(scene_seed(dataset_seed, split, index / counts.size()), stream);
  for (std::size_t left = counts.size(); left > 1; --left)
    std::swap(counts[left - 1], counts[random.below(static_cast<std::uint32_t>(left))]);
  return counts[index % counts.size()];
}

std::vector<ObjectModel> models_of(Split split, std::vector<ObjectModel> models) {
  std::stable_sort(models.begin(), models.end(), [](const ObjectModel& a, const ObjectModel& b) {
    return std::pair(family(a), a.name) < std::pair(family(b), b.name);
  });
  std::vector<ObjectModel> own;
  std::string current;
  Split turn = Split::test;
  bool first = true;
  for (ObjectModel& model : models) {
    if (first || family(model) != current)
      turn = turn == Split::training ? Split::test : Split::training;
    first = false;
    current = family(model);
    if (turn == split) own.push_back(std::move(model));
  }
  return own;
}

}  // namespace symscene
