#include "core/io/png_check_sum.h"

#include <libdeflate.h>

namespace alltact {

std::uint32_t png_check_sum(std::string_view type_and_data) {
  return libdeflate_crc32(0, type_and_data.data(), type_and_data.size());
}

}  // namespace alltact
