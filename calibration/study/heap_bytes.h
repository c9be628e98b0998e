// Heap memory of the program, for studies that report memory.
#pragma once

#include <cstddef>

#include <malloc.h>

namespace alltact {

/// Bytes of the heap that are allocated.
inline std::size_t heap_bytes() {
  const auto heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

}  // namespace alltact
