#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "symscene/core/camera.hpp"
#include "symscene/dataset/single_view.hpp"
#include "symscene/dataset/split.hpp"

namespace symscene {

/// What every dataset folder that SymScene makes holds (docs/formats.md).
inline constexpr const char* dataset_file = "dataset.json";

/// Where scene `index` of a dataset lies.
std::filesystem::path scene_folder(const std::filesystem::path& dataset, std::size_t index);

/// A scene of a dataset on disk: a scene folder with its truth, or a depth image with its labels.
struct DatasetEntry {
  std::string name;                        ///< unlike all others of the dataset
  std::string subset;                      ///< what kind of scene; empty where not known
  std::filesystem::path folder;            ///< empty for an image
  std::filesystem::path depth;             ///< empty for a folder
  std::filesystem::path labels;            ///< empty for a folder
  std::optional<CameraIntrinsics> camera;  ///< of the image
};

/// What a dataset consists of.
struct DatasetListing {
  std::string layout;                 ///< "dataset", "scenes" or "single views"
  std::optional<Split> split;         ///< of a layout "dataset"
  std::optional<std::uint64_t> seed;  ///< the same
  std::vector<DatasetEntry> entries;  ///< by name, numbers in names by value
  std::vector<std::string> missing;   ///< names of scenes that are not made yet
};

/// A scene with what is true of it.
struct LoadedEntry {
  Scene scene;
  SceneTruth truth;  ///< without a table found in an image: empty
  std::string subset;
  std::size_t objects = 0;  ///< that there are, whether or not enough of them is seen
};

/// Whether a path looks like a dataset.
bool is_dataset(const std::filesystem::path& path);

/// Lists a dataset: a folder with dataset.json; any folder of scene folders, at most two levels
/// down; or one of NAME.depth.png and NAME.label.png, with intrinsics.txt or the camera of the
/// Object Segmentation Database. Throws InputError if the folder is none of these, a scene has no
/// truth, or an image lacks its labels or labels their image.
DatasetListing read_dataset(const std::filesystem::path& path);

/// Reads a scene and its truth. Throws InputError if a file cannot be read, truth names points that
/// the cloud does not have, is without masks or puts a point into two objects, or images differ in
/// size.
LoadedEntry load_entry(const DatasetEntry& entry, const SingleViewOptions& options = {});

/// A depth image in millimetres with its labels. Throws InputError as load_entry() does.
LabeledFrame read_labeled_frame(const DatasetEntry& entry);

}  // namespace symscene
