// A verdict for other programs. For .cpp files only.
#pragma once

#include "calibration/verdict/verdict.h"

#include <nlohmann/json.hpp>

namespace alltact {

/// {"grade": "good", "expected_error_mm": 0.021, "causes_mm": {"scale": 0.018, ...}, "missing":
/// [{"evidence": "thirds", "sentence": "..."}], "rests_on": "...", "sentence": "..."}. An unknown
/// error is null.
[[nodiscard]] nlohmann::ordered_json verdict_json(const Verdict& verdict);

}  // namespace alltact
