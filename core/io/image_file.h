// Reading and writing of single images.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>
#include <string_view>

#include <opencv2/core.hpp>

namespace alltact {

/// Reads an 8-bit image as grey (CV_8UC1). A colour image of a scene in white light is converted to
/// grey. Missing, empty and truncated files are refused, also where the decoder would silently fill
/// them up. So are strong colours, 16-bit or float images, transparency, and images with no pixel
/// above 4 ("all black"). Each error names the file. `note`: the text stored by write_image();
/// empty where there is none.
[[nodiscard]] Result<cv::Mat> read_grey_image(const std::filesystem::path& file,
                                              std::string* note = nullptr);

/// Writes an image atomically (see atomic_file.h): PNG for CV_8UC1 or CV_8UC3, TIFF for CV_32FC1
/// and CV_32FC3 (no compression, so that any program reads it). The extension decides. Three
/// channels have their order with OpenCV and read_float_image(); in the file OpenCV writes the
/// last one first, so that readers of red, green, blue get them reversed. `note`: text to store in
/// the file; PNG only.
[[nodiscard]] Status write_image(const std::filesystem::path& file,
                                 const cv::Mat& image,
                                 std::string_view note = {});

/// Reads a float TIFF written by write_image (CV_32FC1 or CV_32FC3).
[[nodiscard]] Result<cv::Mat> read_float_image(const std::filesystem::path& file);

}  // namespace alltact
