#include "engine/core/quantity.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"

namespace dda {
namespace {

using std::string_literals::operator""s;

struct Sample {
  std::string text;
  Dimension dimension;
  double si;
};

// Every accepted unit once, with its value from outside the table. Decimal factors must give the double nearest to the
// decimal result, so these compare exactly.
std::vector<Sample> one_of_each() {
  constexpr double pi = std::numbers::pi;
  using enum Dimension;
  return {{"0.3", dimensionless, 0.3},
          {"30 %", dimensionless, 0.3},
          {"0.5 m", length, 0.5},
          {"2 km", length, 2000},
          {"5 cm", length, 0.05},
          {"7 mm", length, 0.007},
          {"3 um", length, 3e-6},
          {"1e-5 s", time, 1e-5},
          {"34 ms", time, 0.034},
          {"10 us", time, 1e-5},
          {"7 ns", time, 7e-9},
          {"2 min", time, 120},
          {"1.5 h", time, 5400},
          {"0.1 rad", angle, 0.1},
          {"3 mrad", angle, 0.003},
          {"180 deg", angle, pi},
          {"3 kg", mass, 3},
          {"3 g", mass, 0.003},
          {"3 t", mass, 3000},
          {"2650 kg/m3", mass_density, 2650},
          {"2.65 t/m3", mass_density, 2650},
          {"2.65 g/cm3", mass_density, 2650},
          {"12 Pa", stress, 12},
          {"12 kPa", stress, 12e3},
          {"12 MPa", stress, 12e6},
          {"50 GPa", stress, 50e9},
          {"12 N/m2", stress, 12},
          {"12 kN/m2", stress, 12e3},
          {"12 MN/m2", stress, 12e6},
          {"2 bar", stress, 2e5},
          {"5 N", force, 5},
          {"5 kN", force, 5e3},
          {"1 MN", force, 1e6},
          {"5 GN", force, 5e9},
          {"5 N/m", force_per_length, 5},
          {"5 kN/m", force_per_length, 5e3},
          {"5 MN/m", force_per_length, 5e6},
          {"5 GN/m", force_per_length, 5e9},
          {"5 Pa/m", stiffness_per_area, 5},
          {"5 kPa/m", stiffness_per_area, 5e3},
          {"5 MPa/m", stiffness_per_area, 5e6},
          {"5 GPa/m", stiffness_per_area, 5e9},
          {"5 N/m3", stiffness_per_area, 5},
          {"5 kN/m3", stiffness_per_area, 5e3},
          {"5 MN/m3", stiffness_per_area, 5e6},
          {"5 GN/m3", stiffness_per_area, 5e9},
          {"100 Hz", frequency, 100},
          {"1.5 kHz", frequency, 1500},
          {"2 MHz", frequency, 2e6},
          {"4 1/s", rate, 4},
          {"4 1/ms", rate, 4000},
          {"4 1/us", rate, 4e6},
          {"90 1/min", rate, 1.5},
          {"4 m/s", velocity, 4},
          {"4 km/s", velocity, 4000},
          {"4 cm/s", velocity, 0.04},
          {"4 mm/s", velocity, 0.004},
          {"36 km/h", velocity, 10},
          {"4 rad/s", angular_velocity, 4},
          {"180 deg/s", angular_velocity, pi},
          {"9.81 m/s2", acceleration, 9.81},
          {"981 cm/s2", acceleration, 9.81},
          {"9810 mm/s2", acceleration, 9.81},
          {"1 g", acceleration, 9.80665},
          {"7e6 Pa s/m", impedance, 7e6},
          {"11.5 kPa s/m", impedance, 11500},
          {"11.5 MPa s/m", impedance, 11.5e6}};
}

std::vector<Dimension> all_dimensions() {
  std::vector<Dimension> all;
  for (int i = 0; i < dimension_count; ++i) all.push_back(static_cast<Dimension>(i));
  return all;
}

std::string message_of(const std::string& text, Dimension dimension) {
  try {
    parse_quantity(text, dimension, "field");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Quantity, EveryUnitHasItsValue) {
  for (const Sample& sample : one_of_each()) {
    EXPECT_EQ(parse_quantity(sample.text, sample.dimension), sample.si) << sample.text;
  }
}

TEST(Quantity, EveryUnitIsSampled) {
  std::set<std::pair<Dimension, std::string>> sampled;
  for (const Sample& sample : one_of_each()) {
    const std::size_t space = sample.text.find(' ');
    sampled.emplace(sample.dimension, space == std::string::npos ? "" : sample.text.substr(space + 1));
  }
  for (const Dimension dimension : all_dimensions()) {
    for (const Unit& unit : units(dimension)) {
      EXPECT_TRUE(sampled.contains({dimension, std::string(unit.symbol)}))
          << to_string(dimension) << " " << unit.symbol;
    }
  }
}

TEST(Quantity, SiUnitComesFirstWithFactorOne) {
  for (const Dimension dimension : all_dimensions()) {
    EXPECT_EQ(units(dimension).front().symbol, si_unit(dimension));
    EXPECT_EQ(units(dimension).front().numerator, 1.0);
    EXPECT_EQ(units(dimension).front().denominator, 1.0);
  }
  EXPECT_EQ(si_unit(Dimension::mass_density), "kg/m3");
  EXPECT_EQ(si_unit(Dimension::angle), "rad");
}

TEST(Quantity, AcceptsOtherSpellings) {
  EXPECT_EQ(parse_quantity("50GPa", Dimension::stress), 50e9);
  EXPECT_EQ(parse_quantity(" \t50   GPa\n", Dimension::stress), 50e9);
  EXPECT_EQ(parse_quantity("2650 kg/m^3", Dimension::mass_density), 2650);
  EXPECT_EQ(parse_quantity("2650 kg/m\u00b3", Dimension::mass_density), 2650);
  EXPECT_EQ(parse_quantity("9.81 m/s\u00b2", Dimension::acceleration), 9.81);
  EXPECT_EQ(parse_quantity("10 \u00b5s", Dimension::time), 1e-5);
  EXPECT_EQ(parse_quantity("10 \u03bcs", Dimension::time), 1e-5);
  EXPECT_EQ(parse_quantity("180\u00b0", Dimension::angle), std::numbers::pi);
  EXPECT_EQ(parse_quantity("-.5e1 m", Dimension::length), -5);
}

TEST(Quantity, RefusesEverythingElse) {
  const std::vector<std::string> bad = {"",         " ",         "Pa",        "50",      "50 kg",  "50 gpa",
                                        "50 GPa 3", "50 GPa x",  "5 0 GPa",   "nan Pa",  "inf Pa", "-inf GPa",
                                        "1e400 Pa", "1e308 GPa", "1e-400 Pa", "0x10 Pa", "1,5 Pa", "1.5.2 Pa",
                                        "--5 Pa",   "1e Pa",     "5 ^2",      "5 m^3",   "5\0Pa"s, "5 Pa\0"s};
  for (const std::string& text : bad) {
    EXPECT_THROW(parse_quantity(text, Dimension::stress), InputError) << text;
  }
  EXPECT_THROW(parse_quantity("3 m", Dimension::dimensionless), InputError);
}

TEST(Quantity, OneSentenceNamesFieldValueAndUnits) {
  EXPECT_EQ(message_of("50 kg", Dimension::angle),
            "field is \"50 kg\", expected a finite number with a unit of angle (rad, mrad, deg)");
  EXPECT_EQ(message_of("x", Dimension::dimensionless),
            "field is \"x\", expected a finite number without a unit, or with %");
}

TEST(Quantity, SentenceStaysOnOneShortLine) {
  const std::string message = message_of("1\n\x01" + std::string(100'000, 'x'), Dimension::time);
  EXPECT_LT(message.size(), 200u);
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_EQ(message.find('\x01'), std::string::npos);
}

// A random finite double of any magnitude whose product with any factor of the tables stays finite and normal.
double random_number(std::mt19937_64& random) {
  const double mantissa = std::ldexp(static_cast<double>(random() >> 11), -53) * 2 - 1;
  return std::ldexp(mantissa, static_cast<int>(random() % 1800) - 900);
}

TEST(Quantity, RoundTripsEveryFiniteNumber) {
  std::mt19937_64 random(20240501);
  for (int repeat = 0; repeat < 300; ++repeat) {
    for (const Dimension dimension : all_dimensions()) {
      for (const Unit& unit : units(dimension)) {
        const double number = random_number(random);
        const std::string text = fmt::format("{} {}", number, unit.symbol);
        ASSERT_EQ(parse_quantity(text, dimension), number * unit.numerator / unit.denominator) << text;
      }
    }
  }
}

// Whatever the bytes, parsing either throws InputError or returns a finite number.
TEST(Quantity, SurvivesRandomText) {
  constexpr std::string_view alphabet = "0123456789.eE+-infaNkMGPasmg/%^23 \xc2\xb5\x00";
  std::mt19937_64 random(7);
  int accepted = 0;
  for (int repeat = 0; repeat < 100'000; ++repeat) {
    std::string text(random() % 8, ' ');
    for (char& c : text) c = alphabet[random() % alphabet.size()];
    const auto dimension = static_cast<Dimension>(random() % static_cast<std::uint64_t>(dimension_count));
    try {
      ASSERT_TRUE(std::isfinite(parse_quantity(text, dimension))) << text;
      ++accepted;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(accepted, 0);
}

}  // namespace
}  // namespace dda
