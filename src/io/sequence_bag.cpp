// A ROS 1 bag: depth images, the camera_info beside them, and colour images registered to them.
#include "image_files.hpp"
#include "sequence_layouts.hpp"
#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_ROSBAG
#include <mutex>

#include <fmt/format.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "bag.hpp"
#include "camera_formats.hpp"
#include "image_lists.hpp"
#include "image_sequence.hpp"
#include "ros_messages.hpp"
#endif

namespace symscene {

namespace fs = std::filesystem;

bool is_bag(const fs::path& path) {
  return path.extension() == ".bag" && fs::is_regular_file(path);
}

#ifndef SYMSCENE_HAS_ROSBAG

SequencePointer open_bag(const fs::path& path, const SequenceOptions&) {
  throw InputError(path.string(),
                   "a build with a reader of ROS bags (install librosbag-storage-dev and build "
                   "again)",
                   "one without");
}

#else

namespace {

constexpr const char* bag_layout = "ROS bag";

/// Turns exceptions of librosbag into an InputError about the bag.
template <class Call>
auto reading(const std::string& name, const Call& call) {
  try {
    return call();
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(name, "a ROS 1 bag that can be read", error.what());
  }
}

std::string message_bytes(const rosbag::MessageInstance& message) {
  std::string bytes(message.size(), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  message.write(stream);
  return bytes;
}

using Messages = std::vector<rosbag::MessageInstance>;

/// A topic of images and its first message.
struct ImageTopic {
  std::string topic;
  RosImage first;  ///< without its data
  Messages messages;

  bool named(const char* part) const { return topic.find(part) != std::string::npos; }
};

/// A bag and its views, which must live as long as the messages in them.
class Bag {
 public:
  explicit Bag(const fs::path& path) : name_(path.string()) {
    require_sound_bag(path);
    reading(name_, [&] { bag_.open(name_, rosbag::bagmode::Read); });
  }

  const std::string& name() const { return name_; }

  std::vector<std::string> topics(const std::string& type) const {
    std::vector<std::string> names;
    for (const rosbag::ConnectionInfo* connection : rosbag::View(bag_).getConnections()) {
      if (connection->datatype == type) names.push_back(connection->topic);
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
  }

  Messages messages(const std::string& topic) {
    views_.push_back(std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(topic)));
    Messages found;
    found.reserve(views_.back()->size());
    for (const rosbag::MessageInstance& message : *views_.back()) found.push_back(message);
    return found;
  }

  /// The topics with at least one image.
  std::vector<ImageTopic> image_topics() {
    std::vector<ImageTopic> found;
    for (const std::string& topic : topics("sensor_msgs/Image")) {
      ImageTopic images{topic, {}, messages(topic)};
      if (images.messages.empty()) continue;
      images.first = parse_ros_image(message_bytes(images.messages.front()), name_);
      images.first.data = {};
      found.push_back(std::move(images));
    }
    return found;
  }

 private:
  std::string name_;
  rosbag::Bag bag_;
  std::vector<std::unique_ptr<rosbag::View>> views_;
};

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
    names +=
        fmt::format("{}{} ({})", names.empty() ? "" : ", ", images.topic, images.first.encoding);
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
    return color.size == depth.first.size && color.frame_id == depth.first.frame_id;
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
                    name, depth.topic));
  }
  return std::nullopt;
}

/// The camera on the topic camera_info beside the topic of the images.
std::optional<CameraIntrinsics> find_camera(Bag& bag, const ImageTopic& images,
                                            std::vector<std::string>& warnings) {
  const std::string topic = images.topic.substr(0, images.topic.rfind('/') + 1) + "camera_info";
  const std::vector<std::string> topics = bag.topics("sensor_msgs/CameraInfo");
  if (std::find(topics.begin(), topics.end(), topic) == topics.end()) return std::nullopt;
  const Messages messages = bag.messages(topic);
  if (messages.empty()) return std::nullopt;
  const std::string name = bag.name() + ": " + topic;
  const RosCameraInfo info = parse_ros_camera_info(message_bytes(messages.front()), name);
  const bool rectified = images.named("rect") && info.rectified.fx > 0.0;
  if (info.distorted && !rectified) {
    warnings.push_back(name + ": its lens distortion is not corrected");
  }
  const CameraIntrinsics& camera = rectified ? info.rectified : info.raw;
  require_camera(camera, name);
  return camera;
}

