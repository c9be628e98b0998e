// Opens any gauge by its name.
#pragma once

#include "core/base/descriptor.h"
#include "core/base/result.h"
#include "core/devices/gauge_source.h"
#include "core/devices/hid_port.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// A gauge as a person specifies it.
struct GaugeChoice {
  /// "typed" (on standard input), "serial:NODE", "hid:DEVICE" as open_hid() takes it.
  std::string gauge;
  std::string model;      ///< "mark10", "imada", "sauter" or empty: preset of speed, question and
                          ///< format
  std::string unit;       ///< of values without a unit; empty: N
  std::string direction;  ///< as GaugeDirections::parse takes it; empty: x, or x, y, z
  std::string ask;        ///< question for a serial gauge, with \r,
                          ///< , \xHH for control characters
  int baud = 0;           ///< 0: the model's, 9600
  double ask_every_s = 0.05;
  std::string report;  ///< of a HID gauge, as GaugeReport::from() takes it
};

/// Returns a function that opens the gauge, also after it was unplugged. Errors: the specification
/// contradicts itself or is not understood.
[[nodiscard]] Result<GaugeOpener> gauge_opener(const GaugeChoice& choice);

/// Converts escapes, such as "?\r" typed by a person, to bytes. Error: an unknown escape.
[[nodiscard]] Result<std::string> unescaped(const std::string& text);

// A serial line: 8 data bits, no parity, 1 stop bit, no flow control.

/// One thread.
class SerialPort {
 public:
  /// `baud`: a speed that the driver knows, 300 to 4000000. While the line is open no other program
  /// may open it, because each would get a part of the answers. Errors: not there, with a list of
  /// existing lines; no serial line; access not allowed, with the group to join; in use; a speed
  /// that the driver refuses.
  [[nodiscard]] static Result<SerialPort> open(const std::filesystem::path& node, int baud);
  SerialPort(SerialPort&& other) noexcept = default;
  SerialPort& operator=(SerialPort&& other) noexcept = default;
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

  std::filesystem::path node_;
  Descriptor descriptor_;
};

/// /dev/serial/by-id/*, which are stable names, else /dev/ttyUSB*, /dev/ttyACM*.
[[nodiscard]] std::vector<std::filesystem::path> serial_ports();

/// The speeds that open() takes, ascending.
[[nodiscard]] const std::vector<int>& serial_speeds();

// A force gauge on a serial line, which sends by itself or on request.

struct SerialGaugeOptions {
  std::filesystem::path node;
  int baud = 9600;
  std::string ask;  ///< sent for each reading ("?\r"); empty: the gauge sends by itself
  double ask_every_s = 0.05;
  GaugeLineRules rules;
  GaugeDirections directions;
};

/// Assembles lines from pieces of a serial line, with the time at which each began.
class GaugeLineReader {
 public:
  struct Line {
    std::string text;
    double time_s = 0;
  };
  /// byte_s: duration of a byte.
  explicit GaugeLineReader(double byte_s) : byte_s_(byte_s) {}

  /// `arrived_s`: arrival of the last of these bytes. Lines end with CR, LF or both. A line longer
  /// than any reading is discarded up to its end.
  void feed(std::string_view bytes, double arrived_s);
  /// Ends a line without an end mark, of which nothing more comes.
  void end_line();
  /// Skips the first line, which may have lost its beginning.
  void skip_first() { is_skipping_ = true; }
  void clear();
  [[nodiscard]] bool is_within_line() const { return !text_.empty(); }
  [[nodiscard]] double last_byte_s() const { return last_byte_s_; }
  [[nodiscard]] std::optional<Line> take();

 private:
  double byte_s_, begun_s_ = 0, last_byte_s_ = 0;
  bool is_skipping_ = false;
  std::string text_;
  std::vector<Line> lines_;
};

class SerialGauge : public GaugeSource {
 public:
  /// Errors: those of SerialPort::open.
  [[nodiscard]] static Result<std::unique_ptr<GaugeSource>> open(const SerialGaugeOptions& options);
  /// A reading's time is the beginning of its line or, for a gauge that answers a question, midway
  /// between question and line. Lines without a reading are skipped; remarks count them, and report
  /// once that the gauge does not answer. A reading with a new number of decimals is valid only
  /// from the second on, because a line with lost bytes looks like that.
  [[nodiscard]] Result<GaugeUpdate> read(int timeout_ms) override;
  [[nodiscard]] int axes() const override { return options_.directions.count; }

 private:
  SerialGauge(SerialPort port, const SerialGaugeOptions& options);
  [[nodiscard]] Status ask_when_due(GaugeUpdate& update);
  void take_line(const GaugeLineReader::Line& line, GaugeUpdate& update);
  [[nodiscard]] bool has_known_shape(const GaugeLine& line);

  SerialPort port_;
  SerialGaugeOptions options_;
  GaugeLineReader lines_;
  std::optional<double> query_sent_s_;  // question without an answer yet
  double next_ask_s_ = 0, last_s_ = 0;
  int unanswered_ = 0, noise_ = 0;
  std::optional<GaugeLine> shape_, other_shape_;
};

// A force gauge that sends HID input reports.

/// Layout of the values in a gauge's reports, for devices that the program does not know.
struct GaugeReport {
  enum class Type { kU8 = 1, kS8, kU16, kS16, kU24, kS24, kU32, kS32, kF32 };
  struct Value {
    std::size_t at = 0;  ///< first byte, behind the report's id
    Type type = Type::kS16;
    bool is_big_endian = false;
    double scale = 1;  ///< units per count
    double zero = 0;   ///< counts without load
    double unit_N = 1;
  };
  std::uint8_t id = 0;        ///< 0 where the device has no ids
  std::vector<Value> values;  ///< 1 to 3

  /// Parses "id=3 at=1 type=s16 scale=0.01 unit=N at=3". Settings before the first at=, and those
  /// of one value, hold for the values behind it too. Types: u8, s8, u16, s16, u24, s24, u32, s32,
  /// f32, low byte first, or high byte first with "be" behind. Error: not of that form or
  /// impossible.
  static Result<GaugeReport> parse(const std::string& text);
  /// Parses a table of any form that core/base/table.h describes. Its head names at, type and
  /// optionally scale, zero, unit, id. Each row is one value; empty cells repeat the row above.
  /// Errors name the line.
  static Result<GaugeReport> parse_table(std::string_view csv, const std::filesystem::path& origin);
  /// `description`: the text of parse(), or the file of a table.
  static Result<GaugeReport> from(const std::string& description);

  /// Decodes a report. Noise: another report, or too short. Over range: an integer at the end of
  /// its type's range (unsigned: the upper end), or a non-finite float.
  [[nodiscard]] GaugeLine read(std::span<const std::uint8_t> report) const;
};

class HidGauge : public GaugeSource {
 public:
  HidGauge(std::unique_ptr<HidPort> port, GaugeReport report, const GaugeDirections& directions)
      : port_(std::move(port)), report_(std::move(report)), directions_(directions) {}

  /// One sample per report, with its time of arrival.
  [[nodiscard]] Result<GaugeUpdate> read(int timeout_ms) override;
  [[nodiscard]] int axes() const override { return static_cast<int>(report_.values.size()); }

 private:
  std::unique_ptr<HidPort> port_;
  GaugeReport report_;
  GaugeDirections directions_;
  double last_s_ = 0;
  int foreign_reports_ = 0;
};

}  // namespace alltact
