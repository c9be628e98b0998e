#include "core/sources/gauge/force_unit.h"

#include <string>

namespace alltact {

std::optional<double> newtons_in(std::string_view unit) {
  constexpr double kGravity = 9.80665, kPoundKg = 0.45359237;
  std::string name;
  for (const char c : unit) name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (name == "n") return 1.0;
  if (name == "mn") return 1e-3;
  if (name == "kn") return 1e3;
  if (name == "g" || name == "gf") return 1e-3 * kGravity;
  if (name == "kg" || name == "kgf") return kGravity;
  if (name == "lb" || name == "lbf") return kPoundKg * kGravity;
  if (name == "oz" || name == "ozf") return kPoundKg / 16 * kGravity;
  return std::nullopt;
}

}  // namespace alltact
