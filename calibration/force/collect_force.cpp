#include "calibration/force/collect_force.h"

#include "calibration/force/force_table.h"
#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/devices/gauge_log.h"
#include "core/devices/gauge_source.h"
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
  CollectedForce collected;
  collected.frames = frames.size();
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
  return en::say("a CSV whose first line names t_s (or frame), fx_n and fy_n");
}

Error wrong_gauge(Message what, const std::filesystem::path& origin, int line) {
  return {std::move(what), en::say("{}, line {}", origin, line), gauge_advice()};
}

/// Indices of the gauge's columns; -1: missing.
struct GaugeColumns {
  std::map<std::string, int> at;
  std::array<double, 3> unit_N{1, 1, 1};
  bool is_single = false;  ///< one force along a direction
  double time_unit_s = 1;
  [[nodiscard]] int operator[](const char* name) const {
    const auto found = at.find(name);
    return found == at.end() ? -1 : found->second;
  }
};

/// Parses "fx_kgf", "Fx [kgf]", "force (g)": the name before the unit, and newtons per unit;
/// without a unit, `unit_N`. nullopt: no column of forces.
std::optional<std::pair<std::string, double>> force_column(std::string_view cell, double unit_N) {
  const std::size_t end = std::min(cell.find_first_of(" _([/"), cell.size());
  std::string name;
  for (const char c : cell.substr(0, end))
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (name == "force" || name == "load") name = "f";
  if (name != "f" && name != "fx" && name != "fy" && name != "fz") return std::nullopt;
  std::string unit;
  for (const char c : cell.substr(end))
    if (std::string_view(" _()[]/").find(c) == std::string_view::npos) unit += c;
  if (unit.empty()) return std::pair{name, unit_N};
  const auto newtons = newtons_in(unit);
  return newtons ? std::optional(std::pair{name, *newtons}) : std::nullopt;
}

/// Seconds in the unit of a column "t", "t_ms", "time_ns"; nullopt: no column of times.
std::optional<double> time_column(std::string_view cell) {
  std::string name;
  for (const char c : cell)
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == ' ' ? '_' : c;
  for (const char* word : {"time", "t"}) {
    if (!name.starts_with(word)) continue;
    const std::string unit = name.substr(std::string_view(word).size());
    if (unit.empty() || unit == "_s" || unit == "_(s)" || unit == "_[s]") return 1.0;
    if (unit == "_ms" || unit == "_(ms)") return 1e-3;
    if (unit == "_us") return 1e-6;
    if (unit == "_ns") return 1e-9;
  }
  return std::nullopt;
}

class GaugeReader {
 public:
  GaugeReader(std::string_view csv, const std::filesystem::path& origin,
              const GaugeFileOptions& options)
      : lines_(csv), origin_(origin), options_(options) {
    gauge_.is_on_frame_clock = csv.starts_with(kGaugeLogFormat);
  }

  Result<ForceGauge> read() {
    if (Status head = read_head(); !head) return head.error();
    while (const auto line = next_line())
      if (Status status = read_line(lines_.cells(*line)); !status) return status.error();
    const auto any = [&](auto has) {
      return std::any_of(gauge_.readings.begin(), gauge_.readings.end(), has);
    };
    gauge_.has_block = any([](const GaugeReading& one) { return !one.block.empty(); });
    gauge_.has_indenter = any([](const GaugeReading& one) { return !one.indenter.empty(); });
    if (!any([](const GaugeReading& one) { return one.has_force; }))
      return Error{en::say("the gauge's file holds no reading"), origin_, gauge_advice()};
    return std::move(gauge_);
  }

 private:
  [[nodiscard]] Error wrong(Message what) const {
    return wrong_gauge(std::move(what), origin_, lines_.number());
  }

  std::optional<std::string_view> next_line() {
    auto line = lines_.next();
    while (line && line->starts_with('#')) line = lines_.next();
    return line;
  }

  Status read_head() {
    const auto line = next_line();
    if (!line) return Error{en::say("the gauge's file is empty"), origin_, gauge_advice()};
    for (const std::string_view cell : lines_.cells(*line)) {
      std::string name = csv_column(cell);
      if (const auto time = time_column(cell)) {
        name = "t";
        columns_.time_unit_s = *time;
      } else if (const auto force = force_column(cell, options_.unit_N)) {
        name = force->first;
        columns_.unit_N[name == "fy" ? 1 : name == "fz" ? 2 : 0] = force->second;
      } else if (name == "fx" || name == "fy" || name == "fz" || name == "f") {
        return wrong(en::say("the column '{}' has no unit of force", printable(cell)));
      }
      if (!columns_.at.emplace(name, static_cast<int>(count_++)).second)
        return wrong(en::say("the column '{}' appears twice", printable(cell)));
    }
    columns_.is_single = columns_["f"] >= 0 && columns_["fx"] < 0 && columns_["fy"] < 0;
    for (const char* axis : {"fx", "fy"})
      if (columns_[axis] < 0 && !columns_.is_single)
        return wrong(en::say("the column '{}' is missing", std::string(axis) + "_n"));
    gauge_.axes = columns_["fz"] >= 0 || columns_.is_single ? 3 : 2;
    gauge_.by_time = columns_["t"] >= 0 && columns_["frame"] < 0;
    if (columns_["t"] < 0 && columns_["frame"] < 0)
      return wrong(en::say("there is neither a column 't_s' nor a column 'frame'"));
    if ((columns_["along"] < 0) != (columns_["across"] < 0))
      return wrong(en::say("the contact position has only one of along_mm and across_mm"));
    gauge_.has_block = columns_["block"] >= 0, gauge_.has_day = columns_["day"] >= 0;
    gauge_.has_indenter = columns_["indenter"] >= 0;
    return {};
  }

