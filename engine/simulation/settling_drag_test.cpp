// What a static stage takes to be loose: what goes far under drag, and not what others carry.
#include "engine/simulation/settling_drag.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

// A block of 1 m.
BlockTerms one_block() {
  BlockTerms terms;
  terms.area = {1.0};
  return terms;
}

Eigen::VectorXd moved_by(double way) {
  Eigen::VectorXd d = Eigen::VectorXd::Zero(6);
  d(1) = way;
  return d;
}

// Whether the block is loose after a hundred steps, in each of which it would go by `first` (m), and with more drag by
// `second`.
bool is_loose(double first, double second) {
  const BlockTerms terms = one_block();
  SettlingDrag drag;
  for (int step = 0; step < 100; ++step) {
    drag.ease();
    EXPECT_TRUE(drag.raise(terms, {}, moved_by(first)));
    drag.raise(terms, {}, moved_by(second));
    drag.follow(terms, moved_by(second));
  }
  return !drag.loose().empty();
}

TEST(SettlingDrag, WhatItHoldsBackIsLooseOnceItHasGoneHalfOfItsSize) { EXPECT_TRUE(is_loose(2, 0.015)); }

// A splinter between blocks that sink goes with them, by many times its size a step.
TEST(SettlingDrag, WhatOthersCarryIsNotLoose) { EXPECT_FALSE(is_loose(2, 1.9)); }

}  // namespace
}  // namespace dda
