#include "tests/support/source_texts.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

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
    default:
      return letter;
  }
}

/// Reads a source once from its begin to its end.
class Scanner {
 public:
  Scanner(const fs::path& file, std::string source) : file_(file), source_(std::move(source)) {}

  std::vector<SaidText> texts() {
    while (at_ < source_.size()) step();
    return std::move(texts_);
  }

 private:
  struct Bracket {
    std::string word;  ///< before it
    int line = 0;
    std::vector<std::string> literals;  ///< with which its content begins
    bool has_more = false;              ///< behind them
  };

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
    if (here("R\"(")) return skip_to(")\"");
    const char letter = source_[at_];
    if (letter == '"') return read_text();
    if (letter == '\'' && (at_ == 0 || !is_word(source_[at_ - 1]))) return skip_letter();
    if (letter == ')' || letter == '}') close();
    if (std::isspace(static_cast<unsigned char>(letter)) == 0) {
      is_after_text_ = false;
      if (!open_.empty() && letter != ',') open_.back().has_more = true;
    }
    if (letter == '(' || letter == '{') open_.push_back({word_before(), line(), {}, false});
    ++at_;
  }

  [[nodiscard]] int line() const {
    const auto here = source_.begin() + static_cast<std::ptrdiff_t>(at_);
    return 1 + static_cast<int>(std::count(source_.begin(), here, '\n'));
  }

  [[nodiscard]] std::string word_before() const {
    std::size_t begin = at_;
    while (begin > 0 && is_word(source_[begin - 1])) --begin;
    return source_.substr(begin, at_ - begin);
  }

  void skip_letter() {
    at_ += source_[at_ + 1] == '\\' ? 3 : 1;  // a quote may be escaped
    skip_to("'");
    is_after_text_ = false;
  }

  void read_text() {
    std::string text;
    for (++at_; at_ < source_.size() && source_[at_] != '"'; ++at_)
      text += source_[at_] == '\\' ? unescaped(source_[++at_]) : source_[at_];
    ++at_;
    if (open_.empty() || open_.back().has_more) return;
    auto& literals = open_.back().literals;
    if (is_after_text_)
      literals.back() += text;
    else
      literals.push_back(std::move(text));
    is_after_text_ = true;
  }

  void close() {
    if (open_.empty()) return;
    const Bracket call = std::move(open_.back());
    open_.pop_back();
    const bool is_said = call.word.ends_with("en::say");
    if (!is_said && !call.word.ends_with("en::count") && !call.word.ends_with("en::word")) return;
    SaidText text{file_, call.line, {}, {}};
    if (!call.literals.empty()) text.words = call.literals[0];
    if (!is_said && call.literals.size() > 1) text.comment = call.literals[1];
    texts_.push_back(std::move(text));
  }

  fs::path file_;
  std::string source_;
  std::size_t at_ = 0;
  std::vector<Bracket> open_;
  bool is_after_text_ = false;
  std::vector<SaidText> texts_;
};

}  // namespace

std::vector<SaidText> said_in(const fs::path& file) {
  std::ifstream stream(file);
  return Scanner(file, {std::istreambuf_iterator<char>(stream), {}}).texts();
}

std::vector<SaidText> said_below(const fs::path& folder) {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h")
      files.insert(entry.path());
  std::vector<SaidText> all;
  for (const fs::path& file : files) {
    auto some = said_in(file);
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace alltact::test
