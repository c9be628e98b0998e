// A force gauge that tells in HID input reports.
#pragma once

#include "core/sources/gauge/gauge_source.h"
#include "core/sources/hid/hid_port.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

namespace alltact {

/// Where the values stand in a gauge's reports, for devices that the program does not know.
struct GaugeReport {
  enum class Type { kU8 = 1, kS8, kU16, kS16, kU24, kS24, kU32, kS32, kF32 };
  struct Value {
    std::size_t at = 0;  ///< first byte, behind the report's id
    Type type = Type::kS16;
    bool is_big_endian = false;
    double scale = 1;  ///< units for one count
    double zero = 0;   ///< counts without load
    double unit_N = 1;
  };
  std::uint8_t id = 0;        ///< 0 where the device has no ids
  std::vector<Value> values;  ///< 1 to 3

  /// "id=3 at=1 type=s16 scale=0.01 unit=N at=3": what is told before the first at= and of one
  /// value counts for those behind it too. Types u8, s8, u16, s16, u24, s24, u32, s32, f32, low
  /// byte first, or with "be" behind high byte first. Error: not of that form or impossible.
  static Result<GaugeReport> parse(const std::string& text);
  /// A table: CSV whose first line names at, type and as it likes scale, zero, unit, id; a line a
  /// value, where empty cells are as above. Errors name the line.
  static Result<GaugeReport> parse_table(std::string_view csv, const std::filesystem::path& origin);
  /// `told`: the text of parse(), or the file of a table.
  static Result<GaugeReport> from(const std::string& told);

  /// What a report says; noise: another report, or too short. Over range: a whole number at the end
  /// of its type's range (of an unsigned one the upper end), a broken one that is not finite.
  [[nodiscard]] GaugeLine read(std::span<const std::uint8_t> report) const;
};

class HidGauge : public GaugeSource {
 public:
  HidGauge(std::unique_ptr<HidPort> port, GaugeReport report, const GaugeDirections& directions)
      : port_(std::move(port)), report_(std::move(report)), directions_(directions) {}

  /// A sample a report, of when it came.
  [[nodiscard]] Result<GaugeNews> read(int timeout_ms) override;
  [[nodiscard]] int axes() const override { return static_cast<int>(report_.values.size()); }

 private:
  std::unique_ptr<HidPort> port_;
  GaugeReport report_;
  GaugeDirections directions_;
  double last_s_ = 0;
  int passed_over_ = 0;
};

}  // namespace alltact
