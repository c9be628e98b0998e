#include "calibration/study/scaling_study.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

std::string megabytes(const std::optional<std::size_t>& bytes) {
  return bytes ? fmt::format("{:.2f}", static_cast<double>(*bytes) / 1e6) : "-";
}

}  // namespace

std::string text_of(const ScalingStudy& study) {
  std::string text =
      fmt::format("{}. Processor time; exponents over the upper half of the sizes.\n", study.about);
  for (const ScalingCurve& curve : study.curves) {
    text += fmt::format("{}, by {}", curve.what, curve.of);
    if (curve.exponent) text += fmt::format(": grows with its power {:.2f}", *curve.exponent);
    text += fmt::format("\n{:>12} {:>14} {:>14} {:>12}\n", "size", "ms", "us a piece", "MB");
    for (const ScalingPoint& point : curve.points)
      text += fmt::format("{:>12.0f} {:>14.4f} {:>14.4f} {:>12}\n",
                          point.size,
                          point.time_ms,
                          1000 * point.time_ms / point.size,
                          megabytes(point.memory_bytes));
    if (!curve.note.empty()) text += fmt::format("  ({})\n", curve.note);
  }
  return text;
}

std::string csv_of(const ScalingStudy& study) {
  std::string csv = "what,size,time_ms,memory_bytes,exponent\n";
  for (const ScalingCurve& curve : study.curves)
    for (const ScalingPoint& point : curve.points)
      csv += fmt::format("{},{},{},{},{}\n",
                         curve.key,
                         point.size,
                         point.time_ms,
                         point.memory_bytes ? fmt::format("{}", *point.memory_bytes) : "",
                         curve.exponent ? fmt::format("{}", *curve.exponent) : "");
  return csv;
}

nlohmann::json json_of(const ScalingStudy& study) {
  nlohmann::json json{{"about", study.about.english()}, {"curves", nlohmann::json::array()}};
  for (const ScalingCurve& curve : study.curves) {
    nlohmann::json entry{{"key", curve.key},
                         {"what", curve.what.english()},
                         {"of", curve.of.english()},
                         {"note", curve.note.english()},
                         {"points", nlohmann::json::array()}};
    if (curve.exponent) entry["exponent"] = *curve.exponent;
    for (const ScalingPoint& point : curve.points) {
      nlohmann::json point_json{{"size", point.size}, {"time_ms", point.time_ms}};
      if (point.memory_bytes) point_json["memory_bytes"] = *point.memory_bytes;
      entry["points"].push_back(std::move(point_json));
    }
    json["curves"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace alltact
