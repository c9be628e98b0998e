#include "calibration/reference/contact_search.h"

#include "calibration/reference/skin_brightness.h"
#include "core/numerics/median.h"
#include "core/numerics/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Dense>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

struct Spot {
  double lower = 0;           ///< than its surroundings, at its lowest
  Eigen::Vector2d centre_px;  ///< its middle: column, row
  double area_mm2 = 0;
};

struct SpotSearch {
  Eigen::Vector2d mm_per_px;  ///< along columns, along rows
  /// false: regions higher than their surroundings by 0.03, and 4 mm around them, are excluded
  bool near_higher = true;
};

constexpr double kSpotPatchMm = 1.5;
constexpr double kSurroundingsMm = 12.0;
constexpr float kMinLower = 0.03F;  // of brightness: about 0.1 mm of a typical layer
constexpr float kSpotSigmas = 8.0F;
constexpr double kMinMm2 = 1.0, kMaxMm2 = 150.0;
constexpr double kSpotRimMm = 4.0;  // around a contact

cv::Size window(double mm, const Eigen::Vector2d& mm_per_px) {
  const auto window_px = [](double px) { return 2 * std::max(1, static_cast<int>(px / 2)) + 1; };
  return {window_px(mm / mm_per_px.x()), window_px(mm / mm_per_px.y())};
}

