// Chapter 5, Jinping: what its table of sensors implies by itself.
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

[[nodiscard]] Chapter chapter_5(std::span<const Sensor> sensors = jinping_sensors());

}  // namespace verify
