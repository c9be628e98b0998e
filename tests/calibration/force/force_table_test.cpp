// Tables with forces: what is read, and what is refused with a sentence.
#include "calibration/force/force_table.h"

#include "calibration/force/collect_force.h"
#include "core/base/atomic_file.h"
#include "tests/calibration/force/force_worlds.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

/// 24 rows of two markers; `line` may change a row's text.
template <class Change>
std::string table_text(const std::string& head, const Change& change) {
  std::string text = head + "\n";
  for (int row = 0; row < 24; ++row) {
    std::string line =
        fmt::format("{},{},{},{},{},{}", 100 + row, 50.5, 200 - row, 450, 0.1 * row, -0.2 * row);
    change(row, line);
    text += line + "\n";
  }
  return text;
}
std::string table_text() {
  return table_text("u0,v0,u1,v1,fx_n,fy_n", [](int, std::string&) {});
}

std::string table_refusal(const std::string& text) {
  const auto table = ForceTable::parse(text, "table.csv");
  EXPECT_FALSE(table);
  return table ? "" : table.error().sentence();
}

void expect_words(const std::string& sentence, const char* words) {
  EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("table.csv"), std::string::npos) << sentence;
}

TEST(ForceTable, ReadsItsColumns) {
  const auto table = ForceTable::parse(table_text(), "table.csv");
  ASSERT_TRUE(table) << table.error().sentence();
  EXPECT_EQ(table->rows(), 24);
  EXPECT_EQ(table->marker_count, 2);
  EXPECT_EQ(table->axes, 2);
  EXPECT_EQ(table->layouts(3, 0), 103);
  EXPECT_EQ(table->layouts(3, 3), 450);
  EXPECT_EQ(table->force_N(10, 1), -2.0);
  EXPECT_FALSE(table->has_position());
}

TEST(ForceTable, OtherNamesUnitsQuotesAndLineEndsAreUnderstood) {
  std::string text = "\xEF\xBB\xBF\"X00_px\",Y00_px,x01,y01,Fx_N,FY,Temperature,T_s\r\n";
  for (int row = 0; row < 24; ++row)
    text += fmt::format("{}, 50,\"200\",450,{},+1.5e-{},warm,{}\r\n", row, 0.1 * row, row % 3, row);
  const auto table = ForceTable::parse(text, "table.csv");
  ASSERT_TRUE(table) << table.error().sentence();
  EXPECT_EQ(table->layouts(5, 0), 5);
  EXPECT_EQ(table->time_s[7], 7);
  EXPECT_EQ(table->ignored_columns, std::vector<std::string>{"Temperature"});
}

