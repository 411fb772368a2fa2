// Points on a fine square grid, and questions about them that are answered exactly. Cutting decides everything that is
// topology (what crosses what, what lies on which side) with these whole numbers, so that no rounding can contradict
// itself. Coordinates stay below 2^40 in size: products of three differences then fit into 128 bits.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/geometry/box.h"

namespace dda {

__extension__ using Wide = __int128;

// A grid point, and the square of one grid step around it: from -1/2 (included) to +1/2 (not included) in x and in y.
struct Pixel {
  std::int64_t x = 0;
  std::int64_t y = 0;
  bool operator==(const Pixel&) const = default;
};

inline bool operator<(const Pixel& a, const Pixel& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
inline Pixel operator-(const Pixel& a, const Pixel& b) { return {a.x - b.x, a.y - b.y}; }
inline Wide cross(const Pixel& a, const Pixel& b) { return Wide(a.x) * b.y - Wide(a.y) * b.x; }

// Twice the area of the triangle, positive when c lies left of the way from a to b.
inline Wide turn(const Pixel& a, const Pixel& b, const Pixel& c) { return cross(b - a, c - a); }

// Between places of the drawing and pixels. The step is a power of two, about 1e-12 of the extent.
class PixelGrid {
 public:
  explicit PixelGrid(const Box& box);

  [[nodiscard]] double step() const { return step_; }  // m
  [[nodiscard]] Pixel pixel_of(const Vec2& point) const;
  [[nodiscard]] Vec2 centre_of(const Pixel& pixel) const;

 private:
  Vec2 origin_;
  double step_;
};

struct PixelSegment {
  Pixel from;
  Pixel to;
};

// The pixel in which two segments cross; nothing when they touch at an end, overlap, or stay apart.
std::optional<Pixel> crossing(const PixelSegment& a, const PixelSegment& b);

// Whether a segment between grid points enters the pixel.
bool enters(const PixelSegment& segment, const Pixel& pixel);

// Whether `a` comes before `b` counter-clockwise, from the direction of +x on. Neither is zero.
bool before_in_angle(const Pixel& a, const Pixel& b);

}  // namespace dda
