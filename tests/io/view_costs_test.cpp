#include "io/view_costs.hpp"

#include <limits>

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

TEST(ViewCosts, AreNumbersBetweenWhiteSpace) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(parse_view_costs("0 1.5\r\n+2e3\tinf\n1e9", "c.txt"),
            (std::vector<double>{0.0, 1.5, 2000.0, infinity, 1e9}));
  EXPECT_TRUE(parse_view_costs(" \n", "c.txt").empty());
}

TEST(ViewCosts, OtherWordsAreRefused) {
  for (const std::string word : {"near", "-1", "1e10", "nan", "-inf", "infinity", "0x10", "1,2"})
    EXPECT_EQ(refusal([&] { parse_view_costs("1 " + word + " 2", "c.txt"); }),
              "c.txt: expected numbers from 0 to 1e9, or inf, found \"" + word + "\"");
  EXPECT_THROW(parse_view_costs(std::string("5\0x", 3), "c.txt"), InputError)
      << "a number does not end where a byte is zero";
}

}  // namespace
}  // namespace symscene
