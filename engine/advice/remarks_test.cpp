#include "engine/advice/remarks.h"
#include "engine/contact/make_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace dda {
namespace {

Block square(const std::string& name, double x, double y, double side) {
  Block block;
  block.name = name;
  block.shape.outer = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  return block;
}

// Three blocks of 1 m on each other, the lowest held, under gravity: nothing to remark on.
Model ordinary() {
  Model model;
  model.materials = {{"rock", 2600, 10e9, 0.2, PlaneState::stress}};
  JointMaterial joint;
  joint.name = "default";
  joint.friction_angle = 0.6;
  model.joints = {joint};
  for (int i = 0; i < 3; ++i) model.blocks.push_back(square("b" + std::to_string(i), 0, i, 1));
  HeldBlock held;
  held.block = 0;
  model.held_blocks = {held};
  model.gravity = {0, -9.81};
  Stage stage;
  stage.name = "run";
  stage.dt = 1e-3;
  stage.duration = 1;
  model.stages = {stage};
  return model;
}

void make_static(Model& model) { model.stages[0].integrator.is_static = true; }

void shake(Model& model) {
  model.held_blocks[0].amplitude = {1e-2, 0};
  model.held_blocks[0].history = SineCycles{.frequency = 2};
}

// A second stage of 0.5 s takes the uppermost block away by a table; a static one that takes no time comes after it.
void take_away(Model& model, PiecewiseLinear table) {
  model.stages.push_back(model.stages[0]);
  model.stages[1].name = "gone";
  model.stages[1].duration = 0.5;
  model.stages[1].removal = {{2}, std::move(table)};
  Stage& rest = model.stages.emplace_back();
  rest.integrator = static_integrator();
  rest.equilibrium = 1e-9;
}

// A bolt between the lower blocks is taken out after the first stage, and what it exerted fades over 2 s.
void take_a_bolt_out(Model& model) {
  model.stages.push_back(model.stages[0]);
  model.stages[1].name = "without";
  Bolt bolt;
  bolt.name = "prop";
  bolt.direction = {0, 1};
  bolt.links = {{0, 1, {0.5, 0.5}, {0.5, 1.5}, 1e8, 0}};
  bolt.withdrawal = {0, PiecewiseLinear{{0, 2}, {1, 0}}};
  model.bolts = {bolt};
}

std::vector<std::string> remarks_after(const std::function<void(Model&)>& change) {
  Model model = ordinary();
  change(model);
  finish_model(model);
  return remarks_on(model, make_contacts(model));
}

struct OddScene {
  std::string name;
  std::function<void(Model&)> change;
  std::string remark;  // the only one; empty: none
};

class Remark : public testing::TestWithParam<OddScene> {};

TEST_P(Remark, IsTheOnlyOne) {
  const std::vector<std::string> remarks = remarks_after(GetParam().change);
  if (GetParam().remark.empty())
    EXPECT_EQ(remarks, std::vector<std::string>());
  else
    EXPECT_EQ(remarks, std::vector<std::string>{GetParam().remark});
}

const std::vector<OddScene> odd_scenes = {
    {"none", [](Model&) {}, ""},
    {"no_gravity_not_held",
     [](Model& model) {
       model.held_blocks.clear();
       model.gravity = {0, 0};
     },
     ""},
    {"one_that_falls", [](Model& model) { model.blocks.push_back(square("stone", 0, 5, 1)); }, ""},
    {"nothing_held", [](Model& model) { model.held_blocks.clear(); },
     "nothing holds the blocks, and there is gravity: they all fall without end"},
    {"loose_in_a_static_stage",
     [](Model& model) {
       model.blocks.push_back(square("stone", 0, 5, 1));
       model.blocks.push_back(square("other", 0, 6, 1));
       make_static(model);
     },
     "stage \"run\" is static, and block \"stone\" and 1 more touches nothing that is held: it has no equilibrium"},
    {"gravity_upwards",
     [](Model& model) {
       model.gravity = {0, 9.81};
     },
     "gravity points upwards, [0, 9.81] m/s2: y is up, so weight has a negative y"},
    {"compression_in_situ",
     [](Model& model) {
       model.blocks[1].initial_stress = {-1e6, -2e6, 0};
     },
     ""},
    {"tension_in_situ",
     [](Model& model) {
       model.blocks[1].initial_stress = {-1e6, 2e6, 0};
     },
     "block \"b1\" starts in tension, 2e+06 Pa: stresses are positive in tension, in-situ compression is negative"},
    {"soft", [](Model& model) { model.materials[0].young = 20; },
     "material \"rock\": young is 20 Pa, softer than any soil (1 MPa); rock has some GPa"},
    {"light", [](Model& model) { model.materials[0].density = 2.65; },
     "material \"rock\": density is 2.65 kg/m3; rock has 2000 to 3000 kg/m3"},
    {"sliver", [](Model& model) { model.blocks.push_back(square("chip", 0.5, 3, 1e-3)); },
     "block \"chip\" is 0.001 m in size, 0.001 of the middle block's: such slivers make steps dear, or fail; leave "
     "them out (where rock is cut, \"merge\": {\"area\": 1.1e-06} adds them to neighbours)"},
    {"half_the_size", [](Model& model) { model.blocks.push_back(square("chip", 0.5, 3, 0.5)); }, ""},
    {"gap", [](Model& model) { model.blocks.push_back(square("top", 0.5, 3.001, 1)); },
     "blocks \"b2\" and \"top\" are 0.001 m apart and do not touch: blocks touch within 4.3e-09 m"},
    {"two_gaps",
     [](Model& model) {
       model.blocks.push_back(square("top", 0, 3.001, 1));
       model.blocks.push_back(square("side", 1.001, 3.001, 1));
     },
     "blocks \"b2\" and \"top\" are 0.001 m apart, 1 more pairs as little, and do not touch: blocks touch within "
     "4.5e-09 "
     "m"},
    {"gap_one_sees", [](Model& model) { model.blocks.push_back(square("top", 0.5, 3.1, 1)); }, ""},
    {"long_step", [](Model& model) { model.stages[0].dt = 0.5; },
     "stage \"run\": in a step of 0.5 s a block falls 1.2 m, and the smallest is 1 m"},
    {"long_static_step",
     [](Model& model) {
       model.stages[0].dt = 0.5;
       make_static(model);
     },
     ""},
    {"step_of_many_crossings",
     [](Model& model) {
       model.stages[0].dt = 0.5;
       model.gravity = {0, 0};
     },
     "stage \"run\": in a step of 0.5 s a P wave crosses the scene 3.2e+02 times"},
    {"coarse_step",
     [](Model& model) {
       model.gravity = {0, 0};
       model.joints[0].bonded = true;
       model.edge_loads.push_back({2, {0, 3}, {1, 3}, {0, 1}, PiecewiseLinear{{0, 4e-3}, {0, 1}}});
       model.stages[0].dt = 2.5e-3;
     },
     "stage \"run\": loads change as fast as a wave of 62.5 Hz does, whose speed steps of 0.0025 s alter by -7 % and "
     "of whose amplitude they take 0 % in a period; at a dt of 0.00063 s it is 1 and 5 % at most"},
    {"smooth_table",  // a sine with 25 steps in a period, of which the trapezoidal rule alters the speed by 0.5 %
     [](Model& model) {
       model.gravity = {0, 0};
       model.joints[0].bonded = true;
       PiecewiseLinear table;
       for (int i = 0; i <= 400; ++i) {
         table.times.push_back(i * 1.25e-4);
         table.values.push_back(std::sin(2 * std::numbers::pi * i / 400));
       }
       model.edge_loads.push_back({2, {0, 3}, {1, 3}, {0, 1}, table});
       model.stages[0].dt = 2e-3;
     },
     ""},
    {"coarse_damping_rate",
     [](Model& model) {
       model.stages[0].damping_rate = 50;
       model.stages[0].dt = 1e-2;
     },
     "stage \"run\": damping_rate times dt is 0.5, and velocities miss about half of that as a share of them; at a dt "
     "of 0.0004 s it is 1 %"},
    {"fine_damping_rate", [](Model& model) { model.stages[0].damping_rate = 19; }, ""},
    {"fine_step",
     [](Model& model) {
       model.joints[0].bonded = true;
       model.edge_loads.push_back({2, {0, 3}, {1, 3}, {0, 1}, PiecewiseLinear{{0, 4e-3}, {0, 1}}});
       model.stages[0].dt = 1e-4;
     },
     ""},
    {"brittle", [](Model& model) { model.joints[0].cohesion = 1e6; },
     "joint \"default\" is brittle: residual_cohesion is 0 or left out, so a contact that fails loses all of its 1e+06 "
     "Pa"},
    // 50 kPa / tan(0.6 rad) = 73.1 kPa, on either side of which the joint is as strong as it says or not.
    {"no_shear_strength_where_it_is_pulled",
     [](Model& model) {
       model.joints[0].cohesion = 50e3;
       model.joints[0].residual_cohesion = 1e3;
       model.joints[0].tensile_strength = 74e3;
     },
     "joint \"default\": tensile_strength is 74000 Pa, but from cohesion / tan(friction_angle) = 7.31e+04 Pa of "
     "tension "
     "on it has no shear strength, and the least shear breaks it"},
    {"shear_strength_where_it_is_pulled",
     [](Model& model) {
       model.joints[0].cohesion = 50e3;
       model.joints[0].residual_cohesion = 1e3;
       model.joints[0].tensile_strength = 73e3;
     },
     ""},
    {"no_shear_strength_without_cohesion", [](Model& model) { model.joints[0].tensile_strength = 1e3; },
     "joint \"default\": tensile_strength is 1000 Pa, but from cohesion / tan(friction_angle) = 0 Pa of tension on it "
     "has "
     "no shear strength, and the least shear breaks it"},
    {"shear_strength_without_friction",
     [](Model& model) {
       model.joints[0].cohesion = 50e3;
       model.joints[0].residual_cohesion = 1e3;
       model.joints[0].friction_angle = 0;
       model.joints[0].tensile_strength = 1e6;
     },
     ""},
    {"no_shear_stiffness",
     [](Model& model) {
       model.joints[0].law = InterfaceLaw::classical;
       model.joints[0].shear_to_normal = 0;
     },
     "joint \"default\": shear_to_normal is 0, so it never resists shear while it is elastic, and what it has of "
     "friction or cohesion does not act then"},
    {"no_shear_stiffness_but_of_its_own",
     [](Model& model) {
       model.joints[0].law = InterfaceLaw::classical;
       model.joints[0].shear_to_normal = 0;
       model.joints[0].normal_stiffness = 1e10;
       model.joints[0].shear_stiffness = 1e9;
     },
     ""},
    {"no_shear_stiffness_where_nothing_holds_shear",
     [](Model& model) {
       model.joints[0].law = InterfaceLaw::classical;
       model.joints[0].shear_to_normal = 0;
       model.joints[0].friction_angle = 0;
     },
     ""},
    {"no_shear_stiffness_in_a_law_without_springs",
     [](Model& model) {
       model.joints[0].shear_to_normal = 0;
       model.joints[0].bonded = true;
     },
     ""},
    {"shaken_without_damping", shake,
     "stage \"run\": trapezoidal damps nothing, and joint \"default\" has friction without contact_damping: blocks "
     "that "
     "are shaken chatter on it and may slide many times too far; take an integrator that damps, or a contact_damping "
     "of "
     "0.2"},
    {"pushed_to_and_fro_without_damping",
     [](Model& model) {
       model.stages[0].integrator = energy_conserving_integrator();
       model.point_loads.push_back({2, {0.5, 2.5}, {1e3, 0}, SineCycles{.frequency = 2}});
     },
     "stage \"run\": energy_conserving damps nothing, and joint \"default\" has friction without contact_damping: "
     "blocks that are shaken chatter on it and may slide many times too far; take an integrator that damps, or a "
     "contact_damping of 0.2"},
    // Weight towards 40 degrees from the normal of all joints: beyond the friction of 0.6 rad, and within that of 0.8.
    {"slides_down_without_damping",
     [](Model& model) {
       model.stages[0].integrator = energy_conserving_integrator();
       model.gravity = 9.81 * Vec2(std::sin(0.7), -std::cos(0.7));
     },
     "stage \"run\": energy_conserving damps nothing, and blocks slide down along joint \"default\": they may chatter "
     "and go many times too far, with contact_damping and at short steps too; take an integrator that damps"},
    {"does_not_slide_down",
     [](Model& model) {
       model.stages[0].integrator = energy_conserving_integrator();
       model.joints[0].friction_angle = 0.8;
       model.gravity = 9.81 * Vec2(std::sin(0.7), -std::cos(0.7));
     },
     ""},
    {"slides_down_on_strong_friction",
     [](Model& model) {
       model.stages[0].integrator = generalized_alpha_integrator(0);
       model.joints[0].friction_angle = 0.68;
       model.gravity = 9.81 * Vec2(std::sin(0.7), -std::cos(0.7));
     },
     "stage \"run\": blocks slide down along joint \"default\", whose friction is strong: their vibrations feed on it, "
     "and how far they go hangs on dt: short steps let them go too far, long ones hold back what moves; compare with a "
     "longer and a shorter dt than 0.001 s; where they differ take a contact_damping of 0.2, or let go over a time"},
    {"slides_down_on_weak_friction",
     [](Model& model) {
       model.stages[0].integrator = generalized_alpha_integrator(0);
       model.gravity = 9.81 * Vec2(std::sin(0.7), -std::cos(0.7));
     },
     ""},
    {"pushed_steadily",
     [](Model& model) {
       model.point_loads.push_back({2, {0.5, 2.5}, {1e3, 0}, Constant{}});
     },
     ""},
    {"shaken_with_an_integrator_that_damps",
     [](Model& model) {
       shake(model);
       model.stages[0].integrator = generalized_alpha_integrator(0.8);
     },
     ""},
    {"shaken_with_contact_damping",
     [](Model& model) {
       shake(model);
       model.joints[0].contact_damping = 0.2;
     },
     ""},
    {"shaken_bonded_blocks",
     [](Model& model) {
       shake(model);
       model.joints[0].bonded = true;
     },
     ""},
    {"a_load_half_on_a_held_block",
     [](Model& model) {
       for (const int block : {0, 1})
         model.edge_loads.push_back({block, {0, block + 1.0}, {0, block + 0.0}, {1e3, 0}, Constant{}});
     },
     "the load of 1000 Pa lies with 50 % of its 2 m on block \"b0\", which is held: that part moves nothing"},
    {"loads_beside_a_held_block_and_in_the_joint_to_it",
     [](Model& model) {
       model.edge_loads = {{0, {1, 1}, {0, 1}, {0, -1e3}, Constant{}}, {1, {0, 1}, {1, 1}, {0, 1e3}, Constant{}}};
       model.edge_loads.push_back({1, {0, 2}, {0, 1}, {1e3, 0}, Constant{}});
     },
     ""},
    {"a_point_load_on_a_held_block",
     [](Model& model) {
       model.point_loads = {{0, {0, 0.5}, {1e3, 0}, Constant{}}, {1, {0, 1.5}, {1e3, 0}, Constant{}}};
     },
     "all of the load of [1000, 0] N at (0, 0.5) m is on block \"b0\", which is held: it moves nothing"},
    {"a_support_on_a_held_block",
     [](Model& model) {
       for (const int block : {0, 1})
         model.supports.push_back({block, {0, block + 0.5}, true, true, 1e9, {0, 0}, Constant{}});
     },
     "1 of 2 springs of supports are on blocks that are held, the first on block \"b0\": they do nothing there"},
    {"a_fade_that_is_not_over",
     [](Model& model) {
       take_away(model, {{0, 1}, {1, 0}});
     },
     "stage \"gone\": what the blocks that it removes exerted fades until 2 s, and the run ends at 1.5 s: 50 % of it "
     "still "
     "acts then, and 0 % would in the end; stages that last longer, or a fade that is over sooner, get there"},
    {"a_fade_that_is_over",
     [](Model& model) {
       take_away(model, {{0, 0.5}, {1, 0}});
     },
     ""},
    {"a_fade_that_stops_on_purpose",
     [](Model& model) {
       take_away(model, {{0, 0.5, 9}, {1, 0.3, 0.3}});
     },
     ""},
    {"a_fade_to_a_share_that_is_not_over",
     [](Model& model) {
       take_away(model, {{0, 1}, {1, 0.4}});
     },
     "stage \"gone\": what the blocks that it removes exerted fades until 2 s, and the run ends at 1.5 s: 70 % of it "
     "still "
     "acts then, and 40 % would in the end; stages that last longer, or a fade that is over sooner, get there"},
    {"a_fading_bolt", take_a_bolt_out,
     "stage \"without\": what bolt \"prop\", taken out when it begins, exerted fades until 3 s, and the run ends at 2 "
     "s: 50 "
     "% of it still acts then, and 0 % would in the end; stages that last longer, or a fade that is over sooner, get "
     "there"},
    {"tough",
     [](Model& model) {
       model.joints[0].cohesion = 1e6;
       model.joints[0].residual_cohesion = 1e5;
     },
     ""},
};

// Contacts of another moment than that of the drawing: between blocks that touch there is no gap to remark on.
TEST(Remarks, BlocksWithinWhatTouchesAreNotApart) {
  Model model = ordinary();
  finish_model(model);
  ContactSet contacts = make_contacts(model);
  contacts.interfaces.clear();
  EXPECT_EQ(remarks_on(model, contacts), std::vector<std::string>());
}

INSTANTIATE_TEST_SUITE_P(Scenes, Remark, testing::ValuesIn(odd_scenes),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace dda
