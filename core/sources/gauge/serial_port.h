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
  /// `baud`: a speed that the driver knows, 300 to 4000000. While the line is open no other program
  /// may open it, because each would get a part of the answers. Errors: not there, with a list of
  /// existing lines; no serial line; access not allowed, with the group to join; in use; a speed
  /// that the driver refuses.
  [[nodiscard]] static Result<SerialPort> open(const std::filesystem::path& node, int baud);
  SerialPort(SerialPort&& other) noexcept;
  SerialPort& operator=(SerialPort&& other) noexcept;
  ~SerialPort();

  /// Returns received bytes; waits for the first byte no longer than the timeout. Empty: no byte
  /// came. Error: the line is gone.
  [[nodiscard]] Result<std::string> read(int timeout_ms);
  /// Writes all bytes. Error: the line is gone, or takes no byte for a second.
  [[nodiscard]] Status write(std::string_view bytes);
  /// Discards received bytes that were not read.
  void discard_input();

  [[nodiscard]] const std::filesystem::path& node() const { return node_; }

 private:
  SerialPort() = default;
  void close();

  std::filesystem::path node_;
  int descriptor_ = -1;
};

/// /dev/serial/by-id/*, which are stable names, else /dev/ttyUSB*, /dev/ttyACM*.
[[nodiscard]] std::vector<std::filesystem::path> serial_ports();

/// The speeds that open() takes, ascending.
[[nodiscard]] const std::vector<int>& serial_speeds();

}  // namespace alltact
