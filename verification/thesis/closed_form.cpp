#include "verification/thesis/closed_form.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "engine/contact/interface_element.h"
#include "engine/contact/make_element.h"
#include "verification/exact/bar_stress.h"
#include "verification/exact/chain_modes.h"
#include "verification/exact/finite_chain.h"
#include "verification/exact/sharpened_load.h"

namespace verify {
namespace {

double block_length_of(const dda::Model& model) {
  return model.blocks[1].moments.centroid.x() - model.blocks[0].moments.centroid.x();
}

exact::InterfaceLaw interface_law(const dda::Model& model, const exact::BlockChain& chain) {
  const dda::InterfaceLaw law = model.joints.front().law;
  const dda::Stage& stage = model.stages.front();
  if (law == dda::InterfaceLaw::cubic) {
    const double error = exact::period_error(time_scheme_of(stage.integrator));
    return exact::cubic_edge(stage.correct_time_dispersion ? exact::inertia_reduction(chain, error, stage.dt) : 0);
  }
  const dda::Vec4 stiffness = dda::make_element(model, dda::find_interfaces(model).front(), law).stiffness;
  if (law == dda::InterfaceLaw::classical) return exact::corner_springs(stiffness(0), stiffness(1));
  return exact::consistent_edge(stiffness(0), stiffness(3));
}

exact::ChainProbe probe_of(const dda::Measurement& measurement) {
  if (measurement.quantity == dda::Quantity::stress_xx) return {exact::ChainQuantity::block_stress, measurement.block};
  return {exact::ChainQuantity::interface_stress, std::min(measurement.block, measurement.other_block)};
}

std::vector<double> sampled_load(const ThesisBar& bar, const dda::Stage& stage) {
  std::vector<double> load(static_cast<std::size_t>(std::llround(stage.duration / stage.dt)) + 1);
  for (std::size_t i = 0; i < load.size(); ++i)
    load[i] = exact::pulse_force({bar.load_amplitude, bar.load_frequency}, static_cast<double>(i) * stage.dt);
  return load;
}

}  // namespace

exact::TimeScheme time_scheme_of(const dda::Integrator& integrator) {
  return {integrator.beta, integrator.gamma, integrator.alpha_m, integrator.alpha_f, 1};
}

exact::BlockChain chain_of(const dda::Model& model) {
  const dda::Material& rock = model.materials.front();
  exact::BlockChain chain;
  chain.blocks = static_cast<int>(model.blocks.size());
  chain.length = block_length_of(model);
  chain.height = model.blocks.front().moments.area / chain.length;
  chain.density = rock.density;
  chain.elasticity = exact::plane_stress(rock.young, rock.poisson);
  chain.inertia_factor = model.stages.front().strain_inertia;
  const bool cubic = model.joints.front().law == dda::InterfaceLaw::cubic;
  chain.lateral_inertia = cubic && !model.stages.front().lateral_inertia ? 0 : 1;
  chain.interface = interface_law(model, chain);
  return chain;
}

std::vector<double> closed_form_history(const dda::Model& model, const ThesisBar& bar) {
  const dda::Stage& stage = model.stages.front();
  const exact::BlockChain chain = chain_of(model);
  const std::vector<double> load = exact::sharpened(sampled_load(bar, stage), exact::load_sharpening(chain, stage.dt));
  return exact::finite_chain_response(chain, time_scheme_of(stage.integrator), stage.dt, load,
                                      {probe_of(model.measurements.front())})
      .front();
}

double phase_speed(const dda::Model& model, double omega) {
  const dda::Stage& stage = model.stages.front();
  return exact::chain_wave(chain_of(model), time_scheme_of(stage.integrator), stage.dt, omega).speed;
}

}  // namespace verify
