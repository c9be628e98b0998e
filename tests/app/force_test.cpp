// `alltact force` from a table to a finger, and back.
#include "core/base/atomic_file.h"
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
  [[nodiscard]] ForceTable folder_table() const {
    return ForceTable::load(folder / "table.csv").value();
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
  EXPECT_THAT(mean.output, HasSubstr("frames: biased"));
  EXPECT_THAT(mean.output, HasSubstr("Selected model: mean."));
  const auto model_line = [](const std::string& yaml) {
    const std::size_t at = yaml.find("force: {");
    return at == std::string::npos ? std::string() : yaml.substr(at, yaml.find('\n', at) - at);
  };
  EXPECT_NE(model_line(bench.yaml()), model_line(first));
  EXPECT_EQ(bench.run({"--undo"}).status, 0);
  EXPECT_EQ(model_line(bench.yaml()), model_line(first));
}

/// What is written in the finger's force model.
ForceAnswer kept_model(const ForceBench& bench) {
  const std::string yaml = bench.yaml();
  const std::size_t at = yaml.find("force/model-");
  if (at == std::string::npos) return ForceAnswer::object();
  const std::string file = yaml.substr(at, yaml.find('}', at) - at);
  return ForceAnswer::parse(read_file(bench.folder / ("finger/" + file)).value());
}

TEST(ForceCommand, AgainKeepsSplitKindAndCreepUnlessTold) {
  const ForceBench bench;
  ForceTable table = bench.folder_table();
  for (Eigen::Index row = 0; row < table.rows(); ++row)
    table.day.push_back(row < table.rows() / 2 ? "Monday" : "Tuesday");
  table.time_s =
      Eigen::VectorXd::LinSpaced(table.rows(), 0, 0.1 * static_cast<double>(table.rows()));
  bench.write("timed.csv", table.to_csv());
  const ProgramRun first = bench.run(
      {bench.file("timed.csv"), "--split", "day", "--creep-s", "2.5", "--model", "ridge"});
  ASSERT_EQ(first.status, 0) << first.errors;
  const ForceAnswer before = kept_model(bench);
  EXPECT_EQ(before.at("creep_s"), 2.5);
  EXPECT_EQ(before.at("record").at("split"), "day");
  const ProgramRun again = bench.run({"--again"});
  ASSERT_EQ(again.status, 0) << again.errors;
  EXPECT_EQ(kept_model(bench), before) << "the same model to the last byte";
  const ProgramRun other = bench.run({"--again", "--creep-s", "0", "--model", "mean"});
  ASSERT_EQ(other.status, 0) << other.errors;
  EXPECT_EQ(kept_model(bench).at("creep_s"), 0.0);
  EXPECT_EQ(kept_model(bench).at("record").at("split"), "day") << "not told, so as before";
  EXPECT_EQ(kept_model(bench).at("kind"), "mean");
  const ProgramRun automatic = bench.run({"--again", "--model", "auto", "--split", "block"});
  ASSERT_EQ(automatic.status, 0) << automatic.errors;
  EXPECT_EQ(kept_model(bench).at("record").at("split"), "block");
  EXPECT_NE(kept_model(bench).at("kind"), "mean");
}

TEST(ForceCommand, BadTablesAndModelsLeaveTheFingerAsItWas) {
  const ForceBench bench;
  ASSERT_EQ(bench.run({bench.file("table.csv"), "--model", "ridge"}).status, 0);
  const auto finger = [&] { return contents_of(bench.folder / "finger"); };
  const auto before = finger();
  const auto refused = [&](const std::vector<std::string>& arguments, const char* words) {
    const ProgramRun run = bench.run(arguments);
    EXPECT_EQ(run.status, 1) << words;
    EXPECT_THAT(run.errors, HasSubstr(words));
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_TRUE(finger() == before) << words;
  };
  const auto changed = [&](const char* name, const auto& change) {
    ForceTable table = bench.folder_table();
    change(table);
    bench.write(name, table.to_csv());
    return bench.file(name);
  };
  refused({changed("constant.csv", [](ForceTable& t) { t.force_N.col(1).setConstant(2); })},
          "'fy_n' is the same in all rows");
  refused(
      {changed("still.csv",
               [](ForceTable& t) { t.layouts.rowwise() = Eigen::RowVectorXd(t.layouts.row(0)); })},
      "no marker ever moves");
  refused({changed("three.csv",
                   [](ForceTable& t) {
                     t.layouts.conservativeResize(3, Eigen::NoChange);
                     t.seen.conservativeResize(3, Eigen::NoChange);
                     t.force_N.conservativeResize(3, Eigen::NoChange);
                     t.block.resize(3);
                   })},
          "3 rows are too few");
  refused({changed("fewer.csv",
                   [](ForceTable& t) {
                     t.marker_count = 10;
                     t.layouts.conservativeResize(Eigen::NoChange, 20);
                     t.seen.conservativeResize(Eigen::NoChange, 10);
                   })},
          "the table has 10 markers, the finger has 12");
  refused({changed("other.csv", [](ForceTable& t) { t.layouts.array() += 200; })},
          "belong to another finger");
  refused({bench.file("none.csv")}, "none.csv");
  refused({bench.file("table.csv"), "--creep-s", "2"}, "has times");
  refused({bench.file("table.csv"), bench.file("fewer.csv")}, "has 10 markers");
  bench.write("nan.csv", "u0,v0,fx_n,fy_n\n1,2,nan,4\n");
  refused({bench.file("nan.csv")}, "'nan' is not a number");
  bench.write("half.csv", read_file(bench.folder / "table.csv").value().substr(0, 2000));
  refused({bench.file("half.csv")}, "half.csv, line");
}

