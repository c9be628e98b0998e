// One description of a stored struct, from which it is read and written.
#pragma once

#include "core/base/yaml.h"

#include <array>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alltact {

/// A key and its presence. A plain text is a key that the file must have.
struct FieldKey {
  FieldKey(const char* key) : name(key) {}             // NOLINT(google-explicit-constructor)
  FieldKey(std::string key) : name(std::move(key)) {}  // NOLINT(google-explicit-constructor)
  [[nodiscard]] FieldKey required_if(bool holds) && {
    is_required = holds;
    return std::move(*this);
  }
  std::string name;
  bool is_required = true;  ///< else the value stays as it is where the file lacks the key
  bool is_written = true;
};
/// A key that the file may lack. `is_written`: false where the value is not worth a line.
inline FieldKey may(std::string key, bool is_written = true) {
  FieldKey made = std::move(key);
  made.is_required = false;
  made.is_written = is_written;
  return made;
}

/// Words of an enum that counts from 1, in its order.
using EnumWords = std::vector<std::string_view>;
/// Those of to_string(), up to the enumerator `last`.
template <class E>
EnumWords words_up_to(E last) {
  EnumWords words;
  for (int value = 1; value <= static_cast<int>(last); ++value)
    words.push_back(to_string(static_cast<E>(value)));
  return words;
}

/// The keys of a struct, in the order of its file. `describe(Fields&, T&)` names each key once with
/// its limits and its presence; the same call reads the struct from a YamlSection or writes it to a
/// YamlBlock. Reading ends at the first wrong value, as YamlSection does; writing checks nothing
/// and changes nothing.
class Fields {
 public:
  /// Form of a section in the file.
  enum class Layout { kBraces = 1, kLines };

  explicit Fields(YamlSection section) : section_(std::move(section)) {}
  /// Writes; `unknown` are the unknown keys of the file, retained in their sections.
  Fields(YamlBlock& block, const UnknownKeys& unknown) : block_(&block), unknown_(&unknown) {}

  [[nodiscard]] bool is_reading() const { return section_.has_value(); }
  /// True where the key is to be read or written.
  [[nodiscard]] bool has(const FieldKey& key);
  /// The same for a value that may be absent, which has no key then.
  template <class T>
  [[nodiscard]] bool has(FieldKey key, std::optional<T>& value) {
    key.is_written = value.has_value();
    const bool is_present = has(key);
    if (is_present && !value) value.emplace();
    return is_present;
  }
  /// Reading: keys that may be absent, and are there.
  [[nodiscard]] int found() const { return found_; }
  /// The section that is read.
  [[nodiscard]] YamlSection& section() { return *section_; }
  /// Reading: as YamlSection::refuse(), unless `holds`.
  void demand(bool holds, const std::string& key, const Message& what, const Message& advice) const;

  /// The key `format`; another one is refused.
  void format(const char* format, const Message& advice);
  /// `meaning`: the number's meaning, for the message ("a length in mm").
  void number(const FieldKey& key, double& value, const Message& meaning);
  void number(const FieldKey& key, double& value, Limits limits);
  void integer(const FieldKey& key, int& value, int low, int high);
  void flag(const FieldKey& key, bool& value);
  void text(const FieldKey& key, std::string& value);
  /// Without quotes, though it may look like a number.
  void text_or_number(const FieldKey& key, std::string& value);
  /// In quotes, though it may look like a word.
  void quoted(const FieldKey& key, std::string& value);
  void quoted(const FieldKey& key, std::vector<std::string>& values);
  void texts(const FieldKey& key, std::vector<std::string>& values);
  void numbers(const FieldKey& key, std::vector<double>& values, Limits limits = kAnyNumber);
  /// As many numbers as there are values.
  void numbers(const FieldKey& key, std::initializer_list<double*> values, Limits limits);
  /// A wrong count is refused with `what` and `advice`.
  void numbers(const FieldKey& key, std::initializer_list<double*> values, const Message& what,
               const Message& advice = "");
  /// From -limit to limit; others, and a `count` other than this, are refused with `what`.
  void integers(const FieldKey& key, std::vector<int>& values, int limit,
                std::optional<std::size_t> count, const Message& what, const Message& advice);
  /// As many as there are values.
  void integers(const FieldKey& key, std::span<int> values, Limits limits);
  void rows(const FieldKey& key, std::vector<std::vector<double>>& values,
            Limits limits = kAnyNumber);
  /// A row of numbers for each value; `numbers_of` returns an array of pointers to them.
  template <class T, class NumbersOf>
  void rows(const FieldKey& key, std::vector<T>& values, const NumbersOf& numbers_of, Limits limits,
            const Message& what, const Message& advice = "") {
    std::vector<std::vector<double>> table;
    for (T& value : values)
      for (auto& row = table.emplace_back(); const double* number : numbers_of(value))
        row.push_back(*number);
    rows(key, table, limits);
    values.resize(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
      const auto numbers = numbers_of(values[i]);
      demand(table[i].size() == numbers.size(), key.name, what, advice);
      for (std::size_t k = 0; k < numbers.size(); ++k) *numbers[k] = table[i][k];
    }
  }
  template <class E>
  void choice(const FieldKey& key, E& value, const EnumWords& words) {
    auto index = static_cast<std::size_t>(value) - 1;
    choose(key, index, words);
    value = static_cast<E>(index + 1);
  }
  /// A section whose keys are names; absent where it is empty.
  void texts_by_name(const std::string& key, std::map<std::string, std::string>& values,
                     Layout layout = Layout::kBraces);

  using Describe = std::function<void(Fields&)>;
  void section(const FieldKey& key, Layout layout, const Describe& describe);
  template <class T>
  void section(const FieldKey& key, T& value, Layout layout = Layout::kBraces) {
    section(key, layout, [&](Fields& inner) { describe(inner, value); });
  }
  template <class T>
  void section(const FieldKey& key, std::optional<T>& value, Layout layout = Layout::kBraces) {
    if (has(key, value)) section(key, *value, layout);
  }
  /// A list of sections: `count` to be written; `resize` receives the number of those read.
  void sections(const FieldKey& key, Layout layout, std::size_t count,
                const std::function<void(std::size_t count)>& resize,
                const std::function<void(Fields&, std::size_t number)>& describe);
  template <class T>
  void sections(const FieldKey& key, std::vector<T>& values, Layout layout = Layout::kBraces) {
    sections(
        key, layout, values.size(), [&](std::size_t count) { values.resize(count); },
        [&](Fields& item, std::size_t number) { describe(item, values[number]); });
  }
  /// Writes the unknown keys of this section here instead of at its end.
  void unknown_keys() const;

 private:
  void choose(const FieldKey& key, std::size_t& index, const EnumWords& words);
  void add(const FieldKey& key, std::string value);

  std::optional<YamlSection> section_;
  int found_ = 0;
  YamlBlock* block_ = nullptr;
  const UnknownKeys* unknown_ = nullptr;
};

/// The value that describe() reads from the file's text.
template <class T>
[[nodiscard]] Result<T> read_fields(YamlFile& file, const std::string& yaml) {
  T value;
  const Status read = file.read(yaml, [&](YamlSection& top) {
    Fields fields(top);
    describe(fields, value);
  });
  if (!read) return read.error();
  return value;
}

/// The text that describe() writes.
template <class T>
[[nodiscard]] std::string fields_text(T value, const UnknownKeys& unknown = {}) {
  YamlBlock block("");
  Fields fields(block, unknown);
  describe(fields, value);
  fields.unknown_keys();
  return block.on_many_lines();
}

}  // namespace alltact
