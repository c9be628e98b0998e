// What packaging/python/alltact_finger.py makes of an exported finger, beside the program's own.
#pragma once

#include "tests/support/program.h"
#include "tests/support/python.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {

/// Differences of depth in mm, sorted.
struct DepthDifference {
  std::vector<double> all, in_contact;  ///< in_contact: where the program says 0.1 mm or deeper
  std::size_t missing = 0;              ///< pixels that only the program measures

  static double part(const std::vector<double>& values, double share) {
    return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
  }
  [[nodiscard]] std::string words() const {
    return fmt::format(
        "all: median {:.4f} mm, 95 % within {:.4f} mm; contacts: median {:.4f} mm, 95 % within "
        "{:.4f} mm; {:.4f} missing",
        part(all, 0.5), part(all, 0.95), part(in_contact, 0.5), part(in_contact, 0.95),
        missing_part());
  }
  [[nodiscard]] double missing_part() const {
    return static_cast<double>(missing) / static_cast<double>(missing + all.size());
  }
};

/// Exports the finger, has Python reconstruct the pictures, and compares with NAME.depth.tiff in
/// `results`.
inline DepthDifference python_against_program(const std::string& finger,
                                              const std::vector<std::filesystem::path>& images,
                                              const std::filesystem::path& results) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const ProgramRun exported =
      run_alltact({"export", finger, "--to", "zip", "-o", folder.path().string()});
  EXPECT_EQ(exported.status, 0) << exported.errors;
  std::string command = fmt::format("{} -W error {}/packaging/python/alltact_finger.py '{}'",
                                    kPython, ALLTACT_SOURCE_DIR, (folder / "finger.zip").string());
  for (const fs::path& image : images) {
    const fs::path copy = folder / image.filename().string();
    fs::copy_file(image, copy);
    command += " '" + copy.string() + "'";
  }
  const ProgramRun run = run_shell(command);
  EXPECT_EQ(run.status, 0) << run.errors;

  DepthDifference difference;
  for (const fs::path& image : images) {
    const cv::Mat theirs = cv::imread(
        (folder / (image.filename().string() + ".depth.tiff")).string(), cv::IMREAD_UNCHANGED);
    const cv::Mat ours = cv::imread((results / (image.stem().string() + ".depth.tiff")).string(),
                                    cv::IMREAD_UNCHANGED);
    EXPECT_EQ(theirs.type(), CV_32FC1) << image;
    EXPECT_EQ(theirs.size(), ours.size()) << image;
    if (theirs.type() != CV_32FC1 || theirs.size() != ours.size()) continue;
    for (int v = 0; v < ours.rows; ++v)
      for (int u = 0; u < ours.cols; ++u) {
        const float a = ours.at<float>(v, u), b = theirs.at<float>(v, u);
        if (!std::isfinite(a)) continue;
        if (!std::isfinite(b)) {
          ++difference.missing;
          continue;
        }
        difference.all.push_back(std::abs(a - b));
        if (a >= 0.1F) difference.in_contact.push_back(std::abs(a - b));
      }
  }
  std::sort(difference.all.begin(), difference.all.end());
  std::sort(difference.in_contact.begin(), difference.in_contact.end());
  return difference;
}

}  // namespace alltact::test
