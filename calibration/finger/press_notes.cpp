#include "calibration/finger/press_notes.h"

#include "calibration/presses/press_yaml.h"
#include "core/io/atomic_file.h"
#include "core/printable.h"
#include "core/sources/files/picture_source.h"

namespace alltact {
namespace {

namespace fs = std::filesystem;

PressNotes read_notes(YamlSection& top) {
  PressNotes notes;
  if (const std::string format = top.text("format"); format != PressNotes::kFormat)
    top.refuse("format", en::say("'{}' cannot be read by this version", printable(format)), "");
  static_cast<SaidOfPresses&>(notes) = read_said_of_presses(top);
  if (top.has("operator")) notes.operator_name = top.text("operator");
  return notes;
}

/// 0: there is no such file.
fs::file_time_type written(const fs::path& file) {
  std::error_code failed;
  const auto time = fs::last_write_time(file, failed);
  return failed ? fs::file_time_type::min() : time;
}

}  // namespace

PressNotes PressNotes::of(const CalibrationInputs& inputs) {
  return {inputs, inputs.operator_name};
}

Result<PressNotes> PressNotes::load(const fs::path& finger_folder) {
  const fs::path file = finger_folder / kFileName;
  const auto told = written(file);
  const auto used = written(finger_folder / CalibrationInputs::kFileName);
  if (used > told) {
    const auto inputs = CalibrationInputs::load(finger_folder);
    if (!inputs) return inputs.error();
    return of(*inputs);
  }
  if (told == fs::file_time_type::min()) return PressNotes();
  const auto content = read_file(file, YamlFile::kMaxBytes);
  if (!content) return content.error();
  return parse(*content, file);
}

Result<PressNotes> PressNotes::parse(const std::string& yaml, const fs::path& origin) {
  YamlFile file(origin);
  PressNotes notes;
  const Status read = file.read(yaml, [&](YamlSection& top) { notes = read_notes(top); });
  if (!read) return read.error();
  return notes;
}

std::string PressNotes::to_yaml() const {
  YamlBlock block("");
  block.add("format", kFormat);
  if (ball_radius_mm > 0) block.add("ball_radius_mm", yaml_number(ball_radius_mm));
  if (!operator_name.empty()) block.add("operator", yaml_text(operator_name));
  add_said_of_presses(*this, block);
  return block.on_many_lines();
}

Status PressNotes::save(const fs::path& finger_folder) const {
  return write_file_atomically(finger_folder / kFileName, to_yaml());
}

Result<std::vector<fs::path>> kept_presses(const fs::path& finger_folder) {
  const fs::path folder = finger_folder / kPressFolder;
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) return std::vector<fs::path>();
  if (fs::is_empty(folder, failed)) return std::vector<fs::path>();
  return pictures_in(folder);
}

}  // namespace alltact
