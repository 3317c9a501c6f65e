// A recording of ROS 2 in several files.
#include <algorithm>
#include <string_view>

#include "image_files.hpp"
#include "recording.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

/// Recordings one after another, as one.
class JoinedRecording final : public Recording {
 public:
  explicit JoinedRecording(std::vector<RecordingPointer> parts) : parts_(std::move(parts)) {}

  std::vector<RecordedTopic> topics() const override {
    std::vector<RecordedTopic> topics;
    for (const RecordingPointer& part : parts_) {
      for (RecordedTopic& topic : part->topics()) topics.push_back(std::move(topic));
    }
    return sorted_topics(std::move(topics));
  }

  std::vector<RecordedMessage> messages(const std::string& topic) override {
    std::vector<RecordedMessage> found;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      for (const RecordedMessage& message : parts_[part]->messages(topic)) {
        found.push_back({message.time, part, message.place});
      }
    }
    sort_by_time(found);
    return found;
  }

  std::string bytes(const RecordedMessage& message) const override {
    return parts_.at(message.part)->bytes(message);
  }

 private:
  std::vector<RecordingPointer> parts_;
};

}  // namespace

std::vector<RecordedTopic> sorted_topics(std::vector<RecordedTopic> topics) {
  std::stable_sort(topics.begin(), topics.end(),
                   [](const RecordedTopic& a, const RecordedTopic& b) { return a.name < b.name; });
  topics.erase(
      std::unique(topics.begin(), topics.end(),
                  [](const RecordedTopic& a, const RecordedTopic& b) { return a.name == b.name; }),
      topics.end());
  return topics;
}

void sort_by_time(std::vector<RecordedMessage>& messages) {
  std::stable_sort(
      messages.begin(), messages.end(),
      [](const RecordedMessage& a, const RecordedMessage& b) { return a.time < b.time; });
}

std::string ros1_type(std::string type) {
  constexpr std::string_view infix = "/msg/";
  const std::size_t at = type.find(infix);
  return at == std::string::npos ? type : type.replace(at, infix.size(), "/");
}

RecordingPointer open_rosbag2_folder(const fs::path& dir) {
  const std::vector<fs::path> compressed = files_ending(dir, {".db3.zstd", ".mcap.zstd"});
  if (!compressed.empty()) {
    throw InputError(dir.string(), "files .db3 or .mcap (zstd -d decompresses them)",
                     compressed.front().filename().string());
  }
  std::vector<RecordingPointer> parts;
  for (const fs::path& file : files_ending(dir, {".db3", ".mcap"})) {
    parts.push_back(file.extension() == ".mcap" ? open_mcap_recording(file)
                                                : open_sqlite_recording(file));
  }
  return std::make_unique<JoinedRecording>(std::move(parts));
}

}  // namespace symscene
