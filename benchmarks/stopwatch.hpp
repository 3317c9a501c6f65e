#pragma once

#include <chrono>
#include <ctime>

namespace symscene {

/// Wall time, and processor time, which does not depend on other programs.
struct Seconds {
  double wall = 0.0;
  double processor = 0.0;  ///< of all threads

  friend Seconds operator+(const Seconds& a, const Seconds& b) {
    return {a.wall + b.wall, a.processor + b.processor};
  }
  friend Seconds operator-(const Seconds& a, const Seconds& b) {
    return {a.wall - b.wall, a.processor - b.processor};
  }
};

inline double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Body>
Seconds seconds(const Body& body) {
  const double processor = processor_seconds();
  const auto start = std::chrono::steady_clock::now();
  body();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), processor_seconds() - processor};
}

}  // namespace symscene
