// Reading and writing single pictures.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>
#include <string_view>

#include <opencv2/core.hpp>

namespace alltact {

/// Reads an 8-bit picture as grey (CV_8UC1). A colour picture of a scene lit by white light is
/// turned into grey; one whose colours are strong is refused, as are files that are missing, empty
/// or truncated (also where the decoder would fill up in silence), 16-bit or float pictures,
/// pictures with transparency, and pictures with no pixel above 4 ("all black"). Each error names
/// the file. `note`: what write_picture() put beside the pixels; empty where there is nothing.
[[nodiscard]] Result<cv::Mat> read_grey_picture(const std::filesystem::path& file,
                                                std::string* note = nullptr);

/// Writes a picture whole or not at all (see atomic_file.h): PNG for CV_8UC1 or CV_8UC3, TIFF for
/// CV_32FC1 and CV_32FC3 (no compression, so that any program reads it). The ending decides. Three
/// channels come back in their order from OpenCV and from read_float_picture(); in the file they
/// stand last first, as OpenCV writes them, and so they are for readers that know red, green, blue.
/// `note`: words to keep in the file; PNG only.
[[nodiscard]] Status write_picture(const std::filesystem::path& file,
                                   const cv::Mat& picture,
                                   std::string_view note = {});

/// Reads a float TIFF written by write_picture (CV_32FC1 or CV_32FC3).
[[nodiscard]] Result<cv::Mat> read_float_picture(const std::filesystem::path& file);

}  // namespace alltact
