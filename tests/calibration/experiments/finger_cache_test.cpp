// Fingers that are kept between runs.
#include "calibration/experiments/experiment_bench.h"
#include "calibration/experiments/experiments.h"
#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <thread>

#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// Bytes of all files by their relative names.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = read_file(entry.path()).value();
  return files;
}

class KeptFinger : public testing::Test {
 protected:
  KeptFinger() {
    fs::create_directories(made_ / "presses");
    write(made_ / "finger.yaml", "name: a\n");
    write(made_ / "presses/one.png", std::string("\x89PNG\0\xff", 6));
  }
  static void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
  }
  std::optional<std::string> take(const std::string& name, const std::string& to) {
    return load_cached_finger(cache_, name, folder_ / to);
  }

  test::TemporaryFolder folder_;
  const fs::path made_ = folder_ / "made", cache_ = folder_ / "deep/cache";
};

TEST_F(KeptFinger, ComesBackAsItWas) {
  EXPECT_FALSE(take("a", "taken"));
  ASSERT_TRUE(cache_finger(cache_, "a", made_, "17"));
  EXPECT_EQ(take("a", "taken"), "17");
  EXPECT_EQ(files_of(folder_ / "taken"), files_of(made_));
  EXPECT_FALSE(take("b", "other"));
}

TEST_F(KeptFinger, ThatIsDamagedIsNotTakenAndIsReplaced) {
  const auto damage = [&](const std::string& file, const std::string& text) {
    ASSERT_TRUE(fs::exists(cache_ / "a" / file)) << file;
    write(cache_ / "a" / file, text);
  };
  const std::map<std::string, std::string> damaged{{"finger/finger.yaml", "name: b\n"},
                                                   {"finger/presses/one.png", ""},
                                                   {"kept.json", "{"},
                                                   {"kept.json", "[]"}};
  for (const auto& [file, text] : damaged) {
    ASSERT_TRUE(cache_finger(cache_, "a", made_, "17"));
    damage(file, text);
    EXPECT_FALSE(take("a", "taken")) << file;
    EXPECT_FALSE(fs::exists(folder_ / "taken")) << file;
  }
  ASSERT_TRUE(cache_finger(cache_, "a", made_, "17"));
  fs::remove(cache_ / "a/finger/presses/one.png");
  EXPECT_FALSE(take("a", "taken"));
  ASSERT_TRUE(cache_finger(cache_, "a", made_, "17"));
  write(cache_ / "a/finger/more.txt", "not of it");
  EXPECT_FALSE(take("a", "taken"));
  ASSERT_TRUE(cache_finger(cache_, "a", made_, "18"));
  EXPECT_EQ(take("a", "taken"), "18");
  EXPECT_EQ(files_of(folder_ / "taken"), files_of(made_));
  // Nothing is left of those that were replaced.
  EXPECT_EQ(std::distance(fs::directory_iterator(cache_), fs::directory_iterator()), 1);
}

TEST_F(KeptFinger, IsWholeWhoeverKeepsAndTakesAtOnce) {
  constexpr int kRounds = 30;
  const std::map<std::string, std::string> whole = files_of(made_);
  std::atomic<int> taken = 0, torn = 0, cache_problem = 0;
  const auto run = [&](int who) {
    for (int round = 0; round < kRounds; ++round) {
      const std::string to = std::to_string(who) + "_" + std::to_string(round);
      if (!cache_finger(cache_, "a", made_, "17")) ++cache_problem;
      if (!take("a", to)) continue;
      ++taken;
      if (files_of(folder_ / to) != whole) ++torn;
    }
  };
  { std::jthread one(run, 1), two(run, 2), three(run, 3); }
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(cache_problem, 0);
  EXPECT_GT(taken, kRounds);
  EXPECT_EQ(take("a", "last"), "17");
  EXPECT_EQ(std::distance(fs::directory_iterator(cache_), fs::directory_iterator()), 1);
}

TEST_F(KeptFinger, GoesWhenEightOthersWereKeptAfterIt) {
  for (int i = 0; i < 11; ++i) {
    const std::string name = std::to_string(i);
    ASSERT_TRUE(cache_finger(cache_, name, made_, "17"));
    fs::last_write_time(cache_ / name,
                        fs::file_time_type::clock::now() - std::chrono::hours(20 - i));
  }
  EXPECT_FALSE(fs::exists(cache_ / "1"));
  for (int i = 3; i < 11; ++i) EXPECT_TRUE(fs::exists(cache_ / std::to_string(i))) << i;
}

