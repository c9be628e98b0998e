#include "core/simulation/plan_truth.h"

#include <array>
#include <limits>
#include <numbers>

namespace alltact {

namespace {

constexpr float kOff = std::numeric_limits<float>::quiet_NaN();
constexpr float kSlopeStep_mm = 0.02F;  // step of the differences for a pressed face's slopes

// Slope of the press depth over one row, by differences of positions next to the pixels' own.
class DepthSlopes {
 public:
  DepthSlopes(const FrameGeometry& geometry, const RowView& row)
      : geometry_(geometry), row_(row), width_(static_cast<std::size_t>(row.width)) {}

  /// d(depth)/dx and d(depth)/dy for the columns where something may press.
  [[nodiscard]] std::array<std::vector<float>, 2> by_x_and_y(
      const std::vector<Eigen::Vector2f>& luf_slopes) {
    std::array<std::vector<float>, 2> result;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::vector<float> ahead = shifted_depth(luf_slopes, axis, kSlopeStep_mm);
      std::vector<float> slope = shifted_depth(luf_slopes, axis, -kSlopeStep_mm);
      for (std::size_t u = 0; u < width_; ++u)
        slope[u] = (ahead[u] - slope[u]) / (2 * kSlopeStep_mm);
      result[axis] = std::move(slope);
    }
    return result;
  }

 private:
  std::vector<float> shifted_depth(const std::vector<Eigen::Vector2f>& luf_slopes,
                                   std::size_t axis,
                                   float step_mm) {
    const FaceRow& here = row_.face;
    const auto copied = [&](const float* values) {
      return std::vector<float>(values, values + width_);
    };
    std::vector<float> x = copied(here.x_mm), y = copied(here.y_mm), luf = copied(here.luf_mm);
    std::vector<float> s = copied(here.s_mm);
    for (int u = row_.press_first; u < row_.press_last; ++u) {
      const auto i = static_cast<std::size_t>(u);
      (axis == 0 ? x : y)[i] += step_mm;
      luf[i] += step_mm * luf_slopes[i][static_cast<int>(axis)];
      if (axis == 0) s[i] += step_mm / here.cos_incline[u];
    }
    FaceRow shifted = here;
    shifted.x_mm = x.data();
    shifted.y_mm = y.data();
    shifted.luf_mm = luf.data();
    shifted.s_mm = s.data();
    std::vector<float> depth(width_, 0.0F);
    for (const auto& press : geometry_.presses)
      std::visit(
          [&](const auto& p) {
            press_row(p, shifted, row_.press_first, row_.press_last, depth.data());
          },
          press);
    return depth;
  }

  const FrameGeometry& geometry_;
  const RowView& row_;
  std::size_t width_;
};

void set_normals(const FrameGeometry& geometry, const RowView& row, cv::Vec3f* normals) {
  const FaceRow& face = row.face;
  std::vector<Eigen::Vector2f> slopes(static_cast<std::size_t>(row.width), Eigen::Vector2f::Zero());
  for (int u = face.first; u < face.last; ++u) {
    if (face.coverage[u] < 0.5F) continue;
    const Eigen::Vector3d n =
        geometry.press_pose(face.s_mm[u], face.y_mm[u] - face.shift_mm[u], 0).normal;
    slopes[static_cast<std::size_t>(u)] = (-n.head<2>() / n.z()).cast<float>();
  }
  std::array<std::vector<float>, 2> depth;
  if (row.press_first < row.press_last) depth = DepthSlopes(geometry, row).by_x_and_y(slopes);
  for (int u = face.first; u < face.last; ++u) {
    if (face.coverage[u] < 0.5F) continue;
    const auto i = static_cast<std::size_t>(u);
    Eigen::Vector3f normal(-slopes[i].x(), -slopes[i].y(), 1);
    if (u >= row.press_first && u < row.press_last)
      normal += Eigen::Vector3f(depth[0][i], depth[1][i], 0);
    normal.normalize();
    normals[u] = {normal.x(), normal.y(), normal.z()};
  }
}

void set_contacts(const FrameGeometry& geometry, const RowView& row, std::uint8_t* contacts) {
  for (const auto& press : geometry.presses)
    std::visit(
        [&](const auto& p) {
          for (int u = row.press_first; u < row.press_last; ++u)
            if (row.face.coverage[u] >= 0.5F && is_in_contact(p, row.face, u))
              contacts[u] = static_cast<std::uint8_t>(p.pose.contact + 1);
        },
        press);
}

void set_images(const FrameGeometry& geometry, Truth& truth) {
  const cv::Size size = geometry.rays().camera().size();
  truth.depth_mm = cv::Mat(size, CV_32FC1, cv::Scalar::all(kOff));
  truth.view_z_mm = truth.depth_mm.clone();
  truth.untouched_z_mm = truth.depth_mm.clone();
  RowScratch scratch(size.width);
  RowView row(size.width, scratch);
  for (int v = 0; v < size.height; ++v) {
    scratch.rewind();
    row.v = v;
    geometry.fill(row);
    for (int u = row.face.first; u < row.face.last; ++u) {
      if (row.face.coverage[u] < 0.5F) continue;  // the pixel's centre is off the face
      const bool pressed = u >= row.press_first && u < row.press_last;
      truth.depth_mm.at<float>(v, u) = pressed ? row.press_depth_mm[u] : 0.0F;
      truth.view_z_mm.at<float>(v, u) = row.face.z_mm[u];
      truth.untouched_z_mm.at<float>(v, u) = row.face.z_mm[u] + row.face.luf_mm[u];
    }
  }
}

}  // namespace

