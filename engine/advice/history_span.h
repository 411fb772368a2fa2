// When a history changes.
#pragma once

#include "engine/model/time_function.h"

namespace dda {

struct HistorySpan {
  double from = 0, to = 0;  // s
};

// Before and after it the history is zero, or stays as it is.
HistorySpan changing(const TimeFunction& history);

}  // namespace dda
