#include "engine/contact/contact_set.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/cubic_law.h"
#include "engine/contact/projected_law.h"
#include "engine/contact/projected_stretch.h"
#include "engine/contact/row_bending.h"

namespace dda {
namespace {

using Segment6 = Eigen::VectorBlock<Eigen::VectorXd, 6>;

Vec2 moved(const Model& model, const State& state, int block, const Vec2& reference) {
  return current_position(model, state, block, reference);
}

// Adds the stiffness of either of the coupled forces by the gap of the other.
void couple_rows(const InterfaceElement& element, double coupling, InterfaceMatrices& k) {
  const Eigen::Index other = coupled_row(element);
  const auto mixed = [&](const Mat46& left, const Mat46& right) -> Mat6 {
    return coupling * (left.row(0).transpose() * right.row(other) + left.row(other).transpose() * right.row(0));
  };
  k.aa += mixed(element.rows_a, element.rows_a);
  k.bb += mixed(element.rows_b, element.rows_b);
  k.ba += mixed(element.rows_b, element.rows_a);
}

InterfaceLaw usable_law(const Model& model, const Interface& interface, bool can_be_cubic) {
  const InterfaceLaw wanted = model.joints[static_cast<std::size_t>(interface.joint)].law;
  if (interface.length == 0) return InterfaceLaw::classical;
  const bool both_held = model.is_held(interface.block_a) && model.is_held(interface.block_b);
  if (wanted == InterfaceLaw::projected && both_held) return InterfaceLaw::classical;
  return wanted == InterfaceLaw::cubic && !can_be_cubic ? InterfaceLaw::consistent : wanted;
}

template <int rows>
InterfaceMatrices stiffness_of_rows(const InterfaceElement& element, const Vec4& mask) {
  const auto stiffness = element.stiffness.cwiseProduct(mask).head<rows>().asDiagonal();
  const auto a = element.rows_a.topRows<rows>();
  const auto b = element.rows_b.topRows<rows>();
  const Eigen::Matrix<double, 6, rows> weighted_a = a.transpose() * stiffness;
  const Eigen::Matrix<double, 6, rows> weighted_b = b.transpose() * stiffness;
  InterfaceMatrices k;
  k.aa.noalias() = weighted_a * a;
  k.bb.noalias() = weighted_b * b;
  k.ba.noalias() = weighted_b * a;
  return k;
}

Vec2 current_normal(const State& state, const Interface& interface) {
  const auto a = static_cast<std::size_t>(interface.block_a);
  const auto b = static_cast<std::size_t>(interface.block_b);
  // Cofactors of the deformation turn and stretch normals; their sum gives the mean of the two edges.
  const auto turned = [&](std::size_t i) {
    const Mat2& f = state.deformation[i];
    return Vec2(f(1, 1) * interface.normal.x() - f(1, 0) * interface.normal.y(),
                f(0, 0) * interface.normal.y() - f(0, 1) * interface.normal.x());
  };
  // A lone vertex presses on block a's edge: that edge alone has a direction.
  const Vec2 normal = interface.length > 0 ? turned(a) + turned(b) : turned(a);
  return normal.normalized();
}

}  // namespace

InterfaceFrame current_frame(const Model& model, const State& state, const Interface& interface) {
  return {moved(model, state, interface.block_a, interface.from),
          moved(model, state, interface.block_a, interface.to),
          moved(model, state, interface.block_b, interface.from),
          moved(model, state, interface.block_b, interface.to),
          current_normal(state, interface),
          current_centroid(model, state, interface.block_a),
          current_centroid(model, state, interface.block_b)};
}

InterfaceFrame acting_frame(const Model& model, const State& state, const Interface& interface, InterfaceLaw law) {
  InterfaceFrame frame = current_frame(model, state, interface);
  if (law != InterfaceLaw::consistent && law != InterfaceLaw::projected) return frame;
  frame.from_a = frame.from_b = (frame.from_a + frame.from_b) / 2;
  frame.to_a = frame.to_b = (frame.to_a + frame.to_b) / 2;
  return frame;
}

EndsApart ends_apart(const Model& model, const State& state, const Interface& interface) {
  const auto apart = [&](const Vec2& end) -> Vec2 {  // places would lose digits that displacements have
    return point_displacement(model, state, interface.block_b, end) -
           point_displacement(model, state, interface.block_a, end);
  };
  const Mat2 axes = local_axes(current_normal(state, interface));
  return {axes * apart(interface.from), axes * apart(interface.to)};
}

void measure_gap(const Model& model, const State& state, const Interface& interface, const InterfaceElement& element,
                 InterfaceState& own) {
  if (element.law != InterfaceLaw::consistent && element.law != InterfaceLaw::projected) return;
  const EndsApart ends = ends_apart(model, state, interface);
  if (element.law == InterfaceLaw::projected) return measure_projected(model, state, interface, element, ends, own);
  own.gap << (ends.from + ends.to) / 2, (ends.to - ends.from) / 2;
  own.gap -= element.gap_at_start;
}

Vec4 in_situ_force(const Model& model, const Interface& interface) {
  const auto stress = [&](int block) { return model.blocks[static_cast<std::size_t>(block)].initial_stress; };
  const Vec3 mean = (stress(interface.block_a) + stress(interface.block_b)) / 2;
  const Vec2& n = interface.normal;
  const Vec2 global = interface.length / 2 * traction_on(mean, n);
  Vec2 force(n.dot(global), n.x() * global.y() - n.y() * global.x());
  const EndStrength strength = end_strength(model.joints[static_cast<std::size_t>(interface.joint)], interface.length);
  if (strength.is_dry()) {
    const double capacity = strength.capacity(force(0), false);
    force = {std::min(force(0), 0.0), std::clamp(force(1), -capacity, capacity)};
  }
  return {force(0), force(1), force(0), force(1)};
}

ContactSet make_contacts(const Model& model) {
  ContactSet contacts;
  contacts.interfaces = find_interfaces(model);
  contacts.states.resize(contacts.interfaces.size());
  contacts.elements.reserve(contacts.interfaces.size());  // a kilobyte each
  contacts.strengths.reserve(contacts.interfaces.size());
  const std::vector<bool> cubic = cubic_candidates(model, contacts.interfaces);
  const bool cubic_allowed =
      model.stays_linear() && !model.removes_blocks() && !model.adds_blocks() && !changes_materials(model);
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    const JointMaterial& joint = model.joints[static_cast<std::size_t>(interface.joint)];
    InterfaceElement element = make_element(model, interface, usable_law(model, interface, cubic_allowed && cubic[i]));
    set_geometry(model, reference_frame(model, interface), element);
    const Vec3& stress_a = model.blocks[static_cast<std::size_t>(interface.block_a)].initial_stress;
    const Vec3& stress_b = model.blocks[static_cast<std::size_t>(interface.block_b)].initial_stress;
    contacts.elements.push_back(element);
    contacts.strengths.push_back(end_strength(joint, interface.length));
    if (has_stress_rows(element)) {
      contacts.states[i].force = elastic_force(element, contacts.states[i].gap, stress_a, stress_b);
    } else {
      contacts.states[i].force = in_situ_force(model, interface);
      for (Eigen::Index row = 0; row < 4; ++row)
        contacts.states[i].gap(row) = elastic_gap(contacts.states[i].force(row), element.stiffness(row), 0);
    }
    if (element.law == InterfaceLaw::projected && !joint.bonded && is_dry(joint))
      contacts.states[i].broken = {true, true};
    contacts.can_change = contacts.can_change || !joint.bonded;
  }
  fit_to_neighbours(model, contacts);
  return contacts;
}

