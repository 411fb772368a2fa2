#include "engine/scene/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "engine/builder/free_outline.h"
#include "engine/core/error.h"
#include "engine/model/tolerance.h"
#include "engine/scene/named_blocks.h"

namespace dda {
namespace {

std::string extent(const GroundPlan& plan) {
  return fmt::format("the blocks reach from {} to {}", written(plan.box().lower), written(plan.box().upper));
}

Segment side_of_box(const Box& box, std::size_t side) {
  const Vec2 upper_left(box.lower.x(), box.upper.y());
  const Vec2 lower_right(box.upper.x(), box.lower.y());
  const std::vector<Segment> sides = {
      {upper_left, box.lower}, {lower_right, box.upper}, {upper_left, box.upper}, {box.lower, lower_right}};
  return sides.at(side);
}

Segment read_line(const Field& field, const GroundPlan& plan) {
  if (field.is_text()) return side_of_box(plan.box(), field.choice({"left", "right", "top", "bottom"}));
  Segment line{field.at("from").vector(Dimension::length), field.at("to").vector(Dimension::length)};
  if (line.start == line.end) field.fail("two different points");
  return line;
}

// Two blocks that share a part of the line, if any do.
std::optional<std::pair<int, int>> doubly_covered(std::vector<Stretch> stretches, const Segment& line,
                                                  double tolerance) {
  const Vec2 along = (line.end - line.start).normalized();
  const auto first = [&](const Stretch& s) { return std::min(along.dot(s.from), along.dot(s.to)); };
  const auto last = [&](const Stretch& s) { return std::max(along.dot(s.from), along.dot(s.to)); };
  std::sort(stretches.begin(), stretches.end(),
            [&](const Stretch& a, const Stretch& b) { return first(a) < first(b); });
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    if (first(stretches[i]) < last(stretches[i - 1]) - tolerance)
      return std::pair(stretches[i - 1].block, stretches[i].block);
  }
  return {};
}

double read_start(const Field& field) {
  return value_or(field, "start", 0.0, [](const Field& f) { return f.quantity(Dimension::time); });
}

SineCycles read_sine(const Field& field) {
  SineCycles sine;
  sine.frequency = field.at("frequency").positive(Dimension::frequency);
  sine.cycles = value_or(field, "cycles", std::numeric_limits<double>::infinity(),
                         [](const Field& f) { return f.positive(Dimension::dimensionless); });
  sine.start = read_start(field);
  return sine;
}

PiecewiseLinear read_triangle(const Field& field) {
  const double start = read_start(field);
  const double peak = start + field.at("rise").positive(Dimension::time);
  const double end = peak + field.at("fall").positive(Dimension::time);
  if (!(start < peak && peak < end)) field.fail("a rise and a fall that are not lost beside the start");
  return {{start, peak, end}, {0, 1, 0}};
}

ExponentialDecay read_decay(const Field& field) {
  ExponentialDecay decay;
  decay.decay_time = field.at("decay_time").positive(Dimension::time);
  decay.start = read_start(field);
  decay.rise = value_or(field, "rise", 0.0, [](const Field& f) { return f.not_negative(Dimension::time); });
  return decay;
}

}  // namespace

int read_joint_reference(const Field& field, const Model& model) { return field.choice(Names(model.joints)); }

int read_stage_reference(const Field& field, const Model& model) { return field.choice(Names(model.stages)); }

PiecewiseLinear read_table(const Field& field) {
  PiecewiseLinear table;
  for (const Field& row : field.items()) {
    const Vec2 pair = row.vector(Dimension::time, Dimension::dimensionless);
    if (!table.times.empty() && pair.x() <= table.times.back()) row.fail("a later time than the row before");
    table.times.push_back(pair.x());
    table.values.push_back(pair.y());
  }
  return table;
}

std::vector<int> blocks_called(const Field& field, const std::vector<std::string>& groups, const Model& model) {
  const std::string name = field.text();
  NamedBlocks named;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (model.blocks[i].name == name) named.of_block.push_back(static_cast<int>(i));
    if (groups[i] == name) named.of_group.push_back(static_cast<int>(i));
  }
  std::vector<int> blocks = only_meaning(named, field);
  if (blocks.empty()) {
    std::vector<std::string> names = groups;
    for (const Block& block : model.blocks) names.push_back(block.name);
    static_cast<void>(field.choice(names));  // throws, as none is it
  }
  return blocks;
}

