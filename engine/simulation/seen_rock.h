// For tests: small dry rock by lot, and the same rock seen from elsewhere: turned, mirrored, moved, larger or with its
// blocks and corners in another order.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {

enum class CutKind {
  squares,     // blocks of one size, four corners at every node
  orthogonal,  // two sets at right angles, spacings by lot
  oblique,     // two sets at any angle: four corners at every node
  bricks,      // running bond
  courses,     // upright joints by lot in every course
  three_sets   // with slivers and needles
};

inline constexpr int cut_kinds = 6;

inline constexpr double drawn_to = 0x1p-36;  // m, corners of the drawings are multiples of it: neighbours share them

inline Vec2 as_drawn(const Vec2& point) {
  return {std::round(point.x() / drawn_to) * drawn_to, std::round(point.y() / drawn_to) * drawn_to};
}

// Lines across all cells, or across those of one course alone.
inline std::vector<Ring> cut_by(const std::vector<Ring>& cells, const Vec2& point, const Vec2& along,
                                double least_area = 2e-2) {
  std::vector<Ring> next;
  for (const Ring& cell : cells) {
    auto [left, right] = cut(cell, point, along);
    const bool is_cut =
        left.size() > 2 && right.size() > 2 && signed_area(left) > least_area && signed_area(right) > least_area;
    if (!is_cut) {
      next.push_back(cell);
      continue;
    }
    next.push_back(std::move(left));
    next.push_back(std::move(right));
  }
  return next;
}

inline std::vector<Ring> in_courses(SeededNumbers& random, double width, double height, bool is_bond) {
  std::vector<Ring> cells;
  const int courses = random.integer(3, 6);
  const double high = height / courses;
  const int columns = random.integer(3, 5);
  for (int i = 0; i < courses; ++i) {
    std::vector<Ring> course{box_ring(0, i * high, width, (i + 1) * high)};
    for (int k = 0; k <= columns; ++k) {
      const double place = is_bond ? (k + 0.5 * (i % 2)) / columns * width : random.number(0, width);
      if (place > 0.05 * width && place < 0.95 * width) course = cut_by(course, {place, 0}, {0, 1}, 1e-3);
    }
    cells.insert(cells.end(), course.begin(), course.end());
  }
  return cells;
}

inline std::vector<Ring> cut_across(SeededNumbers& random, std::vector<Ring> cells, double angle, double spacing,
                                    bool is_even) {
  const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  double place = -8 + spacing * random.number(0, 1);
  for (; place < 8; place += spacing * (is_even ? 1 : random.number(0.5, 1.5)))
    cells = cut_by(cells, place * across, along);
  return cells;
}

inline std::vector<Ring> dry_cells(CutKind kind, SeededNumbers& random) {
  const double width = 4, height = 3;
  if (kind == CutKind::bricks || kind == CutKind::courses)
    return in_courses(random, width, height, kind == CutKind::bricks);
  if (kind == CutKind::squares) {
    std::vector<Ring> cells;
    const int size = random.integer(3, 5);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) cells.push_back(box_ring(i, j, i + 1, j + 1));
    return cells;
  }
  std::vector<Ring> cells{box_ring(0, 0, width, height)};
  const double angle = kind == CutKind::orthogonal ? 0 : random.number(0, std::numbers::pi);
  const double between = kind == CutKind::orthogonal ? std::numbers::pi / 2 : random.number(0.7, 2.4);
  cells = cut_across(random, cells, angle, random.number(0.7, 1.2), random.chance(0.5));
  cells = cut_across(random, cells, angle + between, random.number(0.7, 1.2), random.chance(0.5));
  if (kind == CutKind::three_sets)
    cells = cut_across(random, cells, angle + between / 2 + random.number(-0.1, 0.1), random.number(1, 1.6), false);
  return cells;
}

inline Block block_of(const std::string& name, const Ring& ring) {
  Block block;
  block.name = name;
  for (const Vec2& corner : ring) block.shape.outer.push_back(as_drawn(corner));
  return block;
}

inline void add_held(const std::string& name, double left, double bottom, double right, double top, Model& model) {
  model.held_blocks.emplace_back().block = static_cast<int>(model.blocks.size());
  model.blocks.push_back(block_of(name, box_ring(left, bottom, right, top)));
}

// On a held floor, half of them between held walls. Without stages.
inline Model dry_rock(CutKind kind, std::uint64_t seed) {
  SeededNumbers random(seed);
  Model model;
  model.materials = {{"rock", 2600, 10e9, random.number(0, 0.3), PlaneState::strain}};
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = random.number(0.2, 0.7);
  joint.automatic_stiffness = random.chance(0.3);
  model.joints = {joint};
  double width = 0, height = 0;
  for (const Ring& ring : dry_cells(kind, random)) {
    model.blocks.push_back(block_of("block " + std::to_string(model.blocks.size()), ring));
    for (const Vec2& corner : model.blocks.back().shape.outer) {
      width = std::max(width, corner.x());
      height = std::max(height, corner.y());
    }
  }
  add_held("floor", -1, -1, width + 1, 0, model);
  if (random.chance(0.5)) {
    add_held("left", -1, 0, 0, height, model);
    add_held("right", width, 0, width + 1, height, model);
  }
  model.gravity = {random.number(-3, 3), -9.81};
  return model;
}

