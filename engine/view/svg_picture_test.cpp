#include "engine/view/svg_picture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "engine/core/error.h"
#include "engine/record/xml_tags.h"
#include "engine/view/colour_map.h"
#include "engine/view/colour_scale.h"
#include "engine/view/quantities.h"
#include "engine/view/svg_path.h"
#include "engine/view/view_test_support.h"

namespace dda {
namespace {

class SvgPictureTest : public testing::Test {
 protected:
  [[nodiscard]] const std::filesystem::path& written() const {
    write_run(folder_.path(), model_to_view(), {0, 1});
    return folder_.path();
  }

  [[nodiscard]] std::string picture(const PictureOptions& options) const {
    return svg_picture(results_.drawing(), results_.frame(1), options);
  }

  static std::vector<XmlTag> tags_of(const std::string& text, const std::string& name) {
    std::vector<XmlTag> found;
    XmlTags tags(text);
    while (const auto tag = tags.next())
      if (tag->name == name) found.push_back(*tag);
    return found;
  }

  TemporaryFolder folder_;
  RunResults results_{written()};
};

TEST(SvgPath, RoundsPlacesNotSteps) {
  SvgPath path;
  path.move_to(Vec2(0.04, -0.26));
  for (int i = 1; i <= 10; ++i) path.line_to(Vec2(0.04 + 0.14 * i, -0.26));
  path.close();
  // 0.18 0.32 0.46 0.60 0.74 0.88 1.02 1.16 1.30 1.44
  EXPECT_EQ(path.text(), "M0 -0.3l0.2 0l0.1 0l0.2 0l0.1 0l0.1 0l0.2 0l0.1 0l0.2 0l0.1 0l0.1 0Z");
}

TEST_F(SvgPictureTest, EveryBlockHasTheColourOfItsValue) {
  PictureOptions options;
  options.quantity = "stress_xx";  // -3, -6, -9 MPa
  const std::string text = picture(options);
  const ColourScale scale{-9e6, 0, false, true, 0, 0};
  for (const double stress : {-3e6, -6e6, -9e6}) {
    const std::string start = "<path fill=\"" + to_hex(scale.colour(stress)) + "\" d=\"M";
    EXPECT_NE(text.find(start), std::string::npos) << stress;
  }
  EXPECT_NE(text.find("Stress \u03c3xx"), std::string::npos);
  EXPECT_NE(text.find(">MPa, tension +<"), std::string::npos);
  EXPECT_NE(text.find(">\u22128<"), std::string::npos);  // a tick
  EXPECT_NE(text.find("t = 1 s"), std::string::npos);
}

TEST_F(SvgPictureTest, OutlinesAreTrue) {
  PictureOptions options;
  options.forces = DrawnForces::none;
  const std::string text = picture(options);
  std::size_t rings = 0;
  std::size_t steps = 0;
  for (const XmlTag& tag : tags_of(text, "path")) {
    const std::string d = tag.attribute("d");
    if (d.find('Z') == std::string::npos) continue;
    rings += static_cast<std::size_t>(std::count(d.begin(), d.end(), 'M'));
    steps += static_cast<std::size_t>(std::count(d.begin(), d.end(), 'l'));
  }
  EXPECT_EQ(rings, 4U);                 // three blocks, one with a hole
  EXPECT_EQ(steps, 3U + 7U + 3U + 3U);  // no edge that is none
}

// A metre is as long along x as along y, and blocks are where the state says, exaggerated when asked for.
TEST_F(SvgPictureTest, BlocksAreWhereTheyAre) {
  PictureOptions options;
  options.window = Window{-1, -3, 9, 3};
  options.forces = DrawnForces::none;
  const double scale = (960 - 32 - 148) / 10.0;  // px/m: the width without margins and side
  for (const double factor : {1.0, 5.0}) {
    options.deformation_scale = factor;
    const std::string text = picture(options);
    const auto number = [](double value) { return fmt::format("{:.4g}", value); };
    const double x = 16 + (0.1 * factor + 1) * scale;  // block 0 moves by (0.1, -0.2)
    const double y = 16 + (3 + 0.2 * factor) * scale;
    EXPECT_NE(text.find("M" + number(x) + " " + number(y) + "l78 0l0 -78l-78 0Z"), std::string::npos) << text;
  }
}

TEST_F(SvgPictureTest, IsWellFormedWithAnyTitle) {
  PictureOptions options;
  options.title =
      "A <title> & \"more\", long enough to need a second line because it goes on and on, and on and on and on";
  options.crosses = true;
  const std::string text = picture(options);
  EXPECT_NE(text.find("A &lt;title&gt; &amp; &quot;more&quot;"), std::string::npos);
  int depth = 0;
  const std::regex tag(R"(<(/?)[a-zA-Z]+( [a-zA-Z0-9-]+="[^"<]*")*(/?)>|<[^>]*>)");
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    ASSERT_TRUE((*it)[2].matched || it->str().find('=') == std::string::npos) << it->str();
    if ((*it)[1].length() > 0)
      --depth;
    else if ((*it)[3].length() == 0)
      ++depth;
    EXPECT_GE(depth, 0);
  }
  EXPECT_EQ(depth, 0);
}

TEST_F(SvgPictureTest, ForcesHaveTheirKey) {
  const std::string text = picture({});
  EXPECT_NE(text.find(">Joint force<"), std::string::npos);
  EXPECT_NE(text.find(">4 kN/m<"), std::string::npos);  // the largest
  PictureOptions none;
  none.forces = DrawnForces::none;
  EXPECT_EQ(picture(none).find("Joint force"), std::string::npos);
}

TEST_F(SvgPictureTest, DrawsBoltsWithTheirKey) {
  const std::string without = picture({});
  EXPECT_EQ(without.find("Axial force"), std::string::npos);
  EXPECT_EQ(without.find("#007a3d"), std::string::npos);
  write_bolts(folder_.path(), model_to_view(), {0, 1});
  const RunResults results(folder_.path());
  for (const std::size_t number : {0U, 1U}) {
    const Frame frame = results.frame(number);
    const std::string text = svg_picture(results.drawing(), frame, {});
    EXPECT_NE(text.find("Axial force"), std::string::npos);
    EXPECT_NE(text.find(number == 0 ? ">yielded<" : ">broken<"), std::string::npos);
    EXPECT_EQ(text.find(number == 0 ? ">broken<" : ">yielded<"), std::string::npos);
    std::vector<XmlTag> elastic;
    std::vector<XmlTag> dashed;
    for (const XmlTag& tag : tags_of(text, "path")) {
      if (tag.attribute("stroke") == "#007a3d") elastic.push_back(tag);
      if (!tag.attribute("stroke-dasharray").empty()) dashed.push_back(tag);
    }
    // The tie; then 0, 0.5 and 1 kN of the key, or 0, 1 and 2 kN. The thickest is the tie at 1 s, the thinnest 0 N.
    ASSERT_EQ(elastic.size(), 4U);
    EXPECT_EQ(elastic[0].attribute("stroke-width"), number == 0 ? "1.60" : "5.50");
    EXPECT_EQ(elastic[1].attribute("stroke-width"), "1.60");
    EXPECT_EQ(elastic.back().attribute("stroke-width"), "5.50");
    EXPECT_EQ(dashed.size(), number == 0 ? 0U : 2U);
    double height = 0;
    const std::string view = tags_of(text, "svg").at(0).attribute("viewBox");
    height = std::stod(view.substr(view.rfind(' ')));
    for (const XmlTag& tag : tags_of(text, "text")) EXPECT_LT(std::stod(tag.attribute("y")), height);
  }
}

// An element at half of its strength has the colour that the key has there, one without has that of bolts.
TEST_F(SvgPictureTest, ColoursLiningsByTheirUtilisation) {
  const RunResults results(folder_.path());
  Frame frame = results.frame(1);
  const auto has = [&](std::string_view what) {
    return svg_picture(results.drawing(), frame, {}).find(what) != std::string::npos;
  };
  DrawnBolt element;
  element.reference = {{0, 0}, {1, 0}};
  element.displacement = {{0, 0}, {0, 0}};
  element.force = -1000;
  frame.bolts = {element};
  EXPECT_FALSE(has("Utilisation"));
  EXPECT_TRUE(has("#007a3d"));
  frame.bolts[0].utilisation = 0.5;
  EXPECT_TRUE(has(">Utilisation<"));
  EXPECT_TRUE(has(">75 %<"));
  const std::string half = to_hex(utilisation_map()[128]);
  int drawn = 0;
  const std::string text = svg_picture(results.drawing(), frame, {});
  for (const XmlTag& tag : tags_of(text, "path")) drawn += tag.attribute("stroke") == half ? 1 : 0;
  EXPECT_EQ(drawn, 2) << "the element and the key";
  frame.bolts[0].condition = DrawnCondition::yielded;
  EXPECT_TRUE(has(">yielded<"));
}

}  // namespace
}  // namespace dda
