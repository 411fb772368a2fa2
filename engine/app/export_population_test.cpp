// Blocks that dda cut exports are read by dda cut again, without a word on layers, as the same blocks: random rocks of
// two joint sets, some persistent, with openings, regions, cells, holes and merging, to DXF, GeoJSON and dc.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "engine/app/command_line_test_support.h"
#include "engine/geometry/polygon.h"

namespace dda {
namespace {

using nlohmann::json;

const std::string long_joint = "a joint of a name so long that DXF cuts it off";

class RandomScene {
 public:
  explicit RandomScene(unsigned seed) : random_(seed) {}

  json make(unsigned seed) {
    json rock = {{"boundary", {{0, between(-1, 1)}, {10, between(-1, 1)}, {10, 10}, {between(3, 7), 11}, {0, 10}}},
                 {"joint_sets", {steep(), flat()}},
                 {"lines", {{{"points", {{-1, between(1, 9)}, {11, between(1, 9)}}}, {"joint", "Störung 1"}}}},
                 {"material", "rock"},
                 {"name", by_lot(0.5) ? "rock" : "boundary"},  // a name that a layer of its own has
                 {"seed", seed}};
    if (by_lot(0.6)) rock["openings"].push_back(opening("tunnel", {3, 5}));
    if (by_lot(0.4)) rock["openings"].push_back(opening("Stollen Süd", {7, 3}));
    if (by_lot(0.5))
      rock["regions"] = {{{"outline", {{0, -1}, {4, -1}, {5, 12}, {0, 12}}}, {"material", "Ton (weich)"}}};
    if (by_lot(0.2)) rock["holes"] = {{{8, 7}, {9, 7}, {9, 8.5}}};
    if (by_lot(0.2)) rock["merge"] = {{"area", 0.05}};
    if (by_lot(0.2)) rock["tolerance"] = between(1e-4, 5e-3);
    if (by_lot(0.2))
      rock["fill"] = {{{"voronoi", {{"size", 0.6}}}, {"joint", "glue"}, {"region", {{4, 6}, {8, 6}, {8, 9}, {4, 9}}}}};
    return scene(rock);
  }

 private:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
  }
  bool by_lot(double share) { return between(0, 1) < share; }
  std::string degrees(double low, double high) { return fmt::format("{:.2f} deg", between(low, high)); }

  json steep() {
    const double spacing = between(0.8, 2);
    return {{"dip", {{"mean", degrees(35, 80)}, {"deviation", degrees(0, 8)}}},
            {"spacing", {{"mean", spacing}, {"deviation", 0.3 * spacing}}},
            {"name", "steep"},
            {"joint", by_lot(0.5) ? long_joint : "default"}};
  }

  json flat() {
    json set = {{"dip", {{"mean", degrees(-25, 25)}, {"deviation", degrees(0, 8)}}},
                {"spacing", {{"mean", between(0.8, 2)}, {"distribution", "exponential"}}},
                {"joint", "bedding"}};
    if (by_lot(0.5)) {
      set["trace_length"] = between(2, 5);
      set["persistence"] = between(0.5, 0.95);
      set["ends_at"] = {"steep"};
    }
    return set;
  }

  json opening(const std::string& name, const Vec2& middle) {
    json entry = {{"name", name}, {"left_out", by_lot(0.5)}};
    const double size = between(0.5, 2);
    if (by_lot(0.5))
      entry["circle"] = {{"centre", {middle.x(), middle.y()}}, {"radius", size}};
    else
      entry["horseshoe"] = {{"foot", {middle.x(), middle.y() - size}}, {"width", 2 * size}, {"height", 2 * size}};
    return entry;
  }

  static json scene(const json& rock) {
    const json friction = {{"friction_angle", "30 deg"}};
    json joints = {{"default", friction}, {"bedding", friction}, {"Störung 1", {{"bonded", true}}}};
    for (const json& set : rock["joint_sets"]) joints[set["joint"].get<std::string>()] = friction;
    if (rock.contains("fill")) joints["glue"] = {{"bonded", true}};
    const json stone = {{"density", 2600}, {"young", 10e9}, {"poisson", 0.2}};
    return {{"dda", 1},
            {"materials", {{"rock", stone}, {"Ton (weich)", stone}}},
            {"joints", joints},
            {"blocks", {{"rock", rock}}},
            {"steps", {{"dt", 1e-3}, {"duration", 1e-3}}}};
  }

