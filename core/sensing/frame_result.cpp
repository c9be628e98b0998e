#include "core/sensing/frame_result.h"

#include "core/image/grey_range.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace alltact {
namespace {

constexpr int kStride = 8;
constexpr int kBlackBelow = 16;
constexpr double kTailFraction = 0.001;  // fraction of the image that may be brighter
constexpr int kBlankLevels = 2;          // from the darkest to the brightest of a blank image
constexpr double kSaturatedFraction = 1.0 / 3;
constexpr double kMinReported = 0.02;  // part of the face
constexpr double kMuchDarker = 0.5, kMuchBrighter = 1.0 / 3;
constexpr double kForeignFraction = 0.1;  // fraction of the face brighter than its reference

}  // namespace

std::optional<Message> image_fault(const cv::Mat& grey) {
  CV_Assert(grey.type() == CV_8UC1);
  std::array<int, 256> histogram{};
  int all = 0;
  for (int v = kStride / 2; v < grey.rows; v += kStride) {
    const auto* row = grey.ptr<std::uint8_t>(v);
    for (int u = kStride / 2; u < grey.cols; u += kStride) ++histogram[row[u]], ++all;
  }
  if (all == 0) return std::nullopt;
  int level = 255, darkest = 0;
  for (int above = histogram[255]; level > 0 && above <= kTailFraction * all;)
    above += histogram[static_cast<std::size_t>(--level)];
  for (int below = histogram[0]; darkest < 255 && below <= kTailFraction * all;)
    below += histogram[static_cast<std::size_t>(++darkest)];
  if (level < kBlackBelow)
    return en::say(
        "the image is black: its brightest parts reach {} of 255 grey levels; take the cap off the "
        "lens, switch the lamps on, or expose longer",
        level);
  int saturated = 0;
  for (std::size_t i = kClippedFrom; i < histogram.size(); ++i) saturated += histogram[i];
  if (saturated > kSaturatedFraction * all)
    return en::say(
        "the image is too bright: {:.0f} % of it is saturated; expose shorter, or dim the lamps",
        100.0 * saturated / all);
  if (level - darkest <= kBlankLevels)
    return en::say(
        "the image is blank: every pixel has {} of 255 grey levels, without even camera noise; "
        "plug the camera in again",
        level);
  return std::nullopt;
}

bool is_same_frame(const Frame& before, const Frame& now) {
  if (before.grey.data == now.grey.data) return true;
  return !now.origin.empty() && before.origin == now.origin && before.name == now.name &&
         before.sequence == now.sequence && before.time_ns == now.time_ns;
}

bool is_same_image(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type() || a.empty()) return false;
  const std::size_t bytes = static_cast<std::size_t>(a.cols) * a.elemSize();
  for (int v = 0; v < a.rows; ++v)
    if (std::memcmp(a.ptr(v), b.ptr(v), bytes) != 0) return false;
  return true;
}

std::vector<Message> face_faults(const FlagFractions& shares, const LightGain& light) {
  std::vector<Message> faults;
  if (shares.of[kSaturated] > kMinReported)
    faults.push_back(
        en::say("{:.0f} % of the face is too bright to be measured; expose shorter, or dim the "
                "lamps",
                100.0 * shares.of[kSaturated]));
  if (shares.of[kNoReference] > kMinReported)
    faults.push_back(en::say(
        "{:.0f} % of the face was never recorded in a pose like this; record the finger bending "
        "further in this direction",
        100.0 * shares.of[kNoReference]));
  if (shares.of[kHiddenEnd] > 0)
    faults.push_back(
        en::say("{:.1f} % of the face, at its end, is hidden in this frame; whether it is in "
                "contact there is unknown",
                100.0 * shares.of[kHiddenEnd]));
  if (light.change() < -kMuchDarker)
    faults.push_back(en::say(
        "the face is {:.0f} % darker than when its reference was recorded; set exposure, gain and "
        "lamps as they were then",
        -100.0 * light.change()));
  if (light.change() > kMuchBrighter)
    faults.push_back(en::say(
        "the face is {:.0f} % brighter than when its reference was recorded; set exposure, gain "
        "and lamps as they were then",
        100.0 * light.change()));
  if (light.brighter() > kForeignFraction)
    faults.push_back(
        en::say("{:.0f} % of the face is brighter than its reference: this is another finger, or "
                "its skin has changed; choose the right finger, or record the reference again",
                100.0 * light.brighter()));
  return faults;
}

cv::Mat contact_face_points_mm(const FrameResult& result, const Face& face) {
  const cv::Mat& depth = result.depth->depth_mm;
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  cv::Mat points(depth.size(), CV_32FC3, cv::Scalar(kNaN, kNaN, kNaN));
  for (int row = 0; row < depth.rows; ++row) {
    const float* d = depth.ptr<float>(row);
    auto* point = points.ptr<cv::Vec3f>(row);
    for (int u = 0; u < depth.cols; ++u) {
      if (!std::isfinite(d[u])) continue;
      const auto local = result.shape->at(u, row);
      if (!local) continue;
      const Eigen::Vector3d p = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
      point[u] = {static_cast<float>(p.x()), static_cast<float>(p.y()),
                  static_cast<float>(p.z()) - d[u]};
    }
  }
  return points;
}

FaceVertices contact_face_vertices(const FrameResult& result, const Face& face) {
  const FaceVertices full{contact_face_points_mm(result, face), result.depth->depth_mm};
  const int step = result.mesh_step_px;
  if (step == 1) return full;
  const cv::Size size((full.depth_mm.cols + step - 1) / step,
                      (full.depth_mm.rows + step - 1) / step);
  FaceVertices sampled{cv::Mat(size, CV_32FC3), cv::Mat(size, CV_32FC1)};
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column) {
      sampled.points_mm.at<cv::Vec3f>(row, column) =
          full.points_mm.at<cv::Vec3f>(step * row, step * column);
      sampled.depth_mm.at<float>(row, column) = full.depth_mm.at<float>(step * row, step * column);
    }
  return sampled;
}

}  // namespace alltact
