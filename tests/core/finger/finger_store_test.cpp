// Two programs on one finger: nothing that one of them was told is written gets lost, whoever is
// killed when.
#include "core/finger/finger_store.h"

#include "core/base/atomic_file.h"
#include "tests/core/finger/finger_files.h"
#include "tests/support/temporary_folder.h"

#include <atomic>
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
    const auto done =
        FingerStore::of(folder)->update([&](Finger& finger) { return add_key(finger, key); });
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

TEST(FingerStore, LosesNothingThroughTwoHundredInterleavingsAndKills) {
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
        FingerStore::of(folder.path())->update([](Finger& last) { return add_key(last, "after"); });
    EXPECT_TRUE(after) << after.error().sentence();
  }
  EXPECT_GT(kills_that_hit, kWorlds / 10);
}

TEST(FingerStore, ThreadsOfOneProgramTakeTurns) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&, thread] {
      for (int i = 0; i < 20; ++i)
        EXPECT_TRUE(FingerStore::of(folder.path())->update([&](Finger& finger) {
          return add_key(finger, fmt::format("t{}_{}", thread, i));
        }));
    });
  for (std::thread& thread : threads) thread.join();
  const auto finger = Finger::load(folder.path());
  ASSERT_TRUE(finger);
  EXPECT_EQ(finger->provenance.size(), 81U);
}

TEST(FingerStore, ARefusedChangeChangesNothing) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  const auto before = read_file(folder / Finger::kFileName);
  const auto refused = FingerStore::of(folder.path())->update([](Finger& finger) -> Status {
    finger.name = "half done";
    return Error{en::say("no"), "", ""};
  });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what.english(), "no");
  const auto invalid = FingerStore::of(folder.path())->update([](Finger& finger) -> Status {
    finger.face.width_mm = -1;
    return {};
  });
  EXPECT_FALSE(invalid);
  EXPECT_EQ(*read_file(folder / Finger::kFileName), *before);
}

TEST(FingerStore, LeavesNothingBeside) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  ASSERT_TRUE(
      FingerStore::of(folder.path())->update([](Finger& finger) { return add_key(finger, "k"); }));
  { ASSERT_TRUE(FingerStore::of(folder.path())->lock_for_work("calibrating")); }
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::ElementsAre(Finger::kFileName));
}

TEST(FingerStore, TheSecondIsToldWhoIsAtWork) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  auto first = FingerStore::of(folder.path())->lock_for_work("calibrating");
  ASSERT_TRUE(first) << first.error().sentence();
  const auto second = FingerStore::of(folder.path())->lock_for_work("recording the reference");
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().what.english(),
              testing::AllOf(testing::HasSubstr("calibrating"),
                             testing::HasSubstr(fmt::format("process {} on", getpid()))));
  // Small changes go on beside long work.
  EXPECT_TRUE(
      FingerStore::of(folder.path())->update([](Finger& finger) { return add_key(finger, "k"); }));
  { const LockFile ended = std::move(*first); }
  EXPECT_TRUE(FingerStore::of(folder.path())->lock_for_work("recording the reference"));
}

TEST(FingerStore, WhoMayNotWriteIsToldSo) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  constexpr uid_t kNobody = 65534;
  const uid_t me = geteuid();
  if (me == 0) {  // the superuser may write everywhere
    ASSERT_EQ(seteuid(kNobody), 0);
  }
  const auto changed = FingerStore::of(folder.path())->update([](Finger&) { return Status(); });
  if (me == 0) {
    ASSERT_EQ(seteuid(me), 0);
  }
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().sentence(), testing::HasSubstr("not allowed"));
}

