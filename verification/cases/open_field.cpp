#include "verification/cases/open_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "verification/harness/nearest_block.h"
#include "verification/harness/recorded_run.h"

namespace verify {
namespace {

using dda::Vec2;

constexpr double cycles = 2;
constexpr double line_width = 0.7;  // standard deviation of the forces across the line, in block sides
constexpr double head_start = 0.4;  // wavelengths: half the width of the line

// Periods after which the pulse has passed a place.
double passed_by(const OpenField& field, double place) { return place / field.slowest + cycles + 0.4; }

// How far the field reaches, in wavelengths, so that nothing is back from its edges when the pulse has passed the
// farther place: S waves come back as P waves, and diffracted waves set out at once where the line ends.
struct Reach {
  double ahead, behind, aside;
};

Reach reach_of(const OpenField& field) {
  const double ratio = field.speed() / dda::p_wave_speed(field.rock);
  const double way = field.fastest * passed_by(field, field.far) + head_start;
  return {(way + ratio * field.far) / (1 + ratio), (way - ratio * field.far) / (1 + ratio),
          std::sqrt(std::pow(way / ratio, 2) - field.far * field.far)};
}

Vec2 across(const Vec2& direction) { return {-direction.y(), direction.x()}; }

void add_blocks(const OpenField& field, const Reach& reach, dda::Model& model) {
  const double radius = field.wavelength * std::hypot(std::max(reach.ahead, reach.behind), reach.aside);
  const double pitch = std::min(field.mesh.first.norm(), field.mesh.second.norm());
  const int cells = static_cast<int>(std::ceil(1.5 * radius / pitch));
  for (int i = -cells; i <= cells; ++i)
    for (int j = -cells; j <= cells; ++j)
      for (dda::Ring ring : field.mesh.cell) {
        for (Vec2& vertex : ring) vertex += i * field.mesh.first + j * field.mesh.second;
        const Vec2 middle = dda::area_moments(dda::Polygon{ring, {}}).centroid / field.wavelength;
        const double along = middle.dot(field.direction);
        if (along < -reach.behind || along > reach.ahead) continue;
        if (std::abs(middle.dot(across(field.direction))) > reach.aside) continue;
        model.blocks.emplace_back().shape.outer = ring;
      }
}

dda::Model blocks_of(const OpenField& field, const Reach& reach) {
  dda::Model model;
  model.title = "plane wave in an open field of blocks";
  model.materials = {field.rock};
  model.joints = {field.joint};
  add_blocks(field, reach, model);
  model.stages = {field.stage};
  const double steps = std::ceil(passed_by(field, field.far) / field.frequency() / field.stage.dt);
  model.stages.front().duration = steps * field.stage.dt;
  dda::finish_model(model);  // centroids
  return model;
}

// Finer than the steps: what arrives is compared with the lines between the points.
dda::PiecewiseLinear table_of(const OpenField& field) {
  dda::PiecewiseLinear table;
  const double pitch = field.stage.dt / 8;
  for (int i = 0; (i - 1) * pitch < cycles / field.frequency(); ++i) {
    table.times.push_back(i * pitch);
    table.values.push_back(field.pulse(i * pitch));
  }
  return table;
}

void add_line_of_forces(const OpenField& field, dda::Model& model) {
  const double width = line_width * field.mesh.longest_side();
  const dda::PiecewiseLinear history = table_of(field);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const dda::AreaMoments& moments = model.blocks[i].moments;
    const double place = moments.centroid.dot(field.direction) / width;
    if (std::abs(place) > 4) continue;
    const double force = 1e6 * moments.area * std::exp(-place * place / 2);
    model.point_loads.push_back({static_cast<int>(i), moments.centroid, force * field.particles, history});
  }
}

void add_face_load(const OpenField& field, dda::Model& model) {
  const Vec2 traction = 1e6 * field.particles;
  const dda::PiecewiseLinear history = table_of(field);
  const auto on_face = [&](const Vec2& vertex) { return std::abs(vertex.dot(field.direction)) < 1e-9; };
  for (std::size_t block = 0; block < model.blocks.size(); ++block) {
    const dda::Ring& ring = model.blocks[block].shape.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& next = ring[(i + 1) % ring.size()];
      if (on_face(ring[i]) && on_face(next))
        model.edge_loads.push_back({static_cast<int>(block), ring[i], next, traction, history});
    }
  }
}

void add_receiver(const OpenField& field, double place, dda::Model& model) {
  dda::Measurement measurement;
  measurement.block = nearest_block(model, place * field.direction);
  measurement.point = model.blocks[static_cast<std::size_t>(measurement.block)].moments.centroid;
  for (const dda::Quantity quantity : {dda::Quantity::velocity_x, dda::Quantity::velocity_y}) {
    measurement.quantity = quantity;
    measurement.name = std::to_string(model.measurements.size());
    model.measurements.push_back(measurement);
  }
}

// At the joint before the block at the farther place, a quarter of a block off its middle: there bricks of a running
// bond have one neighbour.
void add_joint_receiver(const OpenField& field, dda::Model& model) {
  const int behind = nearest_block(model, field.far * field.wavelength * field.direction);
  const dda::Block& block = model.blocks[static_cast<std::size_t>(behind)];
  const double half = dda::extent_along(block.shape.outer, field.direction) / 2;
  dda::Measurement measurement;
  measurement.name = "stress";
  measurement.quantity =
      field.kind == dda::WaveKind::s ? dda::Quantity::traction_shear : dda::Quantity::traction_normal;
  measurement.point = block.moments.centroid - half * field.direction + 0.25 * across(field.direction);
  measurement.block = nearest_block(model, measurement.point - half * field.direction);
  measurement.other_block = behind;
  model.measurements.push_back(measurement);
}

}  // namespace

double OpenField::speed() const { return dda::continuum_speed(rock, kind); }

double OpenField::pulse(double t) const {
  const double duration = cycles / frequency();
  if (t <= 0 || t >= duration) return 0;
  return std::pow(std::sin(std::numbers::pi * t / duration), 2) * std::sin(2 * std::numbers::pi * frequency() * t);
}

dda::Model field_with_line(const OpenField& field) {
  dda::Model model = blocks_of(field, reach_of(field));
  add_line_of_forces(field, model);
  for (const double place : {field.near, field.far}) add_receiver(field, place * field.wavelength, model);
  dda::finish_model(model);
  return model;
}

PassingWave run(const OpenField& field, const dda::Model& model, dda::Counters& counters) {
  RecordedRun run = record_run(model);
  counters += run.counters;
  // What comes back from behind the line reaches the nearer place first, after the pulse has passed it.
  const auto passed = static_cast<std::size_t>(passed_by(field, field.near) / field.frequency() / field.stage.dt);
  for (std::size_t i = 0; i < 2; ++i) run.histories[i].resize(passed);
  const Vec2 way = model.measurements[2].point - model.measurements[0].point;
  return {{std::move(run.histories[0]), std::move(run.histories[1])},
          {std::move(run.histories[2]), std::move(run.histories[3])},
          way.dot(field.direction)};
}

dda::Model field_with_face(const OpenField& field) {
  Reach reach = reach_of(field);
  reach.behind = 0;
  dda::Model model = blocks_of(field, reach);
  add_face_load(field, model);
  add_joint_receiver(field, model);
  dda::finish_model(model);
  return model;
}

}  // namespace verify
