#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ros_cursor.hpp"

namespace symscene {

/// A topic of a recording.
struct RecordedTopic {
  std::string name;
  std::string type;  ///< as in ROS 1: "sensor_msgs/Image"
  RosFormat format = RosFormat::ros1;
};

/// A message, by its place in the recording.
struct RecordedMessage {
  double time = 0.0;        ///< of the recording [s]
  std::size_t part = 0;     ///< the file of a recording of several
  std::uint64_t place = 0;  ///< there
};

/// Messages that a robot recorded.
class Recording {
 public:
  virtual ~Recording() = default;
  /// Sorted by name, each once; those of types that are not read may be left out.
  virtual std::vector<RecordedTopic> topics() const = 0;
  /// The messages of a topic in the order of their times.
  virtual std::vector<RecordedMessage> messages(const std::string& topic) = 0;
  /// The bytes of a message. May be called from several threads.
  virtual std::string bytes(const RecordedMessage& message) const = 0;
};

using RecordingPointer = std::unique_ptr<Recording>;

/// Sorts topics by name; of those with one name the first stays.
std::vector<RecordedTopic> sorted_topics(std::vector<RecordedTopic> topics);

/// Sorts messages by time; equal times stay in their order.
void sort_by_time(std::vector<RecordedMessage>& messages);

/// The name of a type as in ROS 1: "sensor_msgs/msg/Image" becomes "sensor_msgs/Image".
std::string ros1_type(std::string type);

// All throw InputError if the file cannot be read or is not whole.
RecordingPointer open_bag_recording(const std::filesystem::path& path);
RecordingPointer open_mcap_recording(const std::filesystem::path& path);
RecordingPointer open_sqlite_recording(const std::filesystem::path& path);
/// A folder of rosbag2: all its files .db3 and .mcap, in the order of their numbers.
RecordingPointer open_rosbag2_folder(const std::filesystem::path& dir);

/// The same of the bytes of a file, which must outlive the recording.
RecordingPointer open_mcap_recording(std::string_view bytes, const std::string& name);
RecordingPointer open_sqlite_recording(std::string_view bytes, const std::string& name);

}  // namespace symscene
