// What the quick passes of the open-close iteration work with, kept from step to step so that a warm step allocates
// nothing.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "dda/contact/contact_pieces.h"
#include "dda/contact/interface_element.h"
#include "dda/linear/krylov.h"

namespace dda {

struct FrictionNewton {
  // How friction ties the shear forces of sliding ends to their normal gaps.
  struct Coupling {
    std::size_t interface;
    Vec4 shear_by_gap;  // N/m per m of thickness: rows 1 and 3 by the gaps of rows 0 and 2
  };

  static constexpr int basis = 40;  // of GMRES

  std::vector<std::size_t> live;      // interfaces with a broken end: the others are linear
  std::vector<ContactPieces> pieces;  // as live: what the pass takes them to be
  std::vector<Coupling> couplings;
  bool between_pieces = false;  // some forces are not what the ends answer: keep_to_bordering_pieces

  // 6 entries a block.
  Eigen::VectorXd residual;  // what is left of the balance at the increments reached
  Eigen::VectorXd step;      // of Newton's method
  Eigen::VectorXd image;     // matrix * increments
  ConjugateGradients gradients;
  Gmres gmres{basis};

  double imbalance = 0;         // largest entry of the residual, N per m of thickness
  double largest_force = 0;     // of interfaces and bolts, N per m of thickness
  int stale_interfaces = 0;     // that changed in the matrix since it was factored
  bool matrix_amended = false;  // interface by interface since it was assembled

  void resize(Eigen::Index unknowns) {
    for (Eigen::VectorXd* vector : {&residual, &step, &image}) vector->setZero(unknowns);
    gradients.resize(unknowns);
    gmres.resize(unknowns);
  }
};

}  // namespace dda
