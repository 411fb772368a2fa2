#include "engine/simulation/linear_operators.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/contact/cubic_law.h"
#include "engine/contact/mesh_correction.h"
#include "engine/simulation/system_matrix.h"

namespace dda {
namespace {

// The coefficients that leave one matrix of the sum mass M + damping C + stiffness K.
StepCoefficients only_stiffness() {
  StepCoefficients step;
  step.stiffness = 1;
  return step;
}

// The direction of the cubic chain through each block; zero where there is none.
std::vector<Vec2> chain_directions(std::size_t blocks, const ContactSet& contacts) {
  std::vector<Vec2> directions(blocks, Vec2::Zero());
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    if (contacts.elements[i].law != InterfaceLaw::cubic) continue;
    directions[static_cast<std::size_t>(contacts.elements[i].block_a)] = contacts.interfaces[i].normal;
    directions[static_cast<std::size_t>(contacts.elements[i].block_b)] = contacts.interfaces[i].normal;
  }
  return directions;
}

void remove_lateral_inertia(const Model& model, const ContactSet& contacts, BlockMatrix& inertia) {
  const std::vector<Vec2> directions = chain_directions(model.blocks.size(), contacts);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (directions[i].isZero()) continue;
    const int block = static_cast<int>(i);
    inertia.diagonal(block) -= lateral_inertia(model.mass_of(block), model.blocks[i].moments, directions[i]);
  }
}

double corrected_period_error(const Stage& stage) {
  return stage.correct_time_dispersion ? period_error(stage.integrator) : 0;
}

// Whether motion relative to each other has inertia in this interface.
bool has_inertia(const Model& model, const InterfaceElement& element, double period_error) {
  return element.law == InterfaceLaw::cubic || (period_error != 0 && is_in_mesh(model, element));
}

// What consistent interfaces a block has.
struct MeshPlace {
  Vec2 normal = Vec2::Zero();  // of the first; zero where there is none
  bool in_chain = true;        // they all have it
};

std::vector<MeshPlace> mesh_places(const Model& model, const ContactSet& contacts) {
  std::vector<MeshPlace> places(model.blocks.size());
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    if (!is_in_mesh(model, element)) continue;
    const Vec2& normal = contacts.interfaces[i].normal;
    for (const int block : {element.block_a, element.block_b}) {
      MeshPlace& place = places[static_cast<std::size_t>(block)];
      if (place.normal.isZero()) place.normal = normal;
      place.in_chain = place.in_chain && std::abs(place.normal.dot(normal)) > 1 - 1e-9;
    }
  }
  return places;
}

void lower_strains(const Model& model, const Stage& stage, const BlockTerms& terms, const ContactSet& contacts,
                   BlockMatrix& inertia) {
  const double error = corrected_period_error(stage);
  const std::vector<MeshPlace> places = mesh_places(model, contacts);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].normal.isZero()) continue;
    const int block = static_cast<int>(i);
    const double factor = terms.inertia[i].strain_inertia;
    inertia.diagonal(block) -= places[i].in_chain
                                   ? axial_reduction(model, block, places[i].normal, factor, error, stage.dt)
                                   : dilatation_reduction(model, block, factor, error, stage.dt);
  }
}

void add(const InterfaceElement& element, const InterfaceMatrices& part, BlockMatrix& sum) {
  sum.diagonal(element.block_a) += part.aa;
  sum.diagonal(element.block_b) += part.bb;
  sum.add_coupling(element.block_b, element.block_a, part.ba);
}

void soften_jumps(const Model& model, const ContactSet& contacts, BlockMatrix& stiffness) {
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    if (is_in_mesh(model, element)) add(element, jump_stiffness(model, contacts.interfaces[i]), stiffness);
  }
}

