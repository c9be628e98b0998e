#include "core/devices/open_gauge.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/table.h"
#include "core/devices/gauge_source.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace alltact {
namespace {

/// Factory settings: Mark-10 series 5 and 7 (GCL2, "?" asks for the reading shown), Imada DST and
/// ZTS ("D"), Sauter FH and FL ("9").
struct GaugeModel {
  std::string_view name, ask;
  int baud;
  GaugeFormat format;
};
constexpr std::array<GaugeModel, 3> kGaugeModels{{{"mark10", "?\r\n", 115200, GaugeFormat::kPlain},
                                                  {"imada", "D\r", 19200, GaugeFormat::kPlain},
                                                  {"sauter", "9", 9600, GaugeFormat::kSauter}}};

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

Result<GaugeOpener> serial_opener(const GaugeChoice& choice, const GaugeLineRules& rules,
                                  const GaugeDirections& directions) {
  SerialGaugeOptions options;
  options.node = choice.gauge.substr(std::string_view("serial:").size());
  options.rules = rules;
  options.directions = directions;
  options.ask_every_s = choice.ask_every_s;
  if (!choice.model.empty()) {
    const auto model = std::find_if(kGaugeModels.begin(), kGaugeModels.end(),
                                    [&](const auto& m) { return m.name == choice.model; });
    if (model == kGaugeModels.end())
      return Error{en::say("there is no gauge '{}'", printable(choice.model)), "",
                   en::say("mark10, imada or sauter, or the question and the speed")};
    options.ask = model->ask, options.baud = model->baud, options.rules.format = model->format;
  }
  if (!choice.ask.empty()) {
    const auto ask = unescaped(choice.ask);
    if (!ask) return ask.error();
    options.ask = *ask;
  }
  if (choice.baud != 0) options.baud = choice.baud;
  return GaugeOpener([options] { return SerialGauge::open(options); });
}

Result<GaugeOpener> hid_opener(const GaugeChoice& choice, const GaugeDirections& directions) {
  const std::string device = choice.gauge.substr(std::string_view("hid:").size());
  const auto report = GaugeReport::from(choice.report);
  if (!report) return report.error();
  if (directions.count != 0 && directions.count != static_cast<int>(report->values.size()))
    return Error{
        en::say("there are {} directions for {} values", directions.count, report->values.size()),
        "", en::say("one for each, as x/y/z")};
  return GaugeOpener([=, report = *report]() -> Result<std::unique_ptr<GaugeSource>> {
    auto port = open_hid(device);
    if (!port) return port.error();
    return std::unique_ptr<GaugeSource>(
        std::make_unique<HidGauge>(std::move(*port), report, directions));
  });
}

}  // namespace

Result<std::string> unescaped(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      bytes += text[i];
      continue;
    }
    const char kind = i + 1 < text.size() ? text[++i] : ' ';
    const int high = i + 1 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (kind == 'r' || kind == 'n' || kind == '\\') {
      bytes += kind == 'r' ? '\r' : kind == 'n' ? '\n' : '\\';
    } else if (kind == 'x' && high >= 0 && low >= 0) {
      bytes += static_cast<char>(16 * high + low);
      i += 2;
    } else {
      return Error{en::say("'{}' is not a text with \\r, \\n, \\xHH", printable(text)), "", ""};
    }
  }
  return bytes;
}

