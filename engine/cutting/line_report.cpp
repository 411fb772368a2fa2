#include "engine/cutting/line_report.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double noticeable = 1e-3;  // of the tolerance: below it lies round-off

enum class Fate { cuts, overlaps, dangles };

// A part of a straight, in m from its start.
struct Stretch {
  int straight = 0;
  Fate fate = Fate::cuts;
  double from = 0;
  double to = 0;
};

class Lines {
 public:
  Lines(const Arrangement& arrangement, const FaceGroups& groups, const PlanPieces& pieces, const RockPlan& plan,
        std::vector<Cleaned>& cleaned)
      : arrangement_(arrangement), groups_(groups), pieces_(pieces), plan_(plan), cleaned_(cleaned) {}

  void report() {
    collect();
    cleaned_.reserve(cleaned_.size() + stretches_.size() + plan_.lines.size());
    std::vector<bool> used(plan_.lines.size(), false);
    for (const Stretch& stretch : stretches_) {
      if (stretch.fate != Fate::dangles) used[at(source(stretch).line)] = true;
      note(stretch);
    }
    for (std::size_t line = 0; line < used.size(); ++line) {
      const PlanLine& unused = plan_.lines[line];
      if (!used[line])
        cleaned_.push_back({Cleaning::line_not_used, unused.points.front(), unused.points.back(), 0, unused.origin});
    }
  }

 private:
  [[nodiscard]] const Source& source(const Stretch& stretch) const { return pieces_.sources[at(stretch.straight)]; }

  void collect() {
    for (int edge = 0; edge < arrangement_.edges(); ++edge) {
      const int left = groups_.of(arrangement_.face(2 * edge));
      const int right = groups_.of(arrangement_.face(2 * edge + 1));
      if (left == FaceGroups::outside || right == FaceGroups::outside) continue;
      const int counting = counting_straight(arrangement_, edge, pieces_, plan_);
      for (const int straight : arrangement_.straights(edge)) {
        if (pieces_.sources[at(straight)].line == no_line) continue;
        const bool counts = straight == counting || pieces_.sources[at(counting)].line == no_line;
        append(edge, straight, left == right ? Fate::dangles : (counts ? Fate::cuts : Fate::overlaps));
      }
    }
    join();
  }

  void append(int edge, int straight, Fate fate) {
    const Straight& line = pieces_.straights[at(straight)];
    const Vec2 along = (line.to - line.from).normalized();
    const auto way = [&](int half_edge) {
      const Vec2& place = arrangement_.position(arrangement_.origin(half_edge));
      // As if it were prolonged there: what dangles then ends at the end that was drawn, not beside it by round-off.
      if (pieces_.ends_alone[at(straight)] && place == line.to) return (line.to - line.from).norm() + pieces_.tolerance;
      return along.dot(place - line.from);
    };
    const auto [from, to] = std::minmax({way(2 * edge), way(2 * edge + 1)});
    stretches_.push_back({straight, fate, from, to});
  }

  // Stretches of one kind that follow each other become one.
  void join() {
    const auto key = [](const Stretch& s) { return std::tuple(s.straight, s.fate, s.from); };
    std::sort(stretches_.begin(), stretches_.end(),
              [&](const Stretch& a, const Stretch& b) { return key(a) < key(b); });
    std::size_t last = 0;
    for (std::size_t i = 1; i < stretches_.size(); ++i) {
      Stretch& before = stretches_[last];
      const Stretch& each = stretches_[i];
      const bool follows = each.straight == before.straight && each.fate == before.fate &&
                           each.from <= before.to + noticeable * pieces_.tolerance;
      if (follows)
        before.to = each.to;
      else
        stretches_[++last] = each;
    }
    if (!stretches_.empty()) stretches_.resize(last + 1);
  }

  void note(const Stretch& stretch) {
    const Straight& line = pieces_.straights[at(stretch.straight)];
    const double length = (line.to - line.from).norm();
    if (stretch.fate == Fate::cuts) {
      add(Cleaning::end_prolonged, stretch, stretch.from, 0);
      add(Cleaning::end_prolonged, stretch, length, stretch.to);
      return;
    }
    const Cleaning what = stretch.fate == Fate::dangles ? Cleaning::dangle_trimmed : Cleaning::lines_overlap;
    add(what, stretch, std::max(stretch.from, 0.0), std::min(stretch.to, length));
  }

  void add(Cleaning what, const Stretch& stretch, double from, double to) {
    if (to - from <= noticeable * pieces_.tolerance) return;
    const Straight& line = pieces_.straights[at(stretch.straight)];
    const Vec2 along = (line.to - line.from).normalized();
    cleaned_.push_back({what, line.from + from * along, line.from + to * along, to - from,
                        plan_.lines[at(source(stretch).line)].origin});
  }

  const Arrangement& arrangement_;
  const FaceGroups& groups_;
  const PlanPieces& pieces_;
  const RockPlan& plan_;
  std::vector<Cleaned>& cleaned_;
  std::vector<Stretch> stretches_;
};

// The higher counts.
std::tuple<int, int> rank(const Source& source, const RockPlan& plan) {
  if (source.line == no_line) return {source.curve >= curve_of_opening(plan, 0) ? 2 : 0, source.curve};
  return {plan.lines[at(source.line)].construction ? 1 : 3, source.line};
}

// Whether the line was drawn there, and not only prolonged.
bool is_drawn_along(const Arrangement& arrangement, int edge, const Straight& line) {
  const Vec2 middle =
      (arrangement.position(arrangement.origin(2 * edge)) + arrangement.position(arrangement.target(2 * edge))) / 2;
  const Vec2 along = line.to - line.from;
  const double way = along.dot(middle - line.from);
  return way >= 0 && way <= along.squaredNorm();
}

}  // namespace

int counting_straight(const Arrangement& arrangement, int edge, const PlanPieces& pieces, const RockPlan& plan) {
  const auto straights = arrangement.straights(edge);
  if (straights.size() == 1) return straights.front();
  const auto importance = [&](int straight) {
    return std::tuple(is_drawn_along(arrangement, edge, pieces.straights[at(straight)]),
                      rank(pieces.sources[at(straight)], plan));
  };
  return *std::max_element(straights.begin(), straights.end(),
                           [&](int a, int b) { return importance(a) < importance(b); });
}

const std::string& joint_of(const Source& source, const RockPlan& plan) {
  static const std::string default_joint;
  if (source.line != no_line) return plan.lines[at(source.line)].joint;
  const int opening = source.curve - curve_of_opening(plan, 0);
  return opening < 0 ? default_joint : plan.openings[at(opening)].joint;
}

void report_lines(const Arrangement& arrangement, const FaceGroups& groups, const PlanPieces& pieces,
                  const RockPlan& plan, std::vector<Cleaned>& cleaned) {
  Lines(arrangement, groups, pieces, plan, cleaned).report();
}

}  // namespace dda
