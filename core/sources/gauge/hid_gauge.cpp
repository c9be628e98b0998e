#include "core/sources/gauge/hid_gauge.h"

#include "core/io/atomic_file.h"
#include "core/printable.h"
#include "core/sources/gauge/force_unit.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <sstream>

namespace alltact {
namespace {

constexpr std::size_t kMaxReportBytes = 4095, kMaxGaugeValues = 3;
constexpr int kForeignReportLimit = 50;

using ValueType = GaugeReport::Type;

struct TypeName {
  std::string_view name;
  ValueType type;
  std::size_t bytes;
  bool is_signed;
};
constexpr std::array<TypeName, 9> kTypeNames{{{"u8", ValueType::kU8, 1, false},
                                              {"s8", ValueType::kS8, 1, true},
                                              {"u16", ValueType::kU16, 2, false},
                                              {"s16", ValueType::kS16, 2, true},
                                              {"u24", ValueType::kU24, 3, false},
                                              {"s24", ValueType::kS24, 3, true},
                                              {"u32", ValueType::kU32, 4, false},
                                              {"s32", ValueType::kS32, 4, true},
                                              {"f32", ValueType::kF32, 4, true}}};

const TypeName& type_of(const GaugeReport::Value& value) {
  return kTypeNames.at(static_cast<std::size_t>(value.type) - 1);
}

Message report_advice() {
  return en::say(
      "such as 'id=3 at=1 type=s16 scale=0.01 unit=N', or a table with at, type, scale, "
      "zero, unit");
}

template <class T>
bool read_all(std::string_view text, T& number) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  return status == std::errc{} && end == text.data() + text.size();
}

/// Sets `key`=`text` of a value; false: no such key, or a wrong form.
bool take_setting(std::string_view key, std::string_view text, GaugeReport::Value& value) {
  if (key == "at") return read_all(text, value.at);
  if (key == "scale")
    return read_all(text, value.scale) && std::isfinite(value.scale) && value.scale != 0;
  if (key == "zero") return read_all(text, value.zero) && std::isfinite(value.zero);
  if (key == "unit") {
    const auto unit = newtons_in(text);
    value.unit_N = unit.value_or(1);
    return unit.has_value();
  }
  if (key != "type") return false;
  value.is_big_endian = text.ends_with("be");
  if (text.ends_with("be") || text.ends_with("le")) text.remove_suffix(2);
  for (const TypeName& name : kTypeNames)
    if (name.name == text) return value.type = name.type, true;
  return false;
}

bool is_possible(const GaugeReport& report) {
  if (report.values.empty() || report.values.size() > kMaxGaugeValues) return false;
  for (const GaugeReport::Value& value : report.values)
    if (value.at + type_of(value).bytes > kMaxReportBytes) return false;
  return true;
}

std::uint32_t bits_at(const GaugeReport::Value& value, std::span<const std::uint8_t> bytes) {
  const std::size_t count = type_of(value).bytes;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < count; ++i)
    bits = bits << 8U | bytes[value.at + (value.is_big_endian ? i : count - 1 - i)];
  return bits;
}

/// nullopt: over range.
std::optional<double> counts_of(const GaugeReport::Value& value, std::uint32_t bits) {
  if (value.type == ValueType::kF32) {
    const auto number = static_cast<double>(std::bit_cast<float>(bits));
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
  }
  const TypeName& type = type_of(value);
  const auto range = std::int64_t{1} << (8 * type.bytes);
  auto number = static_cast<std::int64_t>(bits);
  if (type.is_signed && number >= range / 2) number -= range;
  const std::int64_t max = (type.is_signed ? range / 2 : range) - 1;
  if (number == max || (type.is_signed && number == -range / 2)) return std::nullopt;
  return static_cast<double>(number);
}

std::vector<std::string> table_cells(std::string_view line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') cells.emplace_back();
    if (c != ',' && c != ' ' && c != '\t' && c != '"' && c != '\r') cells.back() += c;
  }
  return cells;
}

}  // namespace

