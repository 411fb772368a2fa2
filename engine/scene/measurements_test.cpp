// Measurements of forces, groups and contacts as scenes write them, and what is refused of them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

// Two rows of two blocks on a base that is held; "upper" and "lower" are groups.
std::string scene_with(const std::string& measurements) {
  return R"({"dda": 1,
  "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25},
                "soil": {"density": 2000, "young": "1 GPa", "poisson": 0.25}},
  "blocks": [{"polygon": {"name": "base", "material": "soil", "vertices": [[0, -1], [4, -1], [4, 0], [0, 0]]}},
             {"bar": {"name": "lower", "material": "rock", "length": 4, "height": 1, "block_length": 2}},
             {"bar": {"name": "upper", "material": "rock", "origin": [0, 1], "length": 4, "height": 1, "block_length": 2}}],
  "fixed": ["base"],
  "supports": [{"name": "props", "edge": "left", "block": "lower 1", "hold": "x"},
               {"name": "props", "point": [4, 1.5], "hold": "x"},
               {"name": "hook", "point": [4, 2]}],
  "measurements": [)" +
         measurements + R"(],
  "steps": {"dt": "1e-4 s", "duration": 0.01}})";
}

Measurement read_one(const std::string& measurement) {
  const Model model = parse_scene(scene_with(measurement), "scene.json");
  EXPECT_EQ(model.measurements.size(), 1U);
  return model.measurements.at(0);
}

using Indices = std::vector<int>;

TEST(Measurements, OfGroupsAreOfTheirBlocks) {
  EXPECT_EQ(read_one(R"({"quantity": "stress_1", "group": "upper"})").blocks, (Indices{3, 4}));
  EXPECT_EQ(read_one(R"({"quantity": "kinetic_energy", "group": "rock"})").blocks, (Indices{1, 2, 3, 4}));
  EXPECT_EQ(read_one(R"({"quantity": "rotation", "group": "lower 2"})").blocks, (Indices{2}));
}

TEST(Measurements, OfReactionsAreOfWhatIsNamed) {
  const Measurement all = read_one(R"({"quantity": "reaction"})");
  EXPECT_EQ(all.blocks, Indices{0});
  EXPECT_EQ(all.supports, (Indices{0, 1, 2, 3}));  // the edge is two springs
  EXPECT_EQ(all.about, Vec2(0, 0));
  const Measurement props = read_one(R"({"quantity": "reaction", "support": "props", "about": [1, "200 cm"]})");
  EXPECT_EQ(props.supports, (Indices{0, 1, 2}));
  EXPECT_TRUE(props.blocks.empty());
  EXPECT_EQ(props.about, Vec2(1, 2));
  EXPECT_EQ(read_one(R"({"quantity": "reaction", "block": "base"})").blocks, Indices{0});
}

TEST(Measurements, OfForcesHaveTwoSidesOrALine) {
  const Measurement between = read_one(R"({"quantity": "contact_force", "between": ["upper", "lower"]})");
  EXPECT_EQ(between.blocks, (Indices{3, 4}));
  EXPECT_EQ(between.others, (Indices{1, 2}));
  EXPECT_FALSE(between.on_line);
  const Measurement along = read_one(
      R"({"quantity": "contact_force", "between": ["upper", "lower"], "line": {"from": [0, 1], "to": [2, 1]}})");
  EXPECT_TRUE(along.on_line);
  EXPECT_EQ(along.to, Vec2(2, 1));
  const Measurement cut = read_one(R"({"quantity": "resultant", "line": {"from": [-1, 0.5], "to": [5, 1]}})");
  EXPECT_EQ(cut.from, Vec2(-1, 0.5));
  EXPECT_EQ(cut.about, Vec2(2, 0.75));
}

struct Refused {
  std::string measurement;
  std::vector<std::string> sentence;
};

