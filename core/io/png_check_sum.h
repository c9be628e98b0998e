// Check sum of a PNG chunk.
#pragma once

#include <cstdint>
#include <string_view>

namespace alltact {

/// Of a chunk's type and data (PNG, third edition, annex D): a CRC of polynomial 0xEDB88320.
[[nodiscard]] std::uint32_t png_check_sum(std::string_view type_and_data);

}  // namespace alltact
