#include "engine/simulation/free_field_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "engine/contact/tied_sides.h"
#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"
#include "engine/model/free_field_side.h"
#include "engine/model/held_motion.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

// Stiffness of the tie between the sides of a block where no springs lie between it and its neighbours, in Young's
// moduli for a square block: strains along x are then 1e-5 of those that the stress along x would cause, and round-off
// still leaves ten digits.
constexpr double tie_over_young = 1e5;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Between two parts of one block that has several edges along the side.
JointMaterial whole_block() {
  JointMaterial joint;
  joint.law = InterfaceLaw::consistent;
  joint.bonded = true;
  return joint;
}

// Copies one side into the model of the columns.
class Column {
 public:
  Column(const Model& whole, const ContactSet& contacts, const FreeFieldSide& side, double left,
         FreeFieldColumns& columns)
      : whole_(whole), contacts_(contacts), side_(side), left_(left), width_(least_width()), columns_(columns) {}

  void build() {
    append_blocks();
    stand_on_base();
    copy_edges();
  }
  [[nodiscard]] double width() const { return width_; }

 private:
  [[nodiscard]] Model& model() { return columns_.model; }
  [[nodiscard]] const ViscousEdge& edge(std::size_t i) const {
    return whole_.viscous_edges[at(side_.viscous_edges[i])];
  }

