#include "engine/record/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dda {
namespace {

TEST(Progress, WithoutOutputTheClockIsNotRead) {
  int looks = 0;
  {
    Progress progress(0, 1, nullptr, [&] { return double(++looks); });
    for (int step = 1; step < 100; ++step) progress.update(0.01 * step, step);
    progress.finish(1, 100);
  }
  EXPECT_EQ(looks, 0);
}

TEST(Progress, DrawsAtMostTenTimesASecond) {
  std::ostringstream output;
  double now = 1000;
  Progress progress(0, 1, &output, [&] { return now; });
  for (int step = 1; step <= 10'000; ++step) {  // two seconds
    now += 2e-4;
    progress.update(1e-4 * step, step);
  }
  const std::string text = output.str();
  const auto drawings = std::count(text.begin(), text.end(), '\r');
  EXPECT_GE(drawings, 19);  // one of them before the first step
  EXPECT_LE(drawings, 21);
}

TEST(Progress, ShowsShareTimePaceAndTimeLeft) {
  std::ostringstream output;
  double now = 5;
  {
    Progress progress(0.1, 0.5, &output, [&] { return now; });
    output.str("");
    progress.update(0.1, 101);  // a run that goes on after step 100
    now += 30;
    progress.update(0.2, 400);
  }
  EXPECT_EQ(output.str(), "\r[##        ]  25 %  0.2 of 0.5 s  10 steps/s  1:30 left\x1b[K\n");
}

TEST(Progress, IsThereBeforeTheFirstStep) {
  std::ostringstream output;
  const Progress progress(0, 2, &output, [] { return 0.0; });
  EXPECT_EQ(output.str(), "\r[          ]   0 %  0 of 2 s  0 steps/s  --:-- left\x1b[K");
}

TEST(PassingLine, IsGoneInTheEnd) {
  std::ostringstream output;
  {
    const PassingLine line("setting up", &output);
    EXPECT_EQ(output.str(), "setting up");
  }
  EXPECT_EQ(output.str(), "setting up\r\x1b[K");
  const PassingLine nowhere("setting up", nullptr);
}

TEST(Progress, FinishDrawsTheEnd) {
  std::ostringstream output;
  Progress progress(0, 2, &output, [] { return 0.0; });
  output.str("");
  progress.update(1, 1);
  EXPECT_EQ(output.str(), "");
  progress.finish(2, 2);
  EXPECT_EQ(output.str(), "\r[##########] 100 %  2 of 2 s  0 steps/s  0:00 left\x1b[K\n");
}

TEST(Progress, StaysOnOneLineOfATerminal) {
  std::ostringstream output;
  Progress progress(0, 123456.789, &output, [now = 0.0]() mutable { return now += 12345; });
  progress.update(1.2345678e-5, 1);
  progress.update(4.23456789e4, 123'456'789'012);
  EXPECT_NE(output.str().find(" 13:08:13 left"), std::string::npos) << output.str();  // 24690 s * (1 / 0.343 - 1)
  const std::size_t second = output.str().rfind('\r');
  EXPECT_LE(output.str().rfind('\x1b') - second, 80U);
}

// A static stage that finds its own steps may take minutes, all of them at one time: it was at 100 % with 0:00 left.
TEST(Progress, RunThatTakesNoTimeShowsSteps) {
  std::ostringstream output;
  double now = 0;
  Progress progress(1, 1, &output, [&] { return now; });
  EXPECT_EQ(output.str(), "\rstep 0  0 steps/s\x1b[K");
  progress.update(1, 1);
  output.str("");
  now += 4;
  progress.update(1, 2);
  EXPECT_EQ(output.str(), "\rstep 2  0.5 steps/s\x1b[K");
  progress.finish(1, 3);
  EXPECT_EQ(output.str().back(), '\n');
}

TEST(ClockText, MinutesHoursAndUnknown) {
  EXPECT_EQ(clock_text(0), "0:00");
  EXPECT_EQ(clock_text(59.2), "1:00");
  EXPECT_EQ(clock_text(3599), "59:59");
  EXPECT_EQ(clock_text(3661), "1:01:01");
  EXPECT_EQ(clock_text(359999), "99:59:59");
  EXPECT_EQ(clock_text(360000), "--:--");
  EXPECT_EQ(clock_text(INFINITY), "--:--");
  EXPECT_EQ(clock_text(NAN), "--:--");
  EXPECT_EQ(clock_text(-1), "--:--");
}

}  // namespace
}  // namespace dda
