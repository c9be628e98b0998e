// Where frames come from: cameras, videos, pictures and simulated fingers, all alike.
#pragma once

#include "core/job.h"
#include "core/result.h"
#include "core/sources/frame.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// Gives frames one after the other.
class Source {
 public:
  virtual ~Source() = default;

  /// The next frame; nullptr after the last one; an error names the picture that could not be
  /// read. After an error the next call goes on with the picture behind it, where there is one.
  [[nodiscard]] virtual Result<FramePtr> next() = 0;

  /// How many frames there will be, where that is known.
  [[nodiscard]] virtual std::optional<std::size_t> count() const = 0;

  /// True when frames follow each other in time, so that what was seen in one helps in the next.
  [[nodiscard]] virtual bool is_continuous() const = 0;

  /// True when frames come when they come, not when they are asked for: whoever is too slow misses
  /// them.
  [[nodiscard]] virtual bool is_live() const { return false; }

  /// About how often frames come or came.
  [[nodiscard]] virtual double frames_per_s() const { return 30.0; }
};

enum class Pace {
  kAsked = 1,  ///< as fast as they are asked for
  kRecorded,   ///< as they were recorded, or as a camera gives them
};

struct SourceOptions {
  Pace pace = Pace::kAsked;
  std::uint64_t seed = 1;  ///< of a simulated finger
  int threads = 1;         ///< that render it; the pictures are the same for any number
  /// Told of long opening (mending a recording); ends waits at the recorded pace. May be null; else
  /// it outlives the source.
  const Job* job = nullptr;
};

/// True when the name ends as videos' names do.
[[nodiscard]] bool is_video(const std::filesystem::path& file);

/// Opens what the inputs name:
///   one camera: its node (/dev/video0), or its lasting name or serial number (see find_camera);
///   pictures (png, jpg, bmp, tif, pgm) and folders of pictures (in name order; NAME.depth.tiff,
///     NAME.depth_sd.tiff, NAME.flags.png, NAME.sd_*.tiff, NAME.points.tiff, NAME.z.tiff and
///     NAME.3d.png beside them are results); they have no times and come as fast as asked;
///   one video (mkv, avi, mp4; see VideoFile);
///   one scene (yaml): the finger it describes, simulated. As fast as asked it gives the scene's
///     frames; at the camera's pace it goes on without end, with the faults that the scene names.
/// Errors: nothing given, a path that does not exist, a folder without pictures, a video that
/// cannot be opened or holds no frame, a scene that is wrong, no such camera, one of these three
/// together with other inputs.
[[nodiscard]] Result<std::unique_ptr<Source>> open_source(
    const std::vector<std::filesystem::path>& inputs, const SourceOptions& options = {});

}  // namespace alltact
