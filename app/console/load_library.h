// Parts of the program that are loaded when they are needed.
#pragma once

#include <string>

namespace alltact {

/// A function of a part of this program, or the reason why there is none.
struct Loaded {
  void* function = nullptr;
  std::string problem;  ///< the loader's words; empty where there is a function
};

/// Loads liballtact-NAME.so, from next to the program while developing and from its installation
/// folder otherwise, and looks up `function` in it. A library stays loaded.
[[nodiscard]] Loaded load_function(const std::string& name, const char* function);

}  // namespace alltact