/// Means over windows of the known part; NaN where that is less than `least` of the window.
cv::Mat means(const cv::Mat& x, const cv::Mat& known, const cv::Size& window, double least) {
  cv::Mat filled = x.clone(), weight, sum, count;
  filled.setTo(0.0F, ~known);
  known.convertTo(weight, CV_32F, 1.0 / 255);
  cv::boxFilter(filled, sum, CV_32F, window, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::boxFilter(weight, count, CV_32F, window, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::Mat mean = sum / cv::max(count, 1e-6);
  mean.setTo(std::numeric_limits<float>::quiet_NaN(), (count < least) | ~known);
  return mean;
}

float median_magnitude(const cv::Mat& x) {
  std::vector<float> magnitudes;
  for (int v = 0; v < x.rows; v += 2)
    for (int u = 0; u < x.cols; u += 2)
      if (const float value = x.at<float>(v, u); std::isfinite(value))
        magnitudes.push_back(std::abs(value));
  return magnitudes.empty() ? 0.0F : upper_median(magnitudes);
}

cv::Mat contrast(const cv::Mat& x, const cv::Mat& known, const Eigen::Vector2d& mm_per_px) {
  constexpr double kMostOfPatch = 0.5, kSomeOfSurroundings = 0.15;
  return means(x, known, window(kSpotPatchMm, mm_per_px), kMostOfPatch) -
         means(x, known, window(kSurroundingsMm, mm_per_px), kSomeOfSurroundings);
}

std::optional<Spot> lowest_spot(const cv::Mat& x, const cv::Mat& known,
                                const Eigen::Vector2d& mm_per_px) {
  const cv::Mat higher = contrast(x, known, mm_per_px);
  const float limit = std::max(kMinLower, kSpotSigmas * 1.4826F * median_magnitude(higher));
  cv::Mat labels, stats, middles;
  const int count =
      cv::connectedComponentsWithStats(higher < -0.5F * limit, labels, stats, middles);
  std::optional<Spot> found;
  for (int label = 1; label < count; ++label) {
    const double area_mm2 = stats.at<int>(label, cv::CC_STAT_AREA) * mm_per_px.prod();
    if (area_mm2 < kMinMm2 || area_mm2 > kMaxMm2) continue;
    double least = 0;
    cv::minMaxLoc(higher, &least, nullptr, nullptr, nullptr, labels == label);
    if (-least < static_cast<double>(limit) || (found && -least < found->lower)) continue;
    found = Spot{-least, {middles.at<double>(label, 0), middles.at<double>(label, 1)}, area_mm2};
  }
  return found;
}

/// The lowest spot of `x` (CV_32F) of 1 to 150 mm^2 that is below its surroundings by 0.03 and by 8
/// robust standard deviations, each averaged over 1.5 mm. known: CV_8UC1, not 0 where x counts.
std::optional<Spot> find_spot(const cv::Mat& x, const cv::Mat& known, const SpotSearch& search) {
  if (search.near_higher) return lowest_spot(x, known, search.mm_per_px);
  const cv::Mat lower = contrast(x, known, search.mm_per_px) <= kMinLower;
  cv::Mat higher_px;
  cv::distanceTransform(lower | ~known, higher_px, cv::DIST_L2, 3);
  const double rim_px = kSpotRimMm / std::sqrt(search.mm_per_px.prod());
  return lowest_spot(x, known & (higher_px > rim_px), search.mm_per_px);
}

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// Chosen on seeds 1 to 120 of tests/support/contact_recording.h, and on clean ones.
constexpr float kSigmas = 9.0F;  // of a single frame's window; one more with each longer time
constexpr float kTail = 1.6F;    // times the brightest value: error of the fit itself
// sigmas that a frame must reach itself, independent of its neighbours
constexpr float kOwn = 2.5F;
constexpr float kOwnPart = 0.7F;    // of the mean over time that it must reach itself
constexpr float kDoubtful = 0.85F;  // strength
constexpr int kRounds = 6;
constexpr float kStrongest =
    0.3F;  // of the strongest: weaker ones wait until that has left the fit
constexpr double kMotionSds = 4.0;    // markers that far off the modes
constexpr float kMotionGain = 1.25F;  // make darkening count more

/// A column a window (by its middle patch), a row a frame.
using WindowValues = Eigen::MatrixXf;

/// Means over square windows of `side` patches, weighted by each patch's precision; NaN where less
/// than half of a window is known.
WindowValues window_means(const SkinPatches& patches, const PatchValues& off,
                          const std::vector<float>& sd, int side) {
  const int along = patches.along, across = patches.across, half = side / 2;
  std::vector<double> weight(sd.size());
  constexpr float kLeast = 0.003F;
  for (std::size_t p = 0; p < sd.size(); ++p) {
    const auto least = static_cast<double>(std::max(kLeast, sd[p]));
    weight[p] = 1e-6 / (least * least);
  }
  WindowValues means(off.rows(), off.cols());
  parallel_for(static_cast<int>(off.rows()), default_threads(), [&](int first, int last) {
    const auto size = static_cast<std::size_t>((std::ptrdiff_t{along} + 1) * (across + 1));
    std::vector<double> sum(size, 0.0), known(size, 0.0), all(size, 0.0);
    const auto at = [&](int i, int j) {
      return static_cast<std::size_t>(std::ptrdiff_t{i} * (across + 1) + j);
    };
    for (Eigen::Index frame = first; frame < last; ++frame) {
      const float* row = off.row(frame).data();
      for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j) {
          const auto p = static_cast<std::size_t>(std::ptrdiff_t{i} * across + j);
          const double w = weight[p], is_known = std::isfinite(row[p]) ? w : 0.0;
          const double value = is_known > 0 ? w * static_cast<double>(row[p]) : 0.0;
          const auto add = [&](std::vector<double>& s, double x) {
            s[at(i + 1, j + 1)] = x + s[at(i, j + 1)] + s[at(i + 1, j)] - s[at(i, j)];
          };
          add(sum, value);
          add(known, is_known);
          add(all, w);
        }
      for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j) {
          const int a = std::max(0, i - half), b = std::min(along, i + half + 1),
                    c = std::max(0, j - half), d = std::min(across, j + half + 1);
          const auto over = [&](const std::vector<double>& s) {
            return s[at(b, d)] - s[at(a, d)] - s[at(b, c)] + s[at(a, c)];
          };
          const double w = over(known);
          means(frame, i * across + j) =
              w > 0 && w >= 0.5 * over(all) ? static_cast<float>(over(sum) / w) : kNaN;
        }
    }
  });
  return means;
}

/// Means over `half` frames before and after.
WindowValues smoothed_in_time(const WindowValues& values, int half) {
  if (half == 0) return values;
  WindowValues smooth(values.rows(), values.cols());
  const Eigen::Index frames = values.rows();
  parallel_for(static_cast<int>(values.cols()), default_threads(), [&](int first, int last) {
    std::vector<double> sum(static_cast<std::size_t>(frames) + 1, 0.0);
    std::vector<int> count(sum.size(), 0);
    for (Eigen::Index p = first; p < last; ++p) {
      for (Eigen::Index i = 0; i < frames; ++i) {
        const float x = values(i, p);
        const bool known = std::isfinite(x);
        const auto k = static_cast<std::size_t>(i);
        sum[k + 1] = sum[k] + (known ? static_cast<double>(x) : 0.0);
        count[k + 1] = count[k] + known;
      }
      for (Eigen::Index i = 0; i < frames; ++i) {
        const auto a = static_cast<std::size_t>(std::max<Eigen::Index>(0, i - half)),
                   b = static_cast<std::size_t>(std::min(frames, i + half + 1));
        const int n = count[b] - count[a];
        smooth(i, p) = n > half ? static_cast<float>((sum[b] - sum[a]) / n) : kNaN;
      }
    }
  });
  return smooth;
}