Result<GaugeOpener> gauge_opener(const GaugeChoice& choice) {
  GaugeDirections directions;
  if (!choice.direction.empty()) {
    const auto given = GaugeDirections::parse(choice.direction);
    if (!given) return given.error();
    directions = *given;
  }
  GaugeLineRules rules;
  if (!choice.unit.empty()) {
    const auto unit = newtons_in(choice.unit);
    if (!unit)
      return Error{en::say("'{}' is not a unit of force", printable(choice.unit)), "",
                   en::say("N, mN, kN, g, kgf, lbf or ozf")};
    rules.unit_N = *unit;
  }
  const bool is_serial = choice.gauge.starts_with("serial:");
  const bool is_hid = choice.gauge.starts_with("hid:");
  if (is_hid && !choice.unit.empty())
    return Error{en::say("the unit of a HID gauge belongs in its report's description"),
                 choice.gauge, en::say("unit= in the report's description")};
  if (!is_serial && (!choice.model.empty() || !choice.ask.empty() || choice.baud != 0))
    return Error{en::say("model, speed and question apply only to a serial gauge"), choice.gauge,
                 en::say("serial:/dev/ttyUSB0")};
  if (is_hid == choice.report.empty())
    return Error{is_hid
                     ? en::say("the position of the force in the gauge's reports is not specified")
                     : en::say("a report is specified for a gauge that is not a HID device"),
                 choice.gauge, en::say("hid:DEVICE and 'id=3 at=1 type=s16 scale=0.01 unit=N'")};
  if (is_serial) return serial_opener(choice, rules, directions);
  if (is_hid) return hid_opener(choice, directions);
  if (choice.gauge != "typed")
    return Error{en::say("'{}' is not a gauge", printable(choice.gauge)), "",
                 en::say("typed, serial:/dev/ttyUSB0 or hid:DEVICE")};
  return GaugeOpener([=]() -> Result<std::unique_ptr<GaugeSource>> {
    return std::unique_ptr<GaugeSource>(
        std::make_unique<TypedGauge>(STDIN_FILENO, rules, directions));
  });
}

namespace {

constexpr std::size_t kLongestGaugeLine = 120;
constexpr double kAnswerTimeout_s = 0.5, kMinPause_s = 0.02;
constexpr double kBitsPerByte = 10;  // with start and stop bit
constexpr int kUnansweredLimit = 4, kNoiseLimit = 20;

bool has_shape(const GaugeLine& line, const GaugeLine& shape) {
  return line.count == shape.count && line.decimals == shape.decimals;
}

}  // namespace

void GaugeLineReader::feed(std::string_view bytes, double arrived_s) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const double ended_s = arrived_s - byte_s_ * static_cast<double>(bytes.size() - 1 - i);
    last_byte_s_ = ended_s;
    if (bytes[i] == '\r' || bytes[i] == '\n') {
      end_line();
      continue;
    }
    if (text_.empty()) begun_s_ = ended_s - byte_s_;
    text_ += bytes[i];
    if (text_.size() > kLongestGaugeLine) text_.resize(1), is_skipping_ = true;
  }
}

void GaugeLineReader::end_line() {
  if (!text_.empty() && !is_skipping_) lines_.push_back({text_, begun_s_});
  if (!text_.empty()) is_skipping_ = false;
  text_.clear();
}

void GaugeLineReader::clear() {
  text_.clear(), lines_.clear();
  is_skipping_ = false;
}

std::optional<GaugeLineReader::Line> GaugeLineReader::take() {
  if (lines_.empty()) return std::nullopt;
  Line line = std::move(lines_.front());
  lines_.erase(lines_.begin());
  return line;
}

Result<std::unique_ptr<GaugeSource>> SerialGauge::open(const SerialGaugeOptions& options) {
  auto port = SerialPort::open(options.node, options.baud);
  if (!port) return port.error();
  return std::unique_ptr<GaugeSource>(new SerialGauge(std::move(*port), options));
}

SerialGauge::SerialGauge(SerialPort port, const SerialGaugeOptions& options)
    : port_(std::move(port)), options_(options), lines_(kBitsPerByte / options.baud) {
  if (options_.ask.empty()) lines_.skip_first();
}

