// 6x6 blocks in single precision, four numbers at a time: for preconditioners, which need few digits, and whose time is
// that of fetching their blocks from memory.
#pragma once

#include <array>
#include <cstddef>

#include "engine/core/types.h"

namespace dda {

// Four numbers that are added and multiplied at once.
using Four = float __attribute__((vector_size(16)));

namespace detail {

template <int a, int b, int c, int d>
Four pick(const Four& one, const Four& other) {
  return __builtin_shufflevector(one, other, a, b, c, d);
}

inline float sum(const Four& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace detail

// Six numbers, and two zeros.
struct SingleSix {
  Four low{}, high{};

  SingleSix() = default;
  template <typename Six>
  explicit SingleSix(const Six& v)
      : low{static_cast<float>(v(0)), static_cast<float>(v(1)), static_cast<float>(v(2)), static_cast<float>(v(3))},
        high{static_cast<float>(v(4)), static_cast<float>(v(5)), 0, 0} {}

  [[nodiscard]] Vec6 to_double() const {
    Vec6 v;
    v << low[0], low[1], low[2], low[3], high[0], high[1];
    return v;
  }
  SingleSix& operator+=(const SingleSix& other) {
    low += other.low, high += other.high;
    return *this;
  }
  SingleSix& operator-=(const SingleSix& other) {
    low -= other.low, high -= other.high;
    return *this;
  }
};

// Twice the six one after another: what two columns of a block are multiplied by, number by number.
using SingleTwelve = std::array<Four, 3>;

inline SingleTwelve twice(const SingleSix& six) {
  return {six.low, detail::pick<0, 1, 4, 5>(six.high, six.low), detail::pick<2, 3, 4, 5>(six.low, six.high)};
}

// A block of 6 x 6 numbers by columns, two of them in three fours.
class SingleBlock {
 public:
  using Fours = std::array<Four, 9>;

  void set_zero() { fours_ = {}; }

  // Takes the values of a dense expression of 6 x 6 numbers.
  template <typename Expression>
  void assign(const Expression& block) {
    Eigen::Matrix<float, 6, 6>::Map(data()) = block.template cast<float>();
  }
  [[nodiscard]] Mat6 to_double() const { return Eigen::Matrix<float, 6, 6>::Map(data()).cast<double>(); }

  SingleBlock& operator+=(const SingleBlock& other) {
    for (std::size_t i = 0; i < fours_.size(); ++i) fours_[i] += other.fours_[i];
    return *this;
  }

  [[nodiscard]] const Fours& fours() const { return fours_; }
  [[nodiscard]] Fours& fours() { return fours_; }
  [[nodiscard]] const float* data() const { return reinterpret_cast<const float*>(fours_.data()); }

  // Column `c`.
  [[nodiscard]] SingleSix column(int c) const {
    const Four* pair = fours_.data() + c / 2 * 3;
    SingleSix six;
    if (c % 2 == 0) {
      six.low = pair[0];
      six.high = detail::pick<0, 1, 4, 5>(pair[1], Four{});
    } else {
      six.low = detail::pick<2, 3, 4, 5>(pair[1], pair[2]);
      six.high = detail::pick<2, 3, 4, 5>(pair[2], Four{});
    }
    return six;
  }

 private:
  float* data() { return reinterpret_cast<float*>(fours_.data()); }

  Fours fours_{};
};

// The columns of a block, each twice: made once where it is multiplied from the left again and again.
class DoubledColumns {
 public:
  explicit DoubledColumns(const SingleBlock& block) {
    for (int c = 0; c < 6; ++c) columns_[static_cast<std::size_t>(c)] = twice(block.column(c));
  }
  [[nodiscard]] const SingleTwelve& operator[](int column) const { return columns_[static_cast<std::size_t>(column)]; }

 private:
  std::array<SingleTwelve, 6> columns_;
};

// result + sign a b^T
template <int sign>
void add_product_transposed(const DoubledColumns& a, const SingleBlock& b, SingleBlock& result) {
  using detail::pick;
  constexpr float factor = sign;
  for (int pair = 0; pair < 3; ++pair) {
    Four* const c = result.fours().data() + 3 * pair;
    Four sum0{}, sum1{}, sum2{};
#pragma GCC unroll 6
    for (int k = 0; k < 6; ++k) {
      const float* const of_b = b.data() + 6 * k + 2 * pair;
      const Four both{of_b[0], of_b[0], of_b[1], of_b[1]};
      sum0 += a[k][0] * pick<0, 0, 0, 0>(both, both);
      sum1 += a[k][1] * both;
      sum2 += a[k][2] * pick<2, 2, 2, 2>(both, both);
    }
    c[0] += factor * sum0, c[1] += factor * sum1, c[2] += factor * sum2;
  }
}

// Six factors as the columns of a block meet them.
class ColumnFactors {
 public:
  explicit ColumnFactors(const SingleSix& x) {
    using detail::pick;
    const auto spread = [this](std::size_t pair, const Four& both) {
      fours_[3 * pair] = pick<0, 0, 0, 0>(both, both);
      fours_[3 * pair + 1] = both;
      fours_[3 * pair + 2] = pick<2, 2, 2, 2>(both, both);
    };
    spread(0, pick<0, 0, 1, 1>(x.low, x.low));
    spread(1, pick<2, 2, 3, 3>(x.low, x.low));
    spread(2, pick<0, 0, 1, 1>(x.high, x.high));
  }

  // block * x
  [[nodiscard]] SingleSix times(const SingleBlock& block) const {
    using detail::pick;
    const auto& b = block.fours();
    SingleTwelve sum;
    for (std::size_t i = 0; i < 3; ++i) sum[i] = b[i] * fours_[i] + b[i + 3] * fours_[i + 3] + b[i + 6] * fours_[i + 6];
    SingleSix product;
    product.low = sum[0] + pick<2, 3, 4, 5>(sum[1], sum[2]);
    product.high = pick<0, 1, 4, 5>(sum[1] + pick<2, 3, 0, 1>(sum[2], sum[2]), Four{});
    return product;
  }

 private:
  SingleBlock::Fours fours_;
};

// Sums block^T x over several blocks; adds up across the fours only at the end.
class TransposedSum {
 public:
  void add(const SingleBlock& block, const SingleSix& x) {
    const SingleTwelve factors = twice(x);
    const auto& b = block.fours();
    for (std::size_t i = 0; i < 9; ++i) fours_[i] += b[i] * factors[i % 3];
  }

  [[nodiscard]] SingleSix total() const {
    const auto first = [this](std::size_t pair) {
      return detail::sum(fours_[3 * pair]) + (fours_[3 * pair + 1][0] + fours_[3 * pair + 1][1]);
    };
    const auto second = [this](std::size_t pair) {
      return (fours_[3 * pair + 1][2] + fours_[3 * pair + 1][3]) + detail::sum(fours_[3 * pair + 2]);
    };
    SingleSix total;
    total.low = Four{first(0), second(0), first(1), second(1)};
    total.high = Four{first(2), second(2), 0, 0};
    return total;
  }

 private:
  SingleBlock::Fours fours_{};
};

}  // namespace dda
