// Lines that are read as they go by say what they say in a document, and what is wrong with them is said in the same
// words.
#include "engine/scene/scene_document.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/mutator.h"
#include "engine/scene/json_text.h"
#include "engine/scene/scene.h"
#include "engine/scene/schema_check.h"

namespace dda {
namespace {

using nlohmann::json;

std::string scene_with(const std::string& blocks) {
  return R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.25}},
 "joints": {"default": {"friction_angle": "35 deg"}, "bed": {"friction_angle": "25 deg"}, "mesh": {"bonded": true}},
 "blocks": )" +
         blocks + R"(, "steps": {"dt": "1 ms", "duration": "1 s"}})";
}

std::string rock_with(const std::string& lines) {
  return R"({"rock": {"boundary": [[0, 0], [6, 0], [6, 6], [0, 6]], "lines": )" + lines + "}}";
}

const std::string plain_lines = R"([{"points": [[0, 1], [6.0, 1.25e0]], "joint": "default"},
 {"joint": "bed", "points": [[2, -1], [3.125, 3], [2, 7]]}, {"points": [[-0, 5], [0.1, 18446744073709551616]], "joint": "bed"},
 {"points": [[1, 1], [2, 1], [2, 2], [1, 1]], "joint": "mesh"}])";

// As in a document.
json entries_of(const PlainLines& lines) {
  const std::vector<Field> joints = lines.joints();
  json entries = json::array();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    json& entry = entries.emplace_back(json{{"joint", joints[lines.joint(i)].at("joint").text()}});
    for (const Vec2& point : lines.points(i)) entry["points"].push_back({point.x(), point.y()});
  }
  return entries;
}

// With numbers as readers take them.
json in_doubles(json value) {
  if (value.is_number()) return value.get<double>();
  if (value.is_structured())
    for (json& part : value) part = in_doubles(part);
  return value;
}

// The document with its lines.
json whole(const SceneDocument& scene) {
  json document = scene.document;
  for (const PlainLines& lines : scene.lines) {
    json& blocks = document["blocks"];
    json& entry = blocks.is_array() ? blocks[std::stoul(lines.path().substr(std::string("blocks[").size()))] : blocks;
    EXPECT_EQ(entry["rock"]["lines"].size(), 1U);
    entry["rock"]["lines"] = entries_of(lines);
  }
  return in_doubles(document);
}

TEST(SceneDocument, HasPlainLinesBesideIt) {
  for (const std::string& blocks :
       {rock_with(plain_lines), "[" + rock_with("[]") + ", " + rock_with(plain_lines) + "]"}) {
    const std::string text = scene_with(blocks);
    const auto scene = document_without_lines(text);
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->lines.size(), 1U);
    EXPECT_EQ(scene->lines.front().size(), 4U);
    EXPECT_EQ(whole(*scene), in_doubles(parse_json(text)));
  }
}

TEST(SceneDocument, HasOtherListsItself) {
  const std::string text = scene_with(R"([{"polygon": {"vertices": [[0, 0], [1, 0], [1, 1]]}}])");
  const auto scene = document_without_lines(text);
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene->lines.empty());
  EXPECT_EQ(scene->document, parse_json(text));
}

