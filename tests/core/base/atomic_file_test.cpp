#include "core/base/atomic_file.h"

#include "core/base/result.h"
#include "tests/support/temporary_folder.h"

#include <cerrno>
#include <csignal>
#include <fstream>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

/// While it lives, no file may grow beyond a size, as on a disk that fills up.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST(AtomicFile, WritesAndReplaces) {
  const TemporaryFolder folder;
  const std::string zeros("a\0b\n", 4), large(3'000'000, 'x');
  for (const std::string& content : {std::string("first"), zeros, large, std::string()}) {
    ASSERT_TRUE(write_file_atomically(folder / "a.txt", content).ok());
    EXPECT_EQ(*read_file(folder / "a.txt"), content);
  }
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"a.txt"});
}

TEST(AtomicFile, FailureLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "a.txt", "old").ok());
  {
    const SmallDisk disk(1000);
    for (std::size_t size : {1001U, 5000U, 2'000'000U}) {
      const Status status = write_file_atomically(folder / "a.txt", std::string(size, 'x'));
      ASSERT_FALSE(status.ok());
      EXPECT_THAT(status.error().where.english(), HasSubstr("a.txt"));
    }
    EXPECT_TRUE(write_file_atomically(folder / "b.txt", std::string(1000, 'x')).ok());
  }
  const Status refused =
      write_file_atomically(folder / "a.txt", [&](const fs::path& temporary) -> Status {
        std::ofstream(temporary) << "half";
        return Error{en::say("the encoder gave up"), "", ""};
      });
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().what.english(), "the encoder gave up");
  EXPECT_EQ(*read_file(folder / "a.txt"), "old");
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"a.txt", "b.txt"}));
}

TEST(AtomicFile, OtherLibrariesWriteBesideTheFileWithItsEnding) {
  const TemporaryFolder folder;
  fs::path seen;
  const auto by_replacing = [&](const fs::path& temporary) -> Status {
    seen = temporary;
    fs::remove(temporary);  // as libraries do that write a temporary of their own
    std::ofstream(temporary) << "new";
    return {};
  };
  ASSERT_TRUE(write_file_atomically(folder / "a.tiff", by_replacing).ok());
  EXPECT_EQ(seen.parent_path(), folder.path());
  EXPECT_EQ(seen.extension(), ".tiff");
  EXPECT_EQ(*read_file(folder / "a.tiff"), "new");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"a.tiff"});
}

TEST(AtomicFile, SaysWhyItCannotWrite) {
  const TemporaryFolder folder;
  const auto sentence = [](const fs::path& file) {
    const Status status = write_file_atomically(file, "x");
    return status.ok() ? std::string("written") : status.error().sentence();
  };
  EXPECT_THAT(sentence(folder / "none/a.txt"), HasSubstr("its folder does not exist"));
  EXPECT_THAT(sentence(folder.path()), HasSubstr("it is a folder"));
  EXPECT_THAT(sentence(folder.path() / ""), HasSubstr("it is a folder"));
  EXPECT_THAT(sentence(folder / std::string(300, 'n')), HasSubstr("too long"));
  ASSERT_TRUE(write_file_atomically(folder / "file", "x").ok());
  EXPECT_THAT(sentence(folder / "file/a.txt"), HasSubstr("folder"));
}

TEST(AtomicFile, SaysThatAccessIsNotAllowed) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "a.txt", "old").ok());
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec |
                                     fs::perms::others_read | fs::perms::others_exec);
  const bool is_root = geteuid() == 0;  // may write everywhere
  if (is_root) {
    ASSERT_EQ(seteuid(65534), 0);
  }
  const Status status = write_file_atomically(folder / "a.txt", "new");
  if (is_root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  fs::permissions(folder.path(), fs::perms::owner_all);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().what.english(), HasSubstr("access is not allowed"));
  EXPECT_EQ(*read_file(folder / "a.txt"), "old");
}

TEST(AtomicFile, FullAndReadOnlyDisksAreNamed) {
  EXPECT_THAT(system_error(en::say("could not write"), "/a/b", ENOSPC).sentence(),
              HasSubstr("/a/b: could not write: the disk is full. Try: free some space"));
  EXPECT_THAT(system_error(en::say("could not write"), "/a/b", EROFS).what.english(),
              HasSubstr("read-only"));
  EXPECT_FALSE(
      system_error(en::say("could not write"), "/a/b", EPIPE).what.english().ends_with(": "));
}

TEST(AtomicFile, KeepsPermissionsAndLinks) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "a.txt", "old").ok());
  fs::permissions(folder / "a.txt", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.txt", folder / "link.txt");
  ASSERT_TRUE(write_file_atomically(folder / "link.txt", "new").ok());
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(*read_file(folder / "a.txt"), "new");
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(AtomicFile, ReadersSeeOldOrNewNeverHalf) {
  const TemporaryFolder folder;
  const std::string a(200'000, 'a'), b(300'000, 'b');
  ASSERT_TRUE(write_file_atomically(folder / "f", a).ok());
  std::atomic<bool> stop{false};
  std::atomic<int> mixtures{0}, reads{0};
  std::thread reader([&] {
    while (!stop) {
      const auto content = read_file(folder / "f");
      ++reads;
      if (!content.ok() || (*content != a && *content != b)) ++mixtures;
    }
  });
  std::thread writer([&] {
    for (int i = 0; i < 20; ++i) (void)write_file_atomically(folder / "f", a).ok();
  });
  for (int i = 0; i < 20 || reads < 5; ++i)
    EXPECT_TRUE(write_file_atomically(folder / "f", i % 2 == 0 ? b : a).ok());
  writer.join();
  stop = true;
  reader.join();
  EXPECT_EQ(mixtures, 0);
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"f"});
}

TEST(ReadFile, SaysWhyItCannotRead) {
  const TemporaryFolder folder;
  EXPECT_THAT(read_file(folder / "none").error().what.english(), HasSubstr("does not exist"));
  EXPECT_THAT(read_file(folder.path()).error().what.english(), HasSubstr("it is a folder"));
  ASSERT_TRUE(write_file_atomically(folder / "a", "12345").ok());
  EXPECT_TRUE(read_file(folder / "a", 5).ok());
  EXPECT_THAT(read_file(folder / "a", 4).error().what.english(), HasSubstr("larger than 4 bytes"));
  EXPECT_THAT(read_file("/dev/zero", 1 << 16).error().what.english(), HasSubstr("larger"));
}

TEST(MakeFolder, MakesParentsAndSaysWhatIsInTheWay) {
  const TemporaryFolder folder;
  EXPECT_TRUE(make_folder(folder / "a/b/c").ok());
  EXPECT_TRUE(make_folder(folder / "a/b/c").ok());
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  ASSERT_TRUE(write_file_atomically(folder / "file", "x").ok());
  EXPECT_FALSE(make_folder(folder / "file").ok());
  EXPECT_THAT(make_folder(folder / "file/inside").error().what.english(), HasSubstr("no folder"));
}

}  // namespace
}  // namespace alltact
