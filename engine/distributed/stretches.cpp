#include "engine/distributed/stretches.h"

#include <cstddef>
#include <cstdint>

#include "engine/distributed/ranks.h"

namespace dda {
namespace {

void hand_out(const void* whole, const Stretches::Cut& cut, void* own, int count, MPI_Datatype type) {
  MPI_Scatterv(whole, cut.counts.data(), cut.begins.data(), type, own != nullptr || count == 0 ? own : MPI_IN_PLACE,
               count, type, 0, MPI_COMM_WORLD);
}

}  // namespace

Stretches::Stretches(int blocks) : blocks_(blocks), own_(Ranks::own()), processes_(Ranks::count()) {}

int Stretches::begin_of(int process) const {
  return static_cast<int>(static_cast<std::int64_t>(blocks_) * process / processes_);
}

Stretches::Cut Stretches::cut(int each, int more) const {
  Cut cut;
  for (int process = 0; process < processes_; ++process) {
    cut.counts.push_back(each * (begin_of(process + 1) - begin_of(process)) + more);
    cut.begins.push_back(each * begin_of(process));
  }
  return cut;
}

Stretches::Cut Stretches::cut(const int* starts, int each) const {
  Cut cut;
  for (int process = 0; process < processes_ && is_first_process(); ++process) {
    const int begin = starts[begin_of(process)];
    cut.counts.push_back(each * (starts[begin_of(process + 1)] - begin));
    cut.begins.push_back(each * begin);
  }
  return cut;
}

void hand_out(const int* whole, const Stretches::Cut& cut, int* own, int count) {
  hand_out(whole, cut, own, count, MPI_INT);
}

void hand_out(const double* whole, const Stretches::Cut& cut, double* own, int count) {
  hand_out(whole, cut, own, count, MPI_DOUBLE);
}

void collect(const double* own, int count, const Stretches::Cut& cut, double* whole) {
  MPI_Gatherv(own, count, MPI_DOUBLE, whole, cut.counts.data(), cut.begins.data(), MPI_DOUBLE, 0, MPI_COMM_WORLD);
}

}  // namespace dda
