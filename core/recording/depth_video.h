// Depth of a complete recording in one file: 16-bit grey images without loss, FFV1 in Matroska.
//
// Pixels are depth_steps() (image_file.h): depth_mm = 0.001 (value - 10000), 0 where there is none.
// The file's tag kDepthVideoTag contains this formula, so that no other file is needed to read it:
//   ffmpeg -i depth.mkv -pix_fmt gray16le -f rawvideo depth.raw      ffprobe -show_format depth.mkv
// Image n belongs to frame n of the recording; an image without depth is 0 everywhere.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <opencv2/core.hpp>

namespace alltact {

inline constexpr const char* kDepthVideoTag = "ALLTACT_DEPTH";
inline constexpr const char* kDepthVideoFile = "depth.mkv";

/// Compresses depth images independently of each other. Several instances, one per thread, produce
/// the same bytes for the same image.
class DepthPackets {
 public:
  /// Error: this system's libavcodec cannot write FFV1.
  [[nodiscard]] static Result<DepthPackets> create(cv::Size size);
  DepthPackets(DepthPackets&&) noexcept;
  DepthPackets& operator=(DepthPackets&&) noexcept;
  ~DepthPackets();

  /// steps: CV_16UC1 of the size, as depth_steps() makes them.
  [[nodiscard]] Result<std::string> packet(const cv::Mat& steps);

 private:
  friend class DepthVideoWriter;
  struct State;
  explicit DepthPackets(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Not for several threads at once.
class DepthVideoWriter {
 public:
  /// Creates or overwrites the file. Frames come 1 / frames_per_s apart. Errors: it cannot be
  /// written; that of DepthPackets.
  [[nodiscard]] static Result<DepthVideoWriter> create(const std::filesystem::path& file,
                                                       cv::Size size, double frames_per_s);
  DepthVideoWriter(DepthVideoWriter&&) noexcept;
  DepthVideoWriter& operator=(DepthVideoWriter&&) noexcept;
  ~DepthVideoWriter();

  /// The next frame, from DepthPackets::packet(). Error: it could not be written; the file then
  /// takes no more.
  [[nodiscard]] Status add(std::string_view packet);
  /// Writes the end of the file, and waits until everything is on the disk.
  [[nodiscard]] Status finish();

 private:
  struct State;
  explicit DepthVideoWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Reads such a file, one frame after the other.
class DepthVideo {
 public:
  /// Errors: not there, damaged, or a video without the tag for depth.
  [[nodiscard]] static Result<DepthVideo> open(const std::filesystem::path& file);
  DepthVideo(DepthVideo&&) noexcept;
  DepthVideo& operator=(DepthVideo&&) noexcept;
  ~DepthVideo();

  [[nodiscard]] cv::Size size() const;
  [[nodiscard]] double frames_per_s() const;
  /// CV_32FC1 in mm, NaN where there is none; empty after the last. Error: it is damaged.
  [[nodiscard]] Result<cv::Mat> next_mm();
  /// The compressed form of the frame, for another file of the same size; empty after the last.
  [[nodiscard]] Result<std::string> next_packet();

 private:
  struct State;
  explicit DepthVideo(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
