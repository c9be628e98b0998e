#include "core/numerics/readable_numbers.h"

#include <fmt/format.h>

namespace alltact {

std::string value_and_sd(double value, double sd, int decimals) {
  switch (sd_kind(sd, decimals)) {
    case SdKind::kNumber:
      return fmt::format("{:.{}f} +- {:.{}f}", value, decimals, sd, decimals);
    case SdKind::kUnder:
      return fmt::format("{:.{}f} +- under {:.{}f}", value, decimals, std::pow(10, -decimals),
                         decimals);
    case SdKind::kUnknown:
      break;
  }
  return fmt::format("{:.{}f} +- unknown", value, decimals);
}

}  // namespace alltact
