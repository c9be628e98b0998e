// Locales of glibc, made for tests.
#pragma once

#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace alltact::test {

/// "C", "tr_TR.UTF-8", "de_DE.UTF-8" and "zh_CN.UTF-8", made once; without those that localedef
/// cannot make here.
inline const std::vector<std::string>& locales() {
  static const TemporaryFolder folder;
  static const std::vector<std::string> made = [] {
    ::setenv("LOCPATH", folder.path().c_str(), 1);
    std::vector<std::string> names{"C"};
    for (const std::string name : {"tr_TR", "de_DE", "zh_CN"}) {
      const std::string locale = name + ".UTF-8";
      // Its status tells of warnings, too.
      [[maybe_unused]] const int status =
          std::system(fmt::format("localedef -i {} -f UTF-8 '{}' >/dev/null 2>&1", name,
                                  (folder / locale).string())
                          .c_str());
      if (std::setlocale(LC_ALL, locale.c_str()) != nullptr) names.push_back(locale);
    }
    std::setlocale(LC_ALL, "C");
    return names;
  }();
  return made;
}

inline bool is_made(const std::string& locale) {
  return std::find(locales().begin(), locales().end(), locale) != locales().end();
}

}  // namespace alltact::test
