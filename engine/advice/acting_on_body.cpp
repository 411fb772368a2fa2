#include "engine/advice/acting_on_body.h"

#include <cmath>

#include "engine/geometry/segment.h"
#include "engine/model/stage_times.h"
#include "engine/model/time_function.h"

namespace dda {
namespace {

constexpr double round_off = 1e-6;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void add(const Vec2& force, const Vec2& place, ActingOnBody& sum) {
  sum.force += force;
  sum.moment += cross(place, force);
  sum.virial += place.dot(force);
  sum.sizes_of_forces += force.norm();
  sum.sizes_of_moments += place.norm() * force.norm();
}

// What follows its face has no moment about its turn. The part that rises along the stretch has no force of its own.
void add(const EdgeLoad& load, double factor, const Vec2& middle, ActingOnBody& sum) {
  const double before = sum.virial;
  const Vec2 half = (load.to - load.from) / 2;
  const Vec2 rising = factor * 2 * half.norm() / 3 * load.rise;
  add(factor * 2 * half.norm() * load.traction, load.from + half - middle, sum);
  sum.moment += cross(half, rising);
  sum.virial = load.follows ? before : sum.virial + half.dot(rising);
}

class Sums {
 public:
  Sums(const Model& model, const std::vector<std::vector<int>>& bodies)
      : model_(model), body_of_(model.blocks.size(), -1), middles_(bodies.size(), Vec2::Zero()), sums_(bodies.size()) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (const int block : bodies[i]) {
        body_of_[at(block)] = static_cast<int>(i);
        middles_[i] += model.blocks[at(block)].moments.centroid / static_cast<double>(bodies[i].size());
      }
  }

  std::vector<ActingOnBody> at_time(std::size_t stage, double time) {
    for (int block = 0; block < static_cast<int>(model_.blocks.size()); ++block)
      to_body_of(block, [&](const Vec2& middle, ActingOnBody& sum) {
        add(model_.mass_of(block) * model_.gravity, model_.blocks[at(block)].moments.centroid - middle, sum);
      });
    for (const PointLoad& load : model_.point_loads)
      if (load.stages.has(stage))
        to_body_of(load.block, [&](const Vec2& middle, ActingOnBody& sum) {
          add(evaluate(load.history, time) * load.force, load.point - middle, sum);
        });
    for (const EdgeLoad& load : model_.edge_loads)
      if (load.stages.has(stage))
        to_body_of(load.block, [&](const Vec2& middle, ActingOnBody& sum) {
          add(load, evaluate(load.history, time), middle, sum);
        });
    return sums_;
  }

 private:
  template <typename Add>
  void to_body_of(int block, const Add& add) {
    if (body_of_[at(block)] >= 0) add(middles_[at(body_of_[at(block)])], sums_[at(body_of_[at(block)])]);
  }

  const Model& model_;
  std::vector<int> body_of_;
  std::vector<Vec2> middles_;
  std::vector<ActingOnBody> sums_;
};

}  // namespace

bool ActingOnBody::is_in_balance() const {
  return force.norm() <= round_off * sizes_of_forces && std::abs(moment) <= round_off * sizes_of_moments;
}

bool ActingOnBody::turns_further() const { return virial < -round_off * sizes_of_moments; }

std::vector<ActingOnBody> acting_on_bodies(const Model& model, std::size_t stage,
                                           const std::vector<std::vector<int>>& bodies) {
  if (bodies.empty()) return {};
  const double start = begin_of_stage(model, stage);
  std::vector<ActingOnBody> acting = Sums(model, bodies).at_time(stage, start);
  const double duration = model.stages[stage].duration;
  if (duration == 0) return acting;
  const std::vector<ActingOnBody> later = Sums(model, bodies).at_time(stage, start + duration);
  for (std::size_t i = 0; i < acting.size(); ++i)
    if (acting[i].is_in_balance()) acting[i] = later[i];
  return acting;
}

}  // namespace dda
