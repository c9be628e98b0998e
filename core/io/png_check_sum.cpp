#include "core/io/png_check_sum.h"

#include <array>

namespace alltact {
namespace {

/// What each value of a byte does to the sum.
constexpr std::array<std::uint32_t, 256> make_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
    table[byte] = sum;
  }
  return table;
}

constexpr auto kTable = make_table();

}  // namespace

std::uint32_t png_check_sum(std::string_view type_and_data) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : type_and_data)
    sum = (sum >> 8U) ^ kTable[(sum ^ static_cast<unsigned char>(byte)) & 0xFFU];
  return ~sum;
}

}  // namespace alltact
