#include "core/io/system_error.h"

#include <cerrno>
#include <cstring>

namespace alltact {
namespace {

FailureWords words_for(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return {"the disk is full", "free some space, or choose a folder on another disk"};
    case EDQUOT:
      return {"your share of the disk is used up", "free some space, or choose another disk"};
    case EFBIG:
      return {"the file would be larger than this system allows", "another disk"};
    case EROFS:
      return {"the disk is read-only", "a folder on a disk that can be written to"};
    case EACCES:
    case EPERM:
      return {"access is not allowed", "another folder, or ask its owner for access"};
    case ENOENT:
      return {"it does not exist", "check the path for typing errors"};
    case ENOTDIR:
      return {"a part of the path is no folder", "check the path for typing errors"};
    case EISDIR:
      return {"it is a folder", "name a file inside it"};
    case ENAMETOOLONG:
      return {"the name is too long", "a shorter name"};
    case EIO:
      return {"the disk reports a fault", "another disk, and look after this one"};
    case EMFILE:
    case ENFILE:
      return {"too many files are open", "close other programs"};
    default:
      return {{}, "once more, or another folder"};
  }
}

}  // namespace

Error system_error(std::string_view doing, const std::filesystem::path& path, int error_number) {
  return told(doing, path.string(), words_for(error_number), error_number);
}

Error told(std::string_view doing, std::string where, const FailureWords& words, int error_number) {
  const std::string reason =
      words.reason.empty() ? std::string(std::strerror(error_number)) : std::string(words.reason);
  return {fmt::format("{}: {}", doing, reason), std::move(where), std::string(words.advice)};
}

}  // namespace alltact
