// dda run --threads: the same bytes with one thread, two and four.
#include <string>

#include "engine/app/command_line_test_support.h"

namespace dda {
namespace {

// Large enough for all that threads share but sums (engine/linear/block_vectors.h).
constexpr auto bonded_grid = R"({"dda": 1, "title": "grid",
 "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25}},
 "joints": {"default": {"bonded": true}},
 "blocks": {"grid": {"columns": 50, "rows": 44, "block_width": 1, "block_height": 1}},
 "loads": [{"edge": "left", "force": ["1 MN", 0], "history": {"sine": {"frequency": "100 Hz"}}}],
 "measurements": [{"name": "stress", "quantity": "stress_xx", "point": [1.5, 0.5]}],
 "steps": {"dt": 1e-5, "duration": 4e-5, "kinematics": "small"}})";

// Large enough for shared products of the contact passes.
constexpr auto dry_wall = R"({"dda": 1, "title": "wall", "gravity": 9.81,
 "materials": {"brick": {"density": 1900, "young": "5 GPa", "poisson": 0.15}},
 "joints": {"default": {"friction_angle": "35 deg"}},
 "blocks": [{"polygon": {"name": "floor", "vertices": [[-1, -1], [31, -1], [31, 0], [-1, 0]]}},
            {"grid": {"name": "wall", "columns": 30, "rows": 24, "pattern": "running_bond",
                      "block_width": 1, "block_height": 0.5}}],
 "supports": [{"edge": "bottom"}],
 "measurements": [{"name": "foot", "quantity": "stress_yy", "point": [4.5, 0.25]}],
 "steps": {"dt": "1 ms", "duration": "4 ms"}})";

// As many blocks, of any shape and size, that slide on each other.
constexpr auto jointed_rock = R"({"dda": 1, "title": "rock", "gravity": 9.81,
 "materials": {"rock": {"density": 2600, "young": "20 GPa", "poisson": 0.25}},
 "joints": {"default": {"friction_angle": "30 deg"}},
 "blocks": {"rock": {"boundary": [[-15, -12], [15, -12], [15, 12], [-15, 12]], "joint_sets": [
   {"name": "bedding", "dip": {"mean": "10 deg", "deviation": "3 deg"}, "spacing": "1 m", "joint": "default"},
   {"name": "cross", "dip": {"mean": "80 deg", "deviation": "5 deg"}, "spacing": "1 m", "joint": "default"}]}},
 "supports": [{"edge": "bottom"}],
 "measurements": [{"name": "top", "quantity": "displacement_y", "point": [0.3, 11.7]}],
 "steps": {"dt": "0.05 ms", "duration": "0.2 ms"}})";

class ThreadsRun : public CommandLine {
 protected:
  void expect_same_bytes(const std::string& scene) {
    write("scene.json", scene);
    const auto alone = run("1");
    for (const char* threads : {"2", "4"}) EXPECT_EQ(run(threads), alone) << threads << " threads";
  }

 private:
  std::map<std::string, std::string> run(const std::string& threads) {
    const Outcome outcome =
        call({"run", path("scene.json"), "--out", path("results"), "--frames", "2", "--threads", threads});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return results_without_times("results");
  }
};

TEST_F(ThreadsRun, BondedGridIsTheSame) { expect_same_bytes(bonded_grid); }

TEST_F(ThreadsRun, DryWallIsTheSame) { expect_same_bytes(dry_wall); }

TEST_F(ThreadsRun, JointedRockIsTheSame) { expect_same_bytes(jointed_rock); }

TEST_F(ThreadsRun, NumbersThatAreNoneAreRefused) {
  write("scene.json", bonded_grid);
  for (const char* threads : {"0", "-1", "two", "1.5", "1025"})
    expect_refusal({"run", path("scene.json"), "--out", path("out"), "--threads", threads},
                   "--threads: is \"" + std::string(threads) + "\", expected a whole number from 1 to 1024");
}

}  // namespace
}  // namespace dda
