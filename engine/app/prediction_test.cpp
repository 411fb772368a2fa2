#include "engine/app/prediction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "engine/contact/cubic_law.h"

namespace dda {
namespace {

using Complex = std::complex<double>;

constexpr double speed = 4000;
constexpr double frequency = 100;
constexpr double omega = 2 * std::numbers::pi * frequency;

// The size of blocks over which the wave's phase changes by `phase`.
BlockWave wave_of(double phase, double theta) {
  BlockWave wave;
  wave.frequency = frequency;
  wave.speed = speed;
  wave.block_size = phase * speed / omega;
  wave.dt = theta / omega;
  wave.integrator = trapezoidal_integrator();
  return wave;
}

// Solves relation(X) = 0 for the complex X = sin^2(kappa/2) near the continuous answer, and returns the change of the
// phase kappa over one block. Newton's method with a numeric derivative, so that the relation can be any.
template <typename Relation>
Complex phase_of_block(const Relation& relation, double expected_phase) {
  Complex x = std::pow(std::sin(expected_phase / 2), 2);
  for (int i = 0; i < 50; ++i) {
    const double small = 1e-6 * std::abs(x);
    x -= relation(x) * (2 * small) / (relation(x + small) - relation(x - small));
  }
  return 2.0 * std::asin(std::sqrt(x));
}

// -(second difference)/(operator of the integrator): omega^2 as the time steps see it, times dt^2.
Complex stepped_square(const Integrator& integrator, double theta) {
  // Follows one step of an oscillator x'' = -s x with x = x0 z^n, v = v0 z^n, a = a0 z^n, from the three equations of
  // the integrator (settings.h) in units of dt: find s for which they have a solution.
  const Complex z = std::polar(1.0, theta);
  const double beta = integrator.beta;
  const double gamma = integrator.gamma;
  // z v = v + ((1 - gamma) + gamma z) a;  z x = x + v + ((1/2 - beta) + beta z) a;  with a = 1.
  const Complex v = ((1 - gamma) + gamma * z) / (z - 1.0);
  const Complex x = (v + (0.5 - beta) + beta * z) / (z - 1.0);
  const Complex balance_a = (1 - integrator.alpha_m) * z + integrator.alpha_m;
  const Complex balance_x = (1 - integrator.alpha_f) * z + integrator.alpha_f;
  return -balance_a / (balance_x * x);
}

// Relative error of the speed and amplitude loss a wavelength, of a wave whose phase changes by kappa over a block.
struct Exact {
  double speed;
  double loss;
};
Exact exact_from(Complex kappa, double phase) {
  return {phase / kappa.real() - 1, 1 - std::exp(-2 * std::numbers::pi * std::abs(kappa.imag()) / kappa.real())};
}

// Numeric solution of the scalar relation of a chain of blocks with springs: 1/q = 4 X/w - (1 - X)/(1 - f w/12), with
// w = omega^2 m/Kb and q = k/Kb = 1/eta_s.
Exact spring_chain(double phase, const Integrator& integrator, double theta, double compliance, double factor) {
  const Complex w = theta > 0 ? stepped_square(integrator, theta) * std::pow(phase / theta, 2) : Complex(phase * phase);
  const auto relation = [&](Complex x) { return 4.0 * x / w - (1.0 - x) / (1.0 - factor / 12 * w) - compliance; };
  return exact_from(phase_of_block(relation, phase), phase);
}

// The same of the consistent law with penalty q: a w-quadratic relation in S^2 = 4 X and C^2 = 1 - X.
Exact consistent_chain(double phase, double penalty, double factor) {
  const double w = phase * phase;
  const double strain = 1 - factor / 12 * w;
  const auto relation = [&](Complex x) {
    const Complex s2 = 4.0 * x;
    const Complex c2 = 1.0 - x;
    return w * strain + w * (penalty - 2) * c2 - penalty * s2 * strain + s2 * c2;
  };
  return exact_from(phase_of_block(relation, phase), phase);
}

// Cubic finite elements with displacement u and strain e at their ends: 2 x 2 problem for a wave, whose determinant
// vanishes at omega. `lowered`: inertia against (u_b - u_a) taken out, as a share of the mass of a cell; against the
// jump of e likewise, over 12.
Exact cubic_chain(double phase, Complex w, double lowered) {
  const auto determinant = [&](Complex x) {
    const Complex cosine = 1.0 - 2.0 * x;
    const Complex sine2 = 1.0 - cosine * cosine;
    const Complex uu = 2.4 * (1.0 - cosine) - w * ((312.0 + 108.0 * cosine) / 420.0 - lowered * 2.0 * (1.0 - cosine));
    const double of_jump = std::min(lowered, cubic::most_jump_correction) / 6;
    const Complex ee = (8.0 - 2.0 * cosine) / 30.0 - w * ((8.0 - 6.0 * cosine) / 420.0 - of_jump * (1.0 - cosine));
    const Complex ue = 0.2 - w * (-26.0 / 420.0);
    return uu * ee - ue * ue * sine2;
  };
  return exact_from(phase_of_block(determinant, phase), phase);
}

// The remainder of a prediction falls as the next power: halving the wave's phase shows the order of what is left out.
double order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

TEST(Prediction, SpringsDelayByHalfTheirCompliance) {
  const auto left_out = [](double compliance) {
    BlockWave wave = wave_of(1e-3, 1e-3);  // small: only the springs matter
    wave.compliance = compliance;
    return spring_chain(1e-3, wave.integrator, 0, compliance, 1).speed - predict_errors(wave).interfaces;
  };
  // 1/sqrt(1 + eta) = 1 - eta/2 + 3 eta^2/8.
  EXPECT_NEAR(left_out(0.02) / (0.02 * 0.02), 3.0 / 8, 0.02);
  EXPECT_NEAR(order(left_out(0.04), left_out(0.02)), 2, 0.05);
}

TEST(Prediction, BlockSize) {
  for (const double factor : {1.0, 1.5}) {
    const auto left_out = [&](double phase, bool springs) {
      BlockWave wave = wave_of(phase, 1e-6);
      wave.strain_inertia = factor;
      const Exact exact =
          springs ? spring_chain(phase, wave.integrator, 0, 0, factor) : consistent_chain(phase, 4, factor);
      return exact.speed - predict_errors(wave).blocks;
    };
    for (const bool springs : {true, false}) {
      EXPECT_LT(std::abs(left_out(0.2, springs)), 0.05 * 0.2 * 0.2 / 24);
      EXPECT_NEAR(order(left_out(0.4, springs), left_out(0.2, springs)), 4, 0.3);
    }
  }
}

TEST(Prediction, CubicLaw) {
  const auto left_out = [](double phase) {
    BlockWave wave = wave_of(phase, 1e-6);
    wave.cubic = true;
    return cubic_chain(phase, phase * phase, 0).speed - predict_errors(wave).blocks;
  };
  EXPECT_LT(std::abs(left_out(0.5)), 0.1 * std::pow(0.5, 6) / 60480);
  EXPECT_NEAR(order(left_out(1.0), left_out(0.5)), 8, 0.5);
}

TEST(Prediction, TimeStepIsExactForEveryIntegrator) {
  for (const Integrator& integrator : {thesis_integrator(), trapezoidal_integrator(), hht_integrator(0.2),
                                       generalized_alpha_integrator(0.8), generalized_alpha_integrator(0)}) {
    for (const double theta : {0.01, 0.3}) {
      BlockWave wave = wave_of(1e-3, theta);
      wave.integrator = integrator;
      const WaveErrors predicted = predict_errors(wave);
      const Exact exact = spring_chain(1e-3, integrator, theta, 0, 1);
      // The blocks of the chain add (1e-3)^2/24 = 4e-8.
      EXPECT_NEAR(predicted.time, exact.speed, 1e-7) << integrator.name << " " << theta;
      EXPECT_NEAR(predicted.amplitude_loss, exact.loss, 1e-6) << integrator.name << " " << theta;
    }
  }
}

TEST(Prediction, TimeStepToLeadingOrder) {
  const double theta = 0.05;
  BlockWave wave = wave_of(0.1, theta);
  // What is left is two orders higher, 1/100 of these at most.
  EXPECT_NEAR(predict_errors(wave).time, -theta * theta / 12, theta * theta / 1200);
  EXPECT_NEAR(predict_errors(wave).amplitude_loss, 0, 1e-14);
  wave.integrator = thesis_integrator();
  EXPECT_NEAR(predict_errors(wave).time, theta * theta / 96, theta * theta / 1200);
  // exp(-omega^2 dt t/4) over a period.
  const double lost = 1 - std::exp(-2 * std::numbers::pi * theta / 4);
  EXPECT_NEAR(predict_errors(wave).amplitude_loss, lost, lost / 100);
  wave.integrator = generalized_alpha_integrator(0.8);
  EXPECT_NEAR(predict_errors(wave).time, -period_error(wave.integrator) * theta * theta / 2, theta * theta / 1200);
}

// With the period error taken out of the inertia, what is left is of fourth order in dt; beyond the cap it is not.
TEST(Prediction, CorrectedTimeStep) {
  const Integrator integrator = generalized_alpha_integrator(0.8);
  const auto compare = [&](double phase, double theta) {
    BlockWave wave = wave_of(phase, theta);
    wave.integrator = integrator;
    wave.cubic = true;
    wave.time_corrected = true;
    const double courant = theta / phase;
    const double lowered = std::min(period_error(integrator) * courant * courant, cubic::most_correction);
    const Complex w = stepped_square(integrator, theta) / (courant * courant);
    const double exact = cubic_chain(phase, w, lowered).speed;
    EXPECT_NEAR(predict_errors(wave).speed(), exact, std::pow(phase, 4) / 24 + std::pow(theta, 4) / 10);
    return std::pair{exact, predict_errors(wave).time};
  };
  const auto [coarse, coarse_time] = compare(0.2, 0.1);
  compare(0.1, 0.05);
  EXPECT_LT(std::abs(coarse_time), 0.01 * 0.1 * 0.1 / 12);
  EXPECT_LT(std::abs(coarse), 0.01 * 0.1 * 0.1 / 12);
  EXPECT_LT(compare(0.05, 0.2).second, -0.5 * 0.2 * 0.2 / 12);
}

// A bar with corner springs: their tangential part keeps the sides from contracting, E -> E (1 + nu^2 s kappa^2/2 ..).
TEST(Prediction, CornerSpringsStiffenABar) {
  const double poisson = 0.25;
  const double shear_spring = 0.4;  // ks h/(L E)
  BlockWave wave = wave_of(0.05, 1e-6);
  wave.lateral_coupling = poisson * poisson * shear_spring;
  // E1 (1 - nu^2/(1 + 2 ks h/(L E1) sin^2(kappa/2))) over E = E1 (1 - nu^2).
  const double ratio = shear_spring * (1 - poisson * poisson);
  const double stiffer =
      (1 - poisson * poisson / (1 + 2 * ratio * std::pow(std::sin(0.025), 2))) / (1 - poisson * poisson);
  EXPECT_NEAR(predict_errors(wave).interfaces, std::sqrt(stiffer) - 1, 0.02 * (std::sqrt(stiffer) - 1));
}

}  // namespace
}  // namespace dda