TEST(ForceTable, HiddenMarkersAreEmptyCells) {
  const auto table = ForceTable::parse(table_text("u0,v0,u1,v1,fx_n,fy_n",
                                                  [](int row, std::string& line) {
                                                    if (row == 4) line = ",,196,450,0.4,-0.8";
                                                  }),
                                       "table.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->seen(4, 0), 0);
  EXPECT_EQ(table->seen(4, 1), 1);
}

TEST(ForceTable, WritesWhatItReads) {
  made::BeamFinger finger(3);
  ForceTable table = finger.rows(3, 10);
  table.position_mm.row(4).setConstant(std::numeric_limits<double>::quiet_NaN());
  table.time_s = Eigen::VectorXd::LinSpaced(table.rows(), 0, 2.9);
  const std::string csv = table.to_csv();
  const auto again = ForceTable::parse(csv, "table.csv");
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(again->to_csv(), csv);
  EXPECT_EQ(again->layouts, table.layouts);
  EXPECT_EQ(again->seen, table.seen);
  EXPECT_EQ(again->force_N, table.force_N);
  EXPECT_EQ(again->block, table.block);
  EXPECT_TRUE(std::isnan(again->position_mm(4, 0)));
}

TEST(ForceTable, BadTablesAreRefusedWithLineAndColumn) {
  const auto keep = [](int, std::string&) {};
  const auto in_row_7 = [](const char* text) {
    return [text](int row, std::string& line) {
      if (row == 7) line = text;
    };
  };
  const std::string head = "u0,v0,u1,v1,fx_n,fy_n";
  expect_words(table_refusal(""), "the table is empty");
  expect_words(table_refusal(head + "\n"), "0 rows are too few");
  expect_words(table_refusal(head + "\n1,2,3,4,5,6\n2,2,3,4,6,7\n3,2,3,4,7,8\n"),
               "3 rows are too few");
  expect_words(table_refusal(table_text("a,b,c,d,fx_n,fy_n", keep)), "no columns u0, v0");
  expect_words(table_refusal(table_text("u0,v0,u1,w,fx_n,fy_n", keep)), "'v1' is missing");
  expect_words(table_refusal(table_text("u0,v0,u2,v2,fx_n,fy_n", keep)), "'u1' is missing");
  expect_words(table_refusal(table_text("u0,v0,u1,v1,fx_n,b", keep)), "'fy_n' is missing");
  expect_words(table_refusal(table_text("u0,v0,u0,v1,fx_n,fy_n", keep)), "appears twice");
  expect_words(table_refusal(table_text("u0,v0,u1,v1,fx_n,fx_px", keep)),
               "'fx_n' and 'fx_px' both fit fx_n");
  expect_words(table_refusal(table_text("u0,v0,u1,v1,fx_px,fy_n", keep)),
               "'px' is not a unit of the column 'fx_px'");
  expect_words(table_refusal(table_text("u0,v0,seen0,v1,fx_n,fy_n", keep)), "line 1");
  expect_words(table_refusal(table_text(head, in_row_7("1,2,3,nan,5,6"))), "'nan' is not a number");
  expect_words(table_refusal(table_text(head, in_row_7("1,2,3,4,inf,6"))), "line 9, column fx_n");
  expect_words(table_refusal(table_text(head, in_row_7("1,2,3,4,five,6"))),
               "'five' is not a number");
  expect_words(table_refusal(table_text(head, in_row_7("1,2,3,4,,6"))), "a number is missing");
  expect_words(table_refusal(table_text(head, in_row_7("1,,3,4,5,6"))), "column v0");
  expect_words(table_refusal(table_text(head, in_row_7("1,2,3,4,5"))), "has 5 cells, not 6");
  expect_words(table_refusal(table_text(head, in_row_7(",,,,5,6"))), "no marker was seen");
  expect_words(table_refusal(table_text(head, in_row_7("1e300,2,3,4,5,6"))),
               "beyond the measurable range");
  expect_words(
      table_refusal(table_text(
          head, [](int row, std::string& line) { line = fmt::format("{},2,3,4,1,{}", row, row); })),
      "'fx_n' is the same in all rows");
  expect_words(
      table_refusal(table_text(
          head, [](int row, std::string& line) { line = fmt::format("1,2,3,4,{},{}", row, row); })),
      "no marker ever moves");
  expect_words(table_refusal(table_text("u0,v0,u1,along_mm,fx_n,fy_n", keep)), "line 1");
  expect_words(table_refusal("u9999,v9999,fx_n,fy_n\n1,2,3,4\n"), "markers up to number 9999");
}

TEST(ForceTable, EveryPartOfATableIsATableOrASentence) {
  const std::string text = table_text();
  for (std::size_t length = 0; length < text.size(); ++length) {
    const auto table = ForceTable::parse(text.substr(0, length), "table.csv");
    if (table)
      EXPECT_GE(table->rows(), 20);
    else
      EXPECT_FALSE(table.error().sentence().empty());
  }
}

std::vector<MarkerFrame> forty_frames(bool timed) {
  std::vector<MarkerFrame> frames;
  for (int i = 0; i < 40; ++i) {
    MarkerFrame frame;
    frame.name = fmt::format("frame_{:05}", i);
    if (timed) frame.time_s = 500.0 + 0.1 * i;
    frame.markers = {{100.0 + i, 50, true, 0.1}, {100.0, 450, i % 4 != 0, 0.1}};
    frames.push_back(frame);
  }
  return frames;
}

TEST(CollectForce, ReadingsAreInterpolatedAtTheFramesTimes) {
  std::string csv = "t_s,fx_n,fy_n,block\n";
  // F = (t, -2 t) at other times than the frames', from 1 s after the first.
  for (int i = 0; i < 20; ++i)
    csv += fmt::format("{0},{1},{2},a\n", 501 + 0.17 * i, 0.17 * i, -0.34 * i);
  const auto gauge = ForceGauge::parse_csv(csv, "gauge.csv");
  ASSERT_TRUE(gauge) << gauge.error().sentence();
  const auto collected = collect_force(forty_frames(true), *gauge);
  ASSERT_TRUE(collected) << collected.error().sentence();
  ASSERT_EQ(collected->remarks.size(), 1U) << "a steady pull tells no delay";
  EXPECT_NE(collected->remarks[0].english().find("could not be estimated"), std::string::npos);
  EXPECT_EQ(collected->frames, 40U);
  EXPECT_EQ(collected->left_out, 10U) << "those of the first second";
  const ForceTable& table = collected->table;
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    const double age_s = 0.1 * (table.layouts(row, 0) - 100) - 1;
    EXPECT_NEAR(table.force_N(row, 0), age_s, 1e-9);
    EXPECT_NEAR(table.force_N(row, 1), -2 * age_s, 1e-9);
  }
  EXPECT_EQ(table.seen(2, 1), 0);
}

