// The dots that an effect acts on.
#pragma once

#include "core/yaml/yaml_reader.h"

#include <cstddef>
#include <vector>

namespace alltact {

/// For YamlFile::read(): the key `markers`, distinct integers from 0.
[[nodiscard]] std::vector<std::size_t> read_marker_numbers(YamlSection& section);

}  // namespace alltact
