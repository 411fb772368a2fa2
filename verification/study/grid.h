// Grids of parameters: every combination of the values of several axes.
#pragma once

#include <cmath>
#include <vector>

namespace verify {

// Every item with every one of the values, which `set(value, item)` puts into a copy of it; the values vary fastest.
// Axis after axis, the last one varying fastest, this makes a whole grid out of one item.
template <typename Item, typename Values, typename Set>
[[nodiscard]] std::vector<Item> with_each(const std::vector<Item>& items, const Values& values, const Set& set) {
  std::vector<Item> all;
  for (const Item& item : items)
    for (const auto& value : values) set(value, all.emplace_back(item));
  return all;
}

// From `first` to `last`, both included, in equal ratios as near to `ratio` as goes.
[[nodiscard]] inline std::vector<double> geometric(double first, double last, double ratio) {
  std::vector<double> values;
  const int intervals = static_cast<int>(std::lround(std::log(last / first) / std::log(ratio)));
  for (int i = 0; i <= intervals; ++i)
    values.push_back(first * std::pow(last / first, static_cast<double>(i) / intervals));
  return values;
}

}  // namespace verify
