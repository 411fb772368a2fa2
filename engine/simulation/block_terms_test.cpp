#include "dda/simulation/block_terms.h"

#include <gtest/gtest.h>

#include "dda/simulation/simulation_models.h"

namespace dda {
namespace {

std::vector<double> factors(Model model, double asked) {
  Stage stage = stage_of(trapezoidal_integrator(), 1e-4, 1);
  stage.strain_inertia = asked;
  model.stages = {stage};
  finish_model(model);
  std::vector<double> result;
  for (const Inertia& inertia : make_block_terms(model, stage, make_contacts(model)).inertia)
    result.push_back(inertia.strain_inertia);
  return result;
}

TEST(StrainInertia, FollowsTheMeshWhereLeftToIt) {
  const std::vector<double> raised(4, 1.5), own(4, 1.0);
  EXPECT_EQ(factors(grid_of(2, bond(InterfaceLaw::consistent)), Stage::by_mesh), raised);
  EXPECT_EQ(factors(grid_of(2, bond(InterfaceLaw::cubic)), Stage::by_mesh), raised);  // no chain: consistent
  EXPECT_EQ(factors(bar_of(4, bond(InterfaceLaw::consistent)), Stage::by_mesh), raised);
  EXPECT_EQ(factors(bar_of(4, bond(InterfaceLaw::cubic)), Stage::by_mesh), own);
  EXPECT_EQ(factors(grid_of(2, bond(InterfaceLaw::classical)), Stage::by_mesh), own);
  EXPECT_EQ(factors(grid_of(2, bond(InterfaceLaw::consistent)), 1.2), std::vector<double>(4, 1.2));
  EXPECT_EQ(factors(bar_of(4, bond(InterfaceLaw::cubic)), 2), std::vector<double>(4, 2.0));
}

// A bar whose last block has a load on its side, so that its joint is consistent: the block before it is of both.
TEST(StrainInertia, IsThatOfACubicChainWhereABlockIsInOne) {
  Model model = bar_of(4, bond(InterfaceLaw::cubic));
  model.edge_loads = {{3, {3, 0}, {4, 0}, {0, 1}, Constant{}}};
  EXPECT_EQ(factors(model, Stage::by_mesh), (std::vector<double>{1, 1, 1, 1.5}));
}

}  // namespace
}  // namespace dda
