// Assertions that read as sentences:
//
//   expect("slip after 2 s", "m").is(slip).against(expected, "a t^2/2").within(1e-4, "of second order in dt")
//
// The error is relative to the reference unless `absolutely` or `off_by` says otherwise.
#pragma once

#include <string>

#include "verification/suite/case.h"

namespace verify {

class Expectation {
 public:
  explicit Expectation(Assertion assertion);

  // The error is the difference from the reference.
  [[nodiscard]] Expectation absolutely() const;
  // The error is this one, of which the quantity's name says what it is relative to.
  [[nodiscard]] Expectation off_by(double error) const;
  [[nodiscard]] Expectation of_order(const Order& order) const;

  // `reason`: theory, source, or measured with margin.
  [[nodiscard]] Assertion within(double tolerance, const std::string& reason) const;

 private:
  Assertion assertion_;
};

class MeasuredQuantity {
 public:
  explicit MeasuredQuantity(Assertion assertion);

  // `source`: formula with book or paper and equation, or what of verification/exact computes it.
  [[nodiscard]] Expectation against(double reference, const std::string& source) const;

 private:
  Assertion assertion_;
};

class Quantity {
 public:
  Quantity(const std::string& name, const std::string& unit);

  [[nodiscard]] MeasuredQuantity is(double value) const;

 private:
  Assertion assertion_;
};

[[nodiscard]] Quantity expect(const std::string& quantity, const std::string& unit);

}  // namespace verify
