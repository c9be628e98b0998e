#include "calibration/finger/calibration_inputs.h"

#include "core/base/atomic_file.h"
#include "core/base/fields.h"
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
void describe_settings(Fields& fields, const char* key, S& settings,
                       const std::vector<Setting<S>>& table) {
  fields.section(key, Fields::Layout::kBraces, [&](Fields& inner) {
    for (const Setting<S>& setting : table) {
      std::string value = setting.get(settings);
      inner.text_or_number(may(setting.name), value);
      if (!inner.is_reading() || !inner.has(may(setting.name))) continue;
      if (const Status status = setting.set(settings, value); !status)
        inner.section().refuse(setting.name, status.error().what,
                               Message::typed(setting.range.text()));
    }
  });
}

bool is_checksum(const std::string& text) {
  return text.size() == 16 && std::all_of(text.begin(), text.end(),
                                          [](unsigned char c) { return std::isxdigit(c) != 0; });
}

void describe_checksum(Fields& fields, const char* key, std::string& checksum) {
  fields.quoted(key, checksum);
  fields.demand(is_checksum(checksum), key, en::say("is not a checksum of 16 digits"),
                en::say("calibrating again"));
}

/// A name that could leave presses/ is rejected.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

/// The names come last in the file, after its unknown keys.
void describe_presses(Fields& fields, std::vector<StoredPress>& presses) {
  std::vector<std::string> names, checksums;
  for (const StoredPress& press : presses) {
    names.push_back(press.name);
    checksums.push_back(press.checksum);
  }
  fields.quoted("checksums", checksums);
  fields.unknown_keys();
  fields.texts("presses", names);
  if (!fields.is_reading()) return;
  fields.demand(!names.empty(), "presses", en::say("lists no press"), en::say("calibrating again"));
  fields.demand(names.size() == checksums.size(), "checksums",
                en::say("has {} entries for {} presses", checksums.size(), names.size()),
                en::say("one for each press"));
  for (std::size_t i = 0; i < names.size(); ++i) {
    fields.demand(is_plain_name(names[i]), "presses",
                  en::say("'{}' is not an image name", printable(names[i])), "");
    fields.demand(is_checksum(checksums[i]), "checksums",
                  en::say("'{}' is not a checksum of 16 digits", printable(checksums[i])), "");
    fields.demand(
        std::count(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) == 0,
        "presses", en::say("lists '{}' twice", printable(names[i])),
        en::say("delete one of the two"));
    presses.push_back({names[i], checksums[i]});
  }
}

/// Notes are allowed only on existing presses.
void refuse_unknown(const Fields& fields, const CalibrationInputs& inputs) {
  for (const auto& [name, note] : inputs.press_set.notes)
    fields.demand(std::any_of(inputs.presses.begin(), inputs.presses.end(),
                              [&name = name](const auto& press) { return press.name == name; }),
                  "presses",
                  en::say("'{}' is annotated, but is not among the presses", printable(name)),
                  en::say("remove the annotation"));
}

}  // namespace

static void describe(Fields& fields, CalibrationInputs& inputs) {
  fields.format(CalibrationInputs::kFormat,
                en::say("the version of this program that wrote it, or calibrating again with the "
                        "images in presses/ (this version writes '{}')",
                        std::string(CalibrationInputs::kFormat)));
  fields.text("date", inputs.date);
  fields.text("program_version", inputs.program_version);
  describe_all_presses(fields, inputs.press_set, true);
  describe_settings(fields, "calibration", inputs.calibration, calibration_settings());
  describe_settings(fields, "pipeline", inputs.pipeline, pipeline_settings());
  fields.flag("continuous", inputs.is_continuous);
  describe_checksum(fields, "finger", inputs.finger_checksum);
  describe_checksum(fields, "reference", inputs.reference_checksum);
  describe_single_presses(fields, inputs.press_set);
  describe_presses(fields, inputs.presses);
  refuse_unknown(fields, inputs);
}

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
  auto inputs = read_fields<CalibrationInputs>(file, yaml);
  if (!inputs) return inputs;
  inputs->unknown_ = std::move(file.unknown());
  if (warnings != nullptr)
    warnings->insert(warnings->end(), file.warnings().begin(), file.warnings().end());
  return inputs;
}

std::string CalibrationInputs::to_yaml() const { return fields_text(*this, unknown_); }

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
