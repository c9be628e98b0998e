// Reading and writing of single images.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// What was assumed about images that belong together.
struct ImageLook {
  int bits = 0;         ///< in use of 16, by the brightest image so far; 0: none had 16
  int orientation = 0;  ///< that viewers are asked for (Exif); 0 and 1: as it is

  /// Without full stops.
  [[nodiscard]] std::vector<Message> remarks() const;
};

/// Reads an image as grey (CV_8UC1). A colour image of a scene in white light is converted to grey;
/// of 16 bits per pixel the upper 8 in use are taken. Missing, empty and truncated files are
/// refused, also where the decoder would silently fill them up. So are strong colours, float
/// images, black-and-white ones of 1 bit, transparency, and images with no pixel above 4 ("all
/// black"). Each error names the file. `note`: the text stored by write_image(); empty where there
/// is none. `look`: of the images before, too.
[[nodiscard]] Result<cv::Mat> read_grey_image(const std::filesystem::path& file,
                                              std::string* note = nullptr,
                                              ImageLook* look = nullptr);

/// Writes an image atomically (see atomic_file.h): PNG for CV_8UC1 or CV_8UC3, TIFF for CV_32FC1
/// and CV_32FC3 (no compression, so that any program reads it). The extension decides. Three
/// channels have their order with OpenCV and read_float_image(); in the file OpenCV writes the
/// last one first, so that readers of red, green, blue get them reversed. `note`: text to store in
/// the file; PNG only.
[[nodiscard]] Status write_image(const std::filesystem::path& file, const cv::Mat& image,
                                 std::string_view note = {});

/// Reads a float TIFF written by write_image (CV_32FC1 or CV_32FC3).
[[nodiscard]] Result<cv::Mat> read_float_image(const std::filesystem::path& file);

// A short text inside a PNG file.

/// A complete PNG file with `note` (UTF-8) as an iTXt chunk behind its header (PNG, third edition,
/// 11.3.3.4).
[[nodiscard]] std::string with_note(std::string_view png, std::string_view note);

/// The note of such a file; empty where it has none, or is no complete PNG.
[[nodiscard]] std::string note_of(std::string_view png);

// Depth on disk: exact, or as integer micrometres in a fraction of the space.

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
[[nodiscard]] std::string grey_png(const cv::Mat& grey, std::string_view keyword = {},
                                   std::string_view text = {});
/// The PNG of depth_steps(), with kDepthSentence as text.
[[nodiscard]] std::string depth_png(const cv::Mat& depth_mm);
/// Where the pixels of an image lie on a plane with axes in mm.
struct PixelsOnPlane {
  double step_mm = 1;                            ///< from pixel to pixel
  double first_column_mm = 0, first_row_mm = 0;  ///< of the middles of the first ones
};
/// A float TIFF of CV_32FC1, exact: deflate behind the floating-point predictor (Adobe Photoshop
/// TIFF Technical Note 3), which libtiff, OpenCV, MATLAB and ImageJ read. `plane`: the axes as
/// ImageJ stores them (pixels per mm, and the pixel of the origin in the description).
[[nodiscard]] std::string depth_tiff(const cv::Mat& depth_mm,
                                     const std::optional<PixelsOnPlane>& plane = {});

/// Reads a file of depth_png(), CV_32FC1 in mm. Errors: missing, damaged, no 16-bit grey PNG, or
/// one without the text for depth.
[[nodiscard]] Result<cv::Mat> read_depth_png(const std::filesystem::path& file);

/// The depth of a frame among the results in `folder`: NAME.depth.tiff, else NAME.depth16.png.
/// Error: neither exists, or it cannot be read.
[[nodiscard]] Result<cv::Mat> read_frame_depth(const std::filesystem::path& folder,
                                               const std::string& name);

}  // namespace alltact
