// A force gauge on a serial line, which sends by itself or on request.
#pragma once

#include "core/sources/gauge/gauge_source.h"
#include "core/sources/gauge/serial_port.h"

#include <optional>

namespace alltact {

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

}  // namespace alltact
