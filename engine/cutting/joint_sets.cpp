#include "engine/cutting/joint_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/core/error.h"
#include "engine/geometry/box.h"
#include "engine/geometry/segment_crossing.h"

namespace dda {
namespace {

struct Trace {
  Segment segment;
  std::size_t set = 0;
};

std::vector<Segment> parts_inside(const Segment& segment, const Ring& region) {
  if (region.empty()) return {segment};
  std::vector<double> shares{0, 1};
  for (std::size_t i = 0; i < region.size(); ++i) {
    if (const auto share = share_at_inner_crossing(segment, {region[i], region[(i + 1) % region.size()]}))
      shares.push_back(*share);
  }
  std::sort(shares.begin(), shares.end());
  std::vector<Segment> parts;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    if (!contains({region, {}}, point_at(segment, (shares[i - 1] + shares[i]) / 2))) continue;
    parts.push_back({point_at(segment, shares[i - 1]), point_at(segment, shares[i])});
  }
  return parts;
}

// Draws the lines of one set in a frame with x along the mean direction and its origin on the first line.
class SetDrawer {
 public:
  SetDrawer(const JointSet& set, std::size_t number, const Box& box, std::uint64_t seed)
      : set_(set),
        number_(number),
        box_(box),
        random_(seed, number),
        along_(std::cos(set.dip.mean), std::sin(set.dip.mean)) {
    const Vec2 middle = (box.lower + box.upper) / 2;
    const double diagonal = (box.upper - box.lower).norm();
    across_ = {-along_.y(), along_.x()};
    origin_ = set.start ? *set.start : Vec2(middle + diagonal * random_.uniform() * (along_ + across_));
    for (const Vec2& corner :
         {box.lower, box.upper, Vec2(box.lower.x(), box.upper.y()), Vec2(box.upper.x(), box.lower.y())})
      frame_ = expanded(frame_, Vec2((corner - origin_).dot(along_), (corner - origin_).dot(across_)));
    // Traces that turn come in from lines beyond the box.
    const double room = set.length ? reach(*set.length) / 2 : diagonal / 2;
    frame_ = expanded(frame_, turns() ? room : 0);
  }

  std::vector<Trace> draw() {
    refuse_far_start();
    const Vec2 size = frame_.upper - frame_.lower;
    const double on_a_line = set_.length ? 1 + size.x() / (set_.length->mean + set_.bridge.mean) : 1;
    if (size.y() / set_.spacing.mean * on_a_line > static_cast<double>(most_traces)) refuse();
    add_line(0);
    for (double height = 0; height < frame_.upper.y();) add_line(height += random_.positive_sample(set_.spacing));
    for (double height = 0; height > frame_.lower.y();) add_line(height -= random_.positive_sample(set_.spacing));
    return std::move(traces_);
  }

 private:
  [[nodiscard]] bool turns() const { return set_.dip.spread != Spread::none; }

  static double reach(const RandomQuantity& length) {
    const double tail = length.spread == Spread::none ? 1 : 5;
    return tail * (length.mean + length.deviation);
  }

  [[noreturn]] void refuse() const {
    throw InputError("", set_.origin, fmt::format("a set of more than {} traces", most_traces),
                     "a wider spacing or longer traces");
  }

  // Lines and traces are drawn from the start on, those outside the rock too.
  void refuse_far_start() const {
    const double lines = std::max(frame_.upper.y(), -frame_.lower.y()) / set_.spacing.mean;
    const double traces =
        set_.length ? std::max(frame_.upper.x(), -frame_.lower.x()) / (set_.length->mean + set_.bridge.mean) : 0;
    if (set_.start && std::max(lines, traces) > static_cast<double>(most_traces))
      throw InputError("", set_.origin + ".start", fmt::format("({:g}, {:g}) m", set_.start->x(), set_.start->y()),
                       fmt::format("a place nearer to the rock: there are more than {} traces between", most_traces));
  }

