// What is shown, as files for others. Slow: not for the window's thread.
#pragma once

#include "core/job.h"
#include "core/result.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspected_frame.h"

#include <array>
#include <filesystem>
#include <memory>
#include <vector>

namespace alltact {

/// The contact face, its vertices as settings say, by the ending: see write_surface(). Error: no
/// face; those of write_surface().
[[nodiscard]] Status save_surface(const InspectedFrame& frame, const std::filesystem::path& file);

/// A frame of one of two fingers, and where its camera sits in the gripper.
struct PlacedFrame {
  std::shared_ptr<const InspectedFrame> frame;
  RigidTransform gripper_from_camera;
};
/// NAME-1 and NAME-2 with the ending of `file`.
[[nodiscard]] std::vector<std::filesystem::path> files_of_both(const std::filesystem::path& file);
/// Both contact faces, in the gripper's frame, into files_of_both(). Errors: as save_surface().
[[nodiscard]] Status save_both(const std::array<PlacedFrame, 2>& frames,
                               const std::filesystem::path& file);

struct FilmOptions {
  std::filesystem::path finger, input;
  InspectOptions view;
  SceneColours colours;
  std::optional<Look> look;  ///< none: from view.standpoint
  cv::Size size_px{1280, 720};
};

/// A video (Matroska, Motion JPEG) of the whole recording in 3D, at its own pace; needs no display.
/// Frames without a face are left out. Stopped: what is there stays, and is whole. Errors: no
/// OpenGL, no frame with a face, those of reading and writing.
[[nodiscard]] Status save_film(const FilmOptions& options,
                               const std::filesystem::path& file,
                               const Job& job);

}  // namespace alltact
