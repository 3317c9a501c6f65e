#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "core/naming.hpp"
#include "counted.hpp"
#include "io/ply.hpp"
#include "session.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/simulation/scanned_models.hpp"
#include "symscene/simulation/simulation.hpp"
#include "symscene/simulation/sweep.hpp"

namespace symscene::app {
namespace {

/// Options of a fused scene, in the groups of a configuration file.
struct FusedSceneOptions {
  SimulationOptions scan;
  DropOptions drop;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    SimulationOptions::visit_fields(self.scan, visit);
    visit("drop", self.drop);
  }
  void validate() const {
    scan.validate();
    drop.validate();
  }
};

/// Writes a fused scene or, with --sequence, the depth frames of a sweep.
struct Simulate {
  SharedOptions shared;
  FusedSceneOptions fused;
  SweepOptions sweep;
  bool sequence = false;
  std::filesystem::path meshes;
  std::filesystem::path symmetries;
  std::optional<int> objects;
  std::optional<int> frames;
  std::optional<std::uint64_t> seed;

  TabletopOptions& tabletop() { return sequence ? sweep.tabletop : fused.scan.tabletop; }
  CameraArcOptions& camera() { return sequence ? sweep.camera : fused.scan.camera; }
  const DropOptions& drop() const { return sequence ? sweep.drop : fused.drop; }

  OptionFields configure() {
    const auto apply_flags = [&] {
      tabletop().objects = objects.value_or(tabletop().objects);
      tabletop().seed = seed.value_or(tabletop().seed);
      camera().frames = frames.value_or(camera().frames);
    };
    return sequence ? configure_options(sweep, shared.config, apply_flags)
                    : configure_options(fused, shared.config, apply_flags);
  }

  /// A table with scanned meshes that were dropped onto it, or with arranged household objects.
  Tabletop furnish(Session& session, StageTimer& timer) {
    if (meshes.empty()) {
      if (!symmetries.empty())
        throw InputError("--symmetries", "--meshes, to which the symmetries belong", "none");
      return timer.time("arrange", [&] { return arrange_tabletop(tabletop()); });
    }
    const ModelFolder folder = timer.time("read", [&] { return read_models(meshes, symmetries); });
    session.warn(folder.warnings);
    return timer.time("drop", [&] {
      return naming(meshes, [&] { return drop_tabletop(folder.models, tabletop(), drop()); });
    });
  }

  void scan_table(const OptionFields& fields, Session& session, StageTimer& timer) {
    const Tabletop table = furnish(session, timer);
    session.warn(table.warnings);
    const SimulatedScene simulated = timer.time("simulate", [&] {
      return fuse_frames(table, capture_frames(table, fused.scan), fused.scan);
    });
    timer.time("write", [&] {
      write_scene(absolute(shared.output), simulated.scene,
                  {.scene_json = describe_run("simulate", fields),
                   .truth_json = format_truth(simulated.truth)});
    });
    const Index points = simulated.scene.cloud.size();
    const std::size_t count = simulated.truth.objects.size();
    session.print_line(
        fmt::format("{}: {}, {} points", shared.output.string(), counted(count, "object"), points));
    session.finish({{"output", shared.output}, {"objects", count}, {"points", points}},
                   timer.stages());
  }

  void sweep_table(const OptionFields& fields, Session& session, StageTimer& timer) {
    SequenceWriter writer(absolute(shared.output), sweep.camera.intrinsics());
    const Tabletop table = furnish(session, timer);
    session.warn(table.warnings);
    timer.time("frames", [&] {
      int number = 0;
      capture_sweep(table, sweep, [&](const DepthFrame& frame, const Eigen::Isometry3d& pose) {
        session.on_begin()(fmt::format("frame {} of {}", ++number, sweep.camera.frames));
        writer.add(frame, &pose);
      });
    });
    timer.time("write", [&] {
      write_truth_files(table, writer);
      writer.add_file("sequence.json", describe_run("simulate", fields));
      writer.finish();
    });
    const std::size_t count = table.objects.size();
    const auto taken = static_cast<std::uint64_t>(sweep.camera.frames);
    session.print_line(fmt::format("{}: {}, {}", shared.output.string(), counted(count, "object"),
                                   counted(taken, "frame")));
    session.finish({{"output", shared.output}, {"objects", count}, {"frames", taken}},
                   timer.stages());
  }

  /// The ground truth and the meshes that it names.
  static void write_truth_files(const Tabletop& table, SequenceWriter& writer) {
    const SceneTruth truth = tabletop_truth(table);
    for (std::size_t k = 0; k < table.objects.size(); ++k) {
      writer.add_file(fmt::format("meshes/{}.ply", truth.objects[k].mesh),
                      format_ply(table.objects[k].object.mesh));
    }
    writer.add_file("truth.json", format_truth(truth));
  }

  void run() {
    const OptionFields fields = configure();
    if (!meshes.empty()) require_not_input(shared.output, meshes);
    Session session("simulate", shared);
    StageTimer timer(session.on_begin());
    sequence ? sweep_table(fields, session, timer) : scan_table(fields, session, timer);
  }
};

}  // namespace

void add_simulate(CommandLine& line) {
  const auto state = std::make_shared<Simulate>();
  Arguments arguments(line, "simulate",
                      "Scan a simulated table with objects, with its ground truth",
                      "symscene simulate -o scene --objects 6 --seed 1\n"
                      "  symscene simulate --sequence -o sweep --meshes ycb --seed 2");
  arguments.output_folder(state->shared, "scene or sequence folder to write");
  arguments.flag("--sequence", state->sequence,
                 "write the noisy depth frames of a hand-held sweep instead of a fused scene");
  arguments.folder("--meshes", state->meshes,
                   "drop the meshes of this folder onto the table instead of household objects");
  arguments.file("--symmetries", state->symmetries, "JSON file with the symmetries of the meshes");
  arguments.count("--objects", state->objects, range_of(state->fused, "tabletop.objects"),
                  fmt::format("number of objects (default {})", state->tabletop().objects));
  arguments.count("--frames", state->frames, range_of(state->sweep, "camera.frames"),
                  fmt::format("number of frames (default {}, with --sequence {})",
                              state->fused.scan.camera.frames, state->sweep.camera.frames));
  arguments.seed(state->seed, state->tabletop().seed);
  arguments.run_stages(state);
  const auto sweep = std::make_shared<Simulate>();
  sweep->sequence = true;
  arguments.config_with("--sequence", [sweep] { return sweep->configure(); });
}

}  // namespace symscene::app
