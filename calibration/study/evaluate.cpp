#include "calibration/study/evaluate.h"

#include "core/base/atomic_file.h"
#include "core/finger/finger.h"
#include "core/image/image_file.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  return upper_median(values);
}

Truth::Dot dot_of(const Json& json) { return {json.at("u"), json.at("v"), json.at("visible")}; }

Markers markers_of(const Json& line) {
  Markers markers;
  if (!line.contains("markers")) return markers;
  for (const Json& entry : line.at("markers"))
    markers.push_back({entry.at("u"), entry.at("v"), entry.at("seen"), 0.0});
  return markers;
}

Status add_frame(const Json& entry, const Json& line, const fs::path& truths,
                 const fs::path& results, Evaluator& evaluator) {
  const std::string name = entry.at("frame");
  auto depth = read_float_image(truths / (name + ".depth.tiff"));
  if (!depth) return depth.error();
  auto z = read_float_image(truths / (name + ".z.tiff"));
  if (!z) return z.error();
  const auto our_depth = read_float_image(results / (name + ".depth.tiff"));
  if (!our_depth) return our_depth.error();
  const auto our_points = read_float_image(results / (name + ".points.tiff"));
  if (!our_points) return our_points.error();
  if (our_depth->size() != depth->size() || our_points->size() != depth->size() ||
      z->size() != depth->size())
    return Error{en::say("results and ground truth differ in size"), (results / name).string(), ""};
  Truth truth;
  truth.depth_mm = std::move(depth).value();
  truth.untouched_z_mm = std::move(z).value();
  if (entry.contains("markers"))
    for (const Json& marker : entry.at("markers")) truth.markers.push_back(dot_of(marker));
  evaluator.add(truth, *our_depth, *our_points, markers_of(line));
  if (line.contains("times_ms")) evaluator.add_time(line.at("times_ms").at("total"));
  return {};
}

/// Lines of results.jsonl by frame name.
std::map<std::string, Json> lines_by_name(const std::string& text) {
  std::map<std::string, Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    Json json = Json::parse(line);
    const std::string name = json.at("frame");
    lines.emplace(name, std::move(json));
  }
  return lines;
}

}  // namespace

void Evaluator::add(const Truth& truth, const cv::Mat& depth_mm, const cv::Mat& points_mm,
                    const Markers& markers) {
  ++evaluation_.frames;
  add_depth(truth, depth_mm);
  add_position(truth, depth_mm, points_mm);
  add_markers(truth, markers);
}

void Evaluator::add_depth(const Truth& truth, const cv::Mat& depth_mm) {
  cv::Mat contact_free;  // 0 on contact, as distanceTransform expects
  contact_free.create(truth.depth_mm.size(), CV_8UC1);
  for (int v = 0; v < contact_free.rows; ++v)
    for (int u = 0; u < contact_free.cols; ++u)
      contact_free.at<std::uint8_t>(v, u) =
          std::abs(truth.depth_mm.at<float>(v, u)) >= kUntouchedMm ? 0 : 1;
  cv::Mat distance_px;
  cv::distanceTransform(contact_free, distance_px, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  for (int v = 0; v < contact_free.rows; ++v) {
    for (int u = 0; u < contact_free.cols; ++u) {
      const float truly = truth.depth_mm.at<float>(v, u);
      const float z = truth.untouched_z_mm.at<float>(v, u);
      const float estimated = depth_mm.at<float>(v, u);
      if (!std::isfinite(truly) || !std::isfinite(z)) continue;
      if (truly > kPressedMm) {
        covered_.add(std::isfinite(estimated) ? 1.0 : 0.0);
        if (std::isfinite(estimated)) contact_.add(std::abs(estimated - truly));
      } else if (std::isfinite(estimated) &&
                 distance_px.at<float>(v, u) * camera_.mm_per_px_at(z) > kAwayMm) {
        // A pixel's own size is a lower bound of the distance on the face: an inclined face is
        // further away.
        false_.add(std::abs(estimated));
      }
    }
  }
}

void Evaluator::add_position(const Truth& truth, const cv::Mat& depth_mm,
                             const cv::Mat& points_mm) {
  constexpr int kEvery = 3;  // neighbours carry the same information
  for (int v = 0; v < depth_mm.rows; v += kEvery) {
    for (int u = 0; u < depth_mm.cols; u += kEvery) {
      const double untouched_z = points_mm.at<cv::Vec3f>(v, u)[2] + depth_mm.at<float>(v, u);
      const double error = std::abs(untouched_z - truth.untouched_z_mm.at<float>(v, u));
      if (std::isfinite(error)) positions_mm_.push_back(error);
    }
  }
}

void Evaluator::add_markers(const Truth& truth, const Markers& markers) {
  if (markers.size() != truth.markers.size()) return;
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const Truth::Dot& dot = truth.markers[i];
    const double error = std::hypot(markers[i].u - dot.u, markers[i].v - dot.v);
    if (!dot.visible) {
      hidden_.add(error);
    } else if (markers[i].seen) {
      seen_.add(error);
    }
  }
}

Evaluation Evaluator::evaluation() const {
  Evaluation result = evaluation_;
  result.contact_depth_mm = contact_.value();
  result.contact_coverage = covered_.value();
  result.false_depth_mm = false_.value();
  result.position_mm = median(positions_mm_);
  result.marker_seen_px = seen_.value();
  result.marker_hidden_px = hidden_.value();
  result.time_ms = median(times_ms_);
  return result;
}

Result<Evaluation> evaluate_folder(const fs::path& truth_folder, const fs::path& results_folder) {
  const auto file = load_camera(truth_folder / "camera.yaml");
  if (!file) return file.error();
  const auto camera = Camera::create(file->parameters);
  if (!camera) return camera.error();
  const auto truth_text = read_file(truth_folder / "truth.json");
  if (!truth_text) return truth_text.error();
  const auto results_text = read_file(results_folder / "results.jsonl");
  if (!results_text) return results_text.error();
  try {
    const Json truth = Json::parse(*truth_text);
    const auto lines = lines_by_name(*results_text);
    Evaluator evaluator(*camera);
    for (const Json& entry : truth.at("frames")) {
      const std::string name = entry.at("frame");
      const auto line = lines.find(name);
      std::error_code failed;
      if (line == lines.end() || !fs::exists(results_folder / (name + ".depth.tiff"), failed)) {
        evaluator.add_missing();
        continue;
      }
      if (const Status status =
              add_frame(entry, line->second, truth_folder, results_folder, evaluator);
          !status)
        return status.error();
    }
    return evaluator.evaluation();
  } catch (const Json::exception& error) {
    return Error{en::say("not as `alltact simulate` and `alltact reconstruct` write it ({})",
                         std::string(error.what())),
                 en::say("{} with {}", truth_folder, results_folder),
                 en::say("running both again")};
  }
}

}  // namespace alltact
