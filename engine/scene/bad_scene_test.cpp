// Every way to get a scene wrong gives one sentence that names file, field and value.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "dda/core/error.h"
#include "dda/scene/scene.h"

namespace dda {
namespace {

constexpr const char* good_text = R"({
  "dda": 1,
  "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25}},
  "joints": {"default": {"bonded": true}},
  "blocks": [{"bar": {"length": 4, "height": 1, "block_length": 2}}],
  "loads": [{"point": [0, 0.5], "force": [1e3, 0], "history": {"sine": {"frequency": "100 Hz"}}}],
  "supports": [{"edge": "right"}],
  "viscous_boundaries": [{"edge": "left"}],
  "measurements": [{"quantity": "stress_xx", "point": [2, 0.5]}],
  "steps": {"dt": "1e-4 s", "duration": 0.01}
})";

// The good scene with the first occurrence of `from` replaced.
struct Spoiled {
  std::string what;
  std::string from;
  std::string to;
  std::vector<std::string> sentence;  // what it must contain besides the file
};

void PrintTo(const Spoiled& spoiled, std::ostream* out) { *out << spoiled.what; }

std::string spoiled_text(const Spoiled& spoiled) {
  std::string text = good_text;
  const std::size_t at = text.find(spoiled.from);
  EXPECT_NE(at, std::string::npos) << spoiled.from;
  return text.replace(at, spoiled.from.size(), spoiled.to);
}

void expect_sentence(const std::string& sentence, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(sentence.find(part), std::string::npos) << "no \"" << part << "\" in: " << sentence;
  }
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  EXPECT_LT(sentence.size(), 500U) << sentence;
}

class BadScene : public testing::TestWithParam<Spoiled> {};

TEST(GoodScene, OfThisTableIsAccepted) { EXPECT_NO_THROW(parse_scene(good_text, "good.json")); }

TEST_P(BadScene, NamesFileFieldAndValue) {
  try {
    parse_scene(spoiled_text(GetParam()), "bad.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    expect_sentence(error.what(), {"bad.json: ", " is ", ", expected "});
    expect_sentence(error.what(), GetParam().sentence);
  }
}

const std::vector<Spoiled> syntax = {
    {"empty", good_text, "", {"the scene is empty"}},
    {"blank", good_text, " \n\t ", {"the scene is empty"}},
    {"cut short",
     R"("steps": {"dt": "1e-4 s", "duration": 0.01}
})",
     R"("steps": {"dt")",
     {"steps.dt (line 10, column ", "cut short"}},
    {"cut inside text", good_text, R"({"dda": 1, "title": "ro)", {"title (line 1, column 24)"}},
    {"no JSON", good_text, "bar length 100", {"the scene (line 1, column", "bar"}},
    {"a list", good_text, "[]", {"the scene is []", "an object"}},
    {"a number", good_text, "1", {"the scene is 1", "an object"}},
    {"a comma too many",
     R"("poisson": 0.25})",
     R"("poisson": 0.25,})",
     {"materials.rock.poisson (line 3, column 78)", "}"}},
    {"NaN", "2650", "NaN", {"materials.rock.density (line 3", "NaN", "a finite number"}},
    {"minus infinity", "2650", "-Infinity", {"materials.rock.density (line 3", "-Infinity", "a finite number"}},
    {"beyond double", "2650", "1e400", {"materials.rock.density", "1e400", "a finite number"}},
    {"key twice", R"("poisson": 0.25)", R"("poisson": 0.25, "density": 1)", {"materials.rock.density is given twice"}},
    {"key twice in a list",
     R"({"edge": "right"})",
     R"({"edge": "right"}, {"edge": "left", "edge": "top"})",
     {"supports[1].edge is given twice"}},
    {"no UTF-8", "rock", "r\xffk", {"materials (line 3", "UTF-8"}},
    {"nested deeply", "2650", std::string(100, '['), {"materials.rock.density[0]", "nested too deep"}},
    {"comment", R"("dda": 1)", R"("dda": 1 // first)", {"dda (line 2, column 12)", "//"}},
};

