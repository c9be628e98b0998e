// The other end of a serial line: a pseudo-terminal on which a test is the gauge.
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace alltact::test {

class SerialLine {
 public:
  SerialLine() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0)
      throw std::runtime_error("no pseudo-terminal");
    node_ = ::ptsname(master_);
  }
  ~SerialLine() { unplug(); }
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;

  [[nodiscard]] const std::string& node() const { return node_; }
  void say(const std::string& bytes) const {
    if (::write(master_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("the line takes nothing");
  }
  /// What the program sent within this time; empty: nothing.
  [[nodiscard]] std::string hear(int timeout_ms) const {
    pollfd waiting{master_, POLLIN, 0};
    if (::poll(&waiting, 1, timeout_ms) <= 0) return {};
    std::string bytes(1024, '\0');
    const ssize_t size = ::read(master_, bytes.data(), bytes.size());
    bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return bytes;
  }
  void unplug() {
    if (master_ >= 0) ::close(master_);
    master_ = -1;
  }

 private:
  int master_;
  std::string node_;
};

}  // namespace alltact::test
