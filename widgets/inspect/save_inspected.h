// Exports what is shown. Slow: not for the window's thread.
#pragma once

#include "core/job.h"
#include "core/result.h"
#include "widgets/inspect/film.h"

#include <array>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace alltact {

/// The contact face in the format of the file's ending: see write_surface(). Error: no face; those
/// of write_surface().
[[nodiscard]] Status save_surface(const InspectedFrame& frame, const std::filesystem::path& file);

/// A frame of one of two fingers, and the pose of its camera in the gripper.
struct PosedFrame {
  std::shared_ptr<const InspectedFrame> frame;
  RigidTransform gripper_from_camera;
};
/// NAME-1 and NAME-2 with the ending of `file`.
[[nodiscard]] std::vector<std::filesystem::path> files_of_both(const std::filesystem::path& file);
/// Both contact faces, in the gripper's frame, into files_of_both(). Errors: as save_surface().
[[nodiscard]] Status save_both(const std::array<PosedFrame, 2>& frames,
                               const std::filesystem::path& file);

/// A finger with its recording, as SecondFinger.
struct FilmOptions {
  std::filesystem::path finger, input;
  FilmView view;  ///< with options.second for a second finger
  /// gripper_from_camera of both cameras; none: the fingers are shown side by side.
  std::optional<std::array<RigidTransform, 2>> poses;
};

/// A 3D video (Matroska, Motion JPEG) of the full recording at its frame rate; needs no display.
/// Frames without a face are skipped. A stopped file is valid up to that frame. Errors: no OpenGL,
/// no frame with a face, those of reading and writing.
[[nodiscard]] Status save_film(const FilmOptions& options,
                               const std::filesystem::path& file,
                               const Job& job);

/// Queue of live moments for a film. When it is full, the oldest is dropped and counted.
class FilmQueue {
 public:
  static constexpr std::size_t kMaxMoments = 4;
  void add(FilmMoment moment);
  /// Waits up to 100 ms; nullopt: nothing arrived.
  [[nodiscard]] std::optional<FilmMoment> next();
  [[nodiscard]] std::size_t left_out() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable added_;
  std::deque<FilmMoment> moments_;
  std::size_t left_out_ = 0;
};

/// A video of the queue's moments until it is stopped. Errors: as save_film().
[[nodiscard]] Status save_live_film(FilmQueue& queue,
                                    const FilmView& view,
                                    const std::filesystem::path& file,
                                    const Job& job);

}  // namespace alltact
