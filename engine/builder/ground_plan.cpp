#include "engine/builder/ground_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// Far enough to leave the tolerance around a joint, near enough to stay in the thinnest of ordinary blocks.
double probing_distance(const Model& model, const std::vector<int>& candidates) {
  double least_area = std::numeric_limits<double>::infinity();
  for (const int block : candidates) least_area = std::min(least_area, model.blocks[at(block)].moments.area);
  return std::max(1e-3 * std::sqrt(least_area), 10 * model.length_tolerance);
}

std::vector<Box> boxes_of(const std::vector<Block>& blocks) {
  std::vector<Box> boxes;
  boxes.reserve(blocks.size());
  for (const Block& block : blocks) boxes.push_back(bounding_box(block.shape));
  return boxes;
}

std::vector<const Ring*> outlines_of(const std::vector<Block>& blocks) {
  std::vector<const Ring*> outlines;
  outlines.reserve(blocks.size());
  for (const Block& block : blocks) outlines.push_back(&block.shape.outer);
  return outlines;
}

}  // namespace

struct GroundPlan::Tables {
  explicit Tables(const std::vector<Block>& blocks) : boxes(boxes_of(blocks)), index(outlines_of(blocks)) {
    for (const Box& each : boxes) box = expanded(expanded(box, each.lower), each.upper);
    for (std::size_t i = 0; i < blocks.size(); ++i)
      if (corner_count(blocks[i].shape) >= corners_worth_an_index)
        edges.try_emplace(static_cast<int>(i), blocks[i].shape);
  }

  std::vector<Box> boxes;  // of the blocks
  ShapeIndex index;
  std::unordered_map<int, EdgeIndex> edges;  // of blocks with many corners
  Box box;
};

GroundPlan::GroundPlan(const Model& model) : model_(&model), tolerance_(point_tolerance(model)) {}
GroundPlan::~GroundPlan() = default;

const GroundPlan::Tables& GroundPlan::tables() const {
  if (!tables_) tables_ = std::make_unique<const Tables>(model_->blocks);
  return *tables_;
}

const Box& GroundPlan::box() const { return tables().box; }

const Names& GroundPlan::names() const {
  if (!names_) names_.emplace(model_->blocks);
  return *names_;
}

Location GroundPlan::location(int block, const Vec2& point, double tolerance) const {
  const auto large = tables().edges.find(block);
  return large == tables().edges.end() ? locate(model_->blocks[at(block)].shape, point, tolerance)
                                       : large->second.locate(point, tolerance);
}

bool GroundPlan::holds(int block, const Vec2& point, double tolerance) const {
  if (!overlap(expanded(tables().boxes[at(block)], tolerance), Box{point, point})) return false;
  return location(block, point, tolerance) != Location::outside;
}

std::vector<int> GroundPlan::blocks_at(const Vec2& point) const {
  std::vector<int> found;
  for (const int block : tables().index.near(expanded(Box{point, point}, 2 * tolerance_)))
    if (holds(block, point, tolerance_)) found.push_back(block);
  return found;
}

std::optional<int> GroundPlan::block_towards(const std::vector<int>& candidates, const Vec2& point,
                                             const std::vector<Vec2>& directions) const {
  const double distance = probing_distance(*model_, candidates);
  for (const Vec2& direction : directions) {
    for (const int block : candidates) {
      if (holds(block, point + distance * direction, model_->length_tolerance)) return block;
    }
  }
  return {};
}

void GroundPlan::append_stretch(const Segment& edge, int block, const Segment& line,
                                std::vector<Stretch>& found) const {
  const auto common = collinear_overlap(edge, line, tolerance_);
  if (!common) return;
  const Vec2 along = (edge.end - edge.start).normalized();
  found.push_back({block, common->first, common->second, {-along.y(), along.x()}});  // material lies on the left
}

std::vector<Stretch> GroundPlan::stretches_along(const Segment& line) const {
  return stretches_of(tables().index.near(line, tolerance_), line);
}

std::vector<Stretch> GroundPlan::stretches_at(const Segment& line, const Vec2& point) const {
  return stretches_of(tables().index.near(expanded(Box{point, point}, tolerance_)), line);
}

std::vector<Stretch> GroundPlan::stretches_of(const std::vector<int>& blocks, const Segment& line) const {
  std::vector<Stretch> found;
  const Box near_line = expanded(expanded(expanded(Box{}, line.start), line.end), 2 * tolerance_);
  for (const int block : blocks) {
    if (const auto large = tables().edges.find(block); large != tables().edges.end()) {
      for (const int i : large->second.near(near_line))
        append_stretch(large->second.edges()[at(i)], block, line, found);
    } else {
      for_each_edge(model_->blocks[at(block)].shape,
                    [&](const Segment& edge) { append_stretch(edge, block, line, found); });
    }
  }
  return found;
}

namespace {

// Appends where `line` crosses the lines of the ring's edges between their ends, m along it.
void append_crossings(const Ring& ring, const Segment& line, const Vec2& along, std::vector<double>& found) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 from = ring[i] - line.start;
    const Vec2 to = ring[(i + 1) % ring.size()] - line.start;
    const double side_from = cross(along, from);
    const double side_to = cross(along, to);
    if (side_from == side_to || side_from * side_to > 0) continue;
    found.push_back(along.dot(from + side_from / (side_from - side_to) * (to - from)));
  }
}

}  // namespace

std::vector<Passage> GroundPlan::passages_of(const Segment& line) const {
  const double length = (line.end - line.start).norm();
  const Vec2 along = (line.end - line.start) / length;
  std::vector<Passage> passages;
  for (const int block : tables().index.near(line, tolerance_)) {
    const Polygon& shape = model_->blocks[at(block)].shape;
    std::vector<double> cuts{0, length};
    append_crossings(shape.outer, line, along, cuts);
    for (const Ring& hole : shape.holes) append_crossings(hole, line, along, cuts);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double from = std::max(cuts[i - 1], 0.0);
      const double to = std::min(cuts[i], length);
      if (to - from <= tolerance_) continue;
      if (location(block, line.start + (from + to) / 2 * along, model_->length_tolerance) == Location::inside)
        passages.push_back({block, from, to});
    }
  }
  std::sort(passages.begin(), passages.end(), [](const Passage& a, const Passage& b) { return a.from < b.from; });
  return passages;
}

}  // namespace dda
