#include "engine/core/place_in_words.h"

#include <fmt/format.h>

#include <cmath>

namespace dda {
namespace {

std::string coordinate(double value) {
  constexpr double of_a_survey = 1000;  // m
  return std::abs(value) < of_a_survey ? fmt::format("{:.4g}", value) : fmt::format("{:.8g}", value);
}

}  // namespace

std::string place_in_words(const Vec2& place) {
  return fmt::format("({}, {}) m", coordinate(place.x()), coordinate(place.y()));
}

}  // namespace dda
