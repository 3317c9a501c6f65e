#include "symscene/clutter/clutter_objects.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "symscene/io/mesh.hpp"

namespace symscene {
namespace {

constexpr std::array shares{ObjectShare::all, ObjectShare::fitting, ObjectShare::held_out};

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path.string(), "a file that can be read", "none");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The first group of the expression in a description of a robot.
std::string value_in(const std::string& urdf, const char* expression, const char* what,
                     const std::filesystem::path& path) {
  std::smatch match;
  if (!std::regex_search(urdf, match, std::regex(expression)))
    throw InputError(path.string(), what, "none");
  return match[1];
}

double mass_in(const std::string& urdf, const std::filesystem::path& path) {
  const std::string text =
      value_in(urdf, "<mass\\s+value=\"([^\"]*)\"", "an element <mass value=...>", path);
  double mass = 0.0;
  std::istringstream(text) >> mass;
  if (!(mass > 0.0)) throw InputError(path.string(), "a mass above 0", text);
  return mass;
}

void require_plain_meshes(const std::string& urdf, const std::filesystem::path& path) {
  for (const char* unsupported : {"scale=", "<origin"}) {
    if (urdf.find(unsupported) != std::string::npos)
      throw InputError(path.string(), "meshes in the object's frame and in metres", unsupported);
  }
}

Points as_points(const std::vector<Eigen::Vector3f>& vertices) {
  Points points(static_cast<Eigen::Index>(vertices.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = vertices[static_cast<std::size_t>(i)].transpose();
  return points;
}

/// The vertices of each group of an OBJ file.
ConvexParts read_parts(const std::filesystem::path& path) {
  std::istringstream lines(read_text(path));
  ConvexParts parts;
  std::vector<Eigen::Vector3f> vertices;
  const auto end_part = [&] {
    constexpr std::size_t tetrahedron = 4;
    if (vertices.size() >= tetrahedron) parts.push_back(as_points(vertices));
    vertices.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("o ") || line.starts_with("g ")) end_part();
    if (!line.starts_with("v ")) continue;
    std::istringstream numbers(line.substr(2));
    Eigen::Vector3f vertex;
    if (!(numbers >> vertex.x() >> vertex.y() >> vertex.z()))
      throw InputError(path.string(), "three coordinates per vertex", line);
    vertices.push_back(vertex);
  }
  end_part();
  if (parts.empty()) throw InputError(path.string(), "a convex part", "none");
  return parts;
}

ClutterObject read_object(const std::filesystem::path& path) {
  const std::string urdf = read_text(path);
  require_plain_meshes(urdf, path);
  const auto mesh_of = [&](const char* element) {
    const std::string expression =
        fmt::format("<{}[^>]*>[^]*?<mesh\\s+filename=\"([^\"]*)\"", element);
    const std::string what = fmt::format("a mesh in the element <{}>", element);
    return path.parent_path() / value_in(urdf, expression.c_str(), what.c_str(), path);
  };
  return {path.stem().string(), mass_in(urdf, path), read_mesh(mesh_of("visual")),
          read_parts(mesh_of("collision"))};
}

}  // namespace

const char* to_string(ObjectShare share) {
  switch (share) {
    case ObjectShare::all:
      return "all";
    case ObjectShare::fitting:
      return "fitting";
    case ObjectShare::held_out:
      break;
  }
  return "held-out";
}

ObjectShare parse_object_share(const std::string& text) {
  for (const ObjectShare share : shares) {
    if (text == to_string(share)) return share;
  }
  throw InputError("the share of the objects", "all, fitting or held-out", text);
}

bool is_held_out(std::string_view name) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : name) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211U;
  }
  return hash % 2 == 1;
}

std::vector<ClutterObject> read_clutter_objects(const std::filesystem::path& dir,
                                                ObjectShare share) {
  if (!std::filesystem::is_directory(dir)) throw InputError(dir.string(), "a folder", "none");
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(dir)) {
    const bool held_out = is_held_out(entry.path().stem().string());
    const bool chosen = share == ObjectShare::all || held_out == (share == ObjectShare::held_out);
    if (entry.path().extension() == ".urdf" && chosen) paths.push_back(entry.path());
  }
  if (paths.empty()) {
    throw InputError(dir.string(), fmt::format("objects ({}) as NAME.urdf", to_string(share)),
                     "none");
  }
  std::sort(paths.begin(), paths.end());
  std::vector<ClutterObject> objects;
  for (const std::filesystem::path& path : paths) objects.push_back(read_object(path));
  return objects;
}

}  // namespace symscene