// As force gauges' programs, spreadsheets and scripts write it.
TEST(ForceGauge, IsReadAsOtherProgramsWriteIt) {
  struct Example {
    const char* program;
    std::string csv;
    const char* understood;
  };
  // The second reading is taken 0.01 s after the first, with 1.5 N along x.
  for (const Example& example :
       {Example{"Mark-10",
                "Reading #,Load [N],Travel [mm],Time [s]\r\n1,0.5,0,0\r\n2,1.5,0,0.01\r\n",
                "t_s from 'Time [s]' in s"},
        {"Imada",
         "Model,ZTA-50N\nDate,2026/03/01 12:00:00\n\nTime(sec),Force(N)\n0.00,0.50\n0.01,1.50\n",
         "force_n from 'Force(N)' in N"},
        {"Sauter, German",
         "Datum;Uhrzeit;Kraft [mN]\r\n01.03.2026;12:00:00,00;500\r\n"
         "01.03.2026;12:00:00,01;1500\r\n",
         "time stamps of 'Uhrzeit'"},
        {"a script",
         "timestamp,value [N]\n2026-03-01T12:00:00.00+01:00,0.5\n"
         "2026-03-01T12:00:00.01+01:00,1.5\n",
         "time stamps of 'timestamp'"},
        {"pandas", ",timestamp,force\n0,1772366400000,0.5\n1,1772366400010,1.5\n",
         "in ms since 1970"},
        {"Excel, only dates",
         "Datum;Kraft\r\n01.03.2026 12:00:00,00;0,5\r\n01.03.2026 12:00:00,01;1,5\r\n",
         "date from 'Datum'"},
        {"LabVIEW", "X_Value\tForce\tComment\r\n0,000000\t0,500000\r\n0,010000\t1,500000\r\n",
         "tab-separated with decimal commas"}}) {
    SCOPED_TRACE(example.program);
    const auto gauge = ForceGauge::parse_csv(example.csv, "gauge.csv");
    ASSERT_TRUE(gauge) << gauge.error().sentence();
    ASSERT_EQ(gauge->readings.size(), 2U);
    EXPECT_NEAR(gauge->readings[1].time_s - gauge->readings[0].time_s, 0.01, 1e-6);
    EXPECT_EQ(gauge->readings[0].force_N, Eigen::Vector3d(0.5, 0, 0));
    EXPECT_EQ(gauge->readings[1].force_N, Eigen::Vector3d(1.5, 0, 0));
    EXPECT_NE(gauge->understood.english().find(example.understood), std::string::npos)
        << gauge->understood.english();
  }
}