Result<GaugeReport> GaugeReport::parse(const std::string& text) {
  const Error wrong{
      en::say("'{}' describes no report of a gauge", printable(text)), "", report_advice()};
  GaugeReport report;
  Value value;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) return wrong;
    const std::string key = word.substr(0, equals), setting = word.substr(equals + 1);
    if (key == "id") {
      if (!read_all(setting, report.id)) return wrong;
      continue;
    }
    if (!take_setting(key, setting, value)) return wrong;
    if (key == "at")
      report.values.push_back(value);
    else if (!report.values.empty())
      report.values.back() = value;
  }
  return is_possible(report) ? Result<GaugeReport>(report) : wrong;
}

Result<GaugeReport> GaugeReport::parse_table(std::string_view csv,
                                             const std::filesystem::path& origin) {
  GaugeReport report;
  Value value;  // empty cells repeat the line above
  std::vector<std::string> names;
  std::istringstream lines{std::string(csv)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const Where where = en::say("{}, line {}", origin, number);
    auto cells = table_cells(line);
    if (cells == std::vector<std::string>{""} || line.starts_with('#')) continue;
    if (names.empty()) {
      names = std::move(cells);
      continue;
    }
    if (cells.size() != names.size())
      return Error{
          en::say("has {} cells, not {}", cells.size(), names.size()), where, report_advice()};
    bool has_offset = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].empty()) continue;
      has_offset = has_offset || names[i] == "at";
      const bool is_taken = names[i] == "id" ? read_all(cells[i], report.id)
                                             : take_setting(names[i], cells[i], value);
      if (!is_taken)
        return Error{en::say("'{}' is no {}", printable(cells[i]), printable(names[i])),
                     where,
                     report_advice()};
    }
    if (!has_offset)
      return Error{
          en::say("the column '{}' is missing", std::string("at")), where, report_advice()};
    report.values.push_back(value);
  }
  if (!is_possible(report))
    return Error{en::say("the table describes no report of a gauge"), origin, report_advice()};
  return report;
}

Result<GaugeReport> GaugeReport::from(const std::string& description) {
  std::error_code ignored;
  if (description.find('=') != std::string::npos || !std::filesystem::exists(description, ignored))
    return parse(description);
  const auto content = read_file(description, std::size_t{1} << 20);
  if (!content) return content.error();
  return parse_table(*content, description);
}

GaugeLine GaugeReport::read(std::span<const std::uint8_t> report) const {
  GaugeLine reading;
  if (id != 0) {
    if (report.empty() || report[0] != id) return reading;
    report = report.subspan(1);
  }
  for (const Value& value : values) {
    if (report.size() < value.at + type_of(value).bytes) return GaugeLine();
    const auto counts = counts_of(value, bits_at(value, report));
    if (!counts) return reading.kind = GaugeLine::Kind::kOverRange, reading;
    const auto at = static_cast<std::size_t>(reading.count++);
    const double count_N = value.scale * value.unit_N;
    reading.force_N[at] = (*counts - value.zero) * count_N;
    if (!(std::abs(reading.force_N[at]) <= 1e5))
      return reading.kind = GaugeLine::Kind::kOverRange, reading;
    reading.digit_N[at] = value.type == Type::kF32 ? 0 : std::abs(count_N);
  }
  reading.kind = GaugeLine::Kind::kValues;
  return reading;
}

Result<GaugeUpdate> HidGauge::read(int timeout_ms) {
  GaugeUpdate update;
  // Reports that have already arrived belong to this answer, too.
  for (int wait_ms = timeout_ms; update.samples.size() < 1000; wait_ms = 0) {
    const auto report = port_->read(wait_ms);
    if (!report) {
      if (update.samples.empty()) return report.error();
      return update;
    }
    if (report->empty()) return update;
    const GaugeLine reading = report_.read(*report);
    if (reading.kind == GaugeLine::Kind::kNoise) {
      if (++foreign_reports_ == kForeignReportLimit)
        update.remarks.push_back(
            en::say("The device tells other reports than the one described. Try: its id and "
                    "length."));
      continue;
    }
    foreign_reports_ = 0;
    last_s_ = std::max(gauge_clock_s(), last_s_ + 1e-6);
    GaugeSample sample;
    sample.time_s = last_s_;
    if (reading.kind == GaugeLine::Kind::kValues) sample = sample_of(reading, directions_, last_s_);
    update.samples.push_back(std::move(sample));
  }
  return update;
}

}  // namespace alltact
