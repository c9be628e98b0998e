#include "core/yaml/yaml_writer.h"

namespace alltact {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// True when YAML gives no special meaning to any character, also inside a list.
bool is_harmless(std::string_view text) {
  if (text.empty() || text.front() == ' ' || text.back() == ' ') return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter(c) || is_digit(c) ||
           std::string_view(" ./+-()").find(c) != std::string_view::npos;
  });
}

bool is_reserved(std::string_view text) {
  static constexpr std::array kWords{
      "true", "false", "yes", "no", "on", "off", "y", "n", "null", "nan", "inf"};
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return std::find(kWords.begin(), kWords.end(), lower) != kWords.end();
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (char c : text) {
    switch (c) {
      case '"':
        result += "\\\"";
        break;
      case '\\':
        result += "\\\\";
        break;
      case '\n':
        result += "\\n";
        break;
      case '\t':
        result += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
          result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else {
          result += c;
        }
    }
  }
  return result + '"';
}

std::string written(const YamlValue& value) {
  const std::string tag = value.tag.empty() ? "" : "!<" + value.tag + "> ";
  switch (value.kind) {
    case YamlValue::Kind::kNull:
      return tag + "~";
    case YamlValue::Kind::kScalar:
      return tag + (value.is_quoted ? in_quotes(value.text) : yaml_text_or_number(value.text));
    case YamlValue::Kind::kList: {
      std::vector<std::string> items;
      for (const YamlValue& item : value.items) items.push_back(written(item));
      return tag + yaml_list(items);
    }
    case YamlValue::Kind::kMap: {
      std::vector<std::string> entries;
      for (const auto& [key, inner] : value.entries)
        entries.push_back(yaml_text(key) + ": " + written(inner));
      return fmt::format("{}{{{}}}", tag, fmt::join(entries, ", "));
    }
  }
  return {};
}

}  // namespace

std::string yaml_number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find('.') != std::string::npos) return text;
  const std::size_t exponent = text.find('e');
  // Without the point some readers take 1e-07 for a text.
  text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  return text;
}

std::string yaml_text(std::string_view text) {
  const bool is_plain = is_harmless(text) && is_letter(text.front()) && !is_reserved(text);
  return is_plain ? std::string(text) : in_quotes(text);
}

std::string yaml_text_or_number(std::string_view text) {
  const bool is_signed = text.size() > 1 && text.front() == '-' && is_digit(text[1]);
  const bool is_null = text == "null" || text == "Null" || text == "NULL";
  const bool is_plain = is_harmless(text) && !is_null &&
                        (is_letter(text.front()) || is_digit(text.front()) || is_signed);
  return is_plain ? std::string(text) : in_quotes(text);
}

std::string yaml_list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string yaml_numbers(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (double value : values) items.push_back(yaml_number(value));
  return yaml_list(items);
}

void YamlBlock::add(std::string key, std::string value) {
  entries_.emplace_back(std::move(key), std::move(value));
}

void YamlBlock::add_unknown(const UnknownKeys& unknown) {
  const auto section = unknown.find(name_);
  if (section == unknown.end()) return;
  for (const auto& [key, value] : section->second) {
    const auto same = [&key = key](const auto& entry) { return entry.first == key; };
    if (std::none_of(entries_.begin(), entries_.end(), same)) add(key, written(value));
  }
}

std::string YamlBlock::in_braces() const {
  std::vector<std::string> parts;
  for (const auto& [key, value] : entries_) parts.push_back(yaml_text(key) + ": " + value);
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

std::string YamlBlock::on_one_line() const {
  return fmt::format("{}: {}\n", name_, in_braces());
}

std::string YamlBlock::on_many_lines() const {
  std::string text = name_.empty() ? "" : name_ + ":\n";
  const std::string_view indent = name_.empty() ? "" : "  ";
  for (const auto& [key, value] : entries_)
    text += fmt::format("{}{}: {}\n", indent, yaml_text(key), value);
  return text;
}

}  // namespace alltact
