#include "core/base/zip_file.h"

#include "core/base/atomic_file.h"
#include "core/base/result.h"

#include <cerrno>

#include <sys/stat.h>
#include <unistd.h>
#include <zip.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

/// The library's error about `path`.
Error zip_failure(zip_error_t* failure, const fs::path& path) {
  const Message packing = en::say("could not write the archive");
  if (zip_error_system_type(failure) == ZIP_ET_SYS && zip_error_code_system(failure) != 0)
    return system_error(packing, path, zip_error_code_system(failure));
  return {en::at(packing, Message::typed(zip_error_strerror(failure))), path.string(),
          en::say("another name for this file")};
}

bool is_packed_already(const std::string& name) {
  const std::string ending = fs::path(name).extension().string();
  for (const char* packed : {".png", ".mkv", ".jpg", ".mp4", ".avi", ".pdf", ".zip"})
    if (ending == packed) return true;
  return false;
}

/// The library reads files only at the end, and its error then does not name the file.
Status check_readable(const std::vector<ZipEntry>& entries) {
  for (const ZipEntry& entry : entries)
    if (!entry.file.empty() && ::access(entry.file.c_str(), R_OK) != 0)
      return system_error(en::say("could not read the file"), entry.file, errno);
  return {};
}

Status add_entry(zip_t* archive, const ZipEntry& entry) {
  const fs::path origin = entry.file.empty() ? fs::path(entry.name) : entry.file;
  zip_source_t* source =
      entry.file.empty() ? zip_source_buffer(archive, entry.content.data(), entry.content.size(), 0)
                         : zip_source_file(archive, entry.file.c_str(), 0, -1);
  if (source == nullptr) return zip_failure(zip_get_error(archive), origin);
  const zip_int64_t index = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return zip_failure(zip_get_error(archive), origin);
  }
  constexpr zip_uint16_t kMidnight = 0, kNewYear1980 = (1U << 5U) | 1U;
  constexpr zip_uint32_t kPlainFile = (S_IFREG | 0644U) << 16U;
  const auto entry_index = static_cast<zip_uint64_t>(index);
  if (zip_file_set_dostime(archive, entry_index, kMidnight, kNewYear1980, 0) != 0 ||
      zip_file_set_external_attributes(archive, entry_index, 0, ZIP_OPSYS_UNIX, kPlainFile) != 0 ||
      zip_set_file_compression(archive, entry_index,
                               is_packed_already(entry.name) ? ZIP_CM_STORE : ZIP_CM_DEFLATE,
                               0) != 0)
    return zip_failure(zip_get_error(archive), origin);
  return {};
}

/// `file` names the archive in errors and progress; it is written at `temporary`.
Status pack(const fs::path& file, const fs::path& temporary, const std::vector<ZipEntry>& entries,
            const Job& job) {
  int failed = 0;
  Archive archive(zip_open(temporary.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &failed));
  if (!archive) {
    zip_error_t failure;
    zip_error_init_with_code(&failure, failed);
    Error error = zip_failure(&failure, file);
    zip_error_fini(&failure);
    return error;
  }
  for (const ZipEntry& entry : entries)
    if (Status status = add_entry(archive.get(), entry); !status) return status;

  struct Watch {
    const Job& job;
    Message what;
  } watch{job, en::say("packing {}", file.filename())};
  zip_register_progress_callback_with_state(
      archive.get(), 0.005,
      [](zip_t*, double fraction, void* state) {
        const auto* reporter = static_cast<const Watch*>(state);
        reporter->job.report(fraction, reporter->what);
      },
      nullptr, &watch);
  zip_register_cancel_callback_with_state(
      archive.get(),
      [](zip_t*, void* state) {
        return static_cast<const Watch*>(state)->job.stop_requested() ? 1 : 0;
      },
      nullptr, &watch);
  if (zip_close(archive.get()) != 0) {
    if (job.stop_requested())
      return Error{en::say("stopped before it was packed"), file.string(), ""};
    return zip_failure(zip_get_error(archive.get()), file);
  }
  static_cast<void>(archive.release());  // zip_close() has freed it
  return {};
}

}  // namespace

Status write_zip(const fs::path& file, const std::vector<ZipEntry>& entries, const Job& job) {
  if (Status status = check_readable(entries); !status) return status;
  return write_file_atomically(
      file, [&](const fs::path& temporary) { return pack(file, temporary, entries, job); });
}

}  // namespace alltact
