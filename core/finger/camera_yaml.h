// The key `camera:` of a finger file, to and from YAML.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/yaml/yaml_reader.h"
#include "core/yaml/yaml_writer.h"

namespace alltact {

/// For YamlFile::read(). Checks the form of the values; Camera::create() checks the values.
[[nodiscard]] CameraParameters read_camera(YamlSection& section, LensRecord& record);
/// `unknown`: the file's other keys; the caller adds those directly under `camera`.
void add_camera(const CameraParameters& parameters,
                const LensRecord& record,
                const UnknownKeys& unknown,
                YamlBlock& block);

}  // namespace alltact
