// What the quick passes of the open-close iteration work with, kept from step to step so that a warm step allocates
// nothing.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <numeric>
#include <vector>

#include "engine/contact/contact_pieces.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/point_kinematics.h"
#include "engine/linear/block_part.h"
#include "engine/linear/krylov.h"

namespace dda {

struct FrictionNewton {
  // An interface with a broken end; the others are linear.
  struct LiveContact {
    std::size_t interface;
    int block_a, block_b;
    ContactPieces pieces;  // what the pass takes its ends to be
    bool between;          // its forces are not what it answers: keep_to_bordering_pieces
    InterfaceSprings springs;
    PointKinematics points;
  };

  // How friction ties the shear forces of sliding ends to their normal gaps.
  struct Coupling {
    const LiveContact* contact;
    Vec4 shear_by_gap;  // N/m per m of thickness: rows 1 and 3 by the gaps of rows 0 and 2
  };

  static constexpr int basis = 40;  // of GMRES

  std::vector<LiveContact> live;
  std::vector<std::size_t> taken;  // of these, those that the pass moves
  std::vector<Coupling> couplings;
  BlockPart part;               // the blocks that a local pass moves
  bool is_local = false;        // the pass, and with it the factor at hand
  bool between_pieces = false;  // some live contact is

  // 6 entries a block.
  Eigen::VectorXd residual;  // what is left of the balance at the increments reached
  Eigen::VectorXd step;      // of Newton's method
  Eigen::VectorXd image;     // matrix * increments
  ConjugateGradients gradients;
  Gmres gmres{basis};

  double imbalance = 0;         // largest entry of the residual, N per m of thickness
  double largest_force = 0;     // of contacts and bolts, N per m of thickness
  int stale_interfaces = 0;     // that changed in the matrix since it was factored
  bool matrix_amended = false;  // interface by interface since it was assembled

  [[nodiscard]] static Vec4 gap(const LiveContact& contact, const Eigen::VectorXd& d) {
    return contact.points.gap(d.segment<6>(6 * contact.block_a), d.segment<6>(6 * contact.block_b));
  }
  static void add_force(const LiveContact& contact, const Vec4& contact_force, Eigen::VectorXd& force) {
    contact.points.add_force(contact_force, force.segment<6>(6 * contact.block_a),
                             force.segment<6>(6 * contact.block_b));
  }

  void take_all() {
    is_local = false;
    taken.resize(live.size());
    std::iota(taken.begin(), taken.end(), std::size_t{0});
  }
  void take_part() {
    is_local = true;
    taken.clear();
    for (std::size_t k = 0; k < live.size(); ++k)
      if (part.contains(live[k].block_a) || part.contains(live[k].block_b)) taken.push_back(k);
  }

  void resize(Eigen::Index unknowns) {
    for (Eigen::VectorXd* vector : {&residual, &step, &image}) vector->setZero(unknowns);
    gradients.resize(unknowns);
    gmres.resize(unknowns);
  }
};

}  // namespace dda
