#include "calibration/reference/skin_brightness.h"

#include "core/image/grey_range.h"
#include "core/numerics/median.h"
#include "core/numerics/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <Eigen/Dense>

namespace alltact {
namespace {

// Next to the face's edges a shift of a tenth of a pixel is visible as a change of brightness.
constexpr double kPatchRimPx = 1.5, kRimMm = 1.0;
constexpr double kEndMm = 4.0;      // from either end of the visible part: light ends there
constexpr float kMinPixels = 2;     // of a patch
constexpr float kMaxHidden = 0.1F;  // maximum fraction of a patch that a frame does not show

/// Arc length from the face's base of a column of the grid; below 0 before it.
double length_at(const FaceChart& chart, std::size_t column) {
  return chart.base_at_low_u ? chart.along_mm[column] : -chart.along_mm[column];
}

/// By pixel of the grid's runs, its patch; -1 where there is none.
std::vector<std::int32_t> patch_of_pixels(const FaceGrid& grid, SkinPatches& patches) {
  const FaceChart& chart = grid.chart;
  const auto [from_mm, to_mm] =
      std::minmax({length_at(chart, 0), length_at(chart, chart.along_mm.size() - 1)});
  patches.begin_mm = from_mm;
  patches.along = std::max(1, static_cast<int>((to_mm - from_mm) / patches.along_mm));
  std::vector<std::int32_t> patch(grid.runs.pixels(), -1);
  for (const FaceRun& run : grid.runs.runs)
    for (int u = run.first; u < run.end; ++u) {
      const auto column = static_cast<std::size_t>(u);
      const double v = run.row + grid.origin.y;
      const double upper = chart.upper_v[column], lower = chart.lower_v[column];
      if (v < upper + kPatchRimPx || v > lower - kPatchRimPx) continue;
      const double t = (v - upper) / (lower - upper);
      if (std::min(t, 1 - t) * patches.width_mm < kRimMm) continue;
      const int i =
          static_cast<int>((length_at(chart, column) - patches.begin_mm) / patches.along_mm);
      const int j = std::min(patches.across - 1, static_cast<int>(t * patches.across));
      if (i >= patches.along) continue;
      patch[run.before + static_cast<std::uint32_t>(u - run.first)] = i * patches.across + j;
    }
  return patch;
}

/// The part of the face, mm from its base, that a frame shows well within its ends.
struct Shown {
  double from_mm, to_mm;
};
Shown shown_of(const FaceGrid& grid, const FaceImage& face) {
  if (face.first >= face.end) return {1.0, 0.0};
  const auto [from_mm, to_mm] =
      std::minmax({length_at(grid.chart, static_cast<std::size_t>(face.first)),
                   length_at(grid.chart, static_cast<std::size_t>(face.end - 1))});
  return {from_mm + kEndMm, to_mm - kEndMm};
}

}  // namespace

SkinPatches skin_patches(const FaceGrid& grid, const std::vector<FaceImage>& faces,
                         double face_width_mm, double patch_mm) {
  SkinPatches patches;
  patches.along_mm = patch_mm;
  patches.width_mm = face_width_mm;
  patches.across = std::max(3, static_cast<int>(std::lround(face_width_mm / patch_mm)));
  patches.across_mm = face_width_mm / patches.across;
  const std::vector<std::int32_t> patch = patch_of_pixels(grid, patches);
  const auto count = static_cast<std::size_t>(patches.count());
  patches.pixels.assign(count, 0.0F);
  for (const std::int32_t p : patch)
    if (p >= 0) patches.pixels[static_cast<std::size_t>(p)] += 1;
  patches.log_level.resize(static_cast<Eigen::Index>(faces.size()), patches.count());
  patches.log_level.setConstant(std::numeric_limits<float>::quiet_NaN());
  parallel_for(static_cast<int>(faces.size()), default_threads(), [&](int first, int last) {
    std::vector<std::uint32_t> sum(count), seen(count);
    for (int i = first; i < last; ++i) {
      const FaceImage& face = faces[static_cast<std::size_t>(i)];
      std::fill(sum.begin(), sum.end(), 0);
      std::fill(seen.begin(), seen.end(), 0);
      for (const FaceRun& run : grid.runs.runs)
        for (int u = std::max(run.first, face.first); u < std::min(run.end, face.end); ++u) {
          const std::uint32_t pixel = run.before + static_cast<std::uint32_t>(u - run.first);
          const std::int32_t p = patch[pixel];
          if (p < 0 || face.grey[pixel] >= kClippedFrom) continue;
          sum[static_cast<std::size_t>(p)] += face.grey[pixel];
          ++seen[static_cast<std::size_t>(p)];
        }
      const Shown visible = shown_of(grid, face);
      for (std::size_t p = 0; p < count; ++p) {
        const double s_mm = patches.s_mm(static_cast<int>(p));
        if (s_mm < visible.from_mm || s_mm > visible.to_mm) continue;
        const float pixels = patches.pixels[p];
        const auto shown = static_cast<float>(seen[p]);
        if (pixels < kMinPixels || shown < (1 - kMaxHidden) * pixels) continue;
        const float level = static_cast<float>(sum[p]) / shown;
        if (level < kTooDarkBelow) continue;
        patches.log_level(i, static_cast<Eigen::Index>(p)) = std::log(level);
      }
    }
  });
  return patches;
}

namespace {

constexpr float kNoLevel = std::numeric_limits<float>::quiet_NaN();
constexpr int kPoseLightTerms = 6;
// modes: enough for the fingers of touch_search_test
constexpr Eigen::Index kLinear = 5, kSquare = 4;
constexpr Eigen::Index kFramesPerTerm = 6;
constexpr double kRidge = 1e-6;       // of each frame: makes the equations solvable
constexpr double kMinSd = 0.001;      // of a patch; quantisation alone exceeds it
constexpr double kDarkWeight = 0.05;  // of frames below the envelope, in asymmetric least squares
constexpr double kDarkSds = 5.0;      // from there on a darker frame has zero weight
constexpr double kBrightSds = 3.0;    // from there on a brighter one has less weight
constexpr double kShown = 0.9;        // fraction of the frames that must show a patch

double one_sided_weight(double z) {
  if (z >= 0) return z < kBrightSds ? 1.0 : kBrightSds / z;
  const double part = z / kDarkSds;
  return part <= -1 ? 0.0 : (1 - part * part) * (1 - part * part);
}

}  // namespace

Eigen::MatrixXd pose_terms_of(const Eigen::MatrixXd& modes) {
  const Eigen::Index frames = modes.rows();
  Eigen::Index linear = std::min(modes.cols(), kLinear), square = std::min(modes.cols(), kSquare);
  const auto count = [](Eigen::Index l, Eigen::Index s) { return 1 + l + s * (s + 1) / 2; };
  while (square > 0 && kFramesPerTerm * count(linear, square) > frames) --square;
  while (linear > 0 && kFramesPerTerm * count(linear, square) > frames) --linear;
  square = std::min(square, linear);
  Eigen::MatrixXd scaled = modes.leftCols(linear);
  for (Eigen::Index k = 0; k < linear; ++k)
    scaled.col(k) /= std::max(1e-9, scaled.col(k).norm() / std::sqrt(static_cast<double>(frames)));
  Eigen::MatrixXd terms(frames, count(linear, square));
  terms.col(0).setOnes();
  terms.middleCols(1, linear) = scaled;
  Eigen::Index next = 1 + linear;
  for (Eigen::Index a = 0; a < square; ++a)
    for (Eigen::Index b = a; b < square; ++b)
      terms.col(next++) = scaled.col(a).cwiseProduct(scaled.col(b));
  return terms;
}

SkinPatches coarser_patches(const SkinPatches& fine) {
  SkinPatches coarse;
  coarse.along = fine.along / 2;
  coarse.across = fine.across / 2;
  coarse.along_mm = 2 * fine.along_mm;
  coarse.begin_mm = fine.begin_mm;
  coarse.width_mm = fine.width_mm;
  coarse.across_mm = fine.width_mm / coarse.across;
  coarse.pixels.assign(static_cast<std::size_t>(coarse.count()), 0.0F);
  coarse.log_level = PatchValues::Zero(fine.frames(), coarse.count());
  for (int i = 0; i < 2 * coarse.along; ++i)
    for (int j = 0; j < fine.across; ++j) {
      const int from = i * fine.across + j;
      const int to = i / 2 * coarse.across + j * coarse.across / fine.across;
      const float pixels = fine.pixels[static_cast<std::size_t>(from)];
      if (fine.log_level.col(from).array().isNaN().all()) continue;
      coarse.pixels[static_cast<std::size_t>(to)] += pixels;
      coarse.log_level.col(to) += pixels * fine.log_level.col(from);
    }
  for (int p = 0; p < coarse.count(); ++p) {
    const float pixels = coarse.pixels[static_cast<std::size_t>(p)];
    if (pixels > 0)
      coarse.log_level.col(p) /= pixels;
    else
      coarse.log_level.col(p).setConstant(kNoLevel);
  }
  return coarse;
}

PoseBrightness::PoseBrightness(const SkinPatches& patches, const Eigen::MatrixXd& terms)
    : patches_(patches),
      terms_(terms),
      light_(Eigen::MatrixXd::Zero(patches.frames(), kPoseLightTerms)),
      light_basis_(patches.count(), kPoseLightTerms),
      sd_(static_cast<std::size_t>(patches.count()), 0.01F),
      fitted_(PatchValues::Constant(patches.frames(), patches.count(), kNoLevel)) {
  for (int p = 0; p < patches.count(); ++p) {
    const double s = (2 * (p / patches.across) + 1.0) / patches.along - 1;
    const double t = 2 * patches.y_mm(p) / patches.width_mm;
    light_basis_.row(p) << 1, s, t, s * s, s * t, t * t;
    const auto shown = patches.log_level.col(p).array().isFinite().count();
    if (static_cast<double>(shown) >= kShown * static_cast<double>(patches.frames()))
      usable_.push_back(p);
  }
}

void PoseBrightness::fit_one_sided(const std::vector<char>& without, bool from_bright) {
  parallel_for(static_cast<int>(usable_.size()), default_threads(), [&](int first, int last) {
    for (int k = first; k < last; ++k)
      fit_patch(usable_[static_cast<std::size_t>(k)], without, from_bright);
  });
}

void PoseBrightness::fit_patch(int patch, const std::vector<char>& without, bool from_bright) {
  constexpr int kStart = 3, kPatchRounds = 3;
  const Eigen::Index count = terms_.cols();
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < patches_.frames(); ++i)
    if (!without[static_cast<std::size_t>(i)] && std::isfinite(patches_.log_level(i, patch)))
      rows.push_back(i);
  if (rows.size() < 2) return;
  const auto n = static_cast<Eigen::Index>(rows.size());
  const Eigen::MatrixXd a = terms_(rows, Eigen::all);
  Eigen::VectorXd y(n), weight = Eigen::VectorXd::Ones(n), coefficients;
  for (Eigen::Index k = 0; k < n; ++k) y[k] = level(rows[static_cast<std::size_t>(k)], patch);
  const double mean = y.mean();
  y.array() -= mean;
  std::vector<double> brighter;
  for (int round = from_bright ? -kStart : 0; round < kPatchRounds; ++round) {
    Eigen::MatrixXd normal =
        kRidge * static_cast<double>(n) * Eigen::MatrixXd::Identity(count, count);
    normal.selfadjointView<Eigen::Lower>().rankUpdate(
        (weight.cwiseSqrt().asDiagonal() * a).transpose());
    coefficients =
        normal.selfadjointView<Eigen::Lower>().ldlt().solve(a.transpose() * weight.cwiseProduct(y));
    const Eigen::VectorXd left = y - a * coefficients;
    brighter.clear();
    for (const double off : left)
      if (off > 0) brighter.push_back(off);
    const double sd = std::max(2 * kMinSd, 1.4826 * upper_median(brighter));
    sd_[static_cast<std::size_t>(patch)] = static_cast<float>(sd);
    constexpr double kLeastWeight = 1e-4;
    for (Eigen::Index k = 0; k < n; ++k)
      weight[k] = round < -1 ? (left[k] > 0 ? 1.0 : kDarkWeight)
                             : std::max(kLeastWeight, one_sided_weight(left[k] / sd));
  }
  fitted_.col(patch) = (terms_ * coefficients).cast<float>().array() + static_cast<float>(mean);
}

