#include "calibration/checks/gage_readings.h"

#include "calibration/checks/check_history.h"
#include "core/base/atomic_file.h"
#include "core/base/table.h"
#include "core/finger/finger_store.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <boost/multiprecision/cpp_dec_float.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using Decimal = boost::multiprecision::cpp_dec_float_50;

constexpr std::size_t kMaxTableBytes = std::size_t{256} << 20;

TableFormat gage_format() {
  return {{{"part", {}, {"finger", "sample", "specimen", "workpiece"}},
           {"operator", {}, {"appraiser", "person", "technician", "inspector"}},
           {"value_mm", Measure::kLength, {"reading", "measurement", "measuredvalue"}}},
          en::say("a table whose head names part, operator and value_mm")};
}

Result<std::string> name_in(const Table& table, int column) {
  if (column < 0) return std::string();
  const std::string_view text = table.text(column);
  if (text.empty()) return table.wrong(en::say("the cell is empty"), column);
  return printable(text);
}

/// The check's reading; nullopt: it belongs to another calibration, or lacks bias or operator.
std::optional<double> reading_of(const CheckEntry& check, const Finger& finger) {
  return is_of_calibration(check, finger) && !check.operator_name.empty() ? check.bias_mm
                                                                          : std::nullopt;
}

/// Names of the fingers' folders, with those above where two are the same.
std::vector<std::string> names_of(const std::vector<fs::path>& folders) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  bool are_distinct = true;
  for (const fs::path& folder : folders) {
    names.push_back((folder / "").parent_path().filename().string());
    are_distinct = seen.insert(names.back()).second && are_distinct;
  }
  if (!are_distinct)
    std::transform(folders.begin(), folders.end(), names.begin(),
                   [](const fs::path& folder) { return folder.string(); });
  return names;
}

}  // namespace

Result<GageReadings> read_gage_table(const fs::path& file) {
  const auto content = read_file(file, kMaxTableBytes);
  if (!content) return content.error();
  auto table = Table::open(*content, file, gage_format());
  if (!table) return table.error();
  const int part = table->find("part"), person = table->find("operator");
  const int value = table->find("value_mm");
  if (part < 0) return table->missing("part");
  if (value < 0) return table->missing("value_mm");
  const auto unit =
      table->columns()[static_cast<std::size_t>(value)].unit.value_or(MeasurementUnit());
  GageReadings all;
  std::optional<Decimal> origin;
  for (auto more = table->next();; more = table->next()) {
    if (!more) return more.error();
    if (!*more) break;
    const auto of = name_in(*table, part), by = name_in(*table, person);
    const auto digits = table->digits(value);
    if (!of) return of.error();
    if (!by) return by.error();
    if (!digits) return digits.error();
    const Decimal exact(*digits);
    if (!origin) {
      origin = exact;
      all.origin_mm = unit.convert(exact.convert_to<double>());
    }
    const double value_mm = unit.convert(Decimal(exact - *origin).convert_to<double>());
    if (!std::isfinite(value_mm)) return table->wrong(en::say("the number is too large"), value);
    all.readings.push_back({*of, *by, value_mm});
  }
  if (all.readings.empty())
    return Error{en::say("the table has no rows"), file, en::say("one row for each reading")};
  all.remarks = table->remarks();
  return all;
}

Result<GageReadings> read_gage_checks(const std::vector<fs::path>& fingers, const Job& job) {
  for (std::size_t i = 0; i < fingers.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code failed;
      if (fs::equivalent(fingers[i], fingers[j], failed))
        return Error{en::say("the same finger is named twice"), fingers[i],
                     en::say("naming each finger once")};
    }
  GageReadings all;
  const std::vector<std::string> names = names_of(fingers);
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    if (job.stop_requested()) return Error{en::say("stopped"), "", ""};
    const auto finger = open_finger(fingers[i]);
    if (!finger) return finger.error();
    const auto checks = load_checks(fingers[i], &all.remarks);
    if (!checks) return checks.error();
    std::size_t used = 0;
    for (const CheckEntry& check : *checks)
      if (const auto bias_mm = reading_of(check, (*finger)->finger)) {
        all.readings.push_back({names[i], check.operator_name, *bias_mm});
        ++used;
      }
    if (const std::size_t unused = checks->size() - used; unused > 0)
      all.remarks.push_back(
          en::count("{1}: {0} checks of another calibration or without an operator are left out.",
                    "{1}: {0} check of another calibration or without an operator is left out.",
                    unused, names[i]));
  }
  if (all.readings.empty())
    return Error{en::say("no check of these fingers names its operator"), "",
                 en::say("alltact check FINGER --presses ... --operator NAME, two times or more by "
                         "each operator")};
  std::size_t left_out = 0;
  all.readings = balanced(all.readings, left_out);
  if (left_out > 0)
    all.remarks.push_back(
        en::count("{0} earlier checks are left out, so that each finger has as many by each "
                  "operator.",
                  "{0} earlier check is left out, so that each finger has as many by each "
                  "operator.",
                  left_out));
  return all;
}

}  // namespace alltact
