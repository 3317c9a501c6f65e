#include "faults/faulty_run.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace symscene::testing {
namespace {

namespace fs = std::filesystem;

constexpr unsigned longest_run = 60;  ///< s

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

void redirect(int stream, const char* path) {
  const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(file, stream);
  close(file);
}

/// In the child: becomes the command.
[[noreturn]] void become_command(const fs::path& folder, const std::string& line,
                                 const std::string& fault, const fs::path& streams) {
  std::vector<std::string> words = words_of(line);
  words.insert(words.begin(), SYMSCENE_COMMAND);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  redirect(STDOUT_FILENO, "/dev/null");
  redirect(STDERR_FILENO, (streams / "err").c_str());
  setenv("SYMSCENE_FAULT", fault.c_str(), 1);
  setenv("SYMSCENE_FAULT_COUNTS", (streams / "counts").c_str(), 1);
  setenv("LD_PRELOAD", SYMSCENE_FAULT_SHIM, 1);
  alarm(longest_run);
  if (chdir(folder.c_str()) == 0) execv(SYMSCENE_COMMAND, arguments.data());
  _exit(127);
}

}  // namespace

Files files_below(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (entry.is_directory())
      files[name + "/"] = "";
    else
      files[name] = contents(entry.path());
  }
  return files;
}

void restore_files(const fs::path& folder, const Files& files) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const auto& [name, bytes] : files) {
    if (name.back() == '/')
      fs::create_directories(folder / name);
    else
      std::ofstream(folder / name, std::ios::binary) << bytes;
  }
}

FaultyRun run_with_fault(const fs::path& folder, const std::string& line, Kind kind,
                         std::uint64_t call) {
  const fs::path streams = folder.string() + ".streams";
  fs::create_directories(streams);
  std::ofstream(streams / "counts", std::ios::binary) << std::string(sizeof(CallCounts), '\0');
  const std::string fault =
      std::string(kinds[static_cast<std::size_t>(kind)]) + " " + std::to_string(call);
  const pid_t process = fork();
  if (process == 0) become_command(folder, line, fault, streams);
  int status = 0;
  waitpid(process, &status, 0);
  FaultyRun run;
  if (WIFEXITED(status)) run.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  run.err = contents(streams / "err");
  const std::string counts = contents(streams / "counts");
  std::memcpy(run.counts.data(), counts.data(), std::min(sizeof(CallCounts), counts.size()));
  return run;
}

}  // namespace symscene::testing
