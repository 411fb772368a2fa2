// Stages that remove blocks, and the stress that the ground has before.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/scene/bad_scene_test_support.h"
#include "engine/scene/scene.h"
#include "engine/scene/scene_parts.h"

namespace dda {
namespace {

// Three rows of four blocks of 2 m x 1 m, the middle two of the second row in a group of their own.
std::string scene_with(const std::string& more, const std::string& second_stage) {
  return R"({
  "dda": 1, "gravity": 10,
  "materials": {"rock": {"density": 2500, "young": "20 GPa", "poisson": 0.25}},
  "joints": {"default": {"bonded": true}},
  "blocks": [{"grid": {"name": "floor", "columns": 4, "rows": 1, "block_width": 2, "block_height": 1}},
             {"polygon": {"name": "left", "vertices": [[0, 1], [2, 1], [2, 2], [0, 2]], "initial_stress": {"xx": 7}}},
             {"polygon": {"name": "a", "group": "hole", "vertices": [[2, 1], [4, 1], [4, 2], [2, 2]]}},
             {"polygon": {"name": "b", "group": "hole", "vertices": [[4, 1], [6, 1], [6, 2], [4, 2]]}},
             {"polygon": {"name": "right", "vertices": [[6, 1], [8, 1], [8, 2], [6, 2]]}}],
  "fixed": ["floor"])" +
         more + R"(,
  "steps": [{"name": "settle", "integrator": "static"}, {"name": "motion", "dt": 1e-4, "duration": 1e-2)" +
         second_stage + "}]}";
}

Model excavated(const std::string& removal) {
  return parse_scene(scene_with("", R"(, "remove": )" + removal), "scene");
}

TEST(RemovalInScenes, NamesBlocksAndGroups) {
  EXPECT_EQ(excavated(R"(["hole"])").stages[1].removal.blocks, (std::vector<int>{5, 6}));
  EXPECT_EQ(excavated(R"(["right", "a", "hole"])").stages[1].removal.blocks, (std::vector<int>{5, 6, 7}));
  EXPECT_FALSE(excavated(R"(["hole"])").stages[1].removal.relaxation);
}

TEST(RemovalInScenes, LetsGoOverATimeOrByATable) {
  const Model over = excavated(R"({"blocks": ["hole"], "over": "4 ms"})");
  ASSERT_TRUE(over.stages[1].removal.relaxation);
  EXPECT_DOUBLE_EQ(evaluate(*over.stages[1].removal.relaxation, 1e-3), 0.75);
  EXPECT_EQ(evaluate(*over.stages[1].removal.relaxation, 5e-3), 0);
  const Model table = excavated(R"({"blocks": ["hole"], "table": [[0, 1], ["2 ms", 0.3]]})");
  EXPECT_DOUBLE_EQ(evaluate(*table.stages[1].removal.relaxation, 1), 0.3);
}

// Time steps follow the ramp of a removal too: one that is far shorter than all else asks for shorter steps.
TEST(RemovalInScenes, LetsGoSlowlyInADynamicStageThatHasItsStepChosen) {
  const auto chosen = [](const std::string& removal) {
    std::string scene = scene_with("", R"(, "remove": )" + removal);
    scene.replace(scene.find(R"("dt": 1e-4, "duration": 1e-2)"), 28, R"("duration": 10)");
    return parse_scene(scene, "scene");
  };
  const Model slow = chosen(R"({"blocks": ["hole"], "over": "4 s"})");
  ASSERT_TRUE(slow.stages[1].removal.relaxation);
  EXPECT_DOUBLE_EQ(evaluate(*slow.stages[1].removal.relaxation, 1), 0.75);
  EXPECT_GT(slow.stages[1].dt, 0);
  const Model quick = chosen(R"({"blocks": ["hole"], "table": [[0, 1], ["1 ms", 0.5]]})");
  EXPECT_LT(quick.stages[1].dt, 0.1 * slow.stages[1].dt);
  EXPECT_LT(quick.stages[1].dt, 1e-3 / 4);
}

void expect_sentence_for(const std::string& text, const std::vector<std::string>& parts) {
  try {
    parse_scene(text, "bad.json");
    ADD_FAILURE() << "accepted: " << parts.front();
  } catch (const InputError& error) {
    expect_sentence(error.what(), {"bad.json: ", " is ", ", expected "});
    expect_sentence(error.what(), parts);
  }
}

TEST(RemovalInScenes, ThatCannotBeIsRefused) {
  const auto refused = [](const std::string& removal, const std::vector<std::string>& parts) {
    expect_sentence_for(scene_with("", R"(, "remove": )" + removal), parts);
  };
  refused(R"(["hale"])", {"steps[1].remove[0] is \"hale\"", "hole"});
  refused(R"([])", {"steps[1].remove"});
  refused(R"({"over": 1})", {"steps[1].remove", "blocks"});
  refused(R"({"blocks": ["hole"], "over": 1, "table": [[0, 1]]})", {"steps[1].remove.table", "beside over"});
  refused(R"({"blocks": ["hole"], "table": [[0, 0.5], [1, 0]]})", {"steps[1].remove.table", "1 at time 0"});
  for (const char* factor : {"2", "-1"})
    refused(R"({"blocks": ["hole"], "table": [[0, 1], [1, )" + std::string(factor) + "], [2, 0]]}",
            {"steps[1].remove.table[1] is [1," + std::string(factor) + "]", "a factor from 0 to 1"});
  refused(R"(["hole", "right", "hole"])", {"steps[1].remove[2] is \"hole\" a second time", "each name once"});
  refused(R"({"blocks": ["a", "a"], "over": 1e-3})", {"steps[1].remove.blocks[1] is \"a\" a second time"});
  refused(R"(["hole"]}, {"dt": 1e-4, "duration": 1e-2, "remove": ["hole"])",
          {"steps[2].remove[0] is \"hole\"", "no stage before removes"});
  refused(R"(["floor"])", {"\"motion\" remove", "which is held"});
  refused(R"(["hole"]}, {"dt": 1e-4, "duration": 1e-2, "remove": ["a"])",
          {"steps[2].remove[0]", "no stage before removes"});
  std::string first = scene_with("", "");
  first.replace(first.find(R"("integrator": "static")"), 22, R"("integrator": "static", "remove": ["hole"])");
  expect_sentence_for(first, {"steps[0].remove is given in the first stage"});
  std::string timeless = scene_with("", R"(}, {"integrator": "static", "remove": {"blocks": ["hole"], "over": 1})");
  expect_sentence_for(timeless, {"steps[2].remove.over", "take no time"});
}

// With a duration there is a time over which tractions fade: those at its end are what the stage settles under.
TEST(RemovalInScenes, MayLeaveAShareInAStaticStageThatFindsItsSteps) {
  const std::string stage =
      R"(}, {"integrator": "static", "duration": 1, "remove": {"blocks": ["hole"], "table": [[0, 1], [1, 0.3]]})";
  const Model model = parse_scene(scene_with("", stage), "fading.json");
  ASSERT_TRUE(model.stages.back().paces_itself());
  EXPECT_EQ(evaluate(*model.stages.back().removal.relaxation, 1), 0.3);
}

TEST(RemovalInScenes, OfWhatIsActedOnIsRefused) {
  const auto refused = [](const std::string& more, const std::string& part) {
    expect_sentence_for(scene_with(more, R"(, "remove": ["hole"])"), {"\"motion\" remove is \"a\"", part});
  };
  refused(R"(, "loads": [{"point": [3, 2], "force": [0, -1]}])", "a load acts");
  refused(R"(, "measurements": [{"quantity": "stress_xx", "block": "a", "name": "there"}])", "\"there\" is measured");
  refused(R"(, "supports": [{"point": [3, 2]}])", "a support holds");
  refused(R"(, "viscous_boundaries": [{"edge": {"from": [2.5, 2], "to": [3, 2]}}])", "viscous");
}

Model built(const std::string& addition) { return parse_scene(scene_with("", R"(, "add": )" + addition), "scene"); }

TEST(AdditionInScenes, NamesBlocksAndGroups) {
  const Model model = built(R"(["hole", "a"])");
  EXPECT_EQ(model.stages[1].rock.added, (std::vector<int>{5, 6}));
  const std::vector<bool> absent = model.absent_in(0);
  EXPECT_EQ(std::ranges::count(absent, true), 2);
  EXPECT_TRUE(absent[5] && absent[6]);
  EXPECT_TRUE(model.absent_in(1).empty());
}

TEST(AdditionInScenes, BringsNoStressAlong) {
  const Model model = parse_scene(scene_with(R"(, "stress_field": {"xx": "-1 kPa"})", R"(, "add": ["hole"])"), "scene");
  EXPECT_TRUE(model.blocks[5].initial_stress.isZero(0));
  EXPECT_EQ(model.blocks[0].initial_stress, Vec3(-1e3, 0, 0));
}

TEST(AdditionInScenes, FillsWhatWasRemoved) {
  const Model model = parse_scene(
      scene_with("", R"(, "remove": ["hole"]}, {"name": "fill", "dt": 1e-4, "duration": 1e-2, "add": ["a"])"), "scene");
  EXPECT_EQ(std::ranges::count(model.absent_in(1), true), 2);
  EXPECT_EQ(std::ranges::count(model.absent_in(2), true), 1);
}

TEST(AdditionInScenes, ThatCannotBeIsRefused) {
  const auto refused = [](const std::string& addition, const std::vector<std::string>& parts) {
    expect_sentence_for(scene_with("", addition), parts);
  };
  refused(R"(, "add": ["hale"])", {"steps[1].add[0] is \"hale\"", "hole"});
  refused(R"(, "add": [])", {"steps[1].add"});
  refused(R"(, "add": ["a", "a"])", {"steps[1].add[1] is \"a\" a second time"});
  refused(R"(, "add": ["floor"])", {"\"motion\" add", "which is held"});
  refused(R"(, "add": ["left"])", {"\"motion\" add", "a stress or a motion at the start"});
  refused(R"(, "add": ["a"], "remove": ["hole"])", {"steps[1].add[0]", "the stage does not remove"});
  refused(R"(, "add": ["a"]}, {"dt": 1e-4, "duration": 1e-2, "add": ["hole"])",
          {"steps[2].add[0]", "no stage before adds"});
  std::string first = scene_with("", "");
  first.replace(first.find(R"("integrator": "static")"), 22, R"("integrator": "static", "add": ["hole"])");
  expect_sentence_for(first, {"steps[0].add is given in the first stage"});
}

TEST(RockOfStages, BeyondWhatJointsCanHoldIsRefused) {
  const auto refused = [](const std::string& young, const std::vector<std::string>& parts) {
    expect_sentence_for(scene_with("", R"(, "materials": {"rock": {"young": )" + young + "}}"), parts);
  };
  refused("1e-300", {"steps[1].materials.rock.young", "at least 1e-09 times"});
  refused("\"100 GPa\"", {"steps[1].materials.rock.young", "5 times as stiff as at the start", "penalty"});
}

TEST(StressField, FillsBlocksThatStateNoStress) {
  const Model model = parse_scene(
      scene_with(R"(, "stress_field": {"xx": "-1 kPa", "surface": 3.5, "density": 2000, "k0": 0.5})", ""), "scene");
  // Row centres lie 3 m and 2 m deep: 20 kPa/m upright and half of it level.
  EXPECT_EQ(model.blocks[0].initial_stress, Vec3(-31e3, -60e3, 0));
  EXPECT_EQ(model.blocks[5].initial_stress, Vec3(-21e3, -40e3, 0));
  EXPECT_EQ(model.blocks[4].initial_stress, Vec3(7, 0, 0));
}

TEST(StressField, HasNoPressureAboveTheSurface) {
  const Model model =
      parse_scene(scene_with(R"(, "stress_field": {"surface": 1, "gradient": "1 kPa/m"})", ""), "scene");
  EXPECT_EQ(model.blocks[0].initial_stress, Vec3(-500, -500, 0));
  EXPECT_EQ(model.blocks[5].initial_stress, Vec3(0, 0, 0));
}

// Courses of two rocks; the upper course is 2 m high and its density is the material's.
std::string layered(const std::string& layers) {
  return R"({"dda": 1, "materials": {"light": {"density": 2000, "young": 1e10, "poisson": 0.2},
                                     "heavy": {"density": 3000, "young": 4e10, "poisson": 0.1}},
    "joints": {"default": {"friction_angle": "40 deg"}}, "gravity": 10,
    "blocks": [{"grid": {"name": "under", "columns": 4, "rows": 3, "block_width": 1, "block_height": 1, "material": "heavy"}},
               {"grid": {"name": "over", "origin": [0, 3], "columns": 3, "rows": 2, "block_width": 1.3333333333333333,
                         "block_height": 1, "material": "light"}}],
    "stress_field": {"yy": "-1 MPa", "xx": "-1 MPa", "surface": 9, "layers": )" +
         layers + R"(},
    "steps": {"dt": 1e-4, "duration": 1e-2}})";
}

