#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "core/devices/camera_list.h"
#include "core/devices/hid_button.h"

#include <fmt/format.h>

namespace alltact {
namespace {

struct DevicesOptions {
  bool details = false;       ///< every format and control, too
  bool learn_button = false;  ///< waits for a button and prints how to recognise it
};

using Json = Console::Json;

constexpr int kTimeout_ms = 20'000;

Json format_json(const CameraFormat& format) {
  Json json;
  json["pixels"] = fourcc_text(format.fourcc);
  json["width_px"] = format.width_px;
  json["height_px"] = format.height_px;
  if (format.frames_per_second() > 0) json["frames_per_second"] = format.frames_per_second();
  json["readable"] = can_decode(format.fourcc);
  return json;
}

Json control_json(const CameraControl& control) {
  Json json;
  json["id"] = control.id;
  json["name"] = control.name;
  json["type"] = to_string(control.type);
  json["low"] = control.low;
  json["high"] = control.high;
  json["step"] = control.step;
  json["default"] = control.default_value;
  json["value"] = control.value;
  for (const MenuItem& item : control.menu)
    json["menu"].push_back({{"value", item.value}, {"name", item.name}});
  json["read_only"] = control.is_read_only;
  json["automatic_has_it"] = control.is_inactive;
  return json;
}

Json camera_json(const FoundCamera& camera) {
  const CameraIdentity& identity = camera.identity;
  Json json;
  json["node"] = identity.node;
  json["name"] = identity.name;
  for (const auto& [key, text] : {std::pair{"by_id", &identity.by_id},
                                  {"by_path", &identity.by_path},
                                  {"serial", &identity.serial},
                                  {"bus", &identity.bus},
                                  {"driver", &identity.driver}})
    if (!text->empty()) json[key] = *text;
  json["usable"] = !camera.problem.has_value();
  if (camera.problem) json["problem"] = camera.problem->sentence();
  json["formats"] = Json::array();
  for (const CameraFormat& format : camera.formats) json["formats"].push_back(format_json(format));
  json["controls"] = Json::array();
  for (const CameraControl& control : camera.controls)
    json["controls"].push_back(control_json(control));
  return json;
}

std::string control_line(const CameraControl& control) {
  std::string line =
      fmt::format("    {}: {} ({} to {} in steps of {}, default {})", control.name, control.value,
                  control.low, control.high, control.step, control.default_value);
  for (const MenuItem& item : control.menu) line += fmt::format(", {} = {}", item.value, item.name);
  if (control.is_inactive) line += ", now set by an automatic mode";
  return line;
}

void say_camera(const FoundCamera& camera, bool details, Console& console) {
  const CameraIdentity& identity = camera.identity;
  const auto best = choose_format(camera.formats, {}, identity.node);
  const std::string state = camera.problem ? "cannot be used: " + camera.problem->sentence()
                            : best.ok()    ? best->text().english()
                                           : best.error().sentence();
  console.say(fmt::format("camera  {} ({}, {}): {}", identity.stable_name(), identity.node,
                          identity.name, state));
  if (!details) return;
  for (const CameraFormat& format : camera.formats)
    console.say(fmt::format("    {}{}", format.text(),
                            can_decode(format.fourcc) ? "" : " (cannot be decoded)"));
  for (const CameraControl& control : camera.controls) console.say(control_line(control));
}

void say_hid(const FoundHid& hid, Console& console) {
  const HidIdentity& identity = hid.identity;
  console.say(fmt::format(
      "hid     {} ({}, {}): {}", identity.stable_name(), identity.node, identity.name,
      hid.problem ? "cannot be used: " + hid.problem->sentence() : std::string("can be used")));
}

/// The instructions also appear on a terminal that shows no progress.
Status learn(const std::vector<FoundHid>& hids, Console& console) {
  std::vector<std::unique_ptr<HidPort>> ports;
  std::vector<std::string> names;
  for (const FoundHid& hid : hids) {
    auto port = hid.problem ? *hid.problem : open_hid(hid.identity.node);
    if (!port) continue;
    ports.push_back(std::move(*port));
    names.push_back(hid.identity.stable_name());
  }
  if (ports.empty())
    return Error{en::say("there is no HID device that can be read"), "",
                 en::say("plug in a pedal, or see above")};
  std::vector<HidPort*> listening;
  for (const auto& port : ports) listening.push_back(port.get());
  console.warn("Leave the button alone for a second, then press and release it twice.");
  const auto found = learn_button(listening, kTimeout_ms, console.job());
  if (!found) return found.error();
  const LearntButton button{names[found->first], found->second};
  console.say(fmt::format("button  {}", button.text()));
  console.say(fmt::format("Use it: alltact record SOURCE -o VIDEO --button '{}'", button.text()));
  console.answer()["button"] = {
      {"device", button.device}, {"pattern", button.pattern.text()}, {"option", button.text()}};
  return {};
}

/// Lists cameras and HID devices, with the problems of those that cannot be used.
Status run_devices(const DevicesOptions& options, Console& console) {
  const auto cameras = list_cameras(kernel_calls(), true);
  const auto hids = list_hids();
  Json& answer = console.answer();
  answer["cameras"] = answer["hid"] = Json::array();
  for (const FoundCamera& camera : cameras) {
    say_camera(camera, options.details, console);
    answer["cameras"].push_back(camera_json(camera));
  }
  if (cameras.empty()) console.say("No camera was found.");
  for (const FoundHid& hid : hids) {
    say_hid(hid, console);
    Json json = {{"node", hid.identity.node},
                 {"device", hid.identity.stable_name()},
                 {"name", hid.identity.name},
                 {"usable", !hid.problem.has_value()}};
    if (hid.problem) json["problem"] = hid.problem->sentence();
    answer["hid"].push_back(std::move(json));
  }
  if (hids.empty()) console.say("No HID device (pedal, dimmer) was found.");
  return options.learn_button ? learn(hids, console) : Status();
}

}  // namespace

void add_devices(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<DevicesOptions>();
  CLI::App* command = add_command(program, "devices");
  command->add_flag("--details", options->details, "Lists every format and control of each camera");
  command->add_flag("--learn-button", options->learn_button,
                    "Waits for a pedal or button to be pressed twice and prints its value for "
                    "'alltact record --button'");
  command->callback(
      [=, &chosen] { chosen = [=](Console& console) { return run_devices(*options, console); }; });
}

}  // namespace alltact
