// Reads the file of a force gauge.
#include "calibration/force/collect_force.h"
#include "calibration/force/csv_lines.h"
#include "core/io/atomic_file.h"
#include "core/printable.h"
#include "core/sources/gauge/force_unit.h"
#include "core/sources/gauge/gauge_log.h"

#include <algorithm>
#include <array>
#include <map>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using GaugeJson = nlohmann::json;

Message gauge_advice() {
  return en::say("a CSV whose first line names t_s (or frame), fx_n and fy_n");
}

Error wrong_gauge(Message what, const std::filesystem::path& origin, int line) {
  return {std::move(what), en::say("{}, line {}", origin, line), gauge_advice()};
}

/// Indices of the gauge's columns; -1: missing.
struct GaugeColumns {
  std::map<std::string, int> at;
  std::array<double, 3> unit_N{1, 1, 1};
  bool is_single = false;  ///< one force along a direction
  double time_unit_s = 1;
  [[nodiscard]] int operator[](const char* name) const {
    const auto found = at.find(name);
    return found == at.end() ? -1 : found->second;
  }
};

/// Parses "fx_kgf", "Fx [kgf]", "force (g)": the name before the unit, and newtons per unit;
/// without a unit, `unit_N`. nullopt: no column of forces.
std::optional<std::pair<std::string, double>> force_column(std::string_view cell, double unit_N) {
  const std::size_t end = std::min(cell.find_first_of(" _([/"), cell.size());
  std::string name;
  for (const char c : cell.substr(0, end))
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (name == "force" || name == "load") name = "f";
  if (name != "f" && name != "fx" && name != "fy" && name != "fz") return std::nullopt;
  std::string unit;
  for (const char c : cell.substr(end))
    if (std::string_view(" _()[]/").find(c) == std::string_view::npos) unit += c;
  if (unit.empty()) return std::pair{name, unit_N};
  const auto newtons = newtons_in(unit);
  return newtons ? std::optional(std::pair{name, *newtons}) : std::nullopt;
}

/// Seconds in the unit of a column "t", "t_ms", "time_ns"; nullopt: no column of times.
std::optional<double> time_column(std::string_view cell) {
  std::string name;
  for (const char c : cell)
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == ' ' ? '_' : c;
  for (const char* word : {"time", "t"}) {
    if (!name.starts_with(word)) continue;
    const std::string unit = name.substr(std::string_view(word).size());
    if (unit.empty() || unit == "_s" || unit == "_(s)" || unit == "_[s]") return 1.0;
    if (unit == "_ms" || unit == "_(ms)") return 1e-3;
    if (unit == "_us") return 1e-6;
    if (unit == "_ns") return 1e-9;
  }
  return std::nullopt;
}

class GaugeReader {
 public:
  GaugeReader(std::string_view csv,
              const std::filesystem::path& origin,
              const GaugeFileOptions& options)
      : lines_(csv), origin_(origin), options_(options) {
    gauge_.is_on_frame_clock = csv.starts_with(kGaugeLogFormat);
  }

  Result<ForceGauge> read() {
    if (Status head = read_head(); !head) return head.error();
    while (const auto line = next_line())
      if (Status status = read_line(lines_.cells(*line)); !status) return status.error();
    const bool any = std::any_of(gauge_.readings.begin(),
                                 gauge_.readings.end(),
                                 [](const GaugeReading& reading) { return reading.has_force; });
    gauge_.has_block = std::any_of(
        gauge_.readings.begin(), gauge_.readings.end(), [](const GaugeReading& reading) {
          return !reading.block.empty();
        });
    gauge_.has_indenter = std::any_of(
        gauge_.readings.begin(), gauge_.readings.end(), [](const GaugeReading& reading) {
          return !reading.indenter.empty();
        });
    if (!any) return Error{en::say("the gauge's file holds no reading"), origin_, gauge_advice()};
    return std::move(gauge_);
  }

 private:
  [[nodiscard]] Error wrong(Message what) const {
    return wrong_gauge(std::move(what), origin_, lines_.number());
  }

