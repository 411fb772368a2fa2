#include "engine/contact/contact_set.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/contact/contact_sharing.h"
#include "engine/contact/cubic_law.h"
#include "engine/contact/projected_law.h"
#include "engine/core/parallel.h"
#include "engine/core/parallel_scatter.h"

namespace dda {
namespace {

using Segment6 = Eigen::VectorBlock<Eigen::VectorXd, 6>;

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

}  // namespace

void take_off_nothing(std::size_t blocks, ContactSet& contacts) {
  contacts.outline_compliance.assign(blocks, Mat3::Zero());
  contacts.outline_strain.assign(blocks, Vec3::Zero());
  contacts.outline_constant.assign(blocks, 0);
}

void take_off_blocks(std::size_t blocks, ContactSet& contacts) {
  const bool any = std::ranges::count(contacts.elements.kinds(), InterfaceLaw::projected, &InterfaceElement::law) > 0;
  take_off_nothing(any ? blocks : 0, contacts);
  if (!any) return;
  const auto take_off = [&contacts](int block, const TakenOff& part) {
    const auto i = static_cast<std::size_t>(block);
    contacts.outline_compliance[i] += part.compliance;
    contacts.outline_strain[i] += part.strain;
    contacts.outline_constant[i] += part.energy;
  };
  for (const InterfaceElement& element : contacts.elements.own()) {
    if (element.law != InterfaceLaw::projected) continue;
    take_off(element.block_a, taken_off(element, element.softness(0), element.beside_stress_a));
    take_off(element.block_b, taken_off(element, element.softness(1), element.beside_stress_b));
  }
}

Mat3 outline_stiffness(const ContactSet& contacts, std::size_t block, const Mat3& elasticity) {
  return elasticity * contacts.outline_compliance[block] * elasticity;
}

Vec3 outline_force(const ContactSet& contacts, std::size_t block, const Mat3& elasticity, const Vec3& stress) {
  return elasticity * (contacts.outline_compliance[block] * stress + contacts.outline_strain[block]);
}

double outline_energy(const ContactSet& contacts, const std::vector<Vec3>& stress) {
  double energy = 0;
  parallel_add(contacts.outline_compliance.size(), contacts_of_plain_sum, energy,
               [&](std::size_t first, std::size_t last, double& sum) {
                 for (std::size_t i = first; i < last; ++i)
                   sum += stress[i].dot(contacts.outline_compliance[i] * stress[i] / 2 + contacts.outline_strain[i]) +
                          contacts.outline_constant[i];
               });
  return energy;
}

void leave_out(const std::vector<bool>& absent, ContactSet& contacts) {
  const auto is_absent = [&](int block) { return absent[static_cast<std::size_t>(block)]; };
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    if (is_absent(contacts.interfaces[i].block_a) || is_absent(contacts.interfaces[i].block_b)) continue;
    contacts.interfaces[kept] = contacts.interfaces[i];
    elements[kept] = elements[i];
    contacts.strengths[kept] = contacts.strengths[i];
    contacts.states[kept] = contacts.states[i];
    ++kept;
  }
  contacts.interfaces.resize(kept);
  elements.resize(kept);
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

Vec2 carried_force(const InterfaceElement& element, const Vec4& force) {
  const bool has_two_ends = !has_stress_rows(element) && !is_lone_vertex(element);
  return has_two_ends ? Vec2(force.head<2>() + force.tail<2>()) : Vec2(force.head<2>());
}

Vec2 mean_traction(const Model& model, const Interface& interface, const InterfaceElement& element,
                   const InterfaceState& state) {
  if (element.length == 0) return Vec2::Zero();
  Vec2 force = carried_force(element, state.force);
  if (element.law == InterfaceLaw::cubic) {
    const double unit = side_free_modulus(model.material_of(interface.block_a)) * element.length /
                        cubic_half_distance(model, interface);
    force(0) += (cubic::gap_at_interface - cubic::gap_stiffness) * unit * state.gap(0);
  }
  return force / element.length;
}

void refresh_tractions(const State& state, ContactSet& contacts) {
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.read(i, room);
    if (!has_stress_rows(element)) continue;
    contacts.states[i].force =
        elastic_force(element, contacts.states[i].gap, state.stress[static_cast<std::size_t>(element.block_a)],
                      state.stress[static_cast<std::size_t>(element.block_b)]);
  }
}

namespace {

// Adds to both blocks, or to one of them alone.
void add_to_blocks(const InterfaceElement& element, const Vec4& interface_force, const Vec4& gap, Segment6 on_a,
                   Segment6 on_b, bool to_a, bool to_b) {
  if (is_lone_vertex(element)) {
    if (to_a) on_a.noalias() += element.rows_a.topRows<2>().transpose() * interface_force.head<2>();
    if (to_b) on_b.noalias() += element.rows_b.topRows<2>().transpose() * interface_force.head<2>();
    return;
  }
  if (to_a) on_a.noalias() += element.rows_a.transpose() * interface_force;
  if (to_b) on_b.noalias() += element.rows_b.transpose() * interface_force;
  if (!has_stress_rows(element)) return;
  if (to_a) on_a.tail<3>().noalias() += element.strain_rows_a.transpose() * gap;
  if (to_b) on_b.tail<3>().noalias() += element.strain_rows_b.transpose() * gap;
}

}  // namespace

void add_interface_force(const InterfaceElement& element, const Vec4& interface_force, const Vec4& gap,
                         Eigen::VectorXd& force) {
  add_to_blocks(element, interface_force, gap, force.segment<6>(6 * element.block_a),
                force.segment<6>(6 * element.block_b), true, true);
}

void add_contact_force(const ContactSet& contacts, Eigen::VectorXd& force) {
  const auto blocks_of_contact = [&contacts](std::size_t i) {
    return std::pair(contacts.interfaces[i].block_a, contacts.interfaces[i].block_b);
  };
  const auto add = [&](std::size_t i, bool on_a, bool on_b) {
    const InterfaceElement& element = contacts.elements.but_for_blocks(i);
    const InterfaceState& state = contacts.states[i];
    if (state.force.isZero(0) && !has_stress_rows(element)) return;  // open
    const auto [a, b] = blocks_of_contact(i);
    add_to_blocks(element, state.force, state.gap, force.segment<6>(6 * a), force.segment<6>(6 * b), on_a, on_b);
  };
  const auto blocks = static_cast<std::size_t>(force.size() / 6);
  parallel_scatter(contacts.interfaces.size(), blocks, contacts_worth_sharing, blocks_of_contact, add);
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
