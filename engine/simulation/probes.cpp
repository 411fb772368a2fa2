#include "engine/simulation/probes.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/core/error.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

bool is_traction(Quantity quantity) {
  return quantity == Quantity::traction_normal || quantity == Quantity::traction_shear;
}

bool joins(const Interface& interface, int a, int b) {
  return (interface.block_a == a && interface.block_b == b) || (interface.block_a == b && interface.block_b == a);
}

[[noreturn]] void fail(const Measurement& measurement) {
  throw InputError("", fmt::format("measurements \"{}\": point", measurement.name),
                   fmt::format("[{}, {}]", measurement.point.x(), measurement.point.y()),
                   "a point on an edge along which two blocks touch");
}

int interface_of(const Simulation& simulation, const Measurement& measurement) {
  const std::vector<Interface>& interfaces = simulation.contacts().interfaces;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    if (interfaces[i].length == 0 || !joins(interfaces[i], measurement.block, measurement.other_block)) continue;
    const double away = distance(Segment{interfaces[i].from, interfaces[i].to}, measurement.point);
    if (away >= least) continue;
    least = away;
    nearest = static_cast<int>(i);
  }
  if (nearest < 0 || least > simulation.model().length_tolerance) fail(measurement);
  return nearest;
}

Vec2 traction(const Simulation& simulation, int interface) {
  const auto i = static_cast<std::size_t>(interface);
  const ContactSet& contacts = simulation.contacts();
  return mean_traction(simulation.model(), contacts.interfaces[i], contacts.elements[i], simulation.interface_state(i));
}

Vec2 point_acceleration(const Simulation& simulation, const Measurement& measurement) {
  const auto i = static_cast<std::size_t>(measurement.block);
  const Vec2 offset = measurement.point - simulation.model().blocks[i].moments.centroid;
  return displacement_rows(simulation.state().deformation[i] * offset) * simulation.state().acceleration[i];
}

bool is_of_bolt(Quantity quantity) {
  return quantity == Quantity::bolt_force || quantity == Quantity::bolt_shear || quantity == Quantity::bolt_elongation;
}

// Of one link, or of the bolt: the sum of elongations, the force that is largest in magnitude.
double bolt_value(const Simulation& simulation, const Measurement& measurement) {
  const Bolt& bolt = simulation.model().bolts[static_cast<std::size_t>(measurement.bolt)];
  const BoltSet& bolts = simulation.bolts();
  const bool one = measurement.link >= 0;
  const std::size_t first = one ? static_cast<std::size_t>(measurement.link) : 0;
  const std::size_t last = one ? first + 1 : bolt.links.size();
  const bool elongation = measurement.quantity == Quantity::bolt_elongation;
  double value = 0;
  for (std::size_t link = first; link < last; ++link) {
    const Vec2& force = bolts.state(measurement.bolt, link).force;
    const double own = bolt.spacing * (measurement.quantity == Quantity::bolt_shear ? force(1) : force(0));
    if (elongation) {
      value += bolts.elongation(measurement.bolt, link);
    } else if (std::abs(own) > std::abs(value)) {
      value = own;
    }
  }
  return value;
}

double block_value(const Simulation& simulation, const Measurement& measurement) {
  const Model& model = simulation.model();
  const State& state = simulation.state();
  const auto i = static_cast<std::size_t>(measurement.block);
  switch (measurement.quantity) {
    case Quantity::stress_xx: return state.stress[i](0);
    case Quantity::stress_yy: return state.stress[i](1);
    case Quantity::stress_xy: return state.stress[i](2);
    case Quantity::displacement_x: return point_displacement(model, state, measurement.block, measurement.point).x();
    case Quantity::displacement_y: return point_displacement(model, state, measurement.block, measurement.point).y();
    case Quantity::velocity_x: return point_velocity(model, state, measurement.block, measurement.point).x();
    case Quantity::velocity_y: return point_velocity(model, state, measurement.block, measurement.point).y();
    case Quantity::acceleration_x: return point_acceleration(simulation, measurement).x();
    case Quantity::acceleration_y: return point_acceleration(simulation, measurement).y();
    case Quantity::rotation: return state.displacement[i](2);
    case Quantity::traction_normal:
    case Quantity::traction_shear:
    case Quantity::bolt_force:
    case Quantity::bolt_shear:
    case Quantity::bolt_elongation: break;
  }
  return std::nan("");
}

}  // namespace

Probes::Probes(const Simulation& simulation) {
  for (const Measurement& measurement : simulation.model().measurements) {
    Place& place = places_.emplace_back();
    if (!is_traction(measurement.quantity)) continue;
    if (simulation.follows_contacts()) {
      place.edge = shared_edge(simulation.model(), measurement.block, measurement.other_block, measurement.point);
      if (!place.edge) fail(measurement);
    } else {
      place.interface = interface_of(simulation, measurement);
    }
  }
}

void Probes::sample(const Simulation& simulation, std::span<double> values) const {
  const std::vector<Measurement>& measurements = simulation.model().measurements;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (is_of_bolt(measurements[i].quantity)) {
      values[i] = bolt_value(simulation, measurements[i]);
      continue;
    }
    if (!is_traction(measurements[i].quantity)) {
      values[i] = block_value(simulation, measurements[i]);
      continue;
    }
    const Vec2 mean = places_[i].edge ? traction_along(simulation.model(), simulation.state(), simulation.contacts(),
                                                       *places_[i].edge)
                                      : traction(simulation, places_[i].interface);
    values[i] = measurements[i].quantity == Quantity::traction_normal ? mean(0) : mean(1);
  }
}

}  // namespace dda
