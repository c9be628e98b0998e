// Markers of a recording, measured now or read from the output of another command.
#include "calibration/force/collect_force.h"
#include "core/io/atomic_file.h"
#include "core/sensing/pipeline.h"
#include "core/sources/open/open_source.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using MarkerJson = nlohmann::json;

/// nullopt: not in the format of `reconstruct` or `simulate`.
std::optional<Markers> markers_from(const MarkerJson& list, const char* seen_key) {
  if (!list.is_array() || list.empty()) return std::nullopt;
  Markers markers;
  for (const MarkerJson& entry : list) {
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

std::optional<Eigen::Vector2d> region_position(const MarkerJson& line) {
  const auto regions = line.find("regions");
  if (regions == line.end() || !regions->is_array() || regions->empty()) return std::nullopt;
  const MarkerJson& region = regions->front();
  if (!region.is_object() || !region.contains("place_on_face_mm")) return std::nullopt;
  const MarkerJson& position = region.at("place_on_face_mm");
  if (!position.is_array() || position.size() != 2 || !position[0].is_number() ||
      !position[1].is_number())
    return std::nullopt;
  return Eigen::Vector2d(position[0].get<double>(), position[1].get<double>());
}

/// Of results.jsonl: time_ns, where its source had times.
std::optional<double> capture_time_s(const MarkerJson& line) {
  const auto time_ns = line.find("time_ns");
  if (time_ns == line.end() || !time_ns->is_number_integer()) return std::nullopt;
  return 1e-9 * static_cast<double>(time_ns->get<std::int64_t>());
}

/// Reads a line of results.jsonl or a frame of truth.json; ignores one without markers.
void take_markers(const MarkerJson& line, const char* seen_key, std::vector<MarkerFrame>& frames) {
  if (!line.is_object() || !line.contains("markers") || !line.contains("frame") ||
      !line.at("frame").is_string())
    return;
  auto markers = markers_from(line.at("markers"), seen_key);
  if (!markers) return;
  frames.push_back({line.at("frame").get<std::string>(),
                    capture_time_s(line),
                    std::move(*markers),
                    region_position(line)});
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
    if (!result->regions.empty()) one.position_mm = result->regions.front().position_on_face_mm;
    frames.push_back(std::move(one));
  }
  if (frames.empty())
    return Error{en::say("the markers were found in no frame"),
                 inputs.front(),
                 en::say("alltact reconstruct, which says why")};
  return frames;
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

}  // namespace alltact
