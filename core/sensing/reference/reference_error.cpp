#include "core/sensing/reference/reference_error.h"

#include "core/grey_range.h"
#include "core/numerics/dispatch.h"
#include "core/numerics/median.h"
#include "core/numerics/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kCell = kErrorCellPx;
constexpr int kTerms = 6;
constexpr int kEvery = 2;  // cells are enough for the light
constexpr float kMinLevel = kTooDarkBelow;
constexpr int kMinFrames = 12;              // to separate drift from pose
constexpr int kMaxStudied = 48;             // frames computed from their neighbours
constexpr double kMedianOfSquare = 0.4549;  // of a normal distribution
constexpr double kConstantPart = 0.5;  // part of the variance that does not fall with the reach

/// Processes faces in parallel; runs while a recording is read, before any live measurement.
template <class Work>
void for_all(int count, const Work& work) {
  parallel_for(count, default_threads(), [&](int from, int to) {
    for (int i = from; i < to; ++i) work(static_cast<std::size_t>(i));
  });
}

using Terms = Eigen::Matrix<double, kTerms, 1>;
using Square = Eigen::Matrix<double, kTerms, kTerms>;

Terms basis_at(const cv::Size& size, double u, double v) {
  const double s = 2.0 * u / size.width - 1.0, t = 2.0 * v / size.height - 1.0;
  return (Terms() << 1.0, s, t, s * s, s * t, t * t).finished();
}

/// Means over cells of the grid, 0 where a cell shows the face in part only.
cv::Mat cells_of(const FaceGrid& grid, const FaceImage& face) {
  const cv::Size size(grid.size.width / kCell, grid.size.height / kCell);
  cv::Mat sum(size, CV_32SC1, cv::Scalar(0)), count = sum.clone();
  for (const FaceRun& run : grid.runs.runs) {
    const int row = run.row / kCell;
    if (row >= size.height) continue;
    const std::uint8_t* grey = face.grey.data() + run.before;
    const int end = std::min({run.end, face.end, size.width * kCell});
    for (int u = std::max(run.first, face.first), next = 0; u < end; u = next) {
      const int cell = u / kCell;
      next = std::min(end, (cell + 1) * kCell);
      sum.at<int>(row, cell) = std::accumulate(
          grey + (u - run.first), grey + (next - run.first), sum.at<int>(row, cell));
      count.at<int>(row, cell) += next - u;
    }
  }
  constexpr int kPixels = kCell * kCell;
  cv::Mat mean(size, CV_32FC1, cv::Scalar(0));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const auto level = static_cast<float>(sum.at<int>(y, x));
      if (count.at<int>(y, x) == kPixels && level > kMinLevel * kPixels)
        mean.at<float>(y, x) = level / kPixels;
    }
  return mean;
}

std::vector<cv::Mat> cells_of(const FaceGrid& grid, const std::vector<FaceImage>& faces) {
  std::vector<cv::Mat> cells(faces.size());
  for_all(static_cast<int>(faces.size()),
          [&](std::size_t i) { cells[i] = cells_of(grid, faces[i]); });
  return cells;
}

/// c so that (1 + basis c) own approximates `other`, over cells that both have; robust.
Terms light_between(const cv::Mat& own, const cv::Mat& other) {
  Terms terms = Terms::Zero();
  for (int round = 0; round < 3; ++round) {
    Square normal = 1e-6 * Square::Identity();
    Terms pull = Terms::Zero();
    for (int y = 0; y < own.rows; y += kEvery)
      for (int x = 0; x < own.cols; x += kEvery) {
        const auto a = static_cast<double>(own.at<float>(y, x)),
                   b = static_cast<double>(other.at<float>(y, x));
        if (!(a > 0.0) || !(b > 0.0)) continue;
        const Terms row = basis_at(own.size(), x + 0.5, y + 0.5);
        const double off = b / a - 1.0 - row.dot(terms);
        constexpr double kFar = 0.05;
        const double z = round == 0 ? 0.0 : off / kFar;
        if (std::abs(z) >= 1.0) continue;
        const double weight = (1.0 - z * z) * (1.0 - z * z);
        normal.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
        pull += weight * (b / a - 1.0) * row;
      }
    terms = normal.selfadjointView<Eigen::Lower>().ldlt().solve(pull);
  }
  return terms.allFinite() ? terms : Terms::Zero();
}

cv::Mat mean_cells(const std::vector<cv::Mat>& cells) {
  cv::Mat sum(cells.front().size(), CV_32FC1, cv::Scalar(0)), count = sum.clone();
  for (const cv::Mat& one : cells) {
    sum += one;
    cv::Mat shown;
    cv::Mat(one > 0.0F).convertTo(shown, CV_32F, 1.0 / 255);
    count += shown;
  }
  cv::Mat mean = sum / cv::max(count, 1.0);
  mean.setTo(0, count < 0.5 * static_cast<double>(cells.size()));
  return mean;
}

