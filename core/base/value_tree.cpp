#include "core/base/value_tree.h"

#include "core/base/letters.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

namespace alltact {
namespace {

constexpr std::size_t kDeepest = 50, kMaxValues = 500'000;

/// Ends the parsing; parse_values() catches it.
struct RefusedText {
  Message what;
  int line;
  Message advice;
};

/// Counts the values of a tree.
class Budget {
 public:
  void spend(std::size_t depth, int line, std::size_t values = 1) {
    values_ += values;
    if (depth > kDeepest || values_ > kMaxValues)
      throw RefusedText{en::say("is too large to be read"), line,
                        en::say("a file with fewer entries")};
  }

 private:
  std::size_t values_ = 0;
};

void refuse_duplicates(const ValueTree& map) {
  std::set<std::string_view> seen;
  for (const ValueTree& child : map.children)
    if (!seen.insert(child.key).second)
      throw RefusedText{en::say("'{}' is given twice", printable(child.key)), child.line,
                        en::say("delete one of the two")};
}

std::size_t size_of(const ValueTree& tree) {
  std::size_t size = 1;
  for (const ValueTree& child : tree.children) size += size_of(child);
  return size;
}

std::size_t depth_of(const ValueTree& tree) {
  std::size_t depth = 0;
  for (const ValueTree& child : tree.children) depth = std::max(depth, depth_of(child));
  return depth + 1;
}

/// Builds the tree of one YAML document.
class YamlTree : public YAML::EventHandler {
 public:
  YamlTree(Budget& budget, std::size_t file_size) : budget_(budget), file_size_(file_size) {}

  ValueTree root;
  bool is_empty = true;

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& at, YAML::anchor_t anchor) override {
    ValueTree value;
    value.line = at.line + 1;
    add(std::move(value), anchor);
  }
  void OnScalar(const YAML::Mark& at, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    ValueTree value;
    value.line = at.line + 1;
    value.tag = tag;
    value.text = text;
    if (!open_.empty() && open_.back().is_block && tag == "?" && at.pos >= 0 &&
        static_cast<std::size_t>(at.pos) + text.size() >= file_size_)
      open_.back().tree.is_cut = true;
    is_empty = is_empty && (text.empty() || !open_.empty());
    add(std::move(value), anchor);
  }
  void OnAlias(const YAML::Mark& at, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end())
      throw RefusedText{en::say("an alias stands for nothing"), at.line + 1, ""};
    budget_.spend(open_.size() + depth_of(found->second), at.line + 1, size_of(found->second));
    add(ValueTree(found->second), 0);
  }
  void OnSequenceStart(const YAML::Mark& at, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    begin(ValueTree::Kind::kList, at, tag, anchor);
    open_.back().is_block = style == YAML::EmitterStyle::Block;
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& at, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(ValueTree::Kind::kMap, at, tag, anchor);
  }
  void OnMapEnd() override { end(); }

 private:
  struct Open {
    ValueTree tree;
    YAML::anchor_t anchor;
    bool is_block = false;
    bool has_key = false;
    std::string key;
    int key_line = 0;
  };

  void begin(ValueTree::Kind kind, const YAML::Mark& at, const std::string& tag,
             YAML::anchor_t anchor) {
    budget_.spend(open_.size(), at.line + 1);
    is_empty = false;
    Open open{{}, anchor, false, false, {}, 0};
    open.tree.kind = kind;
    open.tree.line = at.line + 1;
    open.tree.tag = tag;
    open_.push_back(std::move(open));
  }

  void end() {
    Open done = std::move(open_.back());
    open_.pop_back();
    if (done.tree.is_map()) refuse_duplicates(done.tree);
    add(std::move(done.tree), done.anchor);
  }

  void add(ValueTree value, YAML::anchor_t anchor) {
    budget_.spend(open_.size(), value.line);
    if (anchor != 0) anchors_[anchor] = value;
    if (open_.empty()) {
      root = std::move(value);
      return;
    }
    Open& open = open_.back();
    if (open.tree.is_map() && !open.has_key) {
      if (value.kind != ValueTree::Kind::kText)
        throw RefusedText{en::say("holds a key that is not a word"), value.line,
                          en::say("one word before each colon")};
      open.has_key = true;
      open.key = std::move(value.text);
      open.key_line = value.line;
      return;
    }
    if (open.tree.is_map()) {
      value.key = std::exchange(open.key, {});
      value.line = open.key_line;
      open.has_key = false;
    }
    open.tree.children.push_back(std::move(value));
  }

  Budget& budget_;
  std::size_t file_size_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, ValueTree> anchors_;
};

/// mrcal stores its measurements as b'...', with characters that YAML interprets: removed.
std::string without_python_bytes(std::string text) {
  if (text.find("'LENSMODEL_") == std::string::npos) return text;
  for (std::size_t at = 0; (at = text.find(": b'", at)) != std::string::npos; ++at) {
    const std::size_t end = text.find('\'', at + 4);
    if (end == std::string::npos) return text;
    text.replace(at, end - at, ": '");
  }
  return text;
}

