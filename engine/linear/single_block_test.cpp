// Blocks in single precision against the same in double precision.
#include "engine/linear/single_block.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace dda {
namespace {

// Sums of some forty products of numbers below 1.
constexpr double round_off = 40 * 6e-8;

struct Operands {
  Mat6 a, b, c;
  Vec6 x, y;
  SingleBlock single_a, single_b, single_c;
};

Operands random_operands(unsigned seed) {
  std::srand(seed);
  Operands random{Mat6::Random(), Mat6::Random(), Mat6::Random(), Vec6::Random(), Vec6::Random(), {}, {}, {}};
  random.single_a.assign(random.a);
  random.single_b.assign(random.b);
  random.single_c.assign(random.c);
  return random;
}

TEST(SingleBlock, KeepsItsNumbersToSinglePrecision) {
  const Operands o = random_operands(1);
  EXPECT_LE((o.single_a.to_double() - o.a).cwiseAbs().maxCoeff(), 6e-8);
  SingleBlock transposed;
  transposed.assign(o.a.transpose());
  EXPECT_EQ(transposed.to_double(), o.single_a.to_double().transpose());
  for (int c = 0; c < 6; ++c) EXPECT_EQ(o.single_a.column(c).to_double(), o.single_a.to_double().col(c)) << c;
  EXPECT_LE((SingleSix(o.x).to_double() - o.x).cwiseAbs().maxCoeff(), 6e-8);
}

TEST(SingleBlock, MultipliesBlocks) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Operands o = random_operands(seed);
    const DoubledColumns columns(o.single_a);
    add_product_transposed<1>(columns, o.single_b, o.single_c);
    EXPECT_LE((o.single_c.to_double() - (o.c + o.a * o.b.transpose())).cwiseAbs().maxCoeff(), round_off);
    add_product_transposed<-1>(columns, o.single_b, o.single_c);
    EXPECT_LE((o.single_c.to_double() - o.c).cwiseAbs().maxCoeff(), round_off);
  }
}

TEST(SingleBlock, MultipliesVectorsBothWays) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Operands o = random_operands(seed);
    const SingleSix product = ColumnFactors(SingleSix(o.x)).times(o.single_a);
    EXPECT_LE((product.to_double() - o.a * o.x).cwiseAbs().maxCoeff(), round_off);
    EXPECT_EQ(product.high[2], 0);
    EXPECT_EQ(product.high[3], 0);
    TransposedSum sum;
    sum.add(o.single_a, SingleSix(o.x));
    sum.add(o.single_b, SingleSix(o.y));
    const Vec6 expected = o.a.transpose() * o.x + o.b.transpose() * o.y;
    EXPECT_LE((sum.total().to_double() - expected).cwiseAbs().maxCoeff(), round_off);
    SingleSix difference(o.x);
    difference -= SingleSix(o.y);
    EXPECT_LE((difference.to_double() - (o.x - o.y)).cwiseAbs().maxCoeff(), round_off);
  }
}

}  // namespace
}  // namespace dda
