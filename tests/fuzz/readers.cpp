#include "tests/fuzz/readers.h"

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

#include <exception>
#include <fstream>

namespace alltact::test {
namespace {

constexpr std::size_t kLongestSentence = 2000;  // bytes

/// In memory where there is such a place: a disk would be waited for at every fsync.
const std::filesystem::path& scratch_folder() {
  static const TemporaryFolder folder([] {
    const std::filesystem::path memory = "/dev/shm";
    std::error_code absent;
    return std::filesystem::is_directory(memory, absent) ? memory
                                                         : std::filesystem::temp_directory_path();
  }());
  return folder.path();
}

bool has_control_characters(std::string_view text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) return true;
  return false;
}

}  // namespace

std::vector<Reader> readers() {
  std::vector<Reader> all;
  for (auto part : {yaml_readers(), table_readers(), picture_readers(), device_readers()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::string fault_of(const Reading& reading) {
  if (!reading.broken.empty() || !reading.refused) return reading.broken;
  const std::string sentence = reading.refused->sentence();
  if (reading.refused->what.empty()) return "refused without a word";
  if (sentence.size() > kLongestSentence) return "refused with a sermon: " + sentence;
  if (has_control_characters(sentence)) return "refused with control characters: " + sentence;
  return {};
}

std::string fault_of(const Reader& reader, const std::string& bytes) {
  try {
    return fault_of(reader.read(bytes));
  } catch (const std::exception& thrown) {
    return std::string("thrown: ") + thrown.what();
  }
}

ScratchFile::ScratchFile(std::string name) {
  static int count = 0;
  const std::filesystem::path folder = scratch_folder() / std::to_string(count++);
  std::filesystem::create_directory(folder);
  file_ = folder / name;
}

const std::filesystem::path& ScratchFile::write(const std::string& bytes) const {
  std::ofstream(file_, std::ios::binary).write(bytes.data(), std::ssize(bytes));
  return file_;
}

std::string ScratchFile::stray() const {
  for (const auto& entry : std::filesystem::directory_iterator(file_.parent_path()))
    if (entry.path() != file_) return "left behind: " + entry.path().string();
  return {};
}

std::string written_by(const std::string& name,
                       const std::function<void(const std::filesystem::path&)>& write) {
  const ScratchFile file(name);
  write(file.path());
  return *read_file(file.path());
}

}  // namespace alltact::test
