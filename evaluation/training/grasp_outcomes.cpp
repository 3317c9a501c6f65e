#include "grasp_outcomes.hpp"

#include <charconv>
#include <fstream>
#include <map>
#include <string>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene::bench {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

/// The rows of a file by the names of its columns.
class Table {
 public:
  explicit Table(const std::filesystem::path& file) : name_(file.string()), in_(file) {
    std::string header;
    if (!std::getline(in_, header)) throw InputError(name_, "a line with names of columns", "none");
    const std::vector<std::string> names = cells_of(header);
    for (std::size_t k = 0; k < names.size(); ++k) column_[names[k]] = k;
  }

  bool next() {
    std::string line;
    if (!std::getline(in_, line)) return false;
    cells_ = cells_of(line);
    if (cells_.size() == column_.size()) return true;
    throw InputError(name_, fmt::format("{} columns in each row", column_.size()),
                     fmt::format("{}", cells_.size()));
  }

  const std::string& text(const std::string& column) const {
    const auto found = column_.find(column);
    if (found == column_.end()) throw InputError(name_, "a column " + column, "none");
    return cells_[found->second];
  }

  double number(const std::string& column) const {
    const std::string& cell = text(column);
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size())
      throw InputError(name_, "a number in column " + column, fmt::format("\"{}\"", cell));
    return value;
  }

 private:
  std::string name_;
  std::ifstream in_;
  std::map<std::string, std::size_t> column_;
  std::vector<std::string> cells_;
};

GraspSource source_of(const std::string& name) {
  for (std::size_t k = 0; k < grasp_sources; ++k) {
    const auto source = static_cast<GraspSource>(k);
    if (name == to_string(source)) return source;
  }
  throw InputError("the source of a grasp", "a name of GraspSource", fmt::format("\"{}\"", name));
}

}  // namespace

std::vector<GraspSample> read_grasp_samples(const std::vector<std::filesystem::path>& files) {
  std::vector<GraspSample> samples;
  std::map<std::pair<std::string, double>, std::size_t> groups;
  for (const std::filesystem::path& file : files) {
    Table table(file);
    while (table.next()) {
      GraspSample sample;
      const std::pair round{file.string(), table.number("round")};
      sample.group = groups.try_emplace(round, groups.size()).first->second;
      GraspFeatures::visit_fields(sample.grasp.features, [&](const char* name, double& value) {
        value = table.number(name);
      });
      sample.grasp.source = source_of(table.text("source"));
      sample.success = table.number("success") != 0.0;
      samples.push_back(sample);
    }
  }
  return samples;
}

}  // namespace symscene::bench