TEST(ForceCommand, ABrokenModelIsNamedAndATableMakesAnother) {
  const ForceBench bench;
  ASSERT_EQ(bench.run({bench.file("table.csv"), "--model", "network"}).status, 0);
  const ForceAnswer whole = kept_model(bench);
  const std::string yaml = bench.yaml();
  const std::size_t at = yaml.find("force/model-");
  const std::string file = "finger/" + yaml.substr(at, yaml.find('}', at) - at);
  const auto again_says = [&](const std::string& model, const char* words) {
    bench.write(file, model);
    const auto before = contents_of(bench.folder / "finger");
    const ProgramRun run = bench.run({"--again"});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.errors, HasSubstr(words));
    EXPECT_TRUE(contents_of(bench.folder / "finger") == before);
  };
  again_says(whole.dump().substr(0, 3000), "damaged or truncated");
  ForceAnswer wrong = whole;
  wrong["members"][0]["regressors"][0].erase(1);
  again_says(wrong.dump(), "does not have the shape");
  wrong = whole;
  wrong["members"][0]["regressors"][0][2]["bias"].push_back(1.0);
  again_says(wrong.dump(), "does not have the shape");
  wrong = whole;
  wrong["members"][0]["regressors"][0][1]["weights"]["numbers"][0] = 1e30;
  again_says(wrong.dump(), "not a valid number");
  const ProgramRun run = bench.run({bench.file("table.csv"), "--model", "ridge"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(kept_model(bench).at("kind"), "ridge");
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
  refused(nan, "is not a number");
  EXPECT_THAT(bench.run({bench.file("table.csv"), "--split", "day"}).errors,
              HasSubstr("no column 'day'"));
  EXPECT_EQ(bench.run({}).status, 2);
  EXPECT_EQ(bench.run({"--collect", "a.jsonl"}).status, 2);
  const ProgramRun without = bench.run({"--collect", "a.jsonl", "-o", "b.csv"});
  EXPECT_EQ(without.status, 1);
  EXPECT_THAT(without.errors, HasSubstr("no readings of a gauge beside"));
  EXPECT_EQ(bench.run({bench.file("table.csv"), "--gauge-unit", "g"}).status, 2);
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
      gauge += fmt::format("frame_{:05},{},{},{}\n", row, table.force_N(row, 0),
                           table.force_N(row, 1), table.block[static_cast<std::size_t>(row)]);
  }
  bench.write("results.jsonl", results);
  bench.write("gauge.csv", gauge);
  const ProgramRun run = bench.run({"--collect", bench.file("results.jsonl"), "--gauge",
                                    bench.file("gauge.csv"), "-o", bench.file("new.csv")});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("90 rows in"));
  EXPECT_THAT(run.output, HasSubstr("10 of 100 frames have no gauge reading"));
  const ForceTable made = ForceTable::load(bench.folder / "new.csv").value();
  EXPECT_EQ(made.layouts.row(3), table.layouts.row(4));
  EXPECT_EQ(made.force_N.row(3), table.force_N.row(4));
  EXPECT_EQ(bench.run({bench.file("new.csv")}).status, 0);
  // The same as Excel writes it in German: the same table, and what was understood is reported.
  std::string german = "\xEF\xBB\xBF";
  for (const char c : gauge)
    german += c == ',' ? ";" : c == '.' ? "," : c == '\n' ? "\r\n" : std::string(1, c);
  german.replace(german.find("fx_n"), 4, "Kraft X [N]");
  bench.write("german.csv", german);
  const ProgramRun same =
      bench.run({"--collect", bench.file("results.jsonl"), "--gauge", bench.file("german.csv"),
                 "-o", bench.file("same.csv"), "--json"});
  ASSERT_EQ(same.status, 0) << same.errors;
  EXPECT_EQ(read_file(bench.folder / "same.csv").value(),
            read_file(bench.folder / "new.csv").value());
  EXPECT_THAT(
      ForceAnswer::parse(same.output).at("gauge_read_as").get<std::string>(),
      HasSubstr("semicolon-separated with decimal commas: frame, fx_n from 'Kraft X [N]' in N"));
}

}  // namespace
}  // namespace alltact::test
