// Arithmetic that makes a NaN or divides by zero ends the program, so that none stays unseen.
#pragma once

#include <cfenv>

namespace alltact::test {

/// As long as it lives, 0/0, inf - inf, sqrt(-1) and 1/0 raise SIGFPE. Not where NaN is a marker
/// value: comparing one traps as well.
class Trapping {
 public:
  Trapping() : before_(fegetexcept()) {
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO);
  }
  ~Trapping() {
    std::feclearexcept(FE_ALL_EXCEPT);
    fedisableexcept(FE_ALL_EXCEPT);
    feenableexcept(before_);
  }
  Trapping(const Trapping&) = delete;
  Trapping& operator=(const Trapping&) = delete;

 private:
  int before_;
};

}  // namespace alltact::test
