// Good scenes: what each section becomes in the model.
#include "engine/scene/scene.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <string>

#include "engine/core/error.h"

namespace dda {
namespace {

// A 4 m x 1 m bar of two blocks, with further sections from `more` and `steps`.
Model bar_with(const std::string& more, const std::string& steps = R"({"dt": 1e-4, "duration": 0.01})") {
  const std::string text = R"({"dda": 1, "materials": {"rock": {"density": 2500, "young": "40 GPa", "poisson": 0.25}},
    "blocks": {"bar": {"length": 4, "height": 1, "block_length": 2}},)" +
                           more + (more.empty() ? "" : ",") + R"("steps": )" + steps + "}";
  return parse_scene(text, "scene.json");
}

TEST(Scene, NumbersAreTheSameWithUnitsAndWithout) {
  const Model plain = bar_with(R"("gravity": [0, -9.81], "target_frequency": 100)");
  const Model units =
      bar_with(R"("gravity": "9810 mm/s2", "target_frequency": "0.1 kHz")", R"({"dt": "0.1 ms", "duration": "10 ms"})");
  EXPECT_EQ(plain.gravity, Vec2(0, -9.81));
  EXPECT_EQ(units.gravity, Vec2(0, -9.81));
  EXPECT_EQ(units.stages[0].dt, plain.stages[0].dt);
  EXPECT_EQ(units.stages[0].duration, 0.01);
  EXPECT_EQ(units.materials[0].young, 40e9);
}

TEST(Scene, PlaneIsOfTheSceneUnlessOfTheMaterial) {
  const auto plane_of = [](const std::string& scene, const std::string& material) {
    return parse_scene(R"({"dda": 1, )" + scene + R"("materials": {"m": {"density": 1, "young": 1, "poisson": 0)" +
                           material + R"(}}, "blocks": {"bar": {"length": 1, "height": 1, "block_length": 1}},
                           "steps": {"dt": 1, "duration": 1}})",
                       "scene.json")
        .materials[0]
        .plane;
  };
  EXPECT_EQ(plane_of("", ""), PlaneState::stress);
  EXPECT_EQ(plane_of(R"("plane": "strain",)", ""), PlaneState::strain);
  EXPECT_EQ(plane_of(R"("plane": "strain",)", R"(, "plane": "stress")"), PlaneState::stress);
}

TEST(Scene, JointsTakeWhatTheyLeaveUnsaidFromTheScheme) {
  const Model accurate = bar_with(R"("joints": {"default": {"friction_angle": "30 deg", "cohesion": "1 MPa"}})");
  EXPECT_EQ(accurate.joints[0].law, InterfaceLaw::projected);
  EXPECT_DOUBLE_EQ(accurate.joints[0].friction_angle, std::numbers::pi / 6);
  EXPECT_TRUE(accurate.joints[0].cohesion == 1e6 && accurate.joints[0].spring_over_young == 0);  // springs by sizes
  EXPECT_EQ(bar_with(R"("joints": {"default": {"law": "consistent"}})").joints[0].law, InterfaceLaw::consistent);
  const Model thesis = bar_with(R"("scheme": "thesis", "joints": {"default": {"shear_to_normal": 0.5}})");
  EXPECT_EQ(thesis.joints[0].law, InterfaceLaw::classical);
  EXPECT_EQ(thesis.joints[0].spring_over_young, 10);
  EXPECT_EQ(thesis.joints[0].shear_to_normal, 0.5);
}

// The force that a joint carried comes upon its springs at once when it breaks: chosen ones are stiff.
TEST(Scene, JointsThatMayBreakHaveChosenSpringsUnlessTheyHaveTheirOwn) {
  const auto are_chosen = [](const std::string& joint) {
    return bar_with(R"("joints": {"default": {)" + joint + "}}").joints[0].automatic_stiffness;
  };
  EXPECT_TRUE(are_chosen(R"("law": "cubic", "cohesion": 1e6)") && are_chosen(R"("law": "consistent", "cohesion": 1)"));
  for (const char* joint : {R"("bonded": true)", R"("law": "classical", "cohesion": 1e6)",
                            R"("cohesion": 1e6, "spring_over_young": 9)", R"("cohesion": 1e6, "normal_spring": 1e9)"})
    EXPECT_FALSE(are_chosen(joint)) << joint;
}

