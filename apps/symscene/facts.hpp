#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "session.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene::app {

/// What `symscene info` reports: rows of a table, and members of the line that --json prints.
class Facts {
 public:
  using Json = nlohmann::ordered_json;

  explicit Facts(const std::string& kind) { add_member("kind", kind); }

  /// Adds a row and the same fact as a member.
  void add(const std::string& label, const std::string& text, const char* key, const Json& value) {
    add_row(label, text);
    add_member(key, value);
  }
  void add_row(const std::string& label, const std::string& text) {
    rows_.push_back({label, text});
  }
  void add_member(const char* key, const Json& value) {
    members_.push_back(
        ReportMember::raw(key, value.dump(-1, ' ', false, Json::error_handler_t::replace)));
  }

  void add_warnings(const std::vector<std::string>& warnings) {
    warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
  }

  /// One line per row, with the texts aligned.
  std::string table() const;
  const std::vector<ReportMember>& members() const { return members_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct Row {
    std::string label;
    std::string text;
  };
  std::vector<Row> rows_;
  std::vector<ReportMember> members_;
  std::vector<std::string> warnings_;
};

/// Reads the frames of these numbers.
Facts sequence_facts(const DepthSequence& sequence, const std::vector<std::size_t>& samples);

Facts scene_facts(const std::filesystem::path& dir);
Facts result_facts(const std::filesystem::path& dir);
Facts dataset_facts(const std::filesystem::path& path);

/// Whether a file has the extension of a cloud, a mesh or an occupancy tree.
bool is_model_file(const std::filesystem::path& path);
Facts model_facts(const std::filesystem::path& path);

}  // namespace symscene::app
