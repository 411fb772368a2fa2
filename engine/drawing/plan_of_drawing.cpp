#include "engine/drawing/plan_of_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/drawn_blocks.h"
#include "engine/drawing/enclosed_rock.h"
#include "engine/drawing/join_lines.h"
#include "engine/drawing/straighten.h"
#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double reach_over_diameter = 1e-6;  // as when cutting

// A line of the drawing as chords, with what its layer means.
struct RoleLine {
  const LayerUse* use;
  std::string layer;  // as the drawing has it
  OpenLine line;
};

struct RolePoint {
  LayerRole role;
  PlanPoint point;
};

std::string on_layer(const std::string& origin, const std::string& layer) {
  return fmt::format("{} (layer {})", origin, layer);
}

const std::string& name_of(LayerRole role) { return role_names()[static_cast<std::size_t>(role)]; }

bool takes_lines(LayerRole role) {
  return role != LayerRole::hole_point && role != LayerRole::fix_point && role != LayerRole::load_point &&
         role != LayerRole::measure_point;
}

bool takes_points(LayerRole role) {
  return !takes_lines(role) || role == LayerRole::removable_hole || role == LayerRole::blast;
}

bool marks_opening(LayerRole role) { return role == LayerRole::hole_point || role == LayerRole::removable_hole; }

double smallest_x(const Ring& ring) { return bounding_box(ring).lower.x(); }

double distance_to(const Ring& ring, const Vec2& point) {
  double least = (ring.back() - point).norm();
  for (std::size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, distance(Segment{ring[i], ring[(i + 1) % ring.size()]}, point));
  return least;
}

// In a drawing whose lines enclose the rock they are joints whatever the name of their layer, unless they are absorbing
// lines or the table says else.
std::map<std::string, LayerUse> table_for(const LineDrawing& drawing, const DrawingOptions& options) {
  std::map<std::string, LayerUse> table;
  if (drawing.encloses) {
    for (const DrawnLine& line : drawing.lines) table[bare_layer(line.layer)].role = LayerRole::rock;
    table.erase(bare_layer(name_of(LayerRole::absorbing_boundary)));
  }
  for (const auto& [layer, use] : options.layers) table[bare_layer(layer)] = use;
  return table;
}

class Planner {
 public:
  Planner(const LineDrawing& drawing, const DrawingOptions& options)
      : reach_(options.reach > 0 ? options.reach : reach_over_diameter * diameter_of(drawing)),
        encloses_(drawing.encloses ? drawing.name : ""),
        layers_(table_for(drawing, options)) {
    sort_lines(drawing, straightened(drawing, options.chords, reach_));
    for (const DrawnPoint& point : drawing.points) sort_point(point);
  }

  RockPlan plan() {
    if (!outlines_.empty() || !holes_.empty()) return plan_of_blocks();
    add_boundary();
    add_joints();
    for (const LayerRole role : {LayerRole::tunnel, LayerRole::removable_hole, LayerRole::blast}) add_openings(role);
    if (!encloses_.empty()) enclose_rock(encloses_, reach_, points_in_openings(), plan_);
    add_points();
    add_marks();
    return std::move(plan_);
  }