void fit_to_neighbours(const Model& model, ContactSet& contacts) {
  stiffen_rows(model, contacts);
  take_off_blocks(model.blocks.size(), contacts);
}

void take_off_blocks(std::size_t blocks, ContactSet& contacts) {
  std::vector<Mat3>& sums = contacts.outline_compliance;
  const bool any = std::ranges::count(contacts.elements, InterfaceLaw::projected, &InterfaceElement::law) > 0;
  sums.assign(any ? blocks : 0, Mat3::Zero());
  for (const InterfaceElement& element : contacts.elements) {
    if (element.law != InterfaceLaw::projected) continue;
    sums[static_cast<std::size_t>(element.block_a)] += traction_compliance(element, element.softness(0));
    sums[static_cast<std::size_t>(element.block_b)] += traction_compliance(element, element.softness(1));
  }
}

Mat3 outline_stiffness(const ContactSet& contacts, std::size_t block, const Mat3& elasticity) {
  return elasticity * contacts.outline_compliance[block] * elasticity;
}

Vec3 outline_force(const ContactSet& contacts, std::size_t block, const Mat3& elasticity, const Vec3& stress) {
  return elasticity * (contacts.outline_compliance[block] * stress);
}

double outline_energy(const ContactSet& contacts, const std::vector<Vec3>& stress) {
  double energy = 0;
  for (std::size_t i = 0; i < contacts.outline_compliance.size(); ++i)
    energy += stress[i].dot(contacts.outline_compliance[i] * stress[i]) / 2;
  return energy;
}

void leave_out(const std::vector<bool>& absent, ContactSet& contacts) {
  const auto is_absent = [&](int block) { return absent[static_cast<std::size_t>(block)]; };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    if (is_absent(contacts.interfaces[i].block_a) || is_absent(contacts.interfaces[i].block_b)) continue;
    contacts.interfaces[kept] = contacts.interfaces[i];
    contacts.elements[kept] = contacts.elements[i];
    contacts.strengths[kept] = contacts.strengths[i];
    contacts.states[kept] = contacts.states[i];
    ++kept;
  }
  contacts.interfaces.resize(kept);
  contacts.elements.resize(kept);
  contacts.strengths.resize(kept);
  contacts.states.resize(kept);
}

