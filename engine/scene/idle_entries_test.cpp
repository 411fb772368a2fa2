// Entries of a scene that would do nothing: loads in situ where nothing is stressed, motions that a support leaves
// free.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

using Random = std::mt19937;

double between(double low, double high, Random& random) { return std::uniform_real_distribution(low, high)(random); }

// A rectangle that is turned by so much, and more entries of a scene.
std::string turned(double angle, const std::string& more) {
  const auto corner = [&](double x, double y) {
    return fmt::format("[{:.17g}, {:.17g}]", std::cos(angle) * x - std::sin(angle) * y,
                       std::sin(angle) * x + std::cos(angle) * y);
  };
  return fmt::format(
      R"({{"dda": 1, "materials": {{"rock": {{"density": 2600, "young": "20 GPa", "poisson": 0.25}}}},
 "joints": {{"default": {{"bonded": true}}}}, "blocks": [{{"polygon": {{"vertices": [{}, {}, {}, {}]}}}}], {}
 "steps": {{"dt": "1 ms", "duration": "1 s"}}}})",
      corner(0, 0), corner(4, 0), corner(4, 2), corner(0, 2), more);
}

std::string pushed(double angle, const char* motion, double along, double across) {
  const double c = std::cos(angle), s = std::sin(angle);
  const std::string history = R"("history": {"table": [[0, 0], [1, 1]]})";
  return turned(angle, fmt::format(R"("supports": [{{"edge": {{"from": [0, 0], "to": [{:.17g}, {:.17g}]}},
 "hold": "normal", "{}": [{:.17g}, {:.17g}], {}}}],)",
                                   4 * c, 4 * s, motion, c * along - s * across, s * along + c * across, history));
}

TEST(IdleEntries, MotionsAlongAFaceThatIsHeldAcross) {
  Random random(2);
  for (int i = 0; i < 30; ++i) {
    const double angle = between(-std::numbers::pi, std::numbers::pi, random);
    const char* motion = i % 3 == 0 ? "velocity" : (i % 3 == 1 ? "displacement" : "acceleration");
    const double size = between(1e-3, 1, random);
    const std::string sentence = refusal(pushed(angle, motion, size, 0));
    EXPECT_NE(sentence.find(fmt::format("supports[0].{} is [", motion)), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("expected a motion across the edge"), std::string::npos) << sentence;
    EXPECT_EQ(refusal(pushed(angle, motion, size, 0.01 * size)), "");
    EXPECT_EQ(refusal(pushed(angle, motion, 0, 0)), "");
  }
}

TEST(IdleEntries, TractionsInSituOfRockWithoutStress) {
  Random random(9);
  const std::string load = R"("loads": [{"edge": "outside", "traction": "in-situ"}],)";
  for (int i = 0; i < 20; ++i) {
    const double angle = between(-1, 1, random);
    const std::string sentence = refusal(turned(angle, load));
    EXPECT_NE(sentence.find("loads[0].traction is \"in-situ\" in rock without any stress"), std::string::npos)
        << sentence;
    const std::string field = fmt::format(R"("stress_field": {{"yy": {:.4g}}},)", between(-5e6, -1e5, random));
    EXPECT_EQ(refusal(turned(angle, field + load)), "");
  }
}

}  // namespace
}  // namespace dda
