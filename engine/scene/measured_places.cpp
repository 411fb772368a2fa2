#include "engine/scene/measured_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/model/quantity_names.h"
#include "engine/scene/places.h"
#include "engine/scene/rock_values.h"

namespace dda {
namespace {

constexpr const char* place_keys[] = {"point",   "block", "group", "side",  "bolt",           "lining",  "support",
                                      "between", "line",  "about", "joint", "friction_angle", "cohesion"};

std::span<const std::string_view> keys_of(Subject subject) {
  static constexpr std::array<std::string_view, 4> block = {"point", "block", "group", "side"};
  static constexpr std::array<std::string_view, 1> joint = {"point"};
  static constexpr std::array<std::string_view, 2> bolt = {"bolt", "point"};
  static constexpr std::array<std::string_view, 2> lining = {"lining", "point"};
  static constexpr std::array<std::string_view, 3> reaction = {"support", "block", "about"};
  static constexpr std::array<std::string_view, 2> contact_force = {"between", "line"};
  static constexpr std::array<std::string_view, 2> resultant = {"line", "about"};
  static constexpr std::array<std::string_view, 4> excess_shear = {"line", "joint", "friction_angle", "cohesion"};
  switch (subject) {
    case Subject::block: return block;
    case Subject::joint: return joint;
    case Subject::bolt: return bolt;
    case Subject::lining: return lining;
    case Subject::reaction: return reaction;
    case Subject::contact_force: return contact_force;
    case Subject::resultant: return resultant;
    case Subject::excess_shear: return excess_shear;
    case Subject::contacts: break;
  }
  return {};
}

void refuse_other_keys(const Field& field, Quantity quantity) {
  const std::span<const std::string_view> allowed = keys_of(subject_of(quantity));
  for (const char* key : place_keys) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    if (const auto given = field.find(key)) given->fail(fmt::format("to be left out beside {}", to_string(quantity)));
  }
}

// Ways from a point into the block meant: straight to that side, leaning up first where two blocks lie there.
std::vector<Vec2> directions_to(const std::string& side) {
  if (side == "right") return {{1, 0.1}, {1, -0.1}, {1, 0}};
  if (side == "left") return {{-1, 0.1}, {-1, -0.1}, {-1, 0}};
  if (side == "above") return {{0.1, 1}, {-0.1, 1}, {0, 1}};
  if (side == "below") return {{0.1, -1}, {-0.1, -1}, {0, -1}};
  return {{1, 1}, {1, 0}, {0, 1}, {1, -1}, {-1, 1}, {-1, 0}, {0, -1}, {-1, -1}};
}

Segment read_line(const Field& field) {
  Segment line{field.at("from").vector(Dimension::length), field.at("to").vector(Dimension::length)};
  if (line.start == line.end) field.fail("two different points");
  return line;
}

bool runs_along(const std::vector<Stretch>& stretches, const std::vector<int>& blocks) {
  return std::any_of(stretches.begin(), stretches.end(), [&](const Stretch& stretch) {
    return std::binary_search(blocks.begin(), blocks.end(), stretch.block);
  });
}

// A point within the length of the longest piece is beside what these make up, wherever it is between two faces and
// however coarse they are; one further off means something else.
int nearest_piece(const Field& field, const Vec2& point, const std::vector<Segment>& pieces, const std::string& whole) {
  double least = std::numeric_limits<double>::infinity(), longest = 0;
  int nearest = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    longest = std::max(longest, (pieces[i].end - pieces[i].start).norm());
    const double away = distance(pieces[i], point);
    if (away >= least) continue;
    least = away;
    nearest = static_cast<int>(i);
  }
  if (least > longest)
    field.fail(fmt::format("{}, {:.3g} m away from {}", written(point), least, whole),
               fmt::format("a point on it, or no further off than its longest piece, {:.3g} m", longest));
  return nearest;
}

}  // namespace

MeasuredPlaces::MeasuredPlaces(const GroundPlan& plan, const BlockSets& sets, const Model& model)
    : plan_(plan), sets_(sets), model_(model), bolts_(model.bolts), linings_(model.linings), joints_(model.joints) {}

