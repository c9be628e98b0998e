#include "core/sensing/depth/unrolled_face.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/image_noise.h"
#include "core/numerics/vector_loops.h"
#include "core/sensing/reference/image_warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace alltact {

namespace {

constexpr int kMinCells = 16;

/// The nearest measured cell across the face, else along it; 0 where nothing is measured.
void fill_unmeasured(cv::Mat& cells) {
  const auto columns = static_cast<std::size_t>(cells.cols);
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  // Row by row: the nearest above, then the nearest below where that is nearer.
  cv::Mat above_row(cells.size(), CV_16SC1);
  std::vector<int> last(columns, -1), next(columns, -1);
  for (int j = 0; j < cells.rows; ++j) {
    const float* row = cells.ptr<float>(j);
    auto* above = above_row.ptr<std::int16_t>(j);
    for (std::size_t i = 0; i < columns; ++i) {
      if (row[i] == row[i]) last[i] = j;  // NaN is not itself
      above[i] = static_cast<std::int16_t>(last[i]);
    }
  }
  for (int j = cells.rows - 1; j >= 0; --j) {
    float* row = cells.ptr<float>(j);
    const auto* above = above_row.ptr<std::int16_t>(j);
    for (std::size_t i = 0; i < columns; ++i) {
      if (above[i] == j) {
        next[i] = j;
        continue;
      }
      const bool is_below = next[i] >= 0 && (above[i] < 0 || next[i] - j <= j - above[i]);
      const int from = is_below ? next[i] : above[i];
      row[i] = from < 0 ? nothing : cells.at<float>(from, static_cast<int>(i));
    }
  }
  std::vector<int> measured_columns;
  for (int i = 0; i < cells.cols; ++i)
    if (last[static_cast<std::size_t>(i)] >= 0) measured_columns.push_back(i);
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
  constexpr long kEvery = 8;  // the face is smooth
  const auto& columns = shape_.columns();
  const auto is_valid = [](const FaceColumn& column) { return column.valid; };
  const long first = std::find_if(columns.begin(), columns.end(), is_valid) - columns.begin(),
             last = columns.rend() - std::find_if(columns.rbegin(), columns.rend(), is_valid) - 1;
  for (long k = 0; first + k <= last + kEvery - 1; k += kEvery) {
    const long distance = std::min(k, last - first);
    const auto u =
        static_cast<std::size_t>(shape_.base_at_low_u() ? first + distance : last - distance);
    const FaceColumn& column = columns[u];
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
  first_s_ = s_.front();
  middle_row_ = 0.5 * size_.height - 0.5;
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
  const double index = (shape_.length_at(u) - first_s_) / step_s_ - 0.5;
  return static_cast<int>(std::clamp(std::lround(index), 0L, static_cast<long>(size_.width) - 1));
}

UnrolledFace UnrolledFace::part(const cv::Rect& cells) const {
  UnrolledFace part = *this;
  part.first_s_ = first_s_ + cells.x * step_s_;
  part.middle_row_ = middle_row_ - cells.y;
  part.size_ = cells.size();
  part.sights_ = {sights_.begin() + cells.x, sights_.begin() + cells.x + cells.width};
  return part;
}

namespace {

/// Cells of a row at w mm across the face; NaN outside of the image.
ALLTACT_WIDE void sample_row(const BilinearSamples& image, const cv::Size& size,
                             const float* __restrict at_u, const float* __restrict middle_v,
                             const float* __restrict px_per_mm, float w_mm, int count,
                             float* __restrict out) {
  const BilinearSamples samples = image;
  const auto last_u = static_cast<float>(size.width - 1),
             last_v = static_cast<float>(size.height - 1);
  for (int i = 0; i < count; ++i) {
    const float u = at_u[i], v = middle_v[i] + w_mm * px_per_mm[i];
    const float value = samples.at(u, v);
    const bool is_within = (u >= 0.0F) & (u <= last_u) & (v >= 0.0F) & (v <= last_v);
    out[i] = is_within ? value : std::numeric_limits<float>::quiet_NaN();
  }
}

}  // namespace

cv::Mat UnrolledFace::from_pixels(const cv::Mat& image, cv::Mat* measured) const {
  cv::Mat cells(size_, CV_32FC1);
  std::vector<float> u, middle_v, px_per_mm;
  for (int i = 0; i < size_.width; ++i) {
    const double s = along_mm(i);
    u.push_back(static_cast<float>(along(u_, s)));
    middle_v.push_back(static_cast<float>(along(middle_v_, s)));
    px_per_mm.push_back(static_cast<float>(1.0 / along(mm_per_px_, s)));
  }
  const BilinearSamples samples(image);
  for (int j = 0; j < size_.height; ++j)
    sample_row(samples, image.size(), u.data(), middle_v.data(), px_per_mm.data(),
               static_cast<float>((j - middle_row()) * step_w_), size_.width, cells.ptr<float>(j));
  if (measured != nullptr) *measured = cells == cells;  // NaN is not itself
  fill_unmeasured(cells);
  return cells;
}

/// For an image: where its columns are among the cells, and the rows that show any.
struct UnrolledFace::PixelColumns {
  std::vector<int> column;  // of the cell before
  std::vector<float> part;  // of the distance to the next
  std::vector<float> middle_v, rows_per_px;
  cv::Range rows;
};

UnrolledFace::PixelColumns UnrolledFace::pixel_columns(const cv::Size& size) const {
  PixelColumns pixels;
  double top = size.height, bottom = 0;
  for (int u = 0; u < size.width; ++u) {
    const double s = shape_.length_at(u), middle = along(middle_v_, s),
                 per_px = along(mm_per_px_, s) / step_w_;
    const double at = std::clamp((s - first_s_) / step_s_ - 0.5, 0.0, size_.width - 1.001);
    pixels.column.push_back(static_cast<int>(at));
    pixels.part.push_back(static_cast<float>(at - std::floor(at)));
    pixels.middle_v.push_back(static_cast<float>(middle));
    pixels.rows_per_px.push_back(static_cast<float>(per_px));
    top = std::min(top, middle - (middle_row_ + 1.0) / per_px);
    bottom = std::max(bottom, middle + (size_.height - middle_row_) / per_px);
  }
  pixels.rows = {std::clamp(static_cast<int>(top), 0, size.height),
                 std::clamp(static_cast<int>(bottom) + 1, 0, size.height)};
  return pixels;
}

namespace {

/// A row of cells at image columns. Only loads from fixed pointers are vectorised.
ALLTACT_WIDE void interpolate_along(const float* __restrict cells, const float* __restrict next,
                                    const int* __restrict column, const float* __restrict part,
                                    int count, float* __restrict out) {
  for (int u = 0; u < count; ++u) {
    const int at = column[u];
    out[u] = cells[at] + part[u] * (next[at] - cells[at]);
  }
}

/// A row of an image from rows of cells at its columns. Neighbouring pixels lie between the same
/// rows or the next: the sum over all rows near a block, each by its distance, needs no branches.
ALLTACT_WIDE void interpolate_across(const float* __restrict cell_rows, std::ptrdiff_t step,
                                     float last_row, const float* __restrict middle_v,
                                     const float* __restrict rows_per_px, float v, float middle_row,
                                     int count, float* __restrict out) {
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        std::array<float, kBlock> row, sum{};
        for (int k = 0; k < size; ++k) {
          const int u = first + k;
          const float at = (v - middle_v[u]) * rows_per_px[u] + middle_row;
          row[static_cast<std::size_t>(k)] = std::min(std::max(at, 0.0F), last_row);
        }
        int least = static_cast<int>(row[0]), most = least;
        for (int k = 0; k < size; ++k) {
          const int above = static_cast<int>(row[static_cast<std::size_t>(k)]);
          least = above < least ? above : least;
          most = above > most ? above : most;
        }
        for (int j = least; j <= most + 1; ++j) {
          const float* cells = cell_rows + j * step + first;
          const auto here = static_cast<float>(j);
          for (int k = 0; k < size; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const float weight = 1.0F - std::abs(row[i] - here);
            sum[i] += (weight > 0.0F ? weight : 0.0F) * cells[k];
          }
        }
        for (int k = 0; k < size; ++k) out[first + k] = sum[static_cast<std::size_t>(k)];
      });
}

}  // namespace

