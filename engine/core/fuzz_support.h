// For tests that feed readers with damaged files. Every input has a number from which all of it follows, so that one
// that fails can be looked at alone. How it is used, and how long runs are made, is in the README of this folder.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/allocation_counter.h"
#include "engine/core/error.h"
#include "engine/core/mutator.h"

namespace dda {

// A number from the environment.
inline std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

// Says which input was at work when the process is ended by a crash, or by an input that takes longer than allowed.
class InputWatch {
 public:
  explicit InputWatch(std::uint64_t number) {
    current() = number;
    for (const int signal : {SIGALRM, SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) std::signal(signal, tell);
    ::alarm(static_cast<unsigned>(number_from_environment("DDA_FUZZ_SECONDS", 60)));
  }
  ~InputWatch() { ::alarm(0); }
  InputWatch(const InputWatch&) = delete;
  InputWatch& operator=(const InputWatch&) = delete;

 private:
  static std::uint64_t& current() {
    static std::uint64_t number = 0;
    return number;
  }

  // Calls only what a signal handler may call.
  static void tell(int signal) {
    std::array<char, 21> digits{};
    char* first = digits.data() + digits.size() - 1;
    *first = '\n';
    for (std::uint64_t rest = current(); first > digits.data(); rest /= 10) {
      *--first = static_cast<char>('0' + rest % 10);
      if (rest < 10) break;
    }
    constexpr std::string_view words = "ended by input DDA_FUZZ_FIRST=";
    static_cast<void>(::write(STDERR_FILENO, words.data(), words.size()));
    static_cast<void>(::write(STDERR_FILENO, first, static_cast<std::size_t>(digits.data() + digits.size() - first)));
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
};

struct FuzzTally {
  std::uint64_t taken = 0;
  std::uint64_t refused = 0;
};

// What a refusal must be: one sentence of a length that can be read.
inline void expect_sentence(const std::string& text) {
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  EXPECT_FALSE(text.empty());
  EXPECT_LT(text.size(), 4000U);
}

// What readers may ask for at once, for an input of so many bytes: a multiple of what is there.
inline std::size_t most_allocated_for(std::size_t bytes) { return (std::size_t{1} << 26) + 256 * bytes; }

struct FuzzPlan {
  std::uint64_t inputs = 1000;       // unless DDA_FUZZ_INPUTS says otherwise; the first is DDA_FUZZ_FIRST or 0
  std::size_t most_bytes = 1 << 20;  // of an input, for the bound on allocations
};

// Calls `read` with a mutator for every input; it mutates what it likes, reads that and checks what was read.
// InputError is a refusal; any other exception fails the test, and so does an allocation beyond the bound.
inline FuzzTally fuzz(const FuzzPlan& plan, const std::function<void(Mutator&)>& read) {
  const std::uint64_t first = number_from_environment("DDA_FUZZ_FIRST", 0);
  const std::uint64_t count = number_from_environment("DDA_FUZZ_INPUTS", plan.inputs);
  FuzzTally tally;
  for (std::uint64_t number = first; number < first + count && !testing::Test::HasFailure(); ++number) {
    SCOPED_TRACE("DDA_FUZZ_FIRST=" + std::to_string(number));
    const InputWatch watch(number);
    Mutator mutator(number);
    forget_largest_allocation();
    try {
      read(mutator);
      ++tally.taken;
    } catch (const InputError& error) {
      expect_sentence(error.what());
      ++tally.refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "neither read nor refused: " << error.what();
    }
    EXPECT_LE(largest_allocation(), most_allocated_for(plan.most_bytes));
  }
  testing::Test::RecordProperty("taken", std::to_string(tally.taken));
  testing::Test::RecordProperty("refused", std::to_string(tally.refused));
  if (count > plan.inputs)
    std::printf("%llu inputs read, %llu refused\n", static_cast<unsigned long long>(tally.taken),
                static_cast<unsigned long long>(tally.refused));
  return tally;
}

// Both must happen often, or the mutations try nothing.
inline void expect_both(const FuzzTally& tally) {
  const std::uint64_t all = tally.taken + tally.refused;
  EXPECT_GE(tally.taken, all / 50) << tally.refused << " refused";
  EXPECT_GE(tally.refused, all / 50) << tally.taken << " taken";
}

}  // namespace dda