void MeasuredPlaces::read(const Field& field, Measurement& measurement) const {
  refuse_other_keys(field, measurement.quantity);
  switch (subject_of(measurement.quantity)) {
    case Subject::block: place_in_block(field, measurement); break;
    case Subject::joint: place_on_joint(field, measurement); break;
    case Subject::bolt: place_on_bolt(field, measurement); break;
    case Subject::lining: place_on_lining(field, measurement); break;
    case Subject::reaction: place_at_supports(field, measurement); break;
    case Subject::contact_force: place_between(field, measurement); break;
    case Subject::resultant: place_across_line(field, measurement); break;
    case Subject::excess_shear: place_along_joints(field, measurement); break;
    case Subject::contacts: break;
  }
}

void MeasuredPlaces::place_in_block(const Field& field, Measurement& measurement) const {
  if (const auto group = field.find("group")) {
    refuse(field, {"point", "block", "side"}, "beside group");
    measurement.blocks = sets_.members(*group);
  } else if (!field.has("point") && field.has("block")) {
    measurement.block = field.at("block").choice(plan_.names());
    measurement.point = model_.blocks[static_cast<std::size_t>(measurement.block)].moments.centroid;
  } else {
    measurement.point = field.at("point").vector(Dimension::length);
    measurement.block = block_at_point(field, measurement.point);
  }
}

int MeasuredPlaces::block_at_point(const Field& field, const Vec2& point) const {
  const std::vector<int> blocks = plan_.blocks_at(point);
  const bool on_a_joint = blocks.size() > 1 && !field.has("block");
  if (!on_a_joint) return read_point(field, plan_, model_).block;
  const std::string side = value_or(field, "side", std::string(), [](const Field& f) { return f.text(); });
  if (const auto block = plan_.block_towards(blocks, point, directions_to(side))) return *block;
  if (side.empty()) return blocks.front();
  field.at("side").fail(fmt::format("a side of the point on which one of its blocks lies: {}", listed(blocks, model_)));
}

void MeasuredPlaces::place_on_joint(const Field& field, Measurement& measurement) const {
  const Field point = field.at("point");
  measurement.point = point.vector(Dimension::length);
  const std::vector<int> blocks = plan_.blocks_at(measurement.point);
  if (blocks.size() != 2) {
    point.fail(fmt::format("a point on the joint between two blocks (at this one: {})",
                           blocks.empty() ? "none" : listed(blocks, model_)));
  }
  measurement.block = blocks[0];
  measurement.other_block = blocks[1];
}

// The link nearest to the point, where one is given. A link stands for a piece of a grouted bolt, up to half-way to the
// next; of an anchored one there is one, from end to end.
void MeasuredPlaces::place_on_bolt(const Field& field, Measurement& measurement) const {
  if (model_.bolts.empty()) field.at("bolt").fail("the name of a bolt, of which there is none");
  measurement.bolt = field.at("bolt").choice(bolts_);
  const auto point = field.find("point");
  if (!point) return;
  measurement.point = point->vector(Dimension::length);
  const Bolt& bolt = model_.bolts[static_cast<std::size_t>(measurement.bolt)];
  std::vector<Segment> pieces;
  for (const BoltLink& link : bolt.links)
    pieces.push_back({link.point_a - link.reach_a * bolt.direction, link.point_b + link.reach_b * bolt.direction});
  measurement.link = nearest_piece(*point, measurement.point, pieces, fmt::format("bolt \"{}\"", bolt.name));
}

// The element nearest to the point, where one is given.
void MeasuredPlaces::place_on_lining(const Field& field, Measurement& measurement) const {
  if (model_.linings.empty()) field.at("lining").fail("the name of a lining, of which there is none");
  measurement.lining = field.at("lining").choice(linings_);
  const auto point = field.find("point");
  if (!point) return;
  measurement.point = point->vector(Dimension::length);
  const Lining& lining = model_.linings[static_cast<std::size_t>(measurement.lining)];
  std::vector<Segment> elements;
  for (std::size_t i = 0; i < lining.elements(); ++i)
    elements.push_back({lining.start_of(i).point, lining.end_of(i).point});
  measurement.element = nearest_piece(*point, measurement.point, elements, fmt::format("lining \"{}\"", lining.name));
}

