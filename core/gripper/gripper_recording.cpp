#include "core/gripper/gripper_recording.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/base/table.h"
#include "core/sensing/contact/contact_regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using ReadJson = nlohmann::json;

/// Thrown to reject a line.
struct RefusedLine {
  Message what;
};

const ReadJson* find_key(const ReadJson& object, const char* key) {
  const auto entry = object.find(key);
  return entry == object.end() ? nullptr : &*entry;
}

double number_of(const ReadJson& value, const char* key) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!std::isfinite(number)) throw RefusedLine{en::say("'{}' must be a number", std::string(key))};
  return number;
}

std::vector<double> numbers_of(const ReadJson& object, const char* key, std::size_t count) {
  const ReadJson* list = find_key(object, key);
  if (list == nullptr || !list->is_array() || (count > 0 && list->size() != count))
    throw RefusedLine{count > 0 ? en::say("'{}' must be {} numbers", std::string(key), count)
                                : en::say("'{}' must be numbers", std::string(key))};
  std::vector<double> numbers;
  for (const ReadJson& value : *list) numbers.push_back(number_of(value, key));
  return numbers;
}

Eigen::Vector3d vector_of(const ReadJson& object, const char* key) {
  const std::vector<double> n = numbers_of(object, key, 3);
  return {n[0], n[1], n[2]};
}

Eigen::Vector3d direction_of(const ReadJson& object, const char* key) {
  const Eigen::Vector3d direction = vector_of(object, key);
  if (!(std::abs(direction.norm() - 1) < 1e-3))
    throw RefusedLine{en::say("'{}' must be of length 1", std::string(key))};
  return direction.normalized();
}

Eigen::Matrix3d covariance_of(const ReadJson& object, const char* key) {
  const std::vector<double> n = numbers_of(object, key, 6);
  Eigen::Matrix3d covariance;
  covariance << n[0], n[1], n[2], n[1], n[3], n[4], n[2], n[4], n[5];
  const double min_value = covariance.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
  // Values are written to nine decimals.
  if (!(min_value > -1e-7 - 1e-6 * covariance.trace()))
    throw RefusedLine{en::say("'{}' is not a covariance", std::string(key))};
  return covariance;
}

ObservedContact contact_of(const ReadJson& region) {
  ObservedContact contact{vector_of(region, "place_mm"), {}, {}, {}, {}};
  if (find_key(region, "place_covariance_mm2") != nullptr)
    contact.position_covariance_mm2 = covariance_of(region, "place_covariance_mm2");
  if (find_key(region, "normal") != nullptr) contact.face_normal = direction_of(region, "normal");
  const ReadJson* sd = find_key(region, "angle_sd_deg");
  if (find_key(region, "axis") == nullptr || sd == nullptr) return contact;
  contact.axis = direction_of(region, "axis");
  contact.axis_sd_deg = number_of(*sd, "angle_sd_deg");
  if (!(*contact.axis_sd_deg >= 0))
    throw RefusedLine{en::say("'{}' must be 0 or above", std::string("angle_sd_deg"))};
  return contact;
}

RecordedContacts contacts_of(const ReadJson& line) {
  if (!line.is_object()) throw RefusedLine{en::say("is not a JSON object")};
  RecordedContacts contacts;
  const ReadJson* frame = find_key(line, "frame");
  if (frame == nullptr || !frame->is_string())
    throw RefusedLine{en::say("'{}' must be text", std::string("frame"))};
  contacts.frame = frame->get<std::string>();
  if (const ReadJson* time = find_key(line, "time_ns")) {
    if (!time->is_number_integer())
      throw RefusedLine{en::say("'{}' must be an integer", std::string("time_ns"))};
    contacts.time_ns = time->get<std::int64_t>();
  }
  if (const ReadJson* regions = find_key(line, "regions")) {
    if (!regions->is_array())
      throw RefusedLine{en::say("'{}' must be a list", std::string("regions"))};
    if (!regions->empty()) {
      if (!regions->front().is_object())
        throw RefusedLine{en::say("a region is not a JSON object")};
      contacts.contact = contact_of(regions->front());
    }
  }
  if (const ReadJson* face = find_key(line, "face"); face != nullptr && face->is_object()) {
    if (face->empty()) return contacts;
    contacts.face_u = numbers_of(*face, "u", 0);
    contacts.face_z_sd_mm = numbers_of(*face, "z_sd_mm", contacts.face_u.size());
    if (!std::is_sorted(contacts.face_u.begin(), contacts.face_u.end()))
      throw RefusedLine{en::say("'{}' must ascend", std::string("u"))};
  }
  return contacts;
}

