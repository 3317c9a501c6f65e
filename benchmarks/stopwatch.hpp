#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

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

/// The quantile of the values; 0 without values.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  const auto at = values.begin() + std::min(rank, static_cast<std::ptrdiff_t>(values.size()) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace symscene
