#pragma once

#include <string>

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include "symscene/core/error.hpp"
#include "symscene/core/stage_timer.hpp"
#include "symscene/core/thread_limit.hpp"

namespace symscene::python {

namespace py = pybind11;

/// How long work of the library is run: what it calls when a stage begins, and its threads.
class Running {
 public:
  /// `progress` is None or takes the name of a stage. Throws InputError for another value, or if
  /// `threads` is negative (0: all cores).
  Running(py::object progress, int threads) : progress_(std::move(progress)), threads_(threads) {
    if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0)
      throw InputError("progress", "a function that takes the name of a stage, or None",
                       "a value that cannot be called");
    if (threads < 0)
      throw InputError("threads", "a number of at least 0", fmt::format("{}", threads));
  }

  /// For a stage timer; refers to this. What the callback raises, and Ctrl-C, ends the work.
  StageTimer::OnBegin on_begin() const {
    return [this](const std::string& stage) { begin(stage); };
  }

  /// Runs `work` while other threads of Python run too.
  template <class Work>
  auto without_gil(const Work& work) const {
    const py::gil_scoped_release released;
    const ThreadLimit limit(static_cast<std::size_t>(threads_));
    return work();
  }

 private:
  void begin(const std::string& stage) const {
    const py::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress_.is_none()) progress_(stage);
  }

  py::object progress_;
  int threads_;
};

}  // namespace symscene::python
