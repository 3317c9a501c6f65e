#include "ground_truth.hpp"

#include <fmt/format.h>

#ifdef SYMSCENE_HAS_SIMULATION
#include "symscene/ground_truth/mask_transfer.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/simulation/truth_transfer.hpp"
#endif

namespace symscene::app {

namespace fs = std::filesystem;

#ifdef SYMSCENE_HAS_SIMULATION

std::string transferred_truth(const fs::path& input, const PosesAndTruth& known,
                              const PointCloud& cloud, Session& /*session*/) {
  if (!fs::exists(input / "truth.json")) return {};
  const SceneTruth truth = read_truth(input / "truth.json");
  return format_truth(transfer_truth(truth, read_truth_meshes(input, truth), cloud,
                                     align_poses(known.poses, known.truth)));
}

void add_ground_truth(Facts& facts, const fs::path& scene, Index cloud_size) {
  if (!fs::exists(scene / "truth.json")) return;
  const SceneTruth truth = read_truth(scene / "truth.json", cloud_size);
  std::string names;
  for (const TrueObject& object : truth.objects) {
    names += (names.empty() ? ": " : ", ") + object.name;
  }
  facts.add("ground truth", fmt::format("{} objects{}", truth.objects.size(), names),
            "true_objects", truth.objects.size());
}

std::vector<PageTruth> page_truth(const fs::path& scene, const PointCloud& cloud) {
  // That of a sequence has poses in place of masks, and no cloud.
  if (!is_scene_folder(scene) || !fs::exists(scene / "truth.json")) return {};
  const PointCloud labeled = read_scene(scene).cloud;
  const SceneTruth truth = read_truth(scene / "truth.json", labeled.size());
  std::vector<PointIndices> masks = transfer_masks(labeled, truth, cloud);
  std::vector<PageTruth> shown;
  for (std::size_t k = 0; k < masks.size(); ++k)
    shown.push_back({truth.objects[k].name, std::move(masks[k])});
  return shown;
}

#else

std::vector<PageTruth> page_truth(const fs::path& /*scene*/, const PointCloud& /*cloud*/) {
  return {};
}

std::string transferred_truth(const fs::path& input, const PosesAndTruth& /*known*/,
                              const PointCloud& /*cloud*/, Session& session) {
  if (fs::exists(input / "truth.json")) {
    session.warn((input / "truth.json").string() +
                 " is left out: this build cannot transfer ground truth (run ./run build)");
  }
  return {};
}

void add_ground_truth(Facts& facts, const fs::path& scene, Index /*cloud_size*/) {
  if (fs::exists(scene / "truth.json"))
    facts.add_row("ground truth", "truth.json, which this build does not read (run ./run build)");
}

#endif

}  // namespace symscene::app
