#include "app/console/option_info.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace alltact {
namespace {

std::vector<std::string> split(std::string_view text, char divider) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = text.find(divider);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

bool is_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_' || c == '-';
  });
}

/// "a|b" or the set {a,b} of a check; empty where it is neither.
std::vector<std::string> words_in(const std::string& value, const std::string& checks) {
  auto words = split(value, '|');
  if (words.size() == 1) {
    const std::size_t open = checks.find('{'), close = checks.find('}');
    if (open == std::string::npos || close == std::string::npos) return {};
    words = split(std::string_view(checks).substr(open + 1, close - open - 1), ',');
  }
  return std::all_of(words.begin(), words.end(), is_word) ? words : std::vector<std::string>();
}

template <std::size_t kCount>
bool is_one_of(std::string_view value, const std::array<std::string_view, kCount>& names) {
  return std::find(names.begin(), names.end(), value) != names.end();
}

ValueKind kind_of(std::string_view value) {
  static constexpr std::array<std::string_view, 3> kFolders{"FINGER", "DIR", "FOLDER"};
  static constexpr std::array<std::string_view, 13> kFiles{"FILE",
                                                           "GAUGE.csv",
                                                           "GRIPPER",
                                                           "IMAGE",
                                                           "INPUT",
                                                           "PICTURE",
                                                           "PRESS",
                                                           "RECORDING",
                                                           "RESULTS",
                                                           "SCENE",
                                                           "SOURCE",
                                                           "TABLE",
                                                           "TEXT|FILE"};
  if (value.ends_with("...")) value.remove_suffix(3);
  if (is_one_of(value, kFolders)) return ValueKind::kFolder;
  const std::size_t dot = value.find('.');  // FILE.html
  const bool names_a_file = dot != std::string_view::npos && is_word(value.substr(dot + 1));
  return names_a_file || is_one_of(value, kFiles) ? ValueKind::kFile : ValueKind::kNone;
}

/// Up to where the details begin, at most `kMaxLetters` letters and no partial words.
std::string shortened(const std::string& what) {
  constexpr std::size_t kMaxLetters = 72;
  std::size_t end = what.size();
  for (const std::string_view divider : {" (", ": ", "; ", ". "})
    end = std::min(end, what.find(divider));
  if (end > kMaxLetters) end = std::min(what.rfind(' ', kMaxLetters), what.rfind(',', kMaxLetters));
  return what.substr(0, std::min(end, what.size()));
}

OptionInfo words_of(const CLI::Option& option) {
  OptionInfo words;
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  const bool is_flag = option.get_items_expected_max() == 0;
  // The kind of value, and behind a colon the description of its checks.
  const std::string type = is_flag ? std::string() : option.get_type_name();
  const std::size_t colon = type.find(':');
  words.value = words.names.empty() ? option.get_name(true) : type.substr(0, colon);
  if (!is_flag)
    words.words = words_in(words.value, colon == std::string::npos ? "" : type.substr(colon));
  words.kind = words.words.empty() ? kind_of(words.value) : ValueKind::kWords;
  words.is_list = option.get_delimiter() != '\0';
  words.is_required = option.get_required();
  words.is_repeated = option.get_items_expected_max() > 1;
  words.group = option.get_group();
  words.what = option.get_description();
  words.short_what = shortened(words.what);
  return words;
}

}  // namespace

std::vector<OptionInfo> options_of(const CLI::App& command) {
  std::vector<OptionInfo> all;
  for (const CLI::Option* option : command.get_options({}))
    if (!option->get_group().empty()) all.push_back(words_of(*option));
  return all;
}

}  // namespace alltact
