#include "engine/simulation/contact_range.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/contact/make_contacts.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

Model scene(std::vector<Block> blocks) {
  Model model;
  model.materials = {{"rock", 2600, 10e9, 0.2, PlaneState::stress}};
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  model.joints = {joint};
  model.blocks = std::move(blocks);
  Stage stage;
  stage.dt = 1e-3;
  stage.duration = 1;
  stage.integrator = generalized_alpha_integrator(0.8);
  model.stages = {stage};
  return model;
}

Status run(Simulation& simulation) {
  Status status = Status::ok;
  while (!simulation.finished() && status == Status::ok) status = simulation.step();
  return status;
}

TEST(ContactRange, NamesBlocksThatMeetElsewhere) {
  Model model = scene({rectangle("floor", 0, 0, 3, 1), rectangle("stone", 1, 1.1, 1, 1)});
  model.blocks[1].initial_velocity = {0, -1};
  model.joints[0].bonded = true;  // other contacts are followed
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_EQ(run(simulation), Status::left_contact_range);
  EXPECT_EQ(simulation.message(),
            "blocks \"floor\" and \"stone\" have run into each other where they did not touch at the start: contacts "
            "other than those of the start are not followed yet");
  // The gap of 0.1 m closes at 0.1 s; the skin is 1 % of the stone's thickness (area/diameter) of 0.71 m.
  EXPECT_GT(simulation.state().time, 0.1);
  EXPECT_LT(simulation.state().time, 0.1 + 0.001 * 0.71 + 0.01 * 0.71 + 2e-3);
}

TEST(ContactRange, BlocksThatPassEachOtherAreLeftAlone) {
  Model model = scene({rectangle("floor", 0, 0, 3, 1), rectangle("stone", 1, 1.001, 1, 1)});
  model.blocks[1].initial_velocity = {4, 0};
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_EQ(run(simulation), Status::ok) << simulation.message();
}

TEST(ContactRange, NamesBlocksThatSlideOff) {
  Model model = scene({rectangle("floor", 0, 0, 3, 1), rectangle("sledge", 1, 1, 1, 0.2)});
  finish_model(model);
  const ContactSet contacts = make_contacts(model);
  ContactRange range(model, contacts.interfaces);
  State state = initial_state(model);
  state.displacement[1].x() = -0.99;
  EXPECT_EQ(range.problem(model, state, contacts), "");
  state.displacement[1].x() = -1.01;
  EXPECT_EQ(range.problem(model, state, contacts),
            "blocks \"floor\" and \"sledge\" have slid off their common edge: contacts other than those of the start "
            "are not followed yet");
}

// Dry contacts are followed where they go: along the floor, over its edge and into the air.
TEST(ContactRange, ASlidingRunGoesOn) {
  Model model = scene({rectangle("floor", 0, 0, 3, 1), rectangle("sledge", 1, 1, 1, 0.2)});
  for (const double x : {0.0, 3.0}) model.supports.push_back({0, {x, 0}, true, true, 1e12, Vec2::Zero(), Constant{}});
  model.blocks[1].initial_velocity = {5, 0};
  model.gravity = {0, -9.81};
  model.stages[0].integrator = thesis_integrator();  // damps the landing on the springs
  Simulation simulation = simulation_of(std::move(model));
  while (simulation.state().time < 0.29) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  // Smooth: nothing holds it back, and its middle is still above the floor.
  EXPECT_NEAR(simulation.state().velocity[1](0), 5, 1e-3);
  EXPECT_NEAR(simulation.state().displacement[1](1), 0, 1e-3);
  EXPECT_EQ(run(simulation), Status::ok) << simulation.message();
  // Then it falls; what its tail pushes up while it is still on the edge is less than all of its weight.
  const double fall = 9.81 * 0.7 * 0.7 / 2;
  EXPECT_LT(simulation.state().displacement[1](1), -0.7 * fall);
  EXPECT_GT(simulation.state().displacement[1](1), -fall);
}

// A lone vertex has slid off when it passes the corner of the edge it stands on.
TEST(ContactRange, LoneVertexHasItsEdge) {
  Block wedge;
  wedge.name = "wedge";
  wedge.shape.outer = {{2.2, 1}, {2.7, 2}, {1.7, 2}};
  Model model = scene({rectangle("floor", 0, 0, 3, 1), wedge});
  finish_model(model);
  const ContactSet contacts = make_contacts(model);
  ASSERT_EQ(contacts.interfaces.size(), 1U);
  ContactRange range(model, contacts.interfaces);
  State state = initial_state(model);
  state.displacement[1].x() = 0.79;
  EXPECT_EQ(range.problem(model, state, contacts), "");
  state.displacement[1].x() = 0.82;
  EXPECT_NE(range.problem(model, state, contacts), "");
}

