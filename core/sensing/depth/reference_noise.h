// Noise of a face's image, estimated from its difference to the reference.
#pragma once

#include "core/sensing/face/face_runs.h"
#include "core/sensing/reference/reference_image.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// Standard deviation of the noise of one image, grey levels. With D = I - I_ref on the face,
///   sd^2 = var(D(u - 1) - 2 D(u) + D(u + 1)) / (6 (1 + noise_gain^2)),
/// from some rows. Light, contacts and their smooth slopes do not affect second differences, and
/// engravings or prints on the skin are in the reference, too. Differences beyond 3 sd (rims, dirt)
/// are ignored, and so are pixels that are clipped or too dark (grey_range.h) in either image. The
/// result is at least that of quantisation, 1/sqrt(12). Noise that neighbouring pixels share after
/// compression is not included: see LightGain::noise_ratio.
/// nullopt: fewer than 100 differences qualify. grey: CV_8UC1 of the reference's size. noise_gain:
/// the reference's noise relative to that of one image, >= 0.
[[nodiscard]] std::optional<double> noise_against_reference(const cv::Mat& grey,
                                                            const ReferenceImage& reference,
                                                            double noise_gain,
                                                            const FaceRuns& face);

}  // namespace alltact
