#include "symscene/dataset/dataset_folder.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "io/json_cursor.hpp"
#include "single_view_scene.hpp"
#include "symscene/core/error.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/image.hpp"
#include "symscene/io/intrinsics.hpp"
#include "symscene/io/scene.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* truth_file = "truth.json";
constexpr const char* depth_ending = ".depth.png";
constexpr const char* label_ending = ".label.png";
constexpr const char* any_dataset =
    "a dataset: a folder with dataset.json, of scene folders, or of NAME.depth.png and "
    "NAME.label.png";

/// A name with its numbers padded to full width, so that 2 comes before 10.
std::string sort_key(const std::string& name) {
  std::string key, digits;
  const auto flush = [&] {
    if (!digits.empty()) key += fmt::format("{:0>20}", digits);
    digits.clear();
  };
  for (const char c : name) {
    if (c >= '0' && c <= '9') {
      digits += c;
    } else {
      flush();
      key += c;
    }
  }
  flush();
  return key;
}

/// As the temporary folders of outputs that are being written.
bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

std::vector<fs::path> sorted_children(const fs::path& dir) {
  std::vector<fs::path> children;
  for (const fs::directory_entry& entry : fs::directory_iterator(dir)) {
    if (!is_hidden(entry.path())) children.push_back(entry.path());
  }
  std::sort(children.begin(), children.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(sort_key(a.filename()), a) < std::pair(sort_key(b.filename()), b);
  });
  return children;
}

/// How the objects of a simulated scene were placed; empty if not known.
std::string placement(const fs::path& dir) {
  const fs::path file = dir / "scene.json";
  if (!fs::exists(file)) return "";
  const Json document = parse_json(read_file(file), file.string());
  const std::string name = file.string();
  const auto own = JsonCursor(document, name).find("placement");
  return own ? own->string() : "";
}

DatasetEntry scene_entry(const fs::path& dir, const std::string& name) {
  if (!fs::exists(dir / truth_file))
    throw InputError((dir / truth_file).string(), "the ground truth of the scene", "no such file");
  return {name, placement(dir), dir, {}, {}, {}};
}

/// Lists the scene folders below `dir`.
void find_scenes(const fs::path& root, const fs::path& dir, int levels,
                 std::vector<DatasetEntry>& entries) {
  for (const fs::path& child : sorted_children(dir)) {
    // Folders with objects.json are results, not scenes.
    if (!fs::is_directory(child) || fs::exists(child / "objects.json")) continue;
    if (is_scene_folder(child)) {
      entries.push_back(scene_entry(child, child.lexically_relative(root).string()));
    } else if (fs::exists(child / truth_file)) {
      throw InputError((child / "cloud.ply").string(), "the cloud of a scene with ground truth",
                       "no such file");
    } else if (levels > 1) {
      find_scenes(root, child, levels - 1, entries);
    }
  }
}

DatasetListing list_made_dataset(const fs::path& path) {
  const std::string name = (path / dataset_file).string();
  const Json document = parse_json(read_file(path / dataset_file), name);
  const JsonCursor root(document, name);
  DatasetListing listing;
  listing.layout = "dataset";
  listing.split = parse_split(root.at("split").string(), name);
  listing.seed = root.at("options").at("seed").count();
  const std::size_t scenes = root.at("options").at("scenes").count();
  for (std::size_t i = 0; i < scenes; ++i) {
    const fs::path folder = scene_folder(path, i);
    if (fs::exists(folder)) {
      listing.entries.push_back(scene_entry(folder, folder.filename()));
    } else {
      listing.missing.push_back(folder.filename());
    }
  }
  return listing;
}

/// The names of the files with an ending, without it.
std::vector<std::string> names_with(const fs::path& dir, std::string_view ending) {
  std::vector<std::string> names;
  for (const fs::path& child : sorted_children(dir)) {
    const std::string file = child.filename();
    if (file.ends_with(ending)) names.push_back(file.substr(0, file.size() - ending.size()));
  }
  return names;
}

/// The subset of an image of the Object Segmentation Database, by its number.
std::string osd_subset(const std::string& name) {
  constexpr std::string_view prefix = "learn";
  const std::string number = name.starts_with(prefix) ? name.substr(prefix.size()) : "";
  if (number.empty() || number.size() > 4 ||
      number.find_first_not_of("0123456789") != std::string::npos) {
    return "";
  }
  const int i = std::stoi(number);
  if (i <= 16) return "boxes";
  if (i <= 24) return "stacked boxes";
  if (i <= 32) return "occluded";
  return i <= 44 ? "cylindric" : "";
}

CameraIntrinsics single_view_camera(const fs::path& dir, std::vector<std::string>& warnings) {
  if (fs::exists(dir / "intrinsics.txt")) return read_intrinsics(dir / "intrinsics.txt");
  const CameraIntrinsics camera{640, 480, 525.0, 525.0, 319.5, 239.5};
  warnings.push_back(
      fmt::format("{}: no intrinsics.txt, so the camera is that of the Object Segmentation "
                  "Database: {:g} {:g} {:g} {:g}",
                  dir.string(), camera.fx, camera.fy, camera.cx, camera.cy));
  return camera;
}

