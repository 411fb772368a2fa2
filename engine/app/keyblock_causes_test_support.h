// Why a run does something else than block theory foretells: causes that are shown, by forces within Coulomb's law and
// by the run's own contacts.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/app/coulomb_forces_test_support.h"
#include "engine/app/keyblock_run_test_support.h"
#include "engine/keyblocks/key_blocks.h"

namespace dda {

inline constexpr double agreement = 0.02;  // of g: friction while the first contacts close, and the path of 2 mm
inline constexpr double allowed = 1e-6;    // of the weight, as `turns` has it

// m/s2, of a body that does not turn.
inline Vec2 foretold(const KeyBlock& block) {
  const FirstMotion& motion = block.motion;
  if (block.type != BlockType::key) return Vec2::Zero();
  return (motion.drive - motion.resistance) / block.body.mass * motion.direction;
}

inline bool is_near(const Vec2& a, const Vec2& b) { return (a - b).norm() < agreement * standard_gravity; }

// What forces within Coulomb's law can give a body, and what motions that makes answers.
class Answers {
 public:
  // `inertia`: kg m2 per m of thickness, about the centroid.
  Answers(const KeyBlock& block, double inertia) : block_(block), inertia_(inertia) {}

  // Whether its faces can keep it where it is.
  [[nodiscard]] bool may_rest() const { return lacking(at_rest(), {}) <= allowed; }
  [[nodiscard]] bool may_rest_without_friction() const { return lacking(at_rest(0), {}) <= allowed; }

  // Whether the motion foretold is an answer, of a body that cannot turn; and of one that can.
  [[nodiscard]] bool foretold_is_one() const {
    return as_foretold().lacking_force(wanted_force(foretold(block_))) <= allowed;
  }
  [[nodiscard]] bool foretold_is_one_without_turning() const {
    return lacking(as_foretold(), {foretold(block_), 0}) <= allowed;
  }

  // What is lacking of the forces for how a run moved in the end, at the places where it was closed.
  [[nodiscard]] double lacking_of(const Measured& run) const {
    CoulombForces forces = none();
    for (const Touched& touched : run.touched) {
      const Vec2& arm = touched.end.at;
      const Vec2 velocity = run.late_velocity.head<2>() + run.late_velocity[2] * Vec2(-arm.y(), arm.x());
      constexpr double stuck = 1e-5;  // m/s: springs give way by a thousandth of that; 2 ms at 2 % of g make 4e-4
      if (touched.stuck == run.late_steps || std::abs(cross(touched.end.outward, velocity)) < stuck)
        forces.sticks(touched.end);
      else if (touched.gripped == run.late_steps)
        forces.slides(touched.end, velocity);
      else
        forces.slides_and_opens(touched.end, velocity);
    }
    return lacking(forces, run.late);
  }

 private:
  [[nodiscard]] CoulombForces none() const {
    return {std::sqrt(block_.body.area), block_.body.mass * standard_gravity};
  }

  [[nodiscard]] std::vector<TouchingEnd> ends(const JointFace& face) const {
    std::vector<TouchingEnd> ends = ends_of(face);
    for (TouchingEnd& end : ends) end.at -= block_.body.centroid;
    return ends;
  }

  [[nodiscard]] CoulombForces at_rest(double strength = 1) const {
    CoulombForces forces = none();
    for (const JointFace& face : block_.body.joints) {
      for (const TouchingEnd& end : ends(face))
        forces.sticks({end.at, end.outward, strength * end.tan_friction, strength * end.cohesion_force});
    }
    return forces;
  }

  // Faces that open give nothing; one that the way runs into would have to give what none can.
  [[nodiscard]] CoulombForces as_foretold() const {
    if (block_.type != BlockType::key) return at_rest();
    CoulombForces forces = none();
    for (const JointFace& face : block_.body.joints) {
      if (std::abs(face.outward.dot(block_.motion.direction)) > allowed) continue;
      for (const TouchingEnd& end : ends(face)) forces.slides(end, block_.motion.direction);
    }
    return forces;
  }

  [[nodiscard]] Vec2 wanted_force(const Vec2& acceleration) const {
    return block_.body.mass * acceleration - block_.acting.force;
  }

  [[nodiscard]] double lacking(const CoulombForces& forces, const Rates& rates) const {
    return forces.lacking(wanted_force(rates.acceleration), inertia_ * rates.turn - block_.acting.moment);
  }

