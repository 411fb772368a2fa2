#include "verification/precision/front.h"

#include <gtest/gtest.h>

#include <limits>

namespace verify {
namespace {

using Indices = std::vector<std::size_t>;

TEST(ParetoFront, LeavesOutWhatIsBeatenInBoth) {
  EXPECT_EQ(pareto_front({{4, 1}, {1, 8}, {2, 3}, {3, 5}, {8, 0.5}}), (Indices{1, 2, 0, 4}));
}

TEST(ParetoFront, OfEqualCostTheBetterAndOfEqualErrorTheCheaper) {
  EXPECT_EQ(pareto_front({{1, 5}, {1, 4}, {2, 4}, {3, 3}, {3, 3}}), (Indices{1, 3}));
}

TEST(ParetoFront, NothingWithoutAnError) {
  EXPECT_EQ(pareto_front({{1, std::numeric_limits<double>::quiet_NaN()}, {2, 1}}), (Indices{1}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(Cheapest, OfThoseGoodEnough) {
  const std::vector<CostAndError> points = {{1, 0.1}, {5, 0.001}, {3, 0.01}, {2, 0.02}};
  EXPECT_EQ(cheapest(points, 0.01), 2U);
  EXPECT_EQ(cheapest(points, 1), 0U);
  EXPECT_FALSE(cheapest(points, 1e-4));
}

}  // namespace
}  // namespace verify