TEST(Measurements, ThatCannotBeAreRefusedInASentence) {
  const std::vector<Refused> cases = {
      {R"({"quantity": "stress_1", "group": "uper"})", {"measurements[0].group is \"uper\"", "name of a material"}},
      {R"({"quantity": "stress_1", "group": "upper", "point": [1, 1]})", {"[0].point is [1,1]", "beside group"}},
      {R"({"quantity": "stress_1", "between": ["upper", "lower"]})", {"[0].between", "left out beside stress_1"}},
      {R"({"quantity": "contacts", "block": "base"})", {"[0].block is \"base\"", "left out beside contacts"}},
      {R"({"quantity": "traction_normal", "point": [1, 1], "group": "upper"})", {"left out beside traction_normal"}},
      {R"({"quantity": "reaction", "support": "prop"})", {"[0].support is \"prop\"", "an entry of supports"}},
      {R"({"quantity": "reaction", "block": "upper"})", {"[0].block is \"upper\"", "held as a whole", "\"upper 1\""}},
      {R"({"quantity": "reaction", "block": "base", "support": "hook"})", {"[0].support is \"hook\"", "beside block"}},
      {R"({"quantity": "contact_force"})", {"between", "missing"}},
      {R"({"quantity": "contact_force", "between": ["rock", "upper"]})",
       {"[0].between", "no block in common", "\"upper 1\""}},
      {R"({"quantity": "contact_force", "between": ["upper", "lower"], "line": {"from": [0, 0], "to": [2, 0]}})",
       {"[0].line", "both sides have edges"}},
      {R"({"quantity": "resultant", "line": {"from": [0, 1], "to": [0, 1]}})", {"[0].line", "two different points"}},
      {R"({"quantity": "resultant", "line": {"from": [0, 1]}})", {"[0].line", "to"}},
      {R"({"name": "a", "quantity": "reaction"}, {"name": "a_x", "quantity": "rotation", "block": "base"})",
       {"measurements[1].name is \"a_x\"", "no other measurement"}},
  };
  for (const Refused& each : cases) {
    try {
      parse_scene(scene_with(each.measurement), "bad.json");
      ADD_FAILURE() << "accepted: " << each.measurement;
    } catch (const InputError& error) {
      expect_sentence(error.what(), {"bad.json: ", ", expected "});
      expect_sentence(error.what(), each.sentence);
    }
  }
}

TEST(Measurements, OfReactionsNeedSomethingHeld) {
  std::string text = scene_with(R"({"quantity": "reaction"})");
  text.replace(text.find(R"("fixed": ["base"])"), 17, R"("fixed": [])");
  const std::size_t from = text.find(R"("supports")");
  text.erase(from, text.find(R"("measurements")") - from);
  try {
    parse_scene(text, "bad.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    expect_sentence(error.what(), {"measurements[0].quantity is \"reaction\"", "something that is held"});
  }
}

// Initial fields.

std::string scene_with_field(const std::string& field) {
  return R"({"dda": 1,
  "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25}},
  "blocks": [{"grid": {"origin": [0, -4], "columns": 4, "rows": 4, "block_width": 2, "block_height": 1,
                       "initial_stress": {"xx": -1, "yy": -2}}}],
  "initial_fields": [)" +
         field + R"(],
  "steps": {"dt": "1e-4 s", "duration": 0.01}})";
}

