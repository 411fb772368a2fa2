#include "verification/exact/viscous_reflection.h"

#include <Eigen/LU>
#include <cmath>

namespace exact {
namespace {

using Complex = std::complex<double>;
using Vector2 = Eigen::Vector2cd;

// One of the four waves of slowness p along the edge; towards the edge (+1) or away from it (-1). Density 1.
class EdgeWave {
 public:
  EdgeWave(const ViscousEdge& edge, PlaneWave kind, double towards, double slowness) : edge_(edge) {
    const double speed = kind == PlaneWave::p ? edge.p_speed : edge.s_speed;
    const double sine = speed * slowness;
    const Complex cosine = towards * std::conj(std::sqrt(Complex(1 - sine * sine)));
    slowness_ = Vector2(cosine, sine) / speed;
    if (kind == PlaneWave::p) {
      polarization_ = {cosine, sine};
    } else {
      polarization_ = {-sine, cosine};
    }
    flux_ = speed * cosine.real();
  }

  // What this wave adds to the two conditions.
  [[nodiscard]] Vector2 conditions() const {
    const double mu = edge_.s_speed * edge_.s_speed;
    const double lambda = edge_.p_speed * edge_.p_speed - 2 * mu;
    const Vector2& s = slowness_;
    const Vector2& d = polarization_;
    const Complex dilation = s(0) * d(0) + s(1) * d(1);
    return {lambda * dilation + 2 * mu * s(0) * d(0) - edge_.across * edge_.p_speed * d(0),
            mu * (s(0) * d(1) + s(1) * d(0)) - edge_.along * edge_.s_speed * d(1)};
  }

  [[nodiscard]] const Vector2& polarization() const { return polarization_; }
  // Energy through the edge for unit amplitude, over omega^2/2.
  [[nodiscard]] double flux() const { return flux_; }

 private:
  ViscousEdge edge_;
  Vector2 slowness_, polarization_;
  double flux_ = 0;
};

}  // namespace

Reflection reflect(const ViscousEdge& edge, PlaneWave incident, double angle) {
  const double slowness = std::sin(angle) / (incident == PlaneWave::p ? edge.p_speed : edge.s_speed);
  const EdgeWave in(edge, incident, 1, slowness);
  const EdgeWave p(edge, PlaneWave::p, -1, slowness);
  const EdgeWave s(edge, PlaneWave::s, -1, slowness);
  Eigen::Matrix2cd reflected;
  reflected << p.conditions(), s.conditions();
  const Vector2 amplitudes = reflected.partialPivLu().solve(-in.conditions());
  const Vector2 edge_velocity = in.polarization() + amplitudes(0) * p.polarization() + amplitudes(1) * s.polarization();
  const double power = edge.across * edge.p_speed * std::norm(edge_velocity(0)) +
                       edge.along * edge.s_speed * std::norm(edge_velocity(1));
  return {amplitudes(0), amplitudes(1), -std::norm(amplitudes(0)) * p.flux() / in.flux(),
          -std::norm(amplitudes(1)) * s.flux() / in.flux(), power / in.flux()};
}

}  // namespace exact
