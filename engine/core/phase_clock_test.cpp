#include "engine/core/phase_clock.h"

#include <gtest/gtest.h>

#include <thread>

namespace dda {
namespace {

// A clock that the tests set, ns.
std::int64_t time_now = 0;
std::int64_t set_time() { return time_now; }

PhaseCost cost(const PhaseClock& clock, Phase phase) { return clock.costs()[static_cast<std::size_t>(phase)]; }

TEST(PhaseClock, CountsTheInnermostPhaseAlone) {
  time_now = 1000;
  PhaseClock clock(set_time);
  time_now += 5;
  {
    const PhaseScope solution(Phase::solution);
    time_now += 10;
    for (int i = 0; i < 3; ++i) {
      const PhaseScope product(Phase::product);
      time_now += 100;
    }
    time_now += 20;
  }
  time_now += 2;
  EXPECT_EQ(cost(clock, Phase::solution).nanoseconds, 30);
  EXPECT_EQ(cost(clock, Phase::solution).calls, 1);
  EXPECT_EQ(cost(clock, Phase::product).nanoseconds, 300);
  EXPECT_EQ(cost(clock, Phase::product).calls, 3);
  EXPECT_EQ(cost(clock, Phase::other).nanoseconds, 7);
  EXPECT_EQ(clock.nanoseconds(), 337);
}

TEST(PhaseClock, PhasesAddUpToTheWhole) {
  PhaseClock clock(set_time);
  const PhaseScope still_open(Phase::stage);
  for (const PhaseName& each : phase_names) {
    const PhaseScope scope(each.phase);
    time_now += 17;
    const PhaseScope again(each.phase);  // a phase may lie within itself: halves of a step do
    time_now += 4;
  }
  time_now += 3;
  std::int64_t sum = 0;
  for (const PhaseCost& each : clock.costs()) sum += each.nanoseconds;
  EXPECT_EQ(sum, clock.nanoseconds());
  EXPECT_EQ(sum, 21 * static_cast<std::int64_t>(phase_names.size()) + 3);
}

TEST(PhaseClock, EventsLieWithinEachOtherAndEndSomewhere) {
  PhaseClock clock(set_time);
  {
    const PhaseScope outer(Phase::solution);
    time_now += 1;
    const PhaseScope inner(Phase::product);
    time_now += 5;
  }
  ASSERT_EQ(clock.events().size(), 2U);
  EXPECT_EQ(clock.events()[0].phase, Phase::product);
  EXPECT_EQ(clock.events()[0].begin, 1);
  EXPECT_EQ(clock.events()[0].duration, 5);
  EXPECT_EQ(clock.events()[1].duration, 6);
  for (std::size_t i = 0; i < PhaseClock::most_events; ++i) const PhaseScope scope(Phase::rows);
  EXPECT_EQ(clock.events().size(), PhaseClock::most_events);
  EXPECT_EQ(clock.events_left_out(), 2);
}

TEST(PhaseClock, WithoutOneNothingIsMeasuredAndOtherThreadsAreNotSeen) {
  EXPECT_EQ(PhaseClock::current(), nullptr);
  const PhaseScope nowhere(Phase::assembly);
  {
    const PhaseClock clock(set_time);
    EXPECT_EQ(PhaseClock::current(), &clock);
    std::thread([] {
      EXPECT_EQ(PhaseClock::current(), nullptr);
      const PhaseScope elsewhere(Phase::assembly);
    }).join();
    EXPECT_EQ(cost(clock, Phase::assembly).calls, 0);
  }
  EXPECT_EQ(PhaseClock::current(), nullptr);
}

}  // namespace
}  // namespace dda