/// Constant, linear and square terms of the leading modes, as many as the number of frames
/// supports.
Eigen::MatrixXd pose_terms(const Eigen::MatrixXd& modes) {
  const Eigen::Index frames = modes.rows();
  Eigen::Index used = std::min<Eigen::Index>(modes.cols(), 4);
  const auto count = [](Eigen::Index n) { return 1 + n + n * (n + 1) / 2; };
  while (used > 0 && 4 * count(used) > frames) --used;
  Eigen::MatrixXd terms(frames, count(used));
  const double scale = std::max(1e-9,
                                modes.leftCols(std::max<Eigen::Index>(used, 1)).norm() /
                                    std::sqrt(static_cast<double>(frames)));
  terms.col(0).setOnes();
  Eigen::Index next = 1;
  for (Eigen::Index a = 0; a < used; ++a) terms.col(next++) = modes.col(a) / scale;
  for (Eigen::Index a = 0; a < used; ++a)
    for (Eigen::Index b = a; b < used; ++b)
      terms.col(next++) = modes.col(a).cwiseProduct(modes.col(b)) / (scale * scale);
  return terms;
}

/// Multiplies one row's pixels by a + b u + c u^2; clipped ones stay clipped.
ALLTACT_WIDE void multiply_row(
    std::uint8_t* grey, int count, int first, float a, float b, float c) {
  for (int i = 0; i < count; ++i) {
    const auto u = static_cast<float>(first + i);
    const auto level = static_cast<float>(grey[i]);
    const float bright = (a + u * (b + u * c)) * level + 0.5F;
    const float limit = kClippedFrom - 1;
    const float within = bright < 0.0F ? 0.0F : bright < limit ? bright : limit;
    grey[i] = static_cast<std::uint8_t>(
        static_cast<std::int32_t>(level >= static_cast<float>(kClippedFrom) ? level : within));
  }
}

void multiply(const FaceGrid& grid, const Terms& light, FaceImage& face) {
  for (const FaceRun& run : grid.runs.runs) {
    // basis_at() of the row, in powers of the column.
    const double per_px = 2.0 / grid.size.width, from = per_px * 0.5 - 1.0,
                 t = 2.0 * (run.row + 0.5) / grid.size.height - 1.0;
    const double constant = 1.0 + light[0] + t * (light[2] + t * light[5]),
                 slope = light[1] + t * light[4];
    multiply_row(face.grey.data() + run.before,
                 run.size(),
                 run.first,
                 static_cast<float>(constant + from * (slope + from * light[3])),
                 static_cast<float>(per_px * (slope + 2.0 * from * light[3])),
                 static_cast<float>(per_px * per_px * light[3]));
  }
}

/// Relative difference between a frame and its prediction from neighbours, without a change of
/// light; NaN where either has no value.
cv::Mat residual_of(const cv::Mat& own, const cv::Mat& computed) {
  const Terms light = light_between(own, computed);
  cv::Mat residual(own.size(), CV_32FC1, cv::Scalar(NAN));
  for (int y = 0; y < own.rows; ++y)
    for (int x = 0; x < own.cols; ++x) {
      const float a = own.at<float>(y, x), b = computed.at<float>(y, x);
      if (!(a > 0.0F) || !(b > 0.0F)) continue;
      const double q = 1.0 + basis_at(own.size(), x + 0.5, y + 0.5).dot(light);
      residual.at<float>(y, x) = static_cast<float>(q * static_cast<double>(a / b) - 1.0);
    }
  return residual;
}

/// Noise of cells' means in grey levels, squared: from differences of adjacent cells, most of which
/// show even skin.
double noise_square(const cv::Mat& residual, const cv::Mat& level) {
  std::vector<double> squares;
  for (int y = 0; y < residual.rows; ++y)
    for (int x = 0; x + 1 < residual.cols; ++x) {
      const double step = static_cast<double>(residual.at<float>(y, x + 1)) -
                          static_cast<double>(residual.at<float>(y, x));
      const double off = step * static_cast<double>(level.at<float>(y, x));
      if (std::isfinite(off)) squares.push_back(0.5 * off * off);
    }
  return squares.empty() ? 0.0 : upper_median(squares) / kMedianOfSquare;
}

cv::Mat computed_from(const std::vector<cv::Mat>& cells, const Neighbours& neighbours) {
  cv::Mat sum(cells.front().size(), CV_32FC1, cv::Scalar(0)), shown = sum == 0.0F;
  for (std::size_t k = 0; k < neighbours.rows.size(); ++k) {
    const cv::Mat& one = cells[static_cast<std::size_t>(neighbours.rows[k])];
    sum += neighbours.weights[static_cast<Eigen::Index>(k)] * one;
    shown &= one > 0.0F;
  }
  sum.setTo(0, ~shown);
  return sum;
}

