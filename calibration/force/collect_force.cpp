#include "calibration/force/collect_force.h"

#include "calibration/force/force_table.h"
#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/base/table.h"
#include "core/devices/gauge_log.h"
#include "core/numerics/median.h"
#include "core/open/open_source.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

constexpr double kMinStillPx = 0.3, kMaxStillPx = 1.5, kStillNoise = 4;
constexpr double kAroundEnter_s = 0.15, kNearestFrame_s = 0.5;
constexpr double kMaxTime_s = 1e12, kMaxForce_N = 1e5;

/// Root mean square distance of the markers seen in both; nullopt: none.
std::optional<double> distance_px(const Markers& one, const Markers& two) {
  if (one.size() != two.size()) return std::nullopt;
  double squares = 0, count = 0;
  for (std::size_t m = 0; m < one.size(); ++m)
    if (one[m].seen && two[m].seen) {
      squares += std::pow(one[m].u - two[m].u, 2) + std::pow(one[m].v - two[m].v, 2);
      count += 1;
    }
  return count > 0 ? std::optional(std::sqrt(squares / count)) : std::nullopt;
}

/// Root mean square distance of two neighbouring frames of a finger at rest. The median is one of
/// frames at rest as long as half of them are.
double noise_px(const std::vector<MarkerFrame>& frames) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i)
    if (const auto step = distance_px(frames[i - 1].markers, frames[i].markers))
      steps.push_back(*step);
  return upper_median(steps);
}

/// Means of the markers over frames [first, last).
Markers mean_layout(const std::vector<MarkerFrame>& frames, std::size_t first, std::size_t last) {
  Markers mean = frames[first].markers;
  for (std::size_t m = 0; m < mean.size(); ++m) {
    double u = 0, v = 0, count = 0;
    for (std::size_t i = first; i < last; ++i)
      if (frames[i].markers.size() == mean.size() && frames[i].markers[m].seen)
        u += frames[i].markers[m].u, v += frames[i].markers[m].v, count += 1;
    mean[m].seen = count > 0;
    if (count > 0) mean[m].u = u / count, mean[m].v = v / count;
  }
  return mean;
}

/// For each reading that holds, the frames that it applies to, as an index of the reading for each
/// frame. These are the frames around its time, without a gap, whose markers have not moved. The
/// limit is 4 times their noise (0.3 to 1.5 px), root mean square, and the neighbouring readings
/// bound them. -1: none. Frames with times, ascending.
std::vector<int> held_readings(const std::vector<MarkerFrame>& frames, const ForceGauge& gauge,
                               const GaugeClock& clock) {
  std::vector<int> held(frames.size(), -1);
  const double still_px = std::clamp(kStillNoise * noise_px(frames), kMinStillPx, kMaxStillPx);
  const auto frame_at = [&](double time_s) {
    return static_cast<std::size_t>(
        std::lower_bound(frames.begin(), frames.end(), time_s,
                         [](const MarkerFrame& f, double t) { return *f.time_s < t; }) -
        frames.begin());
  };
  for (std::size_t r = 0; r < gauge.readings.size(); ++r) {
    const GaugeReading& reading = gauge.readings[r];
    if (!reading.holds || !reading.has_force) continue;
    const double enter_s = clock.frame_time_s(reading.time_s);
    const std::size_t begin = frame_at(enter_s - kAroundEnter_s);
    const std::size_t end = std::max(frame_at(enter_s + kAroundEnter_s), begin + 1);
    if (begin >= frames.size() || std::abs(*frames[begin].time_s - enter_s) > kNearestFrame_s)
      continue;
    const Markers then = mean_layout(frames, begin, std::min(end, frames.size()));
    const std::size_t first =
        r == 0 ? 0 : frame_at(clock.frame_time_s(gauge.readings[r - 1].time_s));
    const std::size_t last = r + 1 == gauge.readings.size()
                                 ? frames.size()
                                 : frame_at(clock.frame_time_s(gauge.readings[r + 1].time_s));
    const auto take = [&](std::size_t i) {
      const auto distance = distance_px(frames[i].markers, then);
      if (!distance || *distance > still_px || held[i] >= 0) return false;
      held[i] = static_cast<int>(r);
      return true;
    };
    for (std::size_t i = std::min(end, last); i-- > first;)
      if (!take(i)) break;
    for (std::size_t i = std::min(end, last); i < last; ++i)
      if (!take(i)) break;
  }
  return held;
}

