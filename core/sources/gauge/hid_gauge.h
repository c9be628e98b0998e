// A force gauge that sends HID input reports.
#pragma once

#include "core/sources/gauge/gauge_source.h"
#include "core/sources/hid/hid_port.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace alltact {

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
  /// Parses a CSV table. The first line names at, type and optionally scale, zero, unit, id. Each
  /// line is one value; empty cells repeat the line above. Errors name the line.
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
