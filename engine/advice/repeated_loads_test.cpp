#include "engine/advice/repeated_loads.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <random>
#include <utility>

namespace dda {
namespace {

using Random = std::mt19937;

double number(Random& random) { return std::uniform_real_distribution(-1.0, 1.0)(random); }

TimeFunction history_by_lot(Random& random) {
  switch (std::uniform_int_distribution(0, 4)(random)) {
    case 0: return Constant{};
    case 1: return PiecewiseLinear{{0, 1}, {0, number(random)}};
    case 2: return SineCycles{50 + number(random), 1, 0};
    case 3: return ExponentialDecay{0.1, 0, 0.01 * (2 + number(random))};
    default:
      return Recorded{std::make_shared<Recording>("r.csv", std::vector<double>{0, 1}, std::vector<double>{0, 1}), 0};
  }
}

// Rock with as many loads on faces, none of them the same.
Model loaded(Random& random, int loads) {
  Model model;
  model.blocks.resize(5);
  for (std::size_t i = 0; i < 5; ++i) model.blocks[i].name = "b" + std::to_string(i);
  for (int i = 0; i < loads; ++i) {
    EdgeLoad load;
    load.block = std::uniform_int_distribution(0, 4)(random);
    load.from = {number(random), number(random)};
    load.to = {number(random), number(random)};
    load.traction = {number(random), number(random)};
    load.history = history_by_lot(random);
    model.edge_loads.push_back(load);
  }
  return model;
}

TEST(RepeatedLoads, AreToldWhereOneIsGivenAgain) {
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    Model model = loaded(random, 12);
    EXPECT_TRUE(repeated_loads(model).empty());
    const EdgeLoad again = model.edge_loads[std::uniform_int_distribution<std::size_t>(0, 11)(random)];
    model.edge_loads.push_back(again);
    const std::vector<std::string> remarks = repeated_loads(model);
    ASSERT_EQ(remarks.size(), 1U);
    const std::string& name = model.blocks[static_cast<std::size_t>(again.block)].name;
    EXPECT_NE(remarks[0].find("acts twice on block \"" + name + "\""), std::string::npos) << remarks[0];
  }
}

TEST(RepeatedLoads, AreOthersInOtherStagesOrOfNothing) {
  Random random(7);
  Model model = loaded(random, 3);
  EdgeLoad later = model.edge_loads[0];
  later.stages.first = 1;
  EdgeLoad nothing = model.edge_loads[1];
  nothing.traction.setZero();
  model.edge_loads.insert(model.edge_loads.end(), {later, nothing, nothing});
  EXPECT_TRUE(repeated_loads(model).empty());
}

}  // namespace
}  // namespace dda
