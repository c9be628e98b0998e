#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "calibration/export/export_finger.h"

#include <fmt/format.h>

namespace alltact {
namespace {

struct ExportOptions {
  Path finger;
  Path folder;
  std::vector<ExportForm> forms;
};

std::string words_with(std::string_view divider, std::string (*word)(const ExportFormInfo&)) {
  std::string words;
  for (const ExportFormInfo& info : export_forms())
    words += (words.empty() ? "" : std::string(divider)) + word(info);
  return words;
}

/// Writes a finger's calibration for other programs.
Status run_export(const ExportOptions& options, Console& console) {
  const auto finger = open_finger(options.finger, console);
  if (!finger) return finger.error();
  std::vector<Path> written;
  const Status status =
      export_finger(**finger, options.forms, options.folder, console.job(), &written);
  for (const Path& file : written) {
    console.say(file.string());
    console.answer()["files"].push_back(file.string());
  }
  if (!status || !std::count(options.forms.begin(), options.forms.end(), ExportForm::kZip))
    return status;
  for (const Path& take : unused_recordings((*finger)->finger, (*finger)->folder)) {
    console.say(fmt::format("not in the zip, because the finger does not use it: {}",
                            take.filename().string()));
    console.answer()["left_out"].push_back(take.string());
  }
  return status;
}

}  // namespace

void add_export(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ExportOptions>();
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = add_command(program, "export");
  command->add_option("FINGER", options->finger, "The finger's folder")->required();
  command
      ->add_option("--to", *words,
                   "Formats, with commas: " + words_with(", ",
                                                         [](const ExportFormInfo& info) {
                                                           return fmt::format("{} ({})", info.word,
                                                                              info.files);
                                                         }))
      ->type_name("LIST")
      ->delimiter(',')
      ->take_all()
      ->expected(1)
      ->check(CLI::Validator(
          [](const std::string& word) {
            return export_form_from(word)
                       ? std::string()
                       : fmt::format("{} is not one of {}", word,
                                     words_with(", ", [](const ExportFormInfo& info) {
                                       return std::string(info.word);
                                     }));
          },
          "{" + words_with(",", [](const ExportFormInfo& info) { return std::string(info.word); }) +
              "}"))
      ->required();
  command->add_option("-o,--output", options->folder, "Folder for the files")
      ->type_name("DIR")
      ->required();
  command->callback([=, &chosen] {
    for (const std::string& word : *words) options->forms.push_back(*export_form_from(word));
    chosen = [=](Console& console) { return run_export(*options, console); };
  });
}

}  // namespace alltact
