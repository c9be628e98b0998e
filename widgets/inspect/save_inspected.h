// What is shown, as files for others. Slow: not for the window's thread.
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

/// A finger of its own with its recording, as SecondFinger.
struct FilmOptions {
  std::filesystem::path finger, input;
  FilmView view;  ///< with options.second for a second finger
  /// Where both cameras sit in the gripper; none: the second finger is shown beside the first.
  std::optional<std::array<RigidTransform, 2>> places;
};

/// A video (Matroska, Motion JPEG) of the whole recording in 3D, at its own pace; needs no display.
/// Frames without a face are left out. Stopped: what is there stays, and is whole. Errors: no
/// OpenGL, no frame with a face, those of reading and writing.
[[nodiscard]] Status save_film(const FilmOptions& options,
                               const std::filesystem::path& file,
                               const Job& job);

/// Moments of the live finger on their way into a film: the newest wins, what the film cannot
/// follow is left out and counted.
class FilmQueue {
 public:
  static constexpr std::size_t kMost = 4;
  void add(FilmMoment moment);
  /// Waits a while; nullopt: nothing came.
  [[nodiscard]] std::optional<FilmMoment> next();
  [[nodiscard]] std::size_t left_out() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::deque<FilmMoment> moments_;
  std::size_t left_out_ = 0;
};

/// A video of what comes through the queue, until it is stopped. Errors: as save_film().
[[nodiscard]] Status save_live_film(FilmQueue& queue,
                                    const FilmView& view,
                                    const std::filesystem::path& file,
                                    const Job& job);

}  // namespace alltact
