#pragma once

// The subcommands in the order of --help. A new subcommand needs a file that defines add_NAME() and
// a line here.
#define SYMSCENE_SUBCOMMANDS(SUBCOMMAND) \
  SUBCOMMAND(calibrate)                  \
  SUBCOMMAND(reconstruct)                \
  SUBCOMMAND(stitch)                     \
  SUBCOMMAND(segment)                    \
  SUBCOMMAND(watch)                      \
  SUBCOMMAND(masks)                      \
  SUBCOMMAND(grasp)                      \
  SUBCOMMAND(plan)                       \
  SUBCOMMAND(cylinders)                  \
  SUBCOMMAND(next_view)                  \
  SUBCOMMAND(symmetry)                   \
  SUBCOMMAND(view)                       \
  SUBCOMMAND(export)                     \
  SUBCOMMAND(info)                       \
  SUBCOMMAND(options)                    \
  SUBCOMMAND(help)                       \
  SUBCOMMAND(completion)                 \
  SUBCOMMAND(manual)

// Those of the evaluation's wing. The simulation's need SYMSCENE_BUILD_SIMULATION or
// SYMSCENE_BUILD_EVALUATION, the others SYMSCENE_BUILD_EVALUATION.
#define SYMSCENE_SIMULATION_SUBCOMMANDS(SUBCOMMAND) \
  SUBCOMMAND(simulate)                              \
  SUBCOMMAND(pick)
#define SYMSCENE_EVALUATION_SUBCOMMANDS(SUBCOMMAND) \
  SUBCOMMAND(explore)                               \
  SUBCOMMAND(dataset)                               \
  SUBCOMMAND(evaluate)

namespace symscene::app {

struct CommandLine;

// add_NAME() adds its subcommand to the command line; parsing the line runs it.
#define SYMSCENE_DECLARE_SUBCOMMAND(name) void add_##name(CommandLine& line);
SYMSCENE_SUBCOMMANDS(SYMSCENE_DECLARE_SUBCOMMAND)
SYMSCENE_SIMULATION_SUBCOMMANDS(SYMSCENE_DECLARE_SUBCOMMAND)
SYMSCENE_EVALUATION_SUBCOMMANDS(SYMSCENE_DECLARE_SUBCOMMAND)
#undef SYMSCENE_DECLARE_SUBCOMMAND

}  // namespace symscene::app
