#include "core/sensing/depth/unrolled_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

namespace alltact {

namespace {

constexpr int kMinCells = 16;

/// The nearest measured cell across the face, else along it; 0 where nothing is measured.
void fill_unmeasured(cv::Mat& cells) {
  const auto is_measured = [&](int j, int i) { return std::isfinite(cells.at<float>(j, i)); };
  std::vector<int> measured_columns;
  for (int i = 0; i < cells.cols; ++i) {
    int last = -1;
    for (int j = 0; j < cells.rows; ++j) {
      if (!is_measured(j, i)) continue;
      const int half = last < 0 ? 0 : (last + j + 1) / 2;
      for (int k = last + 1; k < j; ++k)
        cells.at<float>(k, i) = cells.at<float>(k < half ? last : j, i);
      last = j;
    }
    if (last < 0) continue;
    for (int k = last + 1; k < cells.rows; ++k) cells.at<float>(k, i) = cells.at<float>(last, i);
    measured_columns.push_back(i);
  }
  if (measured_columns.empty()) {
    cells.setTo(0.0F);
    return;
  }
  for (int i = 0; i < cells.cols; ++i) {
    const auto at = std::lower_bound(measured_columns.begin(), measured_columns.end(), i);
    if (at != measured_columns.end() && *at == i) continue;
    const int right = at == measured_columns.end() ? measured_columns.back() : *at;
    const int left = at == measured_columns.begin() ? right : *(at - 1);
    cells.col(i - left < right - i ? left : right).copyTo(cells.col(i));
  }
}

}  // namespace

std::optional<SightInLayer> sight_in_layer(const FaceShape& shape, double u, double v) {
  const auto here = shape.at(u, v), neighbour = shape.at(u, v + 1.0);
  const auto ray = shape.camera().unproject({u, v});
  if (!here || !neighbour || !ray) return std::nullopt;
  const Eigen::Vector3d& normal = here->normal;
  const double depth = ray->direction.dot(normal);
  if (!(depth > 0.0)) return std::nullopt;
  Eigen::Vector3d across = neighbour->view_point_mm - here->view_point_mm;
  across = (across - across.dot(normal) * normal).normalized();
  Eigen::Vector3d along = across.cross(normal);  // towards large u or small u
  if ((along.x() > 0.0) != shape.base_at_low_u()) along = -along;
  const Eigen::Vector3d crossing = shape.face().layer_mm / depth * ray->direction;
  return SightInLayer{{crossing.dot(along), crossing.dot(across)}, depth / ray->direction.norm()};
}

UnrolledFace::UnrolledFace(const FaceShape& shape, double cell_mm) : shape_(shape) {
  tabulate_columns();
  if (!is_empty()) make_grid(cell_mm);
}

void UnrolledFace::tabulate_columns() {
  const auto count = shape_.columns().size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t u = shape_.base_at_low_u() ? k : count - 1 - k;
    const FaceColumn& column = shape_.columns()[u];
    if (!column.valid) continue;
    const auto at_u = static_cast<double>(u);
    const double s = shape_.length_at(at_u);
    if (!s_.empty() && !(s > s_.back())) continue;
    const double middle = 0.5 * (column.upper_v + column.lower_v);
    const double quarter = 0.25 * (column.lower_v - column.upper_v);
    const auto here = sight_in_layer(shape_, at_u, middle),
               above = sight_in_layer(shape_, at_u, middle - quarter),
               below = sight_in_layer(shape_, at_u, middle + quarter);
    if (!here || !above || !below) continue;
    const double mm_per_px = shape_.position_mm(at_u, middle + 1.0).y();
    if (!(mm_per_px > 0.0)) continue;
    s_.push_back(s);
    u_.push_back(at_u);
    middle_v_.push_back(middle);
    mm_per_px_.push_back(mm_per_px);
    shift_s_.push_back(here->displacement_mm.x());
    shift_w_.push_back(here->displacement_mm.y());
    shift_w_slope_.push_back((below->displacement_mm.y() - above->displacement_mm.y()) /
                             (2.0 * quarter * mm_per_px));
    cos_.push_back(here->cos_sight);
    half_w_ = std::max(half_w_, 2.0 * quarter * mm_per_px);
  }
}

