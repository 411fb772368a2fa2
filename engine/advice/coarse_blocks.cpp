#include "engine/advice/coarse_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>

#include "engine/advice/followed_wave.h"

namespace dda {
namespace {

constexpr std::size_t fewest_blocks = 8;      // of rock, and not a few bodies
constexpr double fewest_in_a_wavelength = 3;  // masses and springs make it a sixth slower there

bool is_rock(const Model& model, const ContactSet& contacts) {
  return model.blocks.size() >= fewest_blocks && contacts.interfaces.size() + 1 >= model.blocks.size();
}

// So many, or fewer, of a tenth of the blocks.
double of_the_largest_in_a_wavelength(const Model& model, double frequency) {
  std::vector<double> all;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double wavelength = p_wave_speed(model.material_of(static_cast<int>(i))) / frequency;
    all.push_back(wavelength / std::sqrt(model.blocks[i].moments.area));
  }
  const auto tenth = std::next(all.begin(), static_cast<std::ptrdiff_t>(all.size() / 10));
  std::ranges::nth_element(all, tenth);
  return *tenth;
}

}  // namespace

std::vector<std::string> coarse_blocks(const Model& model, const ContactSet& contacts) {
  std::vector<std::string> remarks;
  if (!is_rock(model, contacts)) return remarks;
  for (const Stage& stage : model.stages) {
    const std::optional<FastestWave> wave = followed_wave(model, stage);
    if (!wave) continue;
    const double in_a_wavelength = of_the_largest_in_a_wavelength(model, wave->frequency);
    if (in_a_wavelength < fewest_in_a_wavelength)
      remarks.push_back(
          fmt::format("stage \"{}\": loads change as fast as a wave of {:.3g} Hz does, of which a wavelength has "
                      "{:.2g} blocks of the largest tenth: so few carry it badly or, below 2, not at all; \"dda "
                      "advise\" foretells what they do to "
                      "waves",
                      stage.name, wave->frequency, in_a_wavelength));
  }
  return remarks;
}

}  // namespace dda
