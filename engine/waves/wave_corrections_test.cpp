#include "engine/waves/wave_corrections.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/make_contacts.h"
#include "engine/linear/dense_modes.h"
#include "engine/terms/inertia.h"
#include "engine/waves/cubic_inertia.h"
#include "engine/waves/mesh_correction.h"

namespace dda {
namespace {

// A motion exp(i theta n) is that of an oscillator whose omega dt is this: the share by which waves are longer or
// shorter than they should be.
double apparent_phase(const Integrator& scheme, double theta) {
  using Complex = std::complex<double>;
  const Complex z = std::polar(1.0, theta);
  const Complex inertia = ((1 - scheme.alpha_m) + scheme.alpha_m / z) * (z - 2.0 + 1.0 / z);
  const Complex time =
      scheme.beta * z + (0.5 + scheme.gamma - 2 * scheme.beta) + (0.5 - scheme.gamma + scheme.beta) / z;
  return std::real(std::sqrt(-inertia / (((1 - scheme.alpha_f) + scheme.alpha_f / z) * time)));
}

TEST(PeriodError, IsThatOfTheIntegrator) {
  for (const Integrator& scheme : {thesis_integrator(), trapezoidal_integrator(), hht_integrator(0.1),
                                   generalized_alpha_integrator(0.8), generalized_alpha_integrator(0)}) {
    // The next term is theta^2 times a number of order one; round-off in theta^2 is amplified by theta^-2.
    constexpr double theta = 0.02;
    const double error = 2 * (apparent_phase(scheme, theta) / theta - 1) / (theta * theta);
    EXPECT_NEAR(error, period_error(scheme), 1e-3) << scheme.name;
  }
  EXPECT_NEAR(period_error(trapezoidal_integrator()), 1.0 / 6, 1e-15);
  EXPECT_NEAR(period_error(thesis_integrator()), -1.0 / 48, 1e-15);
}

constexpr double dt = 1e-4;  // s; steps are a tenth of what a wave needs for a block, and less

Stage corrected_stage() {
  Stage stage;
  stage.dt = stage.duration = dt;
  stage.integrator = trapezoidal_integrator();
  stage.kinematics = Kinematics::small;
  stage.correct_block_dispersion = stage.correct_time_dispersion = true;
  return stage;
}

// A row of squares 1 m wide.
Model row_of(int blocks, InterfaceLaw law, const Stage& stage = corrected_stage()) {
  Model model;
  model.materials = {rock()};
  model.joints = {{.name = "bond", .law = law, .bonded = true}};
  for (int i = 0; i < blocks; ++i) model.blocks.emplace_back().shape.outer = box_ring(i, 0, i + 1, 1);
  model.stages = {stage};
  finish_model(model);
  return model;
}

struct Corrected {
  explicit Corrected(const Model& model)
      : contacts(make_contacts(model)),
        waves(model, model.stages.front(), contacts),
        stiffness(static_cast<int>(model.blocks.size()), all_pairs()),
        inertia(static_cast<int>(model.blocks.size()), waves.coupled_by_inertia(contacts)) {
    waves.add_to_stiffness(model, contacts, stiffness);
    waves.add_to_inertia(model, contacts, inertia);
  }
  [[nodiscard]] std::vector<std::pair<int, int>> all_pairs() const {
    std::vector<std::pair<int, int>> pairs;
    for (const InterfaceElement& element : contacts.elements.own())
      pairs.emplace_back(element.block_a, element.block_b);
    return pairs;
  }

