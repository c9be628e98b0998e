// Options of the command line that say something of single presses.
#pragma once

#include "calibration/presses/press_sayings.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace alltact {

class PressFlags {
 public:
  /// All of press_sayings(), or the one of this name.
  void add_to(CLI::App& command, std::string_view only = {}) {
    for (const PressSaying& kind : press_sayings()) {
      if (!only.empty() && only != kind.flag) continue;
      auto texts = std::make_shared<std::vector<std::string>>();
      std::string help = std::string(kind.help) + "; may be given again for another";
      if (only.empty() && kind.take_back != nullptr)
        help += std::string(". With --again NAME=") + kind.take_back + " takes it back";
      command.add_option("--" + std::string(kind.flag), *texts, help)
          ->type_name(kind.form)
          ->allow_extra_args(false)
          ->take_all()
          ->check([&kind](const std::string& text) {
            PressSet nothing;
            const Status said = say_of_press(kind, text, nothing);
            return said ? std::string() : said.error().what.english();
          });
      said_.emplace_back(&kind, std::move(texts));
    }
  }

  /// Takes what was said into `presses`.
  void say(PressSet& presses) const {
    for (const auto& [kind, texts] : said_)
      for (const std::string& text : *texts)
        [[maybe_unused]] const Status checked = say_of_press(*kind, text, presses);
  }

 private:
  std::vector<std::pair<const PressSaying*, std::shared_ptr<std::vector<std::string>>>> said_;
};

}  // namespace alltact
