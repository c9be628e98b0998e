#include "calibration/checks/check_history.h"

#include "core/base/atomic_file.h"
#include "core/base/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead =
    "time_utc,verdict,error_mm,drifting_above_mm,recalibrate_above_mm,light_percent,presses,"
    "ball_radius_mm,calibration_date,program_version,bias_mm,operator";
constexpr std::string_view kEarlierHead = kHead.substr(0, kHead.find(",bias_mm"));
constexpr std::size_t kEarlierColumns = 10, kColumns = 12;
constexpr std::size_t kLargestFile = std::size_t{64} << 20;

std::string line_of(const CheckEntry& entry) {
  std::string person = entry.operator_name;  // one line, however it was typed
  std::replace_if(
      person.begin(), person.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{}", entry.time, to_string(entry.verdict), entry.error_mm,
      entry.drifting_above_mm, entry.recalibrate_above_mm, entry.light_percent, entry.presses,
      entry.ball_radius_mm, entry.calibration_date, entry.program_version,
      entry.bias_mm ? fmt::format("{}", *entry.bias_mm) : std::string(), table_cell(person));
}

/// The last one may contain commas.
std::vector<std::string> parts_of(const std::string& line) {
  std::vector<std::string> parts(1);
  for (const char c : line)
    if (c == ',' && parts.size() < kColumns)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

template <class T>
bool read(const std::string& text, T& value) {
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size()) return false;
  if constexpr (std::is_floating_point_v<T>) return std::isfinite(value);
  return true;
}

std::optional<CheckEntry> entry_from(const std::string& line) {
  const auto parts = parts_of(line);
  const bool is_earlier = parts.size() == kEarlierColumns;
  if (!(is_earlier || parts.size() == kColumns) || !unix_seconds(parts[0])) return std::nullopt;
  CheckEntry entry;
  entry.time = parts[0];
  bool is_verdict = false;
  for (const auto verdict : {CheckVerdict::kPass, CheckVerdict::kDrifting,
                             CheckVerdict::kRecalibrate, CheckVerdict::kTooFew}) {
    if (parts[1] != to_string(verdict)) continue;
    entry.verdict = verdict;
    is_verdict = true;
  }
  const bool is_complete =
      is_verdict && read(parts[2], entry.error_mm) && read(parts[3], entry.drifting_above_mm) &&
      read(parts[4], entry.recalibrate_above_mm) && read(parts[5], entry.light_percent) &&
      read(parts[6], entry.presses) && read(parts[7], entry.ball_radius_mm);
  if (!is_complete) return std::nullopt;
  entry.calibration_date = parts[8];
  entry.program_version = parts[9];
  if (is_earlier) return entry;
  if (double bias_mm = 0; !parts[10].empty()) {
    if (!read(parts[10], bias_mm)) return std::nullopt;
    entry.bias_mm = bias_mm;
  }
  entry.operator_name = table_cell_text(parts[11]);
  return entry;
}

}  // namespace

CheckEntry entry_of(const PressCheck& check, const Finger& finger, const std::string& time,
                    const std::string& program_version, const std::string& operator_name) {
  CheckEntry entry;
  entry.time = time;
  entry.verdict = check.verdict;
  entry.error_mm = check.error_mm;
  entry.drifting_above_mm = check.drifting_above_mm;
  entry.recalibrate_above_mm = check.recalibrate_above_mm;
  entry.light_percent = 100 * check.light_change;
  entry.presses = static_cast<int>(check.presses.size());
  entry.ball_radius_mm = check.ball_radius_mm;
  const std::string date = provenance_of(finger, "calibration_date");
  if (unix_seconds(date)) entry.calibration_date = date;
  entry.program_version = program_version;
  if (std::isfinite(check.bias_mm)) entry.bias_mm = check.bias_mm;
  entry.operator_name = operator_name;
  return entry;
}

CheckVerdict verdict_now(const CheckEntry& entry) {
  return entry.verdict == CheckVerdict::kPass && entry.presses < kCheckPresses
             ? CheckVerdict::kTooFew
             : entry.verdict;
}

bool is_of_calibration(const CheckEntry& entry, const Finger& finger) {
  const std::string& checked = entry.calibration_date;
  const auto made = finger.provenance.find("calibration_date");
  return checked.empty() || made == finger.provenance.end() || checked == made->second;
}

const CheckEntry* latest_check(const std::vector<CheckEntry>& history, const Finger& finger) {
  return history.empty() || !is_of_calibration(history.back(), finger) ? nullptr : &history.back();
}

Result<std::vector<CheckEntry>> load_checks(const fs::path& folder,
                                            std::vector<Message>* warnings) {
  const fs::path file = folder / kCheckFile;
  std::error_code failed;
  if (!fs::exists(file, failed)) return std::vector<CheckEntry>{};
  const auto content = read_file(file, kLargestFile);
  if (!content) return content.error();
  std::vector<CheckEntry> entries;
  std::size_t begin = 0;
  for (int number = 1; begin < content->size(); ++number) {
    std::size_t end = content->find('\n', begin);
    if (end == std::string::npos) end = content->size();
    std::string line = content->substr(begin, end - begin);
    begin = end + 1;
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line == kHead || line == kEarlierHead) continue;
    if (auto entry = entry_from(line)) {
      entries.push_back(std::move(*entry));
    } else if (warnings != nullptr) {
      warnings->push_back(en::say("{}:{}: this line is not a check and is ignored.", file, number));
    }
  }
  return entries;
}

Status append_check(const fs::path& folder, const CheckEntry& entry) {
  const fs::path file = folder / kCheckFile;
  std::string text;
  std::error_code failed;
  if (fs::exists(file, failed)) {
    auto content = read_file(file, kLargestFile);
    if (!content) return content.error();
    text = std::move(content).value();
  }
  const bool has_earlier_head =
      text.starts_with(kEarlierHead) && text.substr(kEarlierHead.size(), 1) == "\n";
  if (has_earlier_head) text.erase(0, kEarlierHead.size() + 1);
  if (text.empty() || has_earlier_head) text.insert(0, std::string(kHead) + "\n");
  if (!text.ends_with('\n')) text += '\n';
  return write_file_atomically(file, text + line_of(entry) + "\n");
}

}  // namespace alltact
