#include "core/base/result.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

namespace alltact {
namespace {

FailureWords words_for(int error_number) {
  switch (error_number) {
    case ENOSPC:
      return {en::say("the disk is full"),
              en::say("free some space, or choose a folder on another disk")};
    case EDQUOT:
      return {en::say("your disk quota is used up"),
              en::say("free some space, or choose another disk")};
    case EFBIG:
      return {en::say("the file would be larger than this system allows"), en::say("another disk")};
    case EROFS:
      return {en::say("the disk is read-only"),
              en::say("a folder on a disk that can be written to")};
    case EACCES:
    case EPERM:
      return {en::say("access is not allowed"),
              en::say("another folder, or ask its owner for access")};
    case ENOENT:
      return {en::say("it does not exist"), en::say("check the path for typing errors")};
    case ENOTDIR:
      return {en::say("a part of the path is no folder"),
              en::say("check the path for typing errors")};
    case EISDIR:
      return {en::say("it is a folder"), en::say("name a file inside it")};
    case ENAMETOOLONG:
      return {en::say("the name is too long"), en::say("a shorter name")};
    case EIO:
      return {en::say("the disk reports a fault"), en::say("another disk, and check this one")};
    case EMFILE:
    case ENFILE:
      return {en::say("too many files are open"), en::say("close other programs")};
    default:
      return {{}, en::say("once more, or another folder")};
  }
}

}  // namespace

void end_at_wrong_access(const Error* held) {
  if (held != nullptr)
    fmt::print(stderr, "A result was used that is an error: {}\n", held->sentence());
  else
    fmt::print(stderr, "A result was asked for its error, and has none.\n");
  std::abort();
}

Error system_error(const Message& doing, const std::filesystem::path& path, int error_number) {
  return errno_error(doing, path, words_for(error_number), error_number);
}

Error errno_error(const Message& doing, Where where, const FailureWords& words, int error_number) {
  const Message reason =
      words.reason.empty() ? Message::typed(std::strerror(error_number)) : words.reason;
  return {en::at(doing, reason), std::move(where), words.advice};
}

}  // namespace alltact
