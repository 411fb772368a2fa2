#include "engine/app/advise_command.h"

#include "engine/advice/advise.h"

#include <ostream>

#include "engine/core/error.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"

namespace dda {

void advise_scene(const AdviseOptions& options, std::ostream& out) {
  try {
    const Advice advice = advise(Simulation(read_scene(options.scene)), options.question);
    out << (options.json ? to_json_text(advice) : to_text(advice));
  } catch (const InputError& error) {
    throw error.in_file(options.scene.string());
  }
}

}  // namespace dda
