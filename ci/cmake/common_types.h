// For the precompiled headers alone: class templates of Eigen that nearly every source instantiates, instantiated once.
//
// sizeof and decltype make the compiler lay out a class without the bodies of its functions, which each source would
// compile again.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <utility>
#include <vector>

namespace dda::common_types {

template <typename Vector>
const Vector& a() noexcept;

template <typename Matrix>
constexpr bool is_laid_out = sizeof(Matrix) > 0 && sizeof(decltype(Matrix::Zero())) > 0;

template <typename Vector>
constexpr bool is_computed_with =
    is_laid_out<Vector> && sizeof(decltype(a<Vector>() + 2.0 * (a<Vector>() - a<Vector>()))) > 0 &&
    sizeof(decltype((a<Vector>() - a<Vector>()).squaredNorm() + a<Vector>().norm())) > 0 &&
    sizeof(decltype(a<Vector>().dot(a<Vector>() - a<Vector>()) + a<Vector>().dot(a<Vector>()))) > 0 &&
    sizeof(decltype(-a<Vector>() / 2.0)) > 0;

static_assert(is_computed_with<Eigen::Vector2d> && is_computed_with<Eigen::Vector3d>);
static_assert(is_laid_out<Eigen::Vector4d> && is_laid_out<Eigen::Matrix<double, 6, 1>> && is_laid_out<Eigen::VectorXd>);
static_assert(is_laid_out<Eigen::Matrix2d> && is_laid_out<Eigen::Matrix3d> && is_laid_out<Eigen::Matrix<double, 6, 6>>);
static_assert(is_laid_out<Eigen::Matrix<double, 2, 6>> && is_laid_out<Eigen::Matrix<double, 4, 6, Eigen::RowMajor>> &&
              is_laid_out<Eigen::Matrix<double, 4, 3>>);
static_assert(sizeof(decltype(Eigen::Matrix2d::Identity().col(0))) > 0);
static_assert(sizeof(std::vector<double>) > 0 && sizeof(std::vector<int>) > 0 && sizeof(std::optional<double>) > 0 &&
              sizeof(std::vector<std::vector<Eigen::Vector2d>>) > 0 && sizeof(std::vector<Eigen::Vector2d>) > 0 &&
              sizeof(std::optional<Eigen::Vector2d>) > 0);

}  // namespace dda::common_types
