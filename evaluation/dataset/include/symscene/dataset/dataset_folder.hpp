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

/// The file that every dataset folder made by SymScene holds (docs/formats.md).
inline constexpr const char* dataset_file = "dataset.json";

/// The folder of scene `index` of a dataset.
std::filesystem::path scene_folder(const std::filesystem::path& dataset, std::size_t index);

/// A scene of a dataset on disk: a scene folder with ground truth, or a depth image with labels.
struct DatasetEntry {
  std::string name;                        ///< unique in the dataset
  std::string subset;                      ///< kind of scene; empty if not known
  std::filesystem::path folder;            ///< empty for an image
  std::filesystem::path depth;             ///< empty for a folder
  std::filesystem::path labels;            ///< empty for a folder
  std::optional<CameraIntrinsics> camera;  ///< of the image
};

/// The contents of a dataset.
struct DatasetListing {
  std::string layout;                 ///< "dataset", "scenes" or "single views"
  std::optional<Split> split;         ///< of layout "dataset"
  std::optional<std::uint64_t> seed;  ///< of layout "dataset"
  std::vector<DatasetEntry> entries;  ///< by name, numbers in names by value
  std::vector<std::string> missing;   ///< names of scenes that are not made yet
  std::vector<std::string> warnings;  ///< assumptions about the files, one sentence each
};

/// A scene with its ground truth.
struct LoadedEntry {
  Scene scene;
  SceneTruth truth;  ///< every object, also those without a point in the scene's cloud
  std::string subset;
  std::vector<std::string> lost = {};  ///< per object of an image why it has no point, or empty
  std::optional<LabeledFrame> labeled = {};  ///< of an image
};

/// Whether a path has one of the layouts that read_dataset() reads.
bool is_dataset(const std::filesystem::path& path);

/// Lists a dataset: a folder with dataset.json; any folder of scene folders, at most two levels
/// down; or one of NAME.depth.png and NAME.label.png, with intrinsics.txt or the camera of the
/// Object Segmentation Database. Throws InputError if the folder is none of these, a scene has no
/// ground truth, or there is a depth image without labels or labels without a depth image.
DatasetListing read_dataset(const std::filesystem::path& path);

/// Reads a scene and its ground truth. Throws InputError if a file cannot be read, a mask names a
/// point that the cloud does not have, two masks share a point, or images differ
/// in size.
LoadedEntry load_entry(const DatasetEntry& entry, const SingleViewOptions& options = {});

/// Reads a depth image in millimetres with its labels. Throws InputError as load_entry() does.
LabeledFrame read_labeled_frame(const DatasetEntry& entry);

}  // namespace symscene
