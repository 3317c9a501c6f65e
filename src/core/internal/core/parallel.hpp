#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace symscene {

/// Runs body(i) for i in [0, count), each in its own task: for few items of unequal cost.
template <class Body>
void parallel_for_each(std::size_t count, const Body& body) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
      },
      tbb::simple_partitioner());
}

/// Runs body(begin, end) on blocks of [0, count) that do not depend on the number of threads.
template <class Body>
void parallel_for_blocks(std::size_t count, std::size_t block, const Body& body) {
  parallel_for_each((count + block - 1) / block,
                    [&](std::size_t b) { body(b * block, std::min(count, (b + 1) * block)); });
}

/// Maps fixed blocks of [0, count) to values and combines them in order: the same bits for any
/// number of threads.
template <class Value, class Map, class Combine>
Value reduce_blocks(std::size_t count, std::size_t block, Value identity, const Map& map,
                    const Combine& combine) {
  std::vector<Value> partial((count + block - 1) / block, identity);
  parallel_for_each(partial.size(), [&](std::size_t b) {
    partial[b] = map(b * block, std::min(count, (b + 1) * block));
  });
  Value result = identity;
  for (const Value& value : partial) result = combine(result, value);
  return result;
}

}  // namespace symscene
