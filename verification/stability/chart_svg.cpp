#include <fmt/format.h>

#include <map>

#include "verification/stability/chart.h"

namespace verify {
namespace {

constexpr int side = 12;  // px, of a cell
constexpr int left_margin = 80, top_margin = 48, between = 14, bottom_margin = 64;

// Okabe & Ito 2008, which colour-blind readers can tell apart.
const char* colour_of(RunOutcome outcome) {
  switch (outcome) {
    case RunOutcome::right: return "#009E73";
    case RunOutcome::warned: return "#F0E442";
    case RunOutcome::stopped: return "#56B4E9";
    case RunOutcome::refused: return "#999999";
    case RunOutcome::silent: return "#D55E00";
    case RunOutcome::late: break;  // cells are not timed out
  }
  return "";
}

struct Axis {
  std::string title;
  std::vector<double> values;
  double Setting::*value;
};

std::string text(double x, double y, const std::string& words, const std::string& more = "") {
  return fmt::format("<text x=\"{:g}\" y=\"{:g}\"{}>{}</text>\n", x, y, more, words);
}

class Maps {
 public:
  Maps(const ChartGrid& grid, Axis across, Axis upwards)
      : grid_(grid),
        across_(std::move(across)),
        upwards_(std::move(upwards)),
        width_(side * static_cast<int>(across_.values.size())),
        height_(side * static_cast<int>(upwards_.values.size())) {}

  [[nodiscard]] std::string svg(const std::vector<Cell>& cells) const {
    const int columns = static_cast<int>(grid_.integrators.size());
    const int rows = static_cast<int>(all_problems.size());
    const int width = left_margin + columns * (width_ + between), height = bottom() + bottom_margin;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"10\" text-anchor=\"middle\">\n<rect width=\"{0}\" height=\"{1}\" "
        "fill=\"white\"/>\n",
        width, height);
    svg += squares(cells);
    for (int column = 0; column < columns; ++column) svg += head(column);
    for (int row = 0; row < rows; ++row) svg += ticks(row);
    return svg + legend(cells) + "</svg>\n";
  }

 private:
  [[nodiscard]] int left(int column) const { return left_margin + column * (width_ + between); }
  [[nodiscard]] int top(int row) const { return top_margin + row * (height_ + between); }
  [[nodiscard]] int bottom() const { return top(static_cast<int>(all_problems.size())) - between; }

  template <typename List, typename Value>
  static int index_in(const List& list, const Value& value) {
    return static_cast<int>(std::ranges::find(list, value) - list.begin());
  }

  // One path a colour: a file of some kB for thousands of cells.
  [[nodiscard]] std::string squares(const std::vector<Cell>& cells) const {
    std::map<RunOutcome, std::string> paths;
    for (const Cell& cell : cells) {
      const int x = left(index_in(grid_.integrators, cell.setting.integrator)) +
                    side * index_in(across_.values, cell.setting.*across_.value);
      const int y = top(index_in(all_problems, cell.setting.problem)) + height_ -
                    side * (1 + index_in(upwards_.values, cell.setting.*upwards_.value));
      paths[cell.outcome] += fmt::format("M{} {}h{}v{}h-{}z", x, y, side - 1, side - 1, side - 1);
    }
    std::string all;
    for (const auto& [outcome, path] : paths)
      all += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", colour_of(outcome), path);
    return all;
  }

  [[nodiscard]] std::string head(int column) const {
    const double middle = left(column) + width_ / 2.0;
    std::string words = grid_.integrators[static_cast<std::size_t>(column)];
    const std::size_t space = words.find(' ');
    std::string head = text(middle, top_margin - 20, words.substr(0, space));
    if (space != std::string::npos) head += text(middle, top_margin - 8, words.substr(space + 1));
    head += text(left(column) + side / 2.0, bottom() + 12, fmt::format("{:g}", across_.values.front()));
    head += text(left(column) + width_ - side / 2.0, bottom() + 12, fmt::format("{:g}", across_.values.back()));
    return head + text(middle, bottom() + 26, across_.title);
  }

  [[nodiscard]] std::string ticks(int row) const {
    const std::string right = " text-anchor=\"end\"";
    const double low = top(row) + height_ - 2, high = top(row) + side - 2;
    return text(left_margin - 4, low, fmt::format("{:g}", upwards_.values.front()), right) +
           text(left_margin - 4, high, fmt::format("{:g}", upwards_.values.back()), right) +
           text(left_margin - 4, (low + high) / 2, upwards_.title, right) +
           text(12, (low + high) / 2, name_of(all_problems[static_cast<std::size_t>(row)]),
                fmt::format(" font-weight=\"bold\" transform=\"rotate(-90 12 {:g})\"", (low + high) / 2));
  }

  [[nodiscard]] std::string legend(const std::vector<Cell>& cells) const {
    std::string legend;
    double x = left_margin;
    const double y = bottom() + bottom_margin - 24;
    for (const auto& [outcome, name] : cell_outcomes()) {
      const std::string words = fmt::format("{} ({})", name, count_of(cells, outcome));
      legend += fmt::format("<rect x=\"{:g}\" y=\"{:g}\" width=\"11\" height=\"11\" fill=\"{}\"/>\n", x, y,
                            colour_of(outcome));
      legend += text(x + 15, y + 9, words, " text-anchor=\"start\"");
      x += 30 + 6.0 * static_cast<double>(words.size());
    }
    return legend;
  }

  const ChartGrid& grid_;
  Axis across_, upwards_;
  int width_, height_;  // px, of one map
};

}  // namespace

std::string steps_svg(const StabilityChart& chart) {
  const Axis dt{"dt, s", chart.grid.dts, &Setting::dt};
  const Axis penalty{"penalty/E", chart.grid.penalties, &Setting::penalty};
  return Maps(chart.grid, dt, penalty).svg(chart.steps);
}

std::string blocks_svg(const StabilityChart& chart) {
  const Axis aspect{"aspect", chart.grid.aspects, &Setting::aspect};
  const Axis mass_ratio{"mass ratio", chart.grid.mass_ratios, &Setting::mass_ratio};
  return Maps(chart.grid, aspect, mass_ratio).svg(chart.blocks);
}

}  // namespace verify
