// The Delaunay triangulation of points on a grid, by exact predicates.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/cutting/pixel.h"

namespace dda {

// Sites must not be farther from the origin than this in x and in y. The triangle around all sites has corners at
// 8 times that, and the in-circle test of differences of 2^30 takes 124 bits.
inline constexpr std::int64_t farthest_site = std::int64_t{1} << 26U;

struct DelaunayTriangle {
  std::array<int, 3> corners;  // of the sites, counter-clockwise; from sites.size() on: corners of the triangle around
  std::array<int, 3> beside;   // the triangle beyond the edge opposite of each corner; -1: none
};

// Corners beyond the sites are those of a triangle so far away that no place within `farthest_site` is nearer to one of
// them than to a site. Where several sites lie on one pixel, triangles have the first of them.
class Delaunay {
 public:
  explicit Delaunay(std::span<const Pixel> sites);  // at least one

  [[nodiscard]] const std::vector<DelaunayTriangle>& triangles() const { return triangles_; }
  [[nodiscard]] bool is_site(int corner) const { return corner < sites_; }
  // Where the circle through the corners has its centre, in grid steps.
  [[nodiscard]] Vec2 circumcentre(const DelaunayTriangle& triangle) const;

 private:
  // An edge of the cavity around a new site, seen from inside, and the triangle beyond it.
  struct Rim {
    int from = 0;
    int to = 0;
    int beyond = -1;
  };

  [[nodiscard]] const Pixel& place(int corner) const { return places_[static_cast<std::size_t>(corner)]; }
  [[nodiscard]] bool circle_holds(const DelaunayTriangle& triangle, const Pixel& point) const;
  [[nodiscard]] int triangle_around(const Pixel& point, int start) const;
  void find_cavity(int start, const Pixel& point);
  void fill_cavity(int site);
  void insert(int site);

  std::vector<Pixel> places_;
  int sites_ = 0;
  std::vector<DelaunayTriangle> triangles_;
  std::vector<bool> in_cavity_;
  std::vector<int> cavity_;
  std::vector<Rim> rim_;
  std::vector<int> fan_;  // by corner: the new triangle whose rim starts there
  int last_ = 0;          // a triangle made last
};

}  // namespace dda
