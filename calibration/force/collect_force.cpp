#include "calibration/force/collect_force.h"

#include "core/io/atomic_file.h"
#include "core/sensing/pipeline.h"
#include "core/sources/open/open_source.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using MarkerJson = nlohmann::json;

/// nullopt: not as reconstruct and simulate write markers.
std::optional<Markers> markers_from(const MarkerJson& list, const char* seen_key) {
  if (!list.is_array() || list.empty()) return std::nullopt;
  Markers markers;
  for (const MarkerJson& entry : list) {
    if (!entry.is_object() || !entry.contains(seen_key) || !entry.at(seen_key).is_boolean())
      return std::nullopt;
    Marker marker;
    marker.seen = entry.at(seen_key).get<bool>();
    const auto u = entry.find("u"), v = entry.find("v");
    const bool has_place = u != entry.end() && v != entry.end() && u->is_number() && v->is_number();
    if (has_place) marker.u = u->get<double>(), marker.v = v->get<double>();
    marker.seen = marker.seen && has_place;
    markers.push_back(marker);
  }
  return markers;
}

std::optional<Eigen::Vector2d> region_place(const MarkerJson& line) {
  const auto regions = line.find("regions");
  if (regions == line.end() || !regions->is_array() || regions->empty()) return std::nullopt;
  const MarkerJson& region = regions->front();
  if (!region.is_object() || !region.contains("place_on_face_mm")) return std::nullopt;
  const MarkerJson& place = region.at("place_on_face_mm");
  if (!place.is_array() || place.size() != 2 || !place[0].is_number() || !place[1].is_number())
    return std::nullopt;
  return Eigen::Vector2d(place[0].get<double>(), place[1].get<double>());
}

/// A line of results.jsonl or a frame of truth.json; nothing of one without markers.
void take_markers(const MarkerJson& line, const char* seen_key, std::vector<MarkerFrame>& frames) {
  if (!line.is_object() || !line.contains("markers") || !line.contains("frame") ||
      !line.at("frame").is_string())
    return;
  auto markers = markers_from(line.at("markers"), seen_key);
  if (!markers) return;
  frames.push_back(
      {line.at("frame").get<std::string>(), std::nullopt, std::move(*markers), region_place(line)});
}

Result<std::vector<MarkerFrame>> frames_from_file(const std::filesystem::path& file) {
  const auto content = read_file(file);
  if (!content) return content.error();
  std::vector<MarkerFrame> frames;
  if (file.extension() == ".json") {
    const MarkerJson truth = MarkerJson::parse(*content, nullptr, false);
    if (truth.is_object() && truth.contains("frames") && truth.at("frames").is_array())
      for (const MarkerJson& frame : truth.at("frames")) take_markers(frame, "visible", frames);
  } else {
    std::size_t begin = 0;
    while (begin < content->size()) {
      const std::size_t end = std::min(content->find('\n', begin), content->size());
      take_markers(
          MarkerJson::parse(content->substr(begin, end - begin), nullptr, false), "seen", frames);
      begin = end + 1;
    }
  }
  if (frames.empty())
    return Error{en::say("holds no frame with markers"),
                 file,
                 en::say("results.jsonl of alltact reconstruct, or the recording itself")};
  return frames;
}

Result<std::vector<MarkerFrame>> measured_frames(const std::vector<std::filesystem::path>& inputs,
                                                 const FingerSnapshot& finger,
                                                 const Job& job) {
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
    if (!result->regions.empty()) one.place_mm = result->regions.front().place_on_face_mm;
    frames.push_back(std::move(one));
  }
  if (frames.empty())
    return Error{en::say("the markers were found in no frame"),
                 inputs.front(),
                 en::say("alltact reconstruct, which says why")};
  return frames;
}

/// The readings of a gauge, asked for by frame.
class GaugeLookup {
 public:
  GaugeLookup(const ForceGauge& gauge, double shift_s) : gauge_(gauge), shift_s_(shift_s) {
    for (const GaugeReading& reading : gauge.readings)
      if (!gauge.by_time) by_name_[reading.frame] = &reading;
  }

  [[nodiscard]] std::optional<GaugeReading> operator()(const MarkerFrame& frame) const {
    if (!gauge_.by_time) {
      const auto found = by_name_.find(frame.name);
      return found == by_name_.end() ? std::nullopt : std::optional(*found->second);
    }
    if (!frame.time_s) return std::nullopt;
    const double time_s = *frame.time_s + shift_s_;
    const auto after =
        std::lower_bound(gauge_.readings.begin(),
                         gauge_.readings.end(),
                         time_s,
                         [](const GaugeReading& r, double t) { return r.time_s < t; });
    if (after == gauge_.readings.end()) return std::nullopt;
    if (after->time_s == time_s) return *after;
    if (after == gauge_.readings.begin()) return std::nullopt;
    const GaugeReading &one = *(after - 1), &two = *after;
    const double gap_s = two.time_s - one.time_s;
    if (gap_s > kLongestGaugeGapS || one.block != two.block) return std::nullopt;
    const double part = (time_s - one.time_s) / gap_s;
    GaugeReading between = part < 0.5 ? one : two;
    between.force_N = (1 - part) * one.force_N + part * two.force_N;
    return between;
  }