Result<GaugeUpdate> SerialGauge::read(int timeout_ms) {
  GaugeUpdate update;
  const double until_s = gauge_clock_s() + 1e-3 * timeout_ms;
  const double pause_s = std::max(kMinPause_s, 4 * kBitsPerByte / options_.baud);
  do {
    if (const Status status = ask_when_due(update); !status) return status.error();
    double next_s = until_s;
    if (!options_.ask.empty())
      next_s = std::min(next_s, lines_.is_within_line() ? lines_.last_byte_s() + pause_s
                                : query_sent_s_         ? *query_sent_s_ + kAnswerTimeout_s
                                                        : next_ask_s_);
    const double wait_s = std::max(0.0, next_s - gauge_clock_s());
    const auto bytes = port_.read(static_cast<int>(std::ceil(1e3 * wait_s)));
    if (!bytes) return bytes.error();
    const double now_s = gauge_clock_s();
    if (!bytes->empty()) lines_.feed(*bytes, now_s);
    // Sauter's gauges end their answers with nothing but a pause.
    if (!options_.ask.empty() && lines_.is_within_line() && now_s > lines_.last_byte_s() + pause_s)
      lines_.end_line();
    while (const auto line = lines_.take()) take_line(*line, update);
  } while (update.samples.empty() && gauge_clock_s() < until_s);
  if (noise_ >= kNoiseLimit) {
    update.remarks.push_back(en::say("{} lines from the gauge were not readings", noise_));
    noise_ = 0;
  }
  return update;
}

Status SerialGauge::ask_when_due(GaugeUpdate& update) {
  if (options_.ask.empty()) return {};
  const double now_s = gauge_clock_s();
  if (query_sent_s_ && now_s < *query_sent_s_ + kAnswerTimeout_s) return {};
  if (query_sent_s_ && ++unanswered_ == kUnansweredLimit)
    update.remarks.push_back(
        en::say("The gauge does not answer to '{}'. Try: another speed, another "
                "question, its settings for the serial line.",
                printable(options_.ask)));
  query_sent_s_.reset();
  if (now_s < next_ask_s_) return {};
  port_.discard_input();
  lines_.clear();
  if (Status status = port_.write(options_.ask); !status) return status;
  query_sent_s_ = gauge_clock_s();
  next_ask_s_ = *query_sent_s_ + options_.ask_every_s;
  return {};
}

bool SerialGauge::has_known_shape(const GaugeLine& line) {
  if (options_.directions.count != 0 && line.count != options_.directions.count) return false;
  if (!shape_ || has_shape(line, *shape_) || (other_shape_ && has_shape(line, *other_shape_))) {
    shape_ = line;
    other_shape_.reset();
    return true;
  }
  other_shape_ = line;
  return false;
}

void SerialGauge::take_line(const GaugeLineReader::Line& line, GaugeUpdate& update) {
  const GaugeLine reading = read_gauge_line(line.text, options_.rules);
  const double measured_s =
      query_sent_s_ ? 0.5 * (*query_sent_s_ + std::max(*query_sent_s_, line.time_s)) : line.time_s;
  if (reading.kind != GaugeLine::Kind::kNoise) unanswered_ = 0;
  if (!options_.ask.empty() && query_sent_s_) query_sent_s_.reset();
  if (reading.kind == GaugeLine::Kind::kNoise ||
      (reading.kind == GaugeLine::Kind::kValues && !has_known_shape(reading))) {
    ++noise_;
    return;
  }
  // Bytes of several lines come at once; their times follow from the duration of a byte.
  const double time_s = std::max(measured_s, last_s_ + 1e-6);
  last_s_ = time_s;
  GaugeSample sample;
  sample.time_s = time_s;
  if (reading.kind == GaugeLine::Kind::kValues)
    sample = sample_of(reading, options_.directions, time_s);
  update.samples.push_back(std::move(sample));
}