  std::optional<std::string_view> next_line() {
    auto line = lines_.next();
    while (line && line->starts_with('#')) line = lines_.next();
    return line;
  }

  Status read_head() {
    const auto line = next_line();
    if (!line) return Error{en::say("the gauge's file is empty"), origin_, gauge_advice()};
    for (const std::string_view cell : lines_.cells(*line)) {
      std::string name = csv_column(cell);
      if (const auto time = time_column(cell)) {
        name = "t";
        columns_.time_unit_s = *time;
      } else if (const auto force = force_column(cell, options_.unit_N)) {
        name = force->first;
        columns_.unit_N[name == "fy" ? 1 : name == "fz" ? 2 : 0] = force->second;
      } else if (name == "fx" || name == "fy" || name == "fz" || name == "f") {
        return wrong(en::say("the column '{}' counts in no unit of force", printable(cell)));
      }
      if (!columns_.at.emplace(name, static_cast<int>(count_++)).second)
        return wrong(en::say("the column '{}' is given twice", printable(cell)));
    }
    columns_.is_single = columns_["f"] >= 0 && columns_["fx"] < 0 && columns_["fy"] < 0;
    for (const char* axis : {"fx", "fy"})
      if (columns_[axis] < 0 && !columns_.is_single)
        return wrong(en::say("the column '{}' is missing", std::string(axis) + "_n"));
    gauge_.axes = columns_["fz"] >= 0 || columns_.is_single ? 3 : 2;
    gauge_.by_time = columns_["t"] >= 0 && columns_["frame"] < 0;
    if (columns_["t"] < 0 && columns_["frame"] < 0)
      return wrong(en::say("there is neither a column 't_s' nor a column 'frame'"));
    if ((columns_["along"] < 0) != (columns_["across"] < 0))
      return wrong(en::say("of the place of contact there is only one of along_mm and across_mm"));
    gauge_.has_block = columns_["block"] >= 0, gauge_.has_day = columns_["day"] >= 0;
    gauge_.has_indenter = columns_["indenter"] >= 0;
    return {};
  }

  Status read_line(const std::vector<std::string_view>& cells) {
    if (cells.size() != count_) return wrong(en::say("has {} cells, not {}", cells.size(), count_));
    const auto cell = [&](const char* name) {
      return columns_[name] < 0 ? std::string_view()
                                : cells[static_cast<std::size_t>(columns_[name])];
    };
    GaugeReading reading;
    if (Status status = read_force(cells, reading); !status) return status;
    if (gauge_.by_time) {
      const auto time = lines_.number_in(cell("t"));
      if (!time) return wrong(en::say("'{}' is no time", printable(cell("t"))));
      reading.time_s = *time * columns_.time_unit_s;
      if (!gauge_.readings.empty() && reading.time_s <= gauge_.readings.back().time_s)
        return wrong(
            en::say("{} s comes after {} s", reading.time_s, gauge_.readings.back().time_s));
    }
    if (!cell("along").empty() || !cell("across").empty()) {
      const auto along = lines_.number_in(cell("along")), across = lines_.number_in(cell("across"));
      if (!along || !across) return wrong(en::say("the place of contact is no pair of numbers"));
      reading.position_mm = Eigen::Vector2d(*along, *across);
    }
    reading.frame = cell("frame"), reading.block = cell("block"), reading.day = cell("day");
    reading.indenter = cell("indenter");
    gauge_.readings.push_back(std::move(reading));
    return {};
  }

