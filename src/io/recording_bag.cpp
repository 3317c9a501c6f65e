// The messages of a ROS 1 bag, by librosbag.
#include "recording.hpp"
#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_ROSBAG
#include <mutex>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "bag.hpp"
#endif

namespace symscene {

namespace fs = std::filesystem;

#ifndef SYMSCENE_HAS_ROSBAG

RecordingPointer open_bag_recording(const fs::path& path) {
  throw InputError(path.string(),
                   "a build with a reader of ROS bags (install librosbag-storage-dev and build "
                   "again)",
                   "one without");
}

#else

namespace {

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

class BagRecording final : public Recording {
 public:
  explicit BagRecording(const fs::path& path) : name_(path.string()) {
    require_sound_bag(path);
    reading(name_, [&] { bag_.open(name_, rosbag::bagmode::Read); });
  }

  std::vector<RecordedTopic> topics() const override {
    return reading(name_, [&] {
      std::vector<RecordedTopic> topics;
      for (const rosbag::ConnectionInfo* connection : rosbag::View(bag_).getConnections())
        topics.push_back({connection->topic, connection->datatype, RosFormat::ros1});
      return sorted_topics(std::move(topics));
    });
  }

  std::vector<RecordedMessage> messages(const std::string& topic) override {
    return reading(name_, [&] {
      views_.push_back(std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(topic)));
      std::vector<RecordedMessage> found;
      for (const rosbag::MessageInstance& message : *views_.back()) {
        found.push_back({message.getTime().toSec(), 0, messages_.size()});
        messages_.push_back(message);
      }
      return found;
    });
  }

  /// librosbag is not thread-safe.
  std::string bytes(const RecordedMessage& message) const override {
    const std::lock_guard lock(mutex_);
    return reading(name_, [&] {
      const rosbag::MessageInstance& instance = messages_.at(message.place);
      std::string bytes(instance.size(), '\0');
      ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                         static_cast<std::uint32_t>(bytes.size()));
      instance.write(stream);
      return bytes;
    });
  }

 private:
  std::string name_;
  rosbag::Bag bag_;
  std::vector<std::unique_ptr<rosbag::View>> views_;  ///< must live as long as their messages
  std::vector<rosbag::MessageInstance> messages_;
  mutable std::mutex mutex_;
};

}  // namespace

RecordingPointer open_bag_recording(const fs::path& path) {
  return std::make_unique<BagRecording>(path);
}

#endif

}  // namespace symscene
