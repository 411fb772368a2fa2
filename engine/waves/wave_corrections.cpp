#include "engine/waves/wave_corrections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/model/held_flags.h"
#include "engine/waves/cubic_inertia.h"
#include "engine/waves/mesh_correction.h"

namespace dda {
namespace {

bool is_cubic(const InterfaceElement& element) { return element.law == InterfaceLaw::cubic; }

void add(const InterfaceElement& element, const InterfaceMatrices& part, BlockMatrix& sum) {
  sum.diagonal(element.block_a) += part.aa;
  sum.diagonal(element.block_b) += part.bb;
  sum.add_coupling(element.block_b, element.block_a, part.ba);
}

// The direction of the cubic chain through each block; zero where there is none.
std::vector<Vec2> chain_directions(std::size_t blocks, const ContactSet& contacts) {
  std::vector<Vec2> directions(blocks, Vec2::Zero());
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    if (!is_cubic(contacts.elements.but_for_blocks(i))) continue;
    directions[static_cast<std::size_t>(contacts.interfaces[i].block_a)] = contacts.interfaces[i].normal;
    directions[static_cast<std::size_t>(contacts.interfaces[i].block_b)] = contacts.interfaces[i].normal;
  }
  return directions;
}

// What consistent interfaces a block has.
struct MeshPlace {
  Vec2 normal = Vec2::Zero();  // of the first; zero where there is none
  bool in_chain = true;        // they all have it
};

std::vector<MeshPlace> mesh_places(const std::vector<bool>& held, const ContactSet& contacts) {
  std::vector<MeshPlace> places(held.size());
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.read(i, room);
    if (!is_in_mesh(held, element)) continue;
    const Vec2& normal = contacts.interfaces[i].normal;
    for (const int block : {element.block_a, element.block_b}) {
      MeshPlace& place = places[static_cast<std::size_t>(block)];
      if (place.normal.isZero()) place.normal = normal;
      place.in_chain = place.in_chain && std::abs(place.normal.dot(normal)) > 1 - 1e-9;
    }
  }
  return places;
}

}  // namespace

double period_error(const Integrator& integrator) {
  const double shift = integrator.gamma - 0.5;
  const double m = integrator.alpha_m;
  const double f = integrator.alpha_f;
  const double damping = f - m - shift;  // first-order numerical damping; it shortens waves too
  return -1.0 / 12 + (0.5 - integrator.gamma + 2 * integrator.beta) / 2 - shift * shift / 2 -
         (m * (1 - m) - f * (1 - f)) / 2 - damping * damping / 4;
}

WaveCorrections::WaveCorrections(const Model& model, const Stage& stage, const ContactSet& contacts)
    : dt_(stage.dt),
      strain_inertia_(stage.strain_inertia),
      lateral_inertia_(stage.lateral_inertia),
      held_(held_flags(model)),
      ends_(free_chain_ends(model, contacts.interfaces, contacts.elements)),
      sharpening_(model.blocks.size(), 0) {
  const Stage acting = model.with_acting_corrections(stage);
  softening_.for_blocks = acting.correct_block_dispersion;
  if (acting.correct_time_dispersion) period_error_ = period_error(acting.integrator);
  in_chains_only_ = acting.integrator.is_explicit();
  if (in_chains_only_) softening_.for_steps = -period_error_ * dt_ * dt_;
  if (period_error_ != 0) find_sharpening(model, contacts);
}

WaveCorrections WaveCorrections::with_all_inertia() const {
  WaveCorrections complete = *this;
  complete.lateral_inertia_ = true;
  return complete;
}

void WaveCorrections::add_to_stiffness(const Model& model, const ContactSet& contacts, BlockMatrix& stiffness) const {
  for (const ChainEnd& end : ends_) stiffness.diagonal(end.block) += end_stiffness(model, end);
  InterfaceElement room;
  for (std::size_t i = 0; softening_.acts() && i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.read(i, room);
    if (is_in_mesh(held_, element)) add(element, jump_stiffness(model, contacts.interfaces[i], softening_), stiffness);
  }
}

// Whether motion relative to each other has inertia in this interface.
bool WaveCorrections::has_inertia(const InterfaceElement& element) const {
  return is_cubic(element) || (period_error_ != 0 && !in_chains_only_ && is_in_mesh(held_, element));
}

bool WaveCorrections::softened_for_steps(const InterfaceElement& element) const {
  return softening_.for_steps > 0 && is_in_mesh(held_, element);
}

std::vector<std::pair<int, int>> WaveCorrections::coupled_by_inertia(const ContactSet& contacts) const {
  std::vector<std::pair<int, int>> pairs;
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    if (const InterfaceElement& element = contacts.elements.read(i, room); has_inertia(element))
      pairs.emplace_back(element.block_a, element.block_b);
  return pairs;
}

