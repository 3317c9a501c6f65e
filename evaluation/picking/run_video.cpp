#include "symscene/picking/run_video.hpp"

#include <algorithm>
#include <cmath>

#include "core/mesh_thinning.hpp"
#include "core/parallel.hpp"
#include "core/rigid_motion.hpp"
#include "io/gif_writer.hpp"
#include "simulation/depth_renderer.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/point_cloud.hpp"
#include "video_camera.hpp"
#include "video_palette.hpp"
#include "viewer/run_checks.hpp"

namespace symscene {
namespace {

using Pixels = std::vector<std::uint8_t>;  // indices into the palette

constexpr Index most_triangles = 20'000;    // of a solid
constexpr float cell_of_diagonal = 2e-3F;   // of a thinned mesh, by its diagonal: about a pixel
constexpr std::size_t frames_at_once = 16;  // that are rendered before they are encoded

/// Draws the moments of a recording.
class RunRenderer {
 public:
  RunRenderer(const RunRecording& recording, const RunVideoOptions& options)
      : recording_(recording),
        camera_(video_camera(recording, options)),
        hues_(VideoPalette::hues_of(recording.solids)) {
    for (const RecordedSolid& solid : recording.solids) meshes_.push_back(drawn(solid.mesh));
  }

  Pixels draw(std::size_t moment) const {
    std::vector<TriangleMesh> solids;
    for (std::size_t k = 0; k < meshes_.size(); ++k)
      solids.push_back(transformed(meshes_[k], recording_.poses[moment][k]));
    const SensorFrame frame =
        DepthRenderer(solids).render(camera_.intrinsics, camera_.T_table_camera);
    Pixels pixels(frame.objects.size(), VideoPalette::background);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (frame.objects[i] != SensorFrame::nothing)
        pixels[i] = VideoPalette::shaded(hues_[frame.objects[i]], frame.cosines[i]);
    }
    return pixels;
  }

 private:
  static TriangleMesh drawn(const TriangleMesh& mesh) {
    if (mesh.triangles.rows() == 0) return {};
    return thin(mesh, most_triangles,
                cell_of_diagonal * bounding_box(mesh.vertices).extent().norm());
  }

  const RunRecording& recording_;
  VideoCamera camera_;
  std::vector<std::uint8_t> hues_;
  std::vector<TriangleMesh> meshes_;
};

constexpr double same_time = 1e-6;  // rounding must not show the moment before [s]

/// The moment that each frame shows: the last one that is not after the frame's time.
std::vector<std::size_t> shown_moments(const std::vector<double>& times,
                                       const RunVideoOptions& options) {
  const double duration = times.back() - times.front();
  const double speed = std::max(1.0, duration / options.max_duration);
  const auto last = static_cast<std::size_t>(std::ceil(duration / speed * options.frame_rate));
  std::vector<std::size_t> moments;
  for (std::size_t i = 0; i < last; ++i) {
    const double time = times.front() + speed * static_cast<double>(i) / options.frame_rate;
    const auto after = std::upper_bound(times.begin(), times.end(), time + same_time);
    moments.push_back(static_cast<std::size_t>(after - times.begin()) - 1);
  }
  moments.push_back(times.size() - 1);
  return moments;
}

}  // namespace

std::string render_run_video(const RunRecording& recording, const RunVideoOptions& options) {
  options.validate();
  require_playable(recording);
  if (recording.times.empty()) throw InputError("the recording of a run", "moments", "none");
  GifWriter gif({static_cast<Index>(options.width), static_cast<Index>(options.height)},
                VideoPalette().colors());
  const RunRenderer renderer(recording, options);
  const std::vector<std::size_t> moments = shown_moments(recording.times, options);
  for (std::size_t begin = 0; begin < moments.size(); begin += frames_at_once) {
    std::vector<Pixels> frames(std::min(frames_at_once, moments.size() - begin));
    parallel_for_each(frames.size(),
                      [&](std::size_t i) { frames[i] = renderer.draw(moments[begin + i]); });
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const bool is_last = begin + i + 1 == moments.size();
      gif.add(frames[i], 1.0 / options.frame_rate + (is_last ? options.last_frame : 0.0));
    }
  }
  return gif.finish();
}

}  // namespace symscene