constexpr const char* ground =
    R"([{"down_to": 5, "gradient": "1 kPa/m"}, {"down_to": 3, "material": "light", "k0": 0.6},
                                   {"material": "heavy", "k0": 1.4}])";

TEST(StressField, OfLayersAddsUpWhatLiesAbove) {
  const Model model = parse_scene(layered(ground), "scene");
  const auto expect_stress = [&](std::size_t block, double vertical, double k0) {
    const Vec3 expected = -Vec3(1e6, 1e6, 0) - vertical * Vec3(k0, 1, 0);
    EXPECT_LT((model.blocks[block].initial_stress - expected).norm(), 1e-9);
  };
  expect_stress(12, 4e3 + 1.5 * 20e3, 0.6);  // the lower row of the light rock
  expect_stress(15, 4e3 + 0.5 * 20e3, 0.6);
  expect_stress(0, 4e3 + 2 * 20e3 + 2.5 * 30e3, 1.4);  // the lowest of the heavy rock
}

TEST(StressField, OfLayersRefusesWhatIsNoGround) {
  const auto refused = [](const std::string& layers, const std::vector<std::string>& parts) {
    expect_sentence_for(layered(layers), parts);
  };
  refused(R"([{"material": "light"}, {"material": "heavy"}])", {"layers[0]", "down_to"});
  refused(R"([{"down_to": 9.5, "material": "light"}, {"material": "heavy"}])", {"layers[0].down_to", "below 9 m"});
  refused(R"([{"material": "granite"}])", {"layers[0].material", "granite", "a material of the scene"});
  refused(R"([{"material": "light", "density": 2000}])", {"layers[0].material", "beside density"});
  refused(R"([{"down_to": 3, "material": "light"}])", {"layers[0].down_to", "none in the last layer"});
  refused(R"([{"k0": 1}])", {"layers[0]", "without gradient and density"});
}