TEST(Scene, IntegratorFollowsFromSchemeJointsAndKinematics) {
  const std::string bonded = R"("joints": {"default": {"bonded": true}})";
  const std::string small = R"({"dt": 1, "duration": 1, "kinematics": "small"})";
  EXPECT_EQ(bar_with("").stages[0].integrator.name, "generalized_alpha");
  EXPECT_TRUE(bar_with(bonded, small).stages[0].correct_time_dispersion);
  EXPECT_FALSE(bar_with(bonded).stages[0].correct_time_dispersion);
  EXPECT_FALSE(bar_with("", small).stages[0].correct_time_dispersion);
  EXPECT_TRUE(bar_with(bonded, small).stages[0].correct_block_dispersion);
  EXPECT_FALSE(bar_with(bonded).stages[0].correct_block_dispersion);
  EXPECT_FALSE(bar_with("", small).stages[0].correct_block_dispersion);
  EXPECT_FALSE(bar_with(R"("scheme": "thesis", )" + bonded, small).stages[0].correct_block_dispersion);
  EXPECT_EQ(bar_with(R"("scheme": "thesis")").stages[0].integrator.name, "thesis");
  EXPECT_EQ(bar_with("", small).stages[0].kinematics, Kinematics::small);
  EXPECT_EQ(bar_with("").stages[0].kinematics, Kinematics::finite);
}

TEST(Scene, StaticStagesWithoutDtPaceThemselves) {
  const Model model = bar_with("", R"([{"integrator": "static"},
    {"integrator": "static", "dt": "auto", "duration": 3, "equilibrium": 1e-6},
    {"integrator": "static", "dt": 0.1, "duration": 1}])");
  EXPECT_TRUE(model.stages[0].paces_itself());
  EXPECT_EQ(model.stages[0].duration, 0);
  EXPECT_EQ(model.stages[0].equilibrium, 1e-9);
  EXPECT_TRUE(model.stages[1].paces_itself());
  EXPECT_EQ(model.stages[1].duration, 3);
  EXPECT_EQ(model.stages[1].equilibrium, 1e-6);
  EXPECT_FALSE(model.stages[2].paces_itself());
  EXPECT_EQ(model.stages[2].equilibrium, 0);
}

// The choice itself: step_choice_test.
TEST(Scene, DynamicStagesWithoutDtHaveItChosen) {
  const Model model =
      bar_with("", R"([{"duration": 0.01}, {"dt": "auto", "duration": 0.01}, {"dt": 1e-4, "duration": 0.01}])");
  for (const int i : {0, 1}) {
    const Stage& stage = model.stages[static_cast<std::size_t>(i)];
    EXPECT_GT(stage.dt, 0);
    EXPECT_FALSE(stage.chosen.dt.reason.empty());
  }
  EXPECT_EQ(model.stages[0].dt, model.stages[1].dt);
  EXPECT_EQ(model.stages[2].chosen.dt.reason, "");
}

// b = ratio/(pi f); and a/(2 w) + b w/2 = ratio at both.
TEST(Scene, DampingHasItsRatioAtItsFrequencies) {
  const auto stage_with = [](const std::string& damping) {
    return bar_with(R"("joints": {"default": {"bonded": true}})",
                    R"({"dt": 1, "duration": 5, "kinematics": "small", "damping": )" + damping + "}")
        .stages[0];
  };
  const Stage one = stage_with(R"({"ratio": "2 %", "frequency": "100 Hz"})");
  EXPECT_EQ(one.material_damping.mass, 0);
  EXPECT_NEAR(one.material_damping.stiffness, 0.02 / (100 * std::numbers::pi), 1e-17);
  const Stage two = stage_with(R"({"ratio": 0.05, "frequencies": [20, "0.2 kHz"]})");
  for (const double frequency : {20.0, 200.0}) EXPECT_NEAR(two.material_damping.ratio_at(frequency), 0.05, 1e-15);
  EXPECT_LT(two.material_damping.ratio_at(60), 0.05);
}

