// Documents rendered as Markdown and HTML.
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "engine/record/atomic_file.h"
#include "verification/study/gnuplot.h"
#include "verification/study/html.h"
#include "verification/study/markdown.h"

namespace verify {
namespace {

Document example() {
  Table table;
  table.header = {"what", "x|y"};
  table.rows = {{"a < b", "1"}, {"c", "2"}};
  table.breaks = {1};
  Document document;
  document.title = "A & B";
  document.sections = {{"One", {Paragraph{"**bold** `code`"}, Bullets{{"first"}}, table}}};
  return document;
}

TEST(Markdown, EscapesBarsInTables) {
  const std::string text = to_markdown(example());
  EXPECT_NE(text.find("| what | x\\|y |\n|---|---:|\n| a < b | 1 |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("- first\n"), std::string::npos);
}

TEST(Markdown, NamesTheGroupOfAColumn) {
  Document document = example();
  std::get<Table>(document.sections[0].pieces[2]).groups = {{"", 1}, {"second", 1}};
  EXPECT_NE(to_markdown(document).find("| what | second: x\\|y |\n"), std::string::npos);
}

TEST(Html, EscapesAndMarksUp) {
  EXPECT_EQ(inline_html("a < b & **c** `d`"), "a &lt; b &amp; <strong>c</strong> <code>d</code>");
  EXPECT_EQ(inline_html("a ** b"), "a ** b");
  EXPECT_EQ(inline_html("2 m and 5 % of 3 more, 10 ms"), "2&nbsp;m and 5&nbsp;% of 3 more, 10&nbsp;ms");
}

TEST(Html, MarksPartsOfTables) {
  const std::string html = to_html(example(), ".");
  EXPECT_NE(html.find("<tr class=\"part\"><td>c</td><td>2</td></tr>"), std::string::npos);
  EXPECT_NE(html.find("<td>a &lt; b</td>"), std::string::npos);
  EXPECT_NE(html.find("<title>A &amp; B</title>"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST(Html, FiguresKeepTheirIdsApart) {
  const std::string svg =
      "<?xml version='1.0'?>\n<!DOCTYPE svg>\n<svg id='a'><g id=\"p\"/><use xlink:href='#p'/><g "
      "clip-path='url(#p)'/></svg>";
  EXPECT_EQ(embedded_svg(svg, "f-"),
            "<svg id='f-a'><g id=\"f-p\"/><use xlink:href='#f-p'/><g clip-path='url(#f-p)'/></svg>");
}

TEST(Html, MissingFigureIsAnError) {
  Document document;
  document.sections = {{"One", {Figure{"no_such_figure.svg", ""}}}};
  EXPECT_THROW((void)to_html(document, testing::TempDir()), std::runtime_error);
}

TEST(Gnuplot, DrawsAnSvgAndReportsErrors) {
  ASSERT_TRUE(gnuplot_is_installed()) << "ci/setup installs it";
  const dda::TemporaryFolder place;
  const std::filesystem::path folder = place / "gnuplot test";
  std::filesystem::create_directories(folder);
  dda::write_file(folder / "line.gp",
                  gnuplot_style(300, 200) + "set output 'line.svg'\nplot x with lines linestyle 1\n");
  run_gnuplot(folder / "line.gp");
  EXPECT_NE(dda::read_file(folder / "line.svg").find("<svg"), std::string::npos);
  dda::write_file(folder / "wrong.gp", "plot no_such_function(x)\n");
  EXPECT_THROW(run_gnuplot(folder / "wrong.gp"), std::runtime_error);
}

}  // namespace
}  // namespace verify
