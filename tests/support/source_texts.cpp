#include "tests/support/source_texts.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

bool is_word(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == ':';
}

char unescaped(char letter) {
  switch (letter) {
    case 'n':
      return '\n';
    case 't':
      return '\t';
    case '0':
      return '\x04';
    default:
      return letter;
  }
}

/// Reads a source once from its begin to its end.
class Scanner {
 public:
  Scanner(const fs::path& file, std::string source) : file_(file), source_(std::move(source)) {}

  std::vector<SourceText> texts() {
    while (at_ < source_.size()) step();
    return std::move(texts_);
  }

 private:
  [[nodiscard]] bool here(std::string_view what) const {
    return source_.compare(at_, what.size(), what) == 0;
  }
  void skip_to(std::string_view what) {
    const std::size_t found = source_.find(what, at_);
    at_ = found == std::string::npos ? source_.size() : found + what.size();
  }

  void step() {
    if (here("//") || here("#include")) return skip_to("\n");
    if (here("/*")) return skip_to("*/");
    if (here("R\"(")) return read_raw();
    const char letter = source_[at_];
    if (letter == '"') return read_text();
    if (letter == '\'' && (at_ == 0 || !is_word(source_[at_ - 1]))) return skip_letter();
    if (letter == '(' || letter == '{') open_.push_back(word_before());
    if ((letter == ')' || letter == '}') && !open_.empty()) open_.pop_back();
    if (std::isspace(static_cast<unsigned char>(letter)) == 0) {
      is_after_text_ = false;
      is_first_ = letter == '(' || letter == '{';
    }
    ++at_;
  }

  [[nodiscard]] std::string word_before() const {
    std::size_t begin = at_;
    while (begin > 0 && is_word(source_[begin - 1])) --begin;
    return source_.substr(begin, at_ - begin);
  }

  void skip_letter() {
    at_ += source_[at_ + 1] == '\\' ? 2 : 1;
    skip_to("'");
    is_after_text_ = false;
  }

  void read_raw() {
    const std::size_t begin = at_ + 3;
    skip_to(")\"");
    add(source_.substr(begin, at_ - 2 - begin));
  }

  void read_text() {
    std::string text;
    for (++at_; at_ < source_.size() && source_[at_] != '"'; ++at_)
      text += source_[at_] == '\\' ? unescaped(source_[++at_]) : source_[at_];
    ++at_;
    add(std::move(text));
  }

  void add(std::string text) {
    if (is_after_text_) {
      texts_.back().text += text;
      return;
    }
    const auto line =
        1 + std::count(source_.begin(), source_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    const bool is_filled_in = std::any_of(open_.begin(), open_.end(), [](const std::string& word) {
      return word == "fmt::format" || word == "report" || word == "remark";
    });
    const bool is_what = !open_.empty() && open_.back() == "Error" && is_first_;
    const bool is_told = is_filled_in || is_what;
    static const std::set<std::string> kQt{"QStringLiteral", "QLatin1String", "QT_TRANSLATE_NOOP"};
    const bool is_qt =
        is_first_ && !open_.empty() &&
        (open_.back() == "tr" || open_.back().ends_with("::tr") || kQt.contains(open_.back()));
    texts_.push_back({file_, static_cast<int>(line), std::move(text), is_told, is_qt});
    is_after_text_ = true;
    is_first_ = false;
  }

  fs::path file_;
  std::string source_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;  // the word before each bracket that is open
  bool is_after_text_ = false, is_first_ = false;
  std::vector<SourceText> texts_;
};

std::string without_joints(const std::string& text) {
  static const std::regex joints("^[\x01 ;:,.]+|[\x01 ;:,.]+$");
  return std::regex_replace(text, joints, "");
}

}  // namespace

std::vector<SourceText> texts_of(const fs::path& file) {
  std::ifstream stream(file);
  return Scanner(file, {std::istreambuf_iterator<char>(stream), {}}).texts();
}

std::vector<SourceText> texts_below(const fs::path& folder) {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h")
      files.insert(entry.path());
  std::vector<SourceText> all;
  for (const fs::path& file : files) {
    auto some = texts_of(file);
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

std::string bare_pattern(const std::string& pattern) {
  static const std::regex hole("%[1-9]");
  return without_joints(std::regex_replace(pattern, hole, "\x01"));
}

std::set<std::string> bare_sentences(const std::string& text) {
  static const std::regex plural("([a-z]{3})\\{\\}"), hole("\\{[^{}]*\\}"), end("\\. (?=[A-Z])");
  static const std::regex advice("^Try: (?=.)");
  static const std::regex open("\\{\\{"), close("\\}\\}");
  std::set<std::string> sentences;
  if (std::regex_search(text, plural)) {
    const bool hisses = text.find("press{}") != std::string::npos;
    for (const char* form : {"$1", hisses ? "$1es" : "$1s"})
      sentences.merge(bare_sentences(std::regex_replace(text, plural, form)));
    return sentences;
  }
  std::string marked = std::regex_replace(std::regex_replace(text, open, "\x02"), close, "\x03");
  marked = std::regex_replace(marked, hole, "\x01");
  std::replace(marked.begin(), marked.end(), '\x02', '{');
  std::replace(marked.begin(), marked.end(), '\x03', '}');
  for (std::sregex_token_iterator one(marked.begin(), marked.end(), end, -1), none; one != none;
       ++one)
    if (const std::string bare = without_joints(std::regex_replace(one->str(), advice, ""));
        !bare.empty())
      sentences.insert(bare);
  return sentences;
}

bool is_for_people(const std::string& bare, bool is_told) {
  static const std::regex words("[A-Za-z\x01'%)\\]][,;:]? [a-z(\x01]");
  static const std::regex letters("[A-Za-z]{2,}");
  static const std::regex word("[A-Za-z ,'-]{3,}");
  if (!std::regex_search(bare, letters)) return false;
  return std::regex_search(bare, words) || (is_told && std::regex_match(bare, word));
}

}  // namespace alltact::test