  /// Empty cells: no force from then on.
  Status read_force(const std::vector<std::string_view>& cells, GaugeReading& reading) {
    static constexpr std::array<const char*, 3> kAxes{"fx", "fy", "fz"};
    const auto cell = [&](const char* name) {
      return cells[static_cast<std::size_t>(columns_[name])];
    };
    const auto number = [&](const char* name, double unit_N) -> Result<double> {
      const auto force = lines_.number_in(cell(name));
      if (!force || std::abs(*force * unit_N) > 1e5)
        return wrong(en::say("'{}' is no force", printable(cell(name))));
      return *force * unit_N;
    };
    const int values = columns_.is_single ? 1 : gauge_.axes;
    const auto name_of = [&](int value) {
      return columns_.is_single ? "f" : kAxes[static_cast<std::size_t>(value)];
    };
    int empty = 0;
    for (int value = 0; value < values; ++value) empty += cell(name_of(value)).empty() ? 1 : 0;
    reading.has_force = empty < values;
    for (int value = 0; value < values && reading.has_force; ++value) {
      const auto force = number(name_of(value), columns_.unit_N[static_cast<std::size_t>(value)]);
      if (!force) return force.error();
      if (columns_.is_single)
        reading.force_N = *force * options_.direction;
      else
        reading.force_N[value] = *force;
    }
    if (columns_["sd"] >= 0)
      reading.sd_N =
          lines_.number_in(cell("sd")).value_or(std::numeric_limits<double>::quiet_NaN());
    reading.holds = columns_["holds"] >= 0 && cell("holds") == "1";
    return {};
  }

  CsvLines lines_;
  std::filesystem::path origin_;
  GaugeFileOptions options_;
  GaugeColumns columns_;
  std::size_t count_ = 0;
  ForceGauge gauge_;
};

std::optional<Eigen::Vector3d> vector_from(const GaugeJson& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  Eigen::Vector3d vector;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!json[i].is_number()) return std::nullopt;
    vector[static_cast<Eigen::Index>(i)] = json[i].get<double>();
  }
  return vector.allFinite() ? std::optional(vector) : std::nullopt;
}

/// Adds a contact's force to the reading. False: it has none, or not in the format of `simulate`.
bool add_contact(const GaugeJson& contact, double& greatest_N, GaugeReading& reading) {
  if (!contact.is_object() || !contact.contains("force_N")) return false;
  const auto force = vector_from(contact.at("force_N"));
  if (!force) return false;
  reading.force_N += *force;
  const auto along = contact.find("along_mm"), across = contact.find("across_mm");
  if (force->norm() <= greatest_N || along == contact.end() || across == contact.end() ||
      !along->is_number() || !across->is_number())
    return true;
  greatest_N = force->norm();
  reading.position_mm = Eigen::Vector2d(along->get<double>(), across->get<double>());
  return true;
}

}  // namespace

Result<ForceGauge> ForceGauge::parse_csv(std::string_view csv,
                                         const std::filesystem::path& origin,
                                         const GaugeFileOptions& options) {
  return GaugeReader(csv, origin, options).read();
}

Result<ForceGauge> ForceGauge::parse_truth(std::string_view text,
                                           const std::filesystem::path& origin) {
  const auto wrong = [&](Message what) {
    return Error{
        std::move(what), origin, en::say("truth.json of a scene whose pushes have forces")};
  };
  const GaugeJson json = GaugeJson::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("frames") || !json.at("frames").is_array())
    return wrong(en::say("holds no frames of a simulation"));
  ForceGauge gauge;
  gauge.axes = 3;
  bool any_force = false;
  for (const GaugeJson& frame : json.at("frames")) {
    if (!frame.is_object() || !frame.contains("frame") || !frame.at("frame").is_string())
      return wrong(en::say("holds a frame without a name"));
    GaugeReading reading;
    reading.frame = frame.at("frame").get<std::string>();
    double greatest_N = 0;
    bool is_complete = true;
    if (frame.contains("contacts") && frame.at("contacts").is_array())
      for (const GaugeJson& contact : frame.at("contacts"))
        is_complete = add_contact(contact, greatest_N, reading) && is_complete;
    any_force = any_force || greatest_N > 0;
    if (is_complete) gauge.readings.push_back(std::move(reading));
  }
  if (!any_force) return wrong(en::say("tells no force of any contact"));
  return gauge;
}

Result<ForceGauge> ForceGauge::load(const std::filesystem::path& file,
                                    const GaugeFileOptions& options) {
  const auto content = read_file(file);
  if (!content) return content.error();
  return file.extension() == ".json" ? parse_truth(*content, file)
                                     : parse_csv(*content, file, options);
}

}  // namespace alltact
