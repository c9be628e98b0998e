#include "core/base/zip_file.h"

#include "core/base/atomic_file.h"
#include "tests/support/program.h"
#include "tests/support/python.h"

#include <chrono>
#include <csignal>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

/// Some that pack well, some that do not, an empty one, and a name of many letters.
std::vector<ZipEntry> some_entries(const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<ZipEntry> entries;
  const auto add = [&](const std::string& name, const std::string& content) {
    const fs::path file = folder / fmt::format("{}.bin", entries.size());
    EXPECT_TRUE(write_file_atomically(file, content).ok());
    entries.push_back({name, file, {}});
  };
  std::string noise(300'000, '\0');
  std::uint32_t state = 1;
  for (char& byte : noise) byte = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
  add("finger/words.txt", std::string(200'000, 'a'));
  add("finger/noise.mkv", noise);
  add("finger/presses/手指 \"1\".png", noise.substr(0, 1000));
  add("finger/empty", "");
  entries.push_back({"told.json", {}, "{}\n"});
  return entries;
}

std::string content_of(const ZipEntry& entry) {
  return entry.file.empty() ? entry.content : *read_file(entry.file);
}

/// Names and sizes as Python's zipfile reads them, after it has checked every sum.
std::string as_python_reads(const fs::path& archive, const fs::path& into) {
  const test::ProgramRun run = test::run_shell(fmt::format(
      "{} -c \"import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; "
      "z.extractall(sys.argv[2]); print([(i.filename, i.date_time, i.external_attr >> 16) for i in "
      "z.infolist()])\" '{}' '{}'",
      test::kPython, archive.string(), into.string()));
  EXPECT_EQ(run.status, 0) << run.errors;
  return run.output;
}

TEST(ZipFile, AnotherProgramFindsEveryByte) {
  const TemporaryFolder folder;
  const auto entries = some_entries(folder / "in");
  ASSERT_TRUE(write_zip(folder / "a.zip", entries, Job()).ok());
  const std::string told = as_python_reads(folder / "a.zip", folder / "out");
  std::size_t before = 0;
  for (const ZipEntry& entry : entries) {
    EXPECT_EQ(*read_file(folder / ("out/" + entry.name)), content_of(entry)) << entry.name;
    const std::size_t place = told.find(entry.name.substr(0, 12));
    ASSERT_NE(place, std::string::npos);
    EXPECT_GE(place, before) << "in their order";
    before = place;
  }
  EXPECT_EQ(test::contents_of(folder / "out").size(), entries.size());
  EXPECT_THAT(told, HasSubstr("('finger/words.txt', (1980, 1, 1, 0, 0, 0), 33188)"));
  EXPECT_LT(fs::file_size(folder / "a.zip"), 310'000U) << "what can be packed is";
}

TEST(ZipFile, BytesDependOnNamesAndContentsAlone) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_zip(folder / "a.zip", some_entries(folder / "one"), Job()).ok());
  const auto later = some_entries(folder / "two");
  for (const ZipEntry& entry : later)
    if (!entry.file.empty()) {
      fs::last_write_time(entry.file, fs::file_time_type::clock::now() - std::chrono::hours(9999));
      fs::permissions(entry.file, fs::perms::owner_all);
    }
  setenv("TZ", "Asia/Tokyo", 1);
  tzset();
  ASSERT_TRUE(write_zip(folder / "b.zip", later, Job()).ok());
  unsetenv("TZ");
  tzset();
  EXPECT_EQ(*read_file(folder / "a.zip"), *read_file(folder / "b.zip"));
}

TEST(ZipFile, ReportsAndStopsWithTheOldFileInPlace) {
  const TemporaryFolder folder;
  const auto entries = some_entries(folder / "in");
  ASSERT_TRUE(write_file_atomically(folder / "a.zip", "old").ok());
  Job* running = nullptr;
  double last = -1;
  Job job([&](double fraction, const Message& what) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    EXPECT_EQ(what.english(), "packing a.zip");
    last = fraction;
    if (fraction > 0.2) running->request_stop();
  });
  running = &job;
  const Status status = write_zip(folder / "a.zip", entries, job);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("stopped"));
  EXPECT_GT(last, 0.2);
  EXPECT_LT(last, 1.0);
  EXPECT_EQ(*read_file(folder / "a.zip"), "old");
  EXPECT_EQ(test::contents_of(folder.path()).size(), 5U) << "nothing is left over";
}

TEST(ZipFile, NamesWhatItCannotPack) {
  const TemporaryFolder folder;
  auto entries = some_entries(folder / "in");
  entries[1].file = folder / "gone.mkv";
  Status status = write_zip(folder / "a.zip", entries, Job());
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("gone.mkv"));
  entries[1] = {"told.json", {}, "twice"};
  status = write_zip(folder / "a.zip", entries, Job());
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("told.json"));
  entries[1] = {"finger/\xff.png", {}, "no letter"};
  EXPECT_FALSE(write_zip(folder / "a.zip", entries, Job()).ok());
  EXPECT_FALSE(fs::exists(folder / "a.zip"));
}

TEST(ZipFile, AFullDiskIsTold) {
  const TemporaryFolder folder;
  const auto entries = some_entries(folder / "in");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100'000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const Status status = write_zip(folder / "a.zip", entries, Job());
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().sentence(), HasSubstr("a.zip"));
  EXPECT_EQ(test::contents_of(folder.path()).size(), 4U) << "nothing is left over";
}

}  // namespace
}  // namespace alltact
