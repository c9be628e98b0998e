// What stands under `camera:`, to and from YAML.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/yaml/yaml_reader.h"
#include "core/yaml/yaml_writer.h"

namespace alltact {

/// For YamlFile::read(). Looks at the form of the values; whether they make a camera is for
/// Camera::create to say.
[[nodiscard]] CameraParameters read_camera(YamlSection& section, LensRecord& record);
/// `unknown`: what the file held besides; what stood right under `camera` is for the caller.
void add_camera(const CameraParameters& parameters,
                const LensRecord& record,
                const UnknownKeys& unknown,
                YamlBlock& block);

}  // namespace alltact
