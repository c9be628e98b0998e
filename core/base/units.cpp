#include "core/base/units.h"

#include "core/base/letters.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

namespace alltact {
namespace {

struct NamedUnit {
  Measure measure;
  MeasurementUnit unit;
  std::string_view names;  // in lower case, with a blank before and behind each
};

constexpr double kGravity = 9.80665, kPoundKg = 0.45359237;

constexpr std::array<NamedUnit, 23> kUnits{{
    {Measure::kTime, {1, 1e9, "ns"}, " ns nsec nanoseconds nanosekunden "},
    {Measure::kTime, {1, 1e6, "us"}, " us usec microseconds mikrosekunden 微秒 "},
    {Measure::kTime,
     {1, 1e3, "ms"},
     " ms msec msek millisecond milliseconds millisekunden millisecondes milisaniye 毫秒 "},
    {Measure::kTime,
     {1, 1, "s"},
     " s sec secs sek second seconds sekunde sekunden seconde secondes saniye sn segundos secondi "
     "秒 "},
    {Measure::kTime, {60, 1, "min"}, " min mins minute minutes minuten dakika minutos minuti 分 "},
    {Measure::kTime, {3600, 1, "h"}, " h hr hrs hour hours stunde stunden heures saat horas ore "},
    {Measure::kTime, {86400, 1, "d"}, " d day days tage jours "},
    {Measure::kForce, {1, 1, "N"}, " n newton newtons 牛 牛顿 "},
    {Measure::kForce, {1, 1e3, "mN"}, " mn millinewton millinewtons 毫牛 "},
    {Measure::kForce, {1e3, 1, "kN"}, " kn kilonewton kilonewtons 千牛 "},
    {Measure::kForce, {kGravity, 1e3, "gf"}, " g gf gram grams gramm 克 "},
    {Measure::kForce, {kGravity, 1, "kgf"}, " kg kgf kp 公斤 千克 "},
    {Measure::kForce, {kPoundKg * kGravity, 1, "lbf"}, " lb lbf lbs "},
    {Measure::kForce, {kPoundKg * kGravity, 16, "ozf"}, " oz ozf "},
    {Measure::kLength, {1, 1e3, "um"}, " um micron microns 微米 "},
    {Measure::kLength, {1, 1, "mm"}, " mm millimeter millimeters millimetre millimetres 毫米 "},
    {Measure::kLength, {10, 1, "cm"}, " cm 厘米 "},
    {Measure::kLength, {1e3, 1, "m"}, " m meter meters metre metres 米 "},
    {Measure::kLength, {25.4, 1, "in"}, " in inch inches zoll "},
    {Measure::kTurn, {1, 1, "turns"}, " turn turns rev revs revolutions umdrehungen 圈 "},
    {Measure::kTurn, {1, 360, "deg"}, " deg degree degrees ° grad 度 "},
    {Measure::kTurn, {1, 2 * std::numbers::pi, "rad"}, " rad radian radians "},
    {Measure::kPixel, {1, 1, "px"}, " px pixel pixels 像素 "},
}};

/// In lower case, with a u for either micro sign.
std::string plain_unit(std::string_view name) {
  std::string lower;
  for (; !name.empty(); name.remove_prefix(1)) {
    const bool is_micro = name.starts_with("µ") || name.starts_with("μ");
    lower += is_micro ? 'u' : lowered(name.front());
    if (is_micro) name.remove_prefix(1);
  }
  return lower;
}

}  // namespace

std::optional<MeasurementUnit> measurement_unit(Measure measure, std::string_view name) {
  if (name == "MN" || name.empty() || name.find(' ') != std::string_view::npos) return std::nullopt;
  const std::string word = ' ' + plain_unit(name) + ' ';
  for (const NamedUnit& one : kUnits)
    if (one.measure == measure && one.names.find(word) != std::string_view::npos) return one.unit;
  return std::nullopt;
}

std::string measurement_units(Measure measure) {
  std::string list;
  for (const NamedUnit& one : kUnits)
    if (one.measure == measure) list += (list.empty() ? "" : ", ") + std::string(one.unit.symbol);
  return list;
}

bool is_measurement_unit(std::string_view name) {
  using enum Measure;
  return std::any_of(kUnits.begin(), kUnits.end(), [&](const NamedUnit& one) {
    return measurement_unit(one.measure, name).has_value();
  });
}

}  // namespace alltact
