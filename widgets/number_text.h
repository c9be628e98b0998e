// Measured numbers as text in the window's language.
#pragma once

#include <QString>
#include <optional>

namespace alltact {

/// Without "-0.0".
[[nodiscard]] QString plain_number(double value, int digits);

/// Plain text: "1.23 ± 0.04"; "1.23 ± under 0.01" where the digits would make the sd 0, and
/// "1.23 ± unknown" where it is 0 or not finite. Without any sd "1.23".
[[nodiscard]] QString number_and_sd(double value, const std::optional<double>& sd, int digits);

/// The sd alone, as there.
[[nodiscard]] QString sd_number(double sd, int digits);

/// "at least 1.50 ± 0.04", of a number that ends at a limit; "at most" of a negative one.
[[nodiscard]] QString limit_and_sd(double value, const std::optional<double>& sd, int digits);

}  // namespace alltact
