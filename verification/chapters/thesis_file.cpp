#include "verification/chapters/thesis_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "verification/study/markdown.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;
constexpr auto file_name = "thesis.json";

Json json_of(const Finding& finding) {
  return std::visit([](const auto& value) { return Json(value); }, finding);
}

Json json_of(const Statement& statement) {
  return {{"chapter", statement.chapter},
          {"id", statement.id},
          {"statement", statement.statement},
          {"thesis", json_of(statement.thesis)},
          {"ours", json_of(statement.ours)},
          {"unit", statement.unit},
          {"confirmed", statement.confirmed ? Json(*statement.confirmed) : Json(nullptr)},
          {"reason", statement.reason}};
}

Json parsed(std::string_view before) {
  if (before.empty()) return {{"statements", Json::array()}, {"assumptions", Json::array()}};
  Json json = Json::parse(before, nullptr, false);
  if (!json.is_object() || !json.contains("statements") || !json.contains("assumptions"))
    throw dda::InputError(file_name, "", "no file of this command", "one with statements and assumptions, or none");
  return json;
}

// The entries of other chapters and the new ones, by number of chapter.
Json merged(const Json& before, int chapter, const Json& entries) {
  Json all = Json::array();
  for (const Json& entry : before)
    if (entry.at("chapter") != chapter) all.push_back(entry);
  for (const Json& entry : entries) all.push_back(entry);
  std::stable_sort(all.begin(), all.end(), [](const Json& a, const Json& b) {
    return a.at("chapter").get<int>() < b.at("chapter").get<int>();
  });
  return all;
}

std::string text_of(const Finding& finding, const std::string& unit) {
  if (const auto* words = std::get_if<std::string>(&finding)) return *words;
  return fmt::format("{:.4g}{}{}", std::get<double>(finding), unit.empty() ? "" : " ", unit);
}

std::string verdict(const std::optional<bool>& confirmed) {
  if (!confirmed) return "not judged";
  return *confirmed ? "**confirmed**" : "**not confirmed**";
}

Table verdicts(const Chapter& chapter) {
  Table table{"", {}, {"statement", "thesis", "this engine", "verdict"}, {}, false, {}};
  for (const Statement& s : chapter.statements)
    table.rows.push_back({s.statement, text_of(s.thesis, s.unit), text_of(s.ours, s.unit), verdict(s.confirmed)});
  return table;
}

Bullets reasons(const Chapter& chapter) {
  Bullets bullets;
  for (const Statement& s : chapter.statements)
    bullets.items.push_back(fmt::format("`{}` {}: {}", s.id, verdict(s.confirmed), s.reason));
  return bullets;
}

}  // namespace

std::string with_chapter(std::string_view before, const Chapter& chapter) {
  Json json = parsed(before);
  Json statements = Json::array();
  for (const Statement& statement : chapter.statements) statements.push_back(json_of(statement));
  Json assumptions = Json::array();
  for (const std::string& text : chapter.assumptions)
    assumptions.push_back({{"chapter", chapter.number}, {"assumption", text}});
  json["statements"] = merged(json["statements"], chapter.number, statements);
  json["assumptions"] = merged(json["assumptions"], chapter.number, assumptions);
  return json.dump(1) + "\n";
}

Document chapter_page(const Chapter& chapter) {
  Document page;
  page.title = chapter.title;
  page.subtitle = fmt::format(
      "R. Zelig, Rockbursts simulations with the numerical DDA method (2015), statement by statement; made by "
      "`dda-verify thesis --chapter {} --out DIR`",
      chapter.number);
  page.sections.push_back({"Statements", {verdicts(chapter)}});
  page.sections.push_back({"How each was judged", {reasons(chapter)}});
  page.sections.push_back({"Assumptions where the text is silent", {Bullets{chapter.assumptions}}});
  for (const Section& section : chapter.sections) page.sections.push_back(section);
  if (!chapter.failures.empty()) page.sections.push_back({"Runs that failed", {Bullets{chapter.failures}}});
  return page;
}

void write_chapter(const std::filesystem::path& folder, const Chapter& chapter) {
  std::filesystem::create_directories(folder);
  const auto file = folder / file_name;
  const std::string before = std::filesystem::exists(file) ? dda::read_file(file) : "";
  dda::write_file(file, with_chapter(before, chapter));
  for (const PageFigure& figure : chapter.figures) dda::write_file(folder / figure.file, figure.svg);
  dda::write_file(folder / fmt::format("chapter_{}.md", chapter.number), to_markdown(chapter_page(chapter)));
}

}  // namespace verify
