// All that lets waves run in bonded blocks as in continuous rock, in one object that is made for each stage: what is
// added to stiffness and inertia, how loads are filtered, and which lever they have on the end of a chain. README.md
// says why. Other folders include this header of engine/waves and no other.
//
// Everything here is of scenes in which nothing can change (Model::stays_linear); in others it adds nothing.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/core/types.h"
#include "engine/linear/block_matrix.h"
#include "engine/model/model.h"
#include "engine/waves/chain_end.h"
#include "engine/waves/mesh_correction.h"

namespace dda {

// epsilon of an integrator, from its characteristic equation at small omega dt: waves driven at the frequency omega run
// slower by the share epsilon (omega dt)^2/2, as oscillators would whose omega^2 is lowered by the share epsilon
// (omega dt)^2. 1/6 for the trapezoidal rule, -1/48 for Eq. 5 of the thesis, -1/12 for
// central differences.
double period_error(const Integrator& integrator);

// A load as it is applied: F - share (F(t + dt) - 2 F(t) + F(t - dt)).
//
// Inertia M - s dt^2 K under steps that take omega^2 (1 + s omega^2 dt^2) for omega^2 makes the exact equation times
// 1 + s omega^2 dt^2 of the motion: waves keep their speed, but all that a load causes is too small by that factor
// unless the load is multiplied by it too. The second difference does that. Stiffness K - s' dt^2 K M^-1 K under steps
// that take omega^2 (1 + s' omega^2 dt^2) leaves the speed as well, but waves carry too much by 1 + 2 s' omega^2 dt^2:
// the residue of 1/(K(k) - omega^2) is one over the slope of K(k). There the share is -2 s', or 2 epsilon. At time 0,
// when a run starts from rest, a load is as given.
struct LoadFilter {
  double share = 0;
  double dt = 0;  // s

  // `history`: the load as a function of time.
  template <typename History>
  [[nodiscard]] double operator()(const History& history, double time) const {
    const double now = history(time);
    if (share == 0 || time <= 0) return now;
    return now - share * (history(time - dt) - 2 * now + history(time + dt));
  }
};

class WaveCorrections {
 public:
  // `contacts`: of the model as it is drawn.
  WaveCorrections(const Model& model, const Stage& stage, const ContactSet& contacts);

  // What ends of chains and jumps of strains add.
  void add_to_stiffness(const Model& model, const ContactSet& contacts, BlockMatrix& stiffness) const;

  // Blocks that are coupled by inertia, and what is added to that of the blocks alone.
  [[nodiscard]] std::vector<std::pair<int, int>> coupled_by_inertia(const ContactSet& contacts) const;
  void add_to_inertia(const Model& model, const ContactSet& contacts, BlockMatrix& inertia) const;

  // Whether some strains have no inertia, so that the inertia alone gives no accelerations; and the same corrections
  // with the inertia that is left out.
  [[nodiscard]] bool leave_strains_without_inertia() const { return !lateral_inertia_; }
  [[nodiscard]] WaveCorrections with_all_inertia() const;

  // How loads on a block are filtered; lever_correction() is added to a `force` (N) at `offset` from the centroid.
  [[nodiscard]] LoadFilter load_filter(int block) const { return {sharpening_[static_cast<std::size_t>(block)], dt_}; }
  // The filter of a load on an outer face. Where stiffness makes up for explicit steps, the traction of joints is what
  // accelerates blocks, and it follows the load at the face as it is: motion and stress there are too large by
  // 1 + s' omega^2 dt^2 alone, half of what they are about a load in the rock.
  [[nodiscard]] LoadFilter face_load_filter(int block) const;
  [[nodiscard]] Vec6 lever_correction(int block, const Vec2& offset, const Vec2& force) const;

  // Internal forces of the ends of chains under the blocks' stresses (Pa), and the energy stored in them.
  void add_end_forces(const Model& model, const std::vector<Vec3>& stress, Eigen::VectorXd& force) const;
  [[nodiscard]] double end_energy(const Model& model, const std::vector<Vec3>& stress) const;

 private:
  [[nodiscard]] bool has_inertia(const InterfaceElement& element) const;
  [[nodiscard]] InterfaceMatrices inertia_between(const Model& model, const ContactSet& contacts, std::size_t i) const;
  [[nodiscard]] bool softened_for_steps(const InterfaceElement& element) const;
  [[nodiscard]] double sharpening_beside(const Model& model, const ContactSet& contacts, std::size_t i) const;
  void find_sharpening(const Model& model, const ContactSet& contacts);
  void lower_strains(const Model& model, const ContactSet& contacts, BlockMatrix& inertia) const;
  static void remove_lateral_inertia(const Model& model, const ContactSet& contacts, BlockMatrix& inertia);

  double dt_;                    // s
  double strain_inertia_;        // see Stage
  bool lateral_inertia_;         // see Stage
  JumpSoftening softening_;      // Stage::correct_block_dispersion where it acts, and what explicit steps ask for
  double period_error_ = 0;      // of the integrator; 0 where time steps are not corrected by inertia
  bool in_chains_only_ = false;  // that inertia: explicit steps have none between the blocks of a mesh
  std::vector<bool> held_;       // of every block
  std::vector<ChainEnd> ends_;
  std::vector<double> sharpening_;  // of the loads on each block
};

// The share of the interfaces that make up for what explicit steps of the stage's dt do to waves: those of consistent
// law between convex blocks of one material.
double share_softened_for_steps(const Model& model, const Stage& stage, const ContactSet& contacts);

}  // namespace dda
