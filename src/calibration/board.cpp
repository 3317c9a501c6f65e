#include <fmt/format.h>

#include "symscene/calibration/intrinsic_calibration.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

void Board::validate() const {
  constexpr int least = 3, most = 60;
  for (const int count : {columns, rows}) {
    if (count >= least && count <= most) continue;
    throw InputError("board", fmt::format("{} to {} corners along each edge", least, most),
                     fmt::format("{}x{}", columns, rows));
  }
  if (!(square > 0.0 && square < 10.0))
    throw InputError("board", "squares of a size above 0 m", fmt::format("{} m", square));
}

}  // namespace symscene
