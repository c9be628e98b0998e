#include "calibration/finger/calibration_inputs.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/image/image_file.h"
#include "core/numerics/checksum.h"
#include "core/sources/file_source.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// A setting that the file does not name has its default; one of another version is preserved.
template <class S>
S read_settings(YamlSection section, const std::vector<Setting<S>>& table) {
  S settings;
  for (const Setting<S>& setting : table) {
    if (!section.has(setting.name)) continue;
    if (const Status status = setting.set(settings, section.text(setting.name)); !status)
      section.refuse(setting.name, status.error().what, Message::typed(setting.range.text()));
  }
  return settings;
}

template <class S>
std::string settings_text(const char* name, const S& settings, const std::vector<Setting<S>>& table,
                          const UnknownKeys& unknown) {
  YamlBlock block(name);
  for (const Setting<S>& setting : table)
    block.add(setting.name, yaml_text_or_number(setting.get(settings)));
  block.add_unknown(unknown);
  return block.on_one_line();
}

bool is_checksum(const std::string& text) {
  return text.size() == 16 && std::all_of(text.begin(), text.end(),
                                          [](unsigned char c) { return std::isxdigit(c) != 0; });
}

std::string read_checksum(YamlSection& top, const char* key) {
  std::string text = top.text(key);
  if (!is_checksum(text))
    top.refuse(key, en::say("is not a checksum of 16 digits"), en::say("calibrating again"));
  return text;
}

/// A name that could leave presses/ is rejected.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

void read_presses(YamlSection& top, CalibrationInputs& inputs) {
  const auto names = top.texts("presses");
  const auto checksums = top.texts("checksums");
  if (names.empty()) top.refuse("presses", en::say("lists no press"), en::say("calibrating again"));
  if (names.size() != checksums.size())
    top.refuse("checksums",
               en::say("has {} entries for {} presses", checksums.size(), names.size()),
               en::say("one for each press"));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!is_plain_name(names[i]))
      top.refuse("presses", en::say("'{}' is not an image name", printable(names[i])), "");
    if (!is_checksum(checksums[i]))
      top.refuse("checksums",
                 en::say("'{}' is not a checksum of 16 digits", printable(checksums[i])), "");
    for (std::size_t before = 0; before < i; ++before)
      if (names[before] == names[i])
        top.refuse("presses", en::say("lists '{}' twice", printable(names[i])),
                   en::say("delete one of the two"));
    inputs.presses.push_back({names[i], checksums[i]});
  }
}

/// Notes are allowed only on existing presses.
void refuse_unknown(const YamlSection& top, const CalibrationInputs& inputs) {
  for (const auto& [name, note] : inputs.press_set.notes)
    if (std::none_of(inputs.presses.begin(), inputs.presses.end(),
                     [&name = name](const StoredPress& press) { return press.name == name; }))
      top.refuse("presses",
                 en::say("'{}' is annotated, but is not among the presses", printable(name)),
                 en::say("remove the annotation"));
}

CalibrationInputs read_inputs(YamlSection& top) {
  CalibrationInputs inputs;
  if (const std::string format = top.text("format"); format != CalibrationInputs::kFormat)
    top.refuse("format", en::say("'{}' cannot be read by this version", printable(format)),
               en::say("the version of this program that wrote it, or calibrating again with the "
                       "images in presses/ (this version writes '{}')",
                       std::string(CalibrationInputs::kFormat)));
  inputs.date = top.text("date");
  inputs.program_version = top.text("program_version");
  inputs.press_set = read_press_set(top, true);
  inputs.calibration = read_settings(top.section("calibration"), calibration_settings());
  inputs.pipeline = read_settings(top.section("pipeline"), pipeline_settings());
  inputs.is_continuous = top.choice("continuous", {"false", "true"}) == 1;
  inputs.finger_checksum = read_checksum(top, "finger");
  inputs.reference_checksum = read_checksum(top, "reference");
  read_presses(top, inputs);
  refuse_unknown(top, inputs);
  return inputs;
}

}  // namespace

Result<CalibrationInputs> CalibrationInputs::load(const fs::path& finger_folder,
                                                  std::vector<Message>* warnings) {
  const fs::path file = finger_folder / kFileName;
  std::error_code failed;
  if (!fs::exists(file, failed))
    return Error{en::say("there is nothing to repeat: this finger is not calibrated, or by a "
                         "version that did not store its data"),
                 file.string(),
                 en::say("calibrating it with the images in presses/ and --ball-radius-mm")};
  const auto content = read_file(file, YamlFile::kMaxBytes);
  if (!content) return content.error();
  return parse(*content, file, warnings);
}

