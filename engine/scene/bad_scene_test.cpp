// Scenes of the wrong shape: each gives one sentence that names file, field and value.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

class BadScene : public testing::TestWithParam<Spoiled> {};

TEST(GoodScene, OfTheseTablesIsAccepted) { EXPECT_NO_THROW(parse_scene(good_text, "good.json")); }

TEST_P(BadScene, NamesFileFieldAndValue) { expect_refusal(GetParam()); }

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
    {"title of two lines",
     R"("dda": 1,)",
     R"("dda": 1, "title": "rock\nslope",)",
     {"title is \"rock", "expected one line of text"}},
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
    {"absorbing twice",
     R"([{"edge": "left"}])",
     R"([{"edge": {"from": [0, 0], "to": [0, 0.5]}, "ratio": 0.5}, {"edge": "left"}])",
     {"viscous_boundaries[1].edge is along \"bar 1\", where viscous_boundaries[0] absorbs already"}},
    {"stage called as one without a name",
     R"({"dt": "1e-4 s", "duration": 0.01})",
     R"([{"name": "stage 2", "dt": "1e-4 s", "duration": 0.01}, {"dt": "1e-4 s", "duration": 0.01}])",
     {"steps[1] is without a name, and so \"stage 2\", as a stage before is called", "a name of its own"}},
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
    {"unknown key of a stage", R"("duration": 0.01)", R"("duration": 0.01, "damper": 1)", {"steps.damper is no key"}},
    {"missing density", R"("density": 2650, )", "", {"materials.rock.density is missing", "kg/m3"}},
    {"missing duration", R"(, "duration": 0.01)", "", {"steps.duration is missing"}},
    {"missing duration, dt to be chosen", R"("dt": "1e-4 s", "duration": 0.01)", "", {"steps.duration is missing"}},
    {"no equilibrium to end a static stage",
     R"("dt": "1e-4 s", "duration": 0.01)",
     R"("integrator": "static", "equilibrium": 0)",
     {"steps.equilibrium is 0", "above 0"}},
    {"word for a time step", R"("dt": "1e-4 s")", R"("dt": "automatic")", {"steps.dt is \"automatic\""}},
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
     {"supports[0].edge", "left out beside point"}},
    {"neither point nor edge",
     R"({"edge": "right"})",
     R"({"hold": "x"})",
     {"supports[0] is without a place", "one of point, edge and block"}},
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
    {"rings of two blocks",
     R"({"bar": {"length": 4, "height": 1, "block_length": 2}})",
     R"({"rings": {"radii": [1, 2], "sectors": 2}})",
     {"blocks[0].rings.sectors is 2", "3 or more"}},
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

INSTANTIATE_TEST_SUITE_P(Syntax, BadScene, testing::ValuesIn(syntax));
INSTANTIATE_TEST_SUITE_P(Shape, BadScene, testing::ValuesIn(shape));

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
