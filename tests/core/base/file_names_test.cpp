#include "core/base/file_names.h"

#include "tests/support/temporary_folder.h"

#include <fstream>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

// As one character, and as its letters and marks (from Unicode's charts).
struct Look {
  const char *composed, *decomposed;
};
constexpr Look kLooks[] = {
    {"Fl\u00E4che", "Fla\u0308che"},          // German
    {"\u00E9prouvette", "e\u0301prouvette"},  // French
    {"\u1EC7", "e\u0323\u0302"},              // Vietnamese: two marks
    {"\uD55C", "\u1112\u1161\u11AB"},         // Korean: a syllable of three letters
    {"\u304C", "\u304B\u3099"},               // Japanese
};

TEST(FileNames, LettersWithMarksAreComposed) {
  for (const auto& [one, two] : kLooks) {
    EXPECT_EQ(composed(two), one);
    EXPECT_EQ(composed(one), one);
  }
  EXPECT_EQ(composed("e\u0302\u0323"), composed("e\u0323\u0302")) << "marks have an order";
  for (const std::string other : {"plain.mkv", "\xFF\xFE", "a\xCC", ""})
    EXPECT_EQ(composed(other), other);
}

TEST(FileNames, APathFindsWhatLooksLikeIt) {
  for (const auto& [one, two] : kLooks) {
    for (const auto& [stored, typed] : {std::pair{two, one}, std::pair{one, two}}) {
      const TemporaryFolder folder;
      const fs::path file = folder / stored / (std::string(stored) + ".png");
      fs::create_directories(file.parent_path());
      std::ofstream(file) << "x";
      EXPECT_EQ(as_stored(folder / typed / (std::string(typed) + ".png")), file);
      EXPECT_EQ(as_stored(file), file);
      // What does not exist yet, in a folder that does.
      EXPECT_EQ(as_stored(folder / typed / "new.mkv"), folder / stored / "new.mkv");
      EXPECT_EQ(as_stored(folder / "none" / typed), folder / "none" / typed);
    }
  }
}

TEST(FileNames, OfTwoThatLookTheSameTheTypedOneIsMeant) {
  const TemporaryFolder folder;
  const std::string one = "e\u0323\u0302", other = "\u1EB9\u0302", typed = "\u1EC7";
  for (const std::string& name : {one, other}) std::ofstream(folder / name) << "x";
  EXPECT_EQ(as_stored(folder / one), folder / one);
  EXPECT_EQ(as_stored(folder / other), folder / other);
  EXPECT_EQ(as_stored(folder / typed), folder / typed) << "which of the two is unknown";
}

}  // namespace
}  // namespace alltact::test
