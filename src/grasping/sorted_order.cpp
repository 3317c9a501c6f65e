#include "sorted_order.hpp"

#include <array>
#include <utility>

namespace symscene {
namespace {

constexpr int digit_bits = 11;

struct Entry {
  std::uint64_t key;
  Index index;

  std::size_t digit(int shift) const { return (key >> shift) & ((1U << digit_bits) - 1U); }
};

/// Sorts by one digit, the others stay in their order.
void sort_by_digit(const std::vector<Entry>& from, int shift, std::vector<Entry>& to) {
  std::array<std::size_t, std::size_t{1} << digit_bits> next{};
  for (const Entry& entry : from) ++next[entry.digit(shift)];
  std::size_t begin = 0;
  for (std::size_t& place : next) place = std::exchange(begin, begin + place);
  for (const Entry& entry : from) to[next[entry.digit(shift)]++] = entry;
}

}  // namespace

std::vector<Index> sorted_order(const std::vector<std::uint64_t>& keys) {
  std::vector<Entry> entries(keys.size());
  std::uint64_t all_bits = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    entries[i] = {keys[i], static_cast<Index>(i)};
    all_bits |= keys[i];
  }
  std::vector<Entry> sorted(keys.size());
  for (int shift = 0; shift < 64 && all_bits >> shift != 0; shift += digit_bits) {
    sort_by_digit(entries, shift, sorted);
    std::swap(entries, sorted);
  }
  std::vector<Index> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = entries[i].index;
  return order;
}

}  // namespace symscene