DatasetListing list_single_views(const fs::path& path) {
  DatasetListing listing;
  listing.layout = "single views";
  const std::vector<std::string> depths = names_with(path, depth_ending);
  const std::vector<std::string> labels = names_with(path, label_ending);
  const auto require_in = [&](const std::vector<std::string>& names, const std::string& name,
                              const char* ending) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    throw InputError(
        (path / (name + ending)).string(),
        fmt::format("a label image for each depth image of {}", path.string()),
        fmt::format("no such file ({} depth, {} label images)", depths.size(), labels.size()));
  };
  for (const std::string& name : labels) require_in(depths, name, depth_ending);
  const CameraIntrinsics camera = single_view_camera(path, listing.warnings);
  for (const std::string& name : depths) {
    require_in(labels, name, label_ending);
    listing.entries.push_back({name,
                               osd_subset(name),
                               {},
                               path / (name + depth_ending),
                               path / (name + label_ending),
                               camera});
  }
  return listing;
}

/// Label images distinguish single views from a sequence of 7-Scenes, whose depth images have the
/// same ending.
bool has_single_views(const fs::path& path) { return !names_with(path, label_ending).empty(); }

/// Throws InputError unless there is an object and no two masks share a point.
void require_masks(const SceneTruth& truth, const std::string& name) {
  if (truth.objects.empty()) throw InputError(name, "at least one object", "none");
  std::map<Index, std::string> owners;
  for (std::size_t k = 0; k < truth.objects.size(); ++k) {
    const std::string own = fmt::format("object {} (\"{}\")", k, truth.objects[k].name);
    for (const Index point : truth.objects[k].points) {
      const auto [owner, is_new] = owners.emplace(point, own);
      if (!is_new)
        throw InputError(name, "masks that share no point",
                         fmt::format("point {} in {} and in {}", point, owner->second, own));
    }
  }
}

std::vector<std::uint16_t> read_labels(const fs::path& path, const ImageSize& expected) {
  const auto require = [&](const ImageSize& size) {
    if (size == expected) return;
    throw InputError(
        path.string(),
        fmt::format("labels of the depth image's {}×{} pixels", expected.width, expected.height),
        fmt::format("{}×{}", size.width, size.height));
  };
  if (is_depth_png(path)) {
    DepthImage image = read_depth_png(path);
    require(image.size);
    return std::move(image.values);
  }
  const ColorImage image = read_color_image(path);
  require(image.size);
  std::vector<std::uint16_t> labels;
  for (Eigen::Index i = 0; i < image.pixels.rows(); ++i) {
    const auto pixel = image.pixels.row(i);
    if (pixel[0] != pixel[1] || pixel[0] != pixel[2])
      throw InputError(path.string(), "grey pixels, the numbers of objects", "colours");
    labels.push_back(pixel[0]);
  }
  return labels;
}

LoadedEntry load_single_view(const DatasetEntry& entry, const SingleViewOptions& options) {
  LabeledFrame labeled = read_labeled_frame(entry);
  SingleViewScene made = single_view_scene(labeled, options);
  return {std::move(made.scene), std::move(made.truth), entry.subset, std::move(made.lost),
          std::move(labeled)};
}

}  // namespace

fs::path scene_folder(const fs::path& dataset, std::size_t index) {
  return dataset / "scenes" / fmt::format("{:04}", index);
}

bool is_dataset(const fs::path& path) {
  if (!fs::is_directory(path) || is_scene_folder(path)) return false;
  if (fs::exists(path / dataset_file) || has_single_views(path)) return true;
  return std::any_of(
      fs::directory_iterator(path), fs::directory_iterator(), [](const fs::directory_entry& child) {
        return child.is_directory() && !is_hidden(child.path()) &&
               (is_scene_folder(child.path()) || is_scene_folder(child.path() / "scene"));
      });
}

DatasetListing read_dataset(const fs::path& path) {
  if (!fs::is_directory(path))
    throw InputError(path.string(), any_dataset,
                     fs::exists(path) ? "a file" : "nothing of that name");
  if (fs::exists(path / dataset_file)) return list_made_dataset(path);
  if (has_single_views(path)) return list_single_views(path);
  DatasetListing listing;
  listing.layout = "scenes";
  constexpr int levels = 2;
  find_scenes(path, path, levels, listing.entries);
  if (listing.entries.empty()) {
    const bool has_depth = !names_with(path, depth_ending).empty();
    throw InputError(path.string(), any_dataset,
                     has_depth ? "depth images without labels" : "a folder without scenes");
  }
  return listing;
}

LabeledFrame read_labeled_frame(const DatasetEntry& entry) {
  LabeledFrame labeled;
  if (!entry.camera) throw InputError(entry.name, "a depth image with its camera", "none");
  labeled.camera = *entry.camera;
  const DepthImage depth = read_depth_png(entry.depth);
  if (depth.size != ImageSize{labeled.camera.width, labeled.camera.height})
    throw InputError(
        entry.depth.string(),
        fmt::format("the camera's {}×{} pixels", labeled.camera.width, labeled.camera.height),
        fmt::format("{}×{}", depth.size.width, depth.size.height));
  constexpr float millimetre = 1e-3F;
  for (const std::uint16_t value : depth.values)
    labeled.frame.depth.push_back(millimetre * static_cast<float>(value));
  labeled.labels = read_labels(entry.labels, depth.size);
  return labeled;
}

LoadedEntry load_entry(const DatasetEntry& entry, const SingleViewOptions& options) {
  if (entry.folder.empty()) return load_single_view(entry, options);
  LoadedEntry loaded;
  loaded.scene = read_scene(entry.folder);
  loaded.truth = read_truth(entry.folder / truth_file, loaded.scene.cloud.size());
  require_masks(loaded.truth, (entry.folder / truth_file).string());
  loaded.subset = entry.subset;
  return loaded;
}

}  // namespace symscene
