#include "engine/simulation/stability_limit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/contact/make_contacts.h"
#include "engine/core/error.h"
#include "engine/linear/block_vectors.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/inertia_solver.h"

namespace dda {
namespace {

// The part of omega^2 that Lanczos' method may have missed, and the probability that it has missed more.
constexpr double tolerance = 0.01;
constexpr double doubt = 1e-6;

// Kuczynski & Wozniakowski (1992, theorem 4.1): begun in a random direction of n dimensions, k products with a matrix
// miss more than the share e of its largest eigenvalue with a probability below 1.648 sqrt(n) exp(-sqrt(e) (2 k - 1)).
int products_for(double unknowns) {
  const double wanted = std::log(1.648 * std::sqrt(unknowns) / doubt) / std::sqrt(tolerance);
  return static_cast<int>(std::ceil((wanted + 1) / 2));
}

// The share that k of them may miss.
double share_missed(double unknowns, int products) {
  return std::pow(std::log(1.648 * std::sqrt(unknowns) / doubt) / (2.0 * products - 1), 2);
}

// Numbers between 0 and 1, always the same (Knuth's linear congruential generator, the upper bits).
class FixedNumbers {
 public:
  double next() {
    state_ = 6364136223846793005ULL * state_ + 1442695040888963407ULL;
    return std::ldexp(static_cast<double>((state_ >> 11) + 1), -53);
  }
  // Returns a number that is normally distributed (Box & Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(next()));
    return radius * std::cos(2 * std::numbers::pi * next());
  }

 private:
  std::uint64_t state_ = 49;
};

// M v of a v whose direction is as likely as any other in the inner product of M: L g with M = L L^T and g of normally
// distributed numbers. Couplings between blocks are left out of L.
Eigen::VectorXd random_momentum(const ConstantOperator& inertia, const HeldUnknowns& held) {
  Eigen::VectorXd momentum(inertia.unknowns());
  FixedNumbers numbers;
  for (int i = 0; i < inertia.size(); ++i) {
    Vec6 own;
    for (double& each : own) each = numbers.normal();
    const Mat6 block = inertia.block(i, i);
    if (!held.holds(i)) own = block.llt().matrixL() * own;
    momentum.segment<6>(6 * i) = own;
  }
  held.clear(momentum);
  return momentum;
}

// Whether x lies above all eigenvalues of a symmetric tridiagonal matrix: all pivots of x - T are positive (Sturm).
bool is_above_all(const std::vector<double>& diagonal, const std::vector<double>& beside, double x) {
  double pivot = x - diagonal[0];
  for (std::size_t i = 1; i < diagonal.size() && pivot > 0; ++i)
    pivot = x - diagonal[i] - beside[i] * beside[i] / pivot;
  return pivot > 0;
}

// The largest, by bisection; beside[i] couples i - 1 and i. The QR algorithm may end without it where many eigenvalues
// have copies, as those of Lanczos' method have.
double largest_eigenvalue(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  double low = *std::ranges::max_element(diagonal), high = low;
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const double around = (i > 0 ? beside[i] : 0) + (i + 1 < diagonal.size() ? beside[i + 1] : 0);
    high = std::max(high, diagonal[i] + around);  // Gershgorin
  }
  constexpr double close = 1e-14;
  while (high - low > close * std::abs(high)) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (is_above_all(diagonal, beside, middle) ? high : low) = middle;
  }
  return high;
}

// Lanczos' recurrence for M^-1 K in the inner product of M, without reorthogonalization: copies of eigenvalues that
// this brings are copies of the same, and the largest is what is asked for.
class Lanczos {
 public:
  Lanczos(const LinearOperators& operators, const HeldUnknowns& held) : operators_(operators), held_(held) {
    const auto size = static_cast<Eigen::Index>(operators.stiffness.unknowns());
    product_.setZero(size);
    vector_.setZero(size);
    momentum_.setZero(size);
    is_regular_ = solver_.set_up(operators.inertia.matrix(), held) == Status::ok;
    force_ = random_momentum(operators.inertia, held);
    if (is_regular_) is_regular_ = next();
  }

  // False where the inertia has no inverse, or the space is used up.
  [[nodiscard]] bool step() {
    if (!is_regular_) return false;
    operators_.stiffness.multiply(vector_, product_);
    held_.clear(product_);
    const double own = dot(vector_, product_);
    own_.push_back(own);
    // momentum_ is M times the vector, force_ still that times the norm of the one before.
    product_ -= own * momentum_ + norm_ * before_;
    before_.swap(momentum_);
    force_.swap(product_);
    largest_ = std::max(largest_, own);
    return is_regular_ = next();
  }

