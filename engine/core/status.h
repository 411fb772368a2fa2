// How a step or a run ended. Anything but ok is reported, never swallowed.
#pragma once

#include <string_view>

namespace dda {

enum class Status {
  ok,
  not_converged,       // the open-close iteration or the linear solver did not converge
  not_finite,          // a displacement, velocity or stress is NaN or infinite
  singular,            // the system matrix is not positive definite: a block has neither inertia nor support
  not_in_equilibrium,  // a static stage ended out of balance; the state is the one reached
  left_contact_range,  // blocks meet where they did not at the start, which is not followed; the state is the first so
  gained_energy,       // the run went through, but its energy grew beyond what loads and motions brought
  inaccurate,          // the run went through, but its energies do not add up: the solves have lost too many digits
  finished,            // there was no step left to take; the state is that of the end
  stopped,             // the user asked to stop; the state is complete and can be resumed
};

constexpr std::string_view to_string(Status status) {
  switch (status) {
    case Status::ok: return "ok";
    case Status::not_converged: return "not_converged";
    case Status::not_finite: return "not_finite";
    case Status::singular: return "singular";
    case Status::not_in_equilibrium: return "not_in_equilibrium";
    case Status::left_contact_range: return "left_contact_range";
    case Status::gained_energy: return "gained_energy";
    case Status::inaccurate: return "inaccurate";
    case Status::finished: return "finished";
    case Status::stopped: return "stopped";
  }
  return "unknown";
}

}  // namespace dda