/// Looks up the readings of a gauge by frame.
class GaugeLookup {
 public:
  /// `frames` in the order of the look-ups.
  GaugeLookup(const std::vector<MarkerFrame>& frames, const ForceGauge& gauge,
              const GaugeClock& clock)
      : gauge_(gauge), clock_(clock) {
    if (gauge.by_time) {
      held_ = held_readings(frames, gauge, clock);
      return;
    }
    for (const GaugeReading& reading : gauge.readings) by_name_[reading.frame] = &reading;
  }

  [[nodiscard]] std::optional<GaugeReading> operator()(const MarkerFrame& frame,
                                                       std::size_t at) const {
    if (gauge_.by_time)
      return held_[at] >= 0 ? gauge_.readings[static_cast<std::size_t>(held_[at])]
                            : between(clock_.gauge_time_s(*frame.time_s));
    const auto found = by_name_.find(frame.name);
    if (found == by_name_.end() || !found->second->has_force) return std::nullopt;
    return *found->second;
  }

 private:
  [[nodiscard]] std::optional<GaugeReading> between(double time_s) const {
    const auto after =
        std::lower_bound(gauge_.readings.begin(), gauge_.readings.end(), time_s,
                         [](const GaugeReading& r, double t) { return r.time_s < t; });
    if (after == gauge_.readings.end()) return std::nullopt;
    if (after->holds || !after->has_force) return std::nullopt;
    if (after->time_s == time_s) return *after;
    if (after == gauge_.readings.begin()) return std::nullopt;
    const GaugeReading &one = *(after - 1), &two = *after;
    const double gap_s = two.time_s - one.time_s;
    if (!one.has_force || one.holds || gap_s > kLongestGaugeGapS || one.block != two.block)
      return std::nullopt;
    const double part = (time_s - one.time_s) / gap_s;
    GaugeReading interpolated = part < 0.5 ? one : two;
    interpolated.force_N = (1 - part) * one.force_N + part * two.force_N;
    return interpolated;
  }

  const ForceGauge& gauge_;
  GaugeClock clock_;
  std::vector<int> held_;
  std::map<std::string, const GaugeReading*> by_name_;
};

void add_row(const MarkerFrame& frame, const GaugeReading& reading, const ForceGauge& gauge,
             Eigen::Index row, ForceTable& table) {
  for (Eigen::Index m = 0; m < table.marker_count; ++m) {
    const Marker& marker = frame.markers[static_cast<std::size_t>(m)];
    table.seen(row, m) = marker.seen ? 1 : 0;
    table.layouts(row, 2 * m) = marker.seen ? marker.u : 0;
    table.layouts(row, 2 * m + 1) = marker.seen ? marker.v : 0;
  }
  table.force_N.row(row) = reading.force_N.head(table.axes).transpose();
  // The position that the pipeline measures takes precedence over the one of the set-up.
  const auto& position = frame.position_mm ? frame.position_mm : reading.position_mm;
  if (position) table.position_mm.row(row) = position->transpose();
  if (gauge.has_block) table.block.push_back(reading.block);
  if (gauge.has_day) table.day.push_back(reading.day);
  if (gauge.has_indenter) table.indenter.push_back(reading.indenter);
  table.frame.push_back(frame.name);
  if (table.time_s.size() > 0) table.time_s[row] = *frame.time_s;
}

/// The rows of a press, from one moment without load to the next, form one block. Too few presses
/// give no blocks.
void name_presses(ForceTable& table) {
  constexpr double kUnloaded = 0.1;
  constexpr int kMinPresses = 5;
  const Eigen::VectorXd force_N = table.force_N.rowwise().norm();
  std::vector<double> sorted(force_N.begin(), force_N.end());
  std::sort(sorted.begin(), sorted.end());
  const double loaded_N = sorted.empty() ? 0 : sorted[sorted.size() * 95 / 100];
  int presses = 0;
  bool is_loaded = false;
  std::vector<std::string> names;
  for (const double force : force_N) {
    // Hysteresis: loaded from 2 kUnloaded on, so that noise around the bound is one press.
    if (!is_loaded && force > 2 * kUnloaded * loaded_N) is_loaded = true, ++presses;
    if (is_loaded && force < kUnloaded * loaded_N) is_loaded = false;
    names.push_back(fmt::format("press {}", presses));
  }
  if (presses >= kMinPresses) table.block = std::move(names);
}