/// Typical values of a window: by its middle patch.
struct Typical {
  std::vector<float> middle, sd, brightest;
};

Typical typical_values(const WindowValues& values, const std::vector<char>& without,
                       const Eigen::VectorXf& factor, bool one_sided) {
  const auto count = static_cast<std::size_t>(values.cols());
  Typical typical{std::vector<float>(count, 0.0F), std::vector<float>(count, kNaN),
                  std::vector<float>(count, 0.0F)};
  parallel_for(static_cast<int>(values.cols()), default_threads(), [&](int first, int last) {
    std::vector<float> known;
    for (Eigen::Index p = first; p < last; ++p) {
      known.clear();
      for (Eigen::Index i = 0; i < values.rows(); ++i) {
        const float x = values(i, p) / factor[i];
        if (!without[static_cast<std::size_t>(i)] && std::isfinite(x) && (!one_sided || x > 0))
          known.push_back(x);
      }
      if (known.size() < 8) continue;
      auto from = known.begin();                // what is before is less
      const auto quantile = [&](double part) {  // of ascending parts
        const auto it = known.begin() +
                        static_cast<std::ptrdiff_t>(part * (static_cast<double>(known.size()) - 1));
        std::nth_element(from, it, known.end());
        from = it;
        return *it;
      };
      const auto k = static_cast<std::size_t>(p);
      constexpr float kLeast = 2e-4F;
      if (one_sided) {
        typical.sd[k] = std::max(kLeast, 1.4826F * quantile(0.5));
        typical.brightest[k] = quantile(1.0);
      } else {
        const float middle = quantile(0.5);
        typical.middle[k] = std::max(0.0F, middle);
        typical.sd[k] = std::max(kLeast, quantile(0.84) - middle);
        typical.brightest[k] = quantile(1.0) - middle;
      }
    }
  });
  return typical;
}

struct Scale {
  int side;            ///< patches
  float least_darker;  ///< smaller values are no contact
};

struct Rule {
  std::vector<Scale> scales;
  std::vector<int> half_times;  ///< frames
  float sigmas;                 ///< of single frames; one more with each longer time
  bool one_sided;
};

struct Seed {
  float strength = 0, darker = 0;
  int patch = -1, scale = -1, time = -1;
};

struct ScaleValues {
  WindowValues now, short_time;
  Typical typical_now, typical_short;
};

/// By frame: those nearest in pose at other times.
using NearPoses = std::vector<std::vector<Eigen::Index>>;

NearPoses near_poses(const Eigen::MatrixXd& modes, const std::vector<int>& numbers, int gap) {
  constexpr std::size_t kNear = 12;
  NearPoses near(numbers.size());
  parallel_for(static_cast<int>(numbers.size()), default_threads(), [&](int first, int last) {
    std::vector<std::pair<double, Eigen::Index>> others;
    for (int i = first; i < last; ++i) {
      const auto frame = static_cast<std::size_t>(i);
      others.clear();
      for (Eigen::Index j = 0; j < modes.rows(); ++j)
        if (std::abs(numbers[static_cast<std::size_t>(j)] - numbers[frame]) > gap)
          others.emplace_back((modes.row(j) - modes.row(i)).squaredNorm(), j);
      const std::size_t count = std::min(kNear, others.size());
      std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count),
                        others.end());
      for (std::size_t k = 0; k < count; ++k) near[frame].push_back(others[k].second);
    }
  });
  return near;
}

class Evidence {
 public:
  Evidence(const SkinPatches& patches, const PatchValues& off, const std::vector<float>& sd,
           const std::vector<char>& without, const Eigen::VectorXf& factor,
           const std::vector<char>& judged, const Rule& rule)
      : patches_(patches),
        factor_(factor),
        judged_(judged),
        seeds_(static_cast<std::size_t>(off.rows())) {
    for (std::size_t k = 0; k < rule.scales.size(); ++k) {
      ScaleValues values;
      values.now = window_means(patches, off, sd, rule.scales[k].side);
      for (std::size_t t = 0; t < rule.half_times.size(); ++t) {
        const WindowValues smooth = smoothed_in_time(values.now, rule.half_times[t]);
        const Typical typical = typical_values(smooth, without, factor, rule.one_sided);
        if (t == 0) values.typical_now = typical;
        search(smooth, typical, values, rule, static_cast<int>(k), static_cast<int>(t));
      }
      values.short_time = smoothed_in_time(values.now, 1);
      values.typical_short = typical_values(values.short_time, without, factor, rule.one_sided);
      scales_.push_back(std::move(values));
    }
  }
  [[nodiscard]] const std::vector<Seed>& seeds() const { return seeds_; }