void PoseBrightness::fit(const std::vector<char>& without) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < patches_.frames(); ++i)
    if (!without[static_cast<std::size_t>(i)]) rows.push_back(i);
  const auto n = static_cast<Eigen::Index>(rows.size());
  if (n < 2) return;
  const Eigen::MatrixXd a = terms_(rows, Eigen::all);
  const Eigen::MatrixXd normal =
      a.transpose() * a +
      kRidge * static_cast<double>(n) * Eigen::MatrixXd::Identity(a.cols(), a.cols());
  const Eigen::MatrixXd solve = normal.ldlt().solve(a.transpose());
  parallel_for(static_cast<int>(usable_.size()), default_threads(), [&](int first, int last) {
    Eigen::VectorXd y(n);
    std::vector<float> off;
    for (int i = first; i < last; ++i) {
      const int patch = usable_[static_cast<std::size_t>(i)];
      double sum = 0;
      Eigen::Index shown = 0;
      for (Eigen::Index k = 0; k < n; ++k) {
        y[k] = level(rows[static_cast<std::size_t>(k)], patch);
        if (std::isfinite(y[k])) sum += y[k], ++shown;
      }
      if (shown < 2) continue;
      const double mean = sum / static_cast<double>(shown);
      // Frames that do not show the patch take the predicted value.
      Eigen::VectorXd filled = y.array() - mean, coefficients = solve * filled;
      if (shown < n) {
        Eigen::VectorXd predicted = Eigen::VectorXd::Zero(n);
        for (int round = 0; round < 3; ++round) {
          for (Eigen::Index k = 0; k < n; ++k)
            filled[k] = std::isfinite(y[k]) ? y[k] - mean : predicted[k];
          coefficients = solve * filled;
          predicted = a * coefficients;
        }
      }
      const Eigen::VectorXd fitted = terms_ * coefficients;
      fitted_.col(patch) = fitted.cast<float>().array() + static_cast<float>(mean);
      off.clear();
      for (Eigen::Index k = 0; k < n; ++k)
        if (std::isfinite(y[k]))
          off.push_back(static_cast<float>(
              std::abs(y[k] - mean - fitted[rows[static_cast<std::size_t>(k)]])));
      sd_[static_cast<std::size_t>(patch)] =
          std::max(static_cast<float>(kMinSd), 1.4826F * upper_median(off));
    }
  });
}

