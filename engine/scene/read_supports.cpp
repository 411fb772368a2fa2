#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/core/error.h"
#include "engine/model/common_centroid.h"
#include "engine/model/held_flags.h"
#include "engine/model/held_motion.h"
#include "engine/scene/places.h"
#include "engine/scene/rock_values.h"
#include "engine/scene/row_end.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

// Why the spring of a support is this stiff: the point gives way by a thousandth of what a block under the same force
// deforms, and a linear system with it still loses only three of its sixteen digits.
constexpr double support_stiffness_over_young = 1000;

struct KindOfMotion {
  MotionKind kind;
  const char* key;
  Dimension dimension;
};

constexpr KindOfMotion kinds_of_motion[] = {
    {MotionKind::displacement, "displacement", Dimension::length},
    {MotionKind::velocity, "velocity", Dimension::velocity},
    {MotionKind::acceleration, "acceleration", Dimension::acceleration},
};

// What is prescribed, in the members that a point and a block have in common.
template <typename Held>
void read_motion(const Field& field, RecordFiles& records, Held& held) {
  const KindOfMotion* given = nullptr;
  for (const KindOfMotion& each : kinds_of_motion) {
    if (!field.has(each.key)) continue;
    if (given != nullptr) field.at(each.key).fail(fmt::format("to be left out beside {}", given->key));
    given = &each;
  }
  if (given == nullptr) return;
  held.kind = given->kind;
  held.amplitude = field.at(given->key).vector(given->dimension);
  held.history = read_history(field, given->dimension, records);
}

void refuse_history_of_nothing(const Field& field) { refuse(field, {"history"}, "where no motion is prescribed"); }

// Where points are held.

Field amplitude_of(const Field& field) {
  for (const KindOfMotion& each : kinds_of_motion)
    if (const auto amplitude = field.find(each.key)) return *amplitude;
  return field;
}

// Turned into a direction where it is the normal of an edge.
enum class Hold { xy, x, y, normal };

Hold read_held_directions(const Field& field, PointSupport& support) {
  const auto hold = static_cast<Hold>(value_or(field, "hold", std::size_t{0}, [](const Field& f) {
    return f.choice({"xy", "x", "y", "normal"});
  }));
  if (hold == Hold::normal && field.has("point")) field.at("hold").fail("xy, x or y at a point, which has no normal");
  support.holds_x = hold != Hold::y;
  support.holds_y = hold != Hold::x;
  const Vec2& motion = support.amplitude;
  if ((!support.holds_x && motion.x() != 0) || (!support.holds_y && motion.y() != 0))
    amplitude_of(field).fail("zero in the direction that \"hold\" leaves free");
  return hold;
}

double stiffness_of(const PointSupport& support, int block, const Model& model) {
  return support.stiffness > 0 ? support.stiffness : support_stiffness_over_young * model.material_of(block).young;
}

void append_support(PointSupport support, int block, const Vec2& point, double share, Model& model) {
  support.stiffness = share * stiffness_of(support, block, model);
  support.block = block;
  support.point = point;
  model.supports.push_back(std::move(support));
}

// Whether the springs of an edge hold across it, and not along it.
bool holds_across(const PointSupport& support, const Vec2& across) {
  constexpr double tolerance = 1e-6;
  if (!support.direction.isZero(0)) return true;
  return support.holds_x ? std::abs(across.y()) < tolerance : std::abs(across.x()) < tolerance;
}

// How far from the middle of a stretch the two points are that are held across it, over half of its length. Where a row
// of blocks ends there they lie as near to each other as lets the block turn by what half of it would bend; held at the
// corners it could not turn, and a roof of 8 blocks that is clamped at both ends sagged 0.59 as far as a beam.
double reach_of_springs(const PointSupport& support, const Stretch& stretch, const GroundPlan& plan,
                        const Model& model) {
  if (!holds_across(support, stretch.inward)) return 1;
  const auto bending = bending_of_row_end(stretch, plan, model);
  if (!bending) return 1;
  const double half_length = (stretch.to - stretch.from).norm() / 2;
  return std::min(1.0, std::sqrt(*bending / stiffness_of(support, stretch.block, model)) / half_length);
}

// Both ends of a stretch are held across it, or points nearer to its middle where a row ends. Along it a clamped edge
// is held in its middle: held at both ends, a block of constant strain could not strain along the edge at all, which
// near a clamp makes rock of nu above 0.4 as good as rigid.
void append_edge(PointSupport support, Hold hold, const Stretch& stretch, const GroundPlan& plan, Model& model) {
  if (hold == Hold::xy || hold == Hold::normal) support.direction = stretch.inward;
  const double reach = reach_of_springs(support, stretch, plan, model);
  const Vec2 middle = (stretch.from + stretch.to) / 2;
  for (const Vec2& end : {stretch.from, stretch.to})
    append_support(support, stretch.block, reach < 1 ? Vec2(middle + reach * (end - middle)) : end, 0.5, model);
  if (hold != Hold::xy) return;
  support.direction = stretch.inward.unitOrthogonal();
  append_support(support, stretch.block, middle, 1, model);
}

// A motion along the face alone would move nothing.
void require_motion_across(const Field& field, const Vec2& amplitude, const std::vector<Stretch>& edge) {
  constexpr double tolerance = 1e-6;
  const auto ignores = [&](const Stretch& stretch) {
    return std::abs(amplitude.dot(stretch.inward)) <= tolerance * amplitude.norm();
  };
  if (!amplitude.isZero(0) && std::ranges::all_of(edge, ignores))
    amplitude_of(field).fail("a motion across the edge, as \"hold\": \"normal\" leaves all motion along it free");
}

