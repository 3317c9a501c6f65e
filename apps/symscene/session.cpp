#include "session.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "print.hpp"

namespace symscene::app {
namespace {

/// Times of equal stages are added.
nlohmann::ordered_json to_json(const std::vector<StageTime>& times) {
  nlohmann::ordered_json seconds = nlohmann::ordered_json::object();
  for (const StageTime& time : times)
    seconds[time.stage] = seconds.value(time.stage, 0.0) + time.seconds;
  return seconds;
}

std::string json_string(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

ReportMember::ReportMember(std::string member, const std::filesystem::path& path)
    : name(std::move(member)), json(json_string(path.string())) {}

ReportMember ReportMember::raw(std::string member, std::string json) {
  ReportMember raw(std::move(member), 0);
  raw.json = std::move(json);
  return raw;
}

Session::Session(std::string command, const SharedOptions& shared)
    : command_(std::move(command)),
      shared_(shared),
      threads_(shared.threads),
      progress_(!shared.quiet && stderr_is_terminal()) {}

StageTimer::OnBegin Session::on_begin() {
  return [this](const std::string& stage) { progress_.begin(stage); };
}

void Session::print(const std::string& text) {
  progress_.stop();
  print_output(text);
}

void Session::print_line(const std::string& line) {
  if (shared_.quiet) return;
  if (shared_.json)
    progress_.print_line(line);
  else
    print(line + "\n");
}

void Session::warn(const std::string& line) {
  progress_.print_line(fmt::format("symscene {}: warning: {}", command_, line));
}

void Session::warn(std::span<const std::string> lines) {
  for (const std::string& line : lines) warn(line);
}

void Session::finish(const std::vector<ReportMember>& members,
                     const std::vector<StageTime>& times) {
  if (shared_.verbose && !times.empty()) print_line(format_times(times));
  if (!shared_.json) return;
  std::string line = fmt::format("{{\"command\":{}", json_string(command_));
  for (const ReportMember& member : members)
    line += fmt::format(",{}:{}", json_string(member.name), member.json);
  print(fmt::format("{},\"timings\":{}}}\n", line, to_json(times).dump()));
}

std::string format_times(const std::vector<StageTime>& times) {
  double total = 0.0;
  std::size_t width = 5;
  for (const StageTime& time : times) {
    total += time.seconds;
    width = std::max(width, time.stage.size());
  }
  std::string table = fmt::format("{:<{}}  {:>9}  share\n", "stage", width, "ms");
  for (const StageTime& time : times) {
    const double share = total > 0.0 ? 100.0 * time.seconds / total : 0.0;
    table +=
        fmt::format("{:<{}}  {:>9.2f}  {:>3.0f} %\n", time.stage, width, 1e3 * time.seconds, share);
  }
  return table + fmt::format("{:<{}}  {:>9.2f}", "total", width, 1e3 * total);
}

}  // namespace symscene::app
