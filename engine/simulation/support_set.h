// Spring supports of a scene: stiffness, forces, energy.
#pragma once

#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/load_time.h"

namespace dda {

struct SupportElement {
  int block = 0;
  Vec2 offset;                     // of the held point from the centroid, m
  Mat26 rows;                      // of what is held: the point's displacement, or its way from a partner
  Mat2 stiffness;                  // N/m
  Vec2 gap = Vec2::Zero();         // m, held point minus its prescribed place
  Vec2 prescribed = Vec2::Zero();  // m, displacement asked for at the time of `gap`
  Vec2 foreseen = Vec2::Zero();    // m, by which the step under way changes the gap beyond what the rows make of it
  Vec2 rest = Vec2::Zero();        // m, displacement that the held point had when the spring was put in

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [block, offset, rows, stiffness, gap, prescribed, foreseen, rest] = self;
    archive(offset, rows, stiffness, gap, prescribed, foreseen, rest);
  }
};

// Whether what it holds with when it is let go stays as a load.
inline bool leaves_force(const PointSupport& support) { return support.last_stage >= 0 && !support.takes_force_along; }

std::vector<SupportElement> make_supports(const Model& model, const State& state);

// Moves the held points with their blocks (finite kinematics).
void update_geometry(const Model& model, const State& state, std::vector<SupportElement>& supports);

// Gap of support `index`, prescribed for the state's time.
void measure_gap(const Model& model, const State& state, std::size_t index, SupportElement& support);

// Gaps as they are prescribed `now`, of all but ties between two points of a block: their way would be lost in the
// points' own, and forces that jump as gaps are measured anew are not what the ground beside a tie is to feel. Their
// increments and what was foreseen of them is all they go by.
void measure_gaps(const Model& model, const State& state, const LoadTime& now, std::vector<SupportElement>& supports);

// Foresees what the rows, which are those of the share `acts_at` of a step of `dt` (s), miss of the gaps' change in it:
// second order in the turns and strains of the step, times stiff springs a large force. See ADR 30. `believed`: the
// velocities with which the rows were placed, zero of blocks that are not believed to move so.
void foresee_gaps(const Model& model, const State& state, const std::vector<Vec6>& believed, double dt, double acts_at,
                  std::vector<SupportElement>& supports);
void foresee_nothing(std::vector<SupportElement>& supports);

// Follows a held point by the increments `d` of all blocks to where it is `prescribed`, along the directions of the
// step's start.
void advance_gap(const Vec2& prescribed, const Eigen::VectorXd& d, SupportElement& support);

// Prescribed displacement and velocity at `time`, m and m/s.
Vec2 prescribed_displacement(const PointSupport& support, double time);
inline Vec2 prescribed_displacement(const PointSupport& support, const LoadTime& time) {
  return time.of([&](double then) { return prescribed_displacement(support, then); });
}
Vec2 prescribed_velocity(const PointSupport& support, double time);

// Adds the internal forces (stiffness * gap) of all supports to `force`.
void add_support_force(const std::vector<SupportElement>& supports, Eigen::VectorXd& force);

double support_energy(const SupportElement& support);
double support_energy(const std::vector<SupportElement>& supports);

}  // namespace dda
