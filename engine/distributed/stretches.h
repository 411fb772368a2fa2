// Which rows belong to which process, and how what the first one has comes to the others and back.
#pragma once

#include <mpi.h>

#include <vector>

namespace dda {

// Each process has some consecutive blocks, as many as the others or one more.
class Stretches {
 public:
  explicit Stretches(int blocks = 0);

  [[nodiscard]] int first() const { return begin_of(own_); }
  [[nodiscard]] int last() const { return begin_of(own_ + 1); }  // one beyond
  [[nodiscard]] int size() const { return last() - first(); }
  [[nodiscard]] bool is_first_process() const { return own_ == 0; }

  // How many numbers each process gets, and where they begin in the whole.
  struct Cut {
    std::vector<int> counts, begins;
  };
  // Cuts an array with so many numbers a block, and `more` at the end that the next block begins with.
  [[nodiscard]] Cut cut(int each, int more = 0) const;
  // Cuts one with `each` times starts[i + 1] - starts[i] numbers for block i; `starts` is that of the whole. Empty but
  // in the first process, which alone needs it.
  [[nodiscard]] Cut cut(const int* starts, int each) const;

 private:
  [[nodiscard]] int begin_of(int process) const;

  int blocks_ = 0, own_ = 0, processes_ = 1;
};

// The whole counts in the first process alone. An `own` that is null stays where it is in the whole, which the first
// process may ask for.
void hand_out(const int* whole, const Stretches::Cut& cut, int* own, int count);
void hand_out(const double* whole, const Stretches::Cut& cut, double* own, int count);
void collect(const double* own, int count, const Stretches::Cut& cut, double* whole);

}  // namespace dda
