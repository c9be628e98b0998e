// Command-line flags made from the tables of settings: declared once there, never repeated here.
#pragma once

#include "calibration/presses/press_note_kinds.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/settings.h"
#include "core/base/typed_number.h"

#include <cassert>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace alltact {

// Numbers of flags: core/typed_number.h parses every one. Use
// `add_option(...)->transform(typed_number(0.1, 100))` instead of CLI11's own checks.

/// From `low` to `high`, for any floating-point option.
[[nodiscard]] CLI::Validator typed_number(double low, double high);
/// A possible value; one that is not plausible is added to number_warnings().
[[nodiscard]] CLI::Validator typed_number(const Quantity& quantity);
/// From `low` to `high`, for any integral option.
[[nodiscard]] CLI::Validator typed_integer(
    std::uint64_t low, std::uint64_t high = std::numeric_limits<std::uint64_t>::max());

/// Of the numbers on the command line that was read last: "--layer-mm: ...".
[[nodiscard]] std::vector<Message>& number_warnings();

/// Texts of numbers between commas or, where one has a decimal comma, semicolons: "0,5;2;1,49".
/// Error: not `count` of them.
[[nodiscard]] Result<std::vector<double>> typed_numbers(std::string_view text, std::size_t count);

/// "What it does (range; default). What more of it brings; what that costs."
template <class S>
std::string help_of(const Setting<S>& setting) {
  std::string help = fmt::format("{} ({}; default {})", setting.sentence, setting.range.text(),
                                 setting.default_value());
  if (setting.trade)
    help += fmt::format(". Accuracy: {}. Time: {}", setting.trade->gains, setting.trade->costs);
  return help;
}

/// Given values for settings of the group S, checked when the command line is read.
template <class S>
class SettingFlags {
 public:
  /// Adds a flag for each setting of the table except those named in `without`.
  void add_to(CLI::App& command, const std::vector<Setting<S>>& table,
              const std::vector<std::string>& without = {}) {
    for (const Setting<S>& setting : table) {
      if (std::find(without.begin(), without.end(), setting.name) != without.end()) continue;
      const auto take = [given = given_, &setting](const std::string& text) {
        S scratch;
        if (const Status status = setting.set(scratch, text); !status)
          throw CLI::ValidationError("--" + setting.name, status.error().what.english());
        (*given)[setting.name] = {&setting, text};
      };
      command.add_option_function<std::string>("--" + setting.name, take, help_of(setting))
          ->type_name(setting.range.words.empty()
                          ? std::string("VALUE")
                          : fmt::format("{}", fmt::join(setting.range.words, "|")))
          ->group("Settings");
    }
  }

  /// Refuses flags that would have no effect. Throws CLI::ValidationError.
  void refuse_all(const std::string& because) const {
    if (!given_->empty()) throw CLI::ValidationError("--" + given_->begin()->first, because);
  }

  /// `base` with all given values.
  [[nodiscard]] S applied_to(S base) const {
    for (const auto& [name, flag] : *given_) {
      [[maybe_unused]] const Status status = flag.first->set(base, flag.second);
      assert(status.ok());  // was checked when it was read
    }
    return base;
  }

 private:
  using Given = std::map<std::string, std::pair<const Setting<S>*, std::string>>;
  std::shared_ptr<Given> given_ = std::make_shared<Given>();
};

/// `--threads` for commands that compute in several; default 1.
inline void add_threads_flag(CLI::App& command, int& threads) {
  command
      .add_option("--threads", threads,
                  "Number of threads (1 to 64; default 1); the result does not depend on it")
      ->type_name("N")
      ->transform(typed_integer(1, 64));
}

// Command-line options that annotate single presses.

class PressFlags {
 public:
  /// All of press_note_kinds(), or the one of this name.
  void add_to(CLI::App& command, std::string_view only = {}) {
    for (const PressNoteKind& kind : press_note_kinds()) {
      if (!only.empty() && only != kind.flag) continue;
      auto texts = std::make_shared<std::vector<std::string>>();
      std::string help = std::string(kind.help) + "; may be repeated for other presses";
      if (only.empty() && kind.reset_word != nullptr)
        help += std::string(". With --again NAME=") + kind.reset_word + " removes it";
      command.add_option("--" + std::string(kind.flag), *texts, help)
          ->type_name(kind.form)
          ->allow_extra_args(false)
          ->take_all()
          ->check([&kind](const std::string& text) {
            PressSet nothing;
            const Status status = set_press_note(kind, text, nothing);
            return status ? std::string() : status.error().what.english();
          });
      given_.emplace_back(&kind, std::move(texts));
    }
  }

  /// Applies the given annotations to `presses`.
  void say(PressSet& presses) const {
    for (const auto& [kind, texts] : given_)
      for (const std::string& text : *texts)
        [[maybe_unused]] const Status checked = set_press_note(*kind, text, presses);
  }

 private:
  std::vector<std::pair<const PressNoteKind*, std::shared_ptr<std::vector<std::string>>>> given_;
};

}  // namespace alltact
