#pragma once

#include "reconstruction/tsdf_volume.hpp"

namespace symscene {

/// The surface of the model as a camera at a pose would see it.
struct ModelView {
  SurfaceImage image;  ///< in the camera's frame
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  bool has_dominant_plane = false;  ///< whose pixels have one normal, see flatten_dominant_plane()
};

/// Casts a ray through every pixel to the first zero crossing from the front of a surface to its
/// back, by trilinear interpolation (Newcombe et al. 2011, section 3.4). Rays start at the first
/// block with surface and skip blocks without. Where the corners of a tile of 4×4 pixels show one
/// surface, the rays between them start shortly in front of it. (An object thinner than a tile in
/// front of that surface can be missed if no corner shows it.) Normals are the gradient of the
/// field.
ModelView cast_model_view(const TsdfVolume& volume, const CameraIntrinsics& camera,
                          const Eigen::Isometry3d& T_world_camera);

}  // namespace symscene
