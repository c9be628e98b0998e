#include "core/sensing/result_json.h"

#include "core/sensing/frame_result.h"

#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;

/// Rounds to the decimals that the figure supports, so that lines stay readable.
double to_decimals(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  const double result = std::round(value * scale) / scale;
  return result == 0.0 ? 0.0 : result;  // no -0
}

void put(Json& object, const char* key, double value, int decimals) {
  if (std::isfinite(value)) object[key] = to_decimals(value, decimals);
}

void put(Json& object, const char* key, const std::optional<double>& value, int decimals) {
  if (value) put(object, key, *value, decimals);
}

template <class Vector>
void put_vector(Json& object, const char* key, const Vector& vector, int decimals) {
  if (!vector.allFinite()) return;
  Json array = Json::array();
  for (double value : vector) array.push_back(to_decimals(value, decimals));
  object[key] = std::move(array);
}

Json markers_json(const Markers& markers) {
  Json array = Json::array();
  for (const Marker& marker : markers) {
    Json entry = Json::object();
    put(entry, "u", marker.u, 4);
    put(entry, "v", marker.v, 4);
    entry["seen"] = marker.seen;
    array.push_back(std::move(entry));
  }
  return array;
}

Json reference_json(const Reference& reference, bool searched, ReferenceMethod method) {
  Json entry = Json::object();
  if (!searched) {  // the single image of a flat sensor
    entry["method"] = "single";
    return entry;
  }
  constexpr std::array kWords{"single", "nearest", "local"};
  entry["method"] = kWords[static_cast<std::size_t>(method) - 1];
  entry["frame"] = reference.frame;
  put(entry, "distance_px", reference.distance_px, 3);
  entry["known_pose"] = reference.known_pose;
  if (reference.by_shape) entry["by_shape"] = true;
  return entry;
}

Json push_json(const Push& push) {
  Json entry = Json::object();
  entry["touched"] = push.direction.has_value();
  put_vector(entry, "offset_px", push.offset_px, 3);
  if (push.direction) put_vector(entry, "direction", *push.direction, 5);
  put(entry, "sd_deg", push.sd_deg, 2);
  if (push.face) entry["face"] = to_string(*push.face);
  return entry;
}

Json contact_json(const FingerContact& contact) {
  Json entry = Json::object();
  entry["face"] = to_string(contact.face);
  if (contact.direction) put_vector(entry, "direction", *contact.direction, 5);
  put(entry, "direction_sd_deg", contact.direction_sd_deg, 2);
  if (const auto& position = contact.position) {
    put(entry, "along_mm", position->along_mm, 3);
    put(entry, "along_sd_mm", position->along_sd_mm, 4);
    put(entry, "across_mm", position->across_mm, 3);
    put(entry, "across_sd_mm", position->across_sd_mm, 4);
    put(entry, "depth_mm", position->depth_mm, 4);
    put(entry, "depth_sd_mm", position->depth_sd_mm, 4);
    if (position->limits != kNoLimit) entry["limits"] = limit_names(position->limits);
  }
  if (!contact.no_position.empty()) entry["no_place"] = contact.no_position.english();
  entry["new"] = contact.is_new;
  put(entry, "held_s", contact.held_s, 3);
  if (contact.is_slipping) entry["slipping"] = *contact.is_slipping;
  return entry;
}