InterfaceState linear_state(const InterfaceElement& element, const Vec4& gap_at_rest, const Vec6& displacement_a,
                            const Vec6& displacement_b, const Vec3& stress_a, const Vec3& stress_b) {
  InterfaceState state;
  state.gap = gap_at_rest + element.rows_a * displacement_a + element.rows_b * displacement_b;
  state.force = elastic_force(element, state.gap, stress_a, stress_b);
  return state;
}

Vec2 mean_traction(const Model& model, const Interface& interface, const InterfaceElement& element,
                   const InterfaceState& state) {
  if (element.length == 0) return Vec2::Zero();
  Vec2 force = state.force.head<2>();
  if (!has_stress_rows(element)) force += state.force.tail<2>();
  if (element.law == InterfaceLaw::cubic) {
    const double unit = side_free_modulus(model.material_of(interface.block_a)) * element.length /
                        cubic_half_distance(model, interface);
    force(0) += (cubic::gap_at_interface - cubic::gap_stiffness) * unit * state.gap(0);
  }
  return force / element.length;
}

void update_geometry(const Model& model, const State& state, const State& acting, ContactSet& contacts) {
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    InterfaceElement& element = contacts.elements[i];
    set_geometry(model, acting_frame(model, acting, contacts.interfaces[i], element.law), element);
    measure_gap(model, state, contacts.interfaces[i], element, contacts.states[i]);
  }
  if (!contacts.outline_compliance.empty()) take_off_blocks(model.blocks.size(), contacts);
}

void refresh_tractions(const State& state, ContactSet& contacts) {
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    if (!has_stress_rows(element)) continue;
    contacts.states[i].force =
        elastic_force(element, contacts.states[i].gap, state.stress[static_cast<std::size_t>(element.block_a)],
                      state.stress[static_cast<std::size_t>(element.block_b)]);
  }
}

void add_interface_force(const InterfaceElement& element, const Vec4& interface_force, const Vec4& gap,
                         Eigen::VectorXd& force) {
  Segment6 on_a = force.segment<6>(6 * element.block_a);
  Segment6 on_b = force.segment<6>(6 * element.block_b);
  if (is_lone_vertex(element)) {
    on_a.noalias() += element.rows_a.topRows<2>().transpose() * interface_force.head<2>();
    on_b.noalias() += element.rows_b.topRows<2>().transpose() * interface_force.head<2>();
    return;
  }
  on_a.noalias() += element.rows_a.transpose() * interface_force;
  on_b.noalias() += element.rows_b.transpose() * interface_force;
  if (!has_stress_rows(element)) return;
  on_a.tail<3>().noalias() += element.strain_rows_a.transpose() * gap;
  on_b.tail<3>().noalias() += element.strain_rows_b.transpose() * gap;
}

void add_contact_force(const ContactSet& contacts, Eigen::VectorXd& force) {
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceState& state = contacts.states[i];
    if (state.force.isZero(0) && !has_stress_rows(contacts.elements[i])) continue;  // open
    add_interface_force(contacts.elements[i], state.force, state.gap, force);
  }
}

Vec4 gap_increment(const InterfaceElement& element, const Eigen::VectorXd& d) {
  const auto of_a = d.segment<6>(6 * element.block_a);
  const auto of_b = d.segment<6>(6 * element.block_b);
  if (!is_lone_vertex(element)) return element.rows_a * of_a + element.rows_b * of_b;
  Vec4 gap = Vec4::Zero();
  gap.head<2>() = element.rows_a.topRows<2>() * of_a + element.rows_b.topRows<2>() * of_b;
  return gap;
}

InterfaceMatrices stiffness_of(const InterfaceElement& element, const Vec4& mask, double coupling) {
  InterfaceMatrices k =
      is_lone_vertex(element) ? stiffness_of_rows<2>(element, mask) : stiffness_of_rows<4>(element, mask);
  if (coupling != 0) couple_rows(element, coupling, k);
  if (!has_stress_rows(element)) return k;
  const Eigen::Matrix<double, 6, 3> a = element.rows_a.transpose() * element.strain_rows_a;
  const Eigen::Matrix<double, 6, 3> b = element.rows_b.transpose() * element.strain_rows_b;
  k.aa.rightCols<3>() += a;
  k.aa.bottomRows<3>() += a.transpose();
  k.bb.rightCols<3>() += b;
  k.bb.bottomRows<3>() += b.transpose();
  k.ba.rightCols<3>() += element.rows_b.transpose() * element.strain_rows_a;
  k.ba.bottomRows<3>() += element.strain_rows_b.transpose() * element.rows_a;
  return k;
}

double interface_energy(const InterfaceElement& element, const InterfaceState& state) {
  // An open end has a gap without energy: its force is zero. Elsewhere force = K g + stress rows.
  const Vec4 spring = element.stiffness.cwiseProduct(state.gap);
  if (has_stress_rows(element)) return state.gap.dot(state.force - spring / 2);
  return state.gap.dot(state.force) / 2;
}

}  // namespace dda
