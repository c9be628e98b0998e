// The Python that other programs are tried out with.
#pragma once

namespace alltact::test {

/// Debian's, for which the packages hold numpy and OpenCV; another one in the PATH may have
/// neither.
constexpr const char* kPython = "/usr/bin/python3";

}  // namespace alltact::test