// A bilinear function comes back at every centroid, on any grid.
TEST(InitialFields, AreBilinearBetweenTheirPoints) {
  const auto f = [](double x, double y) { return 3 + 2 * x - 5 * y + 0.5 * x * y; };
  std::string rows;
  for (const double y : {-4.0, -2.2, -2.0, 0.0}) {
    std::string row;
    for (const double x : {0.0, 3.0, 9.0}) row += (row.empty() ? "" : ", ") + std::to_string(f(x, y));
    rows += (rows.empty() ? "[" : ", [") + row + "]";
  }
  for (const char* key : {"stress_xy", "velocity_y", "spin", "strain_rate_xx"}) {
    const Model model = parse_scene(scene_with_field(R"({"x": [0, 3, 9], "y": [-4, -2.2, -2, "0 m"], ")" +
                                                     std::string(key) + "\": [" + rows + "]}"),
                                    "scene.json");
    for (const Block& block : model.blocks) {
      const Vec2& c = block.moments.centroid;
      const std::string name = key;
      const double value = name == "stress_xy"    ? block.initial_stress(2)
                           : name == "velocity_y" ? block.initial_velocity.y()
                           : name == "spin"       ? block.initial_spin
                                                  : block.initial_strain_rate(0);
      EXPECT_NEAR(value, f(c.x(), c.y()), 1e-12 * 40) << key << " " << block.name;
      EXPECT_EQ(block.initial_stress(0), -1);
    }
  }
}

TEST(InitialFields, ReplaceWhatBlocksSayAndOneAnother) {
  const Model model = parse_scene(scene_with_field(R"({"x": [0], "y": [-4, 0], "stress_yy": [["-1 MPa"], [0]]},
      {"group": "grid 1.1", "x": [0], "y": [0], "stress_yy": [[7]], "strain_rate_xy": [["2 1/s"]]})"),
                                  "scene.json");
  EXPECT_EQ(model.blocks[0].initial_stress, Vec3(-1, 7, 0));
  EXPECT_EQ(model.blocks[0].initial_strain_rate, Vec3(0, 0, 2));
  EXPECT_NEAR(model.blocks[1].initial_stress(1), -1e6 * 3.5 / 4, 1e-9);
  EXPECT_NEAR(model.blocks[15].initial_stress(1), -1e6 * 0.5 / 4, 1e-9);
}

// Coordinates that a program computes differ from the blocks' centroids in the last digits.
TEST(InitialFields, MayHaveTheCentroidsThemselvesForAGrid) {
  const auto first_of = [](const std::string& x) {
    return parse_scene(scene_with_field(R"({"x": [)" + x + R"(, 7], "y": [0], "spin": [[3, 5]]})"), "scene.json")
        .blocks[0]
        .initial_spin;
  };
  EXPECT_EQ(first_of("1.0000000000000004"), 3);
  EXPECT_THROW(first_of("1.001"), InputError);
}

TEST(InitialFields, ThatCannotBeAreRefusedInASentence) {
  const std::vector<Refused> cases = {
      {R"({"x": [0], "y": [-3, 0], "spin": [[1], [1]]})", {"initial_fields[0] is a grid without block \"grid 1.1\""}},
      {R"({"x": [0, 0], "y": [0], "spin": [[1, 1]]})", {"initial_fields[0].x[1] is 0", "more than the one before"}},
      {R"({"x": [0, 9], "y": [0], "spin": [[1]]})", {"initial_fields[0].spin[0] is 1 values", "2 values of x"}},
      {R"({"x": [0], "y": [0], "spin": [[1], [1]]})", {"initial_fields[0].spin is 2 rows", "1 values of y"}},
      {R"({"x": [0], "y": [0], "spin": [["1 m/s"]]})", {"initial_fields[0].spin[0][0] is \"1 m/s\"", "rad/s"}},
      {R"({"x": [0], "y": [0]})", {"initial_fields[0] is without values"}},
      {R"({"group": "rok", "x": [0], "y": [0], "spin": [[1]]})", {"initial_fields[0].group is \"rok\""}},
  };
  for (const Refused& each : cases) {
    try {
      parse_scene(scene_with_field(each.measurement), "bad.json");
      ADD_FAILURE() << "accepted: " << each.measurement;
    } catch (const InputError& error) {
      expect_sentence(error.what(), {"bad.json: ", ", expected "});
      expect_sentence(error.what(), each.sentence);
    }
  }
}

}  // namespace
}  // namespace dda