// Measures the reaction of named supports, of blocks that are held as a whole, or of all that is held.
void MeasuredPlaces::place_at_supports(const Field& field, Measurement& measurement) const {
  measurement.about =
      value_or(field, "about", Vec2(Vec2::Zero()), [](const Field& f) { return f.vector(Dimension::length); });
  if (const auto block = field.find("block")) {
    refuse(field, {"support"}, "beside block");
    measurement.blocks = sets_.members(*block);
    for (const int each : measurement.blocks)
      if (!model_.is_held(each))
        block->fail(fmt::format("blocks that are held as a whole, and \"{}\" is not",
                                model_.blocks[static_cast<std::size_t>(each)].name));
    return;
  }
  const auto name = field.find("support");
  take_held(name, measurement);
  if (!measurement.supports.empty() || !measurement.blocks.empty()) return;
  if (name) name->fail("the \"name\" of an entry of supports");
  field.at("quantity").fail("something that is held: supports or fixed");
}

void MeasuredPlaces::take_held(const std::optional<Field>& name, Measurement& measurement) const {
  const auto meant = [&](const std::string& own) { return !name || own == name->text(); };
  for (std::size_t i = 0; i < model_.supports.size(); ++i)
    if (meant(model_.supports[i].name)) measurement.supports.push_back(static_cast<int>(i));
  for (const HeldBlock& held : model_.held_blocks)
    if (meant(held.name)) measurement.blocks.push_back(held.block);
  std::ranges::sort(measurement.blocks);
  // A block that several entries move is one block.
  measurement.blocks.erase(std::unique(measurement.blocks.begin(), measurement.blocks.end()), measurement.blocks.end());
}

void MeasuredPlaces::place_between(const Field& field, Measurement& measurement) const {
  const Field between = field.at("between");
  const std::vector<Field> names = between.items();
  measurement.blocks = sets_.members(names.at(0));
  measurement.others = sets_.members(names.at(1));
  std::vector<int> common;
  std::set_intersection(measurement.blocks.begin(), measurement.blocks.end(), measurement.others.begin(),
                        measurement.others.end(), std::back_inserter(common));
  if (!common.empty()) between.fail("two names that have no block in common, as " + listed(common, model_));
  const auto field_of_line = field.find("line");
  measurement.on_line = field_of_line.has_value();
  if (!measurement.on_line) return;
  const Segment line = read_line(*field_of_line);
  const std::vector<Stretch> stretches = plan_.stretches_along(line);
  if (!runs_along(stretches, measurement.blocks) || !runs_along(stretches, measurement.others))
    field_of_line->fail("a line along which both sides have edges");
  measurement.from = line.start;
  measurement.to = line.end;
}

// All joints, one of them, or those along a line, judged by their own strengths or by one that is given.
void MeasuredPlaces::place_along_joints(const Field& field, Measurement& measurement) const {
  if (const auto joint = field.find("joint")) measurement.joint = joint->choice(joints_);
  if (const auto angle = field.find("friction_angle")) measurement.friction_angle = read_friction_angle(*angle);
  if (const auto cohesion = field.find("cohesion")) measurement.cohesion = cohesion->not_negative(Dimension::stress);
  const auto along = field.find("line");
  measurement.on_line = along.has_value();
  if (!measurement.on_line) return;
  const Segment line = read_line(*along);
  if (plan_.stretches_along(line).empty()) along->fail("a line along which blocks have edges");
  measurement.from = line.start;
  measurement.to = line.end;
}

void MeasuredPlaces::place_across_line(const Field& field, Measurement& measurement) const {
  const Segment line = read_line(field.at("line"));
  measurement.from = line.start;
  measurement.to = line.end;
  measurement.about = value_or(field, "about", Vec2((line.start + line.end) / 2),
                               [](const Field& f) { return f.vector(Dimension::length); });
}

}  // namespace dda