// Lines that are right, but more than numbers and a name; and lines that are wrong.
const std::vector<std::string> not_plain{
    R"({"points": [["1 m", 2], [3, 4]], "joint": "bed"})",
    R"({"points": [[1, 2]], "joint": "bed"})",
    R"({"points": [], "joint": "bed"})",
    R"({"points": [[1, 2], [3]], "joint": "bed"})",
    R"({"points": [[1, 2], [3, 4, 5]], "joint": "bed"})",
    R"({"points": [[1, 2], 3], "joint": "bed"})",
    R"({"points": [[1, 2], [3, [4]]], "joint": "bed"})",
    R"({"points": [[1, 2], [3, null]], "joint": "bed"})",
    R"({"points": [[1, 2], [3, true]], "joint": "bed"})",
    R"({"points": [[1, 2], {"x": 3, "y": 4}], "joint": "bed"})",
    R"({"points": "all", "joint": "bed"})",
    R"({"points": [[1, 2], [3, 1e400]], "joint": "bed"})",
    R"({"points": [[1, 2], [3, NaN]], "joint": "bed"})",
    R"({"points": [[1, 2], [3, 4]]})",
    R"({"joint": "bed"})",
    R"({"points": [[1, 2], [3, 4]], "joint": ""})",
    R"({"points": [[1, 2], [3, 4]], "joint": 7})",
    R"({"points": [[1, 2], [3, 4]], "joint": ["bed"]})",
    R"({"points": [[1, 2], [3, 4]], "joint": "bed", "name": "first"})",
    R"({"points": [[1, 2], [3, 4]], "joint": "bed", "joint": "bed"})",
    R"({"points": [[1, 2], [3, 4]], "points": [[1, 2], [3, 4]], "joint": "bed"})",
    R"({"points": [[1, 2], [3, 4]], "joint": "bed"}, 5)",
    R"({"points": [[1, 2], [3, 4]], "joint": "bed"}, [])",
    R"({"points": [[1, 2], [3, 4]], "joint": "bed")",
    R"({"points": [[1, 2], [3, 4]], "joint": "\xff"})",
};

// Blanks make a text a large one.
std::string large(const std::string& text) { return text + std::string(1'000'001, ' '); }

std::string outcome(const std::string& text) {
  try {
    std::string said;
    for (const Block& block : parse_scene(text, "scene.json").blocks) {
      said += block.name;
      for (const Vec2& corner : block.shape.outer) said += json{corner.x(), corner.y()}.dump();
    }
    return said;
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(SceneDocument, OfAnySizeIsReadAndRefusedAlike) {
  std::vector<std::string> lists{plain_lines, R"([{"points": [[0, 1], [6, 1]], "joint": "bad"}])", "7",
                                 R"({"rock": [[]]})", R"([{"points": [[0, 1], [6, 1]], "joint": "bed"}])"};
  for (const std::string& line : not_plain) {
    lists.push_back("[" + line + "]");
    lists.push_back(plain_lines.substr(0, plain_lines.size() - 1) + ", " + line + "]");
    EXPECT_FALSE(document_without_lines(scene_with(rock_with(lists.back())))) << line;
  }
  for (const std::string& list : lists) {
    for (const std::string& blocks : {rock_with(list), "[" + rock_with(list) + ", " + rock_with(plain_lines) + "]"}) {
      const std::string text = scene_with(blocks);
      EXPECT_EQ(outcome(large(text)), outcome(text)) << list;
    }
  }
}

// Names that no joint has are refused at the first line that has them, in order.
TEST(SceneDocument, NamesTheLineWhoseJointIsUnknown) {
  const std::string lines =
      plain_lines.substr(0, plain_lines.size() - 1) +
      R"(, {"points": [[0, 3], [6, 3]], "joint": "bet"}, {"points": [[0, 4], [6, 4]], "joint": "x"}])";
  EXPECT_EQ(
      outcome(large(scene_with(rock_with(lines)))),
      "scene.json: blocks.rock.lines[4].joint is \"bet\", expected one of \"default\", \"bed\", \"mesh\" (perhaps "
      "\"bed\")");
}

// What is taken for plain is what the schema takes.
TEST(SceneDocumentFuzz, DamagedScenesAreTakenAsTheSchemaTakesThem) {
  const std::string text = scene_with("[" + rock_with(plain_lines) + ", " + rock_with("[]") + "]");
  const std::size_t from = text.find("\"blocks\"");
  std::size_t taken = 0;
  for (std::uint64_t number = 0; number < 5000; ++number) {
    const std::string damaged = Mutator(number).text(text, from);
    const auto scene = document_without_lines(damaged);
    if (!scene) continue;
    ++taken;
    const json document = parse_json(damaged);
    EXPECT_NO_THROW(check_schema(document)) << number;
    EXPECT_EQ(whole(*scene), in_doubles(document)) << number;
  }
  EXPECT_GT(taken, 500U);
}

}  // namespace
}  // namespace dda
