// Measured numbers as text in the window's language.
#pragma once

#include <QString>
#include <optional>

namespace alltact {

/// Never "-0.0".
[[nodiscard]] QString plain_number(double value, int digits);

/// Plain text: "1.23 ± 0.04"; "1.23 ± under 0.01" where the digits would make the sd 0; "1.23 ±
/// unknown" where it is 0 or not finite; "1.23" without an sd.
[[nodiscard]] QString number_and_sd(double value, const std::optional<double>& sd, int digits);

/// The sd alone, in the same form.
[[nodiscard]] QString sd_number(double sd, int digits);

/// A number that was cut at a limit: "at least 1.50 ± 0.04"; "at most" for a negative one.
[[nodiscard]] QString limit_and_sd(double value, const std::optional<double>& sd, int digits);

}  // namespace alltact