double median_sd_N(const std::vector<std::pair<const MarkerFrame*, GaugeReading>>& rows) {
  std::vector<double> sds;
  for (const auto& [frame, reading] : rows)
    if (std::isfinite(reading.sd_N)) sds.push_back(reading.sd_N);
  return sds.empty() ? std::numeric_limits<double>::quiet_NaN() : upper_median(sds);
}

/// First and last time, and the median distance of neighbouring ones.
struct Span {
  double first_s = 0, last_s = 0, step_s = 0;
  [[nodiscard]] double length_s() const { return last_s - first_s; }
};

template <class Times>
Span span_of(const Times& times, auto time_of) {
  Span span{time_of(times.front()), time_of(times.back()), 0};
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i)
    steps.push_back(time_of(times[i]) - time_of(times[i - 1]));
  if (!steps.empty()) span.step_s = upper_median(steps);
  return span;
}

Message spans_of(const Span& of_gauge, const Span& of_frames) {
  return en::say(
      "the gauge's times run from {:g} to {:g} s, those of the images from {:g} to {:g} s",
      of_gauge.first_s, of_gauge.last_s, of_frames.first_s, of_frames.last_s);
}

/// The times in the gauge's file are in another unit than they are read in. Evidence: by a known
/// unit's factor both recordings have a similar length, and the readings are farther apart than any
/// gauge's that can be interpolated, or closer than any gauge's.
std::optional<Error> wrong_time_unit(const ForceGauge& gauge, const Span& of_gauge,
                                     const Span& of_frames) {
  constexpr double kSimilar = 5, kMinStep_s = 2e-4;
  const bool is_sparse = of_gauge.step_s > kLongestGaugeGapS;
  if (gauge.time_column.empty() || gauge.is_on_frame_clock || gauge.readings.size() < 3 ||
      !(of_frames.length_s() > 0) || !(is_sparse || of_gauge.step_s < kMinStep_s))
    return std::nullopt;
  const double ratio = of_gauge.length_s() / of_frames.length_s();
  struct Unit {
    const char* symbol;
    double factor;
  };
  std::optional<Unit> meant;
  double nearest = std::log(kSimilar);
  for (const char* symbol : {"ns", "us", "ms", "s", "min", "h", "d"}) {
    const double factor = gauge.time_unit_s / measurement_unit(Measure::kTime, symbol)->convert(1);
    const double away = std::abs(std::log(ratio / factor));
    if (away < nearest && (factor > kSimilar) == is_sparse && std::abs(std::log(factor)) > 1)
      nearest = away, meant = Unit{symbol, factor};
  }
  if (!meant) return std::nullopt;
  const double times = std::max(meant->factor, 1 / meant->factor);
  return Error{
      en::say("{}: the unit is wrong by a factor of {:g}", spans_of(of_gauge, of_frames), times),
      gauge.origin,
      en::say("naming the column '{}' 't_{}' if its times are in {}", printable(gauge.time_column),
              std::string(meant->symbol), std::string(meant->symbol))};
}

/// The reason why no frame has a reading.
Error no_reading(const std::vector<MarkerFrame>& frames, const ForceGauge& gauge,
                 const GaugeClock& clock) {
  if (!gauge.by_time)
    return Error{en::say("no frame has a reading: the gauge's file names '{}', the recording '{}'",
                         printable(gauge.readings.front().frame), printable(frames.front().name)),
                 gauge.origin, en::say("the names of the images in the column 'frame'")};
  const Span of_gauge = span_of(gauge.readings, [](const GaugeReading& r) { return r.time_s; });
  if (of_gauge.step_s > kLongestGaugeGapS)
    return Error{en::say("no frame has a reading: the readings are {:.3g} s apart, at most {} s "
                         "can be interpolated",
                         of_gauge.step_s, kLongestGaugeGapS),
                 gauge.origin, en::say("a higher rate of the gauge")};
  return Error{
      en::say("no frame has a reading: the gauge's times run from {:g} to {:g} s, those of "
              "the images on its clock from {:g} to {:g} s",
              of_gauge.first_s, of_gauge.last_s, clock.gauge_time_s(*frames.front().time_s),
              clock.gauge_time_s(*frames.back().time_s)),
      gauge.origin, en::say("a gauge that records with the camera, or --gauge-shift-s")};
}

std::vector<MarkerFrame> in_order(const std::vector<MarkerFrame>& frames) {
  std::vector<MarkerFrame> ordered = frames;
  std::stable_sort(ordered.begin(), ordered.end(), [](const MarkerFrame& a, const MarkerFrame& b) {
    return *a.time_s < *b.time_s;
  });
  return ordered;
}

}  // namespace

