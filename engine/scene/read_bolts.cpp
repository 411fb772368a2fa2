#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/error.h"
#include "engine/model/tolerance.h"
#include "engine/scene/places.h"
#include "engine/scene/read_withdrawal.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

// Axial stiffness of a bolt, N/m: given, or Young's modulus times section over a length.
struct AxialStiffness {
  double given = 0;             // N/m, or 0
  double young_times_area = 0;  // N
  double free_length = 0;       // m, or 0

  [[nodiscard]] double over(double length) const {
    return given > 0 ? given : young_times_area / (free_length > 0 ? free_length : length);
  }
};

double positive(const Field& field, const char* key, Dimension dimension, double otherwise) {
  return value_or(field, key, otherwise, [dimension](const Field& f) { return f.positive(dimension); });
}

AxialStiffness read_stiffness(const Field& field) {
  AxialStiffness stiffness;
  stiffness.given = positive(field, "stiffness", Dimension::force_per_length, 0);
  if (stiffness.given > 0) {
    refuse(field, {"young", "diameter", "free_length"}, "beside stiffness");
    return stiffness;
  }
  if (!field.has("young") && !field.has("diameter"))
    throw InputError("", field.path() + ".stiffness", "missing", "stiffness, or young and diameter");
  const double diameter = field.at("diameter").positive(Dimension::length);
  stiffness.young_times_area =
      field.at("young").positive(Dimension::stress) * std::numbers::pi * diameter * diameter / 4;
  stiffness.free_length = positive(field, "free_length", Dimension::length, 0);
  return stiffness;
}

// Reads everything but where the bolt runs. Forces of a bolt are spread over its spacing.
Bolt read_properties(const Field& field, const Model& model) {
  Bolt bolt;
  bolt.name =
      value_or(field, "name", fmt::format("bolt {}", model.bolts.size() + 1), [](const Field& f) { return f.name(); });
  const auto same_name = [&bolt](const Bolt& other) { return other.name == bolt.name; };
  if (std::any_of(model.bolts.begin(), model.bolts.end(), same_name))
    field.at("name").fail("a name that no other bolt has");
  bolt.grouted = value_or(field, "grouted", false, [](const Field& f) { return f.truth(); });
  bolt.first_stage = value_or(field, "from_stage", 0, [&](const Field& f) { return read_stage_reference(f, model); });
  bolt.withdrawal = read_withdrawal(field, bolt.first_stage, model);
  bolt.spacing = positive(field, "spacing", Dimension::length, 1);
  bolt.yield_force = positive(field, "yield_force", Dimension::force, bolt.yield_force) / bolt.spacing;
  bolt.shear_yield_force =
      positive(field, "shear_yield_force", Dimension::force, bolt.shear_yield_force) / bolt.spacing;
  bolt.pretension =
      value_or(field, "pretension", 0.0, [](const Field& f) { return f.not_negative(Dimension::force); }) /
      bolt.spacing;
  if (bolt.pretension > bolt.yield_force) field.at("pretension").fail("at most yield_force");
  bolt.rupture_elongation = positive(field, "rupture_elongation", Dimension::length, bolt.rupture_elongation);
  bolt.tension_only = value_or(field, "tension_only", true, [](const Field& f) { return f.truth(); });
  return bolt;
}

// What may surprise who sets an anchor where blocks meet.
std::string note_on_shared_anchors(const Field& field, const GroundPlan& plan, const Model& model) {
  std::string note;
  for (const char* key : {"from", "to"}) {
    const std::vector<int> blocks = plan.blocks_at(field.at(key).vector(Dimension::length));
    if (blocks.size() > 1)
      note += fmt::format("; {} lies where blocks meet ({}), and is taken to be in the one that the bolt runs into",
                          key, listed(blocks, model));
  }
  return note;
}

void add_anchored_link(const Field& field, const Segment& line, const AxialStiffness& stiffness, const GroundPlan& plan,
                       const Model& model, Bolt& bolt) {
  refuse(field, {"shear_stiffness", "shear_yield_force", "free_length"}, "where the bolt is not grouted");
  const int first = read_anchor(field.at("from"), line.end, plan, model);
  const int last = read_anchor(field.at("to"), line.start, plan, model);
  if (first == last)
    field.at("to").fail("a point in another block than from, \"" + model.blocks[static_cast<std::size_t>(first)].name +
                        "\"" + note_on_shared_anchors(field, plan, model));
  const double length = (line.end - line.start).norm();
  bolt.links = {{first, last, line.start, line.end, stiffness.over(length) / bolt.spacing, 0}};
}