void UnrolledFace::make_grid(double cell_mm) {
  // Sizes that cosine transforms of half of them are quick for.
  const auto cells = [&](double length_mm) {
    const int requested = std::max(kMinCells, static_cast<int>(std::ceil(length_mm / cell_mm)));
    return 4 * cv::getOptimalDFTSize((requested + 3) / 4);
  };
  size_ = {cells(s_.back() - s_.front()), cells(2.0 * half_w_)};
  step_s_ = (s_.back() - s_.front()) / size_.width;
  step_w_ = 2.0 * half_w_ / size_.height;
  for (int i = 0; i < size_.width; ++i) {
    const double s = along_mm(i);
    sights_.push_back({along(shift_s_, s) / step_s_, along(shift_w_, s) / step_w_,
                       along(shift_w_slope_, s), along(cos_, s)});
  }
}

double UnrolledFace::along(const std::vector<double>& table, double s_mm) const {
  const auto above = std::upper_bound(s_.begin() + 1, s_.end() - 1, s_mm) - s_.begin();
  const auto i = static_cast<std::size_t>(above);
  const double part = std::clamp((s_mm - s_[i - 1]) / std::max(s_[i] - s_[i - 1], 1e-9), 0.0, 1.0);
  return table[i - 1] + part * (table[i] - table[i - 1]);
}

int UnrolledFace::column_of(int u) const {
  const double index = (shape_.length_at(u) - s_.front()) / step_s_ - 0.5;
  return static_cast<int>(std::clamp(std::lround(index), 0L, static_cast<long>(size_.width) - 1));
}

cv::Mat UnrolledFace::from_pixels(const cv::Mat& image) const {
  cv::Mat at_u(size_, CV_32FC1), at_v(size_, CV_32FC1), cells;
  std::vector<float> u, middle_v, px_per_mm;
  for (int i = 0; i < size_.width; ++i) {
    const double s = along_mm(i);
    u.push_back(static_cast<float>(along(u_, s)));
    middle_v.push_back(static_cast<float>(along(middle_v_, s)));
    px_per_mm.push_back(static_cast<float>(1.0 / along(mm_per_px_, s)));
  }
  for (int j = 0; j < size_.height; ++j) {
    const auto w = static_cast<float>((j - middle_row()) * step_w_);
    std::copy(u.begin(), u.end(), at_u.ptr<float>(j));
    float* v = at_v.ptr<float>(j);
    for (std::size_t i = 0; i < u.size(); ++i) v[i] = middle_v[i] + w * px_per_mm[i];
  }
  cv::remap(image, cells, at_u, at_v, cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar(std::numeric_limits<double>::quiet_NaN()));
  fill_unmeasured(cells);
  return cells;
}

cv::Mat UnrolledFace::to_pixels(const cv::Mat& cells, const cv::Size& size) const {
  cv::Mat column(size, CV_32FC1), row(size, CV_32FC1), at_pixel;
  std::vector<float> columns, middle_v, rows_per_px;
  for (int u = 0; u < size.width; ++u) {
    const double s = shape_.length_at(u);
    columns.push_back(static_cast<float>((s - s_.front()) / step_s_ - 0.5));
    middle_v.push_back(static_cast<float>(along(middle_v_, s)));
    rows_per_px.push_back(static_cast<float>(along(mm_per_px_, s) / step_w_));
  }
  for (int v = 0; v < size.height; ++v) {
    std::copy(columns.begin(), columns.end(), column.ptr<float>(v));
    float* at = row.ptr<float>(v);
    for (std::size_t u = 0; u < columns.size(); ++u)
      at[u] =
          (static_cast<float>(v) - middle_v[u]) * rows_per_px[u] + static_cast<float>(middle_row());
  }
  cv::remap(cells, at_pixel, column, row, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return at_pixel;
}

}  // namespace alltact