const std::vector<Spoiled> shape = {
    {"version", R"("dda": 1)", R"("dda": 2)", {"dda is 2", "expected 1"}},
    {"no version", R"("dda": 1,)", "", {"dda is missing", "version"}},
    {"no blocks", R"("blocks": [{"bar": {"length": 4, "height": 1, "block_length": 2}}],)", "", {"blocks is missing"}},
    {"no materials", R"({"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25}})", "{}", {"materials is {}"}},
    {"misspelt section", R"("materials")", R"("matreials")", {"matreials is no key", "\"materials\""}},
    {"misspelt key", R"("young")", R"("yuong")", {"materials.rock.yuong is no key", "\"young\""}},
    {"unknown key", R"("bonded": true)", R"("glue": true)", {"joints.default.glue is no key", "bonded"}},
    {"unknown key in an entry",
     R"("block_length": 2)",
     R"("block_length": 2, "blocks": 2)",
     {"blocks[0].bar.blocks", "block_length"}},
    {"unknown key of a stage", R"("duration": 0.01)", R"("duration": 0.01, "damping": 1)", {"steps.damping is no key"}},
    {"missing density", R"("density": 2650, )", "", {"materials.rock.density is missing", "kg/m3"}},
    {"missing dt", R"("dt": "1e-4 s", )", "", {"steps.dt is missing", "time step"}},
    {"missing frequency", R"("frequency": "100 Hz")", "", {"loads[0].history.sine.frequency is missing"}},
    {"two kinds of block",
     R"("block_length": 2}})",
     R"("block_length": 2}, "polygon": {"vertices": [[0,0],[1,0],[0,1]]}})",
     {"blocks[0]", "exactly 1 key"}},
    {"no kind of block",
     R"({"bar": {"length": 4, "height": 1, "block_length": 2}})",
     "{}",
     {"blocks[0] is {}", "exactly 1 key"}},
    {"unknown kind of block", R"({"bar": )", R"({"bat": )", {"blocks[0].bat", "\"bar\""}},
    {"no entries", R"([{"bar": {"length": 4, "height": 1, "block_length": 2}}])", "[]", {"blocks is []", "at least 1"}},
    {"truth as number", "2650", "true", {"materials.rock.density is true", "a number or text", "density"}},
    {"number as truth", R"("bonded": true)", R"("bonded": 1)", {"joints.default.bonded is 1", "true or false"}},
    {"null", "2650", "null", {"materials.rock.density is null", "a number or text"}},
    {"three coordinates", "[0, 0.5]", "[0, 0.5, 0]", {"loads[0].point is [0,0.5,0]", "exactly 2"}},
    {"vector as number", "[1e3, 0]", "1e3", {"loads[0].force is 1000", "an array"}},
    {"coordinate of no kind", "[1e3, 0]", "[1e3, {}]", {"loads[0].force[1] is {}", "a number"}},
    {"point and edge",
     R"({"edge": "right"})",
     R"({"edge": "right", "point": [4, 0]})",
     {"supports[0]", "2 of point and edge", "exactly one"}},
    {"neither point nor edge", R"({"edge": "right"})", R"({"hold": "x"})", {"supports[0]", "0 of point and edge"}},
    {"unknown side",
     R"({"edge": "right"})",
     R"({"edge": "rigth"})",
     {"supports[0].edge is \"rigth\"", "\"left\", \"right\""}},
    {"half a line", R"({"edge": "right"})", R"({"edge": {"from": [4, 0]}})", {"supports[0].edge.to is missing"}},
    {"unknown law",
     R"("bonded": true)",
     R"("law": "clasical")",
     {"joints.default.law is \"clasical\"", "perhaps \"classical\""}},
    {"unknown quantity",
     "stress_xx",
     "sress_xx",
     {"measurements[0].quantity is \"sress_xx\"", "perhaps \"stress_xx\""}},
    {"unknown scheme", R"("dda": 1)", R"("dda": 1, "scheme": "exact")", {"scheme is \"exact\"", "accurate or thesis"}},
    {"unknown integrator",
     R"("duration": 0.01)",
     R"("duration": 0.01, "integrator": "newmark")",
     {"steps.integrator is \"newmark\"", "hht"}},
    {"two integrators",
     R"("duration": 0.01)",
     R"("duration": 0.01, "integrator": {"hht": 0, "generalized_alpha": 1})",
     {"steps.integrator", "exactly 1 key"}},
    {"fractional count",
     R"("duration": 0.01)",
     R"("duration": 0.01, "max_step_reductions": 1.5)",
     {"steps.max_step_reductions is 1.5", "a whole number"}},
    {"histories", R"({"sine": {"frequency": "100 Hz"}})", R"({"saw": 1})", {"loads[0].history.saw", "sine"}},
    {"empty table",
     R"({"sine": {"frequency": "100 Hz"}})",
     R"({"table": []})",
     {"loads[0].history.table is []", "at least 1"}},
    {"two vertices",
     R"({"bar": {"length": 4, "height": 1, "block_length": 2}})",
     R"({"polygon": {"vertices": [[0,0],[1,0]]}})",
     {"blocks[0].polygon.vertices", "at least 3"}},
    {"empty name",
     R"("block_length": 2)",
     R"("block_length": 2, "name": "")",
     {"blocks[0].bar.name is \"\"", "at least 1"}},
};