  ContactSet contacts;
  WaveCorrections waves;
  BlockMatrix stiffness, inertia;  // what is added
};

Mat6 coupling(const BlockMatrix& matrix, int row, int column) {
  const int slot = matrix.slot(row, column);
  return slot < 0 ? Mat6(Mat6::Zero()) : Mat6(matrix.offdiagonal(slot));
}

TEST(WaveCorrections, ChainsGetEndsAndInertiaBetweenBlocks) {
  const Model model = row_of(3, InterfaceLaw::cubic);
  const Corrected chain(model);
  const double error = period_error(trapezoidal_integrator());
  const InterfaceMatrices between = cubic_inertia(model, chain.contacts.interfaces[0], error, dt);
  EXPECT_EQ(coupling(chain.inertia, 1, 0), between.ba);
  EXPECT_EQ(Mat6(chain.inertia.diagonal(1)),
            Mat6(between.bb + cubic_inertia(model, chain.contacts.interfaces[1], error, dt).aa));
  const auto ends = free_chain_ends(model, chain.contacts.interfaces, chain.contacts.elements);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(Mat6(chain.inertia.diagonal(0)),
            Mat6(between.aa + end_inertia(model, ends[0], chain.contacts.interfaces[0], error, dt)));
  EXPECT_EQ(Mat6(chain.stiffness.diagonal(0)), end_stiffness(model, ends[0]));
  EXPECT_TRUE(Mat6(chain.stiffness.diagonal(1)).isZero(0));
}

TEST(WaveCorrections, MeshesGetJumpsOfStrainsAndLessInertia) {
  const Model model = row_of(3, InterfaceLaw::consistent);
  const Corrected mesh(model);
  const double error = period_error(trapezoidal_integrator());
  const Interface& interface = mesh.contacts.interfaces[0];
  EXPECT_EQ(coupling(mesh.stiffness, 1, 0), jump_stiffness(model, interface).ba);
  EXPECT_EQ(coupling(mesh.inertia, 1, 0), mesh_inertia(model, interface, error, dt).ba);
  const Mat6 own = mesh_inertia(model, interface, error, dt).aa;
  EXPECT_EQ(Mat6(mesh.inertia.diagonal(0)), Mat6(own - axial_reduction(model, 0, interface.normal, 1, error, dt)));
}

// A stage that asks for nothing has the cubic law's own inertia and ends, which belong to the law, and no more.
TEST(WaveCorrections, NothingThatIsNotAskedFor) {
  Stage plain = corrected_stage();
  plain.correct_block_dispersion = plain.correct_time_dispersion = false;
  const Model mesh_model = row_of(3, InterfaceLaw::consistent, plain);
  const Corrected mesh(mesh_model);
  EXPECT_TRUE(mesh.waves.coupled_by_inertia(mesh.contacts).empty());
  for (int block = 0; block < 3; ++block) {
    EXPECT_TRUE(Mat6(mesh.stiffness.diagonal(block)).isZero(0));
    EXPECT_TRUE(Mat6(mesh.inertia.diagonal(block)).isZero(0));
    EXPECT_EQ(mesh.waves.load_filter(block).share, 0);
  }
  const Model chain_model = row_of(3, InterfaceLaw::cubic, plain);
  const Corrected chain(chain_model);
  EXPECT_EQ(coupling(chain.inertia, 1, 0), cubic_inertia(chain_model, chain.contacts.interfaces[0], 0, dt).ba);
}

TEST(WaveCorrections, InertiaThatIsLeftOutCanBeHadBack) {
  Stage narrow = corrected_stage();
  narrow.lateral_inertia = false;
  const Model model = row_of(3, InterfaceLaw::cubic, narrow);
  const Corrected without(model);
  const Corrected with(row_of(3, InterfaceLaw::cubic));
  EXPECT_TRUE(without.waves.leave_strains_without_inertia());
  EXPECT_FALSE(with.waves.leave_strains_without_inertia());
  const Mat6 lateral = lateral_inertia(model.mass_of(1), model.blocks[1].moments, Vec2::UnitX());
  EXPECT_EQ(Mat6(without.inertia.diagonal(1)), Mat6(with.inertia.diagonal(1) - lateral));
  BlockMatrix again(3, without.waves.coupled_by_inertia(without.contacts));
  without.waves.with_all_inertia().add_to_inertia(model, without.contacts, again);
  EXPECT_EQ(Mat6(again.diagonal(1)), Mat6(with.inertia.diagonal(1)));
}

// The inertia of a row, corrected, over that of its blocks alone: the smallest share that any motion is left with.
double least_share(const Model& model) {
  const Corrected corrected(model);
  const auto size = static_cast<Eigen::Index>(6 * model.blocks.size());
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd added = own;
  for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i) {
    const Inertia inertia{model.mass_of(i), mean_squares(model.blocks[static_cast<std::size_t>(i)].moments), 1};
    own.block<6, 6>(6L * i, 6L * i) = mass_matrix(inertia);
    added.block<6, 6>(6L * i, 6L * i) = corrected.inertia.diagonal(i);
    for (int k = 0; k < i; ++k) {
      added.block<6, 6>(6L * i, 6L * k) = coupling(corrected.inertia, i, k);
      added.block<6, 6>(6L * k, 6L * i) = coupling(corrected.inertia, i, k).transpose();
    }
  }
  return dense_modes(own + added, own).squares.minCoeff();
}

// A row of blocks of two lengths and one in between, of two materials, under steps that a wave needs for a twentieth of
// a metre to five metres.
Model uneven_row(std::mt19937& random) {
  const auto draw = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  Stage stage = corrected_stage();
  stage.integrator = std::array{trapezoidal_integrator(), generalized_alpha_integrator(0.5),
                                generalized_alpha_integrator(0.85), hht_integrator(0.1)}[random() % 4];
  stage.dt = stage.duration = std::pow(10, draw(-1.3, 0.7)) / p_wave_speed(rock());
  const std::array lengths{1.0, draw(0.5, 2), draw(0.5, 2)};
  Model model;
  model.materials = {rock(), rock()};
  model.materials[1].young *= draw(0.2, 1);
  model.joints = {{.name = "bond", .law = InterfaceLaw::cubic, .bonded = true}};
  double left = 0;
  for (int i = 0; i < 12; ++i) {
    const double right = left + lengths[random() % 3];
    model.blocks.emplace_back().shape.outer = box_ring(left, 0, right, 1);
    model.blocks.back().material = static_cast<int>(random() % 4 / 3);
    left = right;
  }
  model.stages = {stage};
  finish_model(model);
  return model;
}

// Whatever the steps: without inertia, or with a negative one, motion grows without bound while the energy balances.
TEST(WaveCorrections, LeaveInertiaToEveryMotionOfUnevenRows) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    EXPECT_GT(least_share(uneven_row(random)), 0.02) << "seed " << seed;
  }
}