// As a German spreadsheet writes it, and as others save it.
TEST(ForceGauge, SemicolonsAndTabulatorsPartNumbersWithDecimalCommas) {
  for (const auto& [name, csv] : {std::pair{"commas", "t_s,fx_n,fy_n\n0.5,0.125,-2\n1,12.345,0\n"},
                                  {"semicolons", "t_s;fx_n;fy_n\n0.5;0.125;-2\n1;12.345;0\n"},
                                  {"German", "t_s;fx_n;fy_n\n0,5;0,125;-2\n1;12,345;0\n"},
                                  {"tabs", "t_s\tfx_n\tfy_n\n0,5\t0,125\t-2\n1\t12,345\t0\n"}}) {
    SCOPED_TRACE(name);
    const auto gauge = ForceGauge::parse_csv(csv, "gauge.csv");
    ASSERT_TRUE(gauge) << gauge.error().sentence();
    ASSERT_EQ(gauge->readings.size(), 2U);
    EXPECT_EQ(gauge->readings[0].time_s, 0.5);
    EXPECT_EQ(gauge->readings[0].force_N, Eigen::Vector3d(0.125, -2, 0));
    EXPECT_EQ(gauge->readings[1].force_N.x(), 12.345) << "a comma, not thousands";
  }
  for (const char* bad : {"t_s;fx_n;fy_n\n0.5;12,345;0\n",   // both marks in one file
                          "t_s;fx_n;fy_n\n0,5;1.234,5;0\n",  // thousands
                          "t_s,fx_n,fy_n\n0,5,0,125,-2\n",   // decimal commas between commas
                          "t_s;fx_n;fy_n\n0,5;1 234;0\n"})
    EXPECT_FALSE(ForceGauge::parse_csv(bad, "gauge.csv").ok()) << bad;
}

TEST(CollectForce, OtherClocksBeginTogether) {
  std::string csv = "time_s,fx_n,fy_n\n";
  for (int i = 0; i < 60; ++i) csv += fmt::format("{0},{1},{1}\n", 0.1 * i, i);
  const auto collected =
      collect_force(forty_frames(true), *ForceGauge::parse_csv(csv, "gauge.csv"));
  ASSERT_TRUE(collected) << collected.error().sentence();
  ASSERT_EQ(collected->remarks.size(), 1U);
  EXPECT_NE(collected->remarks[0].english().find("different clocks"), std::string::npos);
  EXPECT_NEAR(collected->table.force_N(20, 0), 20, 1e-6);
}

TEST(CollectForce, TimesInAnotherUnitThanTheirColumnsAreRefusedWithBothSpans) {
  const auto refusal = [](const char* head, double step, int count) {
    std::string csv = std::string(head) + "\n";
    for (int i = 0; i < count; ++i) csv += fmt::format("{},{},{}\n", step * i, i % 7, i);
    const auto gauge = ForceGauge::parse_csv(csv, "gauge.csv");
    if (!gauge) return gauge.error().sentence();
    const auto collected = collect_force(forty_frames(true), *gauge);
    return collected ? std::string() : collected.error().sentence();
  };
  // 40 frames in 3.9 s from 500 s on.
  EXPECT_EQ(
      refusal("t_s,fx_n,fy_n", 10, 401),
      "gauge.csv: the gauge's times run from 0 to 4000 s, those of the images from 500 to "
      "503.9 s: the unit is wrong by a factor of 1000. Try: naming the column 't_s' 't_ms' if "
      "its times are in ms.");
  EXPECT_NE(refusal("Time [s],fx_n,fy_n", 1e4, 401).find("'Time [s]' 't_us'"), std::string::npos);
  EXPECT_NE(refusal("t_ms,fx_n,fy_n", 0.01, 401).find("'t_ms' 't_s'"), std::string::npos);
  EXPECT_NE(refusal("t_min,fx_n,fy_n", 0.01, 401).find("'t_min' 't_s'"), std::string::npos);
  // Right units: of this length, longer and shorter than the recording.
  for (const auto& [step, count] : {std::pair{0.01, 401}, {0.01, 100000}, {0.001, 500}, {0.3, 20}})
    EXPECT_EQ(refusal("t_s,fx_n,fy_n", step, count), "") << step;
  EXPECT_EQ(refusal("t_ms,fx_n,fy_n", 10, 401), "");
}