TEST(StressField, PushesOnEdges) {
  const Model model = parse_scene(scene_with(R"(, "stress_field": {"xy": 5, "surface": 3, "gradient": 1000, "k0": 0.5},
        "loads": [{"edge": "left", "traction": "in-situ"}, {"edge": "top", "traction": "in-situ"},
                  {"edge": "bottom", "traction": "in-situ"},
                  {"edge": {"from": [8, 0], "to": [8, 1]}, "traction": "in-situ"}],
        "viscous_boundaries": [{"edge": {"from": [8, 1], "to": [8, 2]}, "carries_initial_stress": true}])",
                                             ""),
                                  "scene");
  for (const EdgeLoad& load : model.edge_loads) {
    const Vec2 middle = (load.from + load.to) / 2;
    const double depth = 3 - middle.y();
    if (load.block == 4) continue;  // has a stress of its own
    Vec2 expected = Vec2::Zero();
    if (middle.y() == 2) expected = {5, -1000 * depth};
    if (middle.x() == 8) expected = {-500 * depth, 5};
    if (middle.x() == 0) expected = {500 * depth, -5};
    if (middle.y() == 0) expected = {-5, 1000 * depth};
    EXPECT_EQ(load.traction, expected);
  }
  EXPECT_EQ(model.edge_loads.size(), 2U + 4U + 4U + 1U + 1U);
  const EdgeLoad& absorbed = model.edge_loads.back();
  EXPECT_EQ(absorbed.traction, Vec2(-500 * 1.5, 5));
}

