// Manual pages as a reader of manual pages judges them.
#include "tests/support/program.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string shown(const fs::path& page) {
  const ProgramRun run =
      run_shell("LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings -E UTF-8 -l '" + page.string() + "'");
  EXPECT_EQ(run.status, 0) << page;
  EXPECT_EQ(run.errors, "") << page;
  return run.output;
}

/// As it stands, whatever the line's width and the hyphens.
std::string squeezed(const std::string& text) {
  std::string letters;
  for (const char letter : text)
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) letters += letter;
  return letters;
}

/// What a help says of each option: what stands behind its names, or below them.
std::vector<std::string> descriptions_in(const std::string& help) {
  constexpr std::size_t kColumn = 30;  // as CLI11 lays it out
  std::vector<std::string> descriptions;
  std::istringstream lines(help.substr(help.find("Options:")));
  for (std::string line; std::getline(lines, line) && !line.starts_with("Exit status");)
    if (line.size() > kColumn && line.substr(kColumn - 2, 2) == "  " && line[kColumn] != ' ')
      descriptions.push_back(line.substr(kColumn));
  EXPECT_GE(descriptions.size(), 2U);
  return descriptions;
}

TEST(ManPages, EachIsCleanAndTellsWhatTheHelpTells) {
  int pages = 0;
  for (const auto& entry : fs::directory_iterator(std::string(ALLTACT_BUILT_SHARE) + "/man")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".1") continue;
    ++pages;
    const std::string text = shown(entry.path());
    EXPECT_THAT(text, HasSubstr("NAME\n")) << name;
    EXPECT_THAT(text, HasSubstr("SYNOPSIS\n")) << name;
    EXPECT_THAT(text, HasSubstr(name + " - ")) << name;
    if (!name.starts_with("alltact-") || name == "alltact-studio") continue;
    const std::string all = squeezed(text);
    for (const std::string& words : descriptions_in(run_alltact({name.substr(8), "--help"}).output))
      EXPECT_THAT(all, HasSubstr(squeezed(words))) << name;
  }
  EXPECT_GE(pages, 19);
}

}  // namespace
}  // namespace alltact::test
