// Loading and saving of finger.yaml.
#include "core/finger/finger_yaml.h"

#include "core/io/atomic_file.h"

namespace alltact {

struct Finger::Unknown {
  UnknownKeys keys;
};

Result<Finger> Finger::load(const std::filesystem::path& folder, std::vector<Message>* warnings) {
  const std::filesystem::path path = folder / kFileName;
  const auto content = read_file(path, YamlFile::kMaxBytes);
  if (!content) return content.error();
  return parse(*content, path, warnings);
}

Result<Finger> Finger::parse(const std::string& yaml,
                             const std::filesystem::path& origin,
                             std::vector<Message>* warnings) {
  YamlFile file(origin);
  Finger finger;
  const Status read = file.read(yaml, [&](YamlSection& top) { finger = read_finger(top); });
  if (!read) return read.error();
  if (const Status status = finger.validate(); !status) return file.located(status.error());
  finger.unknown_ = std::make_shared<const Unknown>(Unknown{std::move(file.unknown())});
  if (warnings != nullptr) {
    *warnings = std::move(file.warnings());
    for (const Error& number : finger.implausible())
      warnings->push_back(file.located(number).message());
  }
  return finger;
}

Result<std::string> Finger::to_yaml() const {
  static const UnknownKeys kNone;
  if (const Status status = validate(); !status) return status.error();
  return finger_text(*this, unknown_ ? unknown_->keys : kNone);
}

Status Finger::save(const std::filesystem::path& folder) const {
  const auto text = to_yaml();
  if (!text) return text.error();
  return write_file_atomically(folder / kFileName, *text);
}

}  // namespace alltact