double share_of_first(InterfaceLaw law, const Stage& stage = corrected_stage()) {
  const Model model = row_of(3, law, stage);
  return WaveCorrections(model, model.stages.front(), make_contacts(model)).load_filter(0).share;
}

TEST(LoadFilter, OnlyWhereInertiaIsLowered) {
  EXPECT_NEAR(share_of_first(InterfaceLaw::cubic), 1.0 / 6, 1e-12);
  EXPECT_NEAR(share_of_first(InterfaceLaw::consistent), 1.0 / 6, 1e-12);
  EXPECT_EQ(share_of_first(InterfaceLaw::classical), 0);
  Stage plain = corrected_stage();
  plain.correct_time_dispersion = false;
  EXPECT_EQ(share_of_first(InterfaceLaw::cubic, plain), 0);
  Stage still = corrected_stage();
  still.integrator = static_integrator();
  EXPECT_EQ(share_of_first(InterfaceLaw::cubic, still), 0);
}

// Where inertia is at its cap no more is taken from it, and loads must not be sharpened by more than fits that.
TEST(LoadFilter, FollowsTheCapOfTheInertia) {
  Stage coarse = corrected_stage();
  coarse.dt = coarse.duration = 20 * dt;
  const double capped = share_of_first(InterfaceLaw::consistent, coarse);
  const double courant = coarse.dt * s_wave_speed(rock());  // per block of 1 m
  EXPECT_NEAR(capped, mesh::most_correction / (courant * courant), 1e-12);
  EXPECT_LT(capped, 0.9 / 6);
}

TEST(LoadFilter, TakesAwayTheSecondDifference) {
  const auto history = [](double t) { return 1 + t + 5 * t * t; };
  const LoadFilter filter{0.25, 0.1};
  EXPECT_NEAR(filter(history, 2), history(2) - 0.25 * 10 * 0.1 * 0.1, 1e-13);
  EXPECT_EQ(filter(history, 0), 1);  // the start from rest is under the load as given
  EXPECT_EQ(LoadFilter{}(history, 2), history(2));
}

}  // namespace
}  // namespace dda