TEST(Scene, StagesAreReadInOrderWithTheirSettings) {
  const Model model = bar_with("", R"([{"dt": 1, "duration": 5, "integrator": "static", "solver": "pcg"},
    {"name": "go", "dt": 0.1, "duration": 2, "integrator": {"hht": 0.1}, "velocity_factor": "99 %", "damping_rate": "2 1/s",
     "strain_inertia": 2, "correct_time_dispersion": true, "correct_block_dispersion": true, "lateral_inertia": false, "max_open_close_iterations": 7, "max_step_reductions": 0, "solver": "dense"},
    {"dt": 1, "duration": 1, "integrator": {"generalized_alpha": 0.5}}])");
  ASSERT_EQ(model.stages.size(), 3U);
  EXPECT_EQ(model.stages[0].name, "stage 1");
  EXPECT_TRUE(model.stages[0].integrator.is_static);
  EXPECT_EQ(model.stages[0].solver, SolverRequest::pcg);
  const Stage& go = model.stages[1];
  EXPECT_EQ(go.name, "go");
  EXPECT_EQ(go.integrator.alpha_f, 0.1);
  EXPECT_EQ(go.velocity_factor, 0.99);
  EXPECT_EQ(go.damping_rate, 2);
  EXPECT_EQ(go.strain_inertia, 2);
  EXPECT_TRUE(go.correct_time_dispersion);
  EXPECT_TRUE(go.correct_block_dispersion);
  EXPECT_FALSE(go.lateral_inertia);
  EXPECT_EQ(go.limits.open_close_iterations, 7);
  EXPECT_EQ(go.limits.step_reductions, 0);
  EXPECT_EQ(go.solver, SolverRequest::dense);
  EXPECT_EQ(model.stages[2].integrator.alpha_f, generalized_alpha_integrator(0.5).alpha_f);
}

TEST(Scene, JointPairsBetweenGroupsMaterialsAndBlocks) {
  const Model model = parse_scene(R"({"dda": 1,
    "materials": {"hard": {"density": 1, "young": 1, "poisson": 0}, "soft": {"density": 1, "young": 1, "poisson": 0}},
    "joints": {"default": {}, "clay": {"cohesion": 5}, "fault": {"cohesion": 7}},
    "joint_pairs": [{"between": ["hard", "soft"], "joint": "clay"}, {"between": ["bar 2", "lid"], "joint": "fault"}],
    "blocks": [{"bar": {"length": 2, "height": 1, "block_length": 1, "material": "hard"}},
               {"polygon": {"name": "lid", "material": "soft", "vertices": [[0, 1], [2, 1], [2, 2], [0, 2]]}}],
    "steps": {"dt": 1, "duration": 1}})",
                                  "scene.json");
  EXPECT_EQ(model.joint_between(0, 1).name, "default");
  EXPECT_EQ(model.joint_between(0, 2).cohesion, 5);
  EXPECT_EQ(model.joint_between(2, 1).cohesion, 7);
}

TEST(Scene, ResidualStrengthAndDilationOfAJoint) {
  const JointMaterial rough = bar_with(R"("joints": {"default": {"friction_angle": "40 deg", "cohesion": "2 MPa",
      "residual_friction_angle": "30 deg", "residual_cohesion": "1 kPa", "dilation_angle": "6 deg",
      "zero_dilation_slip": "5 mm"}})")
                                  .joints[0];
  EXPECT_DOUBLE_EQ(*rough.residual_friction_angle, std::numbers::pi / 6);
  EXPECT_EQ(rough.residual_cohesion, 1e3);
  EXPECT_DOUBLE_EQ(rough.dilation_angle, std::numbers::pi / 30);
  EXPECT_EQ(rough.zero_dilation_slip, 5e-3);
  const JointMaterial plain = bar_with(R"("joints": {"default": {"friction_angle": "40 deg"}})").joints[0];
  EXPECT_FALSE(plain.residual_friction_angle);
  EXPECT_EQ(plain.dilation_angle, 0);
  EXPECT_TRUE(std::isinf(plain.zero_dilation_slip));
}

