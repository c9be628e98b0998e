// Readers of tables, lines and logs.
#include "calibration/checks/check_history.h"
#include "calibration/checks/gage_readings.h"
#include "calibration/force/collect_force.h"
#include "calibration/force/force_table.h"
#include "core/base/atomic_file.h"
#include "core/base/table.h"
#include "core/batch/parts.h"
#include "core/devices/gauge_source.h"
#include "core/gripper/gripper_recording.h"
#include "core/recording/journal.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sensing/reference/recorded_faces.h"
#include "core/stream/stream_format.h"
#include "tests/fuzz/readers.h"

#include <sstream>

namespace alltact::test {
namespace {

constexpr int kMarkers = 4;

std::vector<std::string> marker_seeds() {
  MarkerTable table;
  table.frames = {3, 17};
  table.layouts = Eigen::MatrixXd::Constant(2, 2 * kMarkers, 101.25);
  table.layouts(1, 3) = 1e-9;
  table.seen = {{1, 1, 0, 1}, {1, 1, 1, 1}};
  table.typical.resize(kMarkers);
  for (Dot& dot : table.typical) dot.radius_px = 3.5, dot.contrast = 40;
  return {
      written_by("m.csv", [&](const std::filesystem::path& file) { (void)table.save(file).ok(); })};
}

Reading read_markers(const std::string& bytes) {
  static const ScratchFile file("reference.csv"), again("again.csv");
  return reading_of(MarkerTable::load(file.write(bytes), kMarkers),
                    [](const MarkerTable& table) -> std::string {
                      if (!table.layouts.allFinite()) return "a marker that is nowhere";
                      if (!table.save(again.path())) return "read, but not to be written";
                      const auto back = MarkerTable::load(again.path(), kMarkers);
                      if (!back) return "what was written is refused: " + back.error().sentence();
                      return back->layouts == table.layouts ? "" : "other markers come back";
                    });
}

std::vector<std::string> journal_seeds() {
  return {written_by("v.frames.csv", [](const std::filesystem::path& file) {
    auto journal = JournalWriter::create(file, "camera");
    Frame frame;
    for (int i = 0; i < 3; ++i) {
      frame.sequence = static_cast<std::uint64_t>(i);
      frame.time_ns = 81234567890 + 33'333'333L * i;
      frame.controls = std::make_shared<const std::string>("Exposure=200; Gain=3");
      (void)journal->add(frame).ok();
    }
    (void)journal->remark("2 frames never came").ok();
    (void)journal->finish().ok();
  })};
}

/// Times never go back.
Reading read_frame_log(const std::string& bytes) {
  static const ScratchFile file("v.frames.csv");
  return reading_of(read_journal(file.write(bytes)), [](const auto& entries) -> std::string {
    for (std::size_t i = 1; i < entries.size(); ++i)
      if (entries[i].time_ns && entries[i - 1].time_ns &&
          *entries[i].time_ns < *entries[i - 1].time_ns)
        return "time goes back";
    return file.stray();
  });
}

CheckEntry some_check() {
  return {"2026-01-31T12:00:00Z",
          CheckVerdict::kDrifting,
          0.031,
          0.025,
          0.05,
          -3.5,
          3,
          4.0,
          "2026-01-01T00:00:00Z",
          "0.1.0",
          -0.012,
          "Ann, \"late\""};
}

std::vector<std::string> check_seeds() {
  return {written_by(kCheckFile, [](const std::filesystem::path& file) {
    for (int i = 0; i < 2; ++i) (void)append_check(file.parent_path(), some_check()).ok();
  })};
}

/// Whatever is in the file, a check that is added to it is read as its last.
Reading read_checks(const std::string& bytes) {
  static const ScratchFile file(kCheckFile);
  (void)file.write(bytes);
  std::vector<Message> warnings;
  return reading_of(load_checks(file.folder(), &warnings), [](const auto& checks) -> std::string {
    for (const CheckEntry& entry : checks)
      if (!std::isfinite(entry.error_mm)) return "an error that is no number";
    return file.stray();
  });
}

/// A study of the table has finite figures, and its parts of the sum of squares add up.
Reading read_gage(const std::string& bytes) {
  static const ScratchFile file("gage.csv");
  return reading_of(read_gage_table(file.write(bytes)), [](const GageReadings& read) {
    const auto study = gage_study(read.readings);
    if (!study) return fault_of(Reading{study.error()});
    for (const double figure : {study->gage, study->total_sd, study->gage_95.high, study->mean})
      if (!std::isfinite(figure)) return std::string("a figure that is no number");
    return std::string(study->gage <= study->total_sd * (1 + 1e-9) ? "" : "more than all");
  });
}

std::string force_rows(const std::string& head, const std::string& middle) {
  std::string text = head + "\n";
  for (int row = 0; row < 24; ++row) {
    const std::string n = std::to_string(row);
    text += std::to_string(100 + row) + ",50.5," + std::to_string(200 - row) + ",450," + middle +
            "0." + n + ",-0.2" + n + "\n";
  }
  return text;
}

Reading read_force_table(const std::string& bytes) {
  return reading_of(ForceTable::parse_part(bytes, "table.csv"), [](const ForceTable& table) {
    if (!table.force_N.allFinite() || !table.layouts.allFinite())
      return std::string("a force or a place that is no number");
    const std::string written = table.to_csv();
    return same_again<ForceTable>(written, ForceTable::parse_part(written, "table.csv"),
                                  [](const ForceTable& t) { return t.to_csv(); });
  });
}

Reading read_gauge_log(const std::string& bytes) {
  return reading_of(ForceGauge::parse_csv(bytes, "v.gauge.csv"), [](const ForceGauge& gauge) {
    double before = -std::numeric_limits<double>::infinity();
    for (const GaugeReading& reading : gauge.readings) {
      if (!reading.force_N.allFinite()) return std::string("a force that is no number");
      if (gauge.by_time && !(reading.time_s >= before)) return std::string("time goes back");
      before = gauge.by_time ? reading.time_s : before;
    }
    return std::string();
  });
}

/// All numbers and times are finite, and every sentence is one line.
Reading read_table(const std::string& bytes) {
  auto table = Table::open(bytes, "table.csv",
                           {{{"t_s", Measure::kTime, {"time", "zeit"}},
                             {"date", {}, {"datum"}},
                             {.key = "fx_n", .measure = Measure::kForce, .names_with_unit = {"x"}},
                             {.key = "u_px", .measure = Measure::kPixel, .is_numbered = true},
                             {"block"}},
                            en::say("a table")});
  if (!table) return {table.error()};
  const int time = table->find("t_s"), date = table->find("date");
  for (auto more = table->next();; more = table->next()) {
    if (!more) return {more.error()};
    if (!*more) break;
    for (int i = 0; i < static_cast<int>(table->columns().size()); ++i) {
      const auto number = i == time ? table->time_s(i, date) : table->number(i);
      if (number && !std::isfinite(*number)) return {std::nullopt, "a number that is not finite"};
      if (!number) {
        if (const Reading refused{number.error()}; !fault_of(refused).empty()) return refused;
      }
      (void)table->time_ns(i).ok();
    }
  }
  return {std::nullopt, fault_of(Reading{Error{table->understood(), "", ""}})};
}

Reading read_gauge_lines(const std::string& bytes) {
  for (const GaugeFormat format : {GaugeFormat::kPlain, GaugeFormat::kSauter})
    for (const bool is_comma_decimal : {false, true}) {
      const GaugeLine line = read_gauge_line(bytes, {format, 0.00980665, is_comma_decimal});
      for (int i = 0; i < line.count; ++i)
        if (!(std::abs(line.force_N.at(static_cast<std::size_t>(i))) <= 1e5))
          return {std::nullopt, "a force beyond any gauge"};
    }
  return {};
}

Reading read_part(const std::string& bytes) {
  static const ScratchFile file("results.part-1-of-1.jsonl");
  for (const auto& entry : std::filesystem::directory_iterator(file.folder()))
    std::filesystem::remove(entry.path());
  (void)file.write(bytes);
  return reading_of(merge_parts({file.folder()}), [](const MergedParts& merged) {
    const auto results = file.folder() / "results.jsonl";
    return merged.results == results && std::filesystem::exists(results) ? "" : "no results";
  });
}

std::vector<std::string> part_seeds() {
  return {written_by("results.part-1-of-1.jsonl", [](const std::filesystem::path& file) {
    PartResults part;
    part.run = "0123456789abcdef";
    part.frame_count = 2;
    for (int i = 0; i < 2; ++i) {
      FrameLine line;
      line.frame = "frame_0000" + std::to_string(i);
      line.line = "{\"frame\":\"" + line.frame + "\",\"index\":" + std::to_string(i) + "}";
      line.is_measured = true;
      part.lines.push_back(line.to_json());
    }
    (void)write_part(file.parent_path(), part).ok();
  })};
}

constexpr const char* kFacesOf = "a recording";

std::vector<std::string> faces_seeds() {
  FaceCache faces;
  for (const std::size_t row : {0U, 2U}) {
    FoundFace& face = faces.found.emplace_back();
    face.row = row;
    face.edges.u = {3.5, 11.5, 19.5};
    face.edges.upper = face.edges.lower = {{10, 11, 12}, {0.1, 0.1, 0.2}, {1, 1, 0}};
    face.edges.ends.first = FaceEnd{1, 2, 0, 0, 0.5};
  }
  faces.retained = {2};
  faces.faces = {{0, 4, {1, 2, 3, 4}}};
  faces.error.relative_sd = cv::Mat(2, 3, CV_32FC1, cv::Scalar(0.25));
  return {pack_faces(faces, kFacesOf)};
}

Reading read_kept_faces(const std::string& bytes) {
  std::istringstream file(bytes);
  const auto faces = unpack_faces(file, bytes.size(), kFacesOf);
  if (!faces)
    return {
        Error{en::say("not what was kept"), en::say("the cache"), en::say("read the recording")}};
  for (const FoundFace& face : faces->found)
    if (face.edges.upper.v.size() != face.edges.u.size()) return {{}, "an edge of another length"};
  return {{}, faces->retained.size() == faces->faces.size() ? "" : "faces of no row"};
}

}  // namespace

std::vector<Reader> table_readers() {
  return {
      {"kept_faces", faces_seeds, read_kept_faces},
      {"marker_table", marker_seeds, read_markers},
      {"frame_log", journal_seeds, read_frame_log},
      {"checks", check_seeds, read_checks},
      {"gage_table",
       [] {
         return std::vector<std::string>{
             "part,operator,value_mm\na,A,1.5\na,A,1.25\nb,A,2\nb,A,2.5\n",
             "Finger;Appraiser;Reading [um]\n1;x;1e12\n1;y;-3,5\n1;x;1\n1;y;2\n"};
       },
       read_gage},
      {"force_table",
       [] {
         return std::vector{
             force_rows("u0,v0,u1,v1,fx_n,fy_n", ""),
             force_rows("u0,v0,u1,v1,block,t_s,along_mm,across_mm,fx_n,fy_n", "a,1,40,2,")};
       },
       read_force_table},
      {"gauge_log",
       [] {
         return std::vector<std::string>{
             "# alltact-gauge/1\n# gauge: serial:x\nt_s,fx_n,fy_n,fz_n,sd_n,holds,block,indenter\n"
             "500.1,0.5,-0.25,0,0.01,0,,\n500.2,,,,,0,,\n500.3,1.5,0,0,0.01,1,a,ball\n",
             "frame,force_gf\npress_0,12.5\npress_1,-3\n"};
       },
       read_gauge_log},
      {"table",
       [] {
         return std::vector<std::string>{
             "sep=;\r\nZeit [ms];X (mN);block\r\n0;0,5;\"a;\"\"b\"\"\nc\"\r\n10;1,25;d\r\n",
             std::string("\xFF\xFEt\0_\0s\0\t\0f\0x\0\n\0001\0\t\0002\0\n\0", 24),
             "Model,M5\n# t_s fx_n u0\n\ndate,time,fx\n-,s,kN\n01.03.2026,12:00:00.5,2e-3\n",
             "t_s  x [kgf]  u0 u1\n2026-03-01T12:00:00Z  1  2 3\n",
             "\xCA\xB1\xBC\xE4,fx_n\r1772366400123,-.5\r"};
       },
       read_table},
      {"gauge_line",
       [] {
         return std::vector<std::string>{
             "+0.123 N", "-18.78 lbF", "1.2 0.3 -0.1", "0.5,0.25", "+01.23KT0", "0011.70", "OL"};
       },
       read_gauge_lines},
      {"motor_log",
       [] { return std::vector<std::string>{"time_ns,turns\n1000,2.0\n2000,3.0\r\n4000,-1.5\n"}; },
       [](const std::string& bytes) {
         return reading_of(MotorLog::parse(bytes, "motor.csv"), [](const MotorLog& log) {
           const auto turns = log.turns_at(1500);
           return turns && !std::isfinite(*turns) ? "turns that are no number" : "";
         });
       }},
      {"part", part_seeds, read_part},
      {"stream_request",
       [] { return std::vector<std::string>{"alltact-stream/1 picture depth16 points"}; },
       [](const std::string& bytes) { return reading_of(stream_request(bytes), kNoLaw); }},
  };
}

}  // namespace alltact::test