void PoseBrightness::fit_with_light(const std::vector<char>& without) {
  fit(without);
  fit_light();
  fit(without);
}

void PoseBrightness::fit_light() {
  parallel_for(static_cast<int>(patches_.frames()), default_threads(), [&](int first, int last) {
    for (Eigen::Index i = first; i < last; ++i) fit_light_of(i);
  });
}

void PoseBrightness::fit_light_of(Eigen::Index frame) {
  using Terms = Eigen::Matrix<double, kPoseLightTerms, 1>;
  using Square = Eigen::Matrix<double, kPoseLightTerms, kPoseLightTerms>;
  constexpr double kDark = 4.0, kBright = 6.0;  // standard deviations
  constexpr double kLeast = 0.004;              // sd: better known patches get no higher weight
  constexpr double kPrior = 0.02;               // sd of a term: limits the influence of few patches
  Terms light = light_.row(frame).transpose();
  for (int round = 0; round < 3; ++round) {
    Square normal = Square::Identity() / (kPrior * kPrior);
    Terms pull = Terms::Zero();
    for (const int p : usable_) {
      const double y = static_cast<double>(patches_.log_level(frame, p) - fitted_(frame, p));
      if (!std::isfinite(y)) continue;
      const double sd = std::max(kLeast, static_cast<double>(sd_[static_cast<std::size_t>(p)]));
      const Terms basis = light_basis_.row(p).transpose();
      const double z = (y - basis.dot(light)) / sd;
      const double part = z / (z < 0 ? kDark : kBright);
      double weight = 1.0;
      if (round > 0) weight = std::abs(part) >= 1 ? 0.0 : (1 - part * part) * (1 - part * part);
      weight /= sd * sd;
      normal.selfadjointView<Eigen::Lower>().rankUpdate(basis, weight);
      pull += weight * y * basis;
    }
    light = normal.selfadjointView<Eigen::Lower>().ldlt().solve(pull);
  }
  light_.row(frame) = light.transpose();
}

