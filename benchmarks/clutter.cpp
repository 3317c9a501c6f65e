// The clutter-removal benchmark of VGN, GIGA and Edge-Grasp: objects are removed from a table one
// by one, with a hand in a physics simulation.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "program.hpp"
#include "symscene/clutter/clutter_gallery.hpp"
#include "symscene/clutter/clutter_report.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/physics/physics_world.hpp"

namespace {

using namespace symscene;

struct Arguments {
  std::string objects;
  std::string share = "all";
  std::string kind = "packed";
  std::string method = "symscene";
  std::string table = "scale";
  std::string completion = "on";
  std::string attempts;
  std::string gallery;
  int rounds = 100;
  int first = 0;
  std::size_t threads = 2;
  bool verbose = false;
  ClutterRoundOptions options;

  void finish() {
    options.kind = parse_clutter_kind(kind);
    options.method = parse_grasp_method(method);
    options.planning.table = parse_table_knowledge(table);
    if (completion == "off" && options.method != GraspMethod::symscene)
      throw InputError("--completion off", "--method symscene", method);
    options.planning.pipeline.complete_by_symmetry = completion == "on";
  }
};

void declare(CLI::App& app, Arguments& a) {
  app.add_option("--objects", a.objects, "folder with NAME.urdf, its surface and convex parts")
      ->required();
  app.add_option("--share", a.share, "objects by the hash of their name: all, fitting, held-out")
      ->capture_default_str();
  app.add_option("--scene", a.kind, "packed or pile")->capture_default_str();
  app.add_option("--rounds", a.rounds, "rounds")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--first", a.first, "number of the first round")->capture_default_str();
  app.add_option("--seed", a.options.seed, "seed of all rounds")->capture_default_str();
  app.add_option("--count", a.options.objects, "objects per scene")->capture_default_str();
  app.add_option("--rehearsals", a.options.rehearsals,
                 "proposals drawn at random that are tried and undone before each attempt; for "
                 "--attempts only")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--rehearse-best", a.options.rehearse_best,
               "the best grasp of each object is tried and undone before each attempt; the report "
               "shows their success by occlusion");
  app.add_option("--views", a.options.views, "1 from the side, or several around")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--method", a.method, "symscene, cylinders, true-meshes, antipodal or random")
      ->capture_default_str();
  app.add_option("--table", a.table,
                 "what is known of the table: none, plane, or scale (depths are scaled so that "
                 "they show it there)")
      ->capture_default_str();
  app.add_option(
         "--completion", a.completion,
         "hidden sides of method symscene: on (inferred from the symmetries) or off (closed "
         "surfaces end at the visible hull)")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  app.add_flag("!--exact", a.options.noise.enabled, "depth images without noise");
  app.add_flag("!--anywhere", a.options.planning.in_volume_only,
               "allow grasps outside the benchmark's grasp volume");
  app.add_option("--attempts", a.attempts, "CSV file to write: one line per attempt");
  app.add_option("--gallery", a.gallery,
                 "folder to write: index.html with an image of each failed attempt");
  app.add_option("--threads", a.threads, "at most so many threads")->capture_default_str();
  app.add_flag("-v,--verbose", a.verbose, "one line per attempt");
}

void print_attempt(const ClutterAttempt& a) {
  fmt::print(
      "round {:3} attempt {:2}: {} ({:.0f} % hidden), {} seen of {}, {} of quality {:.2f}: {}",
      a.round, a.number, a.aimed, 100.0 * a.occlusion, a.seen, a.present, to_string(a.grasp.source),
      a.grasp.quality, to_string(a.outcome.end));
  if (a.outcome.contact != ApproachContact::none)
    fmt::print(", touched {} {:.0f} mm before", to_string(a.outcome.contact),
               1e3 * a.outcome.short_by);
  if (a.penetration > 0.0) fmt::print(", {:.1f} mm in others", 1e3 * a.penetration);
  fmt::print(", {:.0f} and {:.0f} mm wide\n", 1e3 * a.outcome.closed_width, 1e3 * a.outcome.width);
  std::fflush(stdout);
}

/// Collects the images of failed attempts.
class Gallery {
 public:
  explicit Gallery(const std::filesystem::path& folder) : folder_(folder) {
    if (!folder_.empty()) std::filesystem::create_directories(folder_);
  }

  void before(const ClutterWorld& world, const GraspProposals& proposals) {
    if (!folder_.empty() && !proposals.grasps.empty())
      image_ = grasp_image(world, proposals.grasps.front());
  }

  void after(const ClutterAttempt& attempt) {
    if (folder_.empty() || attempt.outcome.end == GraspEnd::success) return;
    const std::string name = fmt::format("round{}_attempt{}.png", attempt.round, attempt.number);
    write_file_atomically(folder_ / name, format_png(image_));
    entries_.push_back({name, attempt});
  }

  void finish(const std::string& title) const {
    if (!folder_.empty())
      write_file_atomically(folder_ / "index.html", format_gallery(title, entries_));
  }

 private:
  std::filesystem::path folder_;
  ColorImage image_;
  std::vector<GalleryEntry> entries_;
};

void print_round(const ClutterRound& round) {
  fmt::print("  {}, {} of {} removed; left: {}; reasons: {}; grasps outside the volume: {}\n",
             to_string(round.end), round.removed, round.placed, fmt::join(round.left_objects, ", "),
             fmt::join(round.reasons, ", "), round.outside);
}

int run(const Arguments& arguments) {
  if (!has_physics()) {
    fmt::print(stderr, "this build has no physics: libmujoco-dev would add it\n");
    return 1;
  }
  const ThreadLimit limit(arguments.threads);
  const std::vector<ClutterObject> objects =
      read_clutter_objects(arguments.objects, parse_object_share(arguments.share));
  const std::string run_name = fmt::format(
      "{} objects ({}), {}, {} rounds of {}, {} view(s), method {}, table {}, "
      "completion {}, seed {}",
      objects.size(), arguments.share, arguments.kind, arguments.rounds, arguments.options.objects,
      arguments.options.views, arguments.method, arguments.table, arguments.completion,
      arguments.options.seed);
  fmt::print("{}\n", run_name);
  Gallery gallery(arguments.gallery);
  ClutterObserver observer;
  observer.before = [&](const ClutterWorld& world, std::span<const ClutterView>,
                        const GraspProposals& proposals) { gallery.before(world, proposals); };
  observer.after = [&](const ClutterAttempt& attempt) {
    gallery.after(attempt);
    if (arguments.verbose) print_attempt(attempt);
  };
  std::vector<ClutterRound> rounds;
  for (int round = arguments.first; round < arguments.first + arguments.rounds; ++round) {
    rounds.push_back(run_clutter_round(objects, arguments.options, round, observer));
    if (arguments.verbose) print_round(rounds.back());
  }
  fmt::print("{}", format_clutter_report(rounds));
  if (!arguments.attempts.empty())
    write_file_atomically(arguments.attempts, format_attempts_csv(rounds));
  gallery.finish("Failed grasps: " + run_name);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Clutter removal by grasping, in a physics simulation");
  declare(app, arguments);
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_clutter", [&] {
    arguments.finish();
    return run(arguments);
  });
}
