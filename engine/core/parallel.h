// Work shared by threads, with results that do not depend on how many there are: every element is worked on by one
// thread, in the same arithmetic whichever that is, and sums are taken of fixed pieces, in the order of these.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

namespace dda {

// How many threads share the work from now on, the calling one among them; 1 at first. The others are started when
// there is work for them, and sleep when there is none. Not to be called while work is under way.
void use_threads(int threads);
[[nodiscard]] int threads_in_use();

// Those that the machine lets this process run on.
[[nodiscard]] int cores();

// While it lives; then as many as before.
class ThreadsInUse {
 public:
  explicit ThreadsInUse(int threads) : before_(threads_in_use()) { use_threads(threads); }
  ~ThreadsInUse() { use_threads(before_); }
  ThreadsInUse(const ThreadsInUse&) = delete;
  ThreadsInUse& operator=(const ThreadsInUse&) = delete;

 private:
  int before_;
};

// Calls work(index) for every index below `count`, on as many threads as are in use; returns when all are done. Work
// within work, and of a second thread meanwhile, is done by its caller alone. Allocates nothing once the threads run.
// `work` must not throw.
using PieceOfWork = void (*)(const void* body, std::size_t index);
void share_out(std::size_t count, PieceOfWork work, const void* body);

// The pieces that a range is cut into: as even as can be.
struct Pieces {
  std::size_t elements;
  std::size_t count;

  [[nodiscard]] std::size_t begin_of(std::size_t piece) const { return piece * elements / count; }
};

template <typename Body>
void for_each_piece(const Pieces& pieces, const Body& body) {
  const auto call = [&pieces, &body](std::size_t i) { body(i, pieces.begin_of(i), pieces.begin_of(i + 1)); };
  if (pieces.count == 1 || threads_in_use() == 1) {
    for (std::size_t i = 0; i < pieces.count; ++i) call(i);
  } else {
    share_out(
        pieces.count, [](const void* each, std::size_t i) { (*static_cast<decltype(&call)>(each))(i); }, &call);
  }
}

// Calls body(first, last) for ranges that together are [0, elements), none shorter than `grain` unless all of it is.
// Where they are cut depends on the number of threads.
template <typename Body>
void parallel_for(std::size_t elements, std::size_t grain, const Body& body) {
  constexpr std::size_t pieces_a_thread = 4;  // so that a thread that is kept waiting leaves work to the others
  if (elements < 2 * grain || threads_in_use() == 1) {
    body(std::size_t{0}, elements);
  } else {
    const std::size_t pieces = std::min(elements / grain, pieces_a_thread * static_cast<std::size_t>(threads_in_use()));
    for_each_piece({elements, pieces},
                   [&body](std::size_t, std::size_t first, std::size_t last) { body(first, last); });
  }
}

// act(index) for every index below `count`.
template <typename Act>
void parallel_for_each(std::size_t count, std::size_t grain, const Act& act) {
  parallel_for(count, grain, [&act](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) act(i);
  });
}

// Pieces of a sum: one below twice the grain, so that small sums are those of a plain loop. They know nothing of
// threads.
inline constexpr std::size_t most_sum_pieces = 16;
[[nodiscard]] inline Pieces sum_pieces(std::size_t elements, std::size_t grain) {
  return {elements, elements < 2 * grain ? 1 : most_sum_pieces};
}

// body(first, last) of these pieces, put together from the first to the last.
template <typename Body, typename Combine>
double parallel_reduce(std::size_t elements, std::size_t grain, const Combine& combine, const Body& body) {
  const Pieces pieces = sum_pieces(elements, grain);
  if (pieces.count == 1) return body(std::size_t{0}, elements);
  std::array<double, most_sum_pieces> results{};
  for_each_piece(pieces, [&](std::size_t i, std::size_t first, std::size_t last) { results[i] = body(first, last); });
  double whole = results[0];
  for (std::size_t i = 1; i < most_sum_pieces; ++i) whole = combine(whole, results[i]);
  return whole;
}

// body(first, last, sum) adds what the elements of a range make to `sum`. A range that is not cut goes on from what
// `into` holds; of others each piece begins with `nothing`, and combine(into, piece) puts them together from the first
// to the last.
template <typename Sum, typename Combine, typename Body>
void parallel_accumulate(std::size_t elements, std::size_t grain, Sum& into, const Sum& nothing, const Combine& combine,
                         const Body& body) {
  const Pieces pieces = sum_pieces(elements, grain);
  if (pieces.count == 1) {
    body(std::size_t{0}, elements, into);
    return;
  }
  std::array<Sum, most_sum_pieces> sums;
  sums.fill(nothing);
  for_each_piece(pieces, [&](std::size_t i, std::size_t first, std::size_t last) { body(first, last, sums[i]); });
  for (const Sum& sum : sums) combine(into, sum);
}

// The same for a number.
template <typename Body>
void parallel_add(std::size_t elements, std::size_t grain, double& into, const Body& body) {
  parallel_accumulate(
      elements, grain, into, 0.0, [](double& sum, double piece) { sum += piece; }, body);
}

template <typename Body>
double parallel_sum(std::size_t elements, std::size_t grain, const Body& body) {
  return parallel_reduce(elements, grain, std::plus<double>(), body);
}

}  // namespace dda
