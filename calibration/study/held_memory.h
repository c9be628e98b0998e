// What the program holds, for studies that tell memory.
#pragma once

#include <cstddef>

#include <malloc.h>

namespace alltact {

/// Bytes of the heap that were taken and not given back.
inline std::size_t heap_bytes() {
  const auto heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

}  // namespace alltact
