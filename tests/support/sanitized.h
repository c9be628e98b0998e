// Whether the tests run under a sanitizer that has an allocator of its own: what is measured of
// memory then is not the program's, and all takes longer.
#pragma once

namespace alltact::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

}  // namespace alltact::test
