#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "io/option_fields.hpp"

namespace {

/// Options of every kind.
struct AllKinds {
  struct Group {
    double size = 0.5;
    std::uint64_t seed = 1;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
      visit("size", self.size, "m", symscene::above(0.0), "a length");
      visit("seed", self.seed, "", symscene::any_value(), "a seed");
    }
  };
  int count = 3;
  bool flag = true;
  std::string path;
  Group group;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("count", self.count, "", symscene::between(0, 10), "a number");
    visit("flag", self.flag, "", symscene::any_value(), "a choice");
    visit("path", self.path, "", symscene::any_value(), "a file");
    visit("group", self.group);
  }
};

}  // namespace

/// Any bytes are a configuration file that sets options within their ranges, or refused. The values
/// that it sets are a configuration file that sets the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string text(fuzz::as_bytes(data, size));
  AllKinds options;
  const OptionFields fields = option_fields(options);
  const auto read = fuzz::accepted([&] {
    parse_config(text, "fuzz", fields);
    return true;
  });
  if (!read) return 0;
  if (options.count < 0 || options.count > 10 || !(options.group.size > 0.0)) std::abort();
  const std::string values = option_values(fields);
  AllKinds again;
  const OptionFields fields_again = option_fields(again);
  parse_config(values, "again", fields_again);
  if (option_values(fields_again) != values) std::abort();
  return 0;
}
