// Linings of scenes: where they lie, and what is refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/segment.h"
#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

// A round opening in a plate that is cut in quarters.
std::string plate(const std::string& opening, const std::string& lining, const std::string& steps) {
  return R"({"dda": 1, "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25}},
    "joints": {"default": {"bonded": true}},
    "blocks": {"rock": {"boundary": [[-4, -4], [4, -4], [4, 4], [-4, 4]],
               "lines": [{"points": [[-4, 0.1], [4, 0.1]], "joint": "default"}, {"points": [[0.2, -4], [0.2, 4]], "joint": "default"}],
               "openings": [{"name": "tunnel", "circle": {"radius": 1}, )" +
         opening + R"(}]}},
    "linings": [{"thickness": "10 cm", "young": "20 GPa", )" +
         lining + R"(}], "steps": )" + steps + "}";
}

const std::string one_step = R"({"dt": 1e-4, "duration": 0.01})";
const std::string two_steps =
    R"([{"name": "before", "integrator": "static"}, {"name": "after", "remove": ["tunnel"], "dt": 1e-4, "duration": 0.01}])";

// Every node lies on the circle's chords with the rock on its left, and the chain runs around the hole clockwise.
void expect_around(const Lining& lining) {
  double turn = 0;
  for (std::size_t i = 0; i < lining.elements(); ++i) {
    const Vec2& point = lining.start_of(i).point;
    const Vec2& tangent = lining.start_of(i).tangent;
    EXPECT_NEAR(point.norm(), 1, 0.02);
    EXPECT_NEAR(cross(point.normalized(), tangent), -1, 0.03);
    turn += std::atan2(cross(point, lining.end_of(i).point), point.dot(lining.end_of(i).point));
  }
  EXPECT_NEAR(lining.closed ? turn : -2 * std::numbers::pi, -2 * std::numbers::pi, 1e-9);
}

Model model_of(const std::string& text) { return parse_scene(text, "scene.json"); }

TEST(Linings, GoAroundAnOpening) {
  const Model open = model_of(plate(R"("left_out": true)", R"("opening": "tunnel")", one_step));
  const Model cavity = model_of(plate(R"("left_out": true)", R"("cavity": [0.3, 0.2])", one_step));
  const Model removed =
      model_of(plate(R"("left_out": false)", R"("opening": "tunnel", "from_stage": "after")", two_steps));
  for (const Model& model : {open, cavity, removed}) {
    ASSERT_EQ(model.linings.size(), 1U);
    const Lining& lining = model.linings[0];
    EXPECT_EQ(lining.name, "lining 1");
    EXPECT_TRUE(lining.closed);
    EXPECT_EQ(lining.thickness, 0.1);
    EXPECT_EQ(lining.poisson, 0.2);
    EXPECT_FALSE(lining.yields());
    EXPECT_EQ(lining.nodes.size(), open.linings[0].nodes.size());
    expect_around(lining);
  }
  EXPECT_EQ(removed.linings[0].first_stage, 1);
}

TEST(Linings, LeaveOutTheFloor) {
  const Model model = model_of(plate(
      R"("left_out": true)", R"("opening": "tunnel", "above": -0.5, "compressive_strength": "20 MPa")", one_step));
  const Lining& lining = model.linings[0];
  EXPECT_FALSE(lining.closed);
  EXPECT_TRUE(lining.yields());
  EXPECT_EQ(lining.tensile_strength, 0);
  for (const LiningNode& node : lining.nodes) EXPECT_GT(node.point.y(), -0.5);
  EXPECT_LT(lining.nodes.front().point.x(), 0) << "clockwise, as the rock on its left has it";
  EXPECT_GT(lining.nodes.back().point.x(), 0);
  expect_around(lining);
}

TEST(Linings, RunAlongALine) {
  for (const char* along : {R"("along": [[0, 1], [4, 1]])", R"("along": [[4, 1], [0, 1]])"}) {
    std::string text = good_text;
    text.replace(
        text.find(R"("steps":)"), 8,
        std::string(R"("linings": [{"name": "deck", "thickness": 0.1, "young": 2e10, )") + along + R"(}], "steps":)");
    const Model model = model_of(text);
    const Lining& lining = model.linings[0];
    ASSERT_EQ(lining.nodes.size(), 2U);
    EXPECT_EQ(lining.nodes[0].block, 1) << "the rock below it is on the left of a way to the left";
    EXPECT_EQ(lining.nodes[0].point, Vec2(3, 1));
    EXPECT_EQ(lining.nodes[0].tangent, Vec2(-1, 0));
    EXPECT_EQ(lining.nodes[1].point, Vec2(1, 1));
  }
}

class BadLining : public testing::TestWithParam<Spoiled> {};
TEST_P(BadLining, IsRefusedInOneSentence) { expect_refusal(GetParam()); }

Spoiled spoiled(const std::string& what, const std::string& lining, const std::vector<std::string>& sentence) {
  return {what, R"("steps":)", R"("linings": [{)" + lining + R"(}], "steps":)", sentence};
}

const std::string concrete = R"("thickness": 0.1, "young": 2e10, )";
const std::string deck = R"("along": [[0, 1], [4, 1]])";

const std::vector<Spoiled> spoilt = {
    spoiled("no place", R"("thickness": 0.1, "young": 2e10)", {"linings[0]", "without a place"}),
    spoiled("two places", concrete + R"("cavity": [1, 1], )" + deck, {"linings[0]", "at several places"}),
    spoiled("no thickness", R"("young": 2e10, )" + deck, {"linings[0].thickness", "missing"}),
    spoiled("thickness 0", R"("thickness": 0, "young": 2e10, )" + deck, {"linings[0].thickness"}),
    spoiled("thickness in Pa", R"("thickness": "1 Pa", "young": 2e10, )" + deck, {"linings[0].thickness", "1 Pa"}),
    spoiled("young below 0", R"("thickness": 0.1, "young": -1, )" + deck, {"linings[0].young"}),
    spoiled("poisson 0.5", concrete + R"("poisson": 0.5, )" + deck,
            {"linings[0].poisson is 0.5, expected 0 or more and below 0.5 (default 0.2)"}),
    spoiled("poisson 0.6", concrete + R"("poisson": 0.6, )" + deck, {"linings[0].poisson is 0.6, expected 0 or more"}),
    spoiled("unknown stage", concrete + R"("from_stage": "later", )" + deck,
            {"linings[0].from_stage is \"later\"", "\"run\""}),
    spoiled("unknown key", concrete + R"("thicknes": 1, )" + deck, {"linings[0]", "thicknes"}),
    spoiled("tension alone", concrete + R"("tensile_strength": 1e6, )" + deck,
            {"linings[0].tensile_strength", "without compressive_strength"}),
    spoiled("strength 0", concrete + R"("compressive_strength": 0, )" + deck, {"linings[0].compressive_strength"}),
    spoiled("unknown opening", concrete + R"("opening": "tunel")", {"linings[0].opening is \"tunel\""}),
    spoiled("in rock", concrete + R"("cavity": [1, 0.5])", {"linings[0].cavity", "an opening with blocks all around"}),
    spoiled("above of a line", concrete + R"("above": 1, )" + deck, {"linings[0].above", "beside along"}),
    spoiled("closed opening", concrete + R"("closed": true, "cavity": [1, 0.5])",
            {"linings[0].closed", "without along"}),
    spoiled("a point twice", concrete + R"("along": [[0, 1], [0, 1]])", {"linings[0].along", "twice"}),
    spoiled("there and back", concrete + R"("along": [[0, 1], [4, 1], [0, 1]])", {"linings[0].along"}),
    {"measured far from it",
     R"("quantity": "stress_xx", "point": [2, 0.5]}],)",
     R"("quantity": "lining_thrust", "lining": "lining 1", "point": [2, 99]}], "linings": [{)" + concrete + deck +
         "}],",
     {"measurements[0].point is (2, 99) m, 98 m away from lining \"lining 1\"",
      "no further off than its longest piece, 2 m"}},
    spoiled("through air", concrete + R"("along": [[0, 1], [5, 1]])", {"linings[0].along", "past no block at [4, 1]"}),
    spoiled("in a joint", concrete + R"("along": [[2, 0], [2, 1]])", {"linings[0].along", "along a joint"}),
    spoiled("one face", concrete + R"("along": [[0, 1], [2, 1]])", {"linings[0]", "along 1 face of blocks"}),
    spoiled("a name twice", concrete + R"("name": "a", )" + deck + R"(}, {"name": "a", )" + concrete + deck,
            {"linings[1].name", "no other lining"}),
    {"measured without a lining",
     R"("quantity": "stress_xx", "point": [2, 0.5])",
     R"("quantity": "lining_thrust", "lining": "a")",
     {"measurements[0].lining", "there is none"}},
    {"explicit",
     R"("steps": {)",
     R"("linings": [{)" + concrete + deck +
         R"(}], "steps": {"integrator": "central_difference", "kinematics": "small", )",
     {"with linings"}}};

INSTANTIATE_TEST_SUITE_P(Scene, BadLining, testing::ValuesIn(spoilt));

TEST(Linings, BelowIsStillThere) {
  try {
    parse_scene(plate(R"("left_out": false)", R"("opening": "tunnel", "from_stage": "before")", two_steps), "bad.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    expect_sentence(error.what(), {"linings[0].opening is \"tunnel\"", "without blocks inside once"});
  }
}

// Five by three squares, of which some of the middle row are removed.
std::string two_tunnels(const std::string& lining, const std::string& between) {
  std::string blocks;
  for (int i = 0; i < 15; ++i) {
    const int x = i % 5, y = i / 5;
    const std::string group = y == 1 && (x == 1 || x == 3) ? "tunnel" : x == 2 && y == 1 ? between : "rock";
    blocks += (i > 0 ? ", " : "") + fmt::format(R"({{"polygon": {{"name": "b{}", "group": "{}",
      "vertices": [[{}, {}], [{}, {}], [{}, {}], [{}, {}]]}}}})",
                                                i, group, x, y, x + 1, y, x + 1, y + 1, x, y + 1);
  }
  return R"({"dda": 1, "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25}},
    "joints": {"default": {"bonded": true}}, "supports": [{"edge": "bottom"}], "linings": [{"thickness": 0.01,
    "young": 2e10, "from_stage": "after", )" +
         lining + R"(}], "blocks": [)" + blocks + "], \"steps\": " + two_steps + "}";
}

