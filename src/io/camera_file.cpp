#include "symscene/io/camera_file.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "camera_formats.hpp"
#include "image_formats.hpp"
#include "io/atomic_file.hpp"
#include "io/file_names.hpp"
#include "io/pose_json.hpp"
#include "ros_camera_info.hpp"
#include "symscene/core/error.hpp"
#include "yaml.hpp"
#include "yaml_text.hpp"

namespace symscene {
namespace {

constexpr const char* camera_to_write = "camera to write";

/// Name and member of each coefficient.
constexpr std::array<std::pair<const char*, double LensDistortion::*>, 5> coefficients{
    {{"k1", &LensDistortion::k1},
     {"k2", &LensDistortion::k2},
     {"p1", &LensDistortion::p1},
     {"p2", &LensDistortion::p2},
     {"k3", &LensDistortion::k3}}};

void require_known_members(const JsonCursor& object, std::initializer_list<const char*> known) {
  for (const auto& [name, value] : object.members()) {
    const auto is = [&name = name](const char* other) { return name == other; };
    if (std::none_of(known.begin(), known.end(), is)) value.fail("no member of this name");
  }
}

CameraIntrinsics intrinsics_of(const JsonCursor& root, const std::string& name) {
  const JsonCursor numbers = root.at("intrinsics");
  require_known_members(numbers, {"fx", "fy", "cx", "cy"});
  const CameraIntrinsics camera{whole_number(root.at("width"), largest_image),
                                whole_number(root.at("height"), largest_image),
                                numbers.at("fx").number(),
                                numbers.at("fy").number(),
                                numbers.at("cx").number(),
                                numbers.at("cy").number()};
  require_camera(camera, name);
  return camera;
}

LensDistortion distortion_of(const JsonCursor& root) {
  LensDistortion lens;
  const auto numbers = root.find("distortion");
  if (!numbers) return lens;
  require_known_members(*numbers, {"k1", "k2", "p1", "p2", "k3"});
  for (const auto& [name, member] : coefficients) {
    if (const auto number = numbers->find(name)) lens.*member = number->number();
  }
  return lens;
}

std::vector<std::uint8_t> flags_of(const JsonCursor& list, std::size_t count) {
  std::vector<std::uint8_t> flags;
  for (const JsonCursor& item : list.items(count)) {
    const double flag = item.number();
    if (flag != 0.0 && flag != 1.0) item.fail("0 or 1");
    flags.push_back(flag == 1.0 ? 1 : 0);
  }
  return flags;
}

DepthCorrection correction_of(const JsonCursor& grid, const CameraIntrinsics& camera) {
  require_known_members(
      grid, {"columns", "rows", "first_range_m", "range_step_m", "factors", "measured"});
  DepthCorrection correction;
  correction.width = camera.width;
  correction.height = camera.height;
  correction.columns = whole_number(grid.at("columns"), camera.width);
  correction.rows = whole_number(grid.at("rows"), camera.height);
  correction.first_range = grid.at("first_range_m").number();
  correction.range_step = grid.at("range_step_m").number();
  const std::size_t tiles = std::size_t{correction.columns} * correction.rows;
  const std::vector<JsonCursor> factors = grid.at("factors").items();
  correction.ranges = static_cast<Index>(factors.size());
  const std::vector<JsonCursor> measured = grid.at("measured").items(factors.size());
  for (std::size_t k = 0; k < factors.size(); ++k) {
    for (const JsonCursor& factor : factors[k].items(tiles))
      correction.factors.push_back(static_cast<float>(factor.number()));
    const std::vector<std::uint8_t> flags = flags_of(measured[k], tiles);
    correction.measured.insert(correction.measured.end(), flags.begin(), flags.end());
  }
  correction.validate();
  return correction;
}

ColorCamera color_of(const JsonCursor& json, const std::string& name) {
  require_known_members(json, {"width", "height", "intrinsics", "distortion", "T_depth_color"});
  ColorCamera color;
  color.intrinsics = intrinsics_of(json, name);
  color.distortion = distortion_of(json);
  color.T_depth_color = pose_of(json.at("T_depth_color"));
  return color;
}

CameraModel model_of(const JsonCursor& root, const std::string& name) {
  require_known_members(root, {"version", "width", "height", "intrinsics", "distortion",
                               "depth_correction", "color"});
  if (root.at("version").number() != 1.0) root.at("version").fail("1");
  CameraModel camera;
  camera.intrinsics = intrinsics_of(root, name);
  camera.distortion = distortion_of(root);
  if (const auto grid = root.find("depth_correction"))
    camera.depth_correction = correction_of(*grid, camera.intrinsics);
  if (const auto color = root.find("color")) camera.color = color_of(*color, name);
  return camera;
}

Json camera_json(const CameraIntrinsics& camera, const LensDistortion& lens) {
  const auto number = [](double value) { return to_json(value, camera_to_write); };
  Json json = {{"width", camera.width},
               {"height", camera.height},
               {"intrinsics",
                {{"fx", number(camera.fx)},
                 {"fy", number(camera.fy)},
                 {"cx", number(camera.cx)},
                 {"cy", number(camera.cy)}}}};
  if (lens.is_none()) return json;
  for (const auto& [name, member] : coefficients) json["distortion"][name] = number(lens.*member);
  return json;
}

Json correction_json(const DepthCorrection& correction) {
  const std::size_t tiles = std::size_t{correction.columns} * correction.rows;
  Json factors = Json::array(), measured = Json::array();
  for (std::size_t k = 0; k < correction.ranges; ++k) {
    Json numbers = Json::array(), flags = Json::array();
    for (std::size_t i = k * tiles; i < (k + 1) * tiles; ++i) {
      // Six digits keep a millionth; the shortest text that reads back as the same float does both.
      numbers.push_back(std::stod(fmt::format("{}", correction.factors[i])));
      flags.push_back(correction.measured[i]);
    }
    factors.push_back(std::move(numbers));
    measured.push_back(std::move(flags));
  }
  return {{"columns", correction.columns},
          {"rows", correction.rows},
          {"first_range_m", to_json(correction.first_range, camera_to_write)},
          {"range_step_m", to_json(correction.range_step, camera_to_write)},
          {"factors", std::move(factors)},
          {"measured", std::move(measured)}};
}

}  // namespace

bool is_camera_file(const std::filesystem::path& path) {
  return path.extension() == ".json" || is_yaml(path);
}

CameraModel parse_camera_model(std::string_view text, const std::string& name) {
  const bool is_json = std::filesystem::path(name).extension() == ".json";
  const Json document = is_json ? parse_json(text, name) : parse_yaml(text, name);
  const JsonCursor root(document, name);
  return is_ros_camera_info(root) ? ros_camera_info(root, name) : model_of(root, name);
}

CameraModel read_camera_model(const std::filesystem::path& path) {
  return parse_camera_model(read_file(path), path.string());
}

std::string format_camera_model(const CameraModel& camera) {
  Json json = {{"version", 1}};
  json.update(camera_json(camera.intrinsics, camera.distortion));
  if (camera.depth_correction) {
    camera.depth_correction->validate();
    json["depth_correction"] = correction_json(*camera.depth_correction);
  }
  if (camera.color) {
    json["color"] = camera_json(camera.color->intrinsics, camera.color->distortion);
    json["color"]["T_depth_color"] = pose_json(camera.color->T_depth_color, camera_to_write);
  }
  return format_yaml(json);
}

}  // namespace symscene
