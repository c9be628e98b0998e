#include "app/commands/gauge_flags.h"

#include "app/console/flags.h"
#include "core/devices/gauge_source.h"
#include "core/devices/open_gauge.h"

#include <fmt/format.h>

namespace alltact {
namespace {

void check_unit(const std::string& unit) {
  if (!newtons_in(unit))
    throw CLI::ValidationError("--gauge-unit",
                               "'" + unit + "' is not one of N, mN, kN, g, kgf, lbf, ozf");
}

GaugeDirections checked_direction(const std::string& text) {
  const auto directions = GaugeDirections::parse(text);
  if (!directions) throw CLI::ValidationError("--gauge-direction", directions.error().sentence());
  return *directions;
}

}  // namespace

void add_gauge_flags(CLI::App& command, GaugeChoice& gauge) {
  CLI::Option* chosen =
      command
          .add_option("--gauge", gauge.gauge,
                      "Force gauge to record into NAME.gauge.csv: typed (a number and Enter while "
                      "the finger rests; 'y 1.2 N' along y; 'block NAME'; an empty line when it "
                      "moves again), serial:/dev/ttyUSB0, or hid:DEVICE")
          ->type_name("GAUGE");
  const auto add = [&](const char* flag, auto& value, const char* sentence, const char* type) {
    return command.add_option(flag, value, sentence)->type_name(type)->needs(chosen);
  };
  add("--gauge-model", gauge.model,
      "Model of a serial gauge: the speed, request and answers that its maker sets",
      "mark10|imada|sauter")
      ->check(CLI::IsMember({"mark10", "imada", "sauter"}));
  add("--gauge-baud", gauge.baud, "Speed of a serial gauge, 8N1 (default 9600)", "BAUD")
      ->check(CLI::IsMember(serial_speeds()))
      ->transform(typed_integer(1));
  add("--gauge-ask", gauge.ask,
      "Request to a serial gauge for each reading, such as '?\\r' (default: it sends by itself)",
      "TEXT");
  add("--gauge-every-s", gauge.ask_every_s,
      "Interval between requests to a serial gauge, s (default 0.05)", "S")
      ->transform(typed_number(0.001, 60.0));
  add("--gauge-report", gauge.report,
      "Position of the force in the reports of a HID gauge, as 'id=3 at=1 type=s16 scale=0.01 "
      "unit=N', or a CSV with at, type, scale, zero, unit",
      "TEXT|FILE");
  add("--gauge-unit", gauge.unit, "Unit of readings that name none: N, mN, kN, g, kgf, lbf, ozf",
      "UNIT");
  add("--gauge-direction", gauge.direction,
      "Direction of a push on the gauge in the table's axes: x, -y, 0.6,0.8,0; for several values "
      "x/y/z (default: x, or the axes in their order)",
      "DIRECTION");
}

void add_gauge_file_flags(CLI::App& command, CLI::Option* collect, GaugeFileOptions& file,
                          CollectOptions& options) {
  command
      .add_option_function<std::string>(
          "--gauge-unit",
          [&file](const std::string& unit) {
            check_unit(unit);
            file.unit_N = *newtons_in(unit);
          },
          "With --collect: unit of gauge columns that name none: N, mN, kN, g, kgf, lbf, ozf "
          "(default N)")
      ->type_name("UNIT")
      ->needs(collect);
  command
      .add_option_function<std::string>(
          "--gauge-direction",
          [&file](const std::string& text) { file.direction = checked_direction(text).of[0]; },
          "With --collect: direction of a single column force_n: x, -y, 0.6,0.8,0 (default x)")
      ->type_name("DIRECTION")
      ->needs(collect);
  command
      .add_option("--gauge-shift-s", options.shift_s,
                  "With --collect: gauge clock minus frame clock at the first frame, s (default: "
                  "from the markers' motion)")
      ->type_name("S")
      ->transform(typed_number(-1e12, 1e12))
      ->needs(collect);
  command
      .add_option_function<double>(
          "--gauge-drift-ppm", [&options](double ppm) { options.drift = 1e-6 * ppm; },
          "With --collect: drift of the gauge clock, ppm, positive if it is faster (default: from "
          "the markers' motion, where the clocks differ)")
      ->type_name("PPM")
      ->transform(typed_number(-1e4, 1e4))
      ->needs(collect);
}

Result<std::unique_ptr<GaugeLog>> start_gauge(const GaugeChoice& gauge) {
  if (gauge.gauge.empty()) return std::unique_ptr<GaugeLog>();
  const auto opener = gauge_opener(gauge);
  if (!opener) return opener.error();
  return GaugeLog::start(*opener, gauge.gauge);
}

void print_gauge(GaugeLog* gauge, Console& console) {
  if (gauge == nullptr) return;
  for (const Message& remark : gauge->take_remarks()) console.warn(remark.english());
}

Status end_gauge(GaugeLog* gauge, const std::filesystem::path& video, Console::Json& answer,
                 Console& console) {
  if (gauge == nullptr) return {};
  const auto counts = gauge->end();
  print_gauge(gauge, console);
  if (!counts) return counts.error();
  const std::filesystem::path file = gauge_log_of(video);
  console.say(fmt::format("{} gauge readings in {}", counts->readings, file.string()));
  answer["gauge"] = file.string();
  answer["readings"] = counts->readings;
  if (counts->readings == 0) console.warn("The gauge sent no reading during this recording.");
  return {};
}

}  // namespace alltact
