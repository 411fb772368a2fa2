#include "engine/drawing/dc_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

struct DcLine {
  Vec2 from, to;
  int material = 1;
};

using Place = std::pair<double, double>;

Place place(const Vec2& point) { return {point.x(), point.y()}; }

std::vector<std::pair<Vec2, Vec2>> edges_of(const BlockDrawing& drawing) {
  std::vector<std::pair<Vec2, Vec2>> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  };
  for (const ExportedBlock& block : drawing.blocks) {
    add(block.shape.outer);
    for (const Ring& hole : block.shape.holes) add(hole);
  }
  return edges;
}

// Neighbours share the bits of their edges: one that has no other the other way round bounds the rock.
std::vector<DcLine> outline_of(const std::vector<std::pair<Vec2, Vec2>>& edges) {
  std::set<std::pair<Place, Place>> directed;
  for (const auto& [from, to] : edges) directed.insert({place(from), place(to)});
  std::vector<DcLine> lines;
  for (const auto& [from, to] : edges) {
    if (!directed.contains({place(to), place(from)})) lines.push_back({from, to, 1});
  }
  return lines;
}

// Walks along the outline with rock on the left. Where several edges leave a node the rightmost one is next, so that a
// gap that touches another, or the outside, in a node has a walk of its own.
class Walks {
 public:
  explicit Walks(const std::vector<DcLine>& outline) : outline_(outline), used_(outline.size(), false) {
    for (std::size_t i = 0; i < outline.size(); ++i) leaving_[place(outline[i].from)].push_back(i);
  }

  // Those around gaps.
  std::vector<std::vector<std::size_t>> around_gaps() {
    std::vector<std::vector<std::size_t>> gaps;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      if (used_[i]) continue;
      const std::vector<std::size_t> walk = walk_from(i);
      if (area_left_of(walk) < 0) gaps.push_back(walk);
    }
    return gaps;
  }

 private:
  std::vector<std::size_t> walk_from(std::size_t first) {
    std::vector<std::size_t> walk;
    for (std::optional<std::size_t> at = first; at && !used_[*at]; at = next(*at)) {
      used_[*at] = true;
      walk.push_back(*at);
    }
    return walk;
  }

  [[nodiscard]] std::optional<std::size_t> next(std::size_t line) const {
    const auto found = leaving_.find(place(outline_[line].to));
    if (found == leaving_.end()) return std::nullopt;
    const Vec2 came = outline_[line].to - outline_[line].from;
    const auto turn = [&](std::size_t i) {
      const Vec2 goes = outline_[i].to - outline_[i].from;
      return std::atan2(cross(came, goes), came.dot(goes));
    };
    return *std::ranges::min_element(found->second, {}, turn);
  }

  [[nodiscard]] double area_left_of(const std::vector<std::size_t>& walk) const {
    Ring ring;
    for (const std::size_t line : walk) ring.push_back(outline_[line].from);
    return signed_area(ring);
  }

  const std::vector<DcLine>& outline_;
  std::vector<bool> used_;
  std::map<Place, std::vector<std::size_t>> leaving_;
};

// From the middle of the line to the right, half-way to what is met first.
Vec2 point_right_of(const DcLine& line, const std::vector<DcLine>& outline) {
  const Vec2 middle = (line.from + line.to) / 2;
  const Vec2 along = (line.to - line.from).normalized();
  const Vec2 right(along.y(), -along.x());
  double nearest = std::numeric_limits<double>::infinity();
  for (const DcLine& other : outline) {
    const double from = along.dot(other.from - middle);
    const double to = along.dot(other.to - middle);
    if (&other == &line || from == to || std::min(from, to) > 0 || std::max(from, to) < 0) continue;
    const double away = right.dot(other.from - middle + from / (from - to) * (other.to - other.from));
    if (away > 0) nearest = std::min(nearest, away);
  }
  return middle + nearest / 2 * right;
}

// A point in each gap between blocks. dc takes all that lines enclose for blocks, but what has such a point.
std::vector<Vec2> hole_points(const std::vector<DcLine>& outline) {
  std::vector<Vec2> points;
  const auto length = [&](std::size_t line) { return (outline[line].to - outline[line].from).norm(); };
  for (const auto& walk : Walks(outline).around_gaps())
    points.push_back(point_right_of(outline[*std::ranges::max_element(walk, {}, length)], outline));
  return points;
}

// dc takes nodes for one when they are nearer than about this share of the size of the rock.
double least_distance(const std::vector<std::pair<Vec2, Vec2>>& edges) {
  constexpr double usual = 0.001;
  constexpr double of_shortest = 0.1;
  Box box;
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : edges) {
    box = expanded(box, from);
    shortest = std::min(shortest, (to - from).norm());
  }
  return std::min(usual, of_shortest * shortest / (box.upper - box.lower).norm());
}

}  // namespace

std::vector<std::string> dc_joints(const BlockDrawing& drawing) {
  std::vector<std::string> names;
  for (const ExportedJoint& joint : drawing.joints)
    if (std::ranges::find(names, joint.joint) == names.end()) names.push_back(joint.joint);
  return names;
}

std::string dc_text(const BlockDrawing& drawing) {
  const auto edges = edges_of(drawing);
  std::vector<DcLine> lines = outline_of(edges);
  const std::vector<Vec2> holes = hole_points(lines);
  const std::vector<std::string> joints = dc_joints(drawing);
  for (const ExportedJoint& joint : drawing.joints)
    lines.push_back(
        {joint.from, joint.to, static_cast<int>(std::ranges::find(joints, joint.joint) - joints.begin()) + 1});
  std::string text = fmt::format("{}\n{} 0\n0\n0\n0\n0\n0\n{}\n", least_distance(edges), lines.size(), holes.size());
  for (const DcLine& line : lines)
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", line.from.x(), line.from.y(), line.to.x(), line.to.y(),
                   line.material);
  for (const Vec2& hole : holes) fmt::format_to(std::back_inserter(text), "{} {}\n", hole.x(), hole.y());
  return text;
}

}  // namespace dda