Result<CollectedForce> collect_force(const std::vector<MarkerFrame>& all, const ForceGauge& gauge,
                                     const CollectOptions& options) {
  const bool all_timed = std::all_of(
      all.begin(), all.end(), [](const MarkerFrame& frame) { return frame.time_s.has_value(); });
  if (gauge.by_time && !all_timed)
    return Error{en::say("the recording's frames have no times, the gauge has only times"), "",
                 en::say("a recording of alltact record, or a gauge file with a column 'frame'")};
  const std::vector<MarkerFrame> frames = all_timed ? in_order(all) : all;
  Span of_gauge, of_frames;
  if (gauge.by_time && !frames.empty()) {
    of_gauge = span_of(gauge.readings, [](const GaugeReading& r) { return r.time_s; });
    of_frames = span_of(frames, [](const MarkerFrame& frame) { return *frame.time_s; });
    if (auto wrong = wrong_time_unit(gauge, of_gauge, of_frames)) return *wrong;
  }
  CollectedForce collected;
  collected.frames = frames.size();
  collected.remarks = gauge.remarks;
  collected.clock = estimate_gauge_clock(frames, gauge, options, collected.remarks);
  const GaugeLookup lookup(frames, gauge, collected.clock);
  std::vector<std::pair<const MarkerFrame*, GaugeReading>> rows;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const MarkerFrame& frame = frames[i];
    const bool any = seen_count(frame.markers) > 0;
    auto reading = any ? lookup(frame, i) : std::nullopt;
    if (reading && frame.markers.size() == frames.front().markers.size())
      rows.emplace_back(&frame, std::move(*reading));
    else
      ++collected.left_out;
  }
  if (rows.empty() && !frames.empty()) return no_reading(frames, gauge, collected.clock);
  if (gauge.by_time && 2 * rows.size() < frames.size())
    collected.remarks.push_back(en::say(
        "Most frames have no reading: {}. Try: checking the unit and the beginning of the gauge's "
        "times.",
        spans_of(of_gauge, of_frames)));
  collected.reading_sd_N = median_sd_N(rows);
  ForceTable& table = collected.table;
  const auto count = static_cast<Eigen::Index>(rows.size());
  table.marker_count = frames.empty() ? 0 : static_cast<int>(frames.front().markers.size());
  table.axes = gauge.axes;
  table.layouts = Eigen::MatrixXd::Zero(count, Eigen::Index{2} * table.marker_count);
  table.seen = Eigen::MatrixXd::Zero(count, table.marker_count);
  table.force_N = Eigen::MatrixXd::Zero(count, table.axes);
  table.position_mm = Eigen::MatrixXd::Constant(count, 2, std::numeric_limits<double>::quiet_NaN());
  if (all_timed) table.time_s = Eigen::VectorXd::Zero(count);
  for (Eigen::Index row = 0; row < count; ++row) {
    const auto& [frame, reading] = rows[static_cast<std::size_t>(row)];
    add_row(*frame, reading, gauge, row, table);
  }
  if (!table.position_mm.array().isFinite().any()) table.position_mm.resize(0, 0);
  if (gauge.by_time && !gauge.has_block) name_presses(table);
  // This table must meet the conditions of any table.
  auto checked = ForceTable::parse_part(table.to_csv(), "");
  if (!checked) {
    Error error = checked.error();
    return Error{error.what, en::say("{} of {} frames have a reading", count, frames.size()),
                 error.advice};
  }
  table = std::move(*checked);
  return collected;
}

// Reads the file of a force gauge.