TEST(Scene, StiffnessPerAreaIsTheJointsOwnWhateverTheLaw) {
  const auto joint_with = [](const std::string& entries) {
    return bar_with(R"("joints": {"default": {)" + entries + "}}").joints[0];
  };
  const JointMaterial given = joint_with(R"("normal_stiffness": "20 GPa/m", "shear_stiffness": "8 MN/m3")");
  EXPECT_EQ(given.law, InterfaceLaw::projected);
  EXPECT_EQ(given.normal_stiffness, 20e9);
  EXPECT_EQ(given.shear_stiffness, 8e6);
  EXPECT_FALSE(given.automatic_stiffness);
  const JointMaterial chosen = joint_with(R"("normal_stiffness": "auto", "law": "consistent")");
  EXPECT_EQ(chosen.law, InterfaceLaw::consistent);
  EXPECT_EQ(chosen.normal_stiffness, 0);
  EXPECT_TRUE(chosen.automatic_stiffness);
}

TEST(Scene, JointLinesPartByPart) {
  const Model model = parse_scene(R"({"dda": 1, "materials": {"rock": {"density": 1, "young": 1, "poisson": 0}},
    "joints": {"default": {}, "fault": {"cohesion": 7}},
    "joint_lines": [{"points": [[0, 1], [2, 1], [2, 0]], "joint": "fault"}],
    "blocks": {"grid": {"columns": 3, "rows": 2, "block_width": 1, "block_height": 1}},
    "steps": {"dt": 1, "duration": 1}})",
                                  "scene.json");
  ASSERT_EQ(model.joint_lines.size(), 2U);
  EXPECT_EQ(model.joint_lines[0].from, Vec2(0, 1));
  EXPECT_EQ(model.joint_lines[0].to, Vec2(2, 1));
  EXPECT_EQ(model.joint_lines[1].to, Vec2(2, 0));
  EXPECT_EQ(model.joints[static_cast<std::size_t>(model.joint_lines[1].joint)].name, "fault");
}

TEST(Scene, TotalForceOnAnEdgeIsSpreadOverAllItsStretches) {
  const Model model = bar_with(R"("loads": [{"edge": "top", "force": ["8 kN", 0]}])");
  ASSERT_EQ(model.edge_loads.size(), 2U);
  Vec2 total = Vec2::Zero();
  for (const EdgeLoad& load : model.edge_loads) total += (load.to - load.from).norm() * load.traction;
  EXPECT_EQ(total, Vec2(8000, 0));
  EXPECT_EQ(model.edge_loads[0].traction, Vec2(2000, 0));
}

TEST(Scene, PressurePushesIntoTheBlock) {
  for (const auto& [edge, direction] : std::vector<std::pair<std::string, Vec2>>{
           {R"("left")", {1, 0}}, {R"("right")", {-1, 0}}, {R"("top")", {0, -1}}, {R"("bottom")", {0, 1}}}) {
    const Model model = bar_with(R"("loads": [{"edge": )" + edge + R"(, "pressure": "1 kPa"}])");
    EXPECT_EQ(model.edge_loads.at(0).traction, Vec2(1000 * direction)) << edge;
  }
}