ValueTree yaml_tree(std::string text, Budget& budget) {
  // OpenCV's first line is no directive that YAML knows.
  if (text.starts_with("%YAML:")) text.replace(0, std::min(text.find('\n'), text.size()), "");
  text = without_python_bytes(std::move(text));
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    YamlTree first(budget, text.size()), second(budget, text.size());
    if (!parser.HandleNextDocument(first)) return {};
    if (parser.HandleNextDocument(second) && !second.is_empty)
      throw RefusedText{en::say("holds more than one document"), second.root.line,
                        en::say("leave out the lines '---'")};
    return std::move(first.root);
  } catch (const YAML::Exception& problem) {
    throw RefusedText{en::say("this is not YAML: {}", printable(problem.msg)),
                      problem.mark.is_null() ? 1 : problem.mark.line + 1,
                      en::say("check the brackets, quotes and the space before each key")};
  }
}

/// nlohmann::json reports a parsed file's values here; a key that occurs twice stays twice.
class JsonTree : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit JsonTree(Budget& budget) : budget_(budget) {}
  ValueTree root;

  bool null() override { return add_text(""); }
  bool boolean(bool value) override { return add_text(value ? "true" : "false"); }
  bool number_integer(std::int64_t value) override { return add_text(fmt::format("{}", value)); }
  bool number_unsigned(std::uint64_t value) override { return add_text(fmt::format("{}", value)); }
  bool number_float(double, const std::string& text) override { return add_text(text); }
  bool string(std::string& text) override { return add_text(std::move(text)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return begin(ValueTree::Kind::kMap); }
  bool key(std::string& text) override {
    key_ = std::move(text);
    return true;
  }
  bool end_object() override {
    refuse_duplicates(open_.back());
    return end();
  }
  bool start_array(std::size_t) override { return begin(ValueTree::Kind::kList); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }

 private:
  bool add_text(std::string text) {
    ValueTree value;
    value.key = std::exchange(key_, {});
    value.text = std::move(text);
    return add(std::move(value));
  }
  bool begin(ValueTree::Kind kind) {
    budget_.spend(open_.size(), 0);
    ValueTree value;
    value.kind = kind;
    value.key = std::exchange(key_, {});
    open_.push_back(std::move(value));
    return true;
  }
  bool end() {
    ValueTree done = std::move(open_.back());
    open_.pop_back();
    return add(std::move(done));
  }
  bool add(ValueTree value) {
    budget_.spend(open_.size(), 0);
    if (open_.empty())
      root = std::move(value);
    else
      open_.back().children.push_back(std::move(value));
    return true;
  }

  Budget& budget_;
  std::string key_;
  std::vector<ValueTree> open_;
};

ValueTree xml_tree(const std::string& key, const boost::property_tree::ptree& element,
                   std::size_t depth, Budget& budget) {
  budget.spend(depth, 0);
  ValueTree value;
  value.key = key;
  bool is_list = true;
  for (const auto& [name, child] : element) {
    if (name == "<xmlattr>") value.tag = child.get("type_id", "");
    if (name.starts_with('<')) continue;  // attributes, comments
    is_list = is_list && name == "_";
    value.children.push_back(xml_tree(name, child, depth + 1, budget));
  }
  if (value.children.empty()) {
    value.text = element.data();
    return value;
  }
  value.kind = is_list ? ValueTree::Kind::kList : ValueTree::Kind::kMap;
  if (is_list)
    for (ValueTree& child : value.children) child.key.clear();
  else
    refuse_duplicates(value);
  return value;
}

ValueTree xml_tree(const std::string& text, Budget& budget) {
  // The parser is recursive, so that the depth is checked before.
  std::size_t depth = 0;
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at) {
    const char next = at + 1 < text.size() ? text[at + 1] : '\0';
    if (next == '/')
      depth -= depth > 0 ? 1 : 0;
    else if (next != '?' && next != '!')
      budget.spend(++depth, 0);
    const std::size_t end = text.find('>', at);
    if (next != '/' && end != std::string::npos && text[end - 1] == '/') depth -= depth > 0 ? 1 : 0;
  }
  try {
    std::istringstream stream(text);
    boost::property_tree::ptree file;
    boost::property_tree::read_xml(stream, file, boost::property_tree::xml_parser::no_comments);
    Budget fresh;
    ValueTree root = xml_tree("", file, 0, fresh);
    if (root.children.size() == 1) root = ValueTree(std::move(root.children.front()));
    root.key.clear();
    return root;
  } catch (const boost::property_tree::xml_parser_error& problem) {
    throw RefusedText{en::say("this is not XML: {}", printable(problem.message())),
                      static_cast<int>(problem.line()), en::say("copy the file again")};
  }
}

bool is_property_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter(c) || is_digit(c) || c == '_' || c == '.';
  });
}

/// Properties of an object as Matlab prints or assigns them, one after the other; nested ones are
/// not distinguished.
class MatlabText {
 public:
  explicit MatlabText(const std::string& text) : stream_(text) {
    tree.kind = ValueTree::Kind::kMap;
  }

  ValueTree tree;

