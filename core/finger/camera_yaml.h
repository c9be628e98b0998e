// What stands under `camera:`, to and from YAML.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/finger/yaml_reader.h"
#include "core/finger/yaml_writer.h"

namespace alltact {

/// Throws Refused. Looks at the form of the values; whether they make a camera is for
/// Camera::create to say.
[[nodiscard]] CameraParameters read_camera(YamlSection& section, LensRecord& record);
/// `unknown`: what the file held below `camera.lens` besides single values.
void add_camera(const CameraParameters& parameters,
                const LensRecord& record,
                const UnknownKeys& unknown,
                YamlBlock& block);

/// An error about a key becomes one about a line of a file.
[[nodiscard]] Error located(const YamlFile& file, const Error& error);

/// A finger or a camera is a small file; more than this is a mistake.
constexpr std::size_t kMaxYamlBytes = std::size_t{4} << 20;

}  // namespace alltact
