// Looking left: the edge that a ray from a node towards -x meets first.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/cutting/pixel.h"

namespace dda {

// Edges sorted into the cells of a grid, about one cell an edge.
class EdgeLeftOf {
 public:
  // Half-edges 2 e and 2 e + 1 are the two directions of edge e. `pixels`: of the nodes; `origins`: the node that each
  // half-edge leaves. Both must outlive this.
  EdgeLeftOf(std::span<const Pixel> pixels, std::span<const int> origins);

  // The half-edge, running down, that the ray meets first and whose face it comes from; -1 when it meets none.
  [[nodiscard]] int of(int node) const;

 private:
  struct Hit {
    int edge = -1;
    double x = 0;      // pixels
    double slope = 0;  // change of x over change of y
  };

  [[nodiscard]] std::int64_t column_of(std::int64_t x) const;
  [[nodiscard]] std::int64_t row_of(std::int64_t y) const;
  template <typename Visit>
  void visit_cells(int edge, Visit visit) const;
  void look(std::size_t cell, const Pixel& from, Hit& nearest) const;

  [[nodiscard]] int edges() const { return static_cast<int>(origins_.size() / 2); }
  [[nodiscard]] const Pixel& start(int half_edge) const;

  std::span<const Pixel> pixels_;
  std::span<const int> origins_;
  Pixel lower_;
  std::int64_t cell_ = 1;  // pixels
  std::int64_t columns_ = 1, rows_ = 1;
  std::vector<int> starts_, edges_;  // by cell, column by column: nodes, and so edges, come from left to right
};

}  // namespace dda
