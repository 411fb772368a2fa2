#include "engine/advice/advice.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

double size_of(const ErrorTerms& terms, double ErrorTerms::*term) { return std::abs(terms.*term); }

}  // namespace

const ErrorTerms* WaveAdvice::speed_error() const {
  if (asked_history) return history ? &history->speed : nullptr;
  return steady ? &steady->speed : nullptr;
}

const ErrorTerms* WaveAdvice::amplitude_error() const {
  if (asked_history) return history ? &history->amplitude : nullptr;
  return steady ? &steady->amplitude : nullptr;
}

std::string WaveAdvice::cause() const {
  const ErrorTerms* speed_terms = speed_error();
  const ErrorTerms* amplitude_terms = amplitude_error();
  if (speed_terms == nullptr || amplitude_terms == nullptr) return "";
  const auto weight = [&](double ErrorTerms::*term) {
    return std::max(size_of(*speed_terms, term), size_of(*amplitude_terms, term));
  };
  const double blocks = weight(&ErrorTerms::blocks);
  const double interfaces = weight(&ErrorTerms::interfaces);
  const double time = weight(&ErrorTerms::time);
  const double sides = weight(&ErrorTerms::sides);
  if (sides > std::max({blocks, interfaces, time, weight(&ErrorTerms::damping)})) return "sides";
  if (weight(&ErrorTerms::damping) > std::max({blocks, interfaces, time})) return "damping";
  if (time >= std::max(blocks, interfaces)) return "time steps";
  return interfaces >= blocks ? "interfaces" : "block size";
}

}  // namespace dda
