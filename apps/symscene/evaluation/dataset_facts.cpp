#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "facts.hpp"
#include "symscene/dataset/dataset_folder.hpp"
#include "symscene/ground_truth/truth_file.hpp"

namespace symscene::app {
namespace {

/// Sums over all scenes of a dataset.
struct Totals {
  std::size_t fewest = 0;
  std::size_t most = 0;
  std::size_t objects = 0;
  std::size_t axes = 0;
  std::size_t planes = 0;
  std::size_t spheres = 0;
  std::map<std::string, std::size_t> subsets;

  void add(const DatasetEntry& entry) {
    const std::size_t count = entry.folder.empty() ? labels_of(entry) : truths_of(entry);
    fewest = subsets.empty() ? count : std::min(fewest, count);
    most = std::max(most, count);
    objects += count;
    ++subsets[entry.subset];
  }

 private:
  static std::size_t labels_of(const DatasetEntry& entry) {
    const LabeledFrame frame = read_labeled_frame(entry);
    std::set<std::uint16_t> labels(frame.labels.begin(), frame.labels.end());
    labels.erase(0);
    return labels.size();
  }

  std::size_t truths_of(const DatasetEntry& entry) {
    const SceneTruth truth = read_truth(entry.folder / "truth.json");
    for (const TrueObject& object : truth.objects) {
      axes += object.rotational.size();
      planes += object.reflectional.size();
      spheres += object.sphere ? 1 : 0;
    }
    return truth.objects.size();
  }
};

void add_scenes(Facts& facts, const DatasetListing& listing, const Totals& totals) {
  std::vector<std::string> parts;
  for (const auto& [subset, count] : totals.subsets) {
    if (!subset.empty()) parts.push_back(fmt::format("{} {}", count, subset));
  }
  std::string text = fmt::format("{}{}{}", listing.entries.size(), parts.empty() ? "" : ": ",
                                 fmt::join(parts, ", "));
  if (!listing.missing.empty()) text += fmt::format("; {} missing", listing.missing.size());
  facts.add("scenes", text, "scenes", listing.entries.size());
  facts.add_member("subsets", totals.subsets);
  facts.add_member("missing", listing.missing);
  if (!listing.missing.empty())
    facts.add_row("missing", fmt::format("{}", fmt::join(listing.missing, ", ")));
}

}  // namespace

Facts dataset_facts(const std::filesystem::path& path) {
  const DatasetListing listing = read_dataset(path);
  Totals totals;
  for (const DatasetEntry& entry : listing.entries) totals.add(entry);
  Facts facts("dataset");
  facts.add("dataset", listing.layout, "layout", listing.layout);
  if (listing.split)
    facts.add("split", to_string(*listing.split), "split", to_string(*listing.split));
  if (listing.seed) facts.add("seed", std::to_string(*listing.seed), "seed", *listing.seed);
  add_scenes(facts, listing, totals);
  facts.add("objects",
            fmt::format("{}, {} to {} per scene", totals.objects, totals.fewest, totals.most),
            "objects", totals.objects);
  facts.add_member("objects_a_scene", {totals.fewest, totals.most});
  facts.add(
      "symmetries",
      fmt::format("{} axes, {} planes, {} spheres", totals.axes, totals.planes, totals.spheres),
      "symmetries",
      {{"axes", totals.axes}, {"planes", totals.planes}, {"spheres", totals.spheres}});
  return facts;
}

}  // namespace symscene::app