std::string listed(const std::vector<int>& blocks, const Model& model) {
  constexpr std::size_t most_listed = 4;
  std::string list;
  for (std::size_t i = 0; i < std::min(blocks.size(), most_listed); ++i) {
    list += fmt::format("{}\"{}\"", i > 0 ? ", " : "", model.blocks[static_cast<std::size_t>(blocks[i])].name);
  }
  return blocks.size() > most_listed ? list + ", ..." : list;
}

PlacedPoint read_point(const Field& owner, const GroundPlan& plan, const Model& model) {
  const Field field = owner.at("point");
  const Vec2 point = field.vector(Dimension::length);
  const std::vector<int> blocks = plan.blocks_at(point);
  if (blocks.empty()) field.fail(written(point) + " and outside all blocks", "a point of a block; " + extent(plan));
  if (const auto name = owner.find("block")) {
    const int block = name->choice(plan.names());
    if (std::find(blocks.begin(), blocks.end(), block) != blocks.end()) return {block, point};
    name->fail("a block at " + written(point) + ": " + listed(blocks, model));
  }
  if (blocks.size() == 1) return {blocks.front(), point};
  field.fail(written(point) + " where several blocks meet", "\"block\" to say which: " + listed(blocks, model));
}

int read_anchor(const Field& field, const Vec2& other_end, const GroundPlan& plan, const Model& model) {
  const Vec2 point = field.vector(Dimension::length);
  const std::vector<int> blocks = plan.blocks_at(point);
  if (blocks.empty()) field.fail(written(point) + " and outside all blocks", "a point of a block; " + extent(plan));
  const auto block = plan.block_towards(blocks, point, {(other_end - point).normalized()});
  if (block) return *block;
  if (blocks.size() == 1) return blocks.front();
  field.fail(written(point) + " where several blocks meet", "a point inside of one of them: " + listed(blocks, model));
}

bool is_of_joints(const Field& edge) {
  return edge.is_text() ? edge.text() == "joints" : edge.is_object() && edge.has("joints");
}

namespace {

std::vector<Stretch> read_straight_edge(const Field& owner, const GroundPlan& plan, const Model& model) {
  const Field field = owner.at("edge");
  const Segment line = read_line(field, plan);
  std::vector<Stretch> stretches = plan.stretches_along(line);
  keep_named_block(owner, plan, stretches);
  if (stretches.empty()) field.fail("a line along the side of a block; " + extent(plan));
  if (const auto both = doubly_covered(stretches, line, point_tolerance(model))) {
    field.fail("a line outside of joints, or \"block\" to say which side: " +
               listed({both->first, both->second}, model));
  }
  return stretches;
}

std::vector<Stretch> read_cavity(const Field& edge, const GroundPlan& plan, const Model& model) {
  refuse(edge, {"from", "to"}, "beside cavity");
  const Field field = edge.at("cavity");
  const Vec2 point = field.vector(Dimension::length);
  std::vector<Stretch> wall = ring_around(free_rings(model), point);
  if (wall.empty()) field.fail("a point in an opening with blocks all around; " + extent(plan));
  return wall;
}

}  // namespace

std::vector<Stretch> read_edge(const Field& owner, const GroundPlan& plan, const Model& model) {
  const Field field = owner.at("edge");
  if (!field.is_text()) refuse(field, {"opening"}, "here: loads alone act on what blocks lay bare that are taken out");
  if (is_of_joints(field)) field.fail("another edge here, as loads alone act on the faces of joints");
  const bool outside = field.is_text() && field.text() == "outside";
  const bool cavity = !field.is_text() && field.has("cavity");
  if (!outside && !cavity) return read_straight_edge(owner, plan, model);
  std::vector<Stretch> stretches = outside ? outer_rings(free_rings(model)) : read_cavity(field, plan, model);
  keep_named_block(owner, plan, stretches);
  if (stretches.empty()) field.fail("blocks with an outline that closes");
  return stretches;
}

void refuse(const Field& owner, std::initializer_list<const char*> keys, const char* reason) {
  for (const char* key : keys) {
    if (const auto field = owner.find(key)) field->fail(fmt::format("to be left out {}", reason));
  }
}

TimeFunction read_history(const Field& owner, Dimension dimension, RecordFiles& records) {
  const auto history = owner.find("history");
  if (!history) return Constant{};
  if (const auto table = history->find("table")) return read_table(*table);
  if (const auto sine = history->find("sine")) return read_sine(*sine);
  if (const auto record = history->find("record")) return records.read(*record, dimension);
  if (const auto triangle = history->find("triangle")) return read_triangle(*triangle);
  return read_decay(history->at("decay"));
}

}  // namespace dda
