#include "object_samples.hpp"

#include <cstring>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/model_features.hpp"
#include "io/atomic_file.hpp"
#include "proposals/proposal_context.hpp"
#include "symscene/core/error.hpp"
#include "symscene/evaluation/mask_metrics.hpp"

namespace symscene::bench {
namespace {

/// The first line of a file: the version and the features of this build.
std::string heading() {
  return fmt::format("symscene_samples 1 {}\n", fmt::join(names_of<ObjectFeatures>(), " "));
}

template <class T>
void put(std::string& bytes, const std::vector<T>& values) {
  const auto count = static_cast<std::uint32_t>(values.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// Reads what put() wrote.
class Reader {
 public:
  Reader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  bool at_end() const { return bytes_.empty(); }

  template <class T>
  std::vector<T> take() {
    std::uint32_t count = 0;
    copy(&count, sizeof count);
    std::vector<T> values(count);
    copy(values.data(), values.size() * sizeof(T));
    return values;
  }

 private:
  void copy(void* to, std::size_t size) {
    if (size > bytes_.size())
      throw InputError(name_, "the samples of whole scenes", "a file that ends before");
    std::memcpy(to, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

  std::string_view bytes_;
  std::string name_;
};

}  // namespace

SceneSamples object_samples(const Scene& scene, const SceneTruth& truth,
                            const PipelineOptions& options) {
  const SceneProposals proposals = propose_objects(scene, options);
  const std::vector<PointIndices> masks = transfer_masks(scene.cloud, truth, proposals.cloud);
  SceneSamples samples;
  for (const PointIndices& mask : masks)
    samples.true_sizes.push_back(static_cast<std::uint32_t>(mask.size()));
  std::vector<const PointIndices*> points;
  for (const ObjectProposal& proposal : proposals.objects) {
    points.push_back(&proposal.merged.points);
    samples.sizes.push_back(static_cast<std::uint32_t>(proposal.merged.points.size()));
    const auto values = values_of(proposal.features);
    samples.features.emplace_back(values.begin(), values.end());
    for (const PointIndices& mask : masks)
      samples.overlaps.push_back(
          static_cast<float>(intersection_over_union(mask, proposal.merged.points)));
  }
  const SharedCounts shared(points);
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < points.size(); ++b)
      samples.shared.push_back(static_cast<std::uint32_t>(shared.shared(a, b)));
  }
  return samples;
}

void write_samples(const std::filesystem::path& file, const std::vector<SceneSamples>& scenes) {
  std::string bytes = heading();
  for (const SceneSamples& scene : scenes) {
    put(bytes, std::vector<std::uint32_t>{scene.number});
    put(bytes, scene.true_sizes);
    put(bytes, scene.sizes);
    for (const std::vector<float>& row : scene.features) put(bytes, row);
    put(bytes, scene.overlaps);
    put(bytes, scene.shared);
  }
  write_file_atomically(file, bytes);
}

std::vector<SceneSamples> read_samples(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  const std::string expected = heading();
  if (!bytes.starts_with(expected))
    throw InputError(file.string(), "samples with the features of this build", "others");
  Reader reader(std::string_view(bytes).substr(expected.size()), file.string());
  std::vector<SceneSamples> scenes;
  while (!reader.at_end()) {
    SceneSamples& scene = scenes.emplace_back();
    scene.number = reader.take<std::uint32_t>().at(0);
    scene.true_sizes = reader.take<std::uint32_t>();
    scene.sizes = reader.take<std::uint32_t>();
    for (std::size_t k = 0; k < scene.sizes.size(); ++k)
      scene.features.push_back(reader.take<float>());
    scene.overlaps = reader.take<float>();
    scene.shared = reader.take<std::uint32_t>();
  }
  return scenes;
}

}  // namespace symscene::bench
