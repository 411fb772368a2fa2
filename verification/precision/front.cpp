#include "verification/precision/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace verify {

std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(points[i].error < best)) continue;
    best = points[i].error;
    front.push_back(i);
  }
  return front;
}

std::optional<std::size_t> cheapest(const std::vector<CostAndError>& points, double error) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].error <= error && (!found || points[i].cost < points[*found].cost)) found = i;
  return found;
}

}  // namespace verify
