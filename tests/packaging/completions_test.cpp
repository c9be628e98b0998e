// Every flag of every command's help is completed in each shell, and so is every word that a
// setting takes: asked for as a person does, from the shell itself.
#include "core/sensing/pipeline_settings.h"
#include "core/simulation/effect.h"
#include "tests/support/program.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::IsSupersetOf;
using testing::UnorderedElementsAreArray;
using Words = std::vector<std::string>;

const std::string kBuilt = ALLTACT_BUILT_SHARE;

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The flags that a help lists, as CLI11 lays them out.
Words flags_in(const std::string& help) {
  static const std::regex line_form(R"(^  (-\w,)?(--[a-z0-9-]+|-\w)( .*)?$)");
  Words flags;
  for (const std::string& line : lines_of(help)) {
    std::smatch found;
    if (!std::regex_match(line, found, line_form)) continue;
    if (found[1].matched) flags.push_back(found[1].str().substr(0, 2));
    flags.push_back(found[2]);
  }
  return flags;
}

/// Flags of a command's help, asked for once.
const Words& flags_of(const std::string& command) {
  static std::map<std::string, Words> known;
  const auto [at, is_new] = known.emplace(command, Words());
  if (is_new) at->second = flags_in(run_alltact({command, "--help"}).output);
  return at->second;
}

Words commands() {
  Words names;
  static const std::regex line_form(R"(^  ([a-z]+) +[A-Z].*$)");
  bool is_list = false;
  for (const std::string& line : lines_of(run_alltact({"--help"}).output)) {
    std::smatch found;
    if (line == "Subcommands:") is_list = true;
    if (is_list && std::regex_match(line, found, line_form)) names.push_back(found[1]);
  }
  return names;
}

/// Asks a shell for what it would offer after each of these command lines, all in one go.
using Offers = std::map<std::string, Words>;

Offers offers_of(const std::string& script_form, const Words& lines, const std::string& runner) {
  const TemporaryFolder folder;
  std::string script = script_form;
  for (const std::string& line : lines) script += "echo '== " + line + "'\nask '" + line + "'\n";
  write_text(folder / "script", script);
  const ProgramRun run = run_shell(runner + " '" + (folder / "script").string() + "'");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  Offers offers;
  std::string asked;
  for (const std::string& line : lines_of(run.output)) {
    if (line.starts_with("== "))
      offers[asked = line.substr(3)] = {};
    else
      offers[asked].push_back(line.substr(0, line.find('\t')));
  }
  return offers;
}

/// Readline's part: the words, and which of them the cursor is in.
Offers bash_offers(const std::string& program, const Words& lines) {
  return offers_of(
      "source '" + kBuilt + "/bash/" + program +
          "'\n"
          "ask() {\n"
          "  local IFS=' '\n  COMP_LINE=$1 COMP_POINT=${#1}\n"
          "  read -ra COMP_WORDS <<<\"${1//=/ = }\"\n"
          "  if [[ $1 == *[\\ =] ]]; then COMP_WORDS+=(''); fi\n"
          "  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
          "  $(complete -p " +
          program + " | sed 's/.*-F \\([^ ]*\\) .*/\\1/') " + program +
          "\n"
          "  if ((${#COMPREPLY[@]})); then printf '%s\\n' \"${COMPREPLY[@]}\"; fi\n}\n",
      lines, "bash --norc");
}

Offers fish_offers(const std::string& program, const Words& lines) {
  return offers_of("source '" + kBuilt + "/fish/" + program +
                       ".fish'\nfunction ask; complete -C $argv[1]; end\n",
                   lines, "fish --no-config");
}

