#include "core/sensing/contact/reference_free_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kPatchMm = 2.0;  // along the face; a ball of 4 mm pressed in 0.3 mm is 3 mm wide
constexpr int kPieces = 100;      // along
constexpr int kAcross = 12;
constexpr int kReach = 3;         // patches to each side that are the surroundings
constexpr double kRimPx = 4.0;    // at the edges a shift of a tenth of a pixel shows
constexpr double kEndMm = 5.0;    // of the face at both ends, where light ends with it
constexpr double kDarker = 0.05;  // about 0.2 mm of a typical layer
constexpr double kSigmas = 6.0;
constexpr double kDarkLearnt = 0.01;
constexpr int kMemory = 60;  // frames
constexpr int kMinPixels = 6;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// by piece and position across; NaN where the face is not seen
using Patches = std::vector<double>;

std::size_t at(int piece, int across) {
  return static_cast<std::size_t>(piece * kAcross + across);
}

Patches levels_of(const cv::Mat& grey, const FaceShape& shape) {
  std::vector<double> sum(kPieces * kAcross, 0.0);
  std::vector<int> count(sum.size(), 0);
  const double end_mm = std::max(shape.length_at(0), shape.length_at(shape.width_px() - 1));
  for (int u = 0; u < shape.width_px(); u += 2) {
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
    const double along_mm = shape.length_at(u);
    const int piece = static_cast<int>(along_mm / kPatchMm);
    if (!column.valid || piece >= kPieces || along_mm < kEndMm || along_mm > end_mm - kEndMm)
      continue;
    const auto rows = shape.rows(u, kRimPx);
    const double height = (column.lower_v - column.upper_v) / kAcross;
    for (int v = rows.first; v <= rows.last; v += 2) {
      const int across =
          std::clamp(static_cast<int>((v - column.upper_v) / height), 0, kAcross - 1);
      sum[at(piece, across)] += grey.at<std::uint8_t>(v, u);
      ++count[at(piece, across)];
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = count[i] >= kMinPixels ? std::log(std::max(1.0, sum[i] / count[i])) : kNaN;
  return sum;
}

/// Darkness of a patch against its surroundings on two opposite sides, so that an even change of
/// light cancels. Returns the smaller one of along and across the face.
double local_contrast(const Patches& levels, int piece, int across) {
  const double here = levels[at(piece, across)];
  double lowest = kNaN;
  for (const auto& [along_step, across_step] : {std::array{1, 0}, {0, 1}}) {
    double sum = 0;
    int sides = 0;
    for (const int side : {-kReach, kReach}) {
      const int p = piece + side * along_step, a = across + side * across_step;
      if (p < 0 || p >= kPieces || a < 0 || a >= kAcross || !std::isfinite(levels[at(p, a)]))
        continue;
      sum += levels[at(p, a)];
      ++sides;
    }
    if (sides == 2 && !(0.5 * sum - here < lowest)) lowest = 0.5 * sum - here;
  }
  return lowest;
}

}  // namespace

bool ReferenceFreeContactDetector::learn(Skin& skin, double now) {
  const double off = now - skin.typical;
  const double limit = std::max(kDarker, kSigmas * std::sqrt(skin.variance));
  if (skin.frames >= kFirstFrames && off > limit) return false;
  // A contact ended here.
  if (skin.frames >= kFirstFrames && off < -limit) skin = {};
  skin.frames = std::min(skin.frames + 1, kMemory);
  const double share = 1.0 / skin.frames;
  // Slowly increasing contacts must not be learnt. The variance is estimated from the bright side
  // alone, and the dark side changes the typical value only a little.
  if (skin.frames > 1 && off < 0) skin.variance += share * (off * off - skin.variance);
  skin.typical += share * (skin.frames > kFirstFrames ? std::min(off, kDarkLearnt) : off);
  return true;
}

std::optional<ReferenceFreeContact> ReferenceFreeContactDetector::operator()(
    const cv::Mat& grey, const FaceShape& shape) {
  CV_Assert(grey.type() == CV_8UC1 && grey.cols == shape.width_px());
  skin_.resize(kPieces * kAcross);
  ++frames_;
  const Patches levels = levels_of(grey, shape);
  std::optional<ReferenceFreeContact> contact;
  for (int piece = 0; piece < kPieces; ++piece)
    for (int across = 0; across < kAcross; ++across) {
      if (!std::isfinite(levels[at(piece, across)])) continue;
      const double now = local_contrast(levels, piece, across);
      if (!std::isfinite(now)) continue;
      Skin& skin = skin_[at(piece, across)];
      const double darker = now - skin.typical;
      if (learn(skin, now) || (contact && darker <= contact->darker)) continue;
      contact = ReferenceFreeContact{darker, (piece + 0.5) * kPatchMm};
    }
  return contact;
}

void ReferenceFreeContactDetector::forget() {
  skin_.clear();
  frames_ = 0;
}

}  // namespace alltact
