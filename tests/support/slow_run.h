// Tests that try often try less often by default; `packaging/test --slow` (ALLTACT_SLOW=1) runs
// them whole.
#pragma once

#include <cstdlib>

namespace alltact::test {

inline bool is_slow_run() { return std::getenv("ALLTACT_SLOW") != nullptr; }

/// How many fingers, runs or rounds: a handful, or as many as a figure needs.
inline int as_many_as(int quick, int slow) { return is_slow_run() ? slow : quick; }

}  // namespace alltact::test