  /// The skin is as dark there in nearly all frames of near pose at other times: the fit is wrong
  /// in this pose, which is no evidence against a frame.
  [[nodiscard]] bool is_of_the_pose(std::size_t frame, const NearPoses& near) const {
    constexpr std::size_t kMaxBrighter = 2;  // of twelve
    constexpr float kAsDark = 0.5F;
    const Seed& seed = seeds_[frame];
    if (seed.patch < 0) return false;
    const ScaleValues& values = scales_[static_cast<std::size_t>(seed.scale)];
    const float middle = values.typical_now.middle[static_cast<std::size_t>(seed.patch)];
    std::size_t compared = 0, brighter = 0;
    for (const Eigen::Index other : near[frame]) {
      const float darker = middle - values.now(other, seed.patch);
      if (!std::isfinite(darker)) continue;
      ++compared;
      brighter += darker < kAsDark * seed.darker;
    }
    return compared > 2 * kMaxBrighter && brighter <= kMaxBrighter;
  }

  /// Frames of the same contact: neighbours in time in which the seed's window, or the smallest
  /// window at its darkest position, is darker than noise.
  void grow(std::size_t from, std::vector<char>& in_contact) const {
    const Seed& seed = seeds_[from];
    const auto start = static_cast<std::ptrdiff_t>(from);
    const int darkest = darkest_within(scales_.front(), start, seed.patch, kLargestSide / 2);
    grow_at(scales_[static_cast<std::size_t>(seed.scale)], start, seed.patch, in_contact);
    grow_at(scales_.front(), start, darkest, in_contact);
  }

 private:
  static constexpr float kGrow = 2.5F;     // sigmas of three frames together
  static constexpr float kGrowNow = 1.0F;  // and of the frame itself
  // sigmas of a contact that is followed as it moves
  static constexpr float kFollow = 6.0F;
  static constexpr int kLargestSide = 9;            // patches
  static constexpr std::ptrdiff_t kMaxBeyond = 10;  // frames

  [[nodiscard]] static float darker_at(const ScaleValues& values, std::ptrdiff_t frame, int patch) {
    return values.typical_short.middle[static_cast<std::size_t>(patch)] -
           values.short_time(frame, patch);
  }