// A load of the stress in situ knew the section stress_field alone, and rock whose stress a table gave burst in
// silence.
TEST(StressField, PushesWithTheStressOfATableWhereOneGivesIt) {
  const Model model = parse_scene(scene_with(R"(, "stress_field": {"xx": 3, "yy": 5},
        "initial_fields": [{"x": [0], "y": [0], "stress_xx": [[-7]]}],
        "loads": [{"edge": "left", "traction": "in-situ"}, {"edge": "top", "traction": "in-situ"}],
        "viscous_boundaries": [{"edge": {"from": [8, 1], "to": [8, 2]}, "carries_initial_stress": true}])",
                                             ""),
                                  "scene");
  for (const EdgeLoad& load : model.edge_loads) {
    const double x = (load.from.x() + load.to.x()) / 2;
    if (load.block == 4) continue;
    if (x == 0 || x == 8) {
      EXPECT_EQ(load.traction, Vec2(x == 8 ? -7 : 7, 0));
    }
  }
  EXPECT_EQ(model.edge_loads.back().traction, Vec2(-7, 0));
}

// Both would add up, in silence.
TEST(StressField, IsRefusedOnAnEdgeThatCarriesItAlready) {
  const auto scene = [](const std::string& load, const std::string& boundary) {
    return scene_with(R"(, "stress_field": {"xx": -5}, "loads": [)" + load + R"(], "viscous_boundaries": [)" +
                          boundary + R"(, "carries_initial_stress": true}])",
                      "");
  };
  const std::string right = R"({"edge": {"from": [8, 1], "to": [8, 2]})";
  const std::string outside = R"({"edge": "outside", "traction": "in-situ"})";
  const std::string half =
      R"({"edge": "top", "pressure": 1}, {"edge": {"from": [8, 1.5], "to": [8, 2]}, "traction": "in-situ"})";
  const std::string is_true = "viscous_boundaries[0].carries_initial_stress is true along \"right\", on which loads";
  expect_sentence_for(scene(outside, right), {is_true + "[0] puts the traction in situ already", "one of the two"});
  expect_sentence_for(scene(half, right), {is_true + "[1]"});
  const std::string beside = R"({"edge": "left", "traction": "in-situ"}, {"edge": "right", "pressure": "1 kPa"})";
  EXPECT_EQ(parse_scene(scene(beside, right), "scene").edge_loads.size(), 2U + 2U + 1U);
}

