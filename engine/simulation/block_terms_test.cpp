#include "engine/simulation/block_terms.h"

#include <gtest/gtest.h>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

TEST(StrainInertia, IsWhatTheStageAsksFor) {
  Model model = grid_of(2, bond(InterfaceLaw::consistent));
  Stage stage = stage_of(trapezoidal_integrator(), 1e-4, 1);
  stage.strain_inertia = 1.2;
  model.stages = {stage};
  finish_model(model);
  for (const Inertia& inertia : make_block_terms(model, stage).inertia) EXPECT_EQ(inertia.strain_inertia, 1.2);
}

}  // namespace
}  // namespace dda
