// The result of work that can fail because of data: a value, or an error a person can act on.
#pragma once

#include "core/base/message.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace alltact {

/// Location of an error: a file, line or key, or a phrase.
struct Where : Message {
  Where() = default;
  Where(const char (&nothing)[1]) : Message(nothing) {}                        // NOLINT
  Where(std::string text) : Message(typed(std::move(text))) {}                 // NOLINT
  Where(const std::filesystem::path& path) : Message(typed(path.string())) {}  // NOLINT
  Where(Message phrase) : Message(std::move(phrase)) {}                        // NOLINT
};

/// Kinds of errors that callers distinguish; all others are kOther.
enum class ErrorKind {
  kOther = 0,
  kMissingKey,        ///< YAML: a required key is absent
  kUnknownWord,       ///< YAML: the value is none of the permitted words
  kWrongValue,        ///< YAML: "must be ...": wrong type or outside the limits
  kWrongItem,         ///< YAML: the same of a number in a list
  kNoBlock,           ///< YAML: the value must be a block of keys
  kNoList,            ///< YAML: the value must be a list
  kFoldedLens,        ///< the distortion folds over inside the image
  kUncertainFace,     ///< the distance of the face is too uncertain everywhere
  kUndeterminedLens,  ///< the views determine no lens, or contradict every lens
};

/// What happened, where, and what the technician can try. Each part is a sentence or phrase without
/// a full stop; `where` and `advice` may be empty.
struct Error {
  Message what;
  Where where;
  Message advice;
  ErrorKind kind = ErrorKind::kOther;

  /// "where: what. Try: advice", without the last full stop.
  [[nodiscard]] Message message() const {
    const Message located = en::at(where, what);
    return advice.empty() ? located : en::say("{}. Try: {}", located, advice);
  }
  /// The same in English, on one line, with the full stop.
  [[nodiscard]] std::string sentence() const { return message().english() + "."; }
};

/// Ends the program with a message: a Result was asked for what it does not hold, which is a
/// mistake of the program. `held`: its error; null: it holds a value.
[[noreturn]] void end_at_wrong_access(const Error* held);

/// Either a T or an Error. Access to the absent one ends the program, in every build.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}      // NOLINT
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT

  [[nodiscard]] bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  [[nodiscard]] T& value() & { return const_cast<T&>(std::as_const(*this).value()); }
  [[nodiscard]] const T& value() const& {
    if (!ok()) end_at_wrong_access(std::get_if<1>(&content_));
    return *std::get_if<0>(&content_);
  }
  [[nodiscard]] T&& value() && { return std::move(value()); }
  [[nodiscard]] const Error& error() const {
    if (ok()) end_at_wrong_access(nullptr);
    return *std::get_if<1>(&content_);
  }

  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

 private:
  std::variant<T, Error> content_;
};

/// The result of work that returns nothing.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT

  [[nodiscard]] bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  [[nodiscard]] const Error& error() const {
    if (ok()) end_at_wrong_access(nullptr);
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

using Status = Result<void>;

// Errors of the operating system, in words a technician can act on.

/// `doing`: the attempt ("could not write the file"); error_number: errno of the failed call. The
/// error's `where` is the path, its advice a remedy for that kind of failure.
[[nodiscard]] Error system_error(const Message& doing, const std::filesystem::path& path,
                                 int error_number);

/// Reason and remedy for an errno. An empty reason: the system's own text.
struct FailureWords {
  Message reason, advice;
};

/// The error "doing: reason".
[[nodiscard]] Error errno_error(const Message& doing, Where where, const FailureWords& words,
                                int error_number);

}  // namespace alltact