  std::mt19937_64 random_;
};

std::vector<double> areas_of(const json& scene) {
  std::vector<double> areas;
  const auto ring = [](const json& vertices) {
    Ring points;
    for (const json& vertex : vertices) points.push_back({vertex[0].get<double>(), vertex[1].get<double>()});
    return points;
  };
  for (const json& entry : scene["blocks"]) {
    Polygon polygon{ring(entry["polygon"]["vertices"]), {}};
    for (const json& hole : entry["polygon"].value("holes", json::array())) polygon.holes.push_back(ring(hole));
    areas.push_back(area_moments(polygon).area);
  }
  return areas;
}

// Names, groups, corners and materials. A scene of one material does not name it with every block.
json blocks_of(const json& scene) {
  json blocks = scene["blocks"];
  for (json& entry : blocks) entry["polygon"].emplace("material", scene["materials"].begin().key());
  return blocks;
}

class ExportPopulation : public CommandLine {
 protected:
  void expect_back(unsigned seed);
  void expect_same_by_itself(const std::string& format);
  void expect_same_in_scene(json scene, const std::string& format);
  void expect_same_areas_from_dc();
  json cut_of(const std::string& file, const std::string& folder, const std::vector<std::string>& more = {});
  int back_from_dc_ = 0;
};

// Neither --layer nor anything else.
json ExportPopulation::cut_of(const std::string& file, const std::string& folder,
                              const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"cut", path(file), "--out", path(folder)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome cut = call(arguments);
  EXPECT_EQ(cut.code, 0) << cut.errors;
  return cut.code == 0 ? json::parse(text(folder + "/scene.json")) : json();
}

void ExportPopulation::expect_same_by_itself(const std::string& format) {
  const json cut = json::parse(text("out/scene.json"));
  const json again = cut_of("blocks" + format, "again", {"--export", path("again" + format)});
  ASSERT_TRUE(again.is_object());
  EXPECT_TRUE(blocks_of(cut) == blocks_of(again));
  EXPECT_TRUE(cut.value("joint_lines", json()) == again.value("joint_lines", json()));
  EXPECT_EQ(json::parse(text("again/cut.json"))["cleaned"].size(), 0U) << text("again/cut.json");
  EXPECT_TRUE(text("blocks" + format) == text("again" + format));
}

// In place of the rock, beside materials and joints of its scene.
void ExportPopulation::expect_same_in_scene(json scene, const std::string& format) {
  scene["blocks"]["rock"] = {{"drawing", "blocks" + format}, {"material", "rock"}};
  const json cut = json::parse(text("out/scene.json"));
  scene["joints"] = cut["joints"];  // without those of which nothing came
  write("drawn.json", scene.dump());
  cut_of("drawn.json", "drawn");
  EXPECT_TRUE(text("out/scene.json") == text("drawn/scene.json"));
}

// dc knows neither groups nor names, and one piece of rock only.
void ExportPopulation::expect_same_areas_from_dc() {
  const Outcome cut = call({"cut", path("blocks.dc"), "--out", path("again")});
  if (cut.code != 0) {
    EXPECT_TRUE(contains(cut.errors, "pieces of rock apart") || contains(cut.errors, "with others inside"))
        << cut.errors;
    return;
  }
  std::vector<double> before = areas_of(json::parse(text("out/scene.json")));
  std::vector<double> after = areas_of(json::parse(text("again/scene.json")));
  ASSERT_EQ(before.size(), after.size());
  std::ranges::sort(before);
  std::ranges::sort(after);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(before[i], after[i], 1e-9);
  ++back_from_dc_;
}

void ExportPopulation::expect_back(unsigned seed) {
  SCOPED_TRACE(seed);
  const json scene = RandomScene(seed).make(seed);
  write("rock.json", scene.dump());
  for (const std::string format : {".dxf", ".geojson", ".dc"}) {
    SCOPED_TRACE(format);
    ASSERT_TRUE(cut_of("rock.json", "out", {"--export", path("blocks" + format)}).is_object());
    if (format == ".dc") {
      expect_same_areas_from_dc();
    } else {
      expect_same_by_itself(format);
      expect_same_in_scene(scene, format);
    }
  }
}

TEST_F(ExportPopulation, TenRocks) {
  for (unsigned seed = 1; seed <= 10; ++seed) expect_back(seed);
  EXPECT_GT(back_from_dc_, 5);
}

// Slow: run by ctest -L slow.
TEST_F(ExportPopulation, DISABLED_TwoHundredRocks) {
  for (unsigned seed = 1; seed <= 200; ++seed) expect_back(seed);
  RecordProperty("back_from_dc", back_from_dc_);
  EXPECT_GT(back_from_dc_, 150);
}

}  // namespace
}  // namespace dda