  const KeyBlock& block_;
  double inertia_;
};

// N per m of thickness: the cohesion that the run kept of a face, at what it had closed of it all the time.
inline double kept_cohesion(const JointFace& face, const Measured& run) {
  double kept = 0;
  for (const Touched& touched : run.touched) {
    const bool is_of_face = touched.neighbour == face.neighbour && (touched.end.outward - face.outward).norm() < 0.1;
    if (is_of_face && touched.gripped == run.late_steps) kept += touched.end.cohesion_force;
  }
  return kept;
}

// N per m of thickness: what the run lost of the cohesion of the faces that it slides along.
inline double lost_cohesion(const KeyBlock& block, const Measured& run) {
  double lost = 0;
  for (const JointFace& face : block.body.joints) {
    if (std::abs(face.outward.dot(block.motion.direction)) > allowed) continue;
    double whole = 0;
    for (const TouchingEnd& end : ends_of(face)) whole += end.cohesion_force;
    lost += std::max(0.0, whole - kept_cohesion(face, run));
  }
  return lost;
}

// Goes the way foretold, faster, by no more than the cohesion that the run lost; also where it is foretold to be held.
inline bool is_faster_by_lost_cohesion(const KeyBlock& block, const Measured& run) {
  const FirstMotion& motion = block.motion;
  const double along = run.late.acceleration.dot(motion.direction);
  const double more = block.body.mass * along - (motion.drive - motion.resistance);
  const double most = lost_cohesion(block, run);
  return most > 0 && along > 0 && more > 0 && more < most + agreement * standard_gravity * block.body.mass &&
         is_near(run.late.acceleration, along * motion.direction);
}

// Turns by more than a thousandth of g at the arm of its size: twenty times less than what counts as another motion.
inline bool has_turned(const KeyBlock& block, const Measured& run) {
  return std::abs(run.mean.turn) * std::sqrt(block.body.area) > 1e-3 * standard_gravity;
}

// Whether Coulomb's law allows the motion foretold too, and the body takes it when it begins so: with a twentieth of
// the velocity of a free fall.
inline bool goes_as_foretold_when_pushed(const KeyBlock& block, const Answers& answers, const LetGo& part) {
  if (block.type != BlockType::key || !answers.foretold_is_one_without_turning()) return false;
  const Vec2 velocity = standard_gravity * run_duration / 20 * block.motion.direction;
  const Measured pushed = run_let_go(part, close_dt, velocity);
  return pushed.failure.empty() && is_near(pushed.late.acceleration, foretold(block));
}

// A slender wedge goes far before it has pressed the rock beside it as far apart as it takes to clamp it.
inline bool stands_in_stiff_rock(LetGo part) {
  for (Material& material : part.model.materials) material.young *= 100;
  const Measured run = run_let_go(part, close_dt);
  return run.failure.empty() && is_near(run.mean.acceleration, Vec2::Zero());
}

// Why a key block does something else.
inline std::string cause_of_other_motion(const KeyBlock& block, const Answers& answers, const Measured& run,
                                         const LetGo& part) {
  const bool stands = is_near(run.mean.acceleration, Vec2::Zero());
  const std::string how = stands ? "stands" : "goes otherwise";
  if (goes_as_foretold_when_pushed(block, answers, part)) return how + ", as it may, and goes as foretold when pushed";
  if (stands && answers.may_rest())
    return how + (answers.foretold_is_one_without_turning() ? ", as it may, also when pushed"
                                                            : ", as it may; going as foretold it would turn");
  return "";
}

// Why a body moves that is foretold to stay.
inline std::string cause_of_motion(const KeyBlock& block, const Answers& answers, const Measured& run,
                                   const LetGo& part) {
  if (stands_in_stiff_rock(part)) return "moves, and stands in rock a hundred times as stiff";
  const bool is_held_by_friction = answers.may_rest() && !answers.may_rest_without_friction();
  return is_held_by_friction && !block.turns && has_turned(block, run) ? "turns out where friction could hold it" : "";
}

// Why `run`, a close look that differs from what is foretold, does; empty where nothing shows it.
inline std::string cause_of(const KeyBlock& block, const Answers& answers, const Measured& run, const LetGo& part) {
  if (!run.failure.empty() || answers.lacking_of(run) > agreement) return "";
  const auto cause_of_its_type = block.type == BlockType::key ? cause_of_other_motion : cause_of_motion;
  std::string cause = cause_of_its_type(block, answers, run, part);
  if (!cause.empty()) return cause;
  if (is_faster_by_lost_cohesion(block, run)) return "goes faster by cohesion of ends that open";
  if (block.turns && has_turned(block, run)) return "turns as foretold";
  return block.turns && !answers.foretold_is_one_without_turning() ? "leans on other faces, foretold to turn" : "";
}

}  // namespace dda
