// A force gauge on a serial line, that tells by itself or when it is asked.
#pragma once

#include "core/sources/gauge/gauge_source.h"
#include "core/sources/gauge/serial_port.h"

#include <optional>

namespace alltact {

struct SerialGaugeOptions {
  std::filesystem::path node;
  int baud = 9600;
  std::string ask;  ///< sent for each reading ("?\r"); empty: the gauge tells by itself
  double ask_every_s = 0.05;
  GaugeLineRules rules;
  GaugeDirections directions;
};

/// Puts lines together from what a serial line gives, piece by piece, and says when each began.
class GaugeLineReader {
 public:
  struct Line {
    std::string text;
    double time_s = 0;
  };
  /// byte_s: how long a byte takes.
  explicit GaugeLineReader(double byte_s) : byte_s_(byte_s) {}

  /// `arrived_s`: when the last of these bytes came. Lines end with CR, LF or both; what is longer
  /// than any reading is thrown away up to the next end.
  void feed(std::string_view bytes, double arrived_s);
  /// Of a line without an end nothing more comes.
  void end_line();
  /// The first line may have lost its beginning.
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
  /// Times are when a reading's line began or, of a gauge that is asked, half way from the question
  /// to that. Lines that are no readings are passed over; remarks count them, and tell once that
  /// the gauge does not answer. A reading with another number of decimals than before counts from
  /// the second on: where a line loses bytes, that is how it shows.
  [[nodiscard]] Result<GaugeNews> read(int timeout_ms) override;
  [[nodiscard]] int axes() const override { return options_.directions.told; }

 private:
  SerialGauge(SerialPort port, const SerialGaugeOptions& options);
  [[nodiscard]] Status ask_when_due(GaugeNews& news);
  void take_line(const GaugeLineReader::Line& line, GaugeNews& news);
  [[nodiscard]] bool is_of_this_gauge(const GaugeLine& line);

  SerialPort port_;
  SerialGaugeOptions options_;
  GaugeLineReader lines_;
  std::optional<double> asked_s_;  // without an answer yet
  double next_ask_s_ = 0, last_s_ = 0;
  int unanswered_ = 0, noise_ = 0;
  std::optional<GaugeLine> shape_, other_shape_;
};

}  // namespace alltact
