// How noisy the picture of a face is, told by what it differs from its reference.
#pragma once

#include "core/sensing/face/face_runs.h"
#include "core/sensing/reference/reference_picture.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// Standard deviation of the noise of one picture, grey levels. With D = I - I_ref on the face,
///   sd^2 = var(D(u - 1) - 2 D(u) + D(u + 1)) / (6 (1 + noise_gain^2)),
/// from some rows. Light, contacts and their smooth slopes leave second differences alone, and what
/// is engraved in or printed on the skin is in the reference, too; differences beyond 3 sd (rims,
/// dirt) do not count, nor do pixels that are clipped or too dark (grey_range.h) in either picture.
/// At least that of quantisation, 1/sqrt(12). What the pictures' noise has in common (neighbouring
/// pixels after compression) is not seen: LightGain::noise_ratio tells that.
/// nullopt: fewer than 100 differences qualify. grey: CV_8UC1 of the reference's size. noise_gain:
/// the reference's noise against that of one picture, >= 0.
[[nodiscard]] std::optional<double> noise_against_reference(const cv::Mat& grey,
                                                            const ReferencePicture& reference,
                                                            double noise_gain,
                                                            const FaceRuns& face);

}  // namespace alltact