TEST(CollectForce, MostFramesWithoutAReadingAreRemarkedWithBothSpans) {
  const auto remarks = [](double first, double step) {
    std::string csv = "t_s,fx_n,fy_n\n";
    for (int i = 0; i < 400; ++i) csv += fmt::format("{},{},{}\n", first + step * i, i % 7, i);
    const auto collected =
        collect_force(forty_frames(true), ForceGauge::parse_csv(csv, "gauge.csv").value());
    EXPECT_TRUE(collected.ok());
    std::string text;
    if (collected)
      for (const Message& remark : collected->remarks) text += remark.english();
    return text;
  };
  // Only the first of the frames, at 500 s, is near a reading.
  EXPECT_THAT(remarks(500, 50),
              testing::HasSubstr("Most frames have no reading: the gauge's times run from 500 to "
                                 "20450 s, those of the images from 500 to 503.9 s."));
  EXPECT_THAT(remarks(499, 0.05), testing::Not(testing::HasSubstr("Most frames")));
}

TEST(CollectForce, NoReadingForAnyFrameIsExplained) {
  const auto refusal = [](const std::string& csv, bool timed) {
    const auto collected =
        collect_force(forty_frames(timed), *ForceGauge::parse_csv(csv, "gauge.csv"));
    EXPECT_FALSE(collected);
    return collected ? std::string() : collected.error().sentence();
  };
  EXPECT_NE(refusal("frame,fx_n,fy_n\nimg_1.png,1,2\n", false)
                .find("the gauge's file names 'img_1', the recording 'frame_00000'"),
            std::string::npos);
  EXPECT_NE(refusal("t_s,fx_n,fy_n\n500.05,1,2\n502.04,2,3\n503.95,2,4\n", true)
                .find("the readings are 1.99 s apart, at most 0.5 s"),
            std::string::npos);
}

TEST(CollectForce, NamesOfImagesMayHaveFoldersAndExtensions) {
  std::string csv = "image;force\n";
  for (int i = 10; i < 35; ++i) csv += fmt::format("C:\\shots\\frame_{:05}.png;{},5\n", i, i);
  const auto collected =
      collect_force(forty_frames(false), *ForceGauge::parse_csv(csv, "gauge.csv"));
  ASSERT_TRUE(collected) << collected.error().sentence();
  EXPECT_EQ(collected->table.rows(), 25);
  EXPECT_EQ(collected->table.force_N(0, 0), 10.5);
}

TEST(CollectForce, TypedReadingsGoByTheFramesNames) {
  std::string csv = "frame,fx_n,fy_n,fz_n,along_mm,across_mm,indenter\n";
  for (int i = 10; i < 35; ++i)
    csv += fmt::format("frame_{:05},{},1,{},{},2,ball\n", i, i, 0.5 * i, 30 + i);
  const auto collected =
      collect_force(forty_frames(false), *ForceGauge::parse_csv(csv, "gauge.csv"));
  ASSERT_TRUE(collected) << "a part of a table, in which fy_n may stay the same";
  EXPECT_FALSE(ForceTable::parse(collected->table.to_csv(), "table.csv"));
  std::string good = csv;
  good.replace(good.find(",1,"), 3, ",2,");
  const auto again = collect_force(forty_frames(false), *ForceGauge::parse_csv(good, "gauge.csv"));
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(again->table.rows(), 25);
  EXPECT_EQ(again->table.axes, 3);
  EXPECT_EQ(again->table.force_N(4, 2), 7);
  EXPECT_EQ(again->table.position_mm(4, 0), 44);
  EXPECT_EQ(again->table.indenter[0], "ball");
}

TEST(CollectForce, UnitsTimesAndSingleForcesOfOtherProgramsAreUnderstood) {
  const auto first = [](const char* csv, const GaugeFileOptions& options = {}) {
    const auto gauge = ForceGauge::parse_csv(csv, "gauge.csv", options);
    EXPECT_TRUE(gauge) << csv << gauge.error().sentence();
    return gauge ? gauge->readings.at(0) : GaugeReading();
  };
  EXPECT_NEAR(first("t_s,fx_kgf,fy_gf\n1,2,3\n").force_N.x(), 19.6133, 1e-12);
  EXPECT_NEAR(first("t_s,fx_kgf,fy_gf\n1,2,3\n").force_N.y(), 0.02941995, 1e-12);
  EXPECT_NEAR(first("Time (ms),Fx [lbf],Fy [lbf]\n1500,1,0\n").force_N.x(), 4.4482216152605, 1e-12);
  EXPECT_EQ(first("Time (ms),Fx [lbf],Fy [lbf]\n1500,1,0\n").time_s, 1.5);
  EXPECT_EQ(first("time_ns,fx,fy\n81234567890000,1,0\n").time_s, 81234.56789);
  GaugeFileOptions options;
  options.unit_N = 9.80665e-3;
  options.direction = Eigen::Vector3d(0, -1, 0);
  EXPECT_NEAR(first("t_s,Force\n1,100\n", options).force_N.y(), -0.980665, 1e-12);
  EXPECT_NEAR(first("t_s,force_n\n1,100\n", options).force_N.y(), -100, 1e-12);
  const auto unknown = ForceGauge::parse_csv("t_s,fx_mm,fy_mm\n1,2,3\n", "gauge.csv");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().sentence().find("'mm' is not a unit"), std::string::npos);
}

