#pragma once

#include <vector>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/depth_noise.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// How the pixels of one depth image become oriented points.
struct ViewPointOptions {
  double min_depth = 0.2;
  double max_depth = 6.0;
  double noise = structured_light_noise;
  double normal_noise = 0.05;
  double edge_sigmas = 4.0;
  double max_slant = radians(75.0);
  double min_cosine = 0.1;
  int max_hole = 2;
  bool sharpen = true;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    constexpr double right_angle = radians(90.0);
    visit("min_depth", self.min_depth, "m", above(0.0), "nearer depths are ignored");
    visit("max_depth", self.max_depth, "m", above_up_to(0.0, 65.0), "farther depths are ignored");
    visit("noise", self.noise, "1/m", between(1e-6, 1.0),
          "standard deviation of a depth over its square, which is that of an inverse depth "
          "(Khoshelham and Elberink 2012, Eq. 10)");
    visit("normal_noise", self.normal_noise, "rad", between(1e-3, 1.0),
          "standard deviation of a normal under independent noise: the window of the plane fit is "
          "as large as that needs");
    visit("edge_sigmas", self.edge_sigmas, "", at_least(0.0),
          "depth step between neighbouring pixels, in standard deviations over that of the most "
          "slanted surface, that makes an edge");
    visit("max_slant", self.max_slant, "rad", strictly_between(0.0, right_angle),
          "angle between ray and normal up to which neighbouring pixels are one surface");
    visit("min_cosine", self.min_cosine, "", strictly_between(0.0, 1.0),
          "cosine of the angle between normal and ray from which a pixel is a point");
    visit("max_hole", self.max_hole, "px", between(0, 16),
          "missing pixels in a row that do not end a surface");
    visit("sharpen", self.sharpen, "", any_value(),
          "at creases take the plane of the neighbouring window that fits best (Kuwahara et al. "
          "1976)");
  }
  /// Throws InputError if a value is out of its range or max_depth is not above min_depth.
  void validate() const;
};

/// The oriented points of a depth image, in the camera's frame.
struct ViewPoints {
  CameraIntrinsics camera;
  PointCloud cloud;           ///< in the order of the pixels; all have normals
  std::vector<Index> pixels;  ///< row · width + column of each point, ascending
};

/// Makes a point of every pixel whose neighbourhood shows a surface. A plane, which is linear in
/// inverse depth, is fitted to the pixels that a cross-shaped window reaches without passing a
/// depth edge (Zhang, Lu and Lafruit 2009); its size follows the noise and the distance. The point
/// is that of the plane on the pixel's ray. Pixels between two surfaces (flying pixels) reach too
/// few others and are left out. The same bytes for any number of threads. Throws InputError if the
/// image is not of the camera's size or an option is out of its range.
ViewPoints unproject(const DepthFrame& frame, const CameraIntrinsics& camera,
                     const ViewPointOptions& options = {});

/// Triangles between the points of neighbouring pixels that are on one surface, in the frame of the
/// points.
TriangleMesh view_mesh(const ViewPoints& points, const ViewPointOptions& options = {});

}  // namespace symscene
