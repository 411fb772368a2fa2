#include "verification/suite/expect.h"

#include <utility>

namespace verify {

Quantity::Quantity(const std::string& name, const std::string& unit) {
  assertion_.quantity = name;
  assertion_.unit = unit;
}

MeasuredQuantity Quantity::is(double value) const {
  Assertion assertion = assertion_;
  assertion.value = value;
  return MeasuredQuantity(std::move(assertion));
}

MeasuredQuantity::MeasuredQuantity(Assertion assertion) : assertion_(std::move(assertion)) {}

Expectation MeasuredQuantity::against(double reference, const std::string& source) const {
  Assertion assertion = assertion_;
  assertion.reference = reference;
  assertion.source = source;
  assertion.error = relative_error(assertion.value, reference);
  return Expectation(std::move(assertion));
}

Expectation::Expectation(Assertion assertion) : assertion_(std::move(assertion)) {}

Expectation Expectation::absolutely() const { return off_by(assertion_.value - assertion_.reference); }

Expectation Expectation::off_by(double error) const {
  Assertion assertion = assertion_;
  assertion.error = error;
  return Expectation(std::move(assertion));
}

Expectation Expectation::of_order(const Order& order) const {
  Assertion assertion = assertion_;
  assertion.order = order;
  return Expectation(std::move(assertion));
}

Assertion Expectation::within(double tolerance, const std::string& reason) const {
  Assertion assertion = assertion_;
  assertion.tolerance = tolerance;
  assertion.tolerance_reason = reason;
  return assertion;
}

Quantity expect(const std::string& quantity, const std::string& unit) { return {quantity, unit}; }

}  // namespace verify