  void grow_at(const ScaleValues& values, std::ptrdiff_t from, int patch,
               std::vector<char>& in_contact) const {
    in_contact[static_cast<std::size_t>(from)] = 1;
    for (const int step : {-1, 1}) {
      auto last = from;
      int at = patch;
      std::vector<float> darker{
          std::max(0.0F, darker_at(values, from, patch))};  // from the seed on
      for (auto i = from + step; i >= 0 && i < std::ssize(in_contact); i += step) {
        const int here = darkest_within(values, i, at, 1);
        // Pure noise must not start a drift.
        if (sigmas(values.short_time, values.typical_short, i, here) > kFollow) at = here;
        const bool goes_on = sigmas(values.short_time, values.typical_short, i, at) > kGrow &&
                             sigmas(values.now, values.typical_now, i, at) > kGrowNow;
        if (goes_on) in_contact[static_cast<std::size_t>(i)] = 1;
        if (!goes_on) break;
        last = i;
        darker.push_back(darker_at(values, i, at));
      }
      // A slow fade continues below the noise.
      const float half = 0.5F * *std::max_element(darker.begin(), darker.end());
      const auto faded =
          std::find_if(darker.rbegin(), darker.rend(), [&](float x) { return x >= half; }) -
          darker.rbegin();
      const auto beyond = std::min<std::ptrdiff_t>(kMaxBeyond, (faded + 2) / 4);
      for (auto i = last + step, n = beyond; n > 0 && i >= 0 && i < std::ssize(in_contact);
           i += step, --n)
        in_contact[static_cast<std::size_t>(i)] = 1;
    }
  }
  [[nodiscard]] float sigmas(const WindowValues& values, const Typical& typical,
                             std::ptrdiff_t frame, int patch) const {
    const auto k = static_cast<std::size_t>(patch);
    return (typical.middle[k] - values(frame, patch)) / (typical.sd[k] * factor_[frame]);
  }
  [[nodiscard]] int darkest_within(const ScaleValues& values, std::ptrdiff_t frame, int patch,
                                   int reach) const {
    int darkest = patch;
    float most = sigmas(values.short_time, values.typical_short, frame, patch);
    const int i0 = patch / patches_.across, j0 = patch % patches_.across;
    for (int i = std::max(0, i0 - reach); i <= std::min(patches_.along - 1, i0 + reach); ++i)
      for (int j = std::max(0, j0 - reach); j <= std::min(patches_.across - 1, j0 + reach); ++j) {
        const int p = i * patches_.across + j;
        const float z = sigmas(values.short_time, values.typical_short, frame, p);
        if (z > most) most = z, darkest = p;
      }
    return darkest;
  }
  void search(const WindowValues& values, const Typical& typical, const ScaleValues& single,
              const Rule& rule, int scale, int time) {
    const float least = rule.scales[static_cast<std::size_t>(scale)].least_darker;
    const float sigmas = rule.sigmas + static_cast<float>(time);
    parallel_for(static_cast<int>(values.rows()), default_threads(), [&](int first, int last) {
      for (Eigen::Index p = 0; p < values.cols(); ++p) {
        const auto k = static_cast<std::size_t>(p);
        if (!std::isfinite(typical.sd[k])) continue;
        const float limit = std::max(sigmas * typical.sd[k], kTail * typical.brightest[k]);
        for (Eigen::Index i = first; i < last; ++i) {
          if (!judged_[static_cast<std::size_t>(i)]) continue;
          const float darker = typical.middle[k] - values(i, p);
          const float strength = std::min(darker / least, darker / (limit * factor_[i]));
          Seed& seed = seeds_[static_cast<std::size_t>(i)];
          if (time > 0) {
            const float own = single.typical_now.middle[k] - single.now(i, p);
            if (!(own > kOwn * single.typical_now.sd[k] * factor_[i]) || own < kOwnPart * darker)
              continue;
          }
          if (strength > seed.strength) seed = {strength, darker, static_cast<int>(p), scale, time};
        }
      }
    });
  }

  const SkinPatches& patches_;
  const Eigen::VectorXf& factor_;
  const std::vector<char>& judged_;
  std::vector<Seed> seeds_;
  std::vector<ScaleValues> scales_;
};

std::size_t count_of(const std::vector<char>& flags) {
  return static_cast<std::size_t>(
      std::count_if(flags.begin(), flags.end(), [](char f) { return f != 0; }));
}

/// By frame: distance of its markers from the modes, in robust standard deviations of the others.
Eigen::VectorXd motion_sds(const Eigen::VectorXd& off_px, const std::vector<char>& without) {
  Eigen::VectorXd sds = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(without.size()));
  if (off_px.size() != sds.size()) return sds;
  std::vector<double> typical;
  for (Eigen::Index i = 0; i < off_px.size(); ++i)
    if (!without[static_cast<std::size_t>(i)]) typical.push_back(off_px[i]);
  const double middle = upper_median(typical);
  for (double& value : typical) value = std::abs(value - middle);
  constexpr double kLeastPx = 0.02;
  const double sd = std::max(kLeastPx, 1.4826 * upper_median(typical));
  return (off_px.array() - middle) / sd;
}

class Search {
 public:
  Search(const SkinPatches& patches, const Eigen::MatrixXd& modes,
         const Eigen::VectorXd& motion_off_px, const std::vector<int>& numbers)
      : patches_(patches),
        coarse_(coarser_patches(patches)),
        numbers_(numbers),
        motion_off_px_(motion_off_px),
        terms_(pose_terms_of(modes)),
        count_(static_cast<std::size_t>(patches.frames())),
        gap_(std::max(kLeastGap, (numbers.back() - numbers.front() + 1) / kGapPart)),
        near_(near_poses(modes, numbers, gap_)),
        in_contact_(count_, 0),
        judged_(count_, 0) {}

  std::vector<FrameEvidence> operator()() {
    std::vector<char> without(count_, 0);
    PoseBrightness gross(coarse_, terms_);
    remove_gross(gross, without);
    PoseBrightness fine(patches_, terms_);
    fine.set_light_of(gross);
    for (int round = 0; round < kRounds; ++round) {
      judge(fine, without);
      if (in_contact_ == without) break;
      without = in_contact_;
    }
    return result();
  }