const std::vector<Spoiled> values = {
    {"negative density", "2650", "-2650", {"materials.rock.density is -2650", "above 0"}},
    {"negative density with unit",
     "2650",
     R"("-2650 kg/m3")",
     {"materials.rock.density is \"-2650 kg/m3\"", "positive"}},
    {"zero young", R"("50 GPa")", "0", {"materials.rock.young is 0", "above 0"}},
    {"unknown unit", "50 GPa", "50 GPA", {"materials.rock.young is \"50 GPA\"", "GPa"}},
    {"wrong dimension", "50 GPa", "50 kg", {"materials.rock.young is \"50 kg\"", "stress"}},
    {"no unit in text", "50 GPa", "50", {"materials.rock.young is \"50\"", "stress"}},
    {"no number in text", "50 GPa", "stiff", {"materials.rock.young is \"stiff\"", "number"}},
    {"NaN in text", "50 GPa", "nan Pa", {"materials.rock.young is \"nan Pa\"", "finite"}},
    {"two numbers", "50 GPa", "5 0 GPa", {"materials.rock.young is \"5 0 GPa\""}},
    {"poisson", "0.25", "0.51", {"materials.rock.poisson is 0.51", "at most 0.5"}},
    {"poisson in plane strain",
     R"("poisson": 0.25)",
     R"("poisson": 0.5, "plane": "strain")",
     {"materials.rock.poisson is 0.5", "plane strain"}},
    {"degrees without unit",
     R"("bonded": true)",
     R"("friction_angle": 35)",
     {"joints.default.friction_angle is 35", "35 deg"}},
    {"right angle",
     R"("bonded": true)",
     R"("friction_angle": "90 deg")",
     {"joints.default.friction_angle is \"90 deg\"", "below 90"}},
    {"negative cohesion",
     R"("bonded": true)",
     R"("cohesion": "-1 MPa")",
     {"joints.default.cohesion is \"-1 MPa\"", "zero or more"}},
    {"unstable penalty", R"("bonded": true)", R"("penalty": 1)", {"joints.default.penalty is 1", "above 1"}},
    {"two springs",
     R"("bonded": true)",
     R"("normal_spring": 1e9, "spring_over_young": 10)",
     {"joints.default.spring_over_young is 10", "left out"}},
    {"penalty of springs",
     R"("bonded": true)",
     R"("law": "classical", "penalty": 4)",
     {"joints.default.penalty is 4", "classical"}},
    {"joint of no pair",
     R"("default": {"bonded": true})",
     R"("fault": {"bonded": true})",
     {"joints.fault is in no entry of joint_pairs"}},
    {"unknown joint",
     R"("blocks")",
     R"("joint_pairs": [{"between": ["bar", "bar"], "joint": "defualt"}], "blocks")",
     {"joint_pairs[0].joint is \"defualt\"", "expected \"default\""}},
    {"unknown group",
     R"("blocks")",
     R"("joint_pairs": [{"between": ["bar", "wall"], "joint": "default"}], "blocks")",
     {"joint_pairs[0].between[1] is \"wall\""}},
    {"fraction of a block",
     R"("block_length": 2)",
     R"("block_length": 1.5)",
     {"blocks[0].bar.block_length is 1.5 m", "whole number of blocks"}},
    {"block longer than bar",
     R"("block_length": 2)",
     R"("block_length": 8)",
     {"blocks[0].bar.block_length is 8 m", "0.5"}},
    {"too many blocks",
     R"("block_length": 2)",
     R"("block_length": "1 nm")",
     {"blocks[0].bar.block_length is \"1 nm\""}},
    {"far too many blocks",
     R"("block_length": 2)",
     R"("block_length": 1e-9)",
     {"blocks[0].bar.block_length is asking for 4e+09", "at most"}},
    {"no height", R"("height": 1)", R"("height": 0)", {"blocks[0].bar.height is 0", "above 0"}},
    {"unknown material",
     R"("block_length": 2)",
     R"("block_length": 2, "material": "rok")",
     {"blocks[0].bar.material is \"rok\"", "expected \"rock\""}},
    {"which material",
     R"({"rock": )",
     R"({"soil": {"density": 1800, "young": 1e8, "poisson": 0.3}, "rock": )",
     {"blocks[0].bar.material is missing", "several"}},
    {"name in a table",
     R"("block_length": 2)",
     R"("block_length": 2, "name": "a,b")",
     {"blocks[0].bar.name is \"a,b\"", "commas"}},
    {"same names",
     R"("block_length": 2}})",
     R"("block_length": 2}}, {"bar": {"origin": [9, 0], "length": 4, "height": 1, "block_length": 2}})",
     {"blocks \"bar 1\" name is \"bar 1\"", "no other"}},
    {"overlap",
     R"("block_length": 2}})",
     R"("block_length": 2}}, {"polygon": {"vertices": [[3.5,0.5],[5,0.5],[5,2]]}})",
     {"blocks \"block 3\"", "overlapping \"bar 2\""}},
    {"same block twice",
     R"("block_length": 2}})",
     R"("block_length": 2}}, {"bar": {"length": 4, "height": 1, "block_length": 2, "name": "b"}})",
     {"blocks \"b 1\"", "overlapping \"bar 1\""}},
    {"no area",
     R"({"bar": {"length": 4, "height": 1, "block_length": 2}})",
     R"({"polygon": {"vertices": [[0,0],[1,1],[2,2]]}})",
     {"blocks[0].polygon is degenerate"}},
    {"crossing itself",
     R"({"bar": {"length": 4, "height": 1, "block_length": 2}})",
     R"({"polygon": {"vertices": [[0,0],[4,1],[4,0],[0,1]]}})",
     {"blocks[0].polygon is self-intersecting"}},
    {"hole outside",
     R"({"bar": {"length": 4, "height": 1, "block_length": 2}})",
     R"({"polygon": {"vertices": [[0,0],[4,0],[4,1]], "holes": [[[0,2],[1,2],[1,3]]]}})",
     {"blocks[0].polygon is", "hole"}},
    {"vertex with unit of time",
     R"({"bar": {"length": 4, "height": 1, "block_length": 2}})",
     R"({"polygon": {"vertices": [[0,0],["4 s",0],[4,1]]}})",
     {"blocks[0].polygon.vertices[1][0] is \"4 s\"", "length"}},
    {"gravity upwards",
     R"("blocks")",
     R"("gravity": "-9.81 m/s2", "blocks")",
     {"gravity is \"-9.81 m/s2\"", "downwards"}},
    {"point outside", "[0, 0.5]", "[0, 1.5]", {"loads[0].point is (0, 1.5) m and outside all blocks", "(4, 1)"}},
    {"point on a joint",
     "[0, 0.5]",
     "[2, 0.5]",
     {"loads[0].point is (2, 0.5) m where several blocks meet", "\"bar 1\", \"bar 2\""}},
    {"point of another block",
     R"("point": [0, 0.5])",
     R"("point": [2, 0.5], "block": "bar 3")",
     {"loads[0].block is \"bar 3\""}},
    {"point beside its block",
     R"("point": [0, 0.5])",
     R"("point": [0, 0.5], "block": "bar 2")",
     {"loads[0].block is \"bar 2\"", "\"bar 1\""}},
    {"force without direction", R"("force": [1e3, 0],)", "", {"loads[0].force is missing"}},
    {"pressure on a point", R"("force": [1e3, 0])", R"("pressure": 1e3)", {"loads[0].pressure is 1000", "point"}},
    {"force and traction",
     R"("point": [0, 0.5], "force": [1e3, 0])",
     R"("edge": "top", "force": [1, 0], "traction": [1, 0])",
     {"loads[0] is given with 2 of traction, force and pressure"}},
    {"edge away from blocks",
     R"({"edge": "right"})",
     R"({"edge": {"from": [5, 0], "to": [5, 1]}})",
     {"supports[0].edge is {\"from\":[5,0],\"to\":[5,1]}", "(4, 1)"}},
    {"edge on a joint",
     R"({"edge": "right"})",
     R"({"edge": {"from": [2, 0], "to": [2, 1]}})",
     {"supports[0].edge", "\"bar 1\", \"bar 2\""}},
    {"edge without length",
     R"({"edge": "right"})",
     R"({"edge": {"from": [4, 0], "to": [4, 0]}})",
     {"supports[0].edge", "two different points"}},
    {"edge of another block",
     R"({"edge": "right"})",
     R"({"edge": "right", "block": "bar 1"})",
     {"supports[0].block is \"bar 1\""}},
    {"soft support",
     R"({"edge": "right"})",
     R"({"edge": "right", "stiffness": "0 N/m"})",
     {"supports[0].stiffness is \"0 N/m\"", "positive"}},
    {"moved but not held",
     R"({"edge": "right"})",
     R"({"edge": "right", "hold": "x", "displacement": [0, 1]})",
     {"supports[0].displacement is [0,1]", "hold"}},
    {"speed and impedance",
     R"({"edge": "left"})",
     R"({"edge": "left", "normal_speed": "p", "normal_impedance": 1e7})",
     {"viscous_boundaries[0].normal_speed is \"p\"", "left out"}},
    {"unknown speed",
     R"({"edge": "left"})",
     R"({"edge": "left", "normal_speed": "q"})",
     {"viscous_boundaries[0].normal_speed is \"q\"", "velocity"}},
    {"negative frequency", "100 Hz", "-1 Hz", {"loads[0].history.sine.frequency is \"-1 Hz\"", "positive"}},
    {"time going back",
     R"({"sine": {"frequency": "100 Hz"}})",
     R"({"table": [[0, 1], ["2 ms", 0], ["1 ms", 1]]})",
     {"loads[0].history.table[2] is [\"1 ms\",1]", "later"}},
    {"measured outside", "[2, 0.5]", "[-2, 0.5]", {"measurements[0].point is (-2, 0.5) m and outside"}},
    {"nothing on that side",
     "[2, 0.5]",
     R"([2, 0.5], "side": "above"})"
     R"(, {"quantity": "stress_xx", "point": [2, 1], "side": "above")",
     {"measurements[1].side is \"above\""}},
    {"traction away from a joint",
     R"("stress_xx", "point": [2, 0.5])",
     R"("traction_normal", "point": [1, 0.5])",
     {"measurements[0].point is [1,0.5]", "joint"}},
    {"side of a traction",
     R"("stress_xx", )",
     R"("traction_shear", "side": "left", )",
     {"measurements[0].side is \"left\"", "traction"}},
    {"same measurement",
     R"("point": [2, 0.5]})",
     R"("point": [2, 0.5]}, {"name": "stress_xx", "quantity": "rotation", "block": "bar 1"})",
     {"measurements[1].name is \"stress_xx\""}},
    {"zero dt", "1e-4 s", "0 s", {"steps.dt is \"0 s\"", "positive"}},
    {"negative dt", R"("1e-4 s")", "-1e-4", {"steps.dt is -0.0001", "above 0"}},
    {"less than a step", R"("duration": 0.01)", R"("duration": "1 us")", {"steps.duration is \"1 us\"", "one step"}},
    {"more steps than can be", R"("duration": 0.01)", R"("duration": 1e300)", {"steps.duration is 1e+300", "1e12"}},
    {"hht beyond its range",
     R"("duration": 0.01)",
     R"("duration": 0.01, "integrator": {"hht": 0.4})",
     {"steps.integrator.hht is 0.4", "0.333333"}},
    {"rho_inf beyond its range",
     R"("duration": 0.01)",
     R"("duration": 0.01, "integrator": {"generalized_alpha": 1.1})",
     {"steps.integrator.generalized_alpha is 1.1"}},
    {"growing velocity",
     R"("duration": 0.01)",
     R"("duration": 0.01, "velocity_factor": "101 %")",
     {"steps.velocity_factor is \"101 %\""}},
    {"same stages",
     R"({"dt": "1e-4 s", "duration": 0.01})",
     R"([{"dt": 1, "duration": 1, "name": "a"}, {"dt": 1, "duration": 1, "name": "a"}])",
     {"steps[1].name is \"a\""}},
};

INSTANTIATE_TEST_SUITE_P(Syntax, BadScene, testing::ValuesIn(syntax));
INSTANTIATE_TEST_SUITE_P(Shape, BadScene, testing::ValuesIn(shape));
INSTANTIATE_TEST_SUITE_P(Values, BadScene, testing::ValuesIn(values));

std::string sentence_of_reading(const std::filesystem::path& file) {
  try {
    read_scene(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BadSceneFile, Missing) {
  expect_sentence(sentence_of_reading("nowhere/scene.json"),
                  {"nowhere/scene.json: the scene file is missing, expected"});
}

TEST(BadSceneFile, Directory) {
  const std::filesystem::path directory = testing::TempDir();
  expect_sentence(sentence_of_reading(directory), {directory.string() + ": the scene file is a directory, expected"});
}

TEST(BadSceneFile, EmptyAndSpoiledAreNamed) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "dda_bad_scene_test.json";
  std::ofstream(file).flush();
  expect_sentence(sentence_of_reading(file), {file.string() + ": the scene is empty"});
  std::ofstream(file) << R"({"dda": 1})";
  expect_sentence(sentence_of_reading(file), {file.string() + ": ", " is missing, expected"});
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace dda