PatchValues PoseBrightness::residuals() const {
  PatchValues left = patches_.log_level - fitted_;
  left -= (light_ * light_basis_.transpose()).cast<float>();
  return left;
}

DeletedResiduals deleted_residuals(const PatchValues& residuals, const Eigen::MatrixXd& terms,
                                   const std::vector<char>& without,
                                   const std::vector<int>& numbers, int gap) {
  const Eigen::Index frames = residuals.rows(), count = terms.cols();
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < frames; ++i)
    if (!without[static_cast<std::size_t>(i)]) rows.push_back(i);
  const Eigen::MatrixXd all = terms(rows, Eigen::all);
  const Eigen::MatrixXd normal =
      all.transpose() * all +
      kRidge * static_cast<double>(rows.size()) * Eigen::MatrixXd::Identity(count, count);
  const Eigen::MatrixXd inverse = normal.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  DeletedResiduals deleted{PatchValues(frames, residuals.cols()), Eigen::VectorXd(frames)};
  parallel_for(static_cast<int>(frames), default_threads(), [&](int first, int last) {
    std::vector<Eigen::Index> near;
    for (Eigen::Index i = first; i < last; ++i) {
      near.clear();
      for (const Eigen::Index j : rows)
        if (std::abs(numbers[static_cast<std::size_t>(j)] - numbers[static_cast<std::size_t>(i)]) <=
            gap)
          near.push_back(j);
      Eigen::RowVectorXf left = residuals.row(i);
      deleted.leverage[i] = terms.row(i).dot(inverse * terms.row(i).transpose());
      if (!near.empty()) {
        // With A the normal matrix, B the terms of `near`, H = B A^-1 B' and h = B A^-1 b: the fit
        // without them changes at b by -h' (I - H)^-1 r, and its variance is b' A^-1 b + h' (I -
        // H)^-1 h (Sherman, Morrison and Woodbury).
        const Eigen::MatrixXd b = terms(near, Eigen::all);
        const Eigen::MatrixXd solved = inverse * b.transpose();
        const auto size = static_cast<Eigen::Index>(near.size());
        const Eigen::MatrixXd rest =
            (1.0 + kRidge) * Eigen::MatrixXd::Identity(size, size) - b * solved;
        const Eigen::VectorXd h = solved.transpose() * terms.row(i).transpose();
        const Eigen::VectorXd weights = rest.ldlt().solve(h);
        deleted.leverage[i] += h.dot(weights);
        for (Eigen::Index k = 0; k < size; ++k) {
          const auto weight = static_cast<float>(weights[k]);
          const auto other = residuals.row(near[static_cast<std::size_t>(k)]);
          left += other.array().isFinite().select(weight * other, 0.0F);
        }
      }
      deleted.values.row(i) = left;
    }
  });
  return deleted;
}

}  // namespace alltact