namespace {

constexpr int kWriteTimeout_ms = 1000;

const std::map<int, speed_t>& speed_codes() {
  static const std::map<int, speed_t> codes{
      {300, B300},         {600, B600},         {1200, B1200},       {2400, B2400},
      {4800, B4800},       {9600, B9600},       {19200, B19200},     {38400, B38400},
      {57600, B57600},     {115200, B115200},   {230400, B230400},   {460800, B460800},
      {500000, B500000},   {576000, B576000},   {921600, B921600},   {1000000, B1000000},
      {1152000, B1152000}, {1500000, B1500000}, {2000000, B2000000}, {2500000, B2500000},
      {3000000, B3000000}, {3500000, B3500000}, {4000000, B4000000}};
  return codes;
}

FailureWords words_for_line(int error_number) {
  switch (error_number) {
    case EACCES:
    case EPERM:
      return {en::say("access is not allowed"),
              en::say("make this user a member of the group dialout (sudo usermod -aG dialout "
                      "$USER) and log in again")};
    case EBUSY:
      return {en::say("another program uses it"), en::say("close that program")};
    case ENOENT:
    case ENXIO:
    case ENODEV: {
      std::vector<Message> names;
      for (const auto& port : serial_ports()) names.push_back(Message::typed(port.string()));
      return {en::say("there is no such serial line"),
              names.empty() ? en::say("plug the gauge in; none was found")
                            : en::say("plug it in, or one of {}", en::list(names))};
    }
    default:
      return {{}, en::say("unplug it and plug it in again")};
  }
}

Error line_error(const Message& doing, const std::filesystem::path& node, int error_number) {
  return errno_error(doing, node, words_for_line(error_number), error_number);
}

Error line_gone(const std::filesystem::path& node) {
  return {en::say("the serial line is gone"), node, en::say("plug the gauge in again")};
}

Status set_up(int descriptor, const std::filesystem::path& node, speed_t speed, int baud) {
  const Message doing = en::say("the serial line cannot be set up");
  termios line{};
  if (::tcgetattr(descriptor, &line) != 0)
    return Error{en::say("this is not a serial line"), node, en::say("the gauge's /dev/tty...")};
  ::cfmakeraw(&line);
  line.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | PARENB | CRTSCTS | HUPCL);
  line.c_cflag |= CS8 | CREAD | CLOCAL;
  line.c_iflag &= ~static_cast<tcflag_t>(IXON | IXOFF | IXANY);
  line.c_cc[VMIN] = 0;
  line.c_cc[VTIME] = 0;
  ::cfsetispeed(&line, speed);
  ::cfsetospeed(&line, speed);
  if (::tcsetattr(descriptor, TCSANOW, &line) != 0) return line_error(doing, node, errno);
  // tcsetattr() succeeds where any of the settings was accepted.
  termios now{};
  if (::tcgetattr(descriptor, &now) != 0) return line_error(doing, node, errno);
  if (::cfgetospeed(&now) != speed)
    return Error{en::say("the serial line does not support {} baud", baud), node,
                 en::say("the speed given in the gauge's manual")};
  return {};
}

}  // namespace

const std::vector<int>& serial_speeds() {
  static const std::vector<int> speeds = [] {
    std::vector<int> all;
    for (const auto& [baud, code] : speed_codes()) all.push_back(baud);
    return all;
  }();
  return speeds;
}

std::vector<std::filesystem::path> serial_ports() {
  std::vector<std::filesystem::path> ports;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/serial/by-id", ignored))
    ports.push_back(entry.path());
  if (ports.empty())
    for (const auto& entry : std::filesystem::directory_iterator("/dev", ignored)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("ttyUSB") || name.starts_with("ttyACM")) ports.push_back(entry.path());
    }
  std::sort(ports.begin(), ports.end());
  return ports;
}

Result<SerialPort> SerialPort::open(const std::filesystem::path& node, int baud) {
  const auto speed = speed_codes().find(baud);
  if (speed == speed_codes().end())
    return Error{en::say("{} baud is not a speed of a serial line", baud), node,
                 en::say("9600, 19200, 115200 or the speed in the gauge's manual")};
  SerialPort port;
  port.node_ = node;
  port.descriptor_ = Descriptor(::open(node.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!port.descriptor_.is_open())
    return line_error(en::say("the serial line cannot be opened"), node, errno);
  if (Status status = set_up(port.descriptor_.number(), node, speed->second, baud); !status)
    return status.error();
  ::ioctl(port.descriptor_.number(), TIOCEXCL);
  port.discard_input();
  return port;
}

SerialPort::~SerialPort() {
  if (descriptor_.is_open()) ::ioctl(descriptor_.number(), TIOCNXCL);
}

Result<std::string> SerialPort::read(int timeout_ms) {
  pollfd waiting{descriptor_.number(), POLLIN, 0};
  const int ready = ::poll(&waiting, 1, timeout_ms);
  if (ready < 0 && errno != EINTR) return line_gone(node_);
  if (ready <= 0) return std::string();
  std::string bytes(4096, '\0');
  const ssize_t size = ::read(descriptor_.number(), bytes.data(), bytes.size());
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return std::string();
  // A disconnected line is always ready and has no bytes.
  if (size <= 0) return line_gone(node_);
  bytes.resize(static_cast<std::size_t>(size));
  return bytes;
}

Status SerialPort::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t size = ::write(descriptor_.number(), bytes.data(), bytes.size());
    if (size > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(size));
      continue;
    }
    if (size < 0 && errno != EAGAIN && errno != EINTR) return line_gone(node_);
    pollfd waiting{descriptor_.number(), POLLOUT, 0};
    const int ready = ::poll(&waiting, 1, kWriteTimeout_ms);
    if (ready == 0)
      return Error{en::say("the serial line accepts no data"), node_, en::say("check its cable")};
    if (ready < 0 && errno != EINTR) return line_gone(node_);
    if (ready > 0 && (waiting.revents & (POLLERR | POLLHUP)) != 0) return line_gone(node_);
  }
  return {};
}

