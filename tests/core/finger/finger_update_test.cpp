// Two programs on one finger: nothing that one of them was told is written gets lost, whoever is
// killed when.
#include "core/finger/finger_update.h"

#include "core/io/atomic_file.h"
#include "tests/core/finger/finger_files.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace alltact::test {
namespace {

constexpr const char* kSeed = "provenance of a finger that nobody has changed yet";

void make_finger_in(const std::filesystem::path& folder) {
  Finger finger = Finger::parse(kFinRay, folder).value();
  finger.provenance.clear();
  finger.provenance["note"] = kSeed;
  const Status saved = finger.save(folder);
  ASSERT_TRUE(saved) << saved.error().sentence();
}

Status add_key(Finger& finger, const std::string& key) {
  finger.provenance[key] = "here";
  return {};
}

/// A program of its own, as far as files and locks can tell: adds keys until it is killed or has
/// added all, and tells of each once it is written.
pid_t start_writer(const std::filesystem::path& folder, int writer, int count, int told_to) {
  const pid_t child = fork();
  if (child != 0) return child;
  for (int i = 0; i < count; ++i) {
    const std::string key = fmt::format("w{}_{}", writer, i);
    const auto done = update_finger(folder, [&](Finger& finger) { return add_key(finger, key); });
    if (!done) _exit(1);
    const std::string line = key + '\n';
    if (write(told_to, line.data(), line.size()) < 0) _exit(2);
  }
  _exit(0);
}

std::set<std::string> lines_from(int descriptor) {
  std::string text;
  char some[4096];
  for (ssize_t n; (n = read(descriptor, some, sizeof some)) > 0;)
    text.append(some, static_cast<std::size_t>(n));
  std::set<std::string> lines;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos;
       begin = end + 1)
    lines.insert(text.substr(begin, end - begin));
  return lines;
}

TEST(FingerUpdate, LosesNothingThroughTwoHundredInterleavingsAndKills) {
  constexpr int kWorlds = 200, kWriters = 3, kUpdates = 4;
  std::mt19937 random(20261123);
  int kills_that_hit = 0;
  for (int world = 0; world < kWorlds; ++world) {
    const TemporaryFolder folder;
    ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    std::vector<pid_t> writers;
    for (int i = 0; i < kWriters; ++i)
      writers.push_back(start_writer(folder.path(), i, kUpdates, ends[1]));
    close(ends[1]);
    // One is killed somewhere in its work, the others go on.
    const auto victim = writers[random() % kWriters];
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 20000));
    kill(victim, SIGKILL);
    const std::set<std::string> told = lines_from(ends[0]);
    close(ends[0]);
    for (const pid_t writer : writers) {
      int status = 0;
      waitpid(writer, &status, 0);
      if (WIFSIGNALED(status)) ++kills_that_hit;
      EXPECT_TRUE(writer == victim || (WIFEXITED(status) && WEXITSTATUS(status) == 0)) << world;
    }
    const auto finger = Finger::load(folder.path());
    ASSERT_TRUE(finger) << finger.error().sentence();
    EXPECT_EQ(finger->provenance.at("note"), kSeed);
    for (const std::string& key : told)
      EXPECT_TRUE(finger->provenance.contains(key)) << "world " << world << " lost " << key;
    // Nobody is left out afterwards by what a dead one left behind.
    const auto after =
        update_finger(folder.path(), [](Finger& last) { return add_key(last, "after"); });
    EXPECT_TRUE(after) << after.error().sentence();
  }
  EXPECT_GT(kills_that_hit, kWorlds / 10);
}

TEST(FingerUpdate, ThreadsOfOneProgramTakeTurns) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&, thread] {
      for (int i = 0; i < 20; ++i)
        EXPECT_TRUE(update_finger(folder.path(), [&](Finger& finger) {
          return add_key(finger, fmt::format("t{}_{}", thread, i));
        }));
    });
  for (std::thread& thread : threads) thread.join();
  const auto finger = Finger::load(folder.path());
  ASSERT_TRUE(finger);
  EXPECT_EQ(finger->provenance.size(), 81U);
}

TEST(FingerUpdate, ARefusedChangeChangesNothing) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  const auto before = read_file(folder / Finger::kFileName);
  const auto refused = update_finger(folder.path(), [](Finger& finger) -> Status {
    finger.name = "half done";
    return Error{en::say("no"), "", ""};
  });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what.english(), "no");
  const auto invalid = update_finger(folder.path(), [](Finger& finger) -> Status {
    finger.face.width_mm = -1;
    return {};
  });
  EXPECT_FALSE(invalid);
  EXPECT_EQ(*read_file(folder / Finger::kFileName), *before);
}

TEST(FingerUpdate, LeavesNothingBeside) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  ASSERT_TRUE(update_finger(folder.path(), [](Finger& finger) { return add_key(finger, "k"); }));
  { ASSERT_TRUE(hold_for_work(folder.path(), "calibrating")); }
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::ElementsAre(Finger::kFileName));
}

TEST(FingerUpdate, TheSecondIsToldWhoIsAtWork) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  auto first = hold_for_work(folder.path(), "calibrating");
  ASSERT_TRUE(first) << first.error().sentence();
  const auto second = hold_for_work(folder.path(), "recording the reference");
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().what.english(),
              testing::AllOf(testing::HasSubstr("calibrating"),
                             testing::HasSubstr(fmt::format("process {} on", getpid()))));
  // Small changes go on beside long work.
  EXPECT_TRUE(update_finger(folder.path(), [](Finger& finger) { return add_key(finger, "k"); }));
  { const HeldFile ended = std::move(*first); }
  EXPECT_TRUE(hold_for_work(folder.path(), "recording the reference"));
}

TEST(FingerUpdate, WhoMayNotWriteIsToldSo) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  constexpr uid_t kNobody = 65534;
  const uid_t me = geteuid();
  if (me == 0) {  // the superuser may write everywhere
    ASSERT_EQ(seteuid(kNobody), 0);
  }
  const auto changed = update_finger(folder.path(), [](Finger&) { return Status(); });
  if (me == 0) {
    ASSERT_EQ(seteuid(me), 0);
  }
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().sentence(), testing::HasSubstr("not allowed"));
}

}  // namespace
}  // namespace alltact::test