TEST(Scene, PressureInAHolePushesOutwards) {
  const Model model = parse_scene(R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": {"polygon": {"vertices": [[0, 0], [3, 0], [3, 3], [0, 3]], "holes": [[[1, 1], [2, 1], [2, 2], [1, 2]]]}},
    "loads": [{"edge": {"from": [1, 1], "to": [2, 1]}, "pressure": 5}], "steps": {"dt": 1, "duration": 1}})",
                                  "scene.json");
  ASSERT_EQ(model.edge_loads.size(), 1U);
  EXPECT_EQ(model.edge_loads[0].traction, Vec2(0, -5));
}

TEST(Scene, EdgeIsCutToTheEndsOfItsLine) {
  const Model model = bar_with(R"("loads": [{"edge": {"from": [3, 1], "to": [0.5, 1]}, "traction": [0, -1]}])");
  ASSERT_EQ(model.edge_loads.size(), 2U);
  double length = 0;
  for (const EdgeLoad& load : model.edge_loads) length += (load.to - load.from).norm();
  EXPECT_DOUBLE_EQ(length, 2.5);
}

TEST(Scene, EdgeOnAJointTakesTheNamedSide) {
  const Model model =
      bar_with(R"("loads": [{"edge": {"from": [2, 0], "to": [2, 1]}, "block": "bar 2", "pressure": 1}])");
  ASSERT_EQ(model.edge_loads.size(), 1U);
  EXPECT_EQ(model.edge_loads[0].block, 1);
  EXPECT_EQ(model.edge_loads[0].traction, Vec2(1, 0));
}

TEST(Scene, Histories) {
  const auto history = [](const std::string& text) {
    return bar_with(R"("loads": [{"point": [0, 0], "force": [1, 0], "history": )" + text + "}]")
        .point_loads.at(0)
        .history;
  };
  const auto sine = std::get<SineCycles>(history(R"({"sine": {"frequency": "2 kHz", "cycles": 3, "start": "1 ms"}})"));
  EXPECT_EQ(sine.frequency, 2000);
  EXPECT_EQ(sine.cycles, 3);
  EXPECT_EQ(sine.start, 0.001);
  EXPECT_EQ(std::get<SineCycles>(history(R"({"sine": {"frequency": 1}})")).cycles,
            std::numeric_limits<double>::infinity());
  const auto table = std::get<PiecewiseLinear>(history(R"({"table": [[0, 0], ["5 ms", "50 %"]]})"));
  EXPECT_EQ(table.times, (std::vector<double>{0, 0.005}));
  EXPECT_EQ(table.values, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(std::get<ExponentialDecay>(history(R"({"decay": {"decay_time": "2 ms"}})")).decay_time, 0.002);
  EXPECT_EQ(std::get<ExponentialDecay>(history(R"({"decay": {"decay_time": "2 ms"}})")).rise, 0);
  const auto decay =
      std::get<ExponentialDecay>(history(R"({"decay": {"decay_time": 1, "rise": "20 us", "start": "2 s"}})"));
  EXPECT_EQ(decay.rise, 2e-5);
  EXPECT_EQ(decay.start, 2);
  const auto triangle =
      std::get<PiecewiseLinear>(history(R"({"triangle": {"rise": "1 s", "fall": "2 s", "start": "4 s"}})"));
  EXPECT_EQ(triangle.times, (std::vector<double>{4, 5, 7}));
  EXPECT_EQ(triangle.values, (std::vector<double>{0, 1, 0}));
}

TEST(Scene, EdgeSupportHoldsTheEndsOfEachStretch) {
  const Model model =
      bar_with(R"("supports": [{"edge": "bottom", "hold": "y", "stiffness": "6 GN/m"}, {"point": [0, 1]}])");
  ASSERT_EQ(model.supports.size(), 5U);
  EXPECT_EQ(model.supports[0].stiffness, 3e9);
  EXPECT_FALSE(model.supports[0].holds_x);
  EXPECT_EQ(model.supports[2].block, 1);
  EXPECT_EQ(model.supports[4].stiffness, 40e12);
  EXPECT_TRUE(model.supports[4].holds_x && model.supports[4].holds_y);
}

TEST(Scene, ViscousBoundariesMatchTheWavesOfTheirBlock) {
  const Model model = bar_with(R"("viscous_boundaries": [{"edge": "left"}, {"edge": "right", "normal_speed": "bar",
    "shear_impedance": "1 MPa s/m", "ratio": 0.5}, {"edge": "top", "normal_speed": "2 km/s"}])");
  const Material& rock = model.materials[0];
  EXPECT_DOUBLE_EQ(model.viscous_edges[0].normal_impedance, 2500 * p_wave_speed(rock));
  EXPECT_DOUBLE_EQ(model.viscous_edges[0].shear_impedance, 2500 * s_wave_speed(rock));
  EXPECT_DOUBLE_EQ(model.viscous_edges[1].normal_impedance, 1250 * bar_wave_speed(rock));
  EXPECT_DOUBLE_EQ(model.viscous_edges[1].shear_impedance, 0.5e6);
  EXPECT_DOUBLE_EQ(model.viscous_edges[3].normal_impedance, 5e6);
}

