// Output of the command line: results on standard output, errors and progress on standard error,
// progress only when a person is watching.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace alltact {

class Console {
 public:
  using Json = nlohmann::ordered_json;

  /// json: instead of text, one object on standard output at the end.
  explicit Console(bool json);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// A line for people; nothing with --json.
  void say(std::string_view line);
  /// A line on standard error that does not stop the work.
  void warn(std::string_view line);

  /// True when the answer is one JSON object.
  [[nodiscard]] bool json() const { return json_; }
  /// A line of data on standard output, at once. Error: nobody reads it.
  [[nodiscard]] Status put(std::string_view line);

  /// The answer for --json; filled by the command, printed by finish().
  [[nodiscard]] Json& answer() { return answer_; }

  /// The work's listener: draws progress when standard error is a terminal. The first Ctrl-C
  /// requests the work to stop, the second ends the program; so does SIGTERM.
  [[nodiscard]] Job& job() { return job_; }

  /// Prints the rest and returns the exit status: 0, or 1 with the error's sentence.
  [[nodiscard]] int finish(const Status& status);

 private:
  void draw(double fraction, const Message& what);
  void clear_progress();

  bool json_;
  bool watched_;  // standard error is a terminal
  bool drawn_ = false;
  std::size_t drawn_width_ = 0;
  std::int64_t last_drawn_ms_ = 0;
  Json answer_ = Json::object();
  Job job_;
};

/// null without a value.
[[nodiscard]] inline Console::Json json_of(const std::optional<double>& value) {
  return value ? Console::Json(*value) : Console::Json();
}

/// As the answer for --json lists them.
[[nodiscard]] Console::Json in_english(const std::vector<Message>& messages);

}  // namespace alltact
