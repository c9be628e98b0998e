// Command-line flags made from the tables of settings: declared once there, never repeated here.
#pragma once

#include "app/console/number_flags.h"
#include "core/settings.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace alltact {

/// "What it does (range; default). What more of it brings; what that costs."
template <class S>
std::string help_of(const Setting<S>& setting) {
  std::string help = fmt::format(
      "{} ({}; default {})", setting.sentence, setting.range.text(), setting.default_value());
  if (setting.trade)
    help +=
        fmt::format(". In accuracy: {}. In time: {}", setting.trade->gains, setting.trade->costs);
  return help;
}

/// Given values for settings of the group S, checked when the command line is read.
template <class S>
class SettingFlags {
 public:
  /// Adds a flag for each setting of the table except those named in `without`.
  void add_to(CLI::App& command,
              const std::vector<Setting<S>>& table,
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
      .add_option(
          "--threads", threads, "The result is the same for any number (1 to 64; default 1)")
      ->type_name("N")
      ->transform(typed_integer(1, 64));
}

}  // namespace alltact
