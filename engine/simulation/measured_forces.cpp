#include "engine/simulation/measured_forces.h"

#include <algorithm>

#include "engine/contact/contact_set.h"
#include "engine/geometry/segment.h"
#include "engine/model/lining_chord.h"
#include "engine/model/moving_stages.h"
#include "engine/model/quantity_names.h"
#include "engine/model/tolerance.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/linear_states.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

bool contains(const std::vector<int>& ascending, int value) {
  return std::binary_search(ascending.begin(), ascending.end(), value);
}

// `force` is conjugate to the translation of a block and to its turn about its centroid.
ForceAndMoment moved_to(const Vec2& about, const BlockSystem& system, int block, const Vec3& force) {
  const Model& model = system.model;
  const Vec2 centroid = system.geometry_moves() ? local_centroid(model, system.state, block)
                                                : local_place(model, model.blocks[at(block)].moments.centroid);
  return force + Vec3(0, 0, cross(centroid - local_place(model, about), force.head<2>()));
}

// s, of the material damping in force: springs with the stiffness K resist velocities v with this times K v.
double damping_of_stiffness(const BlockSystem& system) {
  if (!system.plan.linear || system.plan.is_static) return 0;
  return system.stage_in_force().material_damping.stiffness;
}

// What a second of the velocities of now would make an interface of a linear scene carry more.
InterfaceState rate_of(const BlockSystem& system, std::size_t i) {
  const InterfaceElement& element = system.contacts.elements[i];
  const auto stress_rate = [&](int block) -> Vec3 {
    return system.terms.elasticity[at(block)] * system.state.velocity[at(block)].tail<3>();
  };
  return linear_state(element, Vec4::Zero(), system.state.velocity[at(element.block_a)],
                      system.state.velocity[at(element.block_b)], stress_rate(element.block_a),
                      stress_rate(element.block_b));
}

// On the rows of an interface, beyond what its state keeps: dashpots and material damping.
Vec4 damping_of_contact(const BlockSystem& system, std::size_t i) {
  const double damping = damping_of_stiffness(system);
  if (damping == 0) return system.contacts.states[i].dashpot;
  return damping * rate_of(system, i).force;
}

// The same of the spring of a support, in x and y.
Vec2 damping_of_support(const BlockSystem& system, std::size_t i) {
  const SupportElement& support = system.supports[i];
  const Vec2 velocity = support.rows * system.state.velocity[at(support.block)] -
                        prescribed_velocity(system.model.supports[i], system.state.time);
  return damping_of_stiffness(system) * (support.stiffness * velocity);
}

// The cubic law's normal force is the one its reconstruction has at the interface, as for tractions.
Vec4 at_interface(const BlockSystem& system, std::size_t i, const InterfaceState& state) {
  const ContactSet& contacts = system.contacts;
  const InterfaceElement& element = contacts.elements.but_for_blocks(i);
  Vec4 force = state.force;
  if (element.law == InterfaceLaw::cubic)
    force(0) = element.length * mean_traction(system.model, contacts.interfaces[i], element, state)(0);
  return force;
}

// Forces on the rows of an interface.
Vec4 carried(const BlockSystem& system, std::size_t i) {
  const Vec4 force = at_interface(system, i, interface_state_now(system, i));
  const double damping = damping_of_stiffness(system);
  if (damping == 0) return force + system.contacts.states[i].dashpot;
  return force + damping * at_interface(system, i, rate_of(system, i));
}

// On one of the two blocks, whose rows these are, about its centroid.
Vec3 on_block(const InterfaceElement& element, const Mat46& rows, const Vec4& force) {
  if (is_lone_vertex(element)) return -rows.topLeftCorner<2, 3>().transpose() * force.head<2>();
  return -rows.leftCols<3>().transpose() * force;
}

bool has_dampers(const BlockSystem& system) {
  return damping_of_stiffness(system) != 0 ||
         std::ranges::any_of(system.model.joints, [](const JointMaterial& joint) { return joint.contact_damping > 0; });
}