namespace {

Message gauge_advice() {
  return en::say("a table whose head names t_s (or frame), and fx_n and fy_n or force_n");
}

/// Columns of a gauge's file, with names of gauges' own programs and those that people choose.
TableFormat gauge_format(const GaugeFileOptions& options) {
  using Names = std::vector<std::string_view>;
  const auto force = [&](const char* key, const Names& names, const Names& names_with_unit) {
    return TableColumnKind{.key = key,
                           .measure = Measure::kForce,
                           .names = names,
                           .names_with_unit = names_with_unit,
                           .unit = {options.unit_N, 1, ""}};
  };
  return {{{"t_s",
            Measure::kTime,
            {"time",      "zeit",        "timestamp",     "timestamps",   "zeitstempel",
             "datetime",  "dateandtime", "datetimestamp", "datumzeit",    "datumuhrzeit",
             "uhrzeit",   "elapsed",     "elapsedtime",   "timeelapsed",  "testtime",
             "runtime",   "reltime",     "relativetime",  "relativezeit", "messzeit",
             "laufzeit",  "sampletime",  "xvalue",        "epoch",        "unixtime",
             "posixtime", "temps",       "horodatage",    "tiempo",       "tempo",
             "zaman",     "süre",        "时间",          "时间戳",       "時間"}},
           {"date", {}, {"datum", "fecha", "data", "tarih", "日期"}},
           {"frame", {}, {"framename", "image", "imagename", "bild", "filename"}},
           force("fx_n",
                 {"forcex", "xforce", "forcefx", "forceinx", "loadx", "xload", "kraftx", "xkraft",
                  "kraftfx", "kraftinx", "effortx", "fuerzax", "forzax", "kuvvetx", "x力", "力x"},
                 {"x"}),
           force("fy_n",
                 {"forcey", "yforce", "forcefy", "forceiny", "loady", "yload", "krafty", "ykraft",
                  "kraftfy", "kraftiny", "efforty", "fuerzay", "forzay", "kuvvety", "y力", "力y"},
                 {"y"}),
           force("fz_n",
                 {"forcez", "zforce", "forcefz", "forceinz", "loadz", "zload", "kraftz", "zkraft",
                  "kraftfz", "kraftinz", "effortz", "fuerzaz", "forzaz", "kuvvetz", "z力", "力z"},
                 {"z"}),
           force("force_n",
                 {"f", "forcevalue", "load", "loadvalue", "kraft", "messkraft", "last", "effort",
                  "charge", "fuerza", "carga", "forza", "força", "kuvvet", "yük", "力", "力值",
                  "载荷", "荷重"},
                 {"reading", "value", "measurement", "messwert", "wert", "valeur", "channel1",
                  "ch1", "kanal1", "读数"}),
           {"sd_n", Measure::kForce},
           {"holds"},
           {"along_mm", Measure::kLength},
           {"across_mm", Measure::kLength},
           {"block"},
           {"day"},
           {"indenter"}},
          gauge_advice()};
}

/// An image's name as frames have it: without its folder and the extension of an image.
std::string frame_name(std::string_view text) {
  const std::size_t slash = text.find_last_of("/\\");
  if (slash != std::string_view::npos) text.remove_prefix(slash + 1);
  for (const std::string_view extension :
       {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".pgm"})
    if (text.ends_with(extension))
      return std::string(text.substr(0, text.size() - extension.size()));
  return std::string(text);
}

class GaugeReader {
 public:
  GaugeReader(Table table, const std::filesystem::path& origin, const GaugeFileOptions& options)
      : table_(std::move(table)), options_(options) {
    gauge_.origin = origin;
  }

  Result<ForceGauge> read() {
    if (const Status head = read_head(); !head) return head.error();
    for (auto more = table_.next();; more = table_.next()) {
      if (!more) return more.error();
      if (!*more) break;
      if (const Status row = read_row(); !row) return row.error();
    }
    const auto any = [&](auto has) {
      return std::any_of(gauge_.readings.begin(), gauge_.readings.end(), has);
    };
    gauge_.has_block = any([](const GaugeReading& one) { return !one.block.empty(); });
    gauge_.has_indenter = any([](const GaugeReading& one) { return !one.indenter.empty(); });
    if (!any([](const GaugeReading& one) { return one.has_force; }))
      return Error{en::say("the gauge's file holds no reading"), gauge_.origin, gauge_advice()};
    gauge_.understood = table_.understood();
    gauge_.remarks = table_.remarks();
    if (gauge_.by_time && !table_.has_time_stamps()) {
      const Table::Column& time = table_.columns()[static_cast<std::size_t>(time_)];
      gauge_.time_column = time.name;
      gauge_.time_unit_s = time.unit.value_or(MeasurementUnit()).convert(1);
    }
    return std::move(gauge_);
  }

