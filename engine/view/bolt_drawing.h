// Bolts and linings of a picture (SVG), and the key that says what their widths and colours mean.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/view/run_results.h"

namespace dda {

// A line is the wider the more axial force it has. Its colour says its condition, and of the elements of linings that
// have a strength how much of it they carry.
class BoltDrawing {
 public:
  // `links` must outlive it; `text_size` of the key, px.
  BoltDrawing(const std::vector<DrawnBolt>& links, double text_size);

  // `at`: from the scene to the page.
  [[nodiscard]] std::string links(const std::function<Vec2(const Vec2&)>& at, double deformation_scale) const;
  // Its first line begins at x, y (px). Nothing where there are no links.
  [[nodiscard]] std::string key(double x, double y) const;
  [[nodiscard]] double key_height() const;  // px, at most

 private:
  [[nodiscard]] double width_of(double force) const;

  const std::vector<DrawnBolt>& links_;
  double text_size_;
  double largest_ = 0;  // N
  bool has_utilisation_ = false;
};

}  // namespace dda
