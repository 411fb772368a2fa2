#include "verification/precision/plane_run.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/builder/generators.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/recorded_run.h"
#include "verification/precision/scheme_settings.h"
#include "verification/thesis/reference.h"
#include "verification/yardstick/explicit_plate.h"

namespace verify {
namespace {

constexpr double distance = 30;                              // m, of the receivers
constexpr double source_reach = 6;                           // radii: exp(-18) of the force
constexpr std::array<double, 3> directions = {0, 22.5, 45};  // degrees

constexpr double no_reading = std::numeric_limits<double>::quiet_NaN();

using Place = Eigen::Vector2d;

int steps_of(double dt) { return static_cast<int>(std::floor(plane_duration / dt)); }

int cells_along(double size) { return 2 * static_cast<int>(std::lround(plane_half_side / size)); }

// The places of a grid of points, half a cell off the source or on it, that are nearest to the wanted ones.
std::vector<Place> receivers(double size, double offset) {
  std::vector<Place> places;
  for (const double degrees : directions) {
    const double angle = degrees * std::numbers::pi / 180;
    const auto nearest = [&](double wanted) { return (std::round(wanted / size - offset) + offset) * size; };
    places.emplace_back(nearest(distance * std::cos(angle)), nearest(distance * std::sin(angle)));
  }
  return places;
}

// 2 x 2 Gauss points a block: exact for what is cubic in it.
void add_source(dda::Model& model, double size) {
  const double gauss = size / 2 / std::sqrt(3.0);
  const double reach = source_reach * plane_pulse().radius;
  const dda::SineCycles once{plane_pulse().frequency, 1, 0};
  const dda::SineCycles twice{2 * plane_pulse().frequency, 2, 0};
  for (std::size_t block = 0; block < model.blocks.size(); ++block) {
    const dda::Vec2 middle = model.blocks[block].shape.outer[0] + dda::Vec2(size / 2, size / 2);
    if (middle.norm() > reach) continue;
    for (const auto& [x, y] : {std::pair{-gauss, -gauss}, {gauss, -gauss}, {gauss, gauss}, {-gauss, gauss}}) {
      const dda::Vec2 point = middle + dda::Vec2(x, y);
      const exact::SourceForce force = exact::source_force(plane_pulse(), point.x(), point.y());
      const dda::Vec2 share = size * size / 4 * dda::Vec2(force.x, force.y);
      model.point_loads.push_back({static_cast<int>(block), point, share, once});
      model.point_loads.push_back({static_cast<int>(block), point, -share / 2, twice});
    }
  }
}

void add_receivers(dda::Model& model, double size) {
  const int along = cells_along(size);
  for (const Place& place : receivers(size, 0.5)) {
    dda::Measurement measurement;
    const int column = static_cast<int>(std::floor(place.x() / size)) + along / 2;
    const int row = static_cast<int>(std::floor(place.y() / size)) + along / 2;
    measurement.block = row * along + column;
    measurement.point = place;
    for (const dda::Quantity quantity : {dda::Quantity::displacement_x, dda::Quantity::displacement_y}) {
      measurement.quantity = quantity;
      measurement.name = fmt::format("u{}", model.measurements.size());
      model.measurements.push_back(measurement);
    }
  }
}

// Histories: x and y of each place in turn.
double plane_error(const std::vector<Place>& places, const std::vector<std::vector<double>>& histories, double dt) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto samples = histories[2 * i].size();
    const PlaneHistory exact = exact_displacement(places[i].x(), places[i].y(), dt, static_cast<int>(samples));
    for (std::size_t n = 0; n < samples; ++n) {
      difference += std::pow(histories[2 * i][n] - exact.x[n], 2) + std::pow(histories[2 * i + 1][n] - exact.y[n], 2);
      size += exact.x[n] * exact.x[n] + exact.y[n] * exact.y[n];
    }
  }
  return std::sqrt(difference / size);
}

