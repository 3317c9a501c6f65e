// Recordings of ROS: depth images, the camera_info beside them, colour images registered to them,
// and poses of tf.
#include <algorithm>

#include <fmt/format.h>

#include "camera_formats.hpp"
#include "image_files.hpp"
#include "image_lists.hpp"
#include "image_sequence.hpp"
#include "recording.hpp"
#include "ros_messages.hpp"
#include "ros_transforms.hpp"
#include "sequence_layouts.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* image_type = "sensor_msgs/Image";
constexpr const char* compressed_type = "sensor_msgs/CompressedImage";

using Messages = std::vector<RecordedMessage>;

/// A recording with the name of its file.
struct Source {
  std::string name;
  std::string layout;
  RecordingPointer recording;

  std::vector<RecordedTopic> topics(std::initializer_list<const char*> types) const {
    std::vector<RecordedTopic> found = recording->topics();
    std::erase_if(found, [&](const RecordedTopic& topic) {
      return std::find(types.begin(), types.end(), topic.type) == types.end();
    });
    return found;
  }
};

RosImage parse_image(const RecordedTopic& topic, std::string_view bytes, const std::string& name) {
  return topic.type == image_type ? parse_ros_image(bytes, topic.format, name)
                                  : parse_ros_compressed_image(bytes, topic.format, name);
}

/// A topic of images and its first message.
struct ImageTopic {
  RecordedTopic topic;
  RosImage first;  ///< without its data
  Messages messages;

  bool named(const char* part) const { return topic.name.find(part) != std::string::npos; }
};

/// The topics with at least one image.
std::vector<ImageTopic> image_topics(const Source& source) {
  std::vector<ImageTopic> found;
  for (const RecordedTopic& topic : source.topics({image_type, compressed_type})) {
    Messages messages = source.recording->messages(topic.name);
    if (messages.empty()) continue;
    const std::string bytes = source.recording->bytes(messages.front());
    RosImage first = parse_image(topic, bytes, source.name);
    first.data = {};
    found.push_back({topic, std::move(first), std::move(messages)});
  }
  return found;
}

bool is_depth(const ImageTopic& images) {
  const std::string& encoding = images.first.encoding;
  return is_depth_encoding(encoding) && (encoding != "mono16" || images.named("depth"));
}

/// Whether `a` is preferred: named depth, then registered to colour, then more images.
bool better_depth(const ImageTopic& a, const ImageTopic& b) {
  const auto rank = [](const ImageTopic& images) {
    return std::tuple(images.named("depth"), images.named("registered") || images.named("aligned"),
                      images.messages.size());
  };
  return rank(a) > rank(b);
}

std::string names_of(const std::vector<ImageTopic>& topics) {
  std::string names;
  for (const ImageTopic& images : topics) {
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", images.topic.name,
                         images.first.encoding);
  }
  return names.empty() ? "none of type sensor_msgs/Image" : names;
}

ImageTopic choose_depth(const std::vector<ImageTopic>& topics, const std::string& name,
                        std::vector<std::string>& warnings) {
  std::vector<ImageTopic> candidates;
  std::copy_if(topics.begin(), topics.end(), std::back_inserter(candidates), is_depth);
  if (candidates.empty()) {
    throw InputError(name, "a topic of depth images, 16UC1 or 32FC1", names_of(topics));
  }
  std::stable_sort(candidates.begin(), candidates.end(), better_depth);
  if (candidates.size() > 1) {
    warnings.push_back(fmt::format("{}: several topics of depth images, {}: the first is read",
                                   name, names_of(candidates)));
  }
  return std::move(candidates.front());
}

/// A topic of colour images of the same camera and size, or of the size of a colour camera of its
/// own, if there is one.
std::optional<ImageTopic> choose_color(const std::vector<ImageTopic>& topics,
                                       const ImageTopic& depth, std::optional<ImageSize> own_size,
                                       const std::string& name,
                                       std::vector<std::string>& warnings) {
  const auto belongs = [&](const RosImage& color) {
    if (own_size) return color.size == *own_size;
    return color.size == depth.first.size && color.header.frame_id == depth.first.header.frame_id;
  };
  const ImageTopic* chosen = nullptr;
  bool unregistered = false;
  for (const ImageTopic& images : topics) {
    if (!is_color_encoding(images.first.encoding)) continue;
    if (!belongs(images.first)) {
      unregistered = true;
    } else if (chosen == nullptr || images.messages.size() > chosen->messages.size()) {
      chosen = &images;
    }
  }
  if (chosen != nullptr) return *chosen;
  if (unregistered) {
    warnings.push_back(
        fmt::format("{}: the colour images are of another size or frame than "
                    "those of {}, not registered to them: read without colour",
                    name, depth.topic.name));
  }
  return std::nullopt;
}

