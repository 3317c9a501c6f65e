#pragma once

#include <cstdint>

namespace symscene {

/// A PCG32 generator (O'Neill 2014) with its own distributions, because those of the standard
/// library differ between implementations. Streams of one seed are independent of each other.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint32_t bits();
  /// The seed of another generator.
  std::uint64_t seed();
  /// In [0, 1).
  double uniform() { return bits() * 0x1.0p-32; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, count).
  std::uint32_t below(std::uint32_t count);
  bool chance(double probability) { return uniform() < probability; }
  /// Normally distributed with mean 0 and standard deviation 1.
  double normal();

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_ = 1;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace symscene
