// Command-line options that annotate single presses.
#pragma once

#include "calibration/presses/press_note_kinds.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace alltact {

class PressFlags {
 public:
  /// All of press_note_kinds(), or the one of this name.
  void add_to(CLI::App& command, std::string_view only = {}) {
    for (const PressNoteKind& kind : press_note_kinds()) {
      if (!only.empty() && only != kind.flag) continue;
      auto texts = std::make_shared<std::vector<std::string>>();
      std::string help = std::string(kind.help) + "; may be given again for another";
      if (only.empty() && kind.reset_word != nullptr)
        help += std::string(". With --again NAME=") + kind.reset_word + " takes it back";
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
