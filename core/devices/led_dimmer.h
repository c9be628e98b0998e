// The brightness of the finger's LEDs, through a USB HID device.
#pragma once

#include "core/base/result.h"
#include "core/devices/hid_port.h"
#include "core/sources/source.h"

#include <memory>
#include <string>

namespace alltact {

/// Layout of a brightness report, for devices that the program does not know.
struct DimmerReport {
  bool is_feature = false;       ///< else an output report
  std::uint8_t id = 0;           ///< 0 where the device has no ids
  std::size_t bytes = 1;         ///< of the report without its id, 1..4095
  std::size_t at = 0;            ///< index of the byte; a high above 255 takes two, low byte first
  unsigned low = 0, high = 255;  ///< dark and bright, up to 65535; low > high inverts

  /// Parses "output id=0 bytes=8 at=1 range=0..255" (or feature). Error: not of that form or
  /// impossible.
  static Result<DimmerReport> parse(const std::string& text);
  [[nodiscard]] std::string text() const;
  bool operator==(const DimmerReport&) const = default;
};

/// Light settings of a calibration.
struct DimmerSetting {
  std::string device;   ///< HidIdentity::stable_name()
  std::string control;  ///< "mcp2221a gp2", "mcp2221a gp3", or a DimmerReport
  double level = 0;     ///< 0 dark, 1 full brightness, rounded to the device's steps
  bool operator==(const DimmerSetting&) const = default;
};

/// One thread.
class LedDimmer {
 public:
  /// control as in DimmerSetting. The MCP2221A's converter has 32 steps between 0 V and its supply;
  /// the other pins and the analogue inputs retain their settings. Error: `control` is not
  /// understood, or the chip does not answer.
  static Result<LedDimmer> create(std::unique_ptr<HidPort> port, const std::string& device,
                                  const std::string& control);

  /// level in [0, 1]. Error: outside, or the device refused it.
  [[nodiscard]] Status set(double level);
  [[nodiscard]] const DimmerSetting& setting() const { return setting_; }

 private:
  LedDimmer() = default;
  [[nodiscard]] Status configure_pin();
  [[nodiscard]] Status set_converter(unsigned step);
  [[nodiscard]] Status set_report(unsigned step);
  [[nodiscard]] Result<std::vector<std::uint8_t>> query_chip(
      const std::vector<std::uint8_t>& command);

  std::unique_ptr<HidPort> port_;
  DimmerSetting setting_;
  int pin_ = 0;  // of the MCP2221A; 0: described by report_
  DimmerReport report_;
};

// A source that adds the setting of the finger's light to its frames.

/// Appends a dimmer's setting to each frame's own settings. One thread.
class LightStamp {
 public:
  explicit LightStamp(const DimmerSetting& light);
  /// Shares the pixels. `frame` must not be null.
  [[nodiscard]] FramePtr operator()(const FramePtr& frame);

 private:
  std::string light_;
  std::shared_ptr<const std::string> before_, with_light_;  // usually the same from frame to frame
};

/// Another source, with stamped frames.
class LitSource : public Source {
 public:
  LitSource(std::unique_ptr<Source> source, const DimmerSetting& light)
      : source_(std::move(source)), stamp_(light) {}

  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return source_->count(); }
  [[nodiscard]] bool is_continuous() const override { return source_->is_continuous(); }
  [[nodiscard]] bool is_live() const override { return source_->is_live(); }
  [[nodiscard]] double frames_per_s() const override { return source_->frames_per_s(); }

 private:
  std::unique_ptr<Source> source_;
  LightStamp stamp_;
};

}  // namespace alltact
