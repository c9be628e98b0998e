#include "widgets/scene3d/face_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

namespace alltact {

FaceMesh::FaceMesh() {
  positions_->SetNumberOfComponents(3);
  normals_->SetNumberOfComponents(3);
  normals_->SetName("normals");
  colours_->SetNumberOfComponents(3);
  colours_->SetName("colours");
  points_->SetData(positions_);
  data_->SetPoints(points_);
  data_->GetPointData()->SetNormals(normals_);
  data_->GetPointData()->SetScalars(colours_);
}

FaceMesh::~FaceMesh() = default;

void FaceMesh::make_topology(cv::Size size) {
  const int count = size.area();
  for (vtkDataArray* array :
       {static_cast<vtkDataArray*>(positions_), static_cast<vtkDataArray*>(normals_),
        static_cast<vtkDataArray*>(colours_)})
    array->SetNumberOfTuples(count);
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
  update_normals(untouched_mm, toward_camera_mm, exaggeration);
  colour(value, scale);
  positions_->Modified();
  normals_->Modified();
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
void FaceMesh::update_normals(const cv::Mat& untouched_mm, const cv::Mat& toward_camera_mm,
                              float exaggeration) {
  const int last_row = drawn_.rows - 1, last_column = drawn_.cols - 1;
  const float slope_gain = std::max(exaggeration, kSlopeGain);
  float* normal = normals_->GetPointer(0);
  for (int j = 0; j <= last_row; ++j) {
    const int up = std::max(j - 1, 0), low = std::min(j + 1, last_row);
    const auto* face = untouched_mm.ptr<cv::Vec3f>(j);
    const auto* above = untouched_mm.ptr<cv::Vec3f>(up);
    const auto* below = untouched_mm.ptr<cv::Vec3f>(low);
    const float* depth[3] = {toward_camera_mm.ptr<float>(up), toward_camera_mm.ptr<float>(j),
                             toward_camera_mm.ptr<float>(low)};
    for (int i = 0; i <= last_column; ++i, normal += 3) {
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
      normal[0] = x / length;
      normal[1] = y / length;
      normal[2] = z / length;
    }
  }
}

void FaceMesh::colour(const cv::Mat& value, const ColourScale& scale) {
  constexpr int kSteps = 256;
  std::array<MapColour, kSteps> table;
  for (int i = 0; i < kSteps; ++i)
    table[static_cast<std::size_t>(i)] = scale.colour(static_cast<double>(i) / (kSteps - 1));
  const auto low = static_cast<float>(scale.low_mm);
  const auto steps = static_cast<float>((kSteps - 1) / (scale.top_mm - scale.low_mm));
  unsigned char* to = colours_->GetPointer(0);
  for (int j = 0; j < value.rows; ++j) {
    const auto* row = value.ptr<float>(j);
    for (int i = 0; i < value.cols; ++i, to += 3) {
      MapColour at = kNotMeasured;
      if (std::isfinite(row[i])) {
        const float step = std::clamp((row[i] - low) * steps, 0.0F, kSteps - 1.0F);
        at = table[static_cast<std::size_t>(step + 0.5F)];
      }
      to[0] = at.red;
      to[1] = at.green;
      to[2] = at.blue;
    }
  }
}

}  // namespace alltact
