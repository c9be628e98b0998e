// Where a camera sits, to and from YAML: `translation_mm` and `rotation` of a RigidTransform.
#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/result.h"
#include "core/yaml/yaml_reader.h"
#include "core/yaml/yaml_writer.h"

#include <optional>
#include <string>

namespace alltact {

/// For YamlFile::read(): three and four numbers; what they must be is for place_problem() to say.
[[nodiscard]] RigidTransform read_place(YamlSection section);

void add_place(const RigidTransform& place, YamlBlock& block);

/// A coordinate beyond 10000 mm, or a rotation not within 0.001 of unit length; NaN is both. `key`
/// names the place, the error's `where` the key below it.
[[nodiscard]] std::optional<Error> place_problem(const RigidTransform& place,
                                                 const std::string& key);

}  // namespace alltact
