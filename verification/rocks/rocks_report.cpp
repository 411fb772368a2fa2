#include "verification/rocks/rocks_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/view/svg_path.h"
#include "verification/study/markdown.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

std::vector<RockResult> of_kind(const std::vector<RockResult>& results, RockKind kind) {
  std::vector<RockResult> some;
  std::ranges::copy_if(results, std::back_inserter(some), [&](const RockResult& one) { return one.kind == kind; });
  return some;
}

std::string median_and_most(std::vector<double> values) {
  if (values.empty()) return "";
  std::ranges::sort(values);
  const auto written = [](double value) {
    return value < 10 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
  };
  return written(values[values.size() / 2]) + " / " + written(values.back());
}

std::vector<std::string> row_of(const std::string& name, const std::vector<RockResult>& results) {
  std::vector<std::string> row{name, std::to_string(results.size())};
  for (const auto& [outcome, known] : rock_outcomes()) row.push_back(std::to_string(count_of(results, outcome)));
  std::vector<double> blocks, settling, all;
  for (const RockResult& result : results) {
    blocks.push_back(static_cast<double>(result.blocks));
    settling.push_back(result.settling_s);
    all.push_back(result.cpu_s);
  }
  row.insert(row.end(), {median_and_most(blocks), median_and_most(settling), median_and_most(all)});
  return row;
}

Table table_of(const std::vector<RockResult>& results) {
  Table table;
  table.caption = "Rocks by kind; blocks, CPU seconds until settled and in all as median / most";
  table.header = {"kind", "rocks"};
  for (const auto& [outcome, known] : rock_outcomes()) table.header.push_back(known);
  table.header.insert(table.header.end(), {"blocks", "settled after (s)", "in all (s)"});
  for (const RockKind kind : all_rock_kinds) table.rows.push_back(row_of(name_of(kind), of_kind(results, kind)));
  table.rows.push_back(row_of("all", results));
  return table;
}

// The largest value that any rock has of each measure, and of how many it is beyond what is allowed.
Table measures(const std::vector<RockResult>& results) {
  Table table;
  table.header = {"measure", "allowed", "largest", "beyond"};
  std::vector<Check> worst;
  std::vector<int> beyond;
  for (const RockResult& result : results)
    for (const Check& check : result.checks) {
      const auto known = std::ranges::find(worst, check.what, &Check::what);
      const auto at = static_cast<std::size_t>(known - worst.begin());
      if (known == worst.end()) {
        worst.push_back(check);
        beyond.push_back(0);
      }
      worst[at].value = std::max(worst[at].value, check.value);
      beyond[at] += check.holds() ? 0 : 1;
    }
  for (std::size_t i = 0; i < worst.size(); ++i)
    table.rows.push_back({worst[i].what, fmt::format("{:.2g}", worst[i].allowed), fmt::format("{:.2g}", worst[i].value),
                          std::to_string(beyond[i])});
  return table;
}

Section gallery(const std::vector<RockResult>& results) {
  Section section;
  section.title = "One of each kind";
  section.pieces.emplace_back(
      Paragraph{"As drawn, and at the end, with displacements as they are. Grey: held. Orange: what nothing held while "
                "the others settled."});
  for (const RockKind kind : all_rock_kinds) {
    const auto shown = std::ranges::find_if(
        results, [&](const RockResult& result) { return result.kind == kind && result.outcome == RunOutcome::right; });
    if (shown == results.end()) continue;
    const std::string caption = fmt::format("{}, seed {}, {} blocks", name_of(kind), shown->seed, shown->blocks);
    section.pieces.emplace_back(Figure{"images/" + picture_of(kind), caption});
  }
  return section;
}

Section not_right(const std::vector<RockResult>& results) {
  Bullets bullets;
  for (const RockResult& result : results)
    if (result.outcome != RunOutcome::right)
      bullets.items.push_back(fmt::format("**{}**, seed {} ({}, {} blocks): {}", name_of(result.outcome), result.seed,
                                          name_of(result.kind), result.blocks, result.reason()));
  if (bullets.items.empty()) bullets.items.emplace_back("none");
  Section section;
  section.title = "Rocks that are not right";
  section.pieces.emplace_back(std::move(bullets));
  return section;
}

// A half of a picture: all outlines in a square of `side` from `left` on.
class Half {
 public:
  Half(const std::vector<dda::Polygon>& drawn, double side, double left) : left_(left) {
    low_ = high_ = drawn.front().outer.front();
    for (const dda::Polygon& outline : drawn)
      for (const dda::Vec2& corner : outline.outer) {
        low_ = low_.cwiseMin(corner);
        high_ = high_.cwiseMax(corner);
      }
    scale_ = side / (high_ - low_).maxCoeff();
  }