/// The topic of the camera_info beside images: image_transport names /image/compressedDepth the
/// compressed form of /image.
std::string camera_topic(const ImageTopic& images) {
  std::string name = images.topic.name;
  if (images.first.compressed) name.erase(std::min(name.rfind('/'), name.size()));
  return name.substr(0, name.rfind('/') + 1) + "camera_info";
}

std::optional<CameraIntrinsics> find_camera(const Source& source, const ImageTopic& images,
                                            std::vector<std::string>& warnings) {
  const std::vector<RecordedTopic> topics = source.topics({"sensor_msgs/CameraInfo"});
  const auto topic = std::find_if(topics.begin(), topics.end(), [&](const RecordedTopic& each) {
    return each.name == camera_topic(images);
  });
  if (topic == topics.end()) return std::nullopt;
  const Messages messages = source.recording->messages(topic->name);
  if (messages.empty()) return std::nullopt;
  const std::string name = source.name + ": " + topic->name;
  const RosCameraInfo info =
      parse_ros_camera_info(source.recording->bytes(messages.front()), topic->format, name);
  const bool rectified = images.named("rect") && info.rectified.fx > 0.0;
  if (info.distorted && !rectified) {
    warnings.push_back(name + ": its lens distortion is not corrected");
  }
  const CameraIntrinsics& camera = rectified ? info.rectified : info.raw;
  require_camera(camera, name);
  return camera;
}

TransformTree read_transforms(const Source& source) {
  TransformTree tree;
  for (const RecordedTopic& topic : source.topics({"tf2_msgs/TFMessage", "tf/tfMessage"})) {
    const std::string name = source.name + ": " + topic.name;
    const bool is_static = topic.name.ends_with("tf_static");
    for (const RecordedMessage& message : source.recording->messages(topic.name)) {
      for (const RosTransform& transform :
           parse_ros_transforms(source.recording->bytes(message), topic.format, name)) {
        tree.add(transform, is_static);
      }
    }
  }
  tree.finish();
  return tree;
}

class RecordedSequence final : public DepthSequence {
 public:
  RecordedSequence(Source source, const SequenceOptions& options) : source_(std::move(source)) {
    const std::string& name = source_.name;
    const std::vector<ImageTopic> topics = image_topics(source_);
    ImageTopic depth = choose_depth(topics, name, warnings_);
    std::optional<CameraIntrinsics> camera;
    if (!options.intrinsics) camera = find_camera(source_, depth, warnings_);
    const Calibration used = resolve_calibration(
        name, source_.layout, {camera, default_depth_scale(depth.first.encoding)}, options);
    camera_ = *used.intrinsics;
    depth_scale_ = *used.depth_scale;
    if (camera_.width == 0) {
      camera_.width = depth.first.size.width, camera_.height = depth.first.size.height;
    }
    encoding_ = depth.first.encoding;
    color_size_ = own_color_size(options).value_or(depth.first.size);
    if (auto color = choose_color(topics, depth, own_color_size(options), name, warnings_)) {
      color_topic_ = color->topic, colors_ = std::move(color->messages);
    }
    depth_topic_ = depth.topic, depths_ = std::move(depth.messages);
    pair_colors();
    transforms_ = read_transforms(source_);
    moves_ = transforms_.moves(depth.first.header.frame_id);
  }

