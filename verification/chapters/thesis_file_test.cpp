#include "verification/chapters/thesis_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "verification/chapters/chapter_figures.h"
#include "verification/study/markdown.h"

namespace verify {
namespace {

using Json = nlohmann::json;

Chapter chapter(int number, std::optional<bool> confirmed) {
  Chapter made;
  made.number = number;
  made.title = "Title";
  made.statements = {{number, "id", "What it says", 2.5, std::string("ours"), "m/s", confirmed, "Because."}};
  made.assumptions = {"something"};
  return made;
}

TEST(ThesisFile, HasEveryKeyOfAStatementAndNullForWhatCannotBeJudged) {
  const Json json = Json::parse(with_chapter("", chapter(4, std::nullopt)));
  const Json expected = {{"chapter", 4},   {"id", "id"},    {"statement", "What it says"}, {"thesis", 2.5},
                         {"ours", "ours"}, {"unit", "m/s"}, {"confirmed", nullptr},        {"reason", "Because."}};
  EXPECT_EQ(json.at("statements"), Json::array({expected}));
  EXPECT_EQ(json.at("assumptions"), Json::array({{{"chapter", 4}, {"assumption", "something"}}}));
}

TEST(ThesisFile, ReplacesItsChapterAndKeepsTheOthersInOrder) {
  std::string text = with_chapter("", chapter(5, true));
  text = with_chapter(text, chapter(3, false));
  text = with_chapter(text, chapter(5, false));
  const Json statements = Json::parse(text).at("statements");
  ASSERT_EQ(statements.size(), 2U);
  EXPECT_EQ(statements[0].at("chapter"), 3);
  EXPECT_EQ(statements[1].at("confirmed"), false);
}

TEST(ThesisFile, RefusesAnotherFile) {
  EXPECT_THROW(static_cast<void>(with_chapter("[]", chapter(3, true))), dda::InputError);
}

TEST(ThesisFile, PageShowsVerdictReasonAndFailures) {
  Chapter judged = chapter(6, false);
  judged.failures = {"run a: not_converged"};
  const std::string page = to_markdown(chapter_page(judged));
  for (const char* text : {"| What it says | 2.5 m/s | ours | **not confirmed** |", "`id` **not confirmed**: Because.",
                           "something", "run a: not_converged"})
    EXPECT_NE(page.find(text), std::string::npos) << text << "\n" << page;
}

TEST(ThesisFile, FiguresAreFilesBesideThePageWhichNamesThem) {
  const dda::TemporaryFolder folder;
  Chapter judged = chapter(6, true);
  Section section{"Readings", {}};
  const dda::LinePlot plot{"peak velocity", "m/s", {0, 10e6, 50e6}, {{"level", {0.1, 0.2, 0.4}}}};
  add_figure("6_1_velocity", "Peak velocity over stress", plot, section, judged);
  add_figure("nothing", "No line", {"peak velocity", "m/s", {0, 10e6}, {}}, section, judged);
  judged.sections = {section};
  write_chapter(folder.path(), judged);
  EXPECT_NE(dda::read_file(folder / "6_1_velocity.svg").find("peak velocity ("), std::string::npos);
  EXPECT_NE(dda::read_file(folder / "chapter_6.md").find("(6_1_velocity.svg)"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "nothing.svg"));
}

}  // namespace
}  // namespace verify