Truth truth_of(const FramePlan& plan, const FrameGeometry& geometry, TruthDetail detail) {
  Truth truth;
  if (detail == TruthDetail::kAll) set_images(geometry, truth);
  for (const MarkerDisc& disc : geometry.discs)
    truth.markers.push_back({disc.centre_px.x(), disc.centre_px.y(), disc.visible});
  for (const auto& press : geometry.presses)
    if (const auto* ball = std::get_if<BallPress>(&press))
      truth.balls.push_back({ball->centre_mm, ball->radius_mm, ball->pose.depth_mm});
  if (!truth.balls.empty()) truth.ball = truth.balls.front();
  truth.contacts = geometry.contacts;
  for (const auto& step : plan.geometry)
    for (const DegreeOfFreedom& dof : step.effect->degrees_of_freedom())
      truth.pose[dof.name] = step.context(dof);
  if (const FaceCurve* curve = geometry.curve(); curve && curve->response) {
    const Eigen::Vector4d& modes = *curve->response;
    truth.pose["q1_mm"] += modes[0];
    truth.pose["q2_mm"] += modes[1];
    truth.pose["sway_mm"] += modes[2];
    truth.pose["twist_deg"] += modes[3] * 180 / std::numbers::pi;
  }
  return truth;
}

TruthMaps truth_maps_of(const FrameGeometry& geometry) {
  const cv::Size size = geometry.rays().camera().size();
  TruthMaps maps;
  maps.contact = cv::Mat::zeros(size, CV_8UC1);
  maps.labels = cv::Mat::zeros(size, CV_8UC1);
  maps.normal = cv::Mat(size, CV_32FC3, cv::Scalar::all(kOff));
  RowScratch scratch(size.width);
  RowView row(size.width, scratch);
  for (int v = 0; v < size.height; ++v) {
    scratch.rewind();
    row.v = v;
    geometry.fill(row);
    set_normals(geometry, row, maps.normal.ptr<cv::Vec3f>(v));
    set_contacts(geometry, row, maps.contact.ptr<std::uint8_t>(v));
    for (int u = row.face.first; u < row.face.last; ++u)
      if (row.face.coverage[u] >= 0.5F)
        maps.labels.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(PixelLabel::kFace);
  }
  return maps;
}

void mark_dots(const FrameGeometry& geometry, cv::Mat& labels) {
  for (const MarkerDisc& disc : geometry.discs)
    for (int row = 0; row < disc.coverage.rows; ++row)
      for (int column = 0; column < disc.coverage.cols; ++column) {
        auto& here = labels.at<std::uint8_t>(disc.corner.y + row, disc.corner.x + column);
        if (disc.coverage(row, column) < 0.5F ||
            here == static_cast<std::uint8_t>(PixelLabel::kFace))
          continue;
        here =
            static_cast<std::uint8_t>(disc.visible ? PixelLabel::kDot : PixelLabel::kFoldOverDot);
      }
}

}  // namespace alltact
