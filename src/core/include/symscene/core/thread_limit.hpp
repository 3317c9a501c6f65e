#pragma once

#include <cstddef>
#include <memory>

namespace symscene {

/// Bounds the number of threads that every stage uses, in the whole process, while it lives.
/// Results do not depend on that number.
class ThreadLimit {
 public:
  /// 0 means all cores.
  explicit ThreadLimit(std::size_t threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace symscene