// What a block has to overcome of dampers in its contacts and supports, about its centroid.
Vec3 resisted_by_dampers(const BlockSystem& system, int block) {
  Vec3 sum = Vec3::Zero();
  if (!has_dampers(system)) return sum;
  InterfaceElement room;
  for (std::size_t i = 0; i < system.contacts.elements.size(); ++i) {
    const InterfaceElement& element = system.contacts.elements.read(i, room);
    if (element.block_a == block) sum -= on_block(element, element.rows_a, damping_of_contact(system, i));
    if (element.block_b == block) sum -= on_block(element, element.rows_b, damping_of_contact(system, i));
  }
  for (std::size_t i = 0; i < system.supports.size(); ++i)
    if (system.supports[i].block == block)
      sum += system.supports[i].rows.leftCols<3>().transpose() * damping_of_support(system, i);
  return sum;
}

bool is_left_of(const Measurement& line, const Vec2& point, double tolerance) {
  const Vec2 along = (line.to - line.from).normalized();
  return cross(along, point - line.from) >= -tolerance;
}

bool is_beside(const Measurement& line, const Vec2& point, double tolerance) {
  const double length = (line.to - line.from).norm();
  const double place = (line.to - line.from).dot(point - line.from) / length;
  return place >= -tolerance && place <= length + tolerance;
}

// Which way a contact, a bolt or a lining goes through a cut: 1 where its block a is on the measured side, -1 where
// block b is, 0 where it is not cut.
int side_of_line(const Model& model, const Measurement& line, int block_a, int block_b, const Vec2& middle) {
  const double tolerance = point_tolerance(model);
  const bool a = is_left_of(line, model.blocks[at(block_a)].moments.centroid, tolerance);
  const bool b = is_left_of(line, model.blocks[at(block_b)].moments.centroid, tolerance);
  if (a == b || !is_beside(line, middle, tolerance)) return 0;
  return a ? 1 : -1;
}

int side_between(const Model& model, const Measurement& measurement, const Interface& interface) {
  int side = 0;
  if (contains(measurement.blocks, interface.block_a) && contains(measurement.others, interface.block_b)) side = 1;
  if (contains(measurement.others, interface.block_a) && contains(measurement.blocks, interface.block_b)) side = -1;
  if (side == 0 || !measurement.on_line) return side;
  const Segment line{measurement.from, measurement.to};
  const double tolerance = point_tolerance(model);
  return distance(line, interface.from) <= tolerance && distance(line, interface.to) <= tolerance ? side : 0;
}

int side_cut(const Model& model, const Measurement& measurement, const Interface& interface) {
  if (measurement.quantity == Quantity::contact_force) return side_between(model, measurement, interface);
  return side_of_line(model, measurement, interface.block_a, interface.block_b, (interface.from + interface.to) / 2);
}

// Calls visit(index, block, force, carried) for every contact that is cut: its block on the measured side, the force on
// that about its centroid, and the forces on the contact's rows.
template <typename Visit>
void visit_cut(const BlockSystem& system, const Measurement& measurement, const Cut& cut, Visit visit) {
  const ContactSet& contacts = system.contacts;
  const std::size_t count = cut.interfaces ? cut.interfaces->size() : contacts.interfaces.size();
  InterfaceElement room;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = cut.interfaces ? (*cut.interfaces)[k] : k;
    const InterfaceElement& element = contacts.elements.read(i, room);
    const int side = side_cut(system.model, measurement, contacts.interfaces[i]);
    if (side == 0) continue;
    const Vec4 force = carried(system, i);
    if (side > 0) {
      visit(i, element.block_a, on_block(element, element.rows_a, force), force);
    } else {
      visit(i, element.block_b, on_block(element, element.rows_b, force), force);
    }
  }
}

ForceAndMoment across_linings(const BlockSystem& system, const Measurement& line) {
  ForceAndMoment sum = ForceAndMoment::Zero();
  std::size_t next = 0;
  for (const Lining& lining : system.model.linings) {
    for (std::size_t i = 0; i < lining.elements(); ++i) {
      const LiningElement& element = system.reinforcement.linings.elements()[next++];
      const Vec2 middle = middle_of(lining, i);
      const int side = side_of_line(system.model, line, element.block_a, element.block_b, middle);
      if (side == 0) continue;
      const Mat36& rows = side > 0 ? element.rows.a : element.rows.b;
      const Vec3 force = -rows.leftCols<3>().transpose() * element.force();
      sum += moved_to(line.about, system, side > 0 ? element.block_a : element.block_b, force);
    }
  }
  return sum;
}

