// Chapter 5, Jinping: its sensors.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "verification/chapters/statement.h"

namespace verify {

// A row of Table 5.1.
struct Sensor {
  std::string name;
  int group = 0;
  double distance = 0;  // m from the rockburst
  double trigger = 0;   // s after 20:32:33
};

[[nodiscard]] std::span<const Sensor> jinping_sensors();

// Eq. 11 for the marble of Table 5.2, m/s.
[[nodiscard]] double speed_by_eq_11(double density);

// What the table of sensors implies by itself; jinping.h adds what the model says.
[[nodiscard]] Chapter chapter_5(std::span<const Sensor> sensors = jinping_sensors());

}  // namespace verify
