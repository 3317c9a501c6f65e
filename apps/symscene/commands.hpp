#pragma once

namespace CLI {
class App;
}

namespace symscene::app {

// Each adds its subcommand, which runs as the command line is parsed.
void add_simulate(CLI::App& app);
void add_dataset(CLI::App& app);
void add_reconstruct(CLI::App& app);
void add_stitch(CLI::App& app);
void add_segment(CLI::App& app);
void add_symmetry(CLI::App& app);
void add_evaluate(CLI::App& app);
void add_view(CLI::App& app);
void add_info(CLI::App& app);

}  // namespace symscene::app
