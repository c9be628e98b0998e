// Renders images and films of the inspected faces without a window. Slow: not for the window's
// thread.
#pragma once

#include "core/geometry/triangle_distance.h"
#include "core/recording/video_writer.h"
#include "core/result.h"
#include "widgets/inspect/shown_scene.h"
#include "widgets/scene3d/offscreen_scene.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// How a film is rendered.
struct FilmView {
  InspectOptions options;
  SceneColours colours;
  cv::Size size_px{1280, 720};
  double pixels_per_unit = 1;  ///< scale of lines and letters
};

/// What is rendered at one moment.
struct FilmMoment {
  std::shared_ptr<const InspectedFrame> first, second;  ///< second: null without a second finger
  /// gripper_from_camera of both fingers, for one joint view; without it they are shown side by
  /// side.
  std::optional<std::array<RigidTransform, 2>> poses = {};
  std::optional<NearestPoints> gap = {};
  std::optional<ViewPose> view_pose = {};  ///< none: as in the options
  [[nodiscard]] bool has_face() const;
};

class FilmRenderer {
 public:
  /// Error: no OpenGL.
  [[nodiscard]] static Result<FilmRenderer> create(const FilmView& view);
  /// The moment needs a face. Returns CV_8UC3, BGR.
  [[nodiscard]] cv::Mat operator()(const FilmMoment& moment);

 private:
  FilmRenderer(FilmView view, std::vector<OffscreenScene> panes)
      : view_(std::move(view)), panes_(std::move(panes)) {}
  FilmView view_;
  std::vector<OffscreenScene> panes_;
  std::optional<ViewPose> view_pose_;
};

/// A video (Matroska, Motion JPEG) that is complete whenever it ends.
class FilmWriter {
 public:
  FilmWriter(std::filesystem::path file, const FilmView& view)
      : file_(std::move(file)), view_(view) {}
  /// Moments without a face are skipped. Errors: no OpenGL, those of writing.
  [[nodiscard]] Status add(const FilmMoment& moment, double frames_per_s);
  [[nodiscard]] std::size_t written() const { return written_; }
  /// Error: nothing was written.
  [[nodiscard]] Status finish();

 private:
  std::filesystem::path file_;
  FilmView view_;
  std::optional<FilmRenderer> renderer_;
  std::optional<VideoWriter> writer_;
  std::size_t written_ = 0;
};

/// Figure for a paper: PNG, 300 dots per inch, 17 cm wide, in the aspect ratio of the view, on
/// white. Errors: no face, no OpenGL, not writable.
[[nodiscard]] Status save_paper_figure(const FilmMoment& moment,
                                       FilmView view,
                                       const std::filesystem::path& file);
inline constexpr double kPaperDotsPerInch = 300, kPaperWidth_px = 2008;

/// Writes a PNG of 300 dots per inch, atomically.
///   bgr: CV_8UC3, blue, green, red
[[nodiscard]] Status write_paper_figure(const std::filesystem::path& file, const cv::Mat& bgr);

}  // namespace alltact