/// A zsh at a terminal of its own, as its completion needs one; what would be offered is taken down
/// where it is added.
Offers zsh_offers(const std::string& /*program*/, const Words& lines) {
  const TemporaryFolder folder;
  const std::string offered = (folder / "offered").string();
  write_text(folder / "setup",
             R"(
PROMPT=
unsetopt zle_bracketed_paste
setopt no_beep no_list_ambiguous
zstyle ':completion:*' completer _complete
fpath=(')" + kBuilt +
                 R"(/zsh' $fpath)
autoload -Uz compinit && compinit -u -d ')" +
                 (folder / "dump").string() + R"('
compadd() {
  local word
  for word in "$@"; do
    [[ $word == (-|--) ]] && break
    # Asked for an array: no offer.
    if [[ $word == -[a-zA-Z]#[OAD][a-zA-Z]# ]]; then builtin compadd "$@"; return; fi
  done
  local -a found
  builtin compadd -A found "$@"
  (( ${#found} )) && print -rl -- "${found[@]}" >>')" +
                 offered + R"('
  builtin compadd "$@"
}
ask-now() { : >')" +
                 offered + R"('; _main_complete; print -r -- THE_END }
zle -C ask complete-word ask-now
bindkey '^I' ask
print READY
)");
  Offers offers = offers_of("zmodload zsh/zpty\nzpty z zsh -f -i\nzpty -w z \"source '" +
                                (folder / "setup").string() +
                                "'\"\n"
                                "until_() { local line; while zpty -r z line; do\n"
                                "  [[ $line == *$1* ]] && return; done }\nuntil_ READY\n"
                                "ask() { zpty -w -n z $'\\C-u'\"$1\"$'\\t'; until_ THE_END; cat '" +
                                offered + "' }\n",
                            lines, "timeout 120 zsh -f");
  for (auto& [line, words] : offers) {  // under several headlines
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
  }
  return offers;
}

struct Shell {
  const char* name;
  Offers (*ask)(const std::string& program, const Words& lines);
};
void PrintTo(const Shell& shell, std::ostream* out) { *out << shell.name; }

class Completions : public testing::TestWithParam<Shell> {};
INSTANTIATE_TEST_SUITE_P(Shells, Completions,
                         testing::Values(Shell{"bash", bash_offers}, Shell{"zsh", zsh_offers},
                                         Shell{"fish", fish_offers}),
                         [](const auto& of) { return of.param.name; });

TEST_P(Completions, HaveEveryCommandAndEveryFlagOfItsHelp) {
  const Words names = commands();
  ASSERT_GE(names.size(), 17U);
  Words lines{"alltact "};
  for (const std::string& name : names)
    for (const char* dashes : {" -", " --"}) lines.push_back("alltact " + name + dashes);
  const Offers offers = GetParam().ask("alltact", lines);
  EXPECT_THAT(offers.at("alltact "), IsSupersetOf(names));
  for (const std::string& name : names) {
    const Words& flags = flags_of(name);
    ASSERT_THAT(flags, IsSupersetOf({"-h", "--help", "--json"})) << name;
    Words offered = offers.at("alltact " + name + " -");
    const Words& with_two = offers.at("alltact " + name + " --");
    offered.insert(offered.end(), with_two.begin(), with_two.end());
    EXPECT_THAT(offered, IsSupersetOf(flags)) << name;
  }
}

TEST_P(Completions, HaveEveryWordThatASettingTakes) {
  Words lines;
  for (const auto& setting : pipeline_settings())
    if (!setting.range.words.empty()) {
      lines.push_back("alltact reconstruct --" + setting.name + " ");
      lines.push_back("alltact reconstruct --" + setting.name + "=");
    }
  ASSERT_GE(lines.size(), 6U);
  const Offers offers = GetParam().ask("alltact", lines);
  for (const auto& setting : pipeline_settings()) {
    if (setting.range.words.empty()) continue;
    EXPECT_THAT(offers.at("alltact reconstruct --" + setting.name + " "),
                UnorderedElementsAreArray(setting.range.words))
        << setting.name;
    Words with_sign = offers.at("alltact reconstruct --" + setting.name + "=");
    for (std::string& word : with_sign) word = word.substr(word.find('=') + 1);  // fish says both
    EXPECT_THAT(with_sign, UnorderedElementsAreArray(setting.range.words)) << setting.name;
  }
}

TEST_P(Completions, GoOnBehindACommaAndOfferFilesAndFolders) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "finger-1");
  write_text(folder / "film.mkv", "");
  const std::string f = (folder / "f").string();
  const std::string list = "alltact reconstruct --format depth,p", finger = "alltact check " + f,
                    source = "alltact-studio --source " + f;
  const Offers offers = GetParam().ask("alltact", {list, finger});
  const auto has = [](const Words& words, const std::string& ending) {
    return std::any_of(words.begin(), words.end(), [&](std::string word) {
      while (word.ends_with('/')) word.pop_back();
      return word.ends_with(ending);
    });
  };
  EXPECT_TRUE(has(offers.at(list), "points"));
  EXPECT_TRUE(has(offers.at(list), "ply"));
  EXPECT_FALSE(has(offers.at(list), "stl"));
  EXPECT_TRUE(has(offers.at(finger), "finger-1"));
  EXPECT_FALSE(has(offers.at(finger), "film.mkv"));
  const Offers studio = GetParam().ask("alltact-studio", {source});
  EXPECT_TRUE(has(studio.at(source), "film.mkv"));
  EXPECT_TRUE(has(studio.at(source), "finger-1"));
}

TEST_P(Completions, HaveEveryFlagOfTheStudiosHelp) {
  const ProgramRun help = run_shell("'" ALLTACT_BUILD_DIR "/app/studio/alltact-studio' --help");
  const Words flags = flags_in(help.output);
  ASSERT_THAT(flags, IsSupersetOf({"-h", "--help", "--version", "--source"})) << help.errors;
  const Offers offers = GetParam().ask("alltact-studio", {"alltact-studio -", "alltact-studio --"});
  Words offered = offers.at("alltact-studio -");
  const Words& with_two = offers.at("alltact-studio --");
  offered.insert(offered.end(), with_two.begin(), with_two.end());
  EXPECT_THAT(offered, IsSupersetOf(flags));
}

}  // namespace
}  // namespace alltact::test
