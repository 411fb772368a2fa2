// Lets a run end in order when the user asks it to.
#pragma once

namespace dda {

// While it lives, the first SIGINT or SIGTERM is noted, and a second one ends the program at once. One at a time.
class StopSignal {
 public:
  // `says_so`: the signal is answered with a line on standard error.
  explicit StopSignal(bool says_so);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  // The signal's number, or 0.
  [[nodiscard]] static int received();
};

}  // namespace dda
