// Content of finger.yaml, to and from YAML.
#pragma once

#include "core/finger/finger.h"
#include "core/yaml/yaml_reader.h"

#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// For YamlFile::read(). Checks the form of the values; Finger::validate checks the values.
[[nodiscard]] Finger read_finger(YamlSection& top);

/// A valid finger as a file. `unknown`: unknown keys of its original file.
[[nodiscard]] std::string finger_text(const Finger& finger, const UnknownKeys& unknown);

/// The words of the file, in the order of the enums, which count from 1.
using FingerWords = std::vector<std::string_view>;
inline const FingerWords kFaceKinds{"fin_ray", "flat"};
inline const FingerWords kPolarities{"bright", "dark", "auto"};
inline const FingerWords kMappingKinds{"polynomial", "moebius"};
inline const FingerWords kAlongs{"z", "normal", "projected"};

}  // namespace alltact
