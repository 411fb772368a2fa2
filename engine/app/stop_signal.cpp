#include "engine/app/stop_signal.h"

#include <signal.h>
#include <unistd.h>

#include <initializer_list>
#include <string_view>

namespace dda {
namespace {

volatile sig_atomic_t received_signal = 0;
volatile sig_atomic_t answer_to = -1;  // a file's number; -1: nobody

// A step of ten thousand loose blocks takes half a minute, in which nothing else would say that the signal has come.
constexpr std::string_view answer =
    "\ndda: stops at the end of this step; once more stops at once, and leaves the last checkpoint to go on from\n";

extern "C" void note(int number) {
  received_signal = number;
  if (answer_to < 0) return;
  // A handler may call write() and little else; where nobody reads there is nothing to be done.
  [[maybe_unused]] const auto written = write(answer_to, answer.data(), answer.size());
}

void handle(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the next one has its usual effect
  sigaction(number, &action, nullptr);
}

}  // namespace

StopSignal::StopSignal(bool says_so) {
  received_signal = 0;
  answer_to = says_so ? STDERR_FILENO : -1;
  for (const int number : {SIGINT, SIGTERM}) handle(number, note);
}

StopSignal::~StopSignal() {
  for (const int number : {SIGINT, SIGTERM}) handle(number, SIG_DFL);
}

int StopSignal::received() { return received_signal; }

}  // namespace dda