std::vector<yardstick::NodeForce> node_forces(const yardstick::Plate& plate) {
  std::vector<yardstick::NodeForce> forces;
  for (int row = 0; row <= plate.rows; ++row) {
    for (int column = 0; column <= plate.columns; ++column) {
      const Place place = plate.side * Place(column - plate.columns / 2, row - plate.rows / 2);
      if (place.norm() > source_reach * plane_pulse().radius) continue;
      const exact::SourceForce force = exact::source_force(plane_pulse(), place.x(), place.y());
      forces.push_back({plate.node(column, row), plate.side * plate.side * Place(force.x, force.y)});
    }
  }
  return forces;
}

PrecisionResult run_yardstick(const PrecisionJob& job) {
  const ThesisBar& rock = thesis_reference().bar;
  const int along = cells_along(job.size);
  const yardstick::Plate plate{rock.density, rock.young, rock.poisson, job.size, along, along};
  const std::vector<Place> places = receivers(job.size, 0);
  std::vector<std::vector<double>> histories(2 * places.size());
  const double start = cpu_seconds();
  yardstick::ExplicitPlate run(plate, job.dt, node_forces(plate));
  for (int n = 0; n <= steps_of(job.dt); ++n) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Place node = places[i] / job.size + Place(along / 2.0, along / 2.0);
      const Place moved = run.displacement().col(
          plate.node(static_cast<int>(std::lround(node.x())), static_cast<int>(std::lround(node.y()))));
      histories[2 * i].push_back(moved.x());
      histories[2 * i + 1].push_back(moved.y());
    }
    run.step(exact::pulse_history(plane_pulse().frequency, n * job.dt));
  }
  const double cpu_s = cpu_seconds() - start;
  return {plane_error(places, histories, job.dt),
          no_reading,
          along * along,
          static_cast<double>(steps_of(job.dt)),
          0,
          0,
          cpu_s};
}

}  // namespace

const exact::PlanePulse& plane_pulse() {
  static const ThesisBar& rock = thesis_reference().bar;
  static const exact::PlanePulse pulse{rock.density,
                                       exact::p_speed_plane_stress(rock.young, rock.poisson, rock.density),
                                       exact::s_speed(rock.young, rock.poisson, rock.density),
                                       5,
                                       100,
                                       1e6};
  return pulse;
}

PlaneHistory exact_displacement(double x, double y, double dt, int samples) {
  const double r = std::hypot(x, y);
  const exact::DisplacementHistory wave = exact::displacement_history(plane_pulse(), r, dt, samples);
  PlaneHistory history;
  for (std::size_t n = 0; n < wave.outward.size(); ++n) {
    history.x.push_back((wave.outward[n] * x + wave.clockwise[n] * y) / r);
    history.y.push_back((wave.outward[n] * y - wave.clockwise[n] * x) / r);
  }
  return history;
}

dda::Model plane_model(const PrecisionJob& job) {
  const ThesisBar& rock = thesis_reference().bar;
  dda::Model model;
  model.title = job.key();
  model.materials.push_back({"rock", rock.density, rock.young, rock.poisson, dda::PlaneState::stress});
  model.joints.push_back(joint_of(job.scheme));
  const int along = cells_along(job.size);
  dda::GridSpec grid;
  grid.origin = {-plane_half_side, -plane_half_side};
  grid.columns = grid.rows = along;
  grid.block_width = grid.block_height = job.size;
  dda::append_grid(model, grid);
  add_source(model, job.size);
  add_receivers(model, job.size);
  model.stages.push_back(stage_of(job.scheme));
  model.stages.back().dt = job.dt;
  model.stages.back().duration = steps_of(job.dt) * job.dt;
  dda::finish_model(model);
  return model;
}

PrecisionResult run_plane(const PrecisionJob& job) {
  if (job.scheme.is_yardstick()) return run_yardstick(job);
  const dda::Model model = plane_model(job);
  const RecordedRun run = record_run(model);
  return result_of(run, model, {plane_error(receivers(job.size, 0.5), run.histories, job.dt), no_reading});
}

}  // namespace verify
