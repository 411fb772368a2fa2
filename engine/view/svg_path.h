// Path data of SVG, short: relative steps in tenths of a pixel, rounded so that errors do not add up.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "engine/core/types.h"

namespace dda {

class SvgPath {
 public:
  void move_to(const Vec2& point) { append(point, 'M', false); }
  void line_to(const Vec2& point) { append(point, 'l', true); }
  void close() { text_ += 'Z'; }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool empty() const { return text_.empty(); }

 private:
  void append(const Vec2& point, char command, bool relative) {
    const long x = tenths_of(point.x());
    const long y = tenths_of(point.y());
    text_ += command;
    append_number(relative ? x - x_ : x);
    text_ += ' ';
    append_number(relative ? y - y_ : y);
    x_ = x;
    y_ = y;
  }

  // Numbers and steps can be written for a point beyond all pictures too, as damaged frames may have it.
  static long tenths_of(double pixels) {
    constexpr double farthest = 1e15;
    return std::isnan(pixels) ? 0 : std::lround(std::clamp(10 * pixels, -farthest, farthest));
  }

  void append_number(long tenths) {
    if (tenths < 0) text_ += '-';
    text_ += std::to_string(std::labs(tenths) / 10);
    if (tenths % 10 != 0) text_ += '.' + std::to_string(std::labs(tenths) % 10);
  }

  std::string text_;
  long x_ = 0, y_ = 0;  // tenths of a pixel, the last point
};

}  // namespace dda