// The wall of the first of two tunnels was lined, and it was said that all of it was.
TEST(Linings, OfAGroupInTwoPlacesAreRefused) {
  try {
    parse_scene(two_tunnels(R"("opening": "tunnel")", "rock"), "bad.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    expect_sentence(error.what(),
                    {"linings[0].opening is \"tunnel\", whose blocks lie in 2 places, at \"b6\" and \"b8\"",
                     "a lining for each place"});
  }
  EXPECT_EQ(model_of(two_tunnels(R"("opening": "tunnel")", "tunnel")).linings[0].nodes.size(), 8U);
  EXPECT_EQ(model_of(two_tunnels(R"("cavity": [1.5, 1.5])", "rock")).linings[0].nodes.size(), 4U);
  std::string first_alone = two_tunnels(R"("opening": "tunnel")", "rock");
  first_alone.replace(first_alone.find(R"("remove": ["tunnel"])"), 20, R"("remove": ["b6"])");
  EXPECT_EQ(model_of(first_alone).linings[0].nodes.size(), 4U) << "the other place is not open yet";
}

// The beam was there twice, with twice the stiffness.
TEST(Linings, ThatGoAroundTwiceAreRefused) {
  const std::string once = "[1, 1], [2, 1], [2, 2], [1, 2]";
  const auto along = [](const std::string& points, const std::string& closed) {
    return two_tunnels(R"("along": [)" + points + R"(], "closed": )" + closed, "rock");
  };
  EXPECT_EQ(model_of(along(once, "true")).linings[0].nodes.size(), 4U);
  EXPECT_EQ(model_of(along(once + ", [1, 1]", "false")).linings[0].nodes.size(), 4U);
  for (const char* closed : {"true", "false"}) try {
      parse_scene(along(once + ", " + once, closed), "bad.json");
      FAIL() << "accepted";
    } catch (const InputError& error) {
      expect_sentence(error.what(), {"linings[0].along is past the face of \"b",
                                     "] twice, expected a line that passes each face once"});
    }
}

TEST(Linings, KeepTheirBlocks) {
  const std::string text = plate(R"("left_out": true)", R"("opening": "tunnel", "name": "shotcrete")",
                                 R"([{"name": "before", "dt": 1e-4, "duration": 0.01},
                                     {"name": "after", "remove": ["rock 1"], "dt": 1e-4, "duration": 0.01}])");
  try {
    parse_scene(text, "bad.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    expect_sentence(error.what(), {"on which \"shotcrete\" is sprayed"});
  }
}

}  // namespace
}  // namespace dda
