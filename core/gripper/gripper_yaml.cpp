// Reads and writes gripper.yaml.
#include "core/finger/pose_yaml.h"
#include "core/gripper/gripper.h"
#include "core/io/atomic_file.h"
#include "core/printable.h"
#include "core/yaml/yaml_reader.h"
#include "core/yaml/yaml_writer.h"

#include <fmt/format.h>

namespace alltact {

struct Gripper::Unknown {
  UnknownKeys keys;
};

namespace {

const std::vector<std::string_view> kAssemblies{"ahead", "behind"};

Eigen::Vector2d read_plane_point(YamlSection& section, const std::string& key) {
  const std::vector<double> at = section.numbers(key);
  if (at.size() != 2) section.refuse(key, en::say("must be two numbers: x and z in mm"), "");
  return {at[0], at[1]};
}

GripperMotor read_motor(YamlSection section) {
  GripperMotor motor;
  motor.lead_mm = section.number("lead_mm", en::say("a travel in mm for each turn"));
  const std::vector<double> range = section.numbers("range_turns");
  if (range.size() != 2)
    section.refuse("range_turns",
                   en::say("must be two motor positions, the lower one first"),
                   en::say("for example [0.0, 12.5]"));
  motor.first_turns = range[0], motor.last_turns = range[1];
  motor.sd_turns = section.number_or("sd_turns", 0.0, {0.0, 1000.0});
  return motor;
}

GripperFinger read_gripper_finger(YamlSection section) {
  GripperFinger finger;
  finger.name = section.text("name");
  finger.folder = section.text("folder");
  LinkageParameters& linkage = finger.linkage;
  linkage.pivot_mm = read_plane_point(section, "pivot_mm");
  linkage.nut_mm = read_plane_point(section, "nut_mm");
  linkage.crank_mm = section.number("crank_mm", en::say("a length in mm"));
  linkage.rod_mm = section.number("rod_mm", en::say("a length in mm"));
  linkage.assembly = static_cast<AssemblyMode>(section.choice("assembly", kAssemblies) + 1);
  if (section.has("known_at_turns"))
    finger.known_at_turns = section.number("known_at_turns", en::say("a motor position"));
  if (section.has("link_from_camera") || !finger.known_at_turns)
    finger.link_from_camera = read_pose(section.section("link_from_camera"));
  return finger;
}

Gripper read_gripper_file(YamlSection& top) {
  Gripper gripper;
  if (const std::string format = top.text("format"); format != Gripper::kFormat)
    top.refuse("format",
               en::say("'{}' cannot be read by this version", printable(format)),
               en::say("a newer version of this program, or '{}'", std::string(Gripper::kFormat)));
  gripper.name = top.text("name");
  gripper.motor = read_motor(top.section("motor"));
  const std::vector<YamlSection> fingers = top.sections("fingers");
  if (fingers.size() != gripper.fingers.size())
    top.refuse("fingers",
               en::say("must be two fingers, not {}", fingers.size()),
               en::say("one block '- name: ...' for each"));
  for (std::size_t i = 0; i < fingers.size(); ++i)
    gripper.fingers[i] = read_gripper_finger(fingers[i]);
  return gripper;
}

std::string finger_block(const GripperFinger& finger,
                         std::size_t number,
                         const UnknownKeys& unknown) {
  const std::string key = fmt::format("fingers[{}]", number);
  const LinkageParameters& linkage = finger.linkage;
  YamlBlock block(key);
  block.add("name", yaml_text(finger.name));
  block.add("folder", yaml_text(finger.folder));
  block.add("pivot_mm", yaml_numbers({linkage.pivot_mm.x(), linkage.pivot_mm.y()}));
  block.add("nut_mm", yaml_numbers({linkage.nut_mm.x(), linkage.nut_mm.y()}));
  block.add("crank_mm", yaml_number(linkage.crank_mm));
  block.add("rod_mm", yaml_number(linkage.rod_mm));
  block.add("assembly",
            std::string(kAssemblies.at(static_cast<std::size_t>(linkage.assembly) - 1)));
  if (finger.known_at_turns) block.add("known_at_turns", yaml_number(*finger.known_at_turns));
  if (finger.link_from_camera) {
    YamlBlock pose(key + ".link_from_camera");
    add_pose(*finger.link_from_camera, pose);
    pose.add_unknown(unknown);
    block.add("link_from_camera", pose.in_braces());
  }
  block.add_unknown(unknown);
  // As an item of the list: the dash replaces the block's own name.
  std::string text = block.on_many_lines();
  text.erase(0, text.find('\n') + 1);
  std::string item;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
    end = text.find('\n', begin) + 1;
    item += (begin == 0 ? "  - " : "    ") + text.substr(begin + 2, end - begin - 2);
  }
  return item;
}

}  // namespace

Result<Gripper> Gripper::parse(const std::string& yaml,
                               const std::filesystem::path& origin,
                               std::vector<Message>* warnings) {
  YamlFile file(origin);
  Gripper gripper;
  const Status read = file.read(yaml, [&](YamlSection& top) { gripper = read_gripper_file(top); });
  if (!read) return read.error();
  if (const Status status = gripper.validate(); !status) return file.located(status.error());
  gripper.unknown_ = std::make_shared<const Unknown>(Unknown{std::move(file.unknown())});
  if (warnings != nullptr) *warnings = std::move(file.warnings());
  return gripper;
}

Result<Gripper> Gripper::load(const std::filesystem::path& path, std::vector<Message>* warnings) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  const std::filesystem::path file = is_folder ? path / kFileName : path;
  const auto content = read_file(file, YamlFile::kMaxBytes);
  if (!content) return content.error();
  auto gripper = parse(*content, file, warnings);
  if (!gripper) return gripper;
  if (const Status taken = gripper->resolve_camera_poses(file.parent_path()); !taken)
    return taken.error();
  return gripper;
}

Result<std::string> Gripper::to_yaml() const {
  static const UnknownKeys kNone;
  const UnknownKeys& unknown = unknown_ ? unknown_->keys : kNone;
  if (const Status status = validate(); !status) return status.error();
  YamlBlock head("");
  head.add("format", kFormat);
  head.add("name", yaml_text(name));
  std::string text = head.on_many_lines();
  YamlBlock block("motor");
  block.add("lead_mm", yaml_number(motor.lead_mm));
  block.add("range_turns", yaml_numbers({motor.first_turns, motor.last_turns}));
  block.add("sd_turns", yaml_number(motor.sd_turns));
  block.add_unknown(unknown);
  text += block.on_many_lines() + "fingers:\n";
  for (std::size_t i = 0; i < fingers.size(); ++i) text += finger_block(fingers[i], i, unknown);
  YamlBlock rest("");
  rest.add_unknown(unknown);
  return text + rest.on_many_lines();
}

Status Gripper::save(const std::filesystem::path& file) const {
  const auto text = to_yaml();
  if (!text) return text.error();
  return write_file_atomically(file, *text);
}

}  // namespace alltact
