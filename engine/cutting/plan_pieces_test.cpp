#include "engine/cutting/plan_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "engine/cutting/cutting_test_support.h"

namespace dda {
namespace {

std::int64_t largest_coordinate(const PlanPieces& pieces) {
  std::int64_t largest = 0;
  for (const Piece& piece : pieces.pieces)
    for (const Pixel& end : {piece.segment.from, piece.segment.to})
      largest = std::max({largest, std::abs(end.x), std::abs(end.y)});
  return largest;
}

// Exact arithmetic on the grid needs coordinates below 2^40, and a tolerance may be anything: whether any rock is left
// then is found out later.
TEST(PlanPieces, EndsThatAToleranceProlongsStayOnTheGrid) {
  RockPlan plan = square_plan(6);
  add_line(plan, {{1, 1}, {5, 2}});
  add_line(plan, {{0, 3}, {6, 3}});
  for (const double tolerance : {1e-6, 1.0, 5.0, 4e6, 1e12})
    EXPECT_LT(largest_coordinate(pieces_of(plan, tolerance)), std::int64_t{1} << 40) << tolerance;
}

}  // namespace
}  // namespace dda
