// A damped oscillator led by a record with straight lines between its samples,
//   w'' + 2 r omega w' + omega^2 w = -f(t),
// followed without any error of time integration (Nigam & Jennings 1969). With h the answer to an impulse (h = 0 and
// h' = 1 at first), H its integral and G the integral of that, f = f0 + slope t over an interval of length t gives
//   w1  = (h' + 2 r omega h) w0 + h w0' - H f0 - G slope
//   w1' = -omega^2 h w0 + h' w0' - h f0 - H slope
#pragma once

namespace dda {

struct Oscillator {
  double omega = 0;  // 1/s, of free vibration without damping
  double ratio = 0;  // share of critical damping, below 1
};

struct OscillatorState {
  double value = 0;  // w
  double rate = 0;   // w'
};

// A straight line of the record.
struct LeadingLine {
  double start = 0;  // f where the line begins
  double slope = 0;  // 1/s
};

// The `order`th derivative of w, 0 to 5, where the line has gone on to the value `f`.
double derivative(int order, const Oscillator& oscillator, const OscillatorState& state, double f, double slope);

// The time (s) after which a free vibration that begins with this value and rate is zero for the first time. From the
// second on derivatives of w are such vibrations while the line goes on.
double first_zero(const Oscillator& oscillator, double value, double rate);

class OscillatorStep {
 public:
  // Over an interval of length `dt`, s.
  OscillatorStep(const Oscillator& oscillator, double dt);

  [[nodiscard]] OscillatorState after(const OscillatorState& state, const LeadingLine& line) const;

 private:
  double stiffness_;                 // omega^2
  double damping_;                   // 2 r omega
  double h_ = 0, rate_of_h_ = 0;     // h, h'
  double integral_ = 0, twice_ = 0;  // H, G
};

}  // namespace dda
