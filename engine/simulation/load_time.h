// When loads and prescribed motions are looked up. A step takes them at its end; a static stage that finds its own
// steps takes no time, and there they go in a straight line from what they are at its start to what they are at its
// end.
#pragma once

namespace dda {

struct LoadTime {
  double from = 0, to = 0;  // s
  double share = 1;         // of the way between what is at these times

  static LoadTime at(double time) { return {time, time, 1}; }

  // `value(time)` returns a number or a vector, no expression.
  template <typename Value>
  [[nodiscard]] auto of(const Value& value) const {
    auto end = value(to);
    if (share >= 1) return end;
    const auto start = value(from);
    end -= start;
    end *= share;
    end += start;
    return end;
  }
};

}  // namespace dda