 private:
  static constexpr int kGapPart = 12, kLeastGap = 3;  // of the recording; frames

  /// Clear contacts leave the fit, the strongest first. Other dark frames are left out of the first
  /// exact fit, which decides on them.
  void remove_gross(PoseBrightness& fit, std::vector<char>& without) {
    const Rule clear{{{1, 0.025F}, {3, 0.018F}}, {0}, 8.0F, true};
    const Rule suspect{{{1, 0.012F}, {3, 0.007F}}, {0, 2}, 5.0F, true};
    const Eigen::VectorXf even = Eigen::VectorXf::Ones(patches_.frames());
    const std::vector<char> all(count_, 1);
    fit.fit_one_sided(without, true);
    fit.fit_light();
    for (int round = 0; round < kRounds; ++round) {
      fit.fit_one_sided(without, round == 0);
      fit.fit_light();
      const Evidence evidence(coarse_, fit.residuals(), fit.sd(), without, even, all, clear);
      if (round == 0) note_darker(evidence);
      const float most = strongest(evidence, without);
      if (most < 1) break;
      for (std::size_t i = 0; i < count_; ++i)
        if (evidence.seeds()[i].strength > std::max(1.0F, kStrongest * most) &&
            !evidence.is_of_the_pose(i, near_))
          without[i] = 1;
    }
    // More than half of the frames darker than the rest: the fit is wrong over these poses.
    if (2 * count_of(without) > count_) {
      std::fill(without.begin(), without.end(), 0);
      fit.fit_with_light(without);
      return;
    }
    const Evidence evidence(coarse_, fit.residuals(), fit.sd(), without, even, all, suspect);
    std::vector<char> suspects = without;
    for (std::size_t i = 0; i < count_; ++i)
      if (evidence.seeds()[i].strength > 1 && !evidence.is_of_the_pose(i, near_)) suspects[i] = 1;
    // An inaccurate pose may be the reason for so many.
    if (count_of(suspects) < count_ - std::max<std::size_t>(kMinFittedFrames, count_ / 4))
      without = suspects;
  }
  /// Of a fit from the bright side.
  void note_darker(const Evidence& evidence) {
    for (std::size_t i = 0; i < count_; ++i)
      darker_[i] = static_cast<char>(evidence.seeds()[i].strength > 1);
  }
  [[nodiscard]] float strongest(const Evidence& evidence, const std::vector<char>& without) const {
    float most = 0;
    for (std::size_t i = 0; i < without.size(); ++i)
      if (!without[i] && !evidence.is_of_the_pose(i, near_))
        most = std::max(most, evidence.seeds()[i].strength);
    return most;
  }

  /// Compares every frame with the fit over the others at other times. A frame whose pose those do
  /// not cover is compared with a fit over all compared frames, also shortly before and after it.
  void judge(PoseBrightness& fine, const std::vector<char>& without) {
    fine.fit_with_light(without);
    DeletedResiduals left = deleted_residuals(fine.residuals(), terms_, without, numbers_, gap_);
    std::vector<char> out = without;
    for (std::size_t i = 0; i < count_; ++i) {
      judged_[i] =
          static_cast<char>(left.leverage[static_cast<Eigen::Index>(i)] < kMaxPoseLeverage);
      if (!judged_[i]) out[i] = 1;
    }
    if (count_of(judged_) < count_ && count_of(out) + kMinFittedFrames < count_) {
      fine.fit_with_light(out);
      const DeletedResiduals second =
          deleted_residuals(fine.residuals(), terms_, out, numbers_, -1);
      for (std::size_t k = 0; k < count_; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        if (judged_[k]) continue;
        left.values.row(i) = second.values.row(i);
        left.leverage[i] = second.leverage[i];
        judged_[k] = static_cast<char>(second.leverage[i] < kMaxPoseLeverage);
      }
    }
    const Rule rule{{{3, 0.010F}, {5, 0.007F}, {9, 0.005F}}, {0, 2, 6}, kSigmas, false};
    const Eigen::VectorXf factor = (1.0 + left.leverage.array()).sqrt().cast<float>();
    const Evidence evidence(patches_, left.values, fine.sd(), out, factor, judged_, rule);
    seeds_ = evidence.seeds();
    motion_sds_ = motion_sds(motion_off_px_, without);
    for (std::size_t i = 0; i < count_; ++i)
      if (motion_sds_[static_cast<Eigen::Index>(i)] > kMotionSds) seeds_[i].strength *= kMotionGain;
    const float most = strongest(evidence, without);
    std::fill(in_contact_.begin(), in_contact_.end(), 0);
    for (std::size_t i = 0; i < count_; ++i) {
      const bool waits =
          !without[i] && most > 1.0F / kStrongest && seeds_[i].strength < kStrongest * most;
      is_of_the_pose_[i] = static_cast<char>(evidence.is_of_the_pose(i, near_));
      if (seeds_[i].strength >= 1 && !waits && !is_of_the_pose_[i]) evidence.grow(i, in_contact_);
    }
  }

