#include "core/process_pool.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <deque>
#include <system_error>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace symscene {
namespace {

constexpr std::size_t longest_text = 60000;
constexpr char mark_done = '+';
constexpr char mark_failed = '-';

/// Makes this process end when its parent does.
void end_with_parent(pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
  if (getppid() != parent) _exit(1);
}

bool send_packet(int socket, const std::string& bytes) {
  return send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
         static_cast<ssize_t>(bytes.size());
}

/// Receives a packet; empty if the other side has closed.
std::string receive_packet(int socket) {
  std::string bytes(longest_text + 1, '\0');
  ssize_t size = 0;
  do {
    size = recv(socket, bytes.data(), bytes.size(), 0);
  } while (size < 0 && errno == EINTR);
  bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return bytes;
}

/// Ends the process if the packet cannot be sent; the other side sees the closed socket.
void send_outcome(int socket, char mark, std::string text) {
  if (text.size() > longest_text) {
    if (mark == mark_done) text = fmt::format("its message exceeds {} bytes", longest_text);
    mark = mark_failed;
    text.resize(std::min(text.size(), longest_text));
  }
  if (!send_packet(socket, mark + text)) _exit(1);
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string describe_end(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("its process was ended by signal {}", WTERMSIG(status));
  return fmt::format("its process ended with code {}", WEXITSTATUS(status));
}

/// Runs the process of one item. Never returns.
[[noreturn]] void do_item(int socket, std::size_t item, const ProcessPool::Work& work,
                          pid_t parent) {
  end_with_parent(parent);
  try {
    send_outcome(socket, mark_done, work(item));
  } catch (const std::exception& error) {
    send_outcome(socket, mark_failed, error.what());
  } catch (...) {
    send_outcome(socket, mark_failed, "an unknown exception");
  }
  _exit(0);
}

/// Runs a worker, which starts a process per item. Both are a group, so that they can be ended
/// together. Never returns.
[[noreturn]] void serve(int socket, const ProcessPool::Work& work, pid_t parent) {
  end_with_parent(parent);
  setpgid(0, 0);
  const pid_t self = getpid();
  for (;;) {
    const std::string packet = receive_packet(socket);
    std::size_t item = 0;
    if (packet.size() != sizeof(item)) _exit(0);
    std::memcpy(&item, packet.data(), sizeof(item));
    const pid_t process = fork();
    if (process == 0) do_item(socket, item, work, self);
    if (process < 0) {
      send_outcome(socket, mark_failed, "the system gives no process for it");
      continue;
    }
    const int status = wait_for(process);
    const bool ended_well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (!ended_well) send_outcome(socket, mark_failed, describe_end(status));
  }
}

sigset_t requests_to_end() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
  return signals;
}

}  // namespace

ProcessPool::ProcessPool(std::size_t processes, const Work& work,
                         std::optional<std::chrono::milliseconds> time_limit)
    : time_limit_(time_limit) {
  try {
    for (std::size_t i = 0; i < processes; ++i) add_worker(work);
  } catch (...) {
    close_workers();
    throw;
  }
}

ProcessPool::~ProcessPool() { close_workers(); }

void ProcessPool::add_worker(const Work& work) {
  std::array<int, 2> sockets{};
  const auto refuse = [] {
    throw InputError("the processes to work in", "another one",
                     std::generic_category().message(errno));
  };
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets.data()) != 0) refuse();
  const pid_t self = getpid();
  const pid_t process = fork();
  if (process == 0) {
    // Open sockets of the other workers would hide from them that this process has ended.
    for (const Worker& other : workers_) close(other.socket);
    close(sockets[0]);
    serve(sockets[1], work, self);
  }
  close(sockets[1]);
  if (process < 0) {
    close(sockets[0]);
    refuse();
  }
  setpgid(process, process);  // whichever of the two comes first
  workers_.push_back({process, sockets[0]});
}

void ProcessPool::close_workers() {
  for (Worker& worker : workers_) {
    if (worker.busy) {
      kill(-worker.process, SIGTERM);
      kill(-worker.process, SIGCONT);  // a stopped process ends when it goes on
    }
    retire(worker);
  }
}

void ProcessPool::retire(Worker& worker) {
  if (worker.process < 0) return;
  close(worker.socket);
  wait_for(worker.process);
  worker = Worker{};
}

bool ProcessPool::give(Worker& worker, std::size_t item) {
  std::string packet(sizeof(item), '\0');
  std::memcpy(packet.data(), &item, sizeof(item));
  worker.item = item;
  worker.begin = std::chrono::steady_clock::now();
  worker.busy = send_packet(worker.socket, packet);
  if (!worker.busy) retire(worker);
  return worker.busy;
}

ItemOutcome ProcessPool::take(Worker& worker) {
  const std::string packet = receive_packet(worker.socket);
  ItemOutcome outcome{worker.item, false, "the process that it was given to was ended"};
  worker.busy = false;
  if (packet.empty()) {
    retire(worker);
    return outcome;
  }
  outcome.done = packet.front() == mark_done;
  outcome.text = packet.substr(1);
  return outcome;
}

/// Until the first item is overdue; -1 without a limit.
int ProcessPool::milliseconds_left(const std::vector<Worker*>& busy) const {
  if (!time_limit_) return -1;
  auto least = *time_limit_;
  for (const Worker* worker : busy)
    least = std::min(least, std::chrono::ceil<std::chrono::milliseconds>(
                                worker->begin + *time_limit_ - std::chrono::steady_clock::now()));
  return static_cast<int>(std::clamp<std::int64_t>(least.count(), 0, 60'000));
}

bool ProcessPool::is_overdue(const Worker& worker) const {
  return time_limit_ && std::chrono::steady_clock::now() - worker.begin >= *time_limit_;
}

ItemOutcome ProcessPool::give_up(Worker& worker) const {
  const double seconds = std::chrono::duration<double>(*time_limit_).count();
  ItemOutcome outcome{
      worker.item, false,
      fmt::format("it was not done within {:g} s, and its process was ended", seconds)};
  kill(-worker.process, SIGKILL);
  retire(worker);
  return outcome;
}

void ProcessPool::run(const std::vector<std::size_t>& items,
                      const std::function<void(const ItemOutcome&)>& on_outcome) {
  std::deque<std::size_t> left(items.begin(), items.end());
  for (;;) {
    for (Worker& worker : workers_) {
      if (worker.process < 0 || worker.busy || left.empty()) continue;
      if (give(worker, left.front())) left.pop_front();
    }
    std::vector<pollfd> waiting;
    std::vector<Worker*> busy;
    for (Worker& worker : workers_) {
      if (!worker.busy) continue;
      waiting.push_back({worker.socket, POLLIN, 0});
      busy.push_back(&worker);
    }
    if (busy.empty()) break;
    if (poll(waiting.data(), waiting.size(), milliseconds_left(busy)) < 0) {
      if (errno == EINTR) continue;
      throw std::system_error(errno, std::generic_category(), "waiting for processes");
    }
    for (std::size_t i = 0; i < busy.size(); ++i) {
      if (waiting[i].revents != 0)
        on_outcome(take(*busy[i]));
      else if (is_overdue(*busy[i]))
        on_outcome(give_up(*busy[i]));
    }
  }
  for (const std::size_t item : left)
    on_outcome({item, false, "no process was left to give it to"});
}

SignalDelay::SignalDelay() {
  const sigset_t signals = requests_to_end();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

SignalDelay::~SignalDelay() {
  const sigset_t signals = requests_to_end();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

}  // namespace symscene
