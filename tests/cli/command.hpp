#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace symscene::testing {

namespace fs = std::filesystem;

inline std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// Exit code and output of a run of the command.
struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// A temporary folder in which the command runs.
class Workspace {
 public:
  Workspace() : folder_(fs::temp_directory_path() / ("symscene-cli-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~Workspace() { fs::remove_all(folder_); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  fs::path operator/(const std::string& name) const { return folder_ / name; }
  const fs::path& folder() const { return folder_; }

  /// Runs `symscene ARGUMENTS`, a line for the shell, in the folder. `output` receives its standard
  /// output.
  Outcome run(const std::string& arguments, fs::path output = {}) const {
    const fs::path streams = folder_.string() + ".streams";
    fs::create_directories(streams);
    if (output.empty()) output = streams / "out";
    const std::string line = "cd '" + folder_.string() + "' && '" SYMSCENE_COMMAND "' " +
                             arguments + " > '" + output.string() + "' 2> '" +
                             (streams / "err").string() + "'";
    const int status = std::system(line.c_str());
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(streams / "out"),
                    contents(streams / "err")};
    fs::remove_all(streams);
    return outcome;
  }

 private:
  fs::path folder_;
};

}  // namespace symscene::testing