class BagSequence final : public DepthSequence {
 public:
  BagSequence(std::unique_ptr<Bag> bag, const SequenceOptions& options) : bag_(std::move(bag)) {
    const std::vector<ImageTopic> topics = bag_->image_topics();
    ImageTopic depth = choose_depth(topics, bag_->name(), warnings_);
    std::optional<CameraIntrinsics> camera;
    if (!options.intrinsics) camera = find_camera(*bag_, depth, warnings_);
    const Calibration used = resolve_calibration(
        bag_->name(), bag_layout, {camera, default_depth_scale(depth.first.encoding)}, options);
    camera_ = *used.intrinsics;
    depth_scale_ = *used.depth_scale;
    if (camera_.width == 0) {
      camera_.width = depth.first.size.width, camera_.height = depth.first.size.height;
    }
    encoding_ = depth.first.encoding;
    color_size_ = own_color_size(options).value_or(depth.first.size);
    if (auto color = choose_color(topics, depth, own_color_size(options), bag_->name(), warnings_))
      colors_ = std::move(color->messages);
    depths_ = std::move(depth.messages);
    pair_colors();
  }

  std::string layout() const override { return bag_layout; }
  const CameraIntrinsics& camera() const override { return camera_; }
  double depth_scale() const override { return depth_scale_; }
  std::size_t size() const override { return depths_.size(); }
  double time(std::size_t i) const override { return depths_.at(i).getTime().toSec(); }
  bool has_color() const override {
    return std::any_of(color_of_.begin(), color_of_.end(), [](int color) { return color >= 0; });
  }
  bool has_color(std::size_t i) const override { return color_of_.at(i) >= 0; }
  std::optional<Eigen::Isometry3d> pose(std::size_t) const override { return std::nullopt; }
  const std::vector<std::string>& warnings() const override { return warnings_; }

  DepthFrame read(std::size_t i) const override {
    DepthFrame frame;
    frame.time = time(i);
    const std::string name = fmt::format("{}: image {}", bag_->name(), i);
    const std::string bytes = bytes_of(depths_.at(i));
    const RosImage image = parse_ros_image(bytes, name);
    require_same(image, name);
    frame.depth = depth_of(image, depth_scale_, name);
    if (color_of_[i] < 0) return frame;
    const std::string color_bytes = bytes_of(colors_[static_cast<std::size_t>(color_of_[i])]);
    const RosImage color = parse_ros_image(color_bytes, name);
    if (is_color_encoding(color.encoding) && color.size == color_size_) {
      frame.colors = colors_of(color, name);
    }
    return frame;
  }

 private:
  /// librosbag is not thread-safe.
  std::string bytes_of(const rosbag::MessageInstance& message) const {
    const std::lock_guard lock(mutex_);
    return reading(bag_->name(), [&] { return message_bytes(message); });
  }

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
      const auto apart = [&](std::size_t k) {
        return std::abs(colors_[k].getTime().toSec() - time(i));
      };
      while (next + 1 < colors_.size() && apart(next + 1) <= apart(next)) ++next;
      if (apart(next) <= association_tolerance) color_of_[i] = static_cast<int>(next);
    }
  }

  std::unique_ptr<Bag> bag_;
  CameraIntrinsics camera_;
  double depth_scale_ = 1.0;
  std::string encoding_;
  ImageSize color_size_;
  Messages depths_;
  Messages colors_;
  std::vector<int> color_of_;  ///< −1 where there is none
  std::vector<std::string> warnings_;
  mutable std::mutex mutex_;
};

}  // namespace

SequencePointer open_bag(const fs::path& path, const SequenceOptions& options) {
  return reading(path.string(), [&]() -> SequencePointer {
    return std::make_unique<BagSequence>(std::make_unique<Bag>(path), options);
  });
}

#endif

}  // namespace symscene