  // That of the narrowest block, so that springs which are given for each contact have the density of the side's.
  [[nodiscard]] double least_width() const {
    double width = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < side_.viscous_edges.size(); ++i) {
      const Box box = bounding_box(whole_.blocks[at(edge(i).block)].shape);
      width = std::min(width, (box.upper - box.lower).x());
    }
    return width;
  }

  void append_blocks() {
    double upper = foot_of(whole_, side_).y();
    for (std::size_t i = 0; i < side_.viscous_edges.size(); ++i) {
      const double lower = upper;
      upper = upwards(edge(i)).end.y();
      const int block = append_block(edge(i).block, lower, upper);
      columns_.blocks.push_back(block);
      tie_sides(edge(i).block, block, upper - lower);
      if (i == 0) lowest_ = block;
      if (i > 0) join(edge(i - 1).block, edge(i).block, block - 1, block, Vec2(edge(i).from.x(), lower));
    }
    highest_ = columns_.blocks.back();
  }

  int append_block(int original, double lower, double upper) {
    Block block = whole_.blocks[at(original)];
    const double right = left_ + width_;
    const std::size_t number = model().blocks.size() + 1;  // in case that a block has two edges along a side
    block.name = fmt::format("{} (free field {})", block.name, number);
    block.shape = {{{left_, lower}, {right, lower}, {right, upper}, {left_, upper}}, {}};
    block.moments = area_moments(block.shape);
    model().blocks.push_back(std::move(block));
    return static_cast<int>(model().blocks.size()) - 1;
  }

  // Vertical joints with classical springs, or of the projected law, give way as they do between the blocks inside. The
  // forces that the ground to the left and right exerts under the initial stress are in the ties from the start.
  void tie_sides(int original, int block, double height) {
    const Block& own = model().blocks[at(block)];
    const Vec2 traction(own.initial_stress(0), own.initial_stress(2));
    join_sides(original, block);
    const auto sides = tied_sides(model(), block, Vec2::UnitX());
    const Vec2 springs = sides ? sides->stiffness : springs_beside(original);
    const double by_stress = sides ? sides->softness : 0;
    columns_.ties.push_back(model().supports.size());
    const double rigid = tie_over_young * model().material_of(block).young * height / width_;
    for (const int axis : {0, 1}) {
      PointSupport tie;
      tie.block = block;
      tie.point = {left_ + width_, own.shape.outer[0].y() + height / 2};
      tie.partner = Vec2(left_, tie.point.y());
      tie.direction = Vec2::Unit(axis);
      tie.stiffness = springs(axis) > 0 ? springs(axis) : rigid;
      tie.amplitude = (height / tie.stiffness - by_stress) * traction(axis) * tie.direction;
      model().supports.push_back(std::move(tie));
    }
  }

  // Where all vertical joints of a block are of the projected law it has such a joint with itself, with the compliance
  // that such joints of its width would have here: half as far apart they give way half as much each.
  void join_sides(int original, int block) {
    const JointMaterial* joint = nullptr;
    for (std::size_t i = 0; i < contacts_.interfaces.size(); ++i) {
      if (!is_beside(original, contacts_.interfaces[i])) continue;
      if (contacts_.elements.but_for_blocks(i).law != InterfaceLaw::projected) return;
      joint = &whole_.joints[at(contacts_.interfaces[i].joint)];
    }
    if (joint == nullptr) return;
    model().joint_of_block_pair[{block, block}] = static_cast<int>(model().joints.size());
    JointMaterial& own = model().joints.emplace_back(*joint);
    own.normal_stiffness *= wider(original);
    own.shear_stiffness *= wider(original);
  }

  [[nodiscard]] static bool is_beside(int block, const Interface& interface) {
    return (interface.block_a == block || interface.block_b == block) && std::abs(interface.normal.x()) >= 0.7;
  }

  // Than the column.
  [[nodiscard]] double wider(int original) const {
    const Box box = bounding_box(whole_.blocks[at(original)].shape);
    return (box.upper - box.lower).x() / width_;
  }

  // Normal and shear stiffness (N/m) of the classical springs in the vertical joints of a block, for the width here.
  [[nodiscard]] Vec2 springs_beside(int original) const {
    Vec2 sum = Vec2::Zero();
    for (std::size_t i = 0; i < contacts_.interfaces.size(); ++i) {
      if (!is_beside(original, contacts_.interfaces[i])) continue;
      const InterfaceElement& element = contacts_.elements.but_for_blocks(i);
      if (element.law != InterfaceLaw::classical) return Vec2::Zero();
      sum += Vec2(element.stiffness(0) + element.stiffness(2), element.stiffness(1) + element.stiffness(3));
    }
    return wider(original) * sum;
  }

  // The joint that two blocks of the whole have at `place`, between two blocks here.
  void join(int original_below, int original_above, int below, int above, const Vec2& place) {
    JointMaterial joint =
        original_below == original_above ? whole_block() : joint_at(original_below, original_above, place);
    if (joint.law == InterfaceLaw::cubic) joint.law = InterfaceLaw::consistent;
    joint.stabilisation = stabilisation_of(joint);  // the rock around the column keeps it from bending
    model().joint_of_block_pair[{std::min(below, above), std::max(below, above)}] =
        static_cast<int>(model().joints.size());
    model().joints.push_back(std::move(joint));
  }

  [[nodiscard]] JointMaterial joint_at(int block_a, int block_b, const Vec2& place) const {
    const double tolerance = point_tolerance(whole_);
    for (std::size_t i = 0; i < contacts_.interfaces.size(); ++i) {
      const Interface& found = contacts_.interfaces[i];
      if (std::minmax(found.block_a, found.block_b) != std::minmax(block_a, block_b)) continue;
      if (distance(Segment{found.from, found.to}, place) > tolerance) continue;
      JointMaterial joint = whole_.joints[at(found.joint)];
      joint.law = contacts_.elements.but_for_blocks(i).law;
      return joint;
    }
    return whole_.joint_between(block_a, block_b);
  }

  void stand_on_base() {
    const int held = held_base_of(whole_, side_);
    if (held >= 0) stand_on_held_block(motions_from(whole_, at(held)));
    for (const int index : supports_at_foot(whole_, side_)) copy_support(whole_.supports[at(index)]);
  }

  void stand_on_held_block(const HeldMotions& motions) {
    const Vec2 foot = foot_of(whole_, side_);
    const int original = motions[0].block;
    const Box box = bounding_box(whole_.blocks[at(original)].shape);
    const int block = append_block(original, foot.y() - (box.upper - box.lower).y(), foot.y());
    join(original, edge(0).block, block, lowest_, foot);
    for (HeldBlock held : motions) {
      held.block = block;
      model().held_blocks.push_back(std::move(held));
    }
  }

  // A point under the lowest block is there for half of the underside.
  void copy_support(PointSupport support) {
    const Box box = bounding_box(whole_.blocks[at(support.block)].shape);
    support.stiffness *= width_ / (box.upper - box.lower).x();
    support.block = lowest_;
    for (const double x : {left_, left_ + width_}) {
      support.point = {x, foot_of(whole_, side_).y()};
      model().supports.push_back(support);
    }
  }

  // Dashpots and tractions on the underside and on the top.
  void copy_edges() {
    const auto copy = [&](const auto& edges, auto& list) {
      for (const auto& each : edges) {
        const bool at_foot = is_at_foot(whole_, side_, each.block, each.from, each.to);
        if (!at_foot && !is_at_head(whole_, side_, each.block, each.from, each.to)) continue;
        auto own = each;
        own.block = at_foot ? lowest_ : highest_;
        own.from = {left_, each.from.y()};
        own.to = {left_ + width_, each.from.y()};
        list.push_back(std::move(own));
      }
    };
    copy(whole_.viscous_edges, model().viscous_edges);
    copy(whole_.edge_loads, model().edge_loads);
  }

  const Model& whole_;
  const ContactSet& contacts_;
  const FreeFieldSide& side_;
  double left_;
  double width_;
  FreeFieldColumns& columns_;
  int lowest_ = 0, highest_ = 0;
};

}  // namespace

FreeFieldColumns make_free_field_columns(const Model& model, const ContactSet& contacts) {
  FreeFieldColumns columns;
  columns.model.materials = model.materials;
  columns.model.joints = {whole_block()};  // every pair of neighbours has one of its own
  columns.model.gravity = model.gravity;
  for (const Stage& stage : model.stages) {
    Stage& own = columns.model.stages.emplace_back(model.with_acting_corrections(stage));
    own.removal = {};  // what goes, comes and changes is named by blocks of the whole
    own.rock = {};
  }
  double left = 0;
  for (const FreeFieldSide& side : model.free_field_sides) {
    Column column(model, contacts, side, left, columns);
    column.build();
    left += 2 * column.width();
  }
  finish_model(columns.model);
  return columns;
}

}  // namespace dda
