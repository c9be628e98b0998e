// Which source it is that an input names.
#pragma once

#include "core/sources/source.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace alltact {

/// True when the name ends as videos' names do.
[[nodiscard]] bool is_video(const std::filesystem::path& file);

/// Opens what the inputs name:
///   one camera: its node (/dev/video0), or its lasting name or serial number (see find_camera);
///   pictures (png, jpg, bmp, tif, pgm) and folders of pictures (in name order; NAME.depth.tiff,
///     NAME.depth16.png, NAME.depth_sd.tiff, NAME.flags.png, NAME.sd_*.tiff, NAME.points.tiff,
///     NAME.z.tiff and NAME.3d.png beside them are results); they have no times and come as fast as
///     asked;
///   one video (mkv, avi, mp4; see VideoFile);
///   one scene (yaml): the finger it describes, simulated. As fast as asked it gives the scene's
///     frames; at the camera's pace it goes on without end, with the faults that the scene names.
/// Errors: nothing given, a path that does not exist, a folder without pictures, a video that
/// cannot be opened or holds no frame, a scene that is wrong, no such camera, one of these three
/// together with other inputs.
[[nodiscard]] Result<std::unique_ptr<Source>> open_source(
    const std::vector<std::filesystem::path>& inputs, const SourceOptions& options = {});

}  // namespace alltact