// As deep below ground: cut from one piece between held sides, under stress and weight, with joints that slide or
// break. A block or two are taken out in the second stage.
inline Model stressed_rock(std::uint64_t seed) {
  SeededNumbers random(seed);
  Model model;
  model.materials = {{"rock", 2600, random.magnitude(9, 10.5), random.number(0, 0.3), PlaneState::strain}};
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = random.number(0.25, 0.8);
  const double pressure = random.magnitude(4.5, 6.5);
  if (random.chance(0.4)) {
    joint.cohesion = random.magnitude(-1, 0.5) * pressure;
    joint.tensile_strength = random.magnitude(-2, 0) * pressure;
  }
  joint.automatic_stiffness = random.chance(0.3);
  model.joints = {joint};
  const CutKind kind = random.chance(0.5) ? CutKind::oblique : CutKind::three_sets;
  for (const Ring& ring : dry_cells(kind, random))
    model.blocks.push_back(block_of("block " + std::to_string(model.blocks.size()), ring));
  const int removed = random.integer(0, static_cast<int>(model.blocks.size()) - 1);
  add_held("floor", -1, -1, 5, 0, model);
  add_held("left", -1, 0, 0, 3, model);
  add_held("right", 4, 0, 5, 3, model);
  add_held("roof", -1, 3, 5, 4, model);
  const Vec3 stress = -pressure * Vec3(random.number(0.5, 2), 1, random.number(-0.3, 0.3));
  for (Block& block : model.blocks) block.initial_stress = stress;
  model.gravity = {0, -9.81};
  model.stages.resize(2);
  model.stages[1].removal.blocks = {removed};
  return model;
}

// ---- The same seen from elsewhere.

struct View {
  std::string name = "as drawn";
  Mat2 turn = Mat2::Identity();  // a reflection where its determinant is negative
  Vec2 shift = Vec2::Zero();     // m
  double scale = 1;              // of lengths; of times its root, of moduli, stresses and strengths itself
  std::vector<int> order = {};   // which block comes first, second and so on; empty: as drawn
  int first_corner = 0;          // rings begin at this one
  double jitter = 0;             // share of the coordinates by which they are off by lot: round-off

  [[nodiscard]] bool mirrors() const { return turn.determinant() < 0; }
};

inline std::vector<int> order_of(const View& view, std::size_t blocks) {
  if (!view.order.empty()) return view.order;
  std::vector<int> order(blocks);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

// A stress (xx, yy, xy) where the axes have been turned, or mirrored.
inline Vec3 turned(const Mat2& turn, const Vec3& stress) {
  Mat2 tensor;
  tensor << stress(0), stress(2), stress(2), stress(1);
  const Mat2 seen = turn * tensor * turn.transpose();
  return {seen(0, 0), seen(1, 1), seen(0, 1)};
}

inline Model seen(const Model& drawn, const View& view) {
  Model model = drawn;
  const std::vector<int> order = order_of(view, drawn.blocks.size());
  std::vector<int> place(order.size());
  SeededNumbers random(99);
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    Block& block = model.blocks[i] = drawn.blocks[static_cast<std::size_t>(order[i])];
    Ring& ring = block.shape.outer;
    for (Vec2& corner : ring) {
      corner = view.scale * (view.turn * corner) + view.shift;
      if (view.jitter > 0)
        for (double& each : corner) each *= 1 + view.jitter * random.integer(-1, 1);
    }
    if (view.mirrors()) std::reverse(ring.begin(), ring.end());
    std::rotate(ring.begin(), ring.begin() + view.first_corner % static_cast<int>(ring.size()), ring.end());
    block.initial_velocity = std::sqrt(view.scale) * (view.turn * block.initial_velocity);
    block.initial_stress = view.scale * turned(view.turn, block.initial_stress);
  }
  for (HeldBlock& held : model.held_blocks) held.block = place[static_cast<std::size_t>(held.block)];
  model.gravity = view.turn * model.gravity;
  for (Material& material : model.materials) material.young *= view.scale;
  for (JointMaterial& joint : model.joints)
    for (double* strength : {&joint.cohesion, &joint.tensile_strength}) *strength *= view.scale;
  for (Stage& stage : model.stages) {
    for (int& block : stage.removal.blocks) block = place[static_cast<std::size_t>(block)];
    stage.dt *= std::sqrt(view.scale);
    stage.chosen.dt.first_steps.dt *= std::sqrt(view.scale);
    stage.duration *= std::sqrt(view.scale);
  }
  return model;
}

// Displacements of the centroids and rotations, of blocks in their order, as the rock as drawn has them.
inline std::vector<Vec3> motion_of(const Simulation& simulation, const View& view) {
  const std::vector<int> order = order_of(view, simulation.state().displacement.size());
  std::vector<Vec3> all(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vec6& own = simulation.state().displacement[i];
    Vec3& into = all[static_cast<std::size_t>(order[i])];
    into.head<2>() = view.turn.transpose() * own.head<2>() / view.scale;
    into(2) = view.mirrors() ? -own(2) : own(2);
  }
  return all;
}

// The largest difference, as a share of the largest motion.
inline double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0, most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, a[i].cwiseAbs().maxCoeff());
    most = std::max(most, (a[i] - b[i]).cwiseAbs().maxCoeff());
  }
  return most / largest;
}

}  // namespace dda
