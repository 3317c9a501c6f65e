#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/core/triangle_mesh.hpp"
#include "symscene/physics/convex_parts.hpp"

namespace symscene {

/// An object of the clutter-removal benchmark.
struct ClutterObject {
  std::string name;
  double mass = 0.0;     ///< [kg]
  TriangleMesh surface;  ///< what cameras see, in the object's frame
  ConvexParts parts;     ///< what the physics collides, in the object's frame
};

/// Objects by the hash of their name: parameters are fitted to the first half, figures are reported
/// on the second.
enum class ObjectShare { all, fitting, held_out };

/// "all", "fitting" or "held-out".
const char* to_string(ObjectShare share);

/// The share of that name. Throws InputError for any other text.
ObjectShare parse_object_share(const std::string& text);

/// Whether an object is of the half that nothing is fitted to: the 64-bit FNV-1a hash of its name
/// is odd.
bool is_held_out(std::string_view name);

/// Reads the objects in a folder, sorted by name: `NAME.urdf` with the mass and the names of two
/// meshes in metres, of which that for collisions has one convex part per group ("o" or "g").
/// Scale and origin of the meshes are not supported. Throws InputError if a file cannot be read or
/// lacks one of these, or there is no object.
std::vector<ClutterObject> read_clutter_objects(const std::filesystem::path& dir,
                                                ObjectShare share = ObjectShare::all);

}  // namespace symscene
