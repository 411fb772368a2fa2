// What one panel of a BlockMatrix adds to a product, two numbers at a time: every block is fetched once and multiplied
// both ways, and what goes to the panel's own rows is added up across the pairs only at its end.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

namespace dda {

class PanelProduct {
 public:
  // The panel's first number, the distance between its columns, and the six unknowns of its block.
  PanelProduct(const double* panel, int stride, const double* x) : panel_(panel), stride_(stride) {
    for (std::size_t c = 0; c < 6; ++c) x_[c] = Pair{x[c], x[c]};
  }

  // The block `below` blocks under the top: y += B x, and B^T x_row for add_to.
  void couple(int below, const double* x_row, double* y_row) {
    const Pair r0 = load(x_row), r1 = load(x_row + 2), r2 = load(x_row + 4);
    Pair y0 = load(y_row), y1 = load(y_row + 2), y2 = load(y_row + 4);
    const double* column = panel_ + 6 * below;
    for (int line = 0; line < 36; line += 8) __builtin_prefetch(panel_ + 36 * below + prefetched + line);
#pragma GCC unroll 6
    for (std::size_t c = 0; c < 6; ++c, column += stride_) {
      const Pair b0 = load(column), b1 = load(column + 2), b2 = load(column + 4);
      y0 += b0 * x_[c], y1 += b1 * x_[c], y2 += b2 * x_[c];
      transposed_[c] += b0 * r0 + b1 * r1 + b2 * r2;
    }
    store(y0, y_row), store(y1, y_row + 2), store(y2, y_row + 4);
  }

  // The first half of it.
  void scatter(int below, double* y_row) const {
    Pair y0 = load(y_row), y1 = load(y_row + 2), y2 = load(y_row + 4);
    const double* column = panel_ + 6 * below;
    for (std::size_t c = 0; c < 6; ++c, column += stride_)
      y0 += load(column) * x_[c], y1 += load(column + 2) * x_[c], y2 += load(column + 4) * x_[c];
    store(y0, y_row), store(y1, y_row + 2), store(y2, y_row + 4);
  }

  // The second.
  void gather(int below, const double* x_row) {
    const Pair r0 = load(x_row), r1 = load(x_row + 2), r2 = load(x_row + 4);
    const double* column = panel_ + 6 * below;
    for (std::size_t c = 0; c < 6; ++c, column += stride_)
      transposed_[c] += load(column) * r0 + load(column + 2) * r1 + load(column + 4) * r2;
  }

  // What the panel's own block gets: its diagonal block, which holds both of its triangles, times x, and all B^T x_row.
  void add_to(double* y) const {
    Pair y0 = load(y), y1 = load(y + 2), y2 = load(y + 4);
    const double* column = panel_;
    for (std::size_t c = 0; c < 6; ++c, column += stride_)
      y0 += load(column) * x_[c], y1 += load(column + 2) * x_[c], y2 += load(column + 4) * x_[c];
    store(y0 + sums(0), y), store(y1 + sums(2), y + 2), store(y2 + sums(4), y + 4);
  }

 private:
  // So many numbers ahead, some panels: the processor follows one run of addresses by itself, but not the six columns
  // of a panel. (A tenth of the time on matrices beyond the second cache; 512 to 1024 make no difference.)
  static constexpr int prefetched = 1024;

  using Pair = double __attribute__((vector_size(16)));

  static Pair load(const double* from) {
    Pair pair;
    std::memcpy(&pair, from, sizeof pair);
    return pair;
  }
  static void store(const Pair& pair, double* to) { std::memcpy(to, &pair, sizeof pair); }
  [[nodiscard]] Pair sums(std::size_t c) const {
    return Pair{transposed_[c][0] + transposed_[c][1], transposed_[c + 1][0] + transposed_[c + 1][1]};
  }

  const double* panel_;
  std::ptrdiff_t stride_;
  std::array<Pair, 6> x_;
  std::array<Pair, 6> transposed_{};
};

}  // namespace dda
