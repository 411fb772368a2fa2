// Lines through material points of blocks, as bolts and linings are drawn.
#pragma once

#include <vector>

#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/record/vtp_file.h"

namespace dda {

class MaterialLines {
 public:
  // The next point of the line that is being added. `reference`: as drawn, m.
  void add_point(int block, const Vec2& reference, PolyData& data);
  void end_line(PolyData& data) const;

  // Fills in where the points are, and their "displacement [m]" since the start.
  void place(const Model& model, const State& state, PolyData& data) const;

 private:
  struct MaterialPoint {
    int block = 0;
    Vec2 reference;  // m
  };

  std::vector<MaterialPoint> points_;
};

}  // namespace dda
