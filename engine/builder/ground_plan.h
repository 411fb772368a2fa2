// Finding blocks and stretches of outline by where they lie, as scenes do.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/builder/names.h"
#include "engine/geometry/box.h"
#include "engine/geometry/edge_index.h"
#include "engine/geometry/near_shapes.h"
#include "engine/geometry/segment.h"
#include "engine/model/model.h"

namespace dda {

// A straight part of a block's outline. `inward` is the unit normal that points into the block.
struct Stretch {
  int block = 0;
  Vec2 from;
  Vec2 to;
  Vec2 inward;
};

// Where a straight line is inside a block: from and to, m along it.
struct Passage {
  int block = 0;
  double from = 0;
  double to = 0;
};

// Looks up places in a model whose blocks are complete (moments and tolerance filled). What it looks in is made when
// something is asked for the first time: scenes need not ask. So one thread asks at a time.
class GroundPlan {
 public:
  explicit GroundPlan(const Model& model);
  ~GroundPlan();

  // Blocks that contain `point` or have it on their outline, in ascending order.
  [[nodiscard]] std::vector<int> blocks_at(const Vec2& point) const;

  // Returns which of `candidates`, all at `point`, goes on from there in the earliest of `directions`; else nothing.
  [[nodiscard]] std::optional<int> block_towards(const std::vector<int>& candidates, const Vec2& point,
                                                 const std::vector<Vec2>& directions) const;

  // Parts of outlines that run along `line`, cut to its ends, in the order of blocks.
  [[nodiscard]] std::vector<Stretch> stretches_along(const Segment& line) const;

  // The same parts of blocks near `point` alone: of all that have it, and of some others.
  [[nodiscard]] std::vector<Stretch> stretches_at(const Segment& line, const Vec2& point) const;

  // Where `line` runs inside of blocks, from its start on; stretches along joints are in none.
  [[nodiscard]] std::vector<Passage> passages_of(const Segment& line) const;

  // The box around all blocks.
  [[nodiscard]] const Box& box() const;

  // The names of the blocks.
  [[nodiscard]] const Names& names() const;

 private:
  [[nodiscard]] Location location(int block, const Vec2& point, double tolerance) const;
  [[nodiscard]] bool holds(int block, const Vec2& point, double tolerance) const;
  [[nodiscard]] std::vector<Stretch> stretches_of(const std::vector<int>& blocks, const Segment& line) const;
  void append_stretch(const Segment& edge, int block, const Segment& line, std::vector<Stretch>& found) const;

  struct Tables;
  [[nodiscard]] const Tables& tables() const;

  const Model* model_;
  double tolerance_;
  mutable std::unique_ptr<const Tables> tables_;
  mutable std::optional<Names> names_;
};

}  // namespace dda
