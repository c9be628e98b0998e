// Opens the source that an input names.
#pragma once

#include "core/sources/source.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace alltact {

/// True for a file that is a video by its content, whatever its name.
[[nodiscard]] bool is_video(const std::filesystem::path& file);

/// Opens the inputs:
///   one camera: its node (/dev/video0), its stable name or its serial number (see find_camera);
///   images (png, jpg, bmp, tif, pgm) and folders of images, by their names with the numbers in
///     them by value; so are files that a shell listed by their letters. NAME.depth.tiff,
///     NAME.depth16.png, NAME.depth_sd.tiff, NAME.flags.png, NAME.sd_*.tiff, NAME.points.tiff,
///     NAME.rectified.tiff, NAME.z.tiff and NAME.3d.png next to them are results. Images have no
///     times and come as fast as requested;
///   one video (see VideoFile), whatever its name;
///   one scene (yaml): the finger it describes, simulated. As fast as requested it gives the
///     scene's frames; at the camera's pace it runs without end, with the faults of the scene.
/// Errors: no input, a path that does not exist, a folder without images, a video that cannot be
/// opened or has no frame, an invalid scene, no such camera, a camera, video or scene together with
/// other inputs.
[[nodiscard]] Result<std::unique_ptr<Source>> open_source(
    const std::vector<std::filesystem::path>& inputs, const SourceOptions& options = {});

/// Inputs that libraries above this one open: each adds its own when it is loaded. In a program
/// that is not linked to them such an input is none.
enum class InputKind { kCamera, kScene };
using InputOpener = Result<std::unique_ptr<Source>> (*)(const std::filesystem::path& input,
                                                        const SourceOptions& options);

/// Returns true, so that a constant of the library can call it. Before main() only.
bool add_input_kind(InputKind kind, InputOpener opener);

}  // namespace alltact