InterfaceMatrices WaveCorrections::inertia_between(const Model& model, const ContactSet& contacts,
                                                   std::size_t i) const {
  const Interface& interface = contacts.interfaces[i];
  return is_cubic(contacts.elements.but_for_blocks(i)) ? cubic_inertia(model, interface, period_error_, dt_)
                                                       : mesh_inertia(model, interface, period_error_, dt_);
}

void WaveCorrections::add_to_inertia(const Model& model, const ContactSet& contacts, BlockMatrix& inertia) const {
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    if (const InterfaceElement& element = contacts.elements.read(i, room); has_inertia(element))
      add(element, inertia_between(model, contacts, i), inertia);
  if (period_error_ != 0 && !in_chains_only_) lower_strains(model, contacts, inertia);
  for (const ChainEnd& end : ends_)
    inertia.diagonal(end.block) += end_inertia(model, end, contacts.interfaces[end.interface], period_error_, dt_);
  if (!lateral_inertia_) remove_lateral_inertia(model, contacts, inertia);
}

// A block that also has a cubic interface has given inertia of its strains there. Taken twice, up to both caps, none
// was left: rows of equal and unequal blocks grew without bound under long steps.
void WaveCorrections::lower_strains(const Model& model, const ContactSet& contacts, BlockMatrix& inertia) const {
  const std::vector<MeshPlace> places = mesh_places(held_, contacts);
  const std::vector<Vec2> chains = chain_directions(places.size(), contacts);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].normal.isZero() || !chains[i].isZero()) continue;
    const int block = static_cast<int>(i);
    inertia.diagonal(block) -=
        places[i].in_chain ? axial_reduction(model, block, places[i].normal, strain_inertia_, period_error_, dt_)
                           : dilatation_reduction(model, block, strain_inertia_, period_error_, dt_);
  }
}

void WaveCorrections::remove_lateral_inertia(const Model& model, const ContactSet& contacts, BlockMatrix& inertia) {
  const std::vector<Vec2> directions = chain_directions(model.blocks.size(), contacts);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (directions[i].isZero()) continue;
    const int block = static_cast<int>(i);
    inertia.diagonal(block) -= lateral_inertia(model.mass_of(block), model.blocks[i].moments, directions[i]);
  }
}

double WaveCorrections::sharpening_beside(const Model& model, const ContactSet& contacts, std::size_t i) const {
  const Interface& interface = contacts.interfaces[i];
  if (softened_for_steps(contacts.elements[i])) return 2 * period_error_ * jump_share(model, interface, softening_);
  return is_cubic(contacts.elements.but_for_blocks(i)) ? cubic_load_sharpening(model, interface, period_error_, dt_)
                                                       : mesh_load_sharpening(model, interface, period_error_, dt_);
}

// Interfaces at their caps have less than others; the least counts. Shares of one stage have one sign.
void WaveCorrections::find_sharpening(const Model& model, const ContactSet& contacts) {
  std::vector<bool> found(sharpening_.size(), false);  // 0 is a share as any other
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.read(i, room);
    if (!has_inertia(element) && !softened_for_steps(element)) continue;
    const double share = sharpening_beside(model, contacts, i);
    for (const int block : {element.block_a, element.block_b}) {
      const auto k = static_cast<std::size_t>(block);
      if (!found[k] || std::abs(share) < std::abs(sharpening_[k])) sharpening_[k] = share;
      found[k] = true;
    }
  }
}

LoadFilter WaveCorrections::face_load_filter(int block) const {
  LoadFilter filter = load_filter(block);
  if (softening_.for_steps > 0) filter.share = std::max(filter.share, period_error_);  // both are negative
  return filter;
}

Vec6 WaveCorrections::lever_correction(int block, const Vec2& offset, const Vec2& force) const {
  const auto end = std::ranges::find(ends_, block, &ChainEnd::block);
  return end == ends_.end() ? Vec6(Vec6::Zero()) : end_load(*end, offset, force);
}

void WaveCorrections::add_end_forces(const Model& model, const std::vector<Vec3>& stress,
                                     Eigen::VectorXd& force) const {
  for (const ChainEnd& end : ends_)
    force.segment<6>(6 * end.block) += end_force(model, end, stress[static_cast<std::size_t>(end.block)]);
}

double WaveCorrections::end_energy(const Model& model, const std::vector<Vec3>& stress) const {
  double energy = 0;
  for (const ChainEnd& end : ends_) energy += dda::end_energy(model, end, stress[static_cast<std::size_t>(end.block)]);
  return energy;
}

double share_softened_for_steps(const Model& model, const Stage& stage, const ContactSet& contacts) {
  const std::vector<bool> held = held_flags(model);
  const JumpSoftening softening{true, -period_error(central_difference_integrator()) * stage.dt * stage.dt};
  std::size_t softened = 0;
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i)
    if (is_in_mesh(held, contacts.elements.read(i, room)) && jump_share(model, contacts.interfaces[i], softening) > 0)
      ++softened;
  return contacts.elements.empty() ? 0 : static_cast<double>(softened) / static_cast<double>(contacts.elements.size());
}

}  // namespace dda
