#include "core/base/fields.h"

#include "core/base/message.h"

#include <cmath>

namespace alltact {
namespace {

std::string yaml_texts(const std::vector<std::string>& texts) {
  std::vector<std::string> items;
  for (const std::string& text : texts) items.push_back(yaml_text(text));
  return yaml_list(items);
}

std::vector<double> pointed(std::initializer_list<double*> values) {
  std::vector<double> all;
  for (const double* value : values) all.push_back(*value);
  return all;
}

std::string in_layout(const YamlBlock& block, Fields::Layout layout) {
  return layout == Fields::Layout::kLines ? block.on_lines("  ") : block.in_braces();
}

}  // namespace

bool Fields::has(const FieldKey& key) {
  if (!is_reading()) return key.is_written;
  if (key.is_required) return true;
  const bool is_there = section_->has(key.name);
  found_ += is_there ? 1 : 0;
  return is_there;
}

void Fields::demand(bool holds, const std::string& key, const Message& what,
                    const Message& advice) const {
  if (is_reading() && !holds) section_->refuse(key, what, advice);
}

void Fields::add(const FieldKey& key, std::string value) {
  block_->add(key.name, std::move(value));
}

void Fields::format(const char* format, const Message& advice) {
  if (!is_reading()) return add("format", format);
  const std::string given = section_->text("format");
  demand(given == format, "format",
         en::say("'{}' cannot be read by this version", printable(given)), advice);
}

void Fields::number(const FieldKey& key, double& value, const Message& meaning) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, yaml_number(value));
  value = section_->number(key.name, meaning);
}

void Fields::number(const FieldKey& key, double& value, Limits limits) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, yaml_number(value));
  value = section_->number(key.name, limits);
}

void Fields::integer(const FieldKey& key, int& value, int low, int high) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, fmt::format("{}", value));
  value = section_->integer(key.name, low, high);
}

void Fields::choose(const FieldKey& key, std::size_t& index, const EnumWords& words) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, std::string(words.at(index)));
  index = section_->choice(key.name, words);
}

void Fields::flag(const FieldKey& key, bool& value) {
  std::size_t index = value ? 1 : 0;
  choose(key, index, {"false", "true"});
  value = index == 1;
}

void Fields::text(const FieldKey& key, std::string& value) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, yaml_text(value));
  value = section_->text(key.name);
}

void Fields::text_or_number(const FieldKey& key, std::string& value) {
  if (!is_reading()) return add(key, yaml_text_or_number(value));
  text(key, value);
}

void Fields::quoted(const FieldKey& key, std::string& value) {
  if (!is_reading()) return add(key, '"' + value + '"');
  text(key, value);
}

void Fields::quoted(const FieldKey& key, std::vector<std::string>& values) {
  if (is_reading()) return texts(key, values);
  std::vector<std::string> items;
  for (const std::string& value : values) items.push_back('"' + value + '"');
  add(key, yaml_list(items));
}

void Fields::texts(const FieldKey& key, std::vector<std::string>& values) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, yaml_texts(values));
  values = section_->texts(key.name);
}

void Fields::numbers(const FieldKey& key, std::vector<double>& values, Limits limits) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, yaml_numbers(values));
  values = section_->numbers(key.name, limits);
}

void Fields::numbers(const FieldKey& key, std::initializer_list<double*> values, Limits limits) {
  std::vector<double> all = pointed(values);
  if (!is_reading()) return numbers(key, all);
  if (!has(key)) return;
  all = section_->numbers(key.name, values.size(), values.size(), limits);
  for (std::size_t i = 0; i < all.size(); ++i) *values.begin()[i] = all[i];
}

void Fields::numbers(const FieldKey& key, std::initializer_list<double*> values,
                     const Message& what, const Message& advice) {
  std::vector<double> all = pointed(values);
  numbers(key, all);
  demand(all.size() == values.size(), key.name, what, advice);
  for (std::size_t i = 0; i < all.size(); ++i) *values.begin()[i] = all[i];
}

void Fields::integers(const FieldKey& key, std::vector<int>& values, int limit,
                      std::optional<std::size_t> count, const Message& what,
                      const Message& advice) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, fmt::format("[{}]", fmt::join(values, ", ")));
  const std::vector<double> all = section_->numbers(key.name);
  demand(all.size() == count.value_or(all.size()), key.name, what, advice);
  values.clear();
  for (const double value : all) {
    demand(value == std::floor(value) && std::abs(value) <= limit, key.name, what, advice);
    values.push_back(static_cast<int>(value));
  }
}

void Fields::integers(const FieldKey& key, std::span<int> values, Limits limits) {
  if (!has(key)) return;
  if (!is_reading()) return add(key, fmt::format("[{}]", fmt::join(values, ", ")));
  const auto all = section_->numbers(key.name, values.size(), values.size(), limits);
  for (std::size_t i = 0; i < all.size(); ++i) values[i] = static_cast<int>(all[i]);
}

void Fields::rows(const FieldKey& key, std::vector<std::vector<double>>& values, Limits limits) {
  if (!has(key)) return;
  if (is_reading()) {
    values = section_->rows(key.name, limits);
    return;
  }
  std::vector<std::string> texts;
  for (const std::vector<double>& row : values) texts.push_back(yaml_numbers(row));
  add(key, yaml_list(texts));
}

void Fields::texts_by_name(const std::string& key, std::map<std::string, std::string>& values,
                           Layout layout) {
  if (is_reading()) {
    if (section_->has(key)) values = section_->section(key).all_texts();
    return;
  }
  YamlBlock block(block_->full_name(key));
  for (const auto& [name, value] : values) block.add(name, yaml_text_or_number(value));
  block.add_unknown(*unknown_);
  if (!block.is_empty()) add(key, in_layout(block, layout));
}

void Fields::section(const FieldKey& key, Layout layout, const Describe& describe) {
  if (!has(key)) return;
  if (is_reading()) {
    Fields inner(section_->section(key.name));
    return describe(inner);
  }
  YamlBlock block(block_->full_name(key.name));
  Fields inner(block, *unknown_);
  describe(inner);
  inner.unknown_keys();
  add(key, in_layout(block, layout));
}

void Fields::sections(const FieldKey& key, Layout layout, std::size_t count,
                      const std::function<void(std::size_t)>& resize,
                      const std::function<void(Fields&, std::size_t)>& describe) {
  if (!has(key)) return;
  if (is_reading()) {
    const std::vector<YamlSection> all = section_->sections(key.name);
    resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      Fields item(all[i]);
      describe(item, i);
    }
    return;
  }
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    YamlBlock block(fmt::format("{}[{}]", block_->full_name(key.name), i));
    Fields item(block, *unknown_);
    describe(item, i);
    item.unknown_keys();
    text += "\n  - " +
            (layout == Layout::kLines ? block.on_lines("    ").substr(5) : block.in_braces());
  }
  add(key, text);
}

void Fields::unknown_keys() const {
  if (!is_reading()) block_->add_unknown(*unknown_);
}

}  // namespace alltact
