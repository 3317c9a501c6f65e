#include "core/dispatch.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace symscene {
namespace {

/// The loop under test, inlined into both functions.
inline void multiply_add(const float* a, const float* b, float* out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out[i] = a[i] * b[i] + 1.0F / (b[i] + 2.0F);
}

SYMSCENE_MULTIVERSION void multiversioned(const float* a, const float* b, float* out,
                                          std::size_t count) {
  multiply_add(a, b, out, count);
}

void baseline(const float* a, const float* b, float* out, std::size_t count) {
  multiply_add(a, b, out, count);
}

TEST(Dispatch, AVectorisedLoopGivesTheBitsOfTheBaseline) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<float> value(-1.0F, 1.0F);
  for (const std::size_t count : {0U, 1U, 7U, 16U, 33U, 1003U}) {
    std::vector<float> a(count);
    std::vector<float> b(count);
    for (float& v : a) v = value(generator);
    for (float& v : b) v = value(generator);
    std::vector<float> fast(count);
    std::vector<float> plain(count);
    multiversioned(a.data(), b.data(), fast.data(), count);
    baseline(a.data(), b.data(), plain.data(), count);
    EXPECT_EQ(fast, plain);
  }
}

}  // namespace
}  // namespace symscene
