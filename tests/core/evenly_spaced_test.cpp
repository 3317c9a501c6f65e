#include "core/evenly_spaced.hpp"

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

TEST(EvenlySpaced, ValuesAreThoseThatTablesPrint) {
  EXPECT_EQ(evenly_spaced(0.1, 0.6, 0.1), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}));
  EXPECT_EQ(evenly_spaced(0.005, 0.045, 0.01).back(), 0.045);
  EXPECT_EQ(evenly_spaced(0.004, 0.03, 0.002).size(), 14U);
  EXPECT_THROW(evenly_spaced(0.0, 1.0, 0.0), InputError);
}

}  // namespace
}  // namespace symscene
