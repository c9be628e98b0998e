#include "core/sources/gauge/serial_gauge.h"

#include "core/printable.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr std::size_t kLongestGaugeLine = 120;
constexpr double kAnswerTimeout_s = 0.5, kMinPause_s = 0.02;
constexpr double kBitsPerByte = 10;  // with start and stop bit
constexpr int kUnansweredLimit = 4, kNoiseLimit = 20;

bool has_shape(const GaugeLine& line, const GaugeLine& shape) {
  return line.count == shape.count && line.decimals == shape.decimals;
}

}  // namespace

void GaugeLineReader::feed(std::string_view bytes, double arrived_s) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const double ended_s = arrived_s - byte_s_ * static_cast<double>(bytes.size() - 1 - i);
    last_byte_s_ = ended_s;
    if (bytes[i] == '\r' || bytes[i] == '\n') {
      end_line();
      continue;
    }
    if (text_.empty()) begun_s_ = ended_s - byte_s_;
    text_ += bytes[i];
    if (text_.size() > kLongestGaugeLine) text_.resize(1), is_skipping_ = true;
  }
}

void GaugeLineReader::end_line() {
  if (!text_.empty() && !is_skipping_) lines_.push_back({text_, begun_s_});
  if (!text_.empty()) is_skipping_ = false;
  text_.clear();
}

void GaugeLineReader::clear() {
  text_.clear(), lines_.clear();
  is_skipping_ = false;
}

std::optional<GaugeLineReader::Line> GaugeLineReader::take() {
  if (lines_.empty()) return std::nullopt;
  Line line = std::move(lines_.front());
  lines_.erase(lines_.begin());
  return line;
}

Result<std::unique_ptr<GaugeSource>> SerialGauge::open(const SerialGaugeOptions& options) {
  auto port = SerialPort::open(options.node, options.baud);
  if (!port) return port.error();
  return std::unique_ptr<GaugeSource>(new SerialGauge(std::move(*port), options));
}

SerialGauge::SerialGauge(SerialPort port, const SerialGaugeOptions& options)
    : port_(std::move(port)), options_(options), lines_(kBitsPerByte / options.baud) {
  if (options_.ask.empty()) lines_.skip_first();
}

Result<GaugeUpdate> SerialGauge::read(int timeout_ms) {
  GaugeUpdate update;
  const double until_s = gauge_clock_s() + 1e-3 * timeout_ms;
  const double pause_s = std::max(kMinPause_s, 4 * kBitsPerByte / options_.baud);
  do {
    if (const Status status = ask_when_due(update); !status) return status.error();
    double next_s = until_s;
    if (!options_.ask.empty())
      next_s = std::min(next_s,
                        lines_.is_within_line() ? lines_.last_byte_s() + pause_s
                        : query_sent_s_         ? *query_sent_s_ + kAnswerTimeout_s
                                                : next_ask_s_);
    const double wait_s = std::max(0.0, next_s - gauge_clock_s());
    const auto bytes = port_.read(static_cast<int>(std::ceil(1e3 * wait_s)));
    if (!bytes) return bytes.error();
    const double now_s = gauge_clock_s();
    if (!bytes->empty()) lines_.feed(*bytes, now_s);
    // Sauter's gauges end their answers with nothing but a pause.
    if (!options_.ask.empty() && lines_.is_within_line() && now_s > lines_.last_byte_s() + pause_s)
      lines_.end_line();
    while (const auto line = lines_.take()) take_line(*line, update);
  } while (update.samples.empty() && gauge_clock_s() < until_s);
  if (noise_ >= kNoiseLimit) {
    update.remarks.push_back(en::say("{} lines of the gauge were no readings", noise_));
    noise_ = 0;
  }
  return update;
}

Status SerialGauge::ask_when_due(GaugeUpdate& update) {
  if (options_.ask.empty()) return {};
  const double now_s = gauge_clock_s();
  if (query_sent_s_ && now_s < *query_sent_s_ + kAnswerTimeout_s) return {};
  if (query_sent_s_ && ++unanswered_ == kUnansweredLimit)
    update.remarks.push_back(
        en::say("The gauge does not answer to '{}'. Try: another speed, another "
                "question, its settings for the serial line.",
                printable(options_.ask)));
  query_sent_s_.reset();
  if (now_s < next_ask_s_) return {};
  port_.discard_input();
  lines_.clear();
  if (Status status = port_.write(options_.ask); !status) return status;
  query_sent_s_ = gauge_clock_s();
  next_ask_s_ = *query_sent_s_ + options_.ask_every_s;
  return {};
}

bool SerialGauge::has_known_shape(const GaugeLine& line) {
  if (options_.directions.count != 0 && line.count != options_.directions.count) return false;
  if (!shape_ || has_shape(line, *shape_) || (other_shape_ && has_shape(line, *other_shape_))) {
    shape_ = line;
    other_shape_.reset();
    return true;
  }
  other_shape_ = line;
  return false;
}

void SerialGauge::take_line(const GaugeLineReader::Line& line, GaugeUpdate& update) {
  const GaugeLine reading = read_gauge_line(line.text, options_.rules);
  const double measured_s =
      query_sent_s_ ? 0.5 * (*query_sent_s_ + std::max(*query_sent_s_, line.time_s)) : line.time_s;
  if (reading.kind != GaugeLine::Kind::kNoise) unanswered_ = 0;
  if (!options_.ask.empty() && query_sent_s_) query_sent_s_.reset();
  if (reading.kind == GaugeLine::Kind::kNoise ||
      (reading.kind == GaugeLine::Kind::kValues && !has_known_shape(reading))) {
    ++noise_;
    return;
  }
  // Bytes of several lines come at once; their times follow from the duration of a byte.
  const double time_s = std::max(measured_s, last_s_ + 1e-6);
  last_s_ = time_s;
  GaugeSample sample;
  sample.time_s = time_s;
  if (reading.kind == GaugeLine::Kind::kValues)
    sample = sample_of(reading, options_.directions, time_s);
  update.samples.push_back(std::move(sample));
}

}  // namespace alltact