 private:
  Status read_head() {
    for (const char* key : {"fx_n", "fy_n", "fz_n"}) force_.push_back(table_.find(key));
    if (const int single = table_.find("force_n"); single >= 0 && force_[0] < 0 && force_[1] < 0) {
      is_single_ = true;
      force_ = {single};
      table_.ignore("fz_n");
    } else {
      for (const std::size_t axis : {0U, 1U})
        if (force_[axis] < 0) return table_.missing(axis == 0 ? "fx_n" : "fy_n");
      if (force_[2] < 0) force_.pop_back();
      table_.ignore("force_n");
    }
    frame_ = table_.find("frame");
    time_ = table_.find("t_s"), date_ = table_.find("date");
    if (time_ < 0) time_ = std::exchange(date_, -1);
    if (frame_ < 0 && time_ < 0) return table_.missing("t_s");
    gauge_.by_time = frame_ < 0;
    if (!gauge_.by_time) table_.ignore("t_s"), table_.ignore("date");
    gauge_.axes = is_single_ ? 3 : static_cast<int>(force_.size());
    along_ = table_.find("along_mm"), across_ = table_.find("across_mm");
    if ((along_ < 0) != (across_ < 0))
      return table_.wrong_head(
          en::say("the contact position has only one of along_mm and across_mm"));
    sd_ = table_.find("sd_n"), holds_ = table_.find("holds");
    block_ = table_.find("block"), day_ = table_.find("day"), indenter_ = table_.find("indenter");
    gauge_.has_day = day_ >= 0;
    return {};
  }

  Status read_row() {
    GaugeReading reading;
    if (const Status force = read_force(reading); !force) return force;
    if (const Status key = gauge_.by_time ? read_time(reading) : read_frame(reading); !key)
      return key;
    if (!text(along_).empty() || !text(across_).empty()) {
      const auto along = table_.number(along_), across = table_.number(across_);
      if (!along) return along.error();
      if (!across) return across.error();
      reading.position_mm = Eigen::Vector2d(*along, *across);
    }
    if (!text(sd_).empty()) {
      const auto sd = table_.number(sd_);
      if (!sd) return sd.error();
      reading.sd_N = *sd;
    }
    reading.holds = text(holds_) == "1";
    if (!reading.holds && !text(holds_).empty() && text(holds_) != "0")
      return table_.wrong(en::say("'{}' is neither 1 nor 0", printable(text(holds_))), holds_);
    reading.block = text(block_), reading.day = text(day_), reading.indenter = text(indenter_);
    gauge_.readings.push_back(std::move(reading));
    return {};
  }

  Status read_time(GaugeReading& reading) {
    const auto time = table_.time_s(time_, date_);
    if (!time) return time.error();
    if (std::abs(*time) > kMaxTime_s) return beyond_range(time_);
    reading.time_s = *time;
    const std::string cell = printable(text(time_));
    if (!gauge_.readings.empty() && *time == gauge_.readings.back().time_s)
      return table_.wrong(en::say("the time '{}' is that of line {}, too", cell, last_line_),
                          time_);
    if (!gauge_.readings.empty() && *time < gauge_.readings.back().time_s)
      return table_.wrong(en::say("the time '{}' comes after '{}' of line {}, which is later", cell,
                                  last_time_, last_line_),
                          time_);
    last_line_ = table_.line(), last_time_ = cell;
    return {};
  }

  Status read_frame(GaugeReading& reading) {
    reading.frame = frame_name(text(frame_));
    if (reading.frame.empty())
      return table_.wrong(en::say("the name of the frame is missing"), frame_);
    const auto [same, is_new] = line_of_frame_.emplace(reading.frame, table_.line());
    if (is_new) return {};
    return table_.wrong(
        en::say("the frame '{}' is that of line {}, too", printable(text(frame_)), same->second),
        frame_);
  }

  /// Empty cells: no force from then on.
  Status read_force(GaugeReading& reading) {
    reading.has_force = std::any_of(force_.begin(), force_.end(),
                                    [&](int column) { return !text(column).empty(); });
    for (std::size_t i = 0; i < force_.size() && reading.has_force; ++i) {
      const auto force = table_.number(force_[i]);
      if (!force) return force.error();
      if (std::abs(*force) > kMaxForce_N) return beyond_range(force_[i]);
      if (is_single_)
        reading.force_N = *force * options_.direction;
      else
        reading.force_N[static_cast<Eigen::Index>(i)] = *force;
    }
    return {};
  }

  [[nodiscard]] std::string_view text(int column) const {
    return column < 0 ? std::string_view() : table_.text(column);
  }
  [[nodiscard]] Error beyond_range(int column) const {
    return table_.wrong(en::say("'{}' is beyond the measurable range", printable(text(column))),
                        column);
  }

