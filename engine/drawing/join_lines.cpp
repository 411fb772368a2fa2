#include "engine/drawing/join_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/mend_lines.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"

namespace dda {
namespace {

constexpr double round_off_of_diagonal = 1e-12;  // ends and corners nearer than that are one, without a word

Box box_of(const std::vector<Vec2>& points) {
  Box box;
  for (const Vec2& point : points) box = expanded(box, point);
  return box;
}

bool same_points(const std::vector<Vec2>& a, const std::vector<Vec2>& b, bool turned, double reach) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if ((a[i] - b[turned ? b.size() - 1 - i : i]).norm() > reach) return false;
  }
  return true;
}

bool has_length(const OpenLine& line, double reach) {
  const Box box = box_of(line.points);
  return (box.upper - box.lower).norm() > reach;
}

Cleaned cleaned_line(Cleaning what, const OpenLine& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) length += (line.points[i] - line.points[i - 1]).norm();
  return {what, line.points.front(), line.points.back(), length, line.origin};
}

std::vector<OpenLine> with_length(std::vector<OpenLine> lines, double reach, std::vector<Cleaned>& cleaned) {
  for (const OpenLine& line : lines)
    if (!has_length(line, reach)) cleaned.push_back(cleaned_line(Cleaning::line_without_length, line));
  std::erase_if(lines, [reach](const OpenLine& line) { return !has_length(line, reach); });
  return lines;
}

std::vector<OpenLine> each_once(std::vector<OpenLine> lines, double reach, std::vector<Cleaned>& cleaned) {
  std::vector<Box> boxes;
  for (const OpenLine& line : lines) boxes.push_back(expanded(box_of(line.points), reach / 2));
  std::vector<bool> doubled(lines.size(), false);
  for (const auto& [i, j] : overlapping_pairs(boxes)) {
    const auto& a = lines[static_cast<std::size_t>(i)].points;
    const auto& b = lines[static_cast<std::size_t>(j)].points;
    if (same_points(a, b, false, reach) || same_points(a, b, true, reach)) doubled[static_cast<std::size_t>(j)] = true;
  }
  std::vector<OpenLine> kept;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (doubled[i])
      cleaned.push_back(cleaned_line(Cleaning::lines_overlap, lines[i]));
    else
      kept.push_back(std::move(lines[i]));
  }
  return kept;
}

// Ends 2 i and 2 i + 1 are those of line i.
class Joiner {
 public:
  Joiner(std::vector<OpenLine> lines, double reach) : reach_(reach) {
    lines_ = each_once(with_length(std::move(lines), reach, joined_.cleaned), reach, joined_.cleaned);
    Box box;
    for (const OpenLine& line : lines_) {
      for (const Vec2& point : line.points) box = expanded(box, point);
    }
    if (!is_empty(box)) round_off_ = round_off_of_diagonal * (box.upper - box.lower).norm();
  }

