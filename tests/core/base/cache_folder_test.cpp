// Where what can be made again is kept, and for how long.
#include "core/base/cache.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

TEST(CacheFolder, LiesWhereTheUserKeepsSuchThings) {
  const auto variable = [](const char* name) {
    const char* text = std::getenv(name);
    return text != nullptr ? std::optional<std::string>(text) : std::nullopt;
  };
  const auto cache = variable("XDG_CACHE_HOME"), home = variable("HOME");
  const auto put = [](const char* name, const std::optional<std::string>& text) {
    text ? setenv(name, text->c_str(), 1) : unsetenv(name);
  };
  put("XDG_CACHE_HOME", "/var/tmp/c");
  put("HOME", "/home/ada");
  EXPECT_EQ(cache_folder("fingers"), "/var/tmp/c/alltact/fingers");
  put("XDG_CACHE_HOME", "not/absolute");
  EXPECT_EQ(cache_folder("fingers"), "/home/ada/.cache/alltact/fingers");
  put("HOME", {});
  EXPECT_FALSE(cache_folder("fingers"));
  put("XDG_CACHE_HOME", cache);
  put("HOME", home);
}

TEST(CacheFolder, KeepsWhatWasWrittenLast) {
  const TemporaryFolder folder;
  const auto now = fs::file_time_type::clock::now();
  const auto put = [&](const std::string& name, std::chrono::hours old) {
    const fs::path file = folder.path() / name;
    std::ofstream(file) << name;
    fs::last_write_time(file, now - old);
    return file;
  };
  const fs::path oldest = put("a", std::chrono::hours(3)), newest = put("b", std::chrono::hours(1)),
                 between = put("c", std::chrono::hours(2)),
                 unfinished = put(".d", std::chrono::hours(1)),
                 left_over = put(".e", std::chrono::hours(25));
  remove_oldest(folder.path(), 2);
  EXPECT_FALSE(fs::exists(oldest));
  EXPECT_TRUE(fs::exists(newest));
  EXPECT_TRUE(fs::exists(between));
  EXPECT_TRUE(fs::exists(unfinished)) << "somebody may be writing it";
  EXPECT_FALSE(fs::exists(left_over));
  remove_oldest(folder.path() / "not there", 2);
}

}  // namespace
}  // namespace alltact
