// Files that change together; what power cuts leave of that is tried in
// tests/app/power_cut_test.cpp.
#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::size_t entries_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class FolderChanges : public testing::Test {
 protected:
  FolderChanges() {
    put("a", "old a");
    put("gone", "old");
  }
  void put(const std::string& name, const std::string& text) const {
    ASSERT_TRUE(write_file_atomically(folder_ / name, text));
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    const auto content = read_file(folder_ / name);
    return content ? *content : "none";
  }
  [[nodiscard]] FolderChange begun() const {
    auto change = FolderChange::begin(folder_.path());
    EXPECT_TRUE(change) << change.error().sentence();
    EXPECT_TRUE(write_file_atomically(change->staged() / "a", "new a"));
    EXPECT_TRUE(make_folder(change->staged() / "deep/er"));
    EXPECT_TRUE(write_file_atomically(change->staged() / "deep/er/b c", "new b"));
    change->remove("gone");
    change->remove("never there");
    return std::move(*change);
  }
  TemporaryFolder folder_;
};

TEST_F(FolderChanges, TakeTheirPlacesTogether) {
  FolderChange change = begun();
  EXPECT_EQ(text("a"), "old a");
  ASSERT_TRUE(change.commit());
  EXPECT_EQ(text("a"), "new a");
  EXPECT_EQ(text("deep/er/b c"), "new b");
  EXPECT_EQ(text("gone"), "none");
  EXPECT_EQ(entries_in(folder_.path()), 2U);
}

TEST_F(FolderChanges, AreNothingUntilThen) {
  { const FolderChange change = begun(); }
  EXPECT_EQ(text("a"), "old a");
  EXPECT_EQ(text("gone"), "old");
  EXPECT_EQ(entries_in(folder_.path()), 2U);
  EXPECT_FALSE(has_open_change(folder_.path()));
}

TEST_F(FolderChanges, AreCompletedByTheNextFromAnyMoment) {
  ASSERT_TRUE(make_folder(folder_ / ".change-1"));
  put(".change-1/a", "new a");
  put("b", "new b");  // was moved already
  put(".change.list", "alltact-change/1\nfrom .change-1\ntake a\ntake b\nremove gone\nend\n");
  ASSERT_TRUE(has_open_change(folder_.path()));
  ASSERT_TRUE(complete_change(folder_.path()));
  EXPECT_EQ(text("a"), "new a");
  EXPECT_EQ(text("b"), "new b");
  EXPECT_EQ(text("gone"), "none");
  EXPECT_EQ(entries_in(folder_.path()), 2U);
  EXPECT_TRUE(complete_change(folder_.path()));
}

TEST_F(FolderChanges, OfWhomNothingWasDecidedAreSwept) {
  ASSERT_TRUE(make_folder(folder_ / ".change-1"));
  put(".change-1/a", "half");
  { const FolderChange change = begun(); }
  EXPECT_EQ(entries_in(folder_.path()), 2U);
  EXPECT_EQ(text("a"), "old a");
}

TEST_F(FolderChanges, NeverReachOutOfTheirFolder) {
  for (const char* line :
       {"take ../out", "take /etc/x", "remove ../../x", "from ..", "from x", "nonsense", "take "}) {
    put(".change.list", std::string("alltact-change/1\nfrom .change-1\n") + line + "\nend\n");
    const Status status = complete_change(folder_.path());
    ASSERT_FALSE(status) << line;
    EXPECT_THAT(status.error().sentence(), HasSubstr("not a list of files to be changed"));
  }
  put(".change.list", "alltact-change/1\nfrom .change-1\ntake a\n");
  EXPECT_FALSE(complete_change(folder_.path())) << "cut off";
  EXPECT_EQ(text("a"), "old a");
}

TEST_F(FolderChanges, FollowNoLink) {
  const TemporaryFolder elsewhere;
  ASSERT_TRUE(write_file_atomically(elsewhere / "theirs", "theirs"));
  fs::create_directory_symlink(elsewhere.path(), folder_ / "deep");
  put(".change.list", "alltact-change/1\nfrom .change-1\nremove deep/theirs\nend\n");
  const Status removed = complete_change(folder_.path());
  ASSERT_FALSE(removed);
  EXPECT_THAT(removed.error().sentence(), HasSubstr("a link to elsewhere"));
  fs::remove(folder_ / ".change.list");
  const Status moved = begun().commit();
  ASSERT_FALSE(moved);
  EXPECT_THAT(moved.error().sentence(), HasSubstr("a link to elsewhere"));
  EXPECT_EQ(entries_in(elsewhere.path()), 1U);
  EXPECT_EQ(text("a"), "old a");
  EXPECT_FALSE(has_open_change(folder_.path())) << "nothing was decided";
}

}  // namespace
}  // namespace alltact::test