  /// Frames clearly darker than the brightest of near pose, without another result.
  void mark_unexplained(std::vector<FrameEvidence>& frames) const {
    constexpr std::size_t kFewPart = 10;
    std::vector<std::size_t> unexplained;
    for (std::size_t i = 0; i < count_; ++i) {
      const FrameContact contact = frames[i].contact;
      if (darker_[i] && (contact == FrameContact::kClean || contact == FrameContact::kUncompared))
        unexplained.push_back(i);
    }
    if (kFewPart * unexplained.size() <= count_) return;
    for (const std::size_t i : unexplained) frames[i].contact = FrameContact::kUnexplained;
  }

  [[nodiscard]] std::vector<FrameEvidence> result() const {
    std::vector<FrameEvidence> frames(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      FrameEvidence& frame = frames[i];
      const Seed& seed = seeds_[i];
      frame.strength = static_cast<double>(seed.strength);
      frame.darker = static_cast<double>(seed.darker);
      if (seed.patch >= 0)
        frame.along_mm = patches_.s_mm(seed.patch), frame.across_mm = patches_.y_mm(seed.patch);
      frame.motion_sd = motion_sds_[static_cast<Eigen::Index>(i)];
      frame.contact = in_contact_[i]               ? FrameContact::kContact
                      : !judged_[i]                ? FrameContact::kUncompared
                      : is_of_the_pose_[i]         ? FrameContact::kClean
                      : seed.strength >= kDoubtful ? FrameContact::kDoubtful
                                                   : FrameContact::kClean;
    }
    mark_unexplained(frames);
    return frames;
  }

  const SkinPatches& patches_;
  SkinPatches coarse_;
  const std::vector<int>& numbers_;
  const Eigen::VectorXd& motion_off_px_;
  Eigen::MatrixXd terms_;
  std::size_t count_;
  int gap_;
  NearPoses near_;
  std::vector<char> darker_ = std::vector<char>(count_, 0);
  std::vector<char> in_contact_, judged_, is_of_the_pose_ = std::vector<char>(count_, 0);
  std::vector<Seed> seeds_;
  Eigen::VectorXd motion_sds_;
};

}  // namespace

std::vector<ContactStretch> stretches_of(const std::vector<FrameEvidence>& frames) {
  std::vector<ContactStretch> stretches;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FrameEvidence& frame = frames[i];
    if (frame.contact == FrameContact::kClean) continue;
    const bool goes_on = !stretches.empty() && stretches.back().last + 1 == i &&
                         stretches.back().contact == frame.contact;
    if (!goes_on) stretches.push_back({i, i, frame.contact, i});
    ContactStretch& stretch = stretches.back();
    stretch.last = i;
    if (frame.strength > frames[stretch.darkest].strength) stretch.darkest = i;
  }
  return stretches;
}

std::vector<FrameEvidence> find_contacts(const SkinPatches& patches, const Eigen::MatrixXd& modes,
                                         const Eigen::VectorXd& motion_off_px,
                                         const std::vector<int>& numbers) {
  if (patches.frames() < kMinFittedFrames)
    return std::vector<FrameEvidence>(static_cast<std::size_t>(patches.frames()));
  return Search(patches, modes, motion_off_px, numbers)();
}

