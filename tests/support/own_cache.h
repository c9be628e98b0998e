// What a program of the tests keeps from one run to the next lies apart from the user's cache.
#pragma once

#include "tests/support/temporary_folder.h"

#include <cstdlib>
#include <optional>

namespace alltact::test {

/// From here to its end; programs that are started meanwhile keep their things here too, and leave
/// them when they are killed.
class OwnCache {
 public:
  OwnCache() {
    constexpr const char* kIsOwn = "ALLTACT_CACHE_OF_TESTS";
    if (std::getenv(kIsOwn) != nullptr) return;
    folder_.emplace();
    setenv(kIsOwn, "1", 1);
    setenv("XDG_CACHE_HOME", folder_->path().c_str(), 1);
  }

 private:
  std::optional<TemporaryFolder> folder_;
};

}  // namespace alltact::test
