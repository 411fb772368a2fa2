#include "engine/app/stop_signal.h"

#include <signal.h>

#include <initializer_list>

namespace dda {
namespace {

volatile sig_atomic_t received_signal = 0;

extern "C" void note(int number) { received_signal = number; }

void handle(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // the next one has its usual effect
  sigaction(number, &action, nullptr);
}

}  // namespace

StopSignal::StopSignal() {
  received_signal = 0;
  for (const int number : {SIGINT, SIGTERM}) handle(number, note);
}

StopSignal::~StopSignal() {
  for (const int number : {SIGINT, SIGTERM}) handle(number, SIG_DFL);
}

int StopSignal::received() { return received_signal; }

}  // namespace dda