/// xx, xy, xz, yy, yz, zz.
Eigen::Vector<double, 6> upper_triangle(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

/// Standard deviation of the face's z, sampled from its first column to its last.
Json face_json(const FaceShape& shape) {
  constexpr int kSamples = 9;
  std::vector<int> valid;
  for (int u = 0; u < shape.width_px(); ++u)
    if (shape.columns()[static_cast<std::size_t>(u)].valid) valid.push_back(u);
  Json entry = Json::object();
  if (valid.empty()) return entry;
  entry["u"] = Json::array(), entry["z_sd_mm"] = Json::array();
  for (std::size_t k = 0; k < kSamples; ++k) {
    const int u = valid[k * (valid.size() - 1) / (kSamples - 1)];
    entry["u"].push_back(u);
    entry["z_sd_mm"].push_back(
        to_decimals(shape.columns()[static_cast<std::size_t>(u)].z_sd_mm, 5));
  }
  return entry;
}

Json regions_json(const std::vector<ContactRegion>& regions) {
  Json array = Json::array();
  for (const ContactRegion& region : regions) {
    Json entry = Json::object();
    put_vector(entry, "place_mm", region.position_mm, 4);
    put_vector(entry, "place_on_face_mm", region.position_on_face_mm, 3);
    put(entry, "deepest_mm", region.deepest_mm, 4);
    put(entry, "deepest_sd_mm", region.deepest_sd_mm, 4);
    if (region.limits != kNoLimit) entry["limits"] = limit_names(region.limits);
    put(entry, "area_mm2", region.area_mm2, 3);
    put(entry, "volume_mm3", region.volume_mm3, 4);
    put(entry, "angle_deg", region.angle_deg, 2);
    put(entry, "angle_sd_deg", region.angle_sd_deg, 2);
    if (region.axis) put_vector(entry, "axis", *region.axis, 6);
    if (region.normal) put_vector(entry, "normal", *region.normal, 6);
    if (const auto& c = region.position_covariance_mm2)
      put_vector(entry, "place_covariance_mm2", upper_triangle(*c), 9);
    if (!region.polygon_mm.empty()) {
      Json corners = Json::array();
      for (const Eigen::Vector2d& corner : region.polygon_mm)
        corners.push_back({to_decimals(corner.x(), 3), to_decimals(corner.y(), 3)});
      entry["polygon_mm"] = std::move(corners);
    }
    array.push_back(std::move(entry));
  }
  return array;
}

/// Fractions of the face by the validity of their depth. Zero fractions are left out.
Json validity_json(const cv::Mat& flags) {
  static constexpr std::array<const char*, kPixelFlagCount> kNames{
      "measured",     "off_face",     "too_dark",   "saturated",  "extrapolated",
      "beyond_layer", "no_reference", "hidden_end", "bulge_limit"};
  const FlagFractions shares = flag_fractions(flags);
  Json entry = Json::object();
  for (std::size_t k = 0; k < kNames.size(); ++k)
    if (shares.of[k] > 0) put(entry, kNames[k], shares.of[k], 5);
  return entry;
}

Json english(const std::vector<Message>& messages) {
  Json array = Json::array();
  for (const Message& message : messages) array.push_back(message.english());
  return array;
}

Json force_json(const Force& force) {
  Json entry = Json::object();
  static constexpr std::array<const char*, 3> kAxes{"fx_n", "fy_n", "fz_n"};
  for (int axis = 0; axis < force.axes; ++axis)
    put(entry, kAxes[static_cast<std::size_t>(axis)], force.force_N[axis], 4);
  put_vector(entry, "sd_n", force.sd_N.head(force.axes), 4);
  put_vector(entry, "half_95_n", force.half_95_N.head(force.axes), 4);
  entry["in_range"] = force.in_range;
  return entry;
}

/// Only steps that ran have a time.
Json times_json(const FrameResult& result) {
  const StepTimes& times = result.times_ms;
  Json entry = Json::object();
  put(entry, "prepare", times.prepare, 3);
  if (result.edges) {
    put(entry, "edges", times.edges, 3);
    put(entry, "global", times.global, 3);
  }
  if (result.markers) put(entry, "markers", times.markers, 3);
  if (result.reference) put(entry, "reference", times.reference, 3);
  if (result.difference || result.depth) put(entry, "local", times.local, 3);
  if (result.reference) put(entry, "contact", times.contact, 3);
  if (result.force) put(entry, "force", times.force, 3);
  put(entry, "total", times.total, 3);
  return entry;
}

}  // namespace

std::string result_line(const FrameResult& result, std::size_t index, ReferenceMethod method) {
  Json line;
  line["frame"] = result.frame->name;
  line["index"] = index;
  if (result.frame->time_ns) line["time_ns"] = *result.frame->time_ns;
  if (result.reduced_by != 1) {
    line["reduced_by"] = result.reduced_by;
    line["size_px"] = {result.grey.cols, result.grey.rows};
  }
  if (result.depth && result.shape) line["face"] = face_json(*result.shape);
  if (result.markers) line["markers"] = markers_json(*result.markers);
  if (result.markers && result.marker_method != MarkerMethod::kBlobs)
    line["marker_method"] = to_string(result.marker_method);
  if (result.reference)
    line["reference"] = reference_json(*result.reference, result.markers.has_value(), method);
  if (result.push) line["contact"] = push_json(*result.push);
  if (result.contact) line["finger_contact"] = contact_json(*result.contact);
  if (result.depth && !result.depth->flags.empty())
    line["validity"] = validity_json(result.depth->flags);
  if (result.depth) line["regions"] = regions_json(result.regions);
  if (result.force) line["force"] = force_json(*result.force);
  line["times_ms"] = times_json(result);
  if (!result.problems.empty()) line["problems"] = english(result.problems);
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string failure_line(const std::string& frame, std::size_t index,
                         const std::vector<Message>& problems) {
  Json line;
  line["frame"] = frame;
  line["index"] = index;
  line["problems"] = english(problems);
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string frame_name(const Error& error, std::size_t index) {
  const std::string stem = std::filesystem::path(error.where.english()).stem().string();
  return stem.empty() ? fmt::format("frame_{:05}", index) : stem;
}

Message as_sentence(const Error& error) { return en::say("{}.", error.message()); }

std::string with_contact(const std::string& line, const FingerContact& contact) {
  // Inserts before the first of the keys that result_line() writes after it.
  std::size_t at = std::string::npos;
  for (const char* key : {",\"validity\":", ",\"regions\":", ",\"force\":", ",\"times_ms\":"})
    if (at = line.find(key); at != std::string::npos) break;
  assert(at != std::string::npos);
  return line.substr(0, at) + ",\"finger_contact\":" +
         contact_json(contact).dump(-1, ' ', false, Json::error_handler_t::replace) +
         line.substr(at);
}

}  // namespace alltact