namespace {

constexpr int kMinCompared = 16;  // frames of the recording

/// Residuals of the recording's frames at poses that the earlier rows cover; NaN elsewhere.
PatchValues left_of(const SkinPatches& patches, const Eigen::MatrixXd& modes, int recorded) {
  const Eigen::MatrixXd terms = pose_terms_of(modes);
  std::vector<char> without(static_cast<std::size_t>(patches.frames()), 0);
  std::fill(without.begin(), without.begin() + recorded, 1);
  PoseBrightness fit(patches, terms);
  fit.fit_with_light(without);
  fit.fit_light();
  const std::vector<int> numbers(without.size());  // unused without a gap
  DeletedResiduals left = deleted_residuals(fit.residuals(), terms, without, numbers, -1);
  for (int i = 0; i < recorded; ++i)
    if (!(left.leverage[i] < kMaxPoseLeverage))
      left.values.row(i).setConstant(std::numeric_limits<float>::quiet_NaN());
  return left.values.topRows(recorded);
}

/// By patch, a row for each position along the face; NaN where too few frames have a value.
cv::Mat medians_of(const PatchValues& left, const SkinPatches& patches) {
  cv::Mat medians(patches.along, patches.across, CV_32FC1, cv::Scalar(0));
  std::vector<float> known;
  for (int p = 0; p < patches.count(); ++p) {
    known.clear();
    for (Eigen::Index i = 0; i < left.rows(); ++i)
      if (std::isfinite(left(i, p))) known.push_back(left(i, p));
    medians.at<float>(p / patches.across, p % patches.across) =
        static_cast<int>(known.size()) < kMinCompared ? std::numeric_limits<float>::quiet_NaN()
                                                      : upper_median(known);
  }
  return medians;
}

}  // namespace

std::optional<PersistentContact> find_persistent_contact(const SkinPatches& patches,
                                                         const Eigen::MatrixXd& modes,
                                                         int recorded) {
  if (patches.frames() - recorded < kMinFittedFrames) return std::nullopt;
  const PatchValues left = left_of(patches, modes, recorded);
  const cv::Mat medians = medians_of(left, patches);
  const cv::Mat known = medians == medians;
  const auto spot = find_spot(medians, known, {.mm_per_px = {patches.across_mm, patches.along_mm}});
  if (!spot) return std::nullopt;
  PersistentContact touch;
  touch.darker = spot->lower;
  touch.along_mm = patches.begin_mm + (spot->centre_px.y() + 0.5) * patches.along_mm;
  touch.across_mm = (spot->centre_px.x() + 0.5) * patches.across_mm - 0.5 * patches.width_mm;
  const auto patch = static_cast<Eigen::Index>(std::lround(spot->centre_px.y()) * patches.across +
                                               std::lround(spot->centre_px.x()));
  float darkest = 0;
  for (int i = 0; i < recorded; ++i) {
    const float off = left(i, patch);
    touch.frames += off < -0.5 * spot->lower;
    if (off < darkest) darkest = off, touch.darkest = i;
  }
  return touch;
}

namespace {

// next to the face's edges a shift of a tenth of a pixel is visible
constexpr double kEdgePx = 4.0;

/// 255 in columns of the face, away from its edges, where x is known.
cv::Mat inner_face(const cv::Mat& x, const FaceShape& shape) {
  cv::Mat inner(x.size(), CV_8UC1, cv::Scalar(0));
  for (int u = 0; u < x.cols; ++u) {
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
    if (!column.valid) continue;
    const int first = std::max(0, static_cast<int>(std::ceil(column.upper_v + kEdgePx))),
              last = std::min(x.rows - 1, static_cast<int>(column.lower_v - kEdgePx));
    for (int v = first; v <= last; ++v)
      if (std::isfinite(x.at<float>(v, u))) inner.at<std::uint8_t>(v, u) = 255;
  }
  return inner;
}

}  // namespace

std::optional<ReferenceSuspect> find_reference_suspect(const Difference& difference,
                                                       const FaceShape& shape) {
  if (difference.x.empty()) return std::nullopt;
  std::vector<double> depths;
  for (const FaceColumn& column : shape.columns())
    if (column.valid) depths.push_back(column.z_mm);
  if (depths.empty()) return std::nullopt;
  const double mm_per_px = shape.camera().mm_per_px_at(upper_median(depths));
  const auto spot = find_spot(difference.x, inner_face(difference.x, shape),
                              {.mm_per_px = {mm_per_px, mm_per_px}, .near_higher = false});
  if (!spot) return std::nullopt;
  const Eigen::Vector2d position_mm = shape.position_mm(spot->centre_px.x(), spot->centre_px.y());
  return ReferenceSuspect{spot->lower, position_mm.x(), position_mm.y(), spot->area_mm2, 0};
}

Message sentence_of(const ReferenceSuspect& suspect) {
  return en::say(
      "the face is {:.0f} % brighter than its reference {:.0f} mm from the base: something pressed "
      "there when the reference was recorded, near its frame {}; record the reference again",
      100.0 * suspect.brighter, suspect.along_mm, suspect.frame);
}

}  // namespace alltact
