#include "engine/cutting/delaunay.h"

#include <cstddef>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Wide square(const Pixel& p) { return Wide(p.x) * p.x + Wide(p.y) * p.y; }

}  // namespace

// Sites come one by one; a new one takes the place of the triangles whose circles hold it (Bowyer 1981, Watson 1981).
Delaunay::Delaunay(std::span<const Pixel> sites)
    : places_(sites.begin(), sites.end()), sites_(static_cast<int>(sites.size())) {
  constexpr std::int64_t far = 8 * farthest_site;
  places_.insert(places_.end(), {{-far, -far}, {far, -far}, {0, far}});
  fan_.resize(places_.size());
  triangles_.push_back({{sites_, sites_ + 1, sites_ + 2}, {-1, -1, -1}});
  for (int site = 0; site < sites_; ++site) insert(site);
}

Vec2 Delaunay::circumcentre(const DelaunayTriangle& triangle) const {
  const Pixel& a = place(triangle.corners[0]);
  const Pixel b = place(triangle.corners[1]) - a;
  const Pixel c = place(triangle.corners[2]) - a;
  const auto twice_area = static_cast<double>(2 * cross(b, c));
  const auto x = static_cast<double>(square(b) * c.y - square(c) * b.y);
  const auto y = static_cast<double>(square(c) * b.x - square(b) * c.x);
  return Vec2(static_cast<double>(a.x), static_cast<double>(a.y)) + Vec2(x, y) / twice_area;
}

bool Delaunay::circle_holds(const DelaunayTriangle& triangle, const Pixel& point) const {
  const Pixel a = place(triangle.corners[0]) - point;
  const Pixel b = place(triangle.corners[1]) - point;
  const Pixel c = place(triangle.corners[2]) - point;
  return square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b) > 0;
}

// Goes over edges that have the point beyond them; in a Delaunay triangulation that arrives.
int Delaunay::triangle_around(const Pixel& point, int start) const {
  int triangle = start;
  for (bool moved = true; moved;) {
    moved = false;
    const DelaunayTriangle& each = triangles_[at(triangle)];
    for (std::size_t i = 0; i < 3 && !moved; ++i) {
      if (turn(place(each.corners[(i + 1) % 3]), place(each.corners[(i + 2) % 3]), point) >= 0) continue;
      triangle = each.beside[i];
      moved = true;
    }
  }
  return triangle;
}

void Delaunay::find_cavity(int start, const Pixel& point) {
  cavity_.assign(1, start);
  rim_.clear();
  in_cavity_.resize(triangles_.size(), false);
  in_cavity_[at(start)] = true;
  for (std::size_t next = 0; next < cavity_.size(); ++next) {
    const DelaunayTriangle& each = triangles_[at(cavity_[next])];
    for (std::size_t i = 0; i < 3; ++i) {
      const int beyond = each.beside[i];
      if (beyond >= 0 && in_cavity_[at(beyond)]) continue;
      if (beyond >= 0 && circle_holds(triangles_[at(beyond)], point)) {
        in_cavity_[at(beyond)] = true;
        cavity_.push_back(beyond);
      } else {
        rim_.push_back({each.corners[(i + 1) % 3], each.corners[(i + 2) % 3], beyond});
      }
    }
  }
  for (const int triangle : cavity_) in_cavity_[at(triangle)] = false;
}

// A fan of triangles from the site to the rim; there are two more than were in the cavity.
void Delaunay::fill_cavity(int site) {
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    if (i >= cavity_.size()) {
      cavity_.push_back(static_cast<int>(triangles_.size()));
      triangles_.emplace_back();
    }
    const Rim& edge = rim_[i];
    fan_[at(edge.from)] = cavity_[i];
    triangles_[at(cavity_[i])] = {{site, edge.from, edge.to}, {edge.beyond, -1, -1}};
    if (edge.beyond < 0) continue;
    DelaunayTriangle& beyond = triangles_[at(edge.beyond)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (beyond.corners[(k + 1) % 3] == edge.to && beyond.corners[(k + 2) % 3] == edge.from)
        beyond.beside[k] = cavity_[i];
    }
  }
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    const int following = fan_[at(rim_[i].to)];
    triangles_[at(cavity_[i])].beside[1] = following;
    triangles_[at(following)].beside[2] = cavity_[i];
  }
  last_ = cavity_.front();
}

void Delaunay::insert(int site) {
  const Pixel& point = place(site);
  const int around = triangle_around(point, last_);
  for (const int corner : triangles_[at(around)].corners) {
    if (place(corner) == point) return;
  }
  find_cavity(around, point);
  fill_cavity(site);
}

}  // namespace dda