// Removed blocks whose force fades act on the wall as it does: rock was loaded twice, in silence.
TEST(StressField, IsPutOnAWallByALoadOrByWhatFades) {
  const auto scene = [](const std::string& load, const std::string& fade) {
    return scene_with(
        R"(, "stress_field": {"xx": -5}, "loads": [{"edge": {"opening": "hole"}, "traction": "in-situ")" + load + "}]",
        R"(, "remove": {"blocks": ["hole"])" + fade + R"(}}, {"name": "after", "dt": 1e-4, "duration": 1e-2)");
  };
  const std::string at_once = R"(, "from_stage": "motion")", later = R"(, "from_stage": "after")";
  const std::string to_half = R"(, "table": [[0, 1], [1e-3, 0.5]])", over = R"(, "over": "10 ms")";
  const std::vector<std::string> sentence = {"loads[0].traction is \"in-situ\" along",
                                             "on which what stage \"motion\" removes still acts while it fades",
                                             "one of the two"};
  for (const std::string& load : {at_once, later}) expect_sentence_for(scene(load, to_half), sentence);
  expect_sentence_for(scene(at_once, over), sentence);
  EXPECT_NO_THROW(parse_scene(scene(later, over), "scene")) << "nothing is left of it when the load comes";
  EXPECT_NO_THROW(parse_scene(scene(at_once, ""), "scene"));
  EXPECT_NO_THROW(parse_scene(scene(at_once + R"(, "history": {"table": [[0, 0], [1, 1]]})", over), "scene"));
}

