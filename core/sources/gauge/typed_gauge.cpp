#include "core/sources/gauge/typed_gauge.h"

#include "core/printable.h"
#include "core/typed_number.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

#include <poll.h>
#include <unistd.h>

namespace alltact {
namespace {

std::string trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

/// Makes a name fit for a cell of a table.
std::string typed_name(std::string name) {
  for (char& c : name)
    if (c == ',' || c == '"' || static_cast<unsigned char>(c) < ' ') c = ' ';
  return trimmed(name);
}

/// The reason why a number in the line is ambiguous, as "1,200 N".
std::optional<Message> ambiguity_in(std::string_view line) {
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(" ;"), line.size());
    const std::string_view word = line.substr(0, end);
    const std::size_t digits = std::min(word.find_first_not_of("0123456789.,'_+-"), word.size());
    if (auto ambiguity = number_ambiguity(word.substr(0, digits))) return ambiguity;
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return std::nullopt;
}

}  // namespace

TypedGauge::TypedGauge(int descriptor,
                       const GaugeLineRules& rules,
                       const GaugeDirections& directions)
    : descriptor_(descriptor), rules_(rules), directions_(directions) {
  rules_.is_comma_decimal = true;
}

Result<GaugeUpdate> TypedGauge::read(int timeout_ms) {
  GaugeUpdate update;
  update.is_over = is_over_;
  if (is_over_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
    return update;
  }
  pollfd waiting{descriptor_, POLLIN, 0};
  if (::poll(&waiting, 1, timeout_ms) <= 0) return update;
  std::array<char, 1024> bytes{};
  const ssize_t size = ::read(descriptor_, bytes.data(), bytes.size());
  if (size < 0 && (errno == EINTR || errno == EAGAIN)) return update;
  const double now_s = gauge_clock_s();
  if (size <= 0) {
    if (!unfinished_.empty()) take(std::exchange(unfinished_, {}), now_s, update);
    update.is_over = is_over_ = true;
    return update;
  }
  unfinished_.append(bytes.data(), static_cast<std::size_t>(size));
  for (std::size_t end = unfinished_.find('\n'); end != std::string::npos;
       end = unfinished_.find('\n')) {
    take(unfinished_.substr(0, end), now_s, update);
    unfinished_.erase(0, end + 1);
  }
  return update;
}

bool TypedGauge::take_name(const std::string& line, GaugeUpdate& update) {
  for (auto [word, name] : {std::pair{"block ", &block_}, {"indenter ", &indenter_}})
    if (line.starts_with(word)) {
      *name = typed_name(line.substr(std::string_view(word).size()));
      update.remarks.push_back(en::say("{} from now on", printable(line)));
      return true;
    }
  return false;
}

void TypedGauge::take(std::string line, double time_s, GaugeUpdate& update) {
  line = trimmed(line);
  time_s = last_s_ = std::max(time_s, last_s_ + 1e-6);
  GaugeSample sample;
  sample.time_s = time_s;
  if (line.empty()) {
    update.samples.push_back(sample);
    update.remarks.push_back(en::say("what was typed holds no longer"));
    return;
  }
  if (take_name(line, update)) return;
  std::string_view rest = line;
  const std::size_t blank = std::min(rest.find(' '), rest.size());
  GaugeDirections directions = directions_;
  if (const auto axis = axis_named(rest.substr(0, blank))) {
    directions.of[0] = *axis, directions.count = 1;
    rest.remove_prefix(std::min(blank + 1, rest.size()));
  }
  if (const auto ambiguity = ambiguity_in(rest)) {
    update.remarks.push_back(*ambiguity);
    return;
  }
  const GaugeLine reading = read_gauge_line(rest, rules_);
  if (reading.kind != GaugeLine::Kind::kValues || (directions.count == 1 && reading.count != 1)) {
    update.remarks.push_back(en::say(
        "'{}' is no reading; a number, 'y 1.2 N', 'block NAME', or nothing", printable(line)));
    return;
  }
  directions_ = directions;
  sample = sample_of(reading, directions_, time_s);
  sample.holds = true;
  sample.block = block_.empty() ? fmt::format("typed {}", ++count_) : block_;
  sample.indenter = indenter_;
  update.remarks.push_back(en::say(
      "{:.3f} {:.3f} {:.3f} N", sample.force_N.x(), sample.force_N.y(), sample.force_N.z()));
  update.samples.push_back(std::move(sample));
}

}  // namespace alltact