  [[nodiscard]] LargestFrequency largest() const {
    if (own_.empty()) return {};
    return {largest_eigenvalue(own_, norms_), static_cast<int>(own_.size())};
  }

 private:
  // The next vector from force_, and what it is in the inner product of M.
  bool next() {
    if (solver_.solve(force_, vector_) != Status::ok) return false;
    held_.clear(vector_);
    norm_ = std::sqrt(std::max(0.0, dot(vector_, force_)));
    norms_.push_back(norm_);
    constexpr double round_off = 1e-7;  // of the largest value; less is what all vectors of a small problem leave
    if (!(norm_ > round_off * largest_) || !std::isfinite(norm_)) return false;
    vector_ /= norm_;
    momentum_ = force_ / norm_;
    if (before_.size() == 0) before_.setZero(force_.size());
    return true;
  }

  const LinearOperators& operators_;
  const HeldUnknowns& held_;
  InertiaSolver solver_;
  Eigen::VectorXd vector_, momentum_, before_, force_, product_;
  std::vector<double> own_, norms_;  // diagonal, and what stands beside it from the second on
  double norm_ = 0, largest_ = 0;
  bool is_regular_ = true;
};

std::string named(const Model& model, std::size_t stage, const char* member) {
  return fmt::format("stages \"{}\" {}", model.stages[stage].name, member);
}

// The supports of a stage; those that only earlier stages have are there without stiffness.
std::vector<SupportElement> supports_in(const Model& model, std::size_t stage) {
  std::vector<SupportElement> supports = make_supports(model, initial_state(model));
  for (std::size_t i = 0; i < supports.size(); ++i)
    if (model.supports[i].last_stage >= 0 && model.supports[i].last_stage < static_cast<int>(stage))
      supports[i].stiffness.setZero();
  return supports;
}

ContactSet contacts_in(const Model& model, std::size_t stage, ContactSet drawn) {
  const std::vector<bool> absent = model.absent_in(stage);
  if (absent.empty()) return drawn;
  leave_out(absent, drawn);
  fit_to_neighbours(model, drawn);
  return drawn;
}

LinearOperators operators_at(const Model& model, std::size_t index, const ContactSet& contacts, double dt) {
  Stage stage = model.stages[index];
  stage.dt = dt;
  return {model, make_block_terms(model, stage), contacts, supports_in(model, index),
          WaveCorrections(model, stage, contacts)};
}

// The limit (s) of steps by the operators that steps of `dt` have.
double limit_at(const Model& model, std::size_t index, const ContactSet& contacts, double dt) {
  const HeldUnknowns held = make_held_unknowns(model, model.absent_in(index));
  const LinearOperators operators = operators_at(model, index, contacts, dt);
  if (operators.inertia.couplings() > 0 && held.move)
    throw InputError("", named(model, index, "integrator"),
                     "\"central_difference\" where blocks of a cubic chain are moved",
                     "another one, or consistent joints there");
  return 2 * std::sqrt((1 - tolerance) / largest_frequency(operators, held).squared);
}

}  // namespace

LargestFrequency largest_frequency(const LinearOperators& operators, const HeldUnknowns& held) {
  Lanczos lanczos(operators, held);
  const int products = products_for(operators.stiffness.unknowns());
  for (int i = 0; i < products && lanczos.step(); ++i) {
  }
  return lanczos.largest();
}

double stable_step(const LinearOperators& operators, const HeldUnknowns& held, const StepsInQuestion& steps) {
  Lanczos lanczos(operators, held);
  const int unknowns = operators.stiffness.unknowns();
  const int most = products_for(unknowns);
  double stable = 0;
  bool is_going_on = true;
  for (int k = 1; k <= most && is_going_on; ++k) {
    const bool is_exhausted = !lanczos.step();
    const double found = lanczos.largest().squared;
    if (!(found > 0)) return 0;
    const double missed = is_exhausted || k == most ? tolerance : std::min(1.0, share_missed(unknowns, k));
    const double limit = 2 / std::sqrt(found);
    stable = std::sqrt(1 - missed) * limit;
    is_going_on = !is_exhausted && limit >= steps.least && stable < steps.wanted && stable < steps.close * limit;
  }
  return stable >= steps.least ? stable : 0;
}

double stable_step(const Model& model, std::size_t stage, const ContactSet& contacts, const StepsInQuestion& steps) {
  const HeldUnknowns held = make_held_unknowns(model, model.absent_in(stage));
  const auto ask = [&](const ContactSet& there) {
    const LinearOperators operators = operators_at(model, stage, there, 0);
    return operators.inertia.couplings() > 0 ? 0 : stable_step(operators, held, steps);
  };
  return model.absent_in(stage).empty() ? ask(contacts) : ask(contacts_in(model, stage, contacts));
}

