// What a person noted about presses, applied to their measurements; the meshes of bodies in notes.
#pragma once

#include "calibration/presses/press.h"
#include "core/base/result.h"
#include "core/finger/press_set.h"

#include <filesystem>
#include <map>
#include <string>

namespace alltact {

/// Folder of the bodies' meshes in a finger's folder.
inline constexpr const char* kBodyFolder = "bodies";

/// By the files that the notes name.
using PressBodies = std::map<std::string, KnownBody>;

/// The file of a body; one without an absolute path is in the finger's folder.
[[nodiscard]] std::filesystem::path body_file(const std::filesystem::path& finger_folder,
                                              const std::string& file);

/// Reads the mesh of a body. Errors, with the file as `where`: those of read_mesh(); a mesh that is
/// not closed; one whose size suggests another unit than mm.
[[nodiscard]] Result<KnownBody> load_body(const std::filesystem::path& file);

/// Reads the mesh of every body in the notes about presses that are not excluded. Errors: those of
/// load_body().
[[nodiscard]] Result<PressBodies> load_bodies(const PressSet& press_set,
                                              const std::filesystem::path& finger_folder);

/// Applies the notes about a press but its exclusion: radius, ball, depth, step, body.
void apply_note(const PressSet& press_set, const PressBodies& bodies, Press& press);

}  // namespace alltact