/// The frame of the other recording, in order of time, that is nearest to a time.
std::size_t nearest_in_time(const std::vector<RecordedContacts>& frames,
                            const std::vector<std::size_t>& order, std::int64_t time_ns) {
  const auto after =
      std::lower_bound(order.begin(), order.end(), time_ns,
                       [&](std::size_t i, std::int64_t time) { return *frames[i].time_ns < time; });
  if (after == order.begin()) return order.front();
  if (after == order.end()) return order.back();
  const std::size_t before = *(after - 1);
  // In double, so that no difference overflows.
  const auto away = [&](std::size_t i) {
    return std::abs(static_cast<double>(*frames[i].time_ns) - static_cast<double>(time_ns));
  };
  return away(*after) < away(before) ? *after : before;
}

std::vector<std::size_t> in_time(const std::vector<RecordedContacts>& frames) {
  std::vector<std::size_t> order(frames.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return *frames[a].time_ns < *frames[b].time_ns;
  });
  // One frame for each time: a second one could not be the nearest to any other.
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::size_t a, std::size_t b) {
                            return *frames[a].time_ns == *frames[b].time_ns;
                          }),
              order.end());
  return order;
}

void find_unpaired(PairedFrames& paired, std::size_t first_count, std::size_t second_count) {
  std::vector<bool> first(first_count, true), second(second_count, true);
  for (const auto& [a, b] : paired.pairs) first[a] = false, second[b] = false;
  for (std::size_t i = 0; i < first_count; ++i)
    if (first[i]) paired.unpaired_first.push_back(i);
  for (std::size_t i = 0; i < second_count; ++i)
    if (second[i]) paired.unpaired_second.push_back(i);
}

}  // namespace

std::optional<double> RecordedContacts::z_sd_mm(double u) const {
  if (face_u.empty() || face_u.size() != face_z_sd_mm.size()) return std::nullopt;
  const auto after = std::upper_bound(face_u.begin(), face_u.end(), u);
  if (after == face_u.begin()) return face_z_sd_mm.front();
  if (after == face_u.end()) return face_z_sd_mm.back();
  const auto i = static_cast<std::size_t>(after - face_u.begin());
  const double part = (u - face_u[i - 1]) / (face_u[i] - face_u[i - 1]);
  return face_z_sd_mm[i - 1] + part * (face_z_sd_mm[i] - face_z_sd_mm[i - 1]);
}

Result<std::vector<RecordedContacts>> parse_recorded_contacts(const std::string& content,
                                                              const std::filesystem::path& origin) {
  std::vector<RecordedContacts> all;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find('\n', begin), content.size());
    const std::string line = content.substr(begin, end - begin);
    begin = end + 1, ++number;
    if (line.empty()) continue;
    const ReadJson json = ReadJson::parse(line, nullptr, false);
    try {
      if (json.is_discarded()) throw RefusedLine{en::say("is not JSON: {}", printable(line))};
      all.push_back(contacts_of(json));
    } catch (const RefusedLine& refused) {
      return Error{refused.what, fmt::format("{}:{}", origin.string(), number),
                   en::say("results.jsonl as alltact reconstruct wrote it")};
    }
  }
  return all;
}