// The base stands out of the box' sides as well: it is what they stand on.
TEST(Scene, FreeFieldSidesFromBelow) {
  const std::string text = R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": [{"grid": {"columns": 2, "rows": 3, "block_width": 1, "block_height": 2}},
               {"polygon": {"name": "base", "vertices": [[0, -1], [2, -1], [2, 0], [0, 0]]}}],
    "fixed": ["base"],
    "viscous_boundaries": [{"edge": "top"}, {"edge": "right", "free_field": true},
                           {"edge": {"from": [0, 0], "to": [0, 4]}, "free_field": true, "from_stage": "wave"}],
    "steps": [{"dt": 1, "duration": 1}, {"name": "wave", "dt": 1, "duration": 1}]})";
  const Model model = parse_scene(text, "scene.json");
  ASSERT_EQ(model.free_field_sides.size(), 2U);
  EXPECT_EQ(model.free_field_sides[0].viscous_edges, (std::vector{2, 3, 4}));
  EXPECT_EQ(model.free_field_sides[0].outward, 1);
  EXPECT_EQ(model.free_field_sides[1].viscous_edges, (std::vector{5, 6}));
  EXPECT_EQ(model.free_field_sides[1].outward, -1);
  EXPECT_EQ(model.viscous_edges[4].block, 5);
  EXPECT_EQ(model.viscous_edges[6].block, 2);
  EXPECT_EQ(model.viscous_edges[6].first_stage, 1);
}

TEST(Scene, SupportsEndAndViscousBoundariesBeginWithAStage) {
  const std::string text = R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": {"bar": {"length": 2, "height": 1, "block_length": 1, "initial_stress": {"xx": -3, "yy": -2, "xy": 0.5}}},
    "supports": [{"edge": "left", "until_stage": "settle"}, {"edge": "right"},
                 {"point": [1, 1], "block": "bar 1", "until_stage": "settle", "release": true}],
    "viscous_boundaries": [{"edge": "left", "from_stage": "wave"}, {"edge": "top", "carries_initial_stress": true}],
    "steps": [{"name": "settle", "dt": 1, "duration": 1}, {"dt": 1, "duration": 1},
              {"name": "wave", "dt": 1, "duration": 1}]})";
  const Model model = parse_scene(text, "scene.json");
  ASSERT_EQ(model.supports.size(), 7U);  // three of each edge, one of the point
  const auto lasts = [&](std::size_t i) { return model.supports[i].last_stage; };
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(lasts(i), 0) << i;
  for (std::size_t i = 3; i < 6; ++i) EXPECT_EQ(lasts(i), -1) << i;
  EXPECT_EQ(lasts(6), 0);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(model.supports[i].takes_force_along, i == 6) << i;
  EXPECT_EQ(model.viscous_edges[0].first_stage, 2);
  EXPECT_EQ(model.viscous_edges[1].first_stage, 0);
  ASSERT_EQ(model.edge_loads.size(), 2U);
  EXPECT_EQ(model.edge_loads[1].block, 1);
  EXPECT_EQ(model.edge_loads[1].traction, Vec2(0.5, -2));
}