void read_held_points(const Field& field, const GroundPlan& plan, RecordFiles& records, Model& model) {
  refuse(field, {"rotation", "spin", "about"}, "for points and edges, which do not turn");
  PointSupport support;
  read_motion(field, records, support);
  if (amplitude_of(field).path() == field.path()) refuse_history_of_nothing(field);
  const Hold hold = read_held_directions(field, support);
  support.stiffness =
      value_or(field, "stiffness", 0.0, [](const Field& f) { return f.positive(Dimension::force_per_length); });
  support.last_stage =
      value_or(field, "until_stage", -1, [&](const Field& f) { return read_stage_reference(f, model); });
  support.name = value_or(field, "name", std::string(), [](const Field& f) { return f.name(); });
  support.takes_force_along = value_or(field, "release", false, [](const Field& f) { return f.truth(); });
  if (support.last_stage < 0) refuse(field, {"release"}, "without until_stage");
  if (field.has("point")) {
    const auto [block, point] = read_point(field, plan, model);
    append_support(support, block, point, 1, model);
    return;
  }
  const std::vector<Stretch> edge = read_edge(field, plan, model);
  if (hold == Hold::normal) require_motion_across(field, support.amplitude, edge);
  for (const Stretch& stretch : edge) append_edge(support, hold, stretch, plan, model);
}

// Whole blocks.

// Behind the entries that the block has already, with which its motion adds up.
void add_to_motions_of_block(const HeldBlock& held, const Field& name, Model& model) {
  const auto first = std::ranges::find(model.held_blocks, held.block, &HeldBlock::block);
  const auto index = static_cast<std::size_t>(first - model.held_blocks.begin());
  model.held_blocks.insert(first + std::ssize(motions_from(model, index)), held);
  if (!add_up(motions_from(model, index)))
    name.fail(
        fmt::format("blocks that are not held already, as \"{}\" is: where several supports hold a block each has "
                    "to move it, and one at most to turn it",
                    model.blocks[static_cast<std::size_t>(held.block)].name));
}

void append_held(HeldBlock held, const std::vector<int>& blocks, const Field& name, Model& model) {
  const std::vector<bool> already = held_flags(model);
  for (const int block : blocks) {
    const Block& own = model.blocks[static_cast<std::size_t>(block)];
    if (!own.starts_at_rest())
      name.fail("blocks without initial velocity, spin and strain rate, as their motion is prescribed, and not \"" +
                own.name + "\"");
    held.block = block;
    if (already[static_cast<std::size_t>(block)])
      add_to_motions_of_block(held, name, model);
    else
      model.held_blocks.push_back(held);
  }
}

// A turn goes with a displacement, a spin with a velocity; either may stand alone.
void read_turn(const Field& field, RecordFiles& records, HeldBlock& held) {
  const bool alone = held.amplitude.isZero(0) && amplitude_of(field).path() == field.path();
  const bool turns = field.has("rotation") || field.has("spin");
  if (!turns) {
    refuse(field, {"about"}, "without rotation or spin");
    if (alone) refuse_history_of_nothing(field);
    return;
  }
  if (field.has("rotation")) refuse(field, {"spin", "velocity", "acceleration"}, "beside rotation");
  if (field.has("spin")) refuse(field, {"displacement", "acceleration"}, "beside spin");
  const bool is_spin = field.has("spin");
  const Dimension dimension = is_spin ? Dimension::angular_velocity : Dimension::angle;
  held.kind = is_spin ? MotionKind::velocity : MotionKind::displacement;
  held.turn = is_spin ? field.at("spin").quantity(dimension) : read_angle_of_turn(field.at("rotation"));
  if (alone) held.history = read_history(field, dimension, records);
}

void read_held_blocks(const Field& field, const std::vector<std::string>& groups, RecordFiles& records, Model& model) {
  refuse(field, {"hold", "stiffness"}, "for a whole block, which is held exactly in all its motions");
  refuse(field, {"until_stage", "release"}, "for a whole block, which is held to the end");
  const Field name = field.at("block");
  const std::vector<int> blocks = blocks_called(name, groups, model);
  HeldBlock held;
  held.name = value_or(field, "name", std::string(), [](const Field& f) { return f.name(); });
  read_motion(field, records, held);
  read_turn(field, records, held);
  held.about = value_or(field, "about", common_centroid(blocks, model),
                        [](const Field& f) { return f.vector(Dimension::length); });
  append_held(held, blocks, name, model);
}

}  // namespace

void read_supports(const Field& scene, const GroundPlan& plan, const std::vector<std::string>& groups,
                   RecordFiles& records, Model& model) {
  if (const auto fixed = scene.find("fixed")) {
    for (const Field& name : fixed->items()) append_held({}, blocks_called(name, groups, model), name, model);
  }
  const auto supports = scene.find("supports");
  if (!supports) return;
  for (const Field& support : supports->items()) {
    if (support.has("point")) refuse(support, {"edge"}, "beside point");
    if (!support.has("point") && !support.has("edge") && !support.has("block"))
      throw InputError("", support.path(), "without a place", "one of point, edge and block");
    if (support.has("point") || support.has("edge")) {
      read_held_points(support, plan, records, model);
    } else {
      read_held_blocks(support, groups, records, model);
    }
  }
}

}  // namespace dda