/// Squared errors of the cells in the studied frames, and their noise; NaN where a frame did not
/// show a cell.
struct Residuals {
  std::vector<cv::Mat> square, noise;
  explicit Residuals(std::size_t count) : square(count), noise(count) {}
  void set(std::size_t k, const cv::Mat& residual, const cv::Mat& level) {
    square[k] = residual.mul(residual);
    noise[k] = noise_square(residual, level) / level.mul(level);
  }
};

/// Sums over the studied frames, noise subtracted. Frames with an unnoticed contact at a cell are
/// outliers there and excluded.
struct Sums {
  cv::Mat square, count;
  explicit Sums(const Residuals& studied)
      : square(studied.square.front().size(), CV_32FC1, cv::Scalar(0)), count(square.clone()) {
    constexpr double kFar = 4.0;  // standard deviations
    std::vector<float> squares;
    for (int y = 0; y < square.rows; ++y)
      for (int x = 0; x < square.cols; ++x) {
        squares.clear();
        for (const cv::Mat& one : studied.square)
          if (const float off2 = one.at<float>(y, x); std::isfinite(off2)) squares.push_back(off2);
        const auto limit =
            kFar * kFar / kMedianOfSquare * static_cast<double>(upper_median(squares));
        for (std::size_t k = 0; k < studied.square.size(); ++k) {
          const float off2 = studied.square[k].at<float>(y, x);
          if (!(static_cast<double>(off2) <= limit)) continue;
          square.at<float>(y, x) += off2 - studied.noise[k].at<float>(y, x);
          count.at<float>(y, x) += 1.0F;
        }
      }
  }
};

}  // namespace

double ReferenceError::factor(double reach) const {
  if (!(typical_reach_px2 > 0.0)) return 1.0;
  const double further = reach / typical_reach_px2;
  return std::sqrt(kConstantPart + (1.0 - kConstantPart) * further * further);
}

double reach_px2(const Eigen::MatrixXd& points,
                 const Eigen::VectorXd& pose,
                 const Eigen::VectorXd& weights) {
  const Eigen::VectorXd square = (points.rowwise() - pose.transpose()).rowwise().squaredNorm();
  const double missed = (points.transpose() * weights - pose).norm();
  const double magnitude = weights.lpNorm<1>();
  const double spread = weights.cwiseAbs().dot(square);
  return spread + missed * std::sqrt(spread / std::max(1.0, magnitude));
}

void remove_drift(const FaceGrid& grid,
                  const Eigen::MatrixXd& modes,
                  std::vector<FaceImage>& faces) {
  if (static_cast<int>(faces.size()) < kMinFrames) return;
  const auto count = static_cast<int>(faces.size());
  const std::vector<cv::Mat> cells = cells_of(grid, faces);
  const cv::Mat mean = mean_cells(cells);
  Eigen::MatrixXd light(count, kTerms);
  for_all(count, [&](std::size_t i) {
    light.row(static_cast<Eigen::Index>(i)) = light_between(cells[i], mean).transpose();
  });
  const Eigen::MatrixXd terms = pose_terms(modes);
  const Eigen::MatrixXd by_pose = terms * terms.colPivHouseholderQr().solve(light);
  const Eigen::MatrixXd drift = light - by_pose;
  constexpr double kNegligible = 5e-4;
  for_all(count, [&](std::size_t i) {
    const Terms off = drift.row(static_cast<Eigen::Index>(i)).transpose();
    if (off.cwiseAbs().maxCoeff() > kNegligible) multiply(grid, off, faces[i]);
  });
}

ReferenceError reference_error(const FaceGrid& grid,
                               const std::vector<FaceImage>& faces,
                               const std::function<Neighbours(int)>& neighbours_of) {
  const std::vector<cv::Mat> cells = cells_of(grid, faces);
  const std::size_t studied = std::min(faces.size(), std::size_t{kMaxStudied});
  Residuals frames(studied);
  std::vector<double> reaches(studied);
  for_all(static_cast<int>(studied), [&](std::size_t k) {
    const std::size_t i = k * faces.size() / studied;
    const Neighbours neighbours = neighbours_of(static_cast<int>(i));
    const cv::Mat computed = computed_from(cells, neighbours);
    frames.set(k, residual_of(cells[i], computed), computed);
    reaches[k] = neighbours.reach_px2;
  });
  ReferenceError error;
  error.typical_reach_px2 = upper_median(reaches);
  // Averaged over a cell and its neighbours, because each has few frames.
  const Sums sums(frames);
  cv::Mat square, number;
  cv::boxFilter(sums.square, square, CV_32F, {3, 3}, {-1, -1}, false, cv::BORDER_ISOLATED);
  cv::boxFilter(sums.count, number, CV_32F, {3, 3}, {-1, -1}, false, cv::BORDER_ISOLATED);
  cv::sqrt(cv::max(square / cv::max(number, 1.0), 0.0), error.relative_sd);
  // Cells without a studied frame take the greatest error.
  double worst = 0;
  cv::minMaxLoc(error.relative_sd, nullptr, &worst);
  error.relative_sd.setTo(worst, number < 1.0);
  return error;
}

}  // namespace alltact
