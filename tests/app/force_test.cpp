// `alltact force` from a table to a finger, and back.
#include "core/io/atomic_file.h"
#include "tests/calibration/force/force_worlds.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact::test {
namespace {

using ForceAnswer = nlohmann::json;
using testing::HasSubstr;

/// A finger whose markers rest where the made one's do, and a table of that one.
struct ForceBench {
  TemporaryFolder folder;
  made::LatentFinger made{21};

  ForceBench() {
    std::string rest;
    for (const Eigen::Vector2d& at : made.rest())
      rest += fmt::format("{}[{:.1f}, {:.1f}]", rest.empty() ? "" : ", ", at.x(), at.y());
    std::filesystem::create_directory(folder / "finger");
    write("finger/finger.yaml",
          "format: alltact-finger/1\nname: made\n"
          "camera: {model: pinhole, size: [960, 540], fx: 523.9, fy: 523.9, cx: 479.5, cy: 269.5}\n"
          "face: {kind: fin_ray, width_mm: 24.0, layer_mm: 1.5}\n"
          "markers: {per_row: 6, polarity: bright}\n"
          "contact:\n  threshold_px: 5.0\n  rest_markers: [" +
              rest + "]\n");
    write("table.csv", made.rows(5, 20).to_csv());
  }
  void write(const std::string& name, const std::string& text) const {
    ASSERT_TRUE(write_file_atomically(folder / name, text));
  }
  [[nodiscard]] std::string yaml() const {
    return read_file(folder / "finger/finger.yaml").value();
  }
  [[nodiscard]] ProgramRun run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"force", (folder / "finger").string()});
    return run_alltact(arguments);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder / name).string(); }
};

TEST(ForceCommand, TrainsKeepsRepeatsAndTakesBack) {
  const ForceBench bench;
  const std::string before = bench.yaml();
  const ProgramRun run = bench.run({bench.file("table.csv"), "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const ForceAnswer answer = ForceAnswer::parse(run.output);
  ASSERT_EQ(answer.at("comparison").size(), 4U);
  EXPECT_EQ(answer.at("kept"), "ridge");
  EXPECT_LT(answer.at("comparison").at(1).at("mae_n").at(0).get<double>(), 0.06);
  EXPECT_LE(answer.at("comparison").at(1).at("shuffled_r2").get<double>(), 0.0);
  const std::string first = bench.yaml();
  EXPECT_THAT(first, HasSubstr("force: {model: force/model-"));
  const ProgramRun mean = bench.run({"--again", "--model", "mean"});
  ASSERT_EQ(mean.status, 0) << mean.errors;
  EXPECT_THAT(mean.output, HasSubstr("frames: too kind"));
  EXPECT_THAT(mean.output, HasSubstr("Kept: mean."));
  const auto model_line = [](const std::string& yaml) {
    const std::size_t at = yaml.find("force: {");
    return at == std::string::npos ? std::string() : yaml.substr(at, yaml.find('\n', at) - at);
  };
  EXPECT_NE(model_line(bench.yaml()), model_line(first));
  EXPECT_EQ(bench.run({"--undo"}).status, 0);
  EXPECT_EQ(model_line(bench.yaml()), model_line(first));
}

TEST(ForceCommand, BadInputIsASentenceAndNothingIsLost) {
  const ForceBench bench;
  const std::string before = bench.yaml();
  const std::string csv = read_file(bench.folder / "table.csv").value();
  const auto refused = [&](const std::string& table, const char* words) {
    bench.write("bad.csv", table);
    const ProgramRun run = bench.run({bench.file("bad.csv")});
    EXPECT_EQ(run.status, 1) << words;
    EXPECT_THAT(run.errors, HasSubstr(words));
    EXPECT_EQ(bench.yaml(), before);
  };
  refused("", "the table is empty");
  refused(csv.substr(0, csv.find('\n', 300)), "rows are too few");
  std::string renamed = csv;
  renamed.replace(renamed.find("fy_n"), 4, "fq_n");
  refused(renamed, "'fy_n' is missing");
  std::string nan = csv;
  nan.replace(nan.find('\n') + 1 + std::string("press 0,").size(), 3, "nan");
  refused(nan, "is no number");
  EXPECT_THAT(bench.run({bench.file("table.csv"), "--split", "day"}).errors,
              HasSubstr("no column 'day'"));
  EXPECT_EQ(bench.run({}).status, 2);
  EXPECT_EQ(bench.run({"--collect", "a.jsonl"}).status, 2);
  EXPECT_EQ(bench.run({bench.file("table.csv"), "--undo"}).status, 2);
  EXPECT_EQ(bench.run({"--undo"}).status, 1);
}

TEST(ForceCommand, CollectsATableFromResultsAndAGauge) {
  const ForceBench bench;
  const ForceTable table = ForceTable::load(bench.folder / "table.csv").value();
  std::string results, gauge = "frame,fx_n,fy_n,block\n";
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    ForceAnswer line{{"frame", fmt::format("frame_{:05}", row)}, {"markers", ForceAnswer::array()}};
    for (int m = 0; m < table.marker_count; ++m)
      line["markers"].push_back(
          {{"u", table.layouts(row, 2 * m)}, {"v", table.layouts(row, 2 * m + 1)}, {"seen", true}});
    results += line.dump() + "\n";
    if (row % 10 != 3)
      gauge += fmt::format("frame_{:05},{},{},{}\n",
                           row,
                           table.force_N(row, 0),
                           table.force_N(row, 1),
                           table.block[static_cast<std::size_t>(row)]);
  }
  bench.write("results.jsonl", results);
  bench.write("gauge.csv", gauge);
  const ProgramRun run = bench.run({"--collect",
                                    bench.file("results.jsonl"),
                                    "--gauge",
                                    bench.file("gauge.csv"),
                                    "-o",
                                    bench.file("new.csv")});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("90 rows in"));
  EXPECT_THAT(run.output, HasSubstr("10 of 100 frames have no reading"));
  const ForceTable made = ForceTable::load(bench.folder / "new.csv").value();
  EXPECT_EQ(made.layouts.row(3), table.layouts.row(4));
  EXPECT_EQ(made.force_N.row(3), table.force_N.row(4));
  EXPECT_EQ(bench.run({bench.file("new.csv")}).status, 0);
}

}  // namespace
}  // namespace alltact::test
