#include "core/devices/led_dimmer.h"

#include "core/base/message.h"
#include "core/image/frame.h"

#include <charconv>
#include <sstream>

namespace alltact {
namespace {

// MCP2221A data sheet (DS20005565), 3.1.13 "Set SRAM settings" and 3.1.14 "Get SRAM settings".
constexpr std::size_t kChipReport = 64;
constexpr std::uint8_t kSetSram = 0x60, kGetSram = 0x61, kChange = 0x80;
constexpr std::uint8_t kPinMask = 0x07, kPinIsConverter = 0x03;  // GP2: DAC1, GP3: DAC2
constexpr std::size_t kAdcAnswer = 7, kPinsAnswer = 22;          // positions in the answer
constexpr unsigned kChipSteps = 31;

Error not_understood(const std::string& control) {
  return {en::say("'{}' does not describe a dimmer", printable(control)), "",
          en::say("mcp2221a gp2, mcp2221a gp3, or a report such as 'output id=0 bytes=8 at=1 "
                  "range=0..255'")};
}

template <class T>
bool read_integer(std::string_view text, T& number) {
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  return status == std::errc{} && end == text.data() + text.size();
}

bool read_range(std::string_view text, DimmerReport& report) {
  const std::size_t dots = text.find("..");
  return dots != std::string_view::npos && read_integer(text.substr(0, dots), report.low) &&
         read_integer(text.substr(dots + 2), report.high);
}

bool read_word(const std::string& word, DimmerReport& report) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) return false;
  const std::string_view key = std::string_view(word).substr(0, equals);
  const std::string_view value = std::string_view(word).substr(equals + 1);
  if (key == "id") return read_integer(value, report.id);
  if (key == "bytes") return read_integer(value, report.bytes);
  if (key == "at") return read_integer(value, report.at);
  return key == "range" && read_range(value, report);
}

bool has_two_bytes(const DimmerReport& report) { return std::max(report.low, report.high) > 255; }

}  // namespace

Result<DimmerReport> DimmerReport::parse(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  words >> word;
  if (word != "output" && word != "feature") return not_understood(text);
  DimmerReport report;
  report.is_feature = word == "feature";
  while (words >> word)
    if (!read_word(word, report)) return not_understood(text);
  const std::size_t last = report.at + (has_two_bytes(report) ? 1 : 0);
  if (report.bytes < 1 || report.bytes > 4095 || last >= report.bytes ||
      report.low == report.high || std::max(report.low, report.high) > 65535)
    return not_understood(text);
  return report;
}

std::string DimmerReport::text() const {
  return fmt::format("{} id={} bytes={} at={} range={}..{}", is_feature ? "feature" : "output", id,
                     bytes, at, low, high);
}

Result<LedDimmer> LedDimmer::create(std::unique_ptr<HidPort> port, const std::string& device,
                                    const std::string& control) {
  LedDimmer dimmer;
  dimmer.port_ = std::move(port);
  dimmer.setting_ = {device, control, 0};
  if (control == "mcp2221a gp2") dimmer.pin_ = 2;
  if (control == "mcp2221a gp3") dimmer.pin_ = 3;
  if (dimmer.pin_ != 0) {
    if (const Status status = dimmer.configure_pin(); !status) return status.error();
    return dimmer;
  }
  const auto report = DimmerReport::parse(control);
  if (!report) return report.error();
  dimmer.report_ = *report;
  return dimmer;
}

Status LedDimmer::set(double level) {
  if (!(level >= 0 && level <= 1))
    return Error{en::say("the brightness {} is not from 0 to 1", level), setting_.device, ""};
  const double low = pin_ != 0 ? 0 : report_.low;
  const double high = pin_ != 0 ? kChipSteps : report_.high;
  const double step = std::round(low + level * (high - low));
  const auto value = static_cast<unsigned>(step);
  const Status status = pin_ != 0 ? set_converter(value) : set_report(value);
  if (status.ok()) setting_.level = (step - low) / (high - low);
  return status;
}

Status LedDimmer::set_report(unsigned step) {
  std::vector<std::uint8_t> bytes(report_.bytes + 1, 0);
  bytes[0] = report_.id;
  bytes[report_.at + 1] = static_cast<std::uint8_t>(step & 0xFFU);
  if (has_two_bytes(report_)) bytes[report_.at + 2] = static_cast<std::uint8_t>(step >> 8U);
  return report_.is_feature ? port_->send_feature(bytes) : port_->write(bytes);
}

Result<std::vector<std::uint8_t>> LedDimmer::query_chip(const std::vector<std::uint8_t>& command) {
  std::vector<std::uint8_t> bytes(kChipReport + 1, 0);  // with the id 0 before it
  std::copy(command.begin(), command.end(), bytes.begin() + 1);
  if (const Status status = port_->write(bytes); !status) return status.error();
  auto answer = port_->read(500);
  if (!answer.ok()) return answer;
  const bool is_good =
      answer->size() == kChipReport && (*answer)[0] == command[0] && (*answer)[1] == 0;
  if (!is_good)
    return Error{en::say("the MCP2221A did not answer as expected"), setting_.device,
                 en::say("plug it in again; close other programs that use it")};
  return answer;
}

Status LedDimmer::configure_pin() {
  const auto now = query_chip({kGetSram});
  if (!now) return now.error();
  const auto pin = static_cast<std::size_t>(pin_);
  std::vector<std::uint8_t> command(12, 0);
  command[0] = kSetSram;
  command[3] = kChange;  // converter's reference: the supply
  // A change of pins resets the references (data sheet 1.8.1.1): they are written again.
  command[5] = static_cast<std::uint8_t>(kChange | (((*now)[kAdcAnswer] >> 2U) & 0x07U));
  command[7] = kChange;
  for (std::size_t i = 0; i < 4; ++i) command[8 + i] = (*now)[kPinsAnswer + i];
  if ((command[8 + pin] & kPinMask) == kPinIsConverter) return {};  // the brightness stays the same
  command[8 + pin] = static_cast<std::uint8_t>((command[8 + pin] & ~kPinMask) | kPinIsConverter);
  const auto answer = query_chip(command);
  return answer.ok() ? Status() : answer.error();
}

Status LedDimmer::set_converter(unsigned step) {
  const auto answer =
      query_chip({kSetSram, 0, 0, kChange, static_cast<std::uint8_t>(kChange | step)});
  return answer.ok() ? Status() : answer.error();
}

LightStamp::LightStamp(const DimmerSetting& light)
    : light_(fmt::format("{:.4g} by {} ({})", light.level, light.device, light.control)) {}

FramePtr LightStamp::operator()(const FramePtr& frame) {
  if (with_light_ == nullptr || frame->controls != before_) {
    before_ = frame->controls;
    std::string settings = before_ == nullptr ? std::string() : *before_;
    add_setting(settings, "Light", light_);
    with_light_ = std::make_shared<const std::string>(std::move(settings));
  }
  auto lit = std::make_shared<Frame>(*frame);  // shares the pixels
  lit->controls = with_light_;
  return lit;
}

Result<FramePtr> LitSource::next() {
  auto frame = source_->next();
  if (!frame || !*frame) return frame;
  return stamp_(*frame);
}

}  // namespace alltact