  std::string layout() const override { return source_.layout; }
  const CameraIntrinsics& camera() const override { return camera_; }
  double depth_scale() const override { return depth_scale_; }
  std::size_t size() const override { return depths_.size(); }
  double time(std::size_t i) const override { return depths_.at(i).time; }
  bool has_color() const override {
    return std::any_of(color_of_.begin(), color_of_.end(), [](int color) { return color >= 0; });
  }
  bool has_color(std::size_t i) const override { return color_of_.at(i) >= 0; }
  /// That of tf at the time of the measurement, which the image tells.
  std::optional<Eigen::Isometry3d> pose(std::size_t i) const override {
    if (!moves_) return std::nullopt;
    const std::string bytes = source_.recording->bytes(depths_.at(i));
    const RosHeader header = parse_image(depth_topic_, bytes, name_of(i)).header;
    return transforms_.pose(header.frame_id, header.time > 0.0 ? header.time : time(i));
  }
  const std::vector<std::string>& warnings() const override { return warnings_; }

  DepthFrame read(std::size_t i) const override {
    DepthFrame frame;
    frame.time = time(i);
    const std::string name = name_of(i);
    const std::string bytes = source_.recording->bytes(depths_.at(i));
    const RosImage image = parse_image(depth_topic_, bytes, name);
    require_same(image, name);
    frame.depth = depth_of(image, depth_scale_, name);
    if (color_of_[i] < 0) return frame;
    const std::string color_bytes =
        source_.recording->bytes(colors_[static_cast<std::size_t>(color_of_[i])]);
    const RosImage color = parse_image(color_topic_, color_bytes, name);
    if (is_color_encoding(color.encoding) && color.size == color_size_) {
      frame.colors = colors_of(color, name);
    }
    return frame;
  }

 private:
  std::string name_of(std::size_t i) const { return fmt::format("{}: image {}", source_.name, i); }

  void require_same(const RosImage& image, const std::string& name) const {
    if (image.size == ImageSize{camera_.width, camera_.height} && image.encoding == encoding_) {
      return;
    }
    throw InputError(name,
                     fmt::format("an image of {}×{}, {}", camera_.width, camera_.height, encoding_),
                     fmt::format("{}×{}, {}", image.size.width, image.size.height, image.encoding));
  }

  /// For every depth image the colour image nearest in time.
  void pair_colors() {
    color_of_.assign(depths_.size(), -1);
    std::size_t next = 0;
    for (std::size_t i = 0; i < depths_.size() && !colors_.empty(); ++i) {
      const auto apart = [&](std::size_t k) { return std::abs(colors_[k].time - time(i)); };
      while (next + 1 < colors_.size() && apart(next + 1) <= apart(next)) ++next;
      if (apart(next) <= association_tolerance) color_of_[i] = static_cast<int>(next);
    }
  }

  Source source_;
  RecordedTopic depth_topic_;
  RecordedTopic color_topic_;
  CameraIntrinsics camera_;
  double depth_scale_ = 1.0;
  std::string encoding_;
  ImageSize color_size_;
  Messages depths_;
  Messages colors_;
  std::vector<int> color_of_;  ///< −1 where there is none
  std::vector<std::string> warnings_;
  TransformTree transforms_;
  bool moves_ = false;  ///< whether tf tells how the camera moves
};

bool is_file_ending(const fs::path& path, const char* ending) {
  return path.extension() == ending && fs::is_regular_file(path);
}

SequencePointer open_recording(const fs::path& path, const char* layout, RecordingPointer recording,
                               const SequenceOptions& options) {
  return std::make_unique<RecordedSequence>(Source{path.string(), layout, std::move(recording)},
                                            options);
}

}  // namespace

bool is_bag(const fs::path& path) { return is_file_ending(path, ".bag"); }
bool is_mcap(const fs::path& path) { return is_file_ending(path, ".mcap"); }
bool is_rosbag2(const fs::path& path) {
  if (is_file_ending(path, ".db3")) return true;
  return fs::exists(path / "metadata.yaml") &&
         !files_ending(path, {".db3", ".mcap", ".db3.zstd", ".mcap.zstd"}).empty();
}

SequencePointer open_bag(const fs::path& path, const SequenceOptions& options) {
  return open_recording(path, "ROS bag", open_bag_recording(path), options);
}

SequencePointer open_mcap(const fs::path& path, const SequenceOptions& options) {
  return open_recording(path, "MCAP", open_mcap_recording(path), options);
}

SequencePointer open_rosbag2(const fs::path& path, const SequenceOptions& options) {
  return open_recording(
      path, "rosbag2",
      fs::is_directory(path) ? open_rosbag2_folder(path) : open_sqlite_recording(path), options);
}

}  // namespace symscene
