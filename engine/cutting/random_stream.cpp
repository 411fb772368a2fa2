#include "engine/cutting/random_stream.h"

#include <cmath>
#include <numbers>

namespace dda {
namespace {

// Spreads neighbouring numbers over all bits (the finalizer of SplitMix64; Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream) : bits_(mixed(seed) ^ mixed(~stream)) {}

double RandomStream::uniform() { return static_cast<double>(bits_() >> 11U) * 0x1p-53; }

// Box and Muller 1958.
double RandomStream::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

// Best and Fisher 1979: rejection from a wrapped Cauchy distribution.
double RandomStream::fisher(double concentration) {
  if (concentration < 1e-6) return std::numbers::pi * (2 * uniform() - 1);
  const double tau = 1 + std::sqrt(1 + 4 * concentration * concentration);
  const double rho = (tau - std::sqrt(2 * tau)) / (2 * concentration);
  const double r = (1 + rho * rho) / (2 * rho);
  for (;;) {
    const double z = std::cos(std::numbers::pi * uniform());
    const double f = (1 + r * z) / (r + z);
    const double c = concentration * (r - f);
    const double u = 1 - uniform();
    if (c * (2 - c) > u || std::log(c / u) + 1 >= c) return std::copysign(std::acos(f), uniform() - 0.5);
  }
}

double RandomStream::sample(const RandomQuantity& quantity) {
  switch (quantity.spread) {
    case Spread::none: return quantity.mean;
    case Spread::normal: return quantity.mean + quantity.deviation * normal();
    case Spread::uniform: return quantity.mean + quantity.deviation * (2 * uniform() - 1);
    case Spread::exponential: return -quantity.mean * std::log(1 - uniform());
    case Spread::lognormal: {
      const double share = quantity.deviation / quantity.mean;
      const double variance = std::log1p(share * share);
      return quantity.mean * std::exp(std::sqrt(variance) * normal() - variance / 2);
    }
    case Spread::fisher: return quantity.mean + fisher(quantity.concentration);
  }
  return quantity.mean;
}

double RandomStream::positive_sample(const RandomQuantity& quantity) {
  for (;;) {
    const double value = sample(quantity);
    if (value > 0) return value;
  }
}

}  // namespace dda