TEST(CollectForce, WhereAGaugeIsOverRangeThereIsNoForce) {
  std::string csv =
      "# alltact-gauge/1\n# gauge: serial:x\n"
      "t_s,fx_n,fy_n,fz_n,sd_n,holds,block,indenter\n";
  for (int i = 0; i < 41; ++i)
    csv += i == 20 ? fmt::format("{},,,,,0,,\n", 500 + 0.1 * i)
                   : fmt::format("{},{},{},0,0.01,0,,\n", 500 + 0.1 * i, i, i % 3);
  const auto gauge = ForceGauge::parse_csv(csv, "a.gauge.csv");
  ASSERT_TRUE(gauge) << gauge.error().sentence();
  EXPECT_TRUE(gauge->is_on_frame_clock);
  EXPECT_FALSE(gauge->has_block);
  CollectOptions options;
  options.shift_s = 0.05;
  const auto collected = collect_force(forty_frames(true), *gauge, options);
  ASSERT_TRUE(collected) << collected.error().sentence();
  EXPECT_EQ(collected->left_out, 2U) << "between 19 and 20, and between 20 and 21";
  EXPECT_NEAR(collected->reading_sd_N, 0.01, 1e-12);
  EXPECT_EQ(collected->clock.source, GaugeClock::Source::kGiven);
  EXPECT_NEAR(collected->table.force_N(5, 0), 5.5, 1e-6);
  const auto none = ForceGauge::parse_csv("t_s,fx_n,fy_n\n1,,\n", "gauge.csv");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().sentence().find("holds no reading"), std::string::npos);
}

TEST(ForceTable, TablesOfSeveralRecordingsAreOne) {
  const test::TemporaryFolder folder;
  const auto write = [&](const char* name, const char* axis, bool has_blocks) {
    std::string csv =
        fmt::format("frame,t_s,fx_n,fy_n,fz_n,u0,v0,u1,v1{}\n", has_blocks ? ",block" : "");
    for (int i = 0; i < 15; ++i)
      csv += fmt::format("f{0},{0},{1},{2},0,{3},50,200,450{4}\n", i, *axis == 'x' ? i : 0,
                         *axis == 'y' ? i : 0, 100 + i,
                         has_blocks ? fmt::format(",press {}", i / 5) : "");
    EXPECT_TRUE(write_file_atomically(folder / name, csv));
    return folder / name;
  };
  const auto x = write("x.csv", "x", true), y = write("y.csv", "y", false);
  EXPECT_FALSE(ForceTable::load(x)) << "alone there is too little of it";
  const auto both = ForceTable::load_all({x, y});
  ASSERT_TRUE(both) << both.error().sentence();
  EXPECT_EQ(both->rows(), 30);
  EXPECT_EQ(both->axes, 2) << "an fz that is 0 everywhere was not measured";
  EXPECT_EQ(both->ignored_columns, std::vector<std::string>{"fz_n"});
  EXPECT_EQ(both->force_N(14, 0), 14);
  EXPECT_EQ(both->force_N(29, 1), 14);
  EXPECT_EQ(both->block[0], "x press 0");
  EXPECT_EQ(both->block[29], "y 4");
  EXPECT_EQ(both->frame[15], "f0");
  EXPECT_EQ(both->time_s.size(), 30);
  ASSERT_TRUE(write_file_atomically(folder / "z.csv", "fx_n,fy_n,fz_n,u0,v0\n1,2,3,4,5\n"));
  const auto other = ForceTable::load_all({x, folder / "z.csv"});
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().sentence().find("has 1 markers and 3 axes"), std::string::npos)
      << other.error().sentence();
  EXPECT_FALSE(ForceTable::load_all({x, folder / "none.csv"}));
  EXPECT_NE(ForceTable::load_all({x, x}).error().sentence().find("'fy_n' is the same"),
            std::string::npos);
}

