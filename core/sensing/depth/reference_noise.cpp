#include "core/sensing/depth/reference_noise.h"

#include "core/grey_range.h"
#include "core/numerics/image_noise.h"
#include "core/sensing/reference/grey_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace alltact {

std::optional<double> noise_against_reference(const cv::Mat& grey,
                                              const ReferenceImage& reference,
                                              double noise_gain,
                                              const FaceRuns& face) {
  CV_Assert(grey.type() == CV_8UC1 && grey.size() == reference.size());
  constexpr int kRows = 48;                   // are enough
  std::array<std::int64_t, 129> histogram{};  // noise of up to 12 grey levels in both images
  ReferenceImage::Reader reader(reference);
  const int first_row = face.runs.empty() ? 0 : face.runs.front().row,
            end_row = face.runs.empty() ? 0 : face.runs.back().row + 1;
  const int step = std::max(1, (end_row - first_row) / kRows);
  for (int v = first_row + step / 2; v < end_row; v += step) {
    const auto runs = face.of_row(v);
    if (runs.empty()) continue;
    const std::int16_t* untouched = reader.row(v, runs);
    const auto* live = grey.ptr<std::uint8_t>(v);
    const auto is_usable = [&](int u) {
      return live[u] >= kTooDarkBelow && live[u] < kClippedFrom &&
             untouched[u] >= kTooDarkBelow * kGreySteps && untouched[u] < kClippedFrom * kGreySteps;
    };
    const auto off = [&](int u) { return live[u] * kGreySteps - untouched[u]; };
    for (const FaceRun& run : runs) {
      int usable = 0;  // usable pixels in a row
      for (int u = run.first; u < run.end; ++u) {
        usable = is_usable(u) ? usable + 1 : 0;
        if (usable < 3) continue;
        const int steps = std::abs(off(u - 2) - 2 * off(u - 1) + off(u));
        const auto levels = static_cast<std::size_t>((steps + kGreySteps / 2) / kGreySteps);
        if (levels < histogram.size()) ++histogram[levels];
      }
    }
  }
  const auto sd = sd_of_differences(histogram);
  if (!sd) return std::nullopt;
  return std::max(*sd / std::sqrt(6.0 * (1.0 + noise_gain * noise_gain)), std::sqrt(1.0 / 12.0));
}

}  // namespace alltact
