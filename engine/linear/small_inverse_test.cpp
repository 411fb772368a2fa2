#include "engine/linear/small_inverse.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

namespace dda {
namespace {

// A random block whose unknowns have units: lengths, and strains of a block of a centimetre.
Mat6 positive_definite(unsigned seed) {
  std::srand(seed);
  const Mat6 random = Mat6::Random();
  const Vec6 units(Vec6::Ones().eval().array() * (Vec6() << 1, 1, 1e-2, 1e-2, 1e-2, 1e-2).finished().array());
  return units.asDiagonal() * (random * random.transpose() + 0.1 * Mat6::Identity()) * units.asDiagonal();
}

TEST(SmallInverse, InvertsAndIsSymmetricToTheLastBit) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const Mat6 block = positive_definite(seed);
    Mat6 inverse;
    ASSERT_TRUE(invert_block(block, inverse));
    const Mat6 expected = block.inverse();
    const Mat6 scale = expected.diagonal().cwiseSqrt() * expected.diagonal().cwiseSqrt().transpose();
    EXPECT_LE((inverse - expected).cwiseQuotient(scale).cwiseAbs().maxCoeff(), 1e-12) << "condition up to 1e3";
    EXPECT_EQ(inverse, inverse.transpose());
  }
}

TEST(SmallInverse, RefusesWhatIsNotPositiveDefinite) {
  Mat6 inverse;
  Mat6 block = positive_definite(1);
  block(5, 5) = -block(5, 5);
  EXPECT_FALSE(invert_block(block, inverse));
  const Vec6 row = Vec6::LinSpaced(1, 2);
  EXPECT_FALSE(invert_block(row * row.transpose(), inverse)) << "singular";
  block(5, 5) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(invert_block(block, inverse));
}

}  // namespace
}  // namespace dda
