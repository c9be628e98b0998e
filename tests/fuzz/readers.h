// Every reader of bytes that somebody else wrote, in one table: libFuzzer drives it for hours
// (fuzz_readers.cpp), a plain test for seconds (readers_test.cpp).
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact::test {

/// What became of some bytes.
struct Reading {
  std::optional<Error> refused;  ///< and why
  /// A law of the reader that does not hold, such as that what it took is written and read again as
  /// the same; empty: all hold.
  std::string broken = {};
};

struct Reader {
  std::string_view name;
  std::function<std::vector<std::string>()> seeds;  ///< whole and good, made by the program itself
  std::function<Reading(const std::string& bytes)> read;
};

[[nodiscard]] std::vector<Reader> yaml_readers();
[[nodiscard]] std::vector<Reader> table_readers();
[[nodiscard]] std::vector<Reader> picture_readers();
[[nodiscard]] std::vector<Reader> device_readers();
[[nodiscard]] std::vector<Reader> readers();  ///< all of them

/// What of a reading may never be: a broken law, or a refusal that is no sentence on one line that
/// says what is wrong. Empty: nothing.
[[nodiscard]] std::string fault_of(const Reading& reading);

/// Reads and tells fault_of(), and what an exception said.
[[nodiscard]] std::string fault_of(const Reader& reader, const std::string& bytes);

/// The bytes as a file of this name, alone in a folder of its own, until the next call.
class ScratchFile {
 public:
  explicit ScratchFile(std::string name);
  [[nodiscard]] const std::filesystem::path& write(const std::string& bytes) const;
  [[nodiscard]] const std::filesystem::path& path() const { return file_; }
  [[nodiscard]] std::filesystem::path folder() const { return file_.parent_path(); }
  /// Whatever else lies beside it, as a broken law; empty: nothing.
  [[nodiscard]] std::string stray() const;

 private:
  std::filesystem::path file_;
};

/// What `write` leaves in a file of this name.
[[nodiscard]] std::string written_by(
    const std::string& name, const std::function<void(const std::filesystem::path&)>& write);

/// What was refused; else what `law` says of the value.
template <class T, class Law>
[[nodiscard]] Reading reading_of(const Result<T>& result, const Law& law) {
  if (!result) return {result.error()};
  return {std::nullopt, law(*result)};
}
inline constexpr auto kNoLaw = [](const auto&) { return std::string(); };

/// For laws of what is written and read again.
template <class T>
[[nodiscard]] std::string same_again(const std::string& written, const Result<T>& read,
                                     const std::function<std::string(const T&)>& write) {
  if (!read) return "what was written is refused: " + read.error().sentence() + "\n" + written;
  const std::string again = write(*read);
  return again == written ? std::string() : "written\n" + written + "\nand then\n" + again;
}

}  // namespace alltact::test