BlockMatrix make_inertia(const Model& model, const Stage& stage, const BlockTerms& terms, const ContactSet& contacts) {
  const double error = corrected_period_error(stage);
  std::vector<std::pair<int, int>> couplings;
  for (const InterfaceElement& element : contacts.elements)
    if (has_inertia(model, element, error)) couplings.emplace_back(element.block_a, element.block_b);
  BlockMatrix inertia(static_cast<int>(terms.inertia.size()), couplings);
  for (std::size_t i = 0; i < terms.inertia.size(); ++i)
    inertia.diagonal(static_cast<int>(i)) = mass_matrix(terms.inertia[i]);
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    if (!has_inertia(model, element, error)) continue;
    const Interface& interface = contacts.interfaces[i];
    add(element,
        element.law == InterfaceLaw::cubic ? interface_inertia(model, interface, error, stage.dt)
                                           : mesh_inertia(model, interface, error, stage.dt),
        inertia);
  }
  if (error != 0) lower_strains(model, stage, terms, contacts, inertia);
  for (const ChainEnd& end : contacts.chain_ends)
    inertia.diagonal(end.block) += end_inertia(model, end, contacts.interfaces[end.interface], error, stage.dt);
  if (!stage.lateral_inertia) remove_lateral_inertia(model, contacts, inertia);
  return inertia;
}

void add_scaled(double factor, const BlockMatrix& matrix, BlockMatrix& sum) {
  for (int column = 0; column < matrix.size(); ++column) {
    sum.diagonal(column) += factor * matrix.diagonal(column);
    const auto first = static_cast<std::size_t>(matrix.column_starts()[static_cast<std::size_t>(column)]);
    const auto last = static_cast<std::size_t>(matrix.column_starts()[static_cast<std::size_t>(column) + 1]);
    for (std::size_t k = first + 1; k < last; ++k)
      sum.add_coupling(matrix.block_rows()[k], column, factor * matrix.offdiagonal(static_cast<int>(k)));
  }
}

}  // namespace

LinearOperators make_linear_operators(const Model& model, const Stage& asked, const BlockTerms& terms,
                                      const ContactSet& contacts, const std::vector<SupportElement>& supports) {
  const Stage stage = model.with_acting_corrections(asked);
  BlockMatrix stiffness = make_system_matrix(static_cast<int>(terms.inertia.size()), contacts);
  const std::vector<Vec4> all_rows(contacts.elements.size(), Vec4::Ones());
  assemble(only_stiffness(), terms, {}, supports, contacts, all_rows, stiffness);
  for (const ChainEnd& end : contacts.chain_ends) stiffness.diagonal(end.block) += end_stiffness(model, end);
  if (stage.correct_block_dispersion) soften_jumps(model, contacts, stiffness);
  BlockMatrix inertia = make_inertia(model, stage, terms, contacts);
  ConstantOperator stiffness_times(stiffness);
  ConstantOperator inertia_times(inertia);
  return {std::move(stiffness), std::move(inertia), std::move(stiffness_times), std::move(inertia_times)};
}

std::vector<double> load_sharpening(const Model& model, const Stage& asked, const ContactSet& contacts) {
  const Stage stage = model.with_acting_corrections(asked);
  std::vector<double> shares(model.blocks.size(), 0);
  const double error = corrected_period_error(stage);
  if (error == 0) return shares;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    if (!has_inertia(model, element, error)) continue;
    const Interface& interface = contacts.interfaces[i];
    const double share = element.law == InterfaceLaw::cubic ? load_sharpening(model, interface, error, stage.dt)
                                                            : mesh_load_sharpening(model, interface, error, stage.dt);
    for (const int block : {element.block_a, element.block_b}) {
      double& least = shares[static_cast<std::size_t>(block)];
      least = least == 0 ? share : std::min(least, share);  // interfaces at their caps have less than others
    }
  }
  return shares;
}

void assemble(const StepCoefficients& step, const LinearOperators& operators, const BlockDamping& damping,
              BlockMatrix& matrix) {
  matrix.set_zero();
  add_scaled(step.mass, operators.inertia, matrix);
  add_scaled(step.stiffness, operators.stiffness, matrix);
  for (const auto& [block, c] : damping) matrix.diagonal(block) += step.damping * c;
}

}  // namespace dda
