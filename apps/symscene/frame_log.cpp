#include "frame_log.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "counted.hpp"

namespace symscene::app {

void FrameLog::add(std::size_t frame, const FrameReport& report) {
  const TrackingResult& tracking = report.tracking;
  fused_ += report.fused ? 1 : 0;
  relocalized_ += report.relocalized ? 1 : 0;
  doubtful_ += tracking.status != TrackingStatus::converged && tracking.searchable ? 1 : 0;
  const bool free = tracking.status == TrackingStatus::degenerate;
  add(frame, to_string(tracking.status),
      free ? fmt::format("unconstrained motions: {}", fmt::join(tracking.unconstrained, ", "))
           : std::string(tracking.reason));
}

void FrameLog::add_unreadable(std::size_t frame) { add(frame, "unreadable", ""); }

void FrameLog::add_lost(std::size_t frame, const std::string& reason) {
  add(frame, "lost", reason);
}

void FrameLog::add_stitched(std::size_t frame) {
  ++fused_;
  add(frame, "stitched", "");
}

void FrameLog::add(std::size_t frame, const std::string& status, const std::string& detail) {
  ++frames_;
  // Lost frames are split by reason; the unconstrained motions of degenerate ones vary with noise.
  if (runs_.empty() || runs_.back().status != status ||
      (status == "lost" && runs_.back().detail != detail)) {
    runs_.push_back({status, detail, frame, frame});
  }
  runs_.back().last = frame;
}

std::size_t FrameLog::count(const std::string& status) const {
  std::size_t sum = 0;
  for (const Run& run : runs_) {
    if (run.status == status) sum += run.last - run.first + 1;
  }
  return sum;
}

std::string FrameLog::describe(const Run& run) const {
  const std::string frames =
      run.first == run.last ? fmt::format("frame {}", step_ * run.first)
                            : fmt::format("frames {} to {}", step_ * run.first, step_ * run.last);
  return fmt::format("{}: {}{}{}", frames, run.status, run.detail.empty() ? "" : ", ", run.detail);
}

std::string FrameLog::first_run() const { return runs_.empty() ? "none" : describe(runs_.front()); }

std::vector<std::string> FrameLog::lines() const {
  constexpr std::size_t most = 12;
  std::vector<std::string> lines{
      fmt::format("{}: {} fused, {} of them degenerate; {} lost, {} unreadable; found again {}",
                  counted(frames_, "frame"), fused_, count("degenerate"), count("lost"),
                  count("unreadable"), counted(relocalized_, "time"))};
  for (const Run& run : runs_) {
    if (run.status == "converged" || run.status == "stitched") continue;
    if (lines.size() > most) {
      lines.emplace_back("  ... (all in scene.json)");
      break;
    }
    lines.push_back("  " + describe(run));
  }
  return lines;
}

std::string FrameLog::json() const {
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (const Run& run : runs_) {
    nlohmann::ordered_json entry = {
        {"first", step_ * run.first}, {"last", step_ * run.last}, {"status", run.status}};
    if (!run.detail.empty()) entry["detail"] = run.detail;
    runs.push_back(std::move(entry));
  }
  nlohmann::ordered_json object = {{"count", frames_},
                                   {"fused", fused_},
                                   {"degenerate", count("degenerate")},
                                   {"lost", count("lost")},
                                   {"unreadable", count("unreadable")},
                                   {"relocalized", relocalized_},
                                   {"runs", std::move(runs)}};
  if (step_ != 1) object["every"] = step_;
  if (const std::size_t stitched = count("stitched")) object["stitched"] = stitched;
  if (!warnings_.empty()) object["warnings"] = warnings_;
  return object.dump();
}

}  // namespace symscene::app
