// Which runs are worth their cost.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace verify {

struct CostAndError {
  double cost = 0;
  double error = 0;
};

// Indices of the points than which none is both cheaper (or as cheap) and better (or as good), cheapest first.
[[nodiscard]] std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

// Index of the cheapest point whose error is at most `error`.
[[nodiscard]] std::optional<std::size_t> cheapest(const std::vector<CostAndError>& points, double error);

}  // namespace verify
