#include "core/sources/gauge/open_gauge.h"

#include "core/printable.h"
#include "core/sources/gauge/force_unit.h"
#include "core/sources/gauge/hid_gauge.h"
#include "core/sources/gauge/serial_gauge.h"
#include "core/sources/gauge/typed_gauge.h"

#include <charconv>

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

Result<GaugeOpener> serial_opener(const GaugeChoice& choice,
                                  const GaugeLineRules& rules,
                                  const GaugeDirections& directions) {
  SerialGaugeOptions options;
  options.node = choice.gauge.substr(std::string_view("serial:").size());
  options.rules = rules;
  options.directions = directions;
  options.ask_every_s = choice.ask_every_s;
  if (!choice.model.empty()) {
    const auto model = std::find_if(kGaugeModels.begin(), kGaugeModels.end(), [&](const auto& m) {
      return m.name == choice.model;
    });
    if (model == kGaugeModels.end())
      return Error{en::say("there is no gauge '{}'", printable(choice.model)),
                   "",
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
        "",
        en::say("one for each, as x/y/z")};
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
      return Error{en::say("'{}' is no text with \\r, \\n, \\xHH", printable(text)), "", ""};
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
      return Error{en::say("'{}' is no unit of force", printable(choice.unit)),
                   "",
                   en::say("N, mN, kN, g, kgf, lbf or ozf")};
    rules.unit_N = *unit;
  }
  const bool is_serial = choice.gauge.starts_with("serial:");
  const bool is_hid = choice.gauge.starts_with("hid:");
  if (is_hid && !choice.unit.empty())
    return Error{en::say("of a HID gauge the unit is told with its report"),
                 choice.gauge,
                 en::say("unit= in the report's description")};
  if (!is_serial && (!choice.model.empty() || !choice.ask.empty() || choice.baud != 0))
    return Error{en::say("model, speed and question are of a serial gauge"),
                 choice.gauge,
                 en::say("serial:/dev/ttyUSB0")};
  if (is_hid == choice.report.empty())
    return Error{is_hid ? en::say("it is not told where the force stands in the gauge's reports")
                        : en::say("a report is told of a gauge that is no HID device"),
                 choice.gauge,
                 en::say("hid:DEVICE and 'id=3 at=1 type=s16 scale=0.01 unit=N'")};
  if (is_serial) return serial_opener(choice, rules, directions);
  if (is_hid) return hid_opener(choice, directions);
  if (choice.gauge != "typed")
    return Error{en::say("'{}' is no gauge", printable(choice.gauge)),
                 "",
                 en::say("typed, serial:/dev/ttyUSB0 or hid:DEVICE")};
  return GaugeOpener([=]() -> Result<std::unique_ptr<GaugeSource>> {
    return std::unique_ptr<GaugeSource>(
        std::make_unique<TypedGauge>(STDIN_FILENO, rules, directions));
  });
}

}  // namespace alltact
