#pragma once

#include <cstddef>
#include <string>

#include "symscene/workflow/live_scene.hpp"

namespace symscene::app {

/// What a live scene tells after an update.
struct LiveReport {
  std::size_t number = 0;  ///< of the update, from 1
  LiveUpdate update;
  std::size_t lost = 0;      ///< frames so far whose pose was not found
  double frame_time = 0.0;   ///< recorded time of its last frame [s]
  double latency = 0.0;      ///< from the arrival of that frame until its objects were found [s]
  float spacing = 0.0F;      ///< median distance between neighbouring points [m]
  std::string problem = {};  ///< why the frames make no scene; empty if they do
};

/// The report as a line of JSON.
std::string live_json(const LiveReport& report);

/// The report as a line for people.
std::string live_line(const LiveReport& report);

/// The report and at most `most` points of the update, evenly spread, with the places of their
/// objects in the report (0 for none) and colours, in the layout of docs/formats.md (*Live
/// updates*).
std::string live_bytes(const LiveReport& report, std::size_t most);

}  // namespace symscene::app
