#include "verification/cases/cavity_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "engine/builder/generators.h"
#include "verification/exact/wave_speeds.h"

namespace verify {
namespace {

constexpr double pi = std::numbers::pi;

dda::Model bonded_rock() {
  dda::Model model;
  model.materials = {{"rock", cavity_density, cavity_young, cavity_poisson, dda::PlaneState::strain}};
  dda::JointMaterial bond;
  bond.bonded = true;
  model.joints = {bond};
  return model;
}

// What the cavity leaves of the square whose centre has these coordinates in squares: all, none, or the half away from
// the cavity.
dda::Ring rest_of_square(const OctagonMesh& mesh, int column, int row) {
  const double h = mesh.size;
  const dda::Vec2 lower((column - 0.5) * h, (row - 0.5) * h);
  const dda::Vec2 upper = lower + dda::Vec2(h, h);
  dda::Ring whole{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}};
  const int half = (mesh.straight - 1) / 2;
  const int u = std::abs(column);
  const int v = std::abs(row);
  if (u > half + mesh.slant || v > half + mesh.slant || u + v > 2 * half + mesh.slant + 1) return whole;
  if (u <= half || v <= half || u + v < 2 * half + mesh.slant + 1) return {};
  const std::size_t inner = column > 0 ? (row > 0 ? 0 : 3) : (row > 0 ? 1 : 2);  // the corner towards the cavity
  dda::Ring triangle;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != inner) triangle.push_back(whole[i]);
  return triangle;
}

}  // namespace

exact::Cavity cavity_in_rock(double radius) {
  const double p = exact::p_speed_plane_strain(cavity_young, cavity_poisson, cavity_density);
  const double s = exact::s_speed(cavity_young, cavity_poisson, cavity_density);
  return {radius, cavity_density * p * p, cavity_density * s * s, cavity_density};
}

dda::Model ring_mesh(int sectors, double outer_radius) {
  dda::Model model = bonded_rock();
  const double angle = 2 * pi / sectors;
  dda::RingsSpec spec;
  spec.sectors = sectors;
  spec.first_corner = -angle / 2;
  for (double radius = 1; radius < outer_radius; radius += angle * std::min(radius, 2.0)) spec.radii.push_back(radius);
  spec.radii.push_back(outer_radius);
  for (double& radius : spec.radii) radius *= std::sqrt(angle / std::sin(angle));  // polygons of the circles' areas
  dda::append_rings(model, spec);
  dda::finish_model(model);
  return model;
}

dda::Model octagon_mesh(const OctagonMesh& mesh) {
  dda::Model model = bonded_rock();
  for (int row = -mesh.half_width; row <= mesh.half_width; ++row)
    for (int column = -mesh.half_width; column <= mesh.half_width; ++column) {
      dda::Ring rest = rest_of_square(mesh, column, row);
      if (rest.empty()) continue;
      dda::Block block;
      block.name = fmt::format("{}.{}", column, row);
      block.shape.outer = std::move(rest);
      model.blocks.push_back(std::move(block));
    }
  dda::finish_model(model);
  return model;
}

double octagon_source_radius(const OctagonMesh& mesh) {
  const double side = mesh.straight + 2 * mesh.slant;
  const double area = mesh.size * mesh.size * (side * side - 2 * mesh.slant * mesh.slant);
  return exact::octagon_source_radius(std::sqrt(area / pi));
}

void set_stage(dda::Model& model, const dda::Integrator& integrator, double dt, double duration) {
  dda::Stage stage;
  stage.kinematics = dda::Kinematics::small;
  stage.integrator = integrator;
  stage.dt = dt;
  stage.duration = duration;
  model.stages = {stage};
  dda::finish_model(model);
}

void probe(dda::Model& model, int block) {
  const dda::Vec2 at = model.blocks[static_cast<std::size_t>(block)].moments.centroid;
  for (const dda::Quantity quantity : {dda::Quantity::stress_xx, dda::Quantity::stress_yy, dda::Quantity::stress_xy}) {
    dda::Measurement measurement;
    measurement.name = fmt::format("{}", model.measurements.size());
    measurement.quantity = quantity;
    measurement.block = block;
    measurement.point = at;
    model.measurements.push_back(measurement);
  }
}

ProbeHistory probe_history(const dda::Model& model, const RecordedRun& run, std::size_t i) {
  const auto block = static_cast<std::size_t>(model.measurements[3 * i].block);
  const dda::Vec2 at = model.blocks[block].moments.centroid;
  const dda::Vec2 n = at.normalized();
  ProbeHistory history;
  history.radius = at.norm();
  for (std::size_t k = 0; k < run.histories[3 * i].size(); ++k) {
    const double xx = run.histories[3 * i][k];
    const double yy = run.histories[3 * i + 1][k];
    const double xy = run.histories[3 * i + 2][k];
    const double radial = n.x() * n.x() * xx + n.y() * n.y() * yy + 2 * n.x() * n.y() * xy;
    history.radial.push_back(radial);
    history.hoop.push_back(xx + yy - radial);
  }
  return history;
}

}  // namespace verify
