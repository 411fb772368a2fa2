// What is published with the format: schema, reference and examples fit what the reader does.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "engine/scene/scene.h"
#include "engine/scene/scene_schema.h"

namespace dda {
namespace {

using nlohmann::json;

const std::filesystem::path docs = DDA_DOCS_DIR;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void collect_keys(const json& schema, std::set<std::string>& keys) {
  if (schema.is_object() && schema.contains("properties")) {
    for (const auto& [key, unused] : schema["properties"].items()) keys.insert(key);
  }
  if (!schema.is_structured()) return;
  for (const json& part : schema) collect_keys(part, keys);
}

TEST(Schema, EveryKeyIsInTheReference) {
  std::set<std::string> keys;
  collect_keys(json::parse(scene_schema()), keys);
  ASSERT_GT(keys.size(), 80U);
  const std::string reference = text_of(docs / "scene.md");
  for (const std::string& key : keys) EXPECT_NE(reference.find("`" + key + "`"), std::string::npos) << key;
}

// Every object of the format refuses keys it does not know; only names of materials and joints are free.
void expect_closed(const json& schema, const std::string& place) {
  if (schema.is_object() && schema.contains("properties")) {
    EXPECT_EQ(schema.value("additionalProperties", json(true)), false) << place;
  }
  if (!schema.is_structured()) return;
  for (const auto& [key, part] : schema.items()) {
    if (key != "properties") {
      expect_closed(part, place + "/" + key);
      continue;
    }
    for (const auto& [name, property] : part.items()) expect_closed(property, place + "/" + name);
  }
}

TEST(Schema, UnknownKeysAreRefusedEverywhere) { expect_closed(json::parse(scene_schema()), ""); }

TEST(Examples, AreAllAccepted) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(docs / "examples")) {
    if (entry.path().extension() != ".json") continue;
    ++count;
    EXPECT_NO_THROW({
      const Model model = read_scene(entry.path());
      EXPECT_FALSE(model.title.empty()) << entry.path();
      EXPECT_FALSE(model.measurements.empty()) << entry.path();
    }) << entry.path();
  }
  EXPECT_GE(count, 7);
}

TEST(Examples, TheBarIsTheOneOfTheThesis) {
  const Model model = read_scene(docs / "examples" / "p_bar_2m_thesis.json");
  ASSERT_EQ(model.blocks.size(), 50U);
  EXPECT_EQ(model.measurements.at(0).block, 25);
  EXPECT_EQ(model.edge_loads.at(0).traction, Vec2(1e6, 0));
  EXPECT_EQ(model.stages.at(0).integrator.name, "thesis");
}

// Every scene in a json block of the reference is one that works.
TEST(Reference, ScenesShownAreAccepted) {
  const std::string reference = text_of(docs / "scene.md");
  int count = 0;
  for (std::size_t at = reference.find("```json\n{\"dda\""); at != std::string::npos;
       at = reference.find("```json\n{\"dda\"", at + 1)) {
    const std::size_t first = at + 8;
    EXPECT_NO_THROW(parse_scene(reference.substr(first, reference.find("```", first) - first), "scene.md"));
    ++count;
  }
  EXPECT_GE(count, 2);
}

// The fragments with stages are whole but for the rock around them.
TEST(Reference, StagesShownAreAcceptedAroundATunnel) {
  const std::string reference = text_of(docs / "scene.md");
  json rock = {{"boundary", {{-8, -8}, {8, -8}, {8, 8}, {-8, 8}}},
               {"joint_sets",
                {{{"dip", "10 deg"}, {"spacing", 2}, {"joint", "default"}},
                 {{"dip", "80 deg"}, {"spacing", 2}, {"joint", "default"}}}},
               {"openings", {{{"name", "tunnel"}, {"circle", {{"radius", 3}}}}}}};
  int count = 0;
  for (std::size_t at = reference.find("\n```"); at != std::string::npos;) {  // blocks of code, one after the other
    const std::size_t first = reference.find('\n', at + 1) + 1, last = reference.find("\n```", first);
    const json fragment = json::parse("{" + reference.substr(first, last - first) + "}", nullptr, false);
    at = reference.find("\n```", last + 1);
    if (fragment.is_discarded() || !fragment.contains("steps")) continue;
    json scene = {{"dda", 1},
                  {"gravity", 9.81},
                  {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.25}}}}},
                  {"joints", {{"default", {{"bonded", true}}}}},
                  {"blocks", {{"rock", rock}}},
                  {"supports", {{{"edge", "bottom"}}}}};
    scene.update(fragment);
    EXPECT_NO_THROW(parse_scene(scene.dump(), "scene.md")) << fragment;
    ++count;
  }
  EXPECT_GE(count, 5);
}

}  // namespace
}  // namespace dda