Result<std::vector<RecordedContacts>> read_recorded_contacts(const std::filesystem::path& file) {
  const auto content = read_file(file);
  if (!content) return content.error();
  return parse_recorded_contacts(*content, file);
}

PairedFrames paired_frames(const std::vector<RecordedContacts>& first,
                           const std::vector<RecordedContacts>& second, std::int64_t tolerance_ns) {
  const auto has_time = [](const RecordedContacts& frame) { return frame.time_ns.has_value(); };
  PairedFrames paired;
  paired.by_time = !first.empty() && !second.empty() &&
                   std::all_of(first.begin(), first.end(), has_time) &&
                   std::all_of(second.begin(), second.end(), has_time);
  if (paired.by_time) {
    const auto first_order = in_time(first), second_order = in_time(second);
    for (const std::size_t i : first_order) {
      const std::size_t j = nearest_in_time(second, second_order, *first[i].time_ns);
      const double apart = std::abs(static_cast<double>(*first[i].time_ns) -
                                    static_cast<double>(*second[j].time_ns));
      if (apart <= static_cast<double>(tolerance_ns) &&
          nearest_in_time(first, first_order, *second[j].time_ns) == i)
        paired.pairs.emplace_back(i, j);
    }
  } else {
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
      paired.pairs.emplace_back(i, i);
  }
  find_unpaired(paired, first.size(), second.size());
  return paired;
}

namespace {

TableFormat motor_format() {
  return {
      {{"time_ns", Measure::kTime, {"t", "timestamp", "zeit", "zeitstempel", "时间"}},
       {.key = "turns",
        .measure = Measure::kTurn,
        .names = {"turn", "motorturns", "revolutions", "rotations", "rev", "umdrehungen", "圈数"},
        .names_with_unit = {"motor", "motorposition", "motorangle", "position", "angle", "winkel",
                            "rotation", "drehung", "角度"}}},
      en::say("a table of motor positions by time, with time_ns and turns"),
      en::say("for example 123456789,4.25")};
}

}  // namespace

Result<MotorLog> MotorLog::load(const std::filesystem::path& file) {
  const auto content = read_file(file);
  if (!content) return content.error();
  return parse(*content, file);
}

Result<MotorLog> MotorLog::parse(const std::string& content, const std::filesystem::path& origin) {
  auto table = Table::open(content, origin, motor_format());
  if (!table) return table.error();
  const int time_column = table->find("time_ns"), turns_column = table->find("turns");
  if (time_column < 0) return table->missing("time_ns");
  if (turns_column < 0) return table->missing("turns");
  MotorLog log;
  for (auto more = table->next();; more = table->next()) {
    if (!more) return more.error();
    if (!*more) break;
    const auto time = table->time_ns(time_column);
    if (!time) return time.error();
    const auto turns = table->number(turns_column);
    if (!turns) return turns.error();
    if (!log.lines_.empty() && *time <= log.lines_.back().first)
      return table->wrong(en::say("the time is not after that of the line before"), time_column);
    log.lines_.emplace_back(*time, *turns);
  }
  if (log.lines_.size() < 2)
    return Error{en::say("holds fewer than two motor positions"), origin,
                 en::say("a line for each time at which the motor was read")};
  log.understood_ = table->understood();
  log.remarks_ = table->remarks();
  return log;
}

std::optional<double> MotorLog::turns_at(std::int64_t time_ns) const {
  if (time_ns < lines_.front().first || time_ns > lines_.back().first) return std::nullopt;
  const auto after =
      std::lower_bound(lines_.begin(), lines_.end(), time_ns,
                       [](const auto& line, std::int64_t time) { return line.first < time; });
  if (after->first == time_ns) return after->second;
  const auto& [time, turns] = *(after - 1);
  // In double, so that no difference overflows.
  const double part = (static_cast<double>(time_ns) - static_cast<double>(time)) /
                      (static_cast<double>(after->first) - static_cast<double>(time));
  return turns + std::clamp(part, 0.0, 1.0) * (after->second - turns);
}

}  // namespace alltact
