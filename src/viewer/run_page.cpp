#include "symscene/viewer/run_page.hpp"

#include <algorithm>
#include <bit>

#include "core/base64.hpp"
#include "core/little_endian.hpp"
#include "core/mesh_thinning.hpp"
#include "io/atomic_file.hpp"
#include "page_filling.hpp"
#include "page_template.hpp"
#include "run_payload.hpp"
#include "run_tracks.hpp"
#include "scan_payload.hpp"
#include "symscene/core/point_cloud.hpp"
#include "viewer/run_checks.hpp"

namespace symscene {
namespace {

using nlohmann::json;

/// How many triangles meshes of one sort may have together, and each of them. 100,000 triangles
/// take 1.1 MB of the page.
struct TriangleBudget {
  Index all;
  Index most;
  Index fewest;

  Index share(std::size_t meshes) const {
    const auto count = static_cast<Index>(std::max<std::size_t>(meshes, 1));
    return std::clamp(all / count, fewest, most);
  }
};
constexpr TriangleBudget solid_triangles{200'000, 20'000, 1'000};
constexpr TriangleBudget believed_triangles{200'000, 3'000, 200};
constexpr float cell_of_diagonal = 1e-3F;  // of a thinned mesh, by its diagonal

json thinned_payload(const TriangleMesh& mesh, Index max_triangles) {
  if (mesh.triangles.rows() == 0) return nullptr;
  const float diagonal = bounding_box(mesh.vertices).extent().norm();
  return surface_payload(thin(mesh, max_triangles, cell_of_diagonal * diagonal));
}

std::string encode_times(const std::vector<double>& times) {
  std::vector<std::uint8_t> bytes;
  for (const double time : times) append_little_endian(bytes, std::bit_cast<std::uint64_t>(time));
  return base64(bytes);
}

std::vector<Eigen::Isometry3d> way_of(std::size_t solid, const RunRecording& recording) {
  std::vector<Eigen::Isometry3d> way;
  way.reserve(recording.poses.size());
  for (const std::vector<Eigen::Isometry3d>& poses : recording.poses) way.push_back(poses[solid]);
  return way;
}

json solids_payload(const RunRecording& recording) {
  const Index share = solid_triangles.share(recording.solids.size());
  json list = json::array();
  for (std::size_t k = 0; k < recording.solids.size(); ++k) {
    const RecordedSolid& solid = recording.solids[k];
    list.push_back({{"name", solid.name},
                    {"kind", to_string(solid.kind)},
                    {"surface", thinned_payload(solid.mesh, share)},
                    {"track", track_payload(way_of(k, recording))}});
  }
  return list;
}

json belief_payload(const RecordedBelief& belief, Index share) {
  json objects = json::array();
  for (const BelievedObject& object : belief.objects) {
    objects.push_back({{"name", object.name},
                       {"label", object.label},
                       {"surface", thinned_payload(object.mesh, share)}});
  }
  return {{"time", belief.time}, {"objects", std::move(objects)}};
}

json beliefs_payload(const std::vector<RecordedBelief>& beliefs) {
  std::size_t objects = 0;
  for (const RecordedBelief& belief : beliefs) objects += belief.objects.size();
  const Index share = believed_triangles.share(objects);
  json list = json::array();
  for (const RecordedBelief& belief : beliefs) list.push_back(belief_payload(belief, share));
  return list;
}

json events_payload(const std::vector<RecordedEvent>& events) {
  json list = json::array();
  for (const RecordedEvent& event : events) {
    list.push_back(
        {{"time", event.time}, {"text", event.text}, {"outcome", to_string(event.outcome)}});
  }
  return list;
}

}  // namespace

const char* to_string(RecordedKind kind) {
  switch (kind) {
    case RecordedKind::robot:
      return "robot";
    case RecordedKind::hand:
      return "hand";
    case RecordedKind::object:
      return "object";
    case RecordedKind::bin:
      return "bin";
    case RecordedKind::table:
      return "table";
  }
  return "";
}

const char* to_string(RecordedOutcome outcome) {
  switch (outcome) {
    case RecordedOutcome::note:
      return "note";
    case RecordedOutcome::success:
      return "success";
    case RecordedOutcome::failure:
      return "failure";
  }
  return "";
}

json run_payload(const RunRecording& recording, const std::string& title) {
  require_playable(recording);
  return {{"version", 1},
          {"title", title},
          {"times", encode_times(recording.times)},
          {"solids", solids_payload(recording)},
          {"beliefs", beliefs_payload(recording.beliefs)},
          {"events", events_payload(recording.events)},
          {"left", recording.left}};
}

std::string render_run_page(const RunRecording& recording, const std::string& title) {
  return fill_page(run_template(), title, script_json(run_payload(recording, title)));
}

void write_run_page(const std::filesystem::path& path, const RunRecording& recording,
                    const std::string& title) {
  write_file_atomically(path, render_run_page(recording, title));
}

}  // namespace symscene