std::vector<cv::Mat> UnrolledFace::to_pixels(std::span<const cv::Mat> all,
                                             const cv::Size& size) const {
  const PixelColumns pixels = pixel_columns(size);
  cv::Mat at_columns = pooled_image({size.width, size_.height}, CV_32FC1);
  std::vector<cv::Mat> images;
  for (const cv::Mat& cells : all) {
    for (int j = 0; j < cells.rows; ++j)
      interpolate_along(cells.ptr<float>(j), cells.ptr<float>(j) + 1, pixels.column.data(),
                        pixels.part.data(), size.width, at_columns.ptr<float>(j));
    cv::Mat image = pooled_image(size, CV_32FC1);
    image.rowRange(0, pixels.rows.start).setTo(0.0);
    image.rowRange(pixels.rows.end, size.height).setTo(0.0);
    for (int v = pixels.rows.start; v < pixels.rows.end; ++v)
      interpolate_across(at_columns.ptr<float>(), static_cast<std::ptrdiff_t>(at_columns.step1()),
                         static_cast<float>(cells.rows) - 1.001F, pixels.middle_v.data(),
                         pixels.rows_per_px.data(), static_cast<float>(v),
                         static_cast<float>(middle_row_), size.width, image.ptr<float>(v));
    images.push_back(image);
  }
  return images;
}

}  // namespace alltact