  void read(Budget& budget) {
    std::string line;
    while (next(line)) {
      const std::size_t mark = line.find_first_of(":=");
      if (mark == std::string::npos) continue;
      std::string_view name = trimmed(std::string_view(line).substr(0, mark));
      if (!is_property_name(name)) continue;
      name = name.substr(name.rfind('.') + 1);
      budget.spend(1, line_);
      ValueTree value;
      value.key = std::string(name);
      value.line = line_;
      value.text = value_after(line.substr(mark + 1), line[mark] == '=');
      if (!trimmed(value.text).empty()) tree.children.push_back(std::move(value));
    }
    refuse_duplicates(tree);
  }

 private:
  bool next(std::string& line) {
    ++line_;
    return static_cast<bool>(std::getline(stream_, line));
  }

  /// A bracket may end in a later line; behind 'Name =' rows of numbers may follow.
  std::string value_after(std::string rest, bool is_assigned) {
    std::string line;
    if (rest.find('[') != std::string::npos) {
      const int begun = line_;
      while (rest.find(']') == std::string::npos) {
        if (!next(line))
          throw RefusedText{en::say("a bracket is not closed"), begun,
                            en::say("copy the file again")};
        rest += ' ' + line;
      }
    } else if (is_assigned && trimmed(rest).empty()) {
      while (next(line)) {
        if (trimmed(line).empty() && !trimmed(rest).empty() && rest.find('*') == std::string::npos)
          break;
        if (trimmed(line).empty()) continue;
        // 1.0e+03 * stands before rows that are all a thousand times larger.
        const std::size_t star = line.find('*');
        if (star != std::string::npos)
          scale_ = line.substr(0, star);
        else
          rest += ' ' + scaled(line);
      }
      scale_.clear();
    }
    for (char& c : rest)
      if (c == '[' || c == ']') c = ' ';
    const std::string_view value = trimmed(rest);
    return std::string(value.ends_with(';') ? value.substr(0, value.size() - 1) : value);
  }

  std::string scaled(const std::string& line) const {
    if (scale_.empty()) return line;
    std::istringstream words(line);
    std::string all, word;
    while (words >> word) {
      double factor = 0, number = 0;
      const std::string_view by = trimmed(scale_);
      const auto parsed = std::from_chars(by.data(), by.data() + by.size(), factor);
      const auto one = std::from_chars(word.data(), word.data() + word.size(), number);
      const bool is_number = parsed.ec == std::errc() && one.ec == std::errc();
      all += (is_number ? fmt::format("{}", number * factor) : word) + ' ';
    }
    return all;
  }

  std::istringstream stream_;
  int line_ = 0;
  std::string scale_;
};

bool is_of_matlab(std::string_view text) {
  for (const char* word : {"RadialDistortion", "IntrinsicMatrix", "FocalLength"})
    if (text.find(word) != std::string_view::npos) return true;
  return false;
}

ValueTree tree_of(std::string content) {
  Budget budget;
  if (content.starts_with("\xEF\xBB\xBF")) content.erase(0, 3);
  if (content.starts_with("MATLAB 5.0 MAT-file"))
    throw RefusedText{en::say("is a MAT-file, which is not text"), 0,
                      en::say("in Matlab: writelines(jsonencode(toStruct(cameraParams)), "
                              "'camera.json')")};
  if (content.starts_with("PK\x03\x04"))
    throw RefusedText{en::say("is a packed archive"), 0,
                      en::say("unpack it, and use a file of it")};
  if (content.find('\0') != std::string::npos)
    throw RefusedText{en::say("is no text file"), 0, en::say("a calibration as YAML, JSON or XML")};
  const std::string_view text = trimmed(content);
  if (text.starts_with('<')) return xml_tree(content, budget);
  if (text.starts_with('{') || text.starts_with('[')) {
    JsonTree json(budget);
    if (nlohmann::json::sax_parse(content, &json)) return std::move(json.root);
    budget = Budget();
  }
  std::optional<RefusedText> problem;
  ValueTree tree;
  try {
    tree = yaml_tree(content, budget);
  } catch (const RefusedText& refused) {
    problem = refused;
  }
  if ((problem || !tree.is_map()) && is_of_matlab(text)) {
    MatlabText matlab(content);
    matlab.read(budget);
    return std::move(matlab.tree);
  }
  if (problem) throw *problem;
  return tree;
}

}  // namespace

const ValueTree* ValueTree::find(std::string_view name) const {
  if (!is_map()) return nullptr;
  for (const ValueTree& child : children)
    if (child.key == name) return &child;
  return nullptr;
}

Result<ValueTree> parse_values(std::string content, const std::filesystem::path& origin) {
  try {
    return tree_of(std::move(content));
  } catch (const RefusedText& refused) {
    const std::string where =
        refused.line > 0 ? fmt::format("{}:{}", origin.string(), refused.line) : origin.string();
    return Error{refused.what, where, refused.advice};
  } catch (const std::exception& problem) {  // of a parser
    return Error{Message::typed(printable(problem.what())), origin, ""};
  }
}

}  // namespace alltact
