// The calculations that plain formulas get wrong where a finger is used: what the plain formula
// makes of each, what ours does, and how wrong ours may be. For the tests, and for whoever wants to
// see that a computer calculates as it should.
#pragma once

#include <string>
#include <vector>

namespace alltact {

struct HardCase {
  std::string what;        ///< "sine of the angle a ball of 1e-8 rad fills"
  std::string plain;       ///< the formula or method that fails: "sqrt(1 - cos^2)"
  std::string unit;        ///< of the three errors: "relative", "mm", "px", ...
  double plain_error = 0;  ///< infinite where it gave no number
  double our_error = 0;
  double bound = 0;

  /// Our error is a number within the bound.
  [[nodiscard]] bool holds() const { return our_error <= bound; }
  /// The plain formula's error is not.
  [[nodiscard]] bool plain_fails() const { return !(plain_error <= bound); }
};

/// Works out all of them, in a few seconds. Truth is arithmetic in 50 digits, or what the
/// data were made from; every random number has a fixed seed.
[[nodiscard]] std::vector<HardCase> hard_cases();

}  // namespace alltact
