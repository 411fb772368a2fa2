#include "engine/simulation/released_forces.h"

#include <Eigen/LU>
#include <algorithm>
#include <optional>

namespace dda {
namespace {

// Sum of f r^T from forces on the unknowns, which do the work f . (displacement_rows(r) d).
Mat2 lever_of(const Vec6& forces) {
  Mat2 lever;
  lever << forces(3), forces(5) - forces(2) / 2, forces(5) + forces(2) / 2, forces(4);
  return lever;
}

Vec6 on_unknowns(const Vec2& force, const Mat2& lever) {
  Vec6 forces;
  forces << force, lever(1, 0) - lever(0, 1), lever(0, 0), lever(1, 1), (lever(0, 1) + lever(1, 0)) / 2;
  return forces;
}

// What exerted forces, by its kind and number; nothing where the model has none of that number, or it does not fade.
const TimeFunction* relaxation_of(const Model& model, Released what, std::size_t number) {
  const auto of = [number](const auto& list, const auto& relaxation) -> const TimeFunction* {
    if (number >= list.size()) return nullptr;
    const std::optional<TimeFunction>& fading = relaxation(list[number]);
    return fading ? &*fading : nullptr;
  };
  const auto of_withdrawal = [](const auto& item) -> const auto& { return item.withdrawal.relaxation; };
  if (what == Released::bolt) return of(model.bolts, of_withdrawal);
  if (what == Released::lining) return of(model.linings, of_withdrawal);
  return of(
      model.stages, [](const Stage& stage) -> const auto& { return stage.removal.relaxation; });
}

}  // namespace

void ReleasedForces::keep(Released what, std::size_t number, double start, const Eigen::VectorXd& forces,
                          const std::vector<Mat2>& deformation) {
  for (std::size_t i = 0; i < deformation.size(); ++i) {
    const Vec6 own = forces.segment<6>(static_cast<Eigen::Index>(6 * i));
    if (own.isZero(0)) continue;
    const Mat2 drawn_lever = lever_of(own) * deformation[i].inverse().transpose();
    loads_.push_back({what, number, start, static_cast<int>(i), own.head<2>(), drawn_lever, own});
  }
}

void ReleasedForces::update_geometry(const std::vector<Mat2>& deformation) {
  for (Load& load : loads_)
    load.now =
        on_unknowns(load.force, load.drawn_lever * deformation[static_cast<std::size_t>(load.block)].transpose());
}

void ReleasedForces::add_loads_at(const Model& model, double time, Eigen::VectorXd& force) const {
  for (const Load& load : loads_)
    force.segment<6>(6 * load.block) +=
        evaluate(*relaxation_of(model, load.what, load.number), time - load.start) * load.now;
}

bool ReleasedForces::fit(const Model& model) const {
  return std::ranges::all_of(loads_,
                             [&](const Load& load) { return relaxation_of(model, load.what, load.number) != nullptr; });
}

}  // namespace dda