  Table table_;
  GaugeFileOptions options_;
  bool is_single_ = false;  // one force along a direction
  std::vector<int> force_;  // columns
  int time_ = -1, date_ = -1, frame_ = -1, sd_ = -1, holds_ = -1, along_ = -1, across_ = -1;
  int block_ = -1, day_ = -1, indenter_ = -1;
  std::map<std::string, int> line_of_frame_;
  int last_line_ = 0;
  std::string last_time_;
  ForceGauge gauge_;
};

std::optional<Eigen::Vector3d> vector_from(const nlohmann::json& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  Eigen::Vector3d vector;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!json[i].is_number()) return std::nullopt;
    vector[static_cast<Eigen::Index>(i)] = json[i].get<double>();
  }
  return vector.allFinite() ? std::optional(vector) : std::nullopt;
}

/// Adds a contact's force to the reading. False: it has none, or not in the format of `simulate`.
bool add_contact(const nlohmann::json& contact, double& greatest_N, GaugeReading& reading) {
  if (!contact.is_object() || !contact.contains("force_N")) return false;
  const auto force = vector_from(contact.at("force_N"));
  if (!force) return false;
  reading.force_N += *force;
  const auto along = contact.find("along_mm"), across = contact.find("across_mm");
  if (force->norm() <= greatest_N || along == contact.end() || across == contact.end() ||
      !along->is_number() || !across->is_number())
    return true;
  greatest_N = force->norm();
  reading.position_mm = Eigen::Vector2d(along->get<double>(), across->get<double>());
  return true;
}

}  // namespace

Result<ForceGauge> ForceGauge::parse_csv(std::string_view csv, const std::filesystem::path& origin,
                                         const GaugeFileOptions& options) {
  auto table = Table::open(csv, origin, gauge_format(options));
  if (!table) return table.error();
  auto gauge = GaugeReader(std::move(*table), origin, options).read();
  if (gauge) gauge->is_on_frame_clock = csv.starts_with(kGaugeLogFormat);
  return gauge;
}

Result<ForceGauge> ForceGauge::parse_truth(std::string_view text,
                                           const std::filesystem::path& origin) {
  const auto wrong = [&](Message what) {
    return Error{std::move(what), origin,
                 en::say("truth.json of a scene whose pushes have forces")};
  };
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("frames") || !json.at("frames").is_array())
    return wrong(en::say("holds no frames of a simulation"));
  ForceGauge gauge;
  gauge.origin = origin;
  gauge.axes = 3;
  bool any_force = false;
  for (const nlohmann::json& frame : json.at("frames")) {
    if (!frame.is_object() || !frame.contains("frame") || !frame.at("frame").is_string())
      return wrong(en::say("holds a frame without a name"));
    GaugeReading reading;
    reading.frame = frame.at("frame").get<std::string>();
    double greatest_N = 0;
    bool is_complete = true;
    if (frame.contains("contacts") && frame.at("contacts").is_array())
      for (const nlohmann::json& contact : frame.at("contacts"))
        is_complete = add_contact(contact, greatest_N, reading) && is_complete;
    any_force = any_force || greatest_N > 0;
    if (is_complete) gauge.readings.push_back(std::move(reading));
  }
  if (!any_force) return wrong(en::say("contains no contact force"));
  return gauge;
}

Result<ForceGauge> ForceGauge::load(const std::filesystem::path& file,
                                    const GaugeFileOptions& options) {
  const auto content = read_file(file);
  if (!content) return content.error();
  return file.extension() == ".json" ? parse_truth(*content, file)
                                     : parse_csv(*content, file, options);
}

// Markers of a recording, measured now or read from the output of another command.

