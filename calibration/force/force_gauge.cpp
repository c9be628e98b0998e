// What a gauge said, read.
#include "calibration/force/collect_force.h"
#include "calibration/force/csv_lines.h"
#include "core/io/atomic_file.h"
#include "core/printable.h"

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

/// Where the gauge's columns stand; -1: it has none.
struct GaugeColumns {
  std::map<std::string, int> at;
  [[nodiscard]] int operator[](const char* name) const {
    const auto found = at.find(name);
    return found == at.end() ? -1 : found->second;
  }
};

class GaugeReader {
 public:
  GaugeReader(std::string_view csv, const std::filesystem::path& origin)
      : lines_(csv), origin_(origin) {}

  Result<ForceGauge> read() {
    if (Status head = read_head(); !head) return head.error();
    while (const auto line = lines_.next())
      if (Status status = read_line(csv_cells(*line)); !status) return status.error();
    if (gauge_.readings.empty())
      return Error{en::say("the gauge's file holds no reading"), origin_, gauge_advice()};
    return std::move(gauge_);
  }

 private:
  [[nodiscard]] Error wrong(Message what) const {
    return wrong_gauge(std::move(what), origin_, lines_.number());
  }

  Status read_head() {
    const auto line = lines_.next();
    if (!line) return Error{en::say("the gauge's file is empty"), origin_, gauge_advice()};
    for (const std::string_view cell : csv_cells(*line)) {
      std::string name = csv_column(cell);
      if (name == "time") name = "t";
      if (!columns_.at.emplace(name, static_cast<int>(count_++)).second)
        return wrong(en::say("the column '{}' is given twice", printable(cell)));
    }
    for (const char* axis : {"fx", "fy"})
      if (columns_[axis] < 0)
        return wrong(en::say("the column '{}' is missing", std::string(axis) + "_n"));
    gauge_.axes = columns_["fz"] >= 0 ? 3 : 2;
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
    static constexpr std::array<const char*, 3> kAxes{"fx", "fy", "fz"};
    for (int axis = 0; axis < gauge_.axes; ++axis) {
      const auto force = csv_number(cell(kAxes[static_cast<std::size_t>(axis)]));
      if (!force || std::abs(*force) > 1e5)
        return wrong(
            en::say("'{}' is no force", printable(cell(kAxes[static_cast<std::size_t>(axis)]))));
      reading.force_N[axis] = *force;
    }
    if (gauge_.by_time) {
      const auto time = csv_number(cell("t"));
      if (!time) return wrong(en::say("'{}' is no time", printable(cell("t"))));
      if (!gauge_.readings.empty() && *time <= gauge_.readings.back().time_s)
        return wrong(en::say("{} s comes after {} s", *time, gauge_.readings.back().time_s));
      reading.time_s = *time;
    }
    if (!cell("along").empty() || !cell("across").empty()) {
      const auto along = csv_number(cell("along")), across = csv_number(cell("across"));
      if (!along || !across) return wrong(en::say("the place of contact is no pair of numbers"));
      reading.place_mm = Eigen::Vector2d(*along, *across);
    }
    reading.frame = cell("frame"), reading.block = cell("block"), reading.day = cell("day");
    reading.indenter = cell("indenter");
    gauge_.readings.push_back(std::move(reading));
    return {};
  }

  CsvLines lines_;
  std::filesystem::path origin_;
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

/// Adds a contact's force to the reading. False: it tells none, or not as simulate writes it.
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
  reading.place_mm = Eigen::Vector2d(along->get<double>(), across->get<double>());
  return true;
}

}  // namespace

Result<ForceGauge> ForceGauge::parse_csv(std::string_view csv,
                                         const std::filesystem::path& origin) {
  return GaugeReader(csv, origin).read();
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
    bool is_told = true;
    if (frame.contains("contacts") && frame.at("contacts").is_array())
      for (const GaugeJson& contact : frame.at("contacts"))
        is_told = add_contact(contact, greatest_N, reading) && is_told;
    any_force = any_force || greatest_N > 0;
    if (is_told) gauge.readings.push_back(std::move(reading));
  }
  if (!any_force) return wrong(en::say("tells no force of any contact"));
  return gauge;
}

Result<ForceGauge> ForceGauge::load(const std::filesystem::path& file) {
  const auto content = read_file(file);
  if (!content) return content.error();
  return file.extension() == ".json" ? parse_truth(*content, file) : parse_csv(*content, file);
}

}  // namespace alltact