// A load with a history may take off what another puts on, and one may follow the other.
TEST(StressField, IsPutOnAnEdgeByOneLoadAtATime) {
  const auto scene = [](const std::string& stages_of_one, const std::string& stages_of_other) {
    return scene_with(R"(, "stress_field": {"xx": -5}, "loads": [{"edge": "outside", "traction": "in-situ")" +
                          stages_of_one + R"(}, {"edge": "left", "traction": "in-situ")" + stages_of_other + "}]",
                      "");
  };
  expect_sentence_for(
      scene("", ""),
      {"loads[1].traction is \"in-situ\" along \"floor 1.1\", on which loads[0] puts it already", "one of the two"});
  EXPECT_NO_THROW(parse_scene(scene("", R"(, "history": {"table": [[0, 0], [1, -1]]})"), "scene"));
  const std::string first = R"(, "until_stage": "settle")", second = R"(, "from_stage": "motion")";
  EXPECT_NO_THROW(parse_scene(scene(first, second), "scene"));
}

TEST(StressField, ThatSaysTooLittleOrTooMuchIsRefused) {
  const auto refused = [](const std::string& field, const std::vector<std::string>& parts) {
    expect_sentence_for(scene_with(R"(, "stress_field": )" + field, ""), parts);
  };
  refused(R"({})", {"stress_field"});
  refused(R"({"k0": 1})", {"stress_field.k0 is 1", "without surface"});
  refused(R"({"surface": 1})", {"stress_field is without gradient and density"});
  refused(R"({"surface": 1, "density": 2, "gradient": 3})", {"stress_field.density is 2", "beside gradient"});
  refused(R"({"surface": 1, "gradient": "3 Pa"})", {"stress_field.gradient is \"3 Pa\""});
  std::string level = scene_with(R"(, "stress_field": {"surface": 1, "density": 2000})", "");
  level.replace(level.find(R"("gravity": 10)"), 13, R"("gravity": 0)");
  expect_sentence_for(level, {"stress_field.density", "gradient instead"});
  expect_sentence_for(scene_with(R"(, "loads": [{"edge": "top", "traction": "insitu"}])", ""), {"loads[0].traction"});
}

// Four blocks of 1 m on top of each other, from y = 0 up.
std::vector<std::string> field_remarks(const std::string& field, const std::string& more = "") {
  return parse_scene_parts(
             R"({"dda": 1, "materials": {"m": {"density": 1, "young": 1, "poisson": 0}}, "blocks": [{"grid":
    {"name": "wall", "columns": 1, "rows": 4, "block_width": 1, "block_height": 1}}], "steps": {"dt": 1, "duration": 1}, )" +
                 more + R"("stress_field": )" + field + "}",
             "scene.json")
      .remarks;
}

TEST(StressFieldRemarks, OnASurfaceBelowAllBlocks) {
  for (const char* field :
       {R"({"surface": -300, "gradient": 1})", R"({"surface": 0.4, "layers": [{"gradient": 1}]})"}) {
    const std::vector<std::string> remarks = field_remarks(field);
    ASSERT_EQ(remarks.size(), 1U) << field;
    EXPECT_NE(remarks[0].find("lies below the middles of all blocks"), std::string::npos);
  }
}

TEST(StressFieldRemarks, OnNoOther) {
  EXPECT_TRUE(field_remarks(R"({"surface": 300, "gradient": 1})").empty());
  EXPECT_TRUE(field_remarks(R"({"surface": 0.6, "gradient": 1})").empty());  // a hill
  EXPECT_TRUE(field_remarks(R"({"xx": 1})").empty());
  const std::string of_their_own = R"("initial_fields": [{"x": [0], "y": [0, 4], "stress_yy": [[-1], [-1]]}], )";
  EXPECT_TRUE(field_remarks(R"({"surface": -300, "gradient": 1})", of_their_own).empty());
}

}  // namespace
}  // namespace dda