TEST(FingerStore, GivesTheSameSnapshotUntilSomethingChanges) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  const auto store = FingerStore::of(folder.path());
  EXPECT_EQ(store, FingerStore::of(folder.path() / "." / "")) << "one, however it is called";
  const FingerPtr first = store->snapshot().value();
  EXPECT_EQ(first, store->snapshot().value());
  EXPECT_EQ(first->finger.name, "left-07");
  EXPECT_EQ(first->camera.size(), cv::Size(960, 540));
  ASSERT_TRUE(first->mapping);
  EXPECT_FALSE(first->without_mapping().mapping || first->without_mapping().finger.mapping);

  const FingerPtr renamed = store
                                ->update([](Finger& finger) {
                                  finger.name = "right-07";
                                  return Status();
                                })
                                .value();
  EXPECT_EQ(renamed->finger.name, "right-07");
  EXPECT_GT(renamed->revision, first->revision);
  EXPECT_EQ(first->finger.name, "left-07") << "what somebody holds stays as it was";

  // What another program writes is seen, what is said of presses changes no revision.
  Finger other = renamed->finger;
  other.name = "other-07";
  ASSERT_TRUE(other.save(folder.path()));
  const FingerPtr seen = store->snapshot().value();
  EXPECT_EQ(seen->finger.name, "other-07");
  PressSet press_set;
  press_set.ball_radius_mm = 4;
  ASSERT_TRUE(store->save_presses(press_set));
  const FingerPtr pressed = store->snapshot().value();
  EXPECT_EQ(pressed->presses, press_set);
  EXPECT_EQ(pressed->revision, seen->revision);
  EXPECT_NE(pressed, seen);
}

TEST(FingerStore, TellsOfEveryChangeUntilNobodyListens) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  const auto store = FingerStore::of(folder.path());
  std::vector<FingerPtr> told;
  auto listening = store->listen([&](const FingerPtr& now, const FingerPtr& before) {
    EXPECT_NE(now, before);
    told.push_back(now);
  });
  ASSERT_TRUE(store->snapshot());
  EXPECT_TRUE(told.empty()) << "nothing has changed yet";
  ASSERT_TRUE(store->update([](Finger& finger) { return add_key(finger, "a"); }));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(told[0]->finger.provenance.contains("a"));
  EXPECT_FALSE(store->update([](Finger&) { return Status(Error{en::say("no"), "", ""}); }));
  EXPECT_EQ(told.size(), 1U);
  Finger other = told[0]->finger;
  other.provenance["b"] = "of another program";
  ASSERT_TRUE(other.save(folder.path()));
  ASSERT_TRUE(store->snapshot());
  EXPECT_EQ(told.size(), 2U);
  listening.reset();
  ASSERT_TRUE(store->update([](Finger& finger) { return add_key(finger, "c"); }));
  EXPECT_EQ(told.size(), 2U);
}

TEST(FingerStore, AListenerMayEndItselfAndIsNotCalledOnceItHasEnded) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  const auto store = FingerStore::of(folder.path());
  int calls = 0;
  std::shared_ptr<void> itself;
  itself = store->listen([&](const FingerPtr&, const FingerPtr&) {
    ++calls;
    itself.reset();
  });
  std::atomic<bool> has_ended{false}, was_called_late{false}, is_over{false};
  auto other = store->listen([&](const FingerPtr&, const FingerPtr&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (has_ended) was_called_late = true;
  });
  std::thread writer([&] {
    for (int i = 0; !is_over; ++i)
      EXPECT_TRUE(store->update(
          [&](Finger& finger) { return add_key(finger, fmt::format("k{}", i % 7)); }));
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  other.reset();
  has_ended = true;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  is_over = true;
  writer.join();
  EXPECT_EQ(calls, 1);
  EXPECT_FALSE(was_called_late);
}

TEST(FingerStore, PressesThatCannotBeReadLeaveTheFingerUsable) {
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(make_finger_in(folder.path()));
  ASSERT_TRUE(write_file_atomically(folder / PressSet::kFileName, "format: ["));
  const auto finger = open_finger(folder.path());
  ASSERT_TRUE(finger);
  ASSERT_TRUE((*finger)->presses_problem);
  EXPECT_THAT((*finger)->presses_problem->sentence(), testing::HasSubstr(PressSet::kFileName));
  EXPECT_EQ((*finger)->presses, PressSet());
}

}  // namespace
}  // namespace alltact::test