void SerialPort::discard_input() { ::tcflush(descriptor_.number(), TCIFLUSH); }

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

const TypeName& value_type_of(const GaugeReport::Value& value) {
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
    if (value.at + value_type_of(value).bytes > kMaxReportBytes) return false;
  return true;
}

std::uint32_t bits_at(const GaugeReport::Value& value, std::span<const std::uint8_t> bytes) {
  const std::size_t count = value_type_of(value).bytes;
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
  const TypeName& type = value_type_of(value);
  const auto range = std::int64_t{1} << (8 * type.bytes);
  auto number = static_cast<std::int64_t>(bits);
  if (type.is_signed && number >= range / 2) number -= range;
  const std::int64_t max = (type.is_signed ? range / 2 : range) - 1;
  if (number == max || (type.is_signed && number == -range / 2)) return std::nullopt;
  return static_cast<double>(number);
}

}  // namespace

Result<GaugeReport> GaugeReport::parse(const std::string& text) {
  const Error wrong{en::say("'{}' does not describe a gauge's report", printable(text)), "",
                    report_advice()};
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
  static constexpr std::array<const char*, 6> kKeys{"at", "id", "type", "unit", "scale", "zero"};
  TableFormat format{{}, report_advice(), report_advice()};
  for (const std::string key : kKeys)
    format.kinds.push_back(key == "scale" || key == "zero" ? TableColumnKind{key, Measure::kNumber}
                                                           : TableColumnKind{key});
  auto table = Table::open(csv, origin, std::move(format));
  if (!table) return table.error();
  const int at = table->find("at");
  if (at < 0) return table->missing("at");
  GaugeReport report;
  Value value;  // empty cells repeat the line above
  for (auto more = table->next();; more = table->next()) {
    if (!more) return more.error();
    if (!*more) break;
    if (table->text(at).empty()) return table->wrong(en::say("a number is missing"), at);
    for (std::size_t i = 0; i < table->columns().size(); ++i) {
      const auto& [name, kind, number, unit] = table->columns()[i];
      const int column = static_cast<int>(i);
      std::string cell(table->text(column));
      if (cell.empty()) continue;
      const std::string key = kind < 0 ? name : kKeys.at(static_cast<std::size_t>(kind));
      if (key == "scale" || key == "zero") {
        const auto setting = table->number(column);
        if (!setting) return setting.error();
        cell = fmt::format("{}", *setting);
      }
      if (key == "id" ? read_all(cell, report.id) : take_setting(key, cell, value)) continue;
      return table->wrong(
          en::say("'{}' is not a valid {}", printable(table->text(column)), printable(name)),
          column);
    }
    report.values.push_back(value);
  }
  if (!is_possible(report))
    return Error{en::say("the table does not describe a gauge's report"), origin, report_advice()};
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
    if (report.size() < value.at + value_type_of(value).bytes) return GaugeLine();
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
        update.remarks.push_back(en::say(
            "The device sends other reports than described. Try: check the id and length."));
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
