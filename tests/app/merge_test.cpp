// A recording shared between processes, brought together again.
#include "tests/support/flat_finger.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Lines without what differs from run to run.
std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::istringstream stream(text_of(file));
  for (std::string line; std::getline(stream, line);) {
    auto json = nlohmann::ordered_json::parse(line);
    json.erase("times_ms");
    lines.push_back(json.dump());
  }
  return lines;
}

/// A calibrated sensor and 70 pictures of its presses: three pieces. Made once, and measured once
/// in one process; every test writes to folders of its own.
struct Shared : FlatFinger {
  Shared() {
    EXPECT_EQ(make().status, 0);
    EXPECT_EQ(calibrate().status, 0);
    fs::create_directory(folder / "pictures");
    for (int i = 0; i < 70; ++i)
      fs::copy_file(presses[static_cast<std::size_t>(i) % presses.size()],
                    folder / "pictures" / ("p" + std::to_string(100 + i) + ".png"));
    EXPECT_EQ(reconstruct({file("pictures")}, "whole", {"--format", "depth16,depth-video"}).status,
              0);
  }
  static const Shared& get() {
    static const Shared shared;
    return shared;
  }
  ProgramRun part(const std::string& which, const std::string& output,
                  const std::string& format = "depth16,depth-video") const {
    return reconstruct({file("pictures")}, output, {"--format", format, "--shard", which});
  }
};

TEST(Merge, PartsMakeWhatOneProcessMakes) {
  const Shared& shared = Shared::get();
  for (const char* which : {"1/4", "2/4", "3/4", "4/4"})  // one has no frames
    ASSERT_EQ(shared.part(which, std::string("part") + which[0]).status, 0);
  const ProgramRun merge = run_alltact({"merge", shared.file("part1"), shared.file("part2"),
                                        shared.file("part3"), shared.file("part4")});
  ASSERT_EQ(merge.status, 0) << merge.errors;
  const auto whole = lines_of(shared.folder / "whole" / "results.jsonl");
  EXPECT_EQ(whole.size(), 70U);
  EXPECT_EQ(lines_of(shared.folder / "part1" / "results.jsonl"), whole);
  for (int i = 0; i < 70; ++i) {
    const std::string name = "p" + std::to_string(100 + i) + ".depth16.png";
    EXPECT_EQ(text_of(shared.folder / "part1" / name), text_of(shared.folder / "whole" / name));
  }
  EXPECT_THAT(text_of(shared.folder / "whole" / "results.jsonl"),
              HasSubstr("\"mm_per_step\":0.001,\"zero_at\":10000"));
  EXPECT_THAT(text_of(shared.folder / "whole" / "results.jsonl"),
              HasSubstr("\"depth_video\":{\"file\":\"depth.mkv\",\"picture\":69,"));
  const std::string video = text_of(shared.folder / "whole" / "depth.mkv");
  EXPECT_GT(video.size(), 1000U);
  EXPECT_EQ(text_of(shared.folder / "part1" / "depth.mkv"), video);
  for (const auto& entry : fs::directory_iterator(shared.folder / "part1"))
    EXPECT_EQ(entry.path().filename().string().find(".part-"), std::string::npos) << entry.path();
}

TEST(Merge, WhatDoesNotBelongTogetherIsRefusedAndStays) {
  const Shared& shared = Shared::get();
  ASSERT_EQ(shared.part("1/2", "parts").status, 0);
  const ProgramRun missing = run_alltact({"merge", shared.file("parts")});
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.errors, HasSubstr("missing: 2"));
  ASSERT_EQ(shared.part("2/2", "other", "depth").status, 0);
  const ProgramRun two = run_alltact({"merge", shared.file("parts"), shared.file("other")});
  EXPECT_EQ(two.status, 1);
  EXPECT_THAT(two.errors, HasSubstr("two different runs"));
  EXPECT_TRUE(fs::exists(shared.folder / "parts" / "results.part-1-of-2.jsonl"));
  EXPECT_FALSE(fs::exists(shared.folder / "parts" / "results.jsonl"));
  EXPECT_THAT(run_alltact({"merge", shared.file("pictures")}).errors, HasSubstr("no parts"));
  // Numbers that are no counts.
  const std::string name = "results.part-1-of-2.jsonl", mark = "\"part\":1,";
  const std::string text = text_of(shared.folder / "parts" / name);
  ASSERT_THAT(text, HasSubstr(mark));
  fs::create_directory(shared.folder / "odd");
  for (const char* number : {"1e99", "1.5", "-1", "4294967297"}) {
    std::string odd = text;
    odd.replace(odd.find(mark), mark.size(), fmt::format("\"part\":{},", number));
    write_text(shared.folder / "odd" / name, odd);
    EXPECT_THAT(run_alltact({"merge", shared.file("odd")}).errors, HasSubstr("damaged")) << number;
  }
}

TEST(Merge, ASlurmJobArrayMakesWhatOneProcessMakes) {
  const Shared& shared = Shared::get();
  const std::string script = ALLTACT_SOURCE_DIR "/packaging/slurm/reconstruct",
                    flags = "--format depth16,depth-video";
  // No more cores than a task needs, so that it runs on the smallest computer.
  write_text(shared.folder / "job",
             "set -e\nexport ALLTACT=" ALLTACT_PROGRAM
             "\nlogs=$1/%x-%a.log\nrun=\"sbatch --wait --cpus-per-task=1 --output=$logs\"\n"
             "$run --array=1-3 " +
                 script + " $1/finger $1/pictures $1/array " + flags +
                 "\n$run --wrap \"$ALLTACT merge $1/array\"\n");
  fs::create_directory(shared.folder / "slurm");
  const ProgramRun run =
      run_shell(ALLTACT_SOURCE_DIR "/tests/support/on_slurm " + shared.file("slurm") + " bash " +
                shared.file("job") + " " + shared.folder.path().string());
  if (run.status == 77) GTEST_SKIP() << run.errors;
  std::string logs;
  for (const auto& entry : fs::directory_iterator(shared.folder.path()))
    if (entry.path().extension() == ".log") logs += text_of(entry.path());
  ASSERT_EQ(run.status, 0) << run.output << run.errors << logs;
  EXPECT_EQ(lines_of(shared.folder / "array" / "results.jsonl"),
            lines_of(shared.folder / "whole" / "results.jsonl"));
  EXPECT_EQ(text_of(shared.folder / "array" / "depth.mkv"),
            text_of(shared.folder / "whole" / "depth.mkv"));
  for (const int i : {0, 31, 32, 69}) {
    const std::string name = "p" + std::to_string(100 + i) + ".depth16.png";
    EXPECT_EQ(text_of(shared.folder / "array" / name), text_of(shared.folder / "whole" / name));
  }
}

TEST(Merge, NonsenseIsWrongUsage) {
  for (const char* which : {"3/2", "0/2", "1/0", "1", "a/b", "1/2x", "-1/2", "1/99999"})
    EXPECT_EQ(run_alltact({"reconstruct", "f", "v.mkv", "-o", "x", "--shard", which}).status, 2)
        << which;
}

}  // namespace
}  // namespace alltact::test
