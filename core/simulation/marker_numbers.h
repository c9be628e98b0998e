// Which dots an effect is about.
#pragma once

#include "core/yaml/yaml_reader.h"

#include <cstddef>
#include <vector>

namespace alltact {

/// For YamlFile::read(): the key `markers`, whole numbers from 0 on, each once.
[[nodiscard]] std::vector<std::size_t> read_marker_numbers(YamlSection& section);

}  // namespace alltact