 private:
  void sort_lines(const LineDrawing& drawing, std::vector<std::vector<Vec2>> chords) {
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
      const DrawnLine& line = drawing.lines[i];
      const LayerUse& use = layers_.use_of(line.layer, line.origin);
      const std::string origin = on_layer(line.origin, line.layer);
      if (!takes_lines(use.role)) throw InputError("", origin, "a line", "points on this layer");
      if (use.role == LayerRole::block || use.role == LayerRole::block_hole)
        add_ring_of_block(line, std::move(chords[i]), use.role, origin);
      else if (use.role != LayerRole::ignored)
        lines_.push_back({&use, line.layer, {std::move(chords[i]), origin}});
    }
  }

  void add_ring_of_block(const DrawnLine& line, std::vector<Vec2> chords, LayerRole role, const std::string& origin) {
    std::vector<DrawnRing>& rings = role == LayerRole::block ? outlines_ : holes_;
    rings.push_back({closed_ring(std::move(chords), origin, reach_, plan_.cleaned), named_layer(line.layer)->name,
                     line.material, origin});
  }

  // Joints run along blocks, which are not cut again: a line that would cut has no place beside them.
  RockPlan plan_of_blocks() {
    for (const RoleLine& line : lines_) {
      const LayerRole role = line.use->role;
      if (role != LayerRole::rock && role != LayerRole::absorbing_boundary)
        throw InputError("", line.line.origin, "a line of layer " + name_of(role) + " beside blocks",
                         "joints along blocks, absorbing boundaries and points");
    }
    plan_.blocks = blocks_with_holes(std::move(outlines_), std::move(holes_));
    add_joints();
    add_points();
    add_marks();
    return std::move(plan_);
  }

  void sort_point(const DrawnPoint& point) {
    const LayerRole role = layers_.use_of(point.layer, point.origin).role;
    const std::string origin = on_layer(point.origin, point.layer);
    if (role == LayerRole::ignored) return;
    if (!takes_points(role)) throw InputError("", origin, "a point", "lines on this layer");
    const std::string& layer = name_of(role);
    points_.push_back({role, {point.at, layer, fmt::format("{} {}", layer, ++counts_[role]), origin}});
  }

  [[nodiscard]] std::vector<OpenLine> lines_where(const std::function<bool(const RoleLine&)>& wanted) const {
    std::vector<OpenLine> found;
    for (const RoleLine& line : lines_) {
      if (wanted(line)) found.push_back(line.line);
    }
    return found;
  }

  [[nodiscard]] std::vector<OpenLine> lines_of(LayerRole role) const {
    return lines_where([role](const RoleLine& line) { return line.use->role == role; });
  }

  // Where all lines are shorter than what counts as one place, nothing would be left, in silence.
  void expect_rings(const Joined& joined, const std::string& origin) const {
    if (joined.gap || !joined.rings.empty()) return;
    throw InputError("", origin, smaller_than_one_place(reach_),
                     "a larger outline, a tolerance, or no line far away from it");
  }

  [[noreturn]] static void refuse(const Gap& gap) { throw InputError("", gap.origin, gap.value, gap.expected); }

  void note(const Joined& joined) {
    plan_.cleaned.insert(plan_.cleaned.end(), joined.cleaned.begin(), joined.cleaned.end());
  }

  // Where absorbing lines are part of the outline, and not drawn along it, both together close it.
  void add_boundary() {
    std::vector<OpenLine> lines = lines_of(LayerRole::boundary);
    if (lines.empty()) return;
    const std::string origin = lines.front().origin;
    Joined joined = join_lines(lines, reach_);
    if (const auto gap = joined.gap) {
      for (OpenLine& line : lines_of(LayerRole::absorbing_boundary)) lines.push_back(std::move(line));
      joined = join_lines(lines, reach_);
      if (joined.gap) refuse(*gap);
    }
    expect_rings(joined, origin);
    note(joined);
    const auto area = [](const JoinedRing& ring) { return std::abs(signed_area(ring.ring)); };
    std::ranges::stable_sort(joined.rings, std::greater<>(), area);
    plan_.boundary = joined.rings.front().ring;
    plan_.boundary_origin = joined.rings.front().origin;
    for (std::size_t i = 1; i < joined.rings.size(); ++i) add_hole(joined.rings[i]);
  }

  void add_hole(JoinedRing& hole) {
    if (!contains({plan_.boundary, {}}, hole.ring.front()))
      throw InputError("", hole.origin, "a second outline, outside of the first",
                       "one outline, and holes inside of it");
    plan_.holes.push_back(std::move(hole.ring));
  }

  // Only lines of closed rings are openings; those of a blast may also be lines like any other.
  void add_joints() {
    for (const RoleLine& line : lines_) {
      if (line.use->role == LayerRole::rock) add_line(line.line, *line.use);
    }
  }

  void add_line(const OpenLine& line, const LayerUse& use) {
    plan_.lines.push_back({line.points, use.joint, line.origin, use.construction});
  }

  // Those of one layer have its name, numbered from left to right where there are several.
  void add_openings(LayerRole role) {
    std::map<std::string, const LayerUse*> layers;
    for (const RoleLine& line : lines_) {
      if (line.use->role == role) layers[line.layer] = line.use;
    }
    for (const auto& [layer, use] : layers) {
      const auto own = lines_where([&name = layer](const RoleLine& line) { return line.layer == name; });
      Joined joined = join_lines(own, reach_);
      expect_rings(joined, own.front().origin);
      if (joined.gap && role != LayerRole::blast) refuse(*joined.gap);
      if (joined.gap) {
        for (const OpenLine& line : own) add_line(line, *use);
        continue;
      }
      note(joined);
      std::ranges::stable_sort(joined.rings, {}, [](const JoinedRing& ring) { return smallest_x(ring.ring); });
      for (std::size_t i = 0; i < joined.rings.size(); ++i) {
        const std::string name = joined.rings.size() == 1 ? layer : fmt::format("{} {}", layer, i + 1);
        plan_.openings.push_back({name, std::move(joined.rings[i].ring), use->joint, false, joined.rings[i].origin});
      }
    }
  }

  [[nodiscard]] std::vector<PlanPoint> points_in_openings() const {
    std::vector<PlanPoint> found;
    for (const RolePoint& each : points_)
      if (marks_opening(each.role)) found.push_back(each.point);
    return found;
  }

  void add_points() {
    for (const RolePoint& each : points_) {
      if (marks_opening(each.role)) mark_opening(each);
      plan_.points.push_back(each.point);
    }
  }

  void mark_opening(const RolePoint& marking) {
    const auto around = [&](const Ring& ring) { return contains({ring, {}}, marking.point.at); };
    bool found = std::ranges::any_of(plan_.holes, around);
    for (PlanOpening& opening : plan_.openings) {
      if (!around(opening.outline)) continue;
      found = true;
      if (marking.role == LayerRole::hole_point) opening.left_out = true;
    }
    if (!found)
      throw InputError("", marking.point.origin, "at " + written(marking.point.at) + ", in no opening",
                       "a place inside a closed line of layer tunnel, removable hole or blast");
  }

  void add_marks() {
    for (OpenLine& line : lines_of(LayerRole::absorbing_boundary)) {
      if (!plan_.boundary.empty()) expect_on_boundary(line);
      plan_.marks.push_back({std::move(line.points), name_of(LayerRole::absorbing_boundary), line.origin});
    }
  }

  // Its corners, and the middles between them.
  void expect_on_boundary(const OpenLine& line) const {
    for (std::size_t i = 0; i < 2 * line.points.size() - 1; ++i) {
      const Vec2 point = (line.points[i / 2] + line.points[(i + 1) / 2]) / 2;
      if (distance_to(plan_.boundary, point) > 2 * reach_)
        throw InputError("", line.origin, "at " + written(point) + ", off the boundary", "a line along the boundary");
    }
  }

  double reach_;
  std::string encloses_;  // name of a drawing whose lines enclose the rock; empty: a layer has the boundary
  Layers layers_;
  std::vector<RoleLine> lines_;
  std::vector<RolePoint> points_;
  std::map<LayerRole, int> counts_;          // of points, by which they are named
  std::vector<DrawnRing> outlines_, holes_;  // of blocks
  RockPlan plan_;
};

}  // namespace

RockPlan plan_of(const LineDrawing& drawing, const DrawingOptions& options) { return Planner(drawing, options).plan(); }

}  // namespace dda