TEST(ContactRange, LooksAgainOnlyBeyondTheSkin) {
  Model model = scene({rectangle("floor", 0, 0, 3, 1), rectangle("stone", 1, 1.001, 1, 1)});
  finish_model(model);
  const ContactSet contacts = make_contacts(model);
  ContactRange range(model, contacts.interfaces);
  State state = initial_state(model);
  // Thickness: the stone's area over its diameter, 0.71 m; skin 7.1 mm, tolerance 0.71 mm.
  state.displacement[1].y() = -0.007;
  EXPECT_EQ(range.problem(model, state, contacts), "") << "within the skin";
  state.displacement[1].y() = -0.0072;
  EXPECT_NE(range.problem(model, state, contacts), "") << "beyond it";
}

// A rotation moves the corners though the centroid stays.
TEST(ContactRange, SeesRotation) {
  Model model = scene({rectangle("floor", 0, 0, 3, 1), rectangle("stone", 1, 1.01, 1, 1)});
  model.blocks[1].initial_spin = 1;
  model.joints[0].bonded = true;
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_EQ(run(simulation), Status::left_contact_range);
  // The corner comes down by about angle/2: 0.01 m of gap and 1 % of the thickness for skin and tolerance.
  EXPECT_LT(simulation.state().time, 0.06);
}

// Corners that meet in a grid come a little nearer under load; that is no new contact.
TEST(ContactRange, LoadedGridStaysInRange) {
  std::vector<Block> blocks;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      blocks.push_back(rectangle(fmt::format("b{}", 3 * row + column), column, row, 1, 1));
  }
  Model model = scene(std::move(blocks));
  model.joints[0].bonded = true;
  model.stages[0].duration = 0.05;
  for (int column = 0; column < 3; ++column) {
    const double x = column;
    model.edge_loads.push_back({6 + column, {x + 1, 3}, {x, 3}, {0, -2e6}, Constant{}});
    for (const double end : {x, x + 1})
      model.supports.push_back({column, {end, 0}, true, true, 1e13, Vec2::Zero(), Constant{}});
  }
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_EQ(run(simulation), Status::ok) << simulation.message();
}

// Blocks of an open joint that come together elsewhere are noticed although they have an interface.
TEST(ContactRange, OpenInterfaceDoesNotExcuseOverlap) {
  Model model = scene({rectangle("left", 0, 0, 1, 1), rectangle("right", 1, 0, 1, 1)});
  finish_model(model);
  ContactSet contacts = make_contacts(model);
  ASSERT_EQ(contacts.interfaces.size(), 1U);
  ContactRange range(model, contacts.interfaces);
  State state = initial_state(model);
  state.displacement[1].x() = -0.05;
  EXPECT_EQ(range.problem(model, state, contacts), "") << "a closed contact, however deep";
  contacts.states[0].status = {ContactStatus::open, ContactStatus::open};
  state.displacement[1].x() = -0.06;
  EXPECT_NE(range.problem(model, state, contacts), "");
}

// A hole of one square in bonded squares under 2 % of their modulus: across its corners blocks are in each other by
// what they strain, 1.3 % of their size and more.
TEST(ContactRange, BlocksAcrossACornerOfAHoleMayStrain) {
  std::vector<Block> blocks;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i)
      if (i != 2 || j != 2) blocks.push_back(rectangle(fmt::format("{}.{}", i, j), i, j, 1, 1));
  Model model = scene(std::move(blocks));
  model.joints[0].bonded = true;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const int block = static_cast<int>(b);
    const Vec2 corner = model.blocks[b].shape.outer[0];
    const double p = 2e8;
    if (corner.x() == 0) model.edge_loads.push_back({block, corner + Vec2(0, 1), corner, {p, 0}, Constant{}});
    if (corner.x() == 4)
      model.edge_loads.push_back({block, corner + Vec2(1, 0), corner + Vec2(1, 1), {-p, 0}, Constant{}});
    if (corner.y() == 0) model.edge_loads.push_back({block, corner, corner + Vec2(1, 0), {0, p}, Constant{}});
    if (corner.y() == 4)
      model.edge_loads.push_back({block, corner + Vec2(1, 1), corner + Vec2(0, 1), {0, -p}, Constant{}});
  }
  model.supports = {{0, {0, 0}, true, true, 1e9, Vec2::Zero(), {}}, {4, {5, 0}, false, true, 1e9, Vec2::Zero(), {}}};
  model.stages[0].integrator = static_integrator();
  model.stages[0].dt = 0;
  model.stages[0].duration = 0;
  model.stages[0].equilibrium = 1e-9;
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_EQ(run(simulation), Status::ok) << simulation.message();
}

}  // namespace
}  // namespace dda