  [[nodiscard]] double height() const { return scale_ * (high_ - low_).y(); }

  [[nodiscard]] std::string path(const dda::Polygon& outline, const char* fill) const {
    dda::SvgPath path;
    const auto add = [&](const dda::Ring& ring) {
      path.move_to(place_of(ring.front()));
      for (const dda::Vec2& corner : std::span(ring).subspan(1)) path.line_to(place_of(corner));
      path.close();
    };
    add(outline.outer);
    for (const dda::Ring& hole : outline.holes) add(hole);
    return fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path.text(), fill);
  }

 private:
  [[nodiscard]] dda::Vec2 place_of(const dda::Vec2& point) const {
    return {left_ + scale_ * (point.x() - low_.x()), scale_ * (high_.y() - point.y())};
  }

  double left_, scale_ = 1;
  dda::Vec2 low_, high_;
};

std::string outlines(const Half& half, const std::vector<dda::Polygon>& shapes, const std::vector<bool>& left_out,
                     const RockPicture& picture) {
  std::string svg;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (!left_out[i])
      svg += half.path(shapes[i], picture.is_held[i] ? "#bbbbbb" : picture.is_loose[i] ? "#E69F00" : "#e8dcc8");
  return svg;
}

}  // namespace

std::string picture_of(RockKind kind) {
  std::string name = name_of(kind);
  std::ranges::replace(name, ' ', '_');
  return "rocks_" + name + ".svg";
}

Json json_of(const RockResult& result) {
  Json json = {{"seed", result.seed},     {"kind", name_of(result.kind)},    {"outcome", name_of(result.outcome)},
               {"blocks", result.blocks}, {"loose", result.loose},           {"steps", result.steps},
               {"passes", result.passes}, {"settling_s", result.settling_s}, {"cpu_s", result.cpu_s}};
  add_reasons(result, json);
  return json;
}

RockResult rock_result_from(const Json& json) {
  RockResult result;
  result.seed = json.at("seed");
  result.kind = *std::ranges::find(all_rock_kinds, json.at("kind").get<std::string>(),
                                   [](RockKind kind) { return std::string(name_of(kind)); });
  const auto outcome =
      std::ranges::find(rock_outcomes(), json.at("outcome").get<std::string>(), &OutcomeNames::value_type::second);
  result.outcome = outcome->first;
  result.blocks = json.at("blocks");
  result.loose = json.at("loose");
  result.steps = json.at("steps");
  result.passes = json.at("passes");
  result.settling_s = json.at("settling_s");
  result.cpu_s = json.at("cpu_s");
  read_reasons(json, result);
  return result;
}

std::string to_json(const std::vector<RockResult>& results) {
  std::string text = "{\"rocks\": [\n";
  for (const RockResult& result : results) text += json_of(result).dump() + (&result == &results.back() ? "\n" : ",\n");
  return text + "]}\n";
}

std::string to_page(const std::vector<RockResult>& results) {
  Document document;
  document.title = "Random rock";
  Section& first = document.sections.emplace_back();
  first.title = "What becomes of it";
  first.pieces.emplace_back(Paragraph{fmt::format(
      "{} rocks cut by lot, seeds {} to {}, which settle by steps that the engine finds and then move. Made by "
      "`dda-verify rocks`; [how they are judged](../verification/rocks/README.md).",
      results.size(), results.front().seed, results.back().seed)});
  first.pieces.emplace_back(table_of(results));
  first.pieces.emplace_back(measures(results));
  document.sections.push_back(gallery(results));
  document.sections.push_back(not_right(results));
  return to_markdown(document);
}

std::string to_svg(const RockPicture& picture) {
  constexpr double side = 360, gap = 20;  // px
  const Half drawn(picture.drawn, side, 0), moved(picture.drawn, side, side + gap);
  const double width = 2 * side + gap;
  const std::vector<bool> none(picture.drawn.size(), false);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-2 -2 {0:g} {1:.0f}\" width=\"{0:g}\" "
             "height=\"{1:.0f}\" "
             "stroke=\"#333333\" stroke-width=\"0.6\" stroke-linejoin=\"round\">\n",
             width + 4, drawn.height() + 4) +
         outlines(drawn, picture.drawn, none, picture) + outlines(moved, picture.moved, picture.is_removed, picture) +
         "</svg>\n";
}

}  // namespace verify
