#include "io/view_costs.hpp"

#include <limits>

#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {

std::vector<double> parse_view_costs(std::string_view text, const std::string& name) {
  constexpr double greatest = 1e9;
  std::vector<double> costs;
  for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
    const std::optional<double> cost =
        word == "inf" ? std::numeric_limits<double>::infinity() : to_number<double>(word);
    const bool is_in_range = cost && *cost >= 0.0 && *cost <= greatest;
    if (word != "inf" && !is_in_range)
      throw InputError(name, "numbers from 0 to 1e9, or inf", in_quotes(word));
    costs.push_back(*cost);
  }
  return costs;
}

}  // namespace symscene