namespace {

double limit_with(const Model& model, std::size_t stage, const ContactSet& contacts) {
  constexpr double close = 1e-5;  // of the limit, to where it is found
  const double dt = model.stages[stage].dt;
  double limit = limit_at(model, stage, contacts, dt);
  if (dt <= limit) return limit;
  for (double tried = dt; std::abs(limit - tried) > close * limit;) {
    tried = limit;
    limit = limit_at(model, stage, contacts, tried);
  }
  return (1 - 10 * close) * limit;
}

}  // namespace

double stability_limit(const Model& model, std::size_t stage, const ContactSet& drawn) {
  if (model.absent_in(stage).empty()) return limit_with(model, stage, drawn);
  return limit_with(model, stage, contacts_in(model, stage, drawn));
}

double stability_limit(const Model& model, std::size_t stage) {
  return stability_limit(model, stage, make_contacts(model));
}

namespace {

// Springs of supports are a thousand times as stiff as the rock unless the scene says otherwise.
std::string remedy_against_supports(Model model, std::size_t stage, double limit) {
  constexpr double worth_saying = 1.3;
  if (model.supports.empty()) return "";
  model.supports.clear();
  const double without = stability_limit(model, stage);
  if (without < worth_saying * limit) return "";
  return fmt::format(
      "; without its supports, whose springs are stiff, it would be {:.3g} s: give them a smaller "
      "stiffness, or fix whole blocks",
      without);
}

// Supports that a stage still has.
std::vector<bool> supported_in(const Model& model, std::size_t stage) {
  std::vector<bool> held;
  for (const PointSupport& support : model.supports)
    held.push_back(support.last_stage < 0 || support.last_stage >= static_cast<int>(stage));
  return held;
}

// True where both stages have the same masses, stiffnesses and corrections.
bool have_same_limit(const Model& model, std::size_t a, std::size_t b) {
  const auto limiting = [](const Stage& stage) {
    return std::tuple(stage.dt, stage.integrator.is_explicit(), stage.strain_inertia, stage.correct_block_dispersion,
                      stage.correct_time_dispersion, stage.lateral_inertia);
  };
  return limiting(model.stages[a]) == limiting(model.stages[b]) && model.absent_in(a) == model.absent_in(b) &&
         supported_in(model, a) == supported_in(model, b);
}

std::size_t first_stage_like(const Model& model, std::size_t stage) {
  std::size_t like = 0;
  while (like < stage && !have_same_limit(model, like, stage)) ++like;
  return like;
}

double rounded_down_to_two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::floor(value / unit) * unit;
}

}  // namespace

void shorten_to(double limit, Stage& stage) {
  const double longest = rounded_down_to_two_digits(limit);
  stage.dt = stage.duration > longest ? stage.duration / std::ceil(stage.duration / longest) : longest;
}

namespace {

// Shorter steps are softened less (ADR 49), so that their own limit is a little shorter, too: by at most half of what
// the margin leaves, and the caller asks for it.
void shorten_below(double limit, Stage& stage) {
  constexpr double margin = 0.95;
  shorten_to(margin * limit, stage);
  stage.chosen.dt.reason = fmt::format("central differences, which are stable up to {:.3g} s here", limit);
}

double limit_of_stage(const Model& model, const ContactSet& drawn, const std::vector<double>& known,
                      std::size_t stage) {
  const std::size_t like = first_stage_like(model, stage);
  return like < stage && known[like] > 0 ? known[like] : stability_limit(model, stage, drawn);
}

}  // namespace

std::vector<double> kept_stability_limits(const ContactSet& drawn, Model& model, std::vector<double> known) {
  std::vector<double> limits = std::move(known);
  limits.resize(model.stages.size(), 0);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    Stage& stage = model.stages[i];
    if (!stage.integrator.is_explicit() || limits[i] > 0) continue;
    limits[i] = limit_of_stage(model, drawn, limits, i);
    if (stage.chosen.dt.automatic && stage.dt > limits[i]) {
      shorten_below(limits[i], stage);
      limits[i] = limit_of_stage(model, drawn, limits, i);
    }
    if (stage.dt <= limits[i]) continue;
    throw InputError("", named(model, i, "dt"), fmt::format("{:.6g} s", stage.dt),
                     fmt::format("at most {:.6g} s, up to which central differences are stable here{}", limits[i],
                                 remedy_against_supports(model, i, limits[i])));
  }
  return limits;
}

}  // namespace dda
