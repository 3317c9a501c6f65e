#ifdef SYMSCENE_HAS_MUJOCO

#include "world_description.hpp"

#include <fmt/format.h>

#include "mujoco_world.hpp"

namespace symscene {
namespace {

constexpr double full_force_distance =
    0.001;  // of a finger from its target, from which it has its full force [m]

/// The finger that opens along -y.
ConvexParts turned(const ConvexParts& finger) {
  ConvexParts parts = finger;
  for (Points& part : parts) part.leftCols<2>() *= -1.0F;
  return parts;
}

/// Mesh assets NAME_0, NAME_1 ...: the hulls of the parts.
std::string describe_hulls(const std::string& name, const ConvexParts& parts) {
  std::string text;
  for (std::size_t p = 0; p < parts.size(); ++p)
    append_hull(text, fmt::format("{}_{}", name, p), parts[p]);
  return text;
}

/// The geometries of these. Where both surfaces have the same priority, MuJoCo takes the greater
/// friction; otherwise that of
// the surface with the higher one.
std::string describe_geoms(const std::string& name, const ConvexParts& parts,
                           const std::string& attributes = {}) {
  std::string text;
  for (std::size_t p = 0; p < parts.size(); ++p)
    text += fmt::format("<geom type=\"mesh\" mesh=\"{}_{}\" {}/>", name, p, attributes);
  return text;
}

std::string describe_fixed(std::span<const FixedBox> fixed, const std::string& friction) {
  std::string text = fmt::format("<geom type=\"plane\" size=\"0 0 1\" {}/>\n", friction);
  for (const FixedBox& box : fixed) {
    const Eigen::Vector3d middle = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
    text += fmt::format(
        "<geom type=\"box\" pos=\"{} {} {}\" size=\"{} {} {}\" contype=\"0\" conaffinity=\"0\" "
        "{}/>\n",
        middle.x(), middle.y(), middle.z(), half.x(), half.y(), half.z(), friction);
  }
  return text;
}

/// A finger as a child of the palm. While it moves freely its damping balances its force.
std::string describe_finger(const char* name, double side, const ConvexParts& parts,
                            const ParallelHand& hand, const GraspWorldOptions& options) {
  return fmt::format(
      "<body name=\"{0}\"><joint name=\"{0}\" type=\"slide\" axis=\"0 {1} 0\" limited=\"true\" "
      "range=\"0 {2}\" damping=\"{3}\"/>{4}</body>\n",
      name, side, 0.5 * hand.max_opening, hand.force / hand.speed,
      describe_geoms(name, parts,
                     fmt::format("condim=\"4\" priority=\"1\" friction=\"{} {} 0.0001\"",
                                 options.finger_friction, options.finger_torsional_friction)));
}

}  // namespace

std::string describe_options(std::size_t bodies, const GraspWorldOptions& options) {
  constexpr std::size_t most_contacts = 420;
  return fmt::format(R"(<mujoco>
<compiler boundmass="1e-6" boundinertia="1e-12"/>
{}<option timestep="{}" cone="elliptic" impratio="10"><flag multiccd="enable"/></option>
<default><geom condim="6" friction="{} {} {}" density="{}"
  solref="0.006 1" solimp="0.95 0.99 0.001"/></default>
)",
                     describe_sizes(bodies, most_contacts), options.time_step,
                     options.object_friction, options.torsional_friction, options.rolling_friction,
                     reference_density);
}

std::string describe_assets(std::span<const WeighedBody> bodies, const ParallelHand& hand) {
  std::string text = "<asset>\n";
  for (std::size_t b = 0; b < bodies.size(); ++b)
    text += describe_hulls(fmt::format("body{}", b), *bodies[b].parts);
  return text + describe_hulls("palm", hand.palm) + describe_hulls("left", hand.finger) +
         describe_hulls("right", turned(hand.finger)) + "</asset>\n";
}

std::string describe_bodies(std::span<const WeighedBody> bodies, std::span<const FixedBox> fixed,
                            const GraspWorldOptions& options) {
  std::string text = describe_fixed(
      fixed, fmt::format("priority=\"1\" friction=\"{} {} {}\"", options.table_friction,
                         options.torsional_friction, options.rolling_friction));
  for (std::size_t b = 0; b < bodies.size(); ++b)
    text += "<body><freejoint/>" + describe_geoms(fmt::format("body{}", b), *bodies[b].parts) +
            "</body>\n";
  return text;
}

std::string describe_palm(const ParallelHand& hand, const GraspWorldOptions& options,
                          const std::string& place) {
  std::string text =
      fmt::format("<body name=\"palm\" {}>", place) +
      describe_geoms("palm", hand.palm,
                     fmt::format("condim=\"3\" priority=\"1\" friction=\"{} 0.005 0.0001\"",
                                 options.palm_friction)) +
      "\n";
  text += describe_finger("left", 1.0, hand.finger, hand, options);
  text += describe_finger("right", -1.0, hand.finger, hand, options);
  return text + "</body>";
}

std::string describe_finger_coupling() {
  return "<equality><joint joint1=\"left\" joint2=\"right\" solref=\"0.01 1\"/></equality>\n";
}

std::string describe_finger_actuators(const ParallelHand& hand) {
  std::string text;
  for (const char* finger : {"left", "right"})
    text += fmt::format(
        "<position joint=\"{}\" kp=\"{}\" forcelimited=\"true\" forcerange=\"-{} {}\"/>\n", finger,
        hand.force / full_force_distance, hand.force, hand.force);
  return text;
}

double closing_control() { return -full_force_distance; }

}  // namespace symscene

#endif