int measured_block(const std::string& place) {
  const std::string grid = R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": {"grid": {"columns": 2, "rows": 2, "block_width": 2, "block_height": 1}}, "steps": {"dt": 1, "duration": 1},
    "measurements": [{"quantity": "stress_xx", )";
  return parse_scene(grid + place + "}]}", "scene.json").measurements.at(0).block;
}

// Blocks 0 and 1 below, 2 and 3 above.
TEST(Scene, PointOnAJointIsMeasuredRightAndAboveUnlessSaidOtherwise) {
  EXPECT_EQ(measured_block(R"("point": [1, 0.5])"), 0);
  EXPECT_EQ(measured_block(R"("point": [2, 0.5])"), 1);
  EXPECT_EQ(measured_block(R"("point": [2, 0])"), 1);
  EXPECT_EQ(measured_block(R"("point": [1, 1])"), 2);
  EXPECT_EQ(measured_block(R"("point": [2, 1])"), 3);
  EXPECT_EQ(measured_block(R"("point": [2, 2])"), 3);
  EXPECT_EQ(measured_block(R"("point": [2, 0.5], "side": "left")"), 0);
  EXPECT_EQ(measured_block(R"("point": [1, 1], "side": "below")"), 0);
  EXPECT_EQ(measured_block(R"("point": [2, 1], "side": "left")"), 2);
  EXPECT_EQ(measured_block(R"("point": [2, 1], "side": "below")"), 1);
  EXPECT_EQ(measured_block(R"("point": [2, 1], "block": "grid 1.1")"), 0);
  EXPECT_EQ(measured_block(R"("block": "grid 2.1")"), 2);
}

TEST(Scene, MeasurementsAreNamedByTheirQuantityAndNumbered) {
  const Model model = bar_with(R"("measurements": [{"quantity": "rotation", "block": "bar 1"},
    {"quantity": "rotation", "block": "bar 2"}, {"name": "joint", "quantity": "traction_normal", "point": [2, 0.5]}])");
  EXPECT_EQ(model.measurements[0].name, "rotation");
  EXPECT_EQ(model.measurements[0].point, Vec2(1, 0.5));
  EXPECT_EQ(model.measurements[1].name, "rotation_2");
  EXPECT_EQ(model.measurements[2].name, "joint");
  EXPECT_EQ(model.measurements[2].block, 0);
  EXPECT_EQ(model.measurements[2].other_block, 1);
}

TEST(Scene, PolygonBlocksMayBeGivenEitherWayRound) {
  const Model model = parse_scene(R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}},
    "blocks": {"polygon": {"vertices": [[0, 0], [0, 2], [2, 2], [2, 0]], "initial_velocity": [1, 2],
      "initial_spin": "180 deg/s", "initial_stress": {"xx": "-1 MPa", "xy": 3}}}, "steps": {"dt": 1, "duration": 1}})",
                                  "scene.json");
  const Block& block = model.blocks.at(0);
  EXPECT_EQ(block.moments.area, 4);
  EXPECT_EQ(block.name, "block 1");
  EXPECT_EQ(block.initial_velocity, Vec2(1, 2));
  EXPECT_EQ(block.initial_spin, std::numbers::pi);
  EXPECT_EQ(block.initial_stress, Vec3(-1e6, 0, 3));
}

// Points and edges written with seven digits still find their block.
TEST(Scene, PlacesNeedNotBeExact) {
  const Model model = bar_with(R"("loads": [{"point": [-1e-7, 0.3333333], "force": [1, 0]},
    {"edge": {"from": [1.33333333, 1.0000001], "to": [4, 1]}, "traction": [1, 0]}])");
  EXPECT_EQ(model.point_loads.at(0).block, 0);
  EXPECT_EQ(model.edge_loads.size(), 2U);
}

}  // namespace
}  // namespace dda
