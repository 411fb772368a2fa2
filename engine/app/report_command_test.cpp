// `dda report`: one page that stands by itself, and what it refuses.
#include <string>

#include "engine/app/command_line_test_support.h"
#include "engine/app/moving_part.h"

namespace dda {
namespace {

class Report : public CommandLine {
 protected:
  void run_slab(const std::vector<std::string>& options) const {
    write("scene.json", restless_slab);
    std::vector<std::string> arguments = {"run", path("scene.json"), "--out", path("results"), "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    call(arguments);
  }
};

std::ptrdiff_t count(const std::string& text, std::string_view part) {
  std::ptrdiff_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_F(Report, SaysWhatCameOfARun) {
  run_slab({"--frames", "4"});
  const Outcome outcome = call({"report", path("results")});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const std::string page = text("results/report.html");
  for (const char* part : {"gained_energy", "friction_angle 30 deg", "Energy and work", "released", "The last frame",
                           "factorizations", "supports</td><td>1", "results</title>"})
    EXPECT_TRUE(contains(page, part)) << part;
  for (const char* outside : {"<script", "src=", "href=\"h", "@import", "url(h"})
    EXPECT_FALSE(contains(page, outside)) << outside;
  for (const char* pair : {"section", "table", "tr", "svg", "ul"})
    EXPECT_EQ(count(page, std::string("<") + pair + ">") + count(page, std::string("<") + pair + " "),
              count(page, std::string("</") + pair + ">"))
        << pair;
  EXPECT_FALSE(contains(page, "nan"));
}

TEST_F(Report, DrawsTheSceneOfARunWithoutFrames) {
  write("scene.json", bar_scene(3, 20));
  ASSERT_EQ(call({"run", path("scene.json"), "--out", path("results"), "--quiet"}).code, 0);
  ASSERT_EQ(call({"report", path("results"), "--out", path("page.html")}).code, 0);
  EXPECT_TRUE(contains(text("page.html"), "The blocks as drawn"));
  EXPECT_TRUE(contains(text("page.html"), "stress, traction_normal ("));
}

// Two rows at one time are the beginning and the end of a static stage, and the motion begins with its end.
TEST(MovingPart, BeginsWhereStaticStagesEnd) {
  const Histories all{{0, 0, 1, 1, 2}, {{"u", "m", {5, 6, 7, 9, 8}}}};
  const Histories moving = from(0, all);
  EXPECT_EQ(moving.times, (std::vector<double>{0, 1, 1, 2}));
  EXPECT_EQ(moving.columns[0].values, (std::vector<double>{6, 7, 9, 8}));
  EXPECT_EQ(from(first_moment({}), all).times, all.times);
  EXPECT_EQ(from(2, all).times, all.times);  // one row shows nothing
  EXPECT_EQ(without_jumps(all.times, all.columns[0].values), (std::vector<double>{5, 5, 6, 6, 5}));
}

TEST_F(Report, RefusesWhatIsNoRun) {
  expect_refusal({"report", path("nothing")}, "nothing/run.json: what the run was asked for is");
  write("scene.json", bar_scene(3, 20));
  ASSERT_EQ(call({"run", path("scene.json"), "--out", path("results"), "--quiet"}).code, 0);
  expect_refusal({"report", path("results"), "--out", path("page.svg")},
                 "page.svg, expected a name that ends in .html");
  std::filesystem::remove(path("results/summary.json"));
  expect_refusal({"report", path("results")}, "summary.json: summary is missing");
}

}  // namespace
}  // namespace dda