  Status read_line(const std::vector<std::string_view>& cells) {
    if (cells.size() != count_) return wrong(en::say("has {} cells, not {}", cells.size(), count_));
    const auto cell = [&](const char* name) {
      return columns_[name] < 0 ? std::string_view()
                                : cells[static_cast<std::size_t>(columns_[name])];
    };
    GaugeReading reading;
    if (Status status = read_force(cells, reading); !status) return status;
    if (gauge_.by_time) {
      const auto time = lines_.number_in(cell("t"));
      if (!time) return wrong(en::say("'{}' is not a time", printable(cell("t"))));
      reading.time_s = *time * columns_.time_unit_s;
      if (!gauge_.readings.empty() && reading.time_s <= gauge_.readings.back().time_s)
        return wrong(
            en::say("{} s comes after {} s", reading.time_s, gauge_.readings.back().time_s));
    }
    if (!cell("along").empty() || !cell("across").empty()) {
      const auto along = lines_.number_in(cell("along")), across = lines_.number_in(cell("across"));
      if (!along || !across) return wrong(en::say("the contact position is not a pair of numbers"));
      reading.position_mm = Eigen::Vector2d(*along, *across);
    }
    reading.frame = cell("frame"), reading.block = cell("block"), reading.day = cell("day");
    reading.indenter = cell("indenter");
    gauge_.readings.push_back(std::move(reading));
    return {};
  }

  /// Empty cells: no force from then on.
  Status read_force(const std::vector<std::string_view>& cells, GaugeReading& reading) {
    static constexpr std::array<const char*, 3> kAxes{"fx", "fy", "fz"};
    const auto cell = [&](const char* name) {
      return cells[static_cast<std::size_t>(columns_[name])];
    };
    const auto number = [&](const char* name, double unit_N) -> Result<double> {
      const auto force = lines_.number_in(cell(name));
      if (!force || std::abs(*force * unit_N) > 1e5)
        return wrong(en::say("'{}' is not a force", printable(cell(name))));
      return *force * unit_N;
    };
    const int values = columns_.is_single ? 1 : gauge_.axes;
    const auto name_of = [&](int value) {
      return columns_.is_single ? "f" : kAxes[static_cast<std::size_t>(value)];
    };
    int empty = 0;
    for (int value = 0; value < values; ++value) empty += cell(name_of(value)).empty() ? 1 : 0;
    reading.has_force = empty < values;
    for (int value = 0; value < values && reading.has_force; ++value) {
      const auto force = number(name_of(value), columns_.unit_N[static_cast<std::size_t>(value)]);
      if (!force) return force.error();
      if (columns_.is_single)
        reading.force_N = *force * options_.direction;
      else
        reading.force_N[value] = *force;
    }
    if (columns_["sd"] >= 0)
      reading.sd_N =
          lines_.number_in(cell("sd")).value_or(std::numeric_limits<double>::quiet_NaN());
    reading.holds = columns_["holds"] >= 0 && cell("holds") == "1";
    return {};
  }

  CsvLines lines_;
  std::filesystem::path origin_;
  GaugeFileOptions options_;
  GaugeColumns columns_;
  std::size_t count_ = 0;
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
  return GaugeReader(csv, origin, options).read();
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
                                                 const FingerSnapshot& finger, const Job& job) {
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
    if ((*frame)->time_ns != 0) one.time_s = 1e-9 * static_cast<double>((*frame)->time_ns);
    if (!result->regions.empty()) one.position_mm = result->regions.front().position_on_face_mm;
    frames.push_back(std::move(one));
  }
  if (frames.empty())
    return Error{en::say("the markers were found in no frame"), inputs.front(),
                 en::say("alltact reconstruct, which reports why")};
  return frames;
}

}  // namespace

Result<std::vector<MarkerFrame>> marker_frames(const std::vector<std::filesystem::path>& inputs,
                                               const FingerSnapshot& finger, const Job& job) {
  if (inputs.size() == 1)
    if (const auto ending = inputs.front().extension(); ending == ".jsonl" || ending == ".json")
      return frames_from_file(inputs.front());
  return measured_frames(inputs, finger, job);
}

}  // namespace alltact