  Joined join() {
    find_partners();
    std::vector<bool> used(lines_.size(), false);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (is_ring(lines_[i])) {
        note_closing(2 * i + 1, 2 * i);
        add_ring({lines_[i].points.begin(), lines_[i].points.end() - 1}, lines_[i].origin);
        used[i] = true;
      }
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!used[i]) walk(i, used);
    }
    return std::move(joined_);
  }

 private:
  [[nodiscard]] bool is_ring(const OpenLine& line) const {
    return (line.points.front() - line.points.back()).norm() <= reach_;
  }

  [[nodiscard]] const Vec2& end(std::size_t number) const {
    const auto& points = lines_[number / 2].points;
    return number % 2 == 0 ? points.front() : points.back();
  }

  void find_partners() {
    partners_.assign(2 * lines_.size(), {});
    std::vector<Box> boxes(2 * lines_.size());  // those of closed lines stay empty and meet nothing
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!is_ring(lines_[i / 2])) boxes[i] = expanded(Box{end(i), end(i)}, reach_ / 2);
    }
    for (const auto& [i, j] : overlapping_pairs(boxes)) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      if ((end(a) - end(b)).norm() > reach_) continue;
      partners_[a].push_back(b);
      partners_[b].push_back(a);
    }
  }

  // From the end of a line on until it comes back to its start, or to a gap.
  void walk(std::size_t first, std::vector<bool>& used) {
    std::vector<Vec2> points;
    std::size_t from = 2 * first;
    while (true) {
      used[from / 2] = true;
      append(from, points);
      const std::size_t to = from ^ 1U;
      if (partners_[to].size() != 1 || partners_[partners_[to].front()].size() != 1) return note_gap(to);
      from = partners_[to].front();
      note_closing(to, from);
      if (from == 2 * first) break;
      if (used[from / 2]) return;  // a chain that began in its middle and has come to a gap before
    }
    add_ring(points, lines_[first].origin);
  }

  // The line entered at its end `from`, without its other end.
  void append(std::size_t from, std::vector<Vec2>& points) const {
    const auto& own = lines_[from / 2].points;
    if (from % 2 == 0)
      points.insert(points.end(), own.begin(), own.end() - 1);
    else
      points.insert(points.end(), own.rbegin(), own.rend() - 1);
  }

  // An end goes to the one that it meets.
  void note_closing(std::size_t from, std::size_t to) {
    note(Cleaning::gap_closed, end(from), end(to), lines_[from / 2].origin);
  }

  void note(Cleaning what, const Vec2& from, const Vec2& to, const std::string& origin) {
    const double size = (to - from).norm();
    if (size > round_off_) joined_.cleaned.push_back({what, from, to, size, origin});
  }

  void add_ring(const std::vector<Vec2>& points, const std::string& origin) {
    Ring ring;
    for (const Vec2& point : points) {
      if (ring.empty() || (point - ring.back()).norm() > reach_)
        ring.push_back(point);
      else
        note(Cleaning::short_edge_closed, point, ring.back(), origin);
    }
    while (ring.size() > 1 && (ring.front() - ring.back()).norm() <= reach_) {
      note(Cleaning::short_edge_closed, ring.back(), ring.front(), origin);
      ring.pop_back();
    }
    joined_.rings.push_back({std::move(ring), origin});
  }

  void note_gap(std::size_t at) {
    if (joined_.gap) return;
    const std::string& origin = lines_[at / 2].origin;
    if (!partners_[at].empty()) {
      joined_.gap = {origin, fmt::format("one of {} lines that meet at {}", partners_[at].size() + 1, written(end(at))),
                     "two at each corner of a closed line"};
      return;
    }
    joined_.gap = overshoot_at(lines_, at / 2, at % 2 == 1, reach_);
    if (!joined_.gap) joined_.gap = opening_at(at);
  }

  [[nodiscard]] Gap opening_at(std::size_t at) const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = at;
    for (std::size_t i = 0; i < partners_.size(); ++i) {
      const double distance = (end(i) - end(at)).norm();
      if (i == at || is_ring(lines_[i / 2]) || distance >= least) continue;
      least = distance;
      nearest = i;
    }
    return {lines_[at / 2].origin,
            fmt::format("open at {}, {:.4g} m from the nearest other end, of {}", written(end(at)), least,
                        lines_[nearest / 2].origin),
            "a closed line"};
  }

  std::vector<OpenLine> lines_;
  double reach_;
  double round_off_ = 0;                            // m
  std::vector<std::vector<std::size_t>> partners_;  // ends that each end meets
  Joined joined_;
};

}  // namespace

Joined join_lines(const std::vector<OpenLine>& lines, double reach) {
  Joined joined = Joiner(lines, reach).join();
  if (!joined.gap) return joined;
  MendedLines mended = mended_lines(lines, reach);
  Joined again = Joiner(std::move(mended.lines), reach).join();
  again.cleaned.insert(again.cleaned.begin(), mended.cleaned.begin(), mended.cleaned.end());
  return again;
}

std::string smaller_than_one_place(double reach) {
  return fmt::format("smaller than {:.4g} m, within which ends belong together", reach);
}

}  // namespace dda