TEST(CollectForce, TheTruthOfASimulationIsAGauge) {
  const auto gauge = ForceGauge::parse_truth(
      R"({"frames": [{"frame": "frame_00000"},
          {"frame": "frame_00001", "contacts": [
            {"name": "push", "force_N": [1.0, 0.5, 0.25], "along_mm": 40, "across_mm": 1},
            {"name": "push#2", "force_N": [0.5, 0, 0], "along_mm": 60, "across_mm": 2}]},
          {"frame": "frame_00002", "contacts": [{"name": "ball"}]}]})",
      "truth.json");
  ASSERT_TRUE(gauge) << gauge.error().sentence();
  ASSERT_EQ(gauge->readings.size(), 2U) << "the ball's force is not known";
  EXPECT_EQ(gauge->readings[0].force_N.norm(), 0);
  EXPECT_EQ(gauge->readings[1].force_N, Eigen::Vector3d(1.5, 0.5, 0.25));
  EXPECT_EQ(*gauge->readings[1].position_mm, Eigen::Vector2d(40, 1));
}

TEST(CollectForce, BadGaugesAreRefused) {
  const auto refusal = [](const char* csv) {
    const auto gauge = ForceGauge::parse_csv(csv, "gauge.csv");
    EXPECT_FALSE(gauge) << csv;
    return gauge ? std::string() : gauge.error().sentence();
  };
  const auto has = [](const std::string& sentence, const char* words) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  has(refusal(""), "empty");
  has(refusal("t_s,fx_n,fy_n\n"), "no reading");
  has(refusal("t_s,fx_n\n1,2\n"), "'fy_n' is missing");
  has(refusal("fx_n,fy_n\n1,2\n"), "'t_s' is missing; found: 'fx_n', 'fy_n'");
  has(refusal("Zeit,Druck\n1,2\n"), "'fx_n' is missing; found: 'Zeit', 'Druck'");
  has(refusal("t_s,fx_n,fy_n\n1,2,x\n"), "gauge.csv, line 2, column fy_n: 'x' is not a number");
  has(refusal("t_s,fx_n,fy_n\n1,2,1e6\n"), "beyond the measurable range");
  has(refusal("t_s,fx_n,fy_n\n2,2,3\n1,2,3\n"), "line 3, column t_s: the time '1' comes after '2'");
  has(refusal("t_s,fx_n,fy_n\n2,2,3\n2,3,4\n"), "the time '2' is that of line 2, too");
  has(refusal("time,fx_n,fy_n\n23:59:59,2,3\n00:00:01,3,4\n"), "'00:00:01' comes after '23:59:59'");
  has(refusal("frame,fx_n,fy_n\na,2,3\na.png,3,4\n"), "the frame 'a.png' is that of line 2, too");
  has(refusal("frame,fx_n,fy_n\n,2,3\n"), "the name of the frame is missing");
  has(refusal("t_s,fx_n,fy_n,holds\n1,2,3,yes\n"), "'yes' is neither 1 nor 0");
  has(refusal("t_s,fx_n,fy_n,sd_n\n1,2,3,?\n"), "column sd_n: '?' is not a number");
  has(refusal("t_s,fx_n,fy_n\n1,2\n"), "has 2 cells, not 3");
  EXPECT_FALSE(ForceGauge::parse_truth("{}", "truth.json"));
  EXPECT_FALSE(ForceGauge::parse_truth("[", "truth.json"));
  EXPECT_FALSE(ForceGauge::parse_truth(R"({"frames": [{"frame": "a"}]})", "truth.json"));
  const auto untimed = collect_force(forty_frames(false),
                                     *ForceGauge::parse_csv("t_s,fx_n,fy_n\n1,2,3\n", "gauge.csv"));
  ASSERT_FALSE(untimed);
  has(untimed.error().sentence(), "have no times");
}

}  // namespace
}  // namespace alltact
