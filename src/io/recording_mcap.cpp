// The messages of ROS in an MCAP file.
#include <algorithm>
#include <mutex>

#include "io/atomic_file.hpp"
#include "mcap_reader.hpp"
#include "recording.hpp"

namespace symscene {
namespace {

bool is_ros_message(const McapChannel& channel) {
  return channel.message_encoding == "cdr" || channel.message_encoding == "ros1";
}

class McapRecording final : public Recording {
 public:
  McapRecording(std::unique_ptr<ByteSource> source, const std::string& name)
      : reader_(std::move(source), name) {}

  std::vector<RecordedTopic> topics() const override {
    std::vector<RecordedTopic> topics;
    for (const auto& [id, channel] : reader_.channels()) {
      if (!is_ros_message(channel)) continue;
      const RosFormat format =
          channel.message_encoding == "ros1" ? RosFormat::ros1 : RosFormat::cdr;
      topics.push_back({channel.topic, ros1_type(channel.schema), format});
    }
    return sorted_topics(std::move(topics));
  }

  /// Several channels may have one topic: those are read whose type and encoding are the first's.
  std::vector<RecordedMessage> messages(const std::string& topic) override {
    const auto& channels = reader_.channels();
    const auto first = std::find_if(channels.begin(), channels.end(), [&](const auto& entry) {
      return entry.second.topic == topic && is_ros_message(entry.second);
    });
    std::vector<RecordedMessage> found;
    for (std::size_t i = 0; first != channels.end() && i < reader_.messages().size(); ++i) {
      const McapMessage& message = reader_.messages()[i];
      if (channels.at(message.channel) != first->second) continue;
      found.push_back({1e-9 * static_cast<double>(message.log_time), 0, i});
    }
    sort_by_time(found);
    return found;
  }

  std::string bytes(const RecordedMessage& message) const override {
    const std::lock_guard lock(mutex_);
    return reader_.data(reader_.messages().at(message.place));
  }

 private:
  mutable McapReader reader_;  ///< remembers a chunk
  mutable std::mutex mutex_;
};

}  // namespace

RecordingPointer open_mcap_recording(const std::filesystem::path& path) {
  require_regular_file(path);
  return std::make_unique<McapRecording>(std::make_unique<BytesInFile>(path), path.string());
}

RecordingPointer open_mcap_recording(std::string_view bytes, const std::string& name) {
  return std::make_unique<McapRecording>(std::make_unique<BytesInMemory>(bytes), name);
}

}  // namespace symscene