Result<CalibrationInputs> CalibrationInputs::parse(const std::string& yaml, const fs::path& origin,
                                                   std::vector<Message>* warnings) {
  YamlFile file(origin);
  CalibrationInputs inputs;
  const Status read = file.read(yaml, [&](YamlSection& top) { inputs = read_inputs(top); });
  if (!read) return read.error();
  inputs.unknown_ = std::move(file.unknown());
  if (warnings != nullptr)
    warnings->insert(warnings->end(), file.warnings().begin(), file.warnings().end());
  return inputs;
}

std::string CalibrationInputs::to_yaml() const {
  YamlBlock head("");
  head.add("format", kFormat);
  head.add("date", yaml_text(date));
  head.add("program_version", yaml_text(program_version));
  add_all_presses(press_set, head);
  std::string text = head.on_many_lines();
  text += settings_text("calibration", calibration, calibration_settings(), unknown_);
  text += settings_text("pipeline", pipeline, pipeline_settings(), unknown_);

  YamlBlock rest("");
  rest.add("continuous", is_continuous ? "true" : "false");
  rest.add("finger", '"' + finger_checksum + '"');
  rest.add("reference", '"' + reference_checksum + '"');
  add_single_presses(press_set, rest);
  std::vector<std::string> names, checksums;
  for (const StoredPress& press : presses) {
    names.push_back(yaml_text(press.name));
    checksums.push_back('"' + press.checksum + '"');
  }
  rest.add("checksums", yaml_list(checksums));
  rest.add_unknown(unknown_);
  text += rest.on_many_lines();
  YamlBlock last("");
  last.add("presses", yaml_list(names));
  return text + last.on_many_lines();
}

fs::path stored_press_file(const fs::path& finger_folder, const std::string& name) {
  return finger_folder / kPressFolder / (name + ".png");
}

Status store_press(const fs::path& finger_folder, const Frame& frame) {
  if (const Status made = make_folder(finger_folder / kPressFolder); !made) return made;
  return write_image(stored_press_file(finger_folder, frame.name), frame.grey,
                     frame.controls ? *frame.controls : std::string());
}

Result<FramePtr> read_stored_press(const fs::path& finger_folder, const std::string& name) {
  const fs::path file = stored_press_file(finger_folder, name);
  auto grey = read_grey_image(file);
  if (!grey) return grey.error();
  auto frame = std::make_shared<Frame>();
  frame->grey = std::move(grey).value();
  frame->name = name;
  frame->origin = file.string();
  return FramePtr(std::move(frame));
}

Result<std::vector<fs::path>> stored_presses(const fs::path& finger_folder) {
  const fs::path folder = finger_folder / kPressFolder;
  std::error_code failed;
  if (!fs::is_directory(folder, failed) || fs::is_empty(folder, failed))
    return std::vector<fs::path>();
  return images_in(folder);
}

bool same_but_for_date(const CalibrationInputs& a, const CalibrationInputs& b) {
  CalibrationInputs other = b;
  other.date = a.date;
  return a.to_yaml() == other.to_yaml();
}

std::string image_checksum(const cv::Mat& grey) {
  Checksum checksum;
  const std::int32_t size[] = {grey.rows, grey.cols};
  checksum.add(size, sizeof size);
  for (int row = 0; row < grey.rows; ++row)
    checksum.add(grey.ptr(row), static_cast<std::size_t>(grey.cols) * grey.elemSize());
  return checksum.text();
}

std::string finger_checksum(const Finger& finger) {
  Finger bare;  // a copy, without keys of other versions
  bare.name = "finger";
  bare.camera = finger.camera;
  bare.face = finger.face;
  bare.markers = finger.markers;
  // The polarity that the reference recording determined belongs to the reference.
  bare.markers.polarity = Polarity::kAuto;
  bare.markers.missing.clear();
  const auto yaml = bare.to_yaml();
  Checksum checksum;
  if (yaml) checksum.add(yaml->data(), yaml->size());
  return checksum.text();
}

Result<std::string> reference_checksum(const fs::path& finger_folder, const Finger& finger) {
  if (!finger.reference) return std::string();
  Checksum checksum;
  const ReferenceFiles& files = *finger.reference;
  if (!files.image.empty()) {
    const auto grey = read_grey_image(finger_folder / files.image);
    if (!grey) return grey.error();
    return image_checksum(*grey);
  }
  for (const std::string& name : {files.video, files.markers}) {
    const auto content = read_file(finger_folder / name);
    if (!content) return content.error();
    checksum.add(content->data(), content->size());
  }
  return checksum.text();
}

std::string shell_quoted(std::string_view word) {
  const bool is_plain = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return c < 128 && (std::isalnum(c) != 0 || std::strchr("_./:@%+=-", c) != nullptr);
  });
  if (is_plain) return std::string(word);
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace alltact