ForceAndMoment across_bolts(const BlockSystem& system, const Measurement& line) {
  ForceAndMoment sum = ForceAndMoment::Zero();
  std::size_t next = 0;
  for (const Bolt& bolt : system.model.bolts) {
    for (const BoltLink& drawn : bolt.links) {
      const LinkElement& link = system.reinforcement.bolts.links()[next++];
      const Vec2 middle = (drawn.point_a + drawn.point_b) / 2;
      const int side = side_of_line(system.model, line, drawn.block_a, drawn.block_b, middle);
      if (side == 0) continue;
      const Mat26& rows = side > 0 ? link.rows.a : link.rows.b;
      const Vec3 force = -rows.leftCols<3>().transpose() * link.state.force;
      sum += moved_to(line.about, system, side > 0 ? drawn.block_a : drawn.block_b, force);
    }
  }
  return sum;
}

}  // namespace

ForceAndMoment reaction(const BlockSystem& system, const Measurement& measurement) {
  ForceAndMoment sum = ForceAndMoment::Zero();
  for (const int i : measurement.supports) {
    const SupportElement& support = system.supports[at(i)];
    const Vec2 spring = support.stiffness * support.gap;
    const Vec6 force = -support.rows.transpose() * (spring + damping_of_support(system, at(i)));
    sum += moved_to(measurement.about, system, support.block, force.head<3>());
  }
  for (const int block : measurement.blocks) {
    const Vec3 internal = system.forces.internal_old.segment<3>(6 * block);
    const Vec3 force = internal + resisted_by_dampers(system, block) - system.forces.load_old.segment<3>(6 * block);
    sum += moved_to(measurement.about, system, block, force);
  }
  return sum;
}

Cut make_cut(const BlockSystem& system, const Measurement& measurement) {
  const Model& model = system.model;
  if (contacts_move(model) || model.removes_blocks() || model.adds_blocks()) return {};
  Cut cut{std::vector<std::size_t>()};
  const std::vector<Interface>& interfaces = system.contacts.interfaces;
  for (std::size_t i = 0; i < interfaces.size(); ++i)
    if (side_cut(system.model, measurement, interfaces[i]) != 0) cut.interfaces->push_back(i);
  return cut;
}

bool cuts_something(const BlockSystem& system, const Measurement& measurement) {
  const std::vector<Interface>& interfaces = system.contacts.interfaces;
  return std::any_of(interfaces.begin(), interfaces.end(),
                     [&](const Interface& interface) { return side_cut(system.model, measurement, interface) != 0; });
}

Eigen::Vector4d contact_force(const BlockSystem& system, const Measurement& measurement, const Cut& cut) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  const InterfaceElements& elements = system.contacts.elements;
  visit_cut(system, measurement, cut, [&](std::size_t i, int, const Vec3& force, const Vec4& carried) {
    sum.head<2>() += force.head<2>();
    sum.tail<2>() += carried_force(elements.but_for_blocks(i), carried);
  });
  return sum;
}

ForceAndMoment resultant(const BlockSystem& system, const Measurement& measurement, const Cut& cut) {
  ForceAndMoment sum = across_bolts(system, measurement) + across_linings(system, measurement);
  visit_cut(system, measurement, cut, [&](std::size_t, int block, const Vec3& force, const Vec4&) {
    sum += moved_to(measurement.about, system, block, force);
  });
  return sum;
}

bool is_of_forces(const Measurement& measurement) {
  const Subject subject = subject_of(measurement.quantity);
  return subject == Subject::reaction || subject == Subject::contact_force || subject == Subject::resultant;
}

void write_forces(const BlockSystem& system, const Measurement& measurement, const Cut& cut, std::span<double> values) {
  const auto write = [&](const auto& forces) { std::copy(forces.begin(), forces.end(), values.begin()); };
  const Subject subject = subject_of(measurement.quantity);
  if (subject == Subject::reaction) write(reaction(system, measurement));
  if (subject == Subject::contact_force) write(contact_force(system, measurement, cut));
  if (subject == Subject::resultant) write(resultant(system, measurement, cut));
}

void note_part(double dt, BlockSystem& system) {
  std::vector<double> values;
  ForcesOfParts& parts = system.audit.forces_of_parts;
  parts.begin_part(dt);
  for (std::size_t i = 0; i < system.model.measurements.size(); ++i) {
    const Measurement& measurement = system.model.measurements[i];
    values.resize(is_of_forces(measurement) ? histories_of(measurement.quantity).size() : 0);
    write_forces(system, measurement, {}, values);
    parts.add(i, values);
  }
}

}  // namespace dda