// Nothing bonds a bolt where it runs through air. Along a joint it lies between two blocks.
void refuse_air(const Field& field, const Segment& line, const std::vector<Passage>& passages, const GroundPlan& plan,
                const Model& model) {
  if (passages.empty()) return;
  const double length = (line.end - line.start).norm();
  const auto point = [&](double at) -> Vec2 { return line.start + at / length * (line.end - line.start); };
  const auto size = [&](const Passage& passage) {
    return std::sqrt(model.blocks[static_cast<std::size_t>(passage.block)].moments.area);
  };
  const auto check = [&](double from, double to, double smaller_block) {
    if (to - from <= widest_joint * smaller_block || !plan.blocks_at(point((from + to) / 2)).empty()) return;
    field.at("grouted").fail(
        fmt::format("true of a bolt that crosses {:.3g} m of air, from {} to {}", to - from, written(point(from)),
                    written(point(to))),
        "a bolt in rock from end to end, or false for one anchored at its ends, which may cross air");
  };
  check(0, passages.front().from, size(passages.front()));
  for (std::size_t i = 1; i < passages.size(); ++i)
    check(passages[i - 1].to, passages[i].from, std::min(size(passages[i - 1]), size(passages[i])));
  check(passages.back().to, length, size(passages.back()));
}

// Each piece of the bolt goes to the nearest link.
void share_out_reach(const Segment& line, Bolt& bolt) {
  const auto at = [&](const Vec2& point) { return bolt.direction.dot(point - line.start); };
  bolt.links.front().reach_a = at(bolt.links.front().point_a);
  bolt.links.back().reach_b = at(line.end) - at(bolt.links.back().point_b);
  for (std::size_t i = 1; i < bolt.links.size(); ++i)
    bolt.links[i - 1].reach_b = bolt.links[i].reach_a = (at(bolt.links[i].point_a) - at(bolt.links[i - 1].point_b)) / 2;
}

// One link where the bolt passes from a block to another. By itself a link takes the
// stretch between the middles of its two lengths in rock.
void add_grouted_links(const Field& field, const Segment& line, const AxialStiffness& stiffness, const GroundPlan& plan,
                       const Model& model, Bolt& bolt) {
  read_anchor(field.at("from"), line.end, plan, model);
  read_anchor(field.at("to"), line.start, plan, model);
  const double shear = value_or(field, "shear_stiffness", 0.0,
                                [](const Field& f) { return f.not_negative(Dimension::force_per_length); });
  const std::vector<Passage> passages = plan.passages_of(line);
  refuse_air(field, line, passages, plan, model);
  for (std::size_t i = 1; i < passages.size(); ++i) {
    const Passage& before = passages[i - 1];
    const Passage& after = passages[i];
    if (before.block == after.block) continue;
    const double stretch = (after.from + after.to - before.from - before.to) / 2;
    const auto point = [&](double at) -> Vec2 { return line.start + at * bolt.direction; };
    bolt.links.push_back({before.block, after.block, point(before.to), point(after.from),
                          stiffness.over(stretch) / bolt.spacing, shear / bolt.spacing});
  }
  if (bolt.links.empty()) field.at("to").fail("a point beyond a joint, which the bolt is to cross");
  share_out_reach(line, bolt);
}

void read_bolt(const Field& field, const GroundPlan& plan, Model& model) {
  Bolt bolt = read_properties(field, model);
  const AxialStiffness stiffness = read_stiffness(field);
  const Segment line{field.at("from").vector(Dimension::length), field.at("to").vector(Dimension::length)};
  if (line.start == line.end) field.at("to").fail("another point than from");
  bolt.direction = (line.end - line.start).normalized();
  if (bolt.grouted) {
    add_grouted_links(field, line, stiffness, plan, model, bolt);
  } else {
    add_anchored_link(field, line, stiffness, plan, model, bolt);
  }
  model.bolts.push_back(std::move(bolt));
}

}  // namespace

void read_bolts(const Field& scene, const GroundPlan& plan, Model& model) {
  const auto bolts = scene.find("bolts");
  if (!bolts) return;
  for (const Field& bolt : bolts->items()) read_bolt(bolt, plan, model);
}

}  // namespace dda
