// A serial line: 8 data bits, no parity, 1 stop bit, no flow control.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// One thread.
class SerialPort {
 public:
  /// `baud`: one that the driver knows, 300 to 4000000. No other program may open the line as long
  /// as this one has it, because each would get a part of the answers. Errors: not there, with the
  /// lines that are; no serial line; access not allowed, with the group to join; used by somebody
  /// else; a speed that the driver did not take.
  [[nodiscard]] static Result<SerialPort> open(const std::filesystem::path& node, int baud);
  SerialPort(SerialPort&& other) noexcept;
  SerialPort& operator=(SerialPort&& other) noexcept;
  ~SerialPort();

  /// What has come; waits for the first byte at most so long. Empty: nothing came. Error: the line
  /// is gone.
  [[nodiscard]] Result<std::string> read(int timeout_ms);
  /// All of it, unless the line takes nothing for a second. Error: it is gone or takes nothing.
  [[nodiscard]] Status write(std::string_view bytes);
  /// Throws away what has come and was not read.
  void forget_input();

  [[nodiscard]] const std::filesystem::path& node() const { return node_; }

 private:
  SerialPort() = default;
  void close();

  std::filesystem::path node_;
  int descriptor_ = -1;
};

/// /dev/serial/by-id/*, which last, else /dev/ttyUSB*, /dev/ttyACM*.
[[nodiscard]] std::vector<std::filesystem::path> serial_ports();

/// The speeds that open() takes, ascending.
[[nodiscard]] const std::vector<int>& serial_speeds();

}  // namespace alltact