  void add_line(double height) {
    if (height < frame_.lower.y() || height > frame_.upper.y()) return;
    if (!set_.length) {
      add_trace(height, frame_.lower.x(), frame_.upper.x());
      return;
    }
    const double first = random_.positive_sample(*set_.length);
    const double period = set_.length->mean + set_.bridge.mean;
    const double middle = set_.start ? 0 : period * random_.uniform();
    add_trace(height, middle - first / 2, middle + first / 2);
    for (double end = middle + first / 2; end < frame_.upper.x();) {
      const double from = end + std::max(0.0, random_.sample(set_.bridge));
      end = from + random_.positive_sample(*set_.length);
      add_trace(height, from, end);
    }
    for (double end = middle - first / 2; end > frame_.lower.x();) {
      const double from = end - std::max(0.0, random_.sample(set_.bridge));
      end = from - random_.positive_sample(*set_.length);
      add_trace(height, end, from);
    }
  }

  // A trace that runs through the whole rock goes on far enough to do so after it has turned.
  void add_trace(double height, double from, double to) {
    const double turn = turns() ? random_.sample(set_.dip) : set_.dip.mean;
    if (to < frame_.lower.x() || from > frame_.upper.x()) return;
    if (traces_.size() == most_traces) refuse();
    const Vec2 middle = origin_ + (from + to) / 2 * along_ + height * across_;
    const double half = set_.length ? (to - from) / 2 : (frame_.upper - frame_.lower).norm();
    const Vec2 way = half * Vec2(std::cos(turn), std::sin(turn));
    const Segment trace{middle - way, middle + way};
    if (!overlap(box_, expanded(expanded(Box{}, trace.start), trace.end))) return;
    for (const Segment& part : parts_inside(trace, set_.region)) traces_.push_back({part, number_});
  }

  const JointSet& set_;
  std::size_t number_;
  Box box_;  // of the rock
  RandomStream random_;
  Vec2 along_, across_, origin_;
  Box frame_;
  std::vector<Trace> traces_;
};

// From its middle on, a trace goes both ways up to the first trace of the sets at which it ends.
Segment ended(const Segment& trace, const std::vector<Trace>& earlier, const std::vector<std::size_t>& sets) {
  double from = 0;
  double to = 1;
  const Box box = expanded(expanded(Box{}, trace.start), trace.end);
  for (const Trace& other : earlier) {
    if (std::find(sets.begin(), sets.end(), other.set) == sets.end()) continue;
    if (!overlap(box, expanded(expanded(Box{}, other.segment.start), other.segment.end))) continue;
    const auto share = share_at_inner_crossing(trace, other.segment);
    if (!share) continue;
    if (*share < 0.5)
      from = std::max(from, *share);
    else
      to = std::min(to, *share);
  }
  return {point_at(trace, from), point_at(trace, to)};
}

std::vector<std::size_t> numbers_of(const JointSet& set, const std::vector<JointSet>& sets, std::size_t before) {
  std::vector<std::size_t> numbers;
  for (const std::string& name : set.ends_at) {
    const auto end = sets.begin() + static_cast<std::ptrdiff_t>(before);
    const auto found = std::find_if(sets.begin(), end, [&](const JointSet& other) { return other.name == name; });
    if (found == end) throw InputError("", set.origin + ".ends_at", "\"" + name + "\"", "the name of an earlier set");
    numbers.push_back(static_cast<std::size_t>(found - sets.begin()));
  }
  return numbers;
}

}  // namespace

std::vector<PlanLine> traces_of(const std::vector<JointSet>& sets, const Ring& boundary, std::uint64_t seed) {
  const Box box = bounding_box(boundary);
  std::vector<Trace> traces;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::vector<Trace> own = SetDrawer(sets[i], i, box, seed).draw();
    const std::vector<std::size_t> ends_at = numbers_of(sets[i], sets, i);
    if (!ends_at.empty()) {
      for (Trace& trace : own) trace.segment = ended(trace.segment, traces, ends_at);
    }
    traces.insert(traces.end(), own.begin(), own.end());
  }
  std::vector<PlanLine> lines;
  for (const Trace& trace : traces) {
    const JointSet& set = sets[trace.set];
    lines.push_back({{trace.segment.start, trace.segment.end}, set.joint, set.origin, false});
  }
  return lines;
}

}  // namespace dda