 private:
  const ForceGauge& gauge_;
  double shift_s_;
  std::map<std::string, const GaugeReading*> by_name_;
};

/// Added to a frame's time it is the gauge's.
double clock_shift_s(const std::vector<MarkerFrame>& frames,
                     const ForceGauge& gauge,
                     std::vector<Message>& remarks) {
  if (!gauge.by_time) return 0;
  std::optional<double> first_s;
  for (const MarkerFrame& frame : frames) {
    if (!frame.time_s) continue;
    if (!first_s) first_s = frame.time_s;
    if (*frame.time_s >= gauge.readings.front().time_s &&
        *frame.time_s <= gauge.readings.back().time_s)
      return 0;
  }
  if (!first_s) return 0;
  remarks.push_back(
      en::say("The gauge and the camera were on different clocks: their beginnings are taken for "
              "one moment."));
  return gauge.readings.front().time_s - *first_s;
}

void add_row(const MarkerFrame& frame,
             const GaugeReading& reading,
             const ForceGauge& gauge,
             Eigen::Index row,
             ForceTable& table) {
  for (Eigen::Index m = 0; m < table.marker_count; ++m) {
    const Marker& marker = frame.markers[static_cast<std::size_t>(m)];
    table.seen(row, m) = marker.seen ? 1 : 0;
    table.layouts(row, 2 * m) = marker.seen ? marker.u : 0;
    table.layouts(row, 2 * m + 1) = marker.seen ? marker.v : 0;
  }
  table.force_N.row(row) = reading.force_N.head(table.axes).transpose();
  // What the pipeline will tell when it measures counts before what was set up.
  const auto& place = frame.place_mm ? frame.place_mm : reading.place_mm;
  if (place) table.place_mm.row(row) = place->transpose();
  if (gauge.has_block) table.block.push_back(reading.block);
  if (gauge.has_day) table.day.push_back(reading.day);
  if (gauge.has_indenter) table.indenter.push_back(reading.indenter);
  table.frame.push_back(frame.name);
  if (table.time_s.size() > 0) table.time_s[row] = *frame.time_s;
}

}  // namespace

Result<std::vector<MarkerFrame>> marker_frames(const std::vector<std::filesystem::path>& inputs,
                                               const FingerSnapshot& finger,
                                               const Job& job) {
  if (inputs.size() == 1)
    if (const auto ending = inputs.front().extension(); ending == ".jsonl" || ending == ".json")
      return frames_from_file(inputs.front());
  return measured_frames(inputs, finger, job);
}

Result<CollectedForce> collect_force(const std::vector<MarkerFrame>& frames,
                                     const ForceGauge& gauge) {
  const bool all_timed = std::all_of(frames.begin(), frames.end(), [](const MarkerFrame& frame) {
    return frame.time_s.has_value();
  });
  if (gauge.by_time && !all_timed)
    return Error{en::say("the recording's frames have no times, the gauge has nothing but times"),
                 "",
                 en::say("a recording of alltact record, or a gauge file with a column 'frame'")};
  CollectedForce collected;
  collected.frames = frames.size();
  const GaugeLookup lookup(gauge, clock_shift_s(frames, gauge, collected.remarks));
  std::vector<std::pair<const MarkerFrame*, GaugeReading>> rows;
  for (const MarkerFrame& frame : frames) {
    const bool any = std::any_of(
        frame.markers.begin(), frame.markers.end(), [](const Marker& m) { return m.seen; });
    auto reading = any ? lookup(frame) : std::nullopt;
    if (reading && frame.markers.size() == frames.front().markers.size())
      rows.emplace_back(&frame, std::move(*reading));
    else
      ++collected.left_out;
  }
  ForceTable& table = collected.table;
  const auto count = static_cast<Eigen::Index>(rows.size());
  table.marker_count = frames.empty() ? 0 : static_cast<int>(frames.front().markers.size());
  table.axes = gauge.axes;
  table.layouts = Eigen::MatrixXd::Zero(count, 2 * table.marker_count);
  table.seen = Eigen::MatrixXd::Zero(count, table.marker_count);
  table.force_N = Eigen::MatrixXd::Zero(count, table.axes);
  table.place_mm = Eigen::MatrixXd::Constant(count, 2, std::numeric_limits<double>::quiet_NaN());
  if (all_timed) table.time_s = Eigen::VectorXd::Zero(count);
  for (Eigen::Index row = 0; row < count; ++row) {
    const auto& [frame, reading] = rows[static_cast<std::size_t>(row)];
    add_row(*frame, reading, gauge, row, table);
  }
  if (!table.place_mm.array().isFinite().any()) table.place_mm.resize(0, 0);
  // Whatever a table must be, this one must be too.
  auto checked = ForceTable::parse(table.to_csv(), "");
  if (!checked) {
    Error error = checked.error();
    return Error{
        error.what, en::say("{} of {} frames have a reading", count, frames.size()), error.advice};
  }
  table = std::move(*checked);
  return collected;
}

}  // namespace alltact
