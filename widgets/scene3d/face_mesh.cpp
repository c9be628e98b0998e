#include "widgets/scene3d/face_mesh.h"

#include "widgets/scene3d/face_surface.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

namespace alltact {
namespace {

cv::Vec3f vec(const Eigen::Vector3d& v) { return cv::Vec3d(v.x(), v.y(), v.z()); }

/// In the middle of the face, towards the camera.
Eigen::Vector3d normal_of(const cv::Mat& untouched_mm) {
  return inward_normal(untouched_mm, untouched_mm.cols / 2, untouched_mm.rows / 2);
}

}  // namespace

Eigen::Vector3d key_light(const cv::Mat& untouched_mm) {
  const Eigen::Vector3d normal = normal_of(untouched_mm);
  const Eigen::Vector3d along = (Eigen::Vector3d::UnitX() - normal.x() * normal).normalized();
  const Eigen::Vector3d up = normal.cross(along);  // of the image
  return (-0.9 * along + 0.25 * up + 0.75 * normal).normalized();
}

FaceMesh::FaceMesh() {
  positions_->SetNumberOfComponents(3);
  colours_->SetNumberOfComponents(3);
  colours_->SetName("colours");
  points_->SetData(positions_);
  data_->SetPoints(points_);
  data_->GetPointData()->SetScalars(colours_);
}

FaceMesh::~FaceMesh() = default;

void FaceMesh::make_topology(cv::Size size) {
  const int count = size.area();
  positions_->SetNumberOfTuples(count);
  colours_->SetNumberOfTuples(count);
  light_.create(size, CV_32FC1);
  drawn_ = cv::Mat(size, CV_32FC3, positions_->GetPointer(0));
  make_triangles();
  ++topologies_;
}

bool FaceMesh::set_stride(int stride) {
  if (stride == stride_) return false;
  stride_ = stride;
  if (!drawn_.empty()) make_triangles();
  return true;
}

/// Block by block: a software renderer transforms a vertex once for triangles that follow each
/// other, not once a row.
void FaceMesh::make_triangles() {
  const auto steps = [this](int count) {
    std::vector<int> all;
    for (int i = 0; i < count - 1; i += stride_) all.push_back(i);
    all.push_back(count - 1);
    return all;
  };
  const std::vector<int> columns = steps(drawn_.cols), rows = steps(drawn_.rows);
  const std::size_t last_column = columns.size() - 1, last_row = rows.size() - 1;
  const vtkNew<vtkCellArray> triangles;
  const auto quads = static_cast<vtkIdType>(last_column) * static_cast<vtkIdType>(last_row);
  triangles->AllocateExact(2 * quads, 6 * quads);
  constexpr std::size_t kBlock = 16;
  for (std::size_t top = 0; top < last_row; top += kBlock)
    for (std::size_t left = 0; left < last_column; left += kBlock)
      for (std::size_t j = top; j < std::min(top + kBlock, last_row); ++j)
        for (std::size_t i = left; i < std::min(left + kBlock, last_column); ++i) {
          const auto id = [&](std::size_t row, std::size_t column) {
            return static_cast<vtkIdType>(rows[row]) * drawn_.cols + columns[column];
          };
          const vtkIdType a = id(j, i), below = id(j + 1, i);
          const vtkIdType right = id(j, i + 1), over = id(j + 1, i + 1);
          triangles->InsertNextCell({a, below, right});
          triangles->InsertNextCell({right, below, over});
        }
  data_->SetPolys(triangles);
}

void FaceMesh::update(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm,
                      float exaggeration, const cv::Mat& value, const ColourScale& scale) {
  CV_Assert(untouched_mm.type() == CV_32FC3 && toward_camera_mm.type() == CV_32FC1 &&
            value.type() == CV_32FC1 && untouched_mm.size() == toward_camera_mm.size() &&
            untouched_mm.size() == value.size());
  if (drawn_.size() != untouched_mm.size()) make_topology(untouched_mm.size());
  set_positions(untouched_mm, toward_camera_mm, exaggeration);
  update_light(untouched_mm, toward_camera_mm, exaggeration);
  update_shadow(untouched_mm, toward_camera_mm);
  colour(value, scale);
  positions_->Modified();
  colours_->Modified();
  points_->Modified();
  data_->Modified();
}

void FaceMesh::set_positions(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm,
                             float exaggeration) {
  for (int j = 0; j < drawn_.rows; ++j) {
    const auto* from = untouched_mm.ptr<cv::Vec3f>(j);
    const auto* toward = toward_camera_mm.ptr<float>(j);
    auto* to = drawn_.ptr<cv::Vec3f>(j);
    for (int i = 0; i < drawn_.cols; ++i) {
      const float d = std::isfinite(toward[i]) ? exaggeration * toward[i] : 0.0F;
      to[i] = {from[i][0], from[i][1], from[i][2] - d};
    }
  }
}

/// A depth d along z moves the face's point by (0, 0, -d). With the undeformed face's steps t along
/// the grid and w down it, the normal is
///   (w - (0, 0, d_w)) x (t - (0, 0, d_t)) = w x t + (d_w t_y - d_t w_y, d_t w_x - d_w t_x, 0),
/// of which only the second part comes from the depth. Its steps are those of a 3 x 3 Sobel mask.
void FaceMesh::update_light(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm,
                            float exaggeration) {
  const int last_row = drawn_.rows - 1, last_column = drawn_.cols - 1;
  const float slope_gain = std::max(exaggeration, kSlopeGain);
  constexpr float kAmbient = 0.3F, kFill = 0.25F;
  const Eigen::Vector3d key = key_light(untouched_mm), normal = normal_of(untouched_mm);
  const cv::Vec3f fill = vec(kFill * normal),
                  lamp = vec((1 - kAmbient - kFill) / key.dot(normal) * key);
  for (int j = 0; j <= last_row; ++j) {
    const int up = std::max(j - 1, 0), low = std::min(j + 1, last_row);
    const auto* face = untouched_mm.ptr<cv::Vec3f>(j);
    const auto* above = untouched_mm.ptr<cv::Vec3f>(up);
    const auto* below = untouched_mm.ptr<cv::Vec3f>(low);
    const float* depth[3] = {toward_camera_mm.ptr<float>(up), toward_camera_mm.ptr<float>(j),
                             toward_camera_mm.ptr<float>(low)};
    auto* light = light_.ptr<float>(j);
    for (int i = 0; i <= last_column; ++i) {
      const int left = std::max(i - 1, 0), right = std::min(i + 1, last_column);
      const float here = std::isfinite(depth[1][i]) ? depth[1][i] : 0.0F;
      const auto d = [&](int row, int column) {
        return std::isfinite(depth[row][column]) ? depth[row][column] : here;
      };
      const float d_along = 0.25F * (d(0, right) - d(0, left) + d(2, right) - d(2, left)) +
                            0.5F * (d(1, right) - d(1, left));
      const float d_down = 0.25F * (d(2, left) - d(0, left) + d(2, right) - d(0, right)) +
                           0.5F * (d(2, i) - d(0, i));
      const cv::Vec3f t = face[right] - face[left], w = below[i] - above[i];
      float x = w[1] * t[2] - w[2] * t[1];
      float y = w[2] * t[0] - w[0] * t[2];
      const float z = w[0] * t[1] - w[1] * t[0];
      const float more_x = d_down * t[1] - d_along * w[1], more_y = d_along * w[0] - d_down * t[0];
      const float slope = slope_gain * std::sqrt(more_x * more_x + more_y * more_y) /
                          std::max(std::sqrt(x * x + y * y + z * z), 1e-12F);
      const float share = slope_gain / std::sqrt(1 + slope * slope / (kMaxSlope * kMaxSlope));
      x += share * more_x;
      y += share * more_y;
      const float length = std::max(std::sqrt(x * x + y * y + z * z), 1e-12F);
      const auto from = [&](const cv::Vec3f& lit) {
        return std::max(0.0F, (x * lit[0] + y * lit[1] + z * lit[2]) / length);
      };
      light[i] = kAmbient + from(fill) + from(lamp);
    }
  }
}

/// Depth darkening (Luft, Colditz and Deussen, 2006): how far skin lies below the mean of its
/// surroundings stands for the sky that they hide.
void FaceMesh::update_shadow(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm) {
  constexpr double kReach_mm = 1.2;      // half the side of each of two means
  constexpr float kDarkest = 0.35F;      // part of the light that a shadow takes at most
  constexpr float kHalfDark_mm = 0.03F;  // so far below takes half of that
  toward_camera_mm.copyTo(height_mm_);
  cv::patchNaNs(height_mm_, 0);
  const auto side = [&](const cv::Vec3f& from, const cv::Vec3f& to, int steps) {
    const double step_mm = std::max(cv::norm(to - from) / steps, 1e-6);
    return 2 * std::clamp(static_cast<int>(std::lround(kReach_mm / step_mm)), 1, steps) + 1;
  };
  const int last_row = drawn_.rows - 1, last_column = drawn_.cols - 1;
  const cv::Size mean(side(untouched_mm.at<cv::Vec3f>(last_row / 2, 0),
                           untouched_mm.at<cv::Vec3f>(last_row / 2, last_column), last_column),
                      side(untouched_mm.at<cv::Vec3f>(0, last_column / 2),
                           untouched_mm.at<cv::Vec3f>(last_row, last_column / 2), last_row));
  cv::blur(height_mm_, around_mm_, mean, {-1, -1}, cv::BORDER_REPLICATE);
  cv::blur(around_mm_, around_mm_, mean, {-1, -1}, cv::BORDER_REPLICATE);
  for (int j = 0; j <= last_row; ++j) {
    const auto* height = height_mm_.ptr<float>(j);
    const auto* around = around_mm_.ptr<float>(j);
    auto* light = light_.ptr<float>(j);
    for (int i = 0; i <= last_column; ++i) {
      const float below = std::max(0.0F, around[i] - height[i]);
      light[i] *= 1 - kDarkest * below / (below + kHalfDark_mm);
    }
  }
}

void FaceMesh::colour(const cv::Mat& value, const ColourScale& scale) {
  const ColourTable colour_of(scale);
  unsigned char* to = colours_->GetPointer(0);
  for (int j = 0; j < value.rows; ++j) {
    const auto* row = value.ptr<float>(j);
    const auto* light = light_.ptr<float>(j);
    for (int i = 0; i < value.cols; ++i, to += 3) {
      const MapColour at = std::isfinite(row[i]) ? colour_of(row[i]) : kNotMeasured;
      const auto lit = [&](std::uint8_t level) {
        return static_cast<std::uint8_t>(std::min(255.0F, level * light[i] + 0.5F));
      };
      to[0] = lit(at.red);
      to[1] = lit(at.green);
      to[2] = lit(at.blue);
    }
  }
}

}  // namespace alltact