namespace {

/// nullopt: not in the format of `reconstruct` or `simulate`.
std::optional<Markers> markers_from(const nlohmann::json& list, const char* seen_key) {
  if (!list.is_array() || list.empty()) return std::nullopt;
  Markers markers;
  for (const nlohmann::json& entry : list) {
    if (!entry.is_object() || !entry.contains(seen_key) || !entry.at(seen_key).is_boolean())
      return std::nullopt;
    Marker marker;
    marker.seen = entry.at(seen_key).get<bool>();
    const auto u = entry.find("u"), v = entry.find("v");
    const bool has_position =
        u != entry.end() && v != entry.end() && u->is_number() && v->is_number();
    if (has_position) marker.u = u->get<double>(), marker.v = v->get<double>();
    marker.seen = marker.seen && has_position;
    markers.push_back(marker);
  }
  return markers;
}

std::optional<Eigen::Vector2d> region_position(const nlohmann::json& line) {
  const auto regions = line.find("regions");
  if (regions == line.end() || !regions->is_array() || regions->empty()) return std::nullopt;
  const nlohmann::json& region = regions->front();
  if (!region.is_object() || !region.contains("place_on_face_mm")) return std::nullopt;
  const nlohmann::json& position = region.at("place_on_face_mm");
  if (!position.is_array() || position.size() != 2 || !position[0].is_number() ||
      !position[1].is_number())
    return std::nullopt;
  return Eigen::Vector2d(position[0].get<double>(), position[1].get<double>());
}

/// Of results.jsonl: time_ns, where its source had times.
std::optional<double> capture_time_s(const nlohmann::json& line) {
  const auto time_ns = line.find("time_ns");
  if (time_ns == line.end() || !time_ns->is_number_integer()) return std::nullopt;
  return 1e-9 * static_cast<double>(time_ns->get<std::int64_t>());
}

/// Reads a line of results.jsonl or a frame of truth.json; ignores one without markers.
void take_markers(const nlohmann::json& line, const char* seen_key,
                  std::vector<MarkerFrame>& frames) {
  if (!line.is_object() || !line.contains("markers") || !line.contains("frame") ||
      !line.at("frame").is_string())
    return;
  auto markers = markers_from(line.at("markers"), seen_key);
  if (!markers) return;
  frames.push_back({line.at("frame").get<std::string>(), capture_time_s(line), std::move(*markers),
                    region_position(line)});
}

Result<std::vector<MarkerFrame>> frames_from_file(const std::filesystem::path& file) {
  const auto content = read_file(file);
  if (!content) return content.error();
  std::vector<MarkerFrame> frames;
  if (file.extension() == ".json") {
    const nlohmann::json truth = nlohmann::json::parse(*content, nullptr, false);
    if (truth.is_object() && truth.contains("frames") && truth.at("frames").is_array())
      for (const nlohmann::json& frame : truth.at("frames")) take_markers(frame, "visible", frames);
  } else {
    std::size_t begin = 0;
    while (begin < content->size()) {
      const std::size_t end = std::min(content->find('\n', begin), content->size());
      take_markers(nlohmann::json::parse(content->substr(begin, end - begin), nullptr, false),
                   "seen", frames);
      begin = end + 1;
    }
  }
  if (frames.empty())
    return Error{en::say("holds no frame with markers"), file,
                 en::say("results.jsonl of alltact reconstruct, or the recording itself")};
  return frames;
}

Result<std::vector<MarkerFrame>> measured_frames(const std::vector<std::filesystem::path>& inputs,
                                                 const FingerSnapshot& finger, const Job& job,
                                                 std::vector<Message>* remarks) {
  auto source = open_source(inputs);
  if (!source) return source.error();
  auto pipeline = Pipeline::create(finger, {}, job);
  if (!pipeline) return pipeline.error();
  const auto count = static_cast<double>((*source)->count().value_or(1000));
  std::vector<MarkerFrame> frames;
  for (std::size_t number = 0;; ++number) {
    if (job.stop_requested())
      return Error{en::say("stopped before all frames were measured"), "", ""};
    const auto frame = (*source)->next();
    if (!frame) return frame.error();
    if (*frame == nullptr) break;
    job.report(std::min(1.0, static_cast<double>(number) / count),
               en::say("measuring frame {}", number));
    auto result = (*pipeline)(*frame);
    if (!result) return result.error();
    if (!result->markers) continue;
    MarkerFrame one{(*frame)->name, std::nullopt, std::move(*result->markers), std::nullopt};
    one.time_s = time_s(**frame);
    if (!result->regions.empty()) one.position_mm = result->regions.front().position_on_face_mm;
    frames.push_back(std::move(one));
  }
  if (frames.empty())
    return Error{en::say("the markers were found in no frame"), inputs.front(),
                 en::say("alltact reconstruct, which reports why")};
  if (remarks != nullptr) *remarks = (*source)->remarks();
  return frames;
}

}  // namespace

Result<std::vector<MarkerFrame>> marker_frames(const std::vector<std::filesystem::path>& inputs,
                                               const FingerSnapshot& finger, const Job& job,
                                               std::vector<Message>* remarks) {
  if (inputs.size() == 1)
    if (const auto ending = inputs.front().extension(); ending == ".jsonl" || ending == ".json")
      return frames_from_file(inputs.front());
  return measured_frames(inputs, finger, job, remarks);
}

}  // namespace alltact
