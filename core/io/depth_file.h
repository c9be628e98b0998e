// Depth on disk: exact, or as integer micrometres in a fraction of the space.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>
#include <string_view>

#include <opencv2/core.hpp>

namespace alltact {

/// Depth in 16 bits: depth_mm = kDepthStep_mm (value - kDepthZero), 0 where there is none. The
/// range is -9.999 to 55.535 mm; values beyond (no layer is so thick) are clamped. Rounding adds
/// 0.3 um rms, a thirtieth of a calibrated finger's noise per pixel.
inline constexpr double kDepthStep_mm = 0.001;
inline constexpr int kDepthZero = 10000;
/// The same formula as text for files.
inline constexpr std::string_view kDepthSentence = "depth_mm = 0.001 * (value - 10000); 0: none";

/// CV_32FC1 in mm, NaN where there is none, to CV_16UC1 and back.
[[nodiscard]] cv::Mat depth_steps(const cv::Mat& depth_mm);
[[nodiscard]] cv::Mat depth_of_steps(const cv::Mat& steps);

/// A PNG file of CV_8UC1 or CV_16UC1. `keyword` and `text` (Latin-1) are stored as a tEXt chunk
/// (PNG, third edition, 11.3.3.2) unless the text is empty.
[[nodiscard]] std::string grey_png(const cv::Mat& grey,
                                   std::string_view keyword = {},
                                   std::string_view text = {});
/// The PNG of depth_steps(), with kDepthSentence as text.
[[nodiscard]] std::string depth_png(const cv::Mat& depth_mm);
/// A float TIFF of CV_32FC1, exact: deflate behind the floating-point predictor (Adobe Photoshop
/// TIFF Technical Note 3), which libtiff, OpenCV, MATLAB and ImageJ read.
[[nodiscard]] std::string depth_tiff(const cv::Mat& depth_mm);

/// Reads a file of depth_png(), CV_32FC1 in mm. Errors: missing, damaged, no 16-bit grey PNG, or
/// one without the text for depth.
[[nodiscard]] Result<cv::Mat> read_depth_png(const std::filesystem::path& file);

/// The depth of a frame among the results in `folder`: NAME.depth.tiff, else NAME.depth16.png.
/// Error: neither exists, or it cannot be read.
[[nodiscard]] Result<cv::Mat> read_frame_depth(const std::filesystem::path& folder,
                                               const std::string& name);

}  // namespace alltact
