#include <algorithm>
#include <memory>

#include "commands.hpp"
#include "facts.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/io/scene.hpp"

#ifdef SYMSCENE_HAS_EVALUATION
#include "symscene/dataset/dataset_folder.hpp"
#endif

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

/// Frames that are read of a sequence without --all.
constexpr std::size_t sampled_frames = 20;

constexpr const char* readable =
    "a sequence, a scene, a result or a dataset folder, or a file with a cloud, a mesh or an "
    "occupancy tree";

#ifdef SYMSCENE_HAS_EVALUATION
bool has_label_images(const fs::path& folder) {
  return std::any_of(
      fs::directory_iterator(folder), fs::directory_iterator(),
      [](const auto& entry) { return entry.path().string().ends_with(".label.png"); });
}

/// Scenes beside the images of a sequence do not make it a dataset. Images of single views are
/// named like those of 7-Scenes, but have labels.
bool is_described_as_dataset(const fs::path& path) {
  if (!is_dataset(path)) return false;
  return fs::exists(path / dataset_file) || has_label_images(path) || !is_sequence(path);
}
#endif

struct Info {
  SharedOptions shared;
  SequenceOptions options;
  fs::path path;
  bool all = false;
  std::optional<int> every;

  /// The frames to read of so many.
  std::vector<std::size_t> samples(std::size_t size) const {
    std::vector<std::size_t> chosen;
    if (!every && !all) {
      for (const Index i : evenly_spread(Index(size), Index(std::min(size, sampled_frames))))
        chosen.push_back(i);
      return chosen;
    }
    for (std::size_t i = 0; i < size; i += static_cast<std::size_t>(every.value_or(1)))
      chosen.push_back(i);
    return chosen;
  }

  Facts facts() const {
    if (fs::exists(path / "objects.json")) return result_facts(path);
    if (is_scene_folder(path)) return scene_facts(path);
    if (is_model_file(path)) return model_facts(path);
#ifdef SYMSCENE_HAS_EVALUATION
    if (is_described_as_dataset(path)) return dataset_facts(path);
#endif
    if (is_sequence(path)) {
      const auto sequence = open_sequence(path, options);
      return sequence_facts(*sequence, samples(sequence->size()));
    }
    const char* found = fs::is_directory(path) ? "another folder" : "another file";
    throw InputError(path.string(), readable, fs::exists(path) ? found : "no such file or folder");
  }

  void run() const {
    Session session("info", shared);
    StageTimer timer(session.on_begin());
    const Facts found = timer.time("read", [&] { return facts(); });
    session.warn(found.warnings());
    session.print_line(found.table());
    std::vector<ReportMember> members{{"path", path}};
    members.insert(members.end(), found.members().begin(), found.members().end());
    session.finish(members, timer.stages());
  }
};

}  // namespace

void add_info(CommandLine& line) {
  const auto state = std::make_shared<Info>();
  Arguments arguments(line, "info", "Describe a sequence, scene, result, dataset or model",
                      "symscene info sequence --intrinsics 525,525,319.5,239.5");
  arguments.input(state->path, "PATH", "folder or file");
  arguments.sequence_options(state->options);
  arguments.flag("--all", state->all, "read all frames of a sequence, not 20 spread over it");
  arguments.every(state->every, "read every N-th frame of a sequence, not 20 spread over it");
  arguments.reporting(state->shared);
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
