// Pictures and films of what is inspected, drawn without a window. Slow: not for the window's
// thread.
#pragma once

#include "core/geometry/triangle_distance.h"
#include "core/recording/video_writer.h"
#include "core/result.h"
#include "widgets/inspect/shown_scene.h"
#include "widgets/scene3d/scene_pictures.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// How it is drawn.
struct FilmView {
  InspectOptions options;
  SceneColours colours;
  cv::Size size_px{1280, 720};
  double pixels_per_unit = 1;  ///< of lines and letters
};

/// What is drawn at a moment.
struct FilmMoment {
  std::shared_ptr<const InspectedFrame> first, second;  ///< second: null without a second finger
  /// Both fingers in the gripper's frame in one picture; without them side by side.
  std::optional<std::array<RigidTransform, 2>> places = {};
  std::optional<NearestPoints> gap = {};
  std::optional<Look> look = {};  ///< none: as the options say
  [[nodiscard]] bool has_face() const;
};

class FilmPictures {
 public:
  /// Error: no OpenGL.
  [[nodiscard]] static Result<FilmPictures> create(const FilmView& view);
  /// With a face. CV_8UC3, blue, green, red.
  [[nodiscard]] cv::Mat operator()(const FilmMoment& moment);

 private:
  FilmPictures(FilmView view, std::vector<ScenePictures> panes)
      : view_(std::move(view)), panes_(std::move(panes)) {}
  FilmView view_;
  std::vector<ScenePictures> panes_;
  std::optional<Look> look_;
};

/// A video (Matroska, Motion JPEG) that is whole whenever it ends.
class FilmWriter {
 public:
  FilmWriter(std::filesystem::path file, const FilmView& view)
      : file_(std::move(file)), view_(view) {}
  /// Moments without a face are left out. Errors: no OpenGL, those of writing.
  [[nodiscard]] Status add(const FilmMoment& moment, double frames_per_s);
  [[nodiscard]] std::size_t written() const { return written_; }
  /// Error: nothing was written.
  [[nodiscard]] Status finish();

 private:
  std::filesystem::path file_;
  FilmView view_;
  std::optional<FilmPictures> pictures_;
  std::optional<VideoWriter> writer_;
  std::size_t written_ = 0;
};

/// PNG of 300 dots per inch, 17 cm wide, as tall as the view's form asks for, for a paper: on
/// white. Errors: no face, no OpenGL, not writable.
[[nodiscard]] Status save_paper_picture(const FilmMoment& moment,
                                        FilmView view,
                                        const std::filesystem::path& file);
inline constexpr double kPaperDotsPerInch = 300, kPaperWidth_px = 2008;

/// As PNG, whole or not at all, of 300 dots per inch.
///   picture: CV_8UC3, blue, green, red
[[nodiscard]] Status write_paper_picture(const std::filesystem::path& file, const cv::Mat& picture);

}  // namespace alltact