TEST_F(KeptFinger, HasANameOfItsOwnForAllThatMadeIt) {
  const std::string name = cached_finger_name({"ab", "c"});
  EXPECT_EQ(cached_finger_name({"ab", "c"}), name);
  EXPECT_NE(cached_finger_name({"a", "bc"}), name);
  EXPECT_NE(cached_finger_name({"c", "ab"}), name);
  EXPECT_NE(cached_finger_name({"ab", "c", ""}), name);
}

TEST_F(KeptFinger, ACacheThatCannotBeWrittenIsSaid) {
  write(folder_ / "file", "x");
  const Status refused = cache_finger(folder_ / "file", "a", made_, "17");
  ASSERT_FALSE(refused);
  EXPECT_FALSE(refused.error().sentence().empty());
  EXPECT_FALSE(load_cached_finger(folder_ / "file", "a", folder_ / "taken"));
}

/// Without what the time of making leaves there.
std::map<std::string, std::string> undated_files_of(const fs::path& folder) {
  std::map<std::string, std::string> files = files_of(folder);
  for (auto& [name, text] : files) {
    std::string undated;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
      const std::string line = text.substr(at, end - at);
      if (!name.ends_with("yaml") || line.find("date: ") == std::string::npos) undated += line;
      at = end;
    }
    text = undated;
  }
  return files;
}

// A small finger costs little: what is kept of it is what it would be made as again.
TEST(KeptFingerOfExperiments, MeasuresTheSameAsOneMadeAnew) {
  const test::TemporaryFolder folder;
  const Job job;
  BenchOptions options;
  options.threads = 2;
  options.finger = FingerVariant::draw(3, 1);
  options.finger.scale = 0.5;
  options.recording_every = 3;
  const auto made_in = [&](const std::string& name, bool with_cache) {
    options.folder = folder / name;
    options.cache = with_cache ? std::optional(folder / "cache") : std::nullopt;
    auto bench = ExperimentBench::make(options, job);
    EXPECT_TRUE(bench) << bench.error().sentence();
    return std::move(bench).value();
  };
  const ExperimentBench made = made_in("made", true), kept = made_in("kept", true);
  EXPECT_FALSE(made.finger_was_cached());
  EXPECT_FALSE(made.cache_problem());
  ASSERT_TRUE(kept.finger_was_cached());
  const auto files = undated_files_of(made.finger().folder);
  EXPECT_GT(files.size(), 6U);
  EXPECT_EQ(undated_files_of(kept.finger().folder), files);
  EXPECT_EQ(kept.truth_at_rest().markers.size(), made.truth_at_rest().markers.size());
  EXPECT_EQ(kept.truth_at_rest().markers[0].u, made.truth_at_rest().markers[0].u);

  const auto pose = experiments_named({"pose"}).value().front();
  const auto figures_of = [&](const ExperimentBench& bench) {
    std::vector<double> figures;
    const auto outcome = pose->run(bench);
    EXPECT_TRUE(outcome) << outcome.error().sentence();
    for (const ExperimentFigure& figure : outcome->figures) figures.push_back(figure.simulated);
    return figures;
  };
  EXPECT_EQ(figures_of(kept), figures_of(made));
  // Made anew where it is asked for, by the same name, with the same figures; and not taken for
  // another's.
  const ExperimentBench anew = made_in("anew", false);
  EXPECT_FALSE(anew.finger_was_cached());
  EXPECT_EQ(undated_files_of(anew.finger().folder), files);
  EXPECT_EQ(figures_of(anew), figures_of(kept));
  // Another seed finds none: it sets out to make one, and stops at that.
  options.seed = 2;
  options.folder = folder / "other";
  options.cache = folder / "cache";
  Job at_once([&at_once](double, const Message&) { at_once.request_stop(); });
  const auto other = ExperimentBench::make(options, at_once);
  ASSERT_FALSE(other);
  EXPECT_TRUE(at_once.stop_requested());
}

}  // namespace
}  // namespace alltact
