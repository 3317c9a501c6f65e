#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "calibrate.hpp"
#include "viewer/html_text.hpp"

namespace symscene::app {
namespace {

constexpr const char* page_begin =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" "
    "content=\"width=device-width\"><title>Camera calibration</title><style>body{{font:15px/1.4 "
    "system-ui,sans-serif;margin:1.5em;max-width:70em}}table{{border-collapse:collapse}}td,th"
    "{{padding:.15em .7em;text-align:right}}td:first-child,th:first-child{{text-align:left}}"
    "figure{{display:inline-block;margin:.4em}}svg{{background:#fff;border:1px solid #999;width:"
    "20em;max-width:100%}}</style><h1>Camera calibration</h1><p>{}</p>";

/// Corners and, enlarged, their residuals.
void add_corners(std::string& svg, const BoardImage& image, const BoardViewReport& view,
                 double magnification) {
  for (std::size_t i = 0; i < image.corners.size(); ++i) {
    const Eigen::Vector2d& p = image.corners[i];
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\" fill=\"#27c\"/>", p.x(), p.y());
    if (i >= view.residuals.size()) continue;
    const Eigen::Vector2d end = p + magnification * view.residuals[i];
    svg += fmt::format(
        "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#c30\" stroke-width=\"1.5\"/>", p.x(),
        p.y(), end.x(), end.y());
  }
}

/// Blue where depth is too far, red where it is too near.
std::string color_of(double factor, double scale) {
  const double share = std::clamp((factor - 1.0) / scale, -1.0, 1.0);
  const int fade = static_cast<int>(std::lround(255.0 * (1.0 - std::abs(share))));
  return share > 0.0 ? fmt::format("rgb(255,{0},{0})", fade)
                     : fmt::format("rgb({0},{0},255)", fade);
}

std::string map_of(const DepthCorrection& grid, Index range, double scale) {
  std::string svg = fmt::format("<figure><svg viewBox=\"0 0 {} {}\">", grid.columns, grid.rows);
  for (Index j = 0; j < grid.rows; ++j) {
    for (Index i = 0; i < grid.columns; ++i) {
      const std::size_t cell = grid.cell(range, j, i);
      svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"1\" height=\"1\" fill=\"{}\"/>", i, j,
                         color_of(double{grid.factors[cell]}, scale));
      if (grid.measured[cell] == 0)
        svg += fmt::format("<circle cx=\"{}.5\" cy=\"{}.5\" r=\".12\" fill=\"#666\"/>", i, j);
    }
  }
  return svg + fmt::format("</svg><figcaption>{:.2f} m</figcaption></figure>", grid.range(range));
}

std::string row_of(const DepthViewReport& view) {
  if (!view.used)
    return fmt::format("<tr><td>{}<td colspan=\"4\">left out: {}", view.number,
                       escape_html(view.reason));
  return fmt::format("<tr><td>{}<td>{:.2f} m<td>{:.0f} %<td>{:.2f} %<td>{:.2f} %", view.number,
                     view.distance, 100.0 * view.share, 100.0 * view.error_before,
                     100.0 * view.error_after);
}

}  // namespace

std::string intrinsics_page(const IntrinsicCalibration& found, std::span<const BoardImage> images) {
  constexpr double magnification = 100.0;
  const CameraIntrinsics& K = found.camera.intrinsics;
  const LensDistortion& lens = found.camera.distortion;
  std::string page = fmt::format(
      fmt::runtime(page_begin),
      fmt::format(
          "fx {:.2f} fy {:.2f} cx {:.2f} cy {:.2f} px; k1 {:.4f} k2 {:.4f} p1 {:.5f} p2 "
          "{:.5f} k3 {:.4f}; reprojection error {:.3f} px; corners in {:.0f} % of the image",
          K.fx, K.fy, K.cx, K.cy, lens.k1, lens.k2, lens.p1, lens.p2, lens.k3, found.error,
          100.0 * found.coverage));
  const std::string frame = fmt::format("<svg viewBox=\"0 0 {} {}\">", K.width, K.height);
  std::string all = frame, each;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const BoardViewReport& view = found.views[i];
    if (view.used) add_corners(all, images[i], view, magnification);
    each += "<figure>" + frame;
    add_corners(each, images[i], view, magnification);
    each += fmt::format("</svg><figcaption>{}: {:.3f} px{}</figcaption></figure>",
                        escape_html(view.name), view.error,
                        view.used ? "" : ", left out: " + escape_html(view.reason));
  }
  page += fmt::format(
      "<h2>Coverage and residuals</h2><p>Corners (blue) and their residuals (red), "
      "{:.0f} times as long.</p><figure>{}</svg></figure><h2>Images</h2>{}",
      magnification, all, each);
  return page + "</html>\n";
}

std::string depth_page(const DepthCalibration& found) {
  const DepthCorrection& grid = found.correction;
  double scale = 1e-3;
  for (const float factor : grid.factors) scale = std::max(scale, std::abs(double{factor} - 1.0));
  std::string page =
      fmt::format(fmt::runtime(page_begin),
                  fmt::format("Error of depth {:.2f} % before the correction, {:.2f} % after.",
                              100.0 * found.error_before, 100.0 * found.error_after));
  for (const std::string& warning : found.warnings) page += "<p>" + escape_html(warning) + ".</p>";
  page += fmt::format(
      "<h2>Correction by range</h2><p>Red: measured too near, up to {:.2f} %. Blue: "
      "too far. A dot: not measured, continued from its neighbours.</p>",
      100.0 * scale);
  for (Index k = 0; k < grid.ranges; ++k) page += map_of(grid, k, scale);
  page += "<h2>Images</h2><table><tr><th>image<th>distance<th>on the plane<th>before<th>after";
  for (const DepthViewReport& view : found.views) page += row_of(view);
  return page + "</table></html>\n";
}

}  // namespace symscene::app
