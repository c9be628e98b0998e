// Where frames come from: pictures, a folder of pictures, a video.
#pragma once

#include "core/result.h"
#include "core/sources/frame.h"

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
};

/// Opens pictures (png, jpg, bmp, tif, pgm), folders of pictures (in name order; NAME.depth.tiff,
/// NAME.points.tiff and NAME.z.tiff beside them are results, not pictures) or one video
/// (mkv, avi, mp4). Errors: nothing given, a path that does not exist, a folder without pictures, a
/// video that cannot be opened or holds no frame.
[[nodiscard]] Result<std::unique_ptr<Source>> open_source(
    const std::vector<std::filesystem::path>& inputs);

}  // namespace alltact
