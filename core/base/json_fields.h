// One description of a struct that is stored as JSON, from which it is read and written.
#pragma once

#include "core/base/message.h"

#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace alltact {

/// Ends the reading at a wrong value. nlohmann's exceptions do so, too.
struct RefusedJson : std::exception {
  RefusedJson(std::string at, Message why) : path(std::move(at)), what_is_wrong(std::move(why)) {}
  [[nodiscard]] const char* what() const noexcept override { return path.c_str(); }
  std::string path;  ///< "members[0].scale"
  Message what_is_wrong;
};

/// A value of a JSON file, as Fields is a section of a YAML file: `describe(JsonFields&, T&)` names
/// each key of an object once. Callers catch the exceptions of reading.
class JsonFields {
 public:
  using Json = nlohmann::ordered_json;
  struct Rules {
    std::string root = {};  ///< name of the file, for a missing key
    double largest = std::numeric_limits<double>::infinity();  ///< numbers are smaller
    bool null_is_nan = false;  ///< numbers that are not finite are written as null
  };

  JsonFields(const Json& json, Rules rules, std::string path = "")
      : in_(&json), rules_(std::move(rules)), path_(std::move(path)) {}
  explicit JsonFields(Json& json) : out_(&json) {}

  [[nodiscard]] bool is_reading() const { return in_ != nullptr; }
  /// The value that is read.
  [[nodiscard]] const Json& json() const { return *in_; }
  [[noreturn]] void refuse(Message what) const { throw RefusedJson(path_, std::move(what)); }

  template <class T>
  void field(const std::string& key, T& value) {
    child(key).value(value);
  }
  /// Absent where there is no value.
  template <class T>
  void field(const std::string& key, std::optional<T>& value) {
    if (is_reading() ? !in_->contains(key) : !value) return;
    field(key, value ? *value : value.emplace());
  }
  template <class Describe>
  void section(const std::string& key, const Describe& describe_section) {
    JsonFields inner = child(key);
    describe_section(inner);
  }

  /// T: a number, a flag, a text, a matrix of fixed size column by column, described itself, or a
  /// list of these.
  template <class T>
  void value(T& value) {
    if constexpr (requires { describe(*this, value); }) {
      if (!is_reading()) *out_ = Json::object();
      describe(*this, value);
    } else if constexpr (requires { value.reshaped(); }) {
      numbers(value);
    } else if (is_reading()) {
      read(value);
    } else {
      *out_ = value;
    }
  }
  template <class T>
  void value(std::vector<T>& values) {
    if (!is_reading()) {
      *out_ = Json::array();
      for (T& item : values) JsonFields(out_->emplace_back()).value(item);
      return;
    }
    if (!in_->is_array()) refuse(en::say("is not a list"));
    const bool is_outer = path_.find('[') == std::string::npos;  // its items have numbers
    for (const Json& item : *in_) {
      const std::string number =
          is_outer && item.is_object() ? fmt::format("[{}]", values.size()) : "";
      JsonFields(item, rules_, path_ + number).value(values.emplace_back());
    }
  }

 private:
  [[nodiscard]] JsonFields child(const std::string& key) const {
    if (!is_reading()) return JsonFields((*out_)[key]);
    const std::string& name = path_.empty() ? rules_.root : path_;
    if (!in_->is_object()) throw RefusedJson(name, en::say("is not an object"));
    const auto found = in_->find(key);
    if (found == in_->end()) throw RefusedJson(name + "." + key, en::say("is missing"));
    return {*found, rules_, path_.empty() ? key : path_ + "." + key};
  }

  template <class Matrix>
  void numbers(Matrix& matrix) {
    std::vector<double> all(matrix.reshaped().begin(), matrix.reshaped().end());
    const std::size_t size = all.size();
    if (is_reading()) all.clear();
    value(all);
    if (all.size() < size) refuse(en::say("is missing"));
    std::copy_n(all.begin(), size, matrix.reshaped().begin());
  }

  template <class T>
  void read(T& value) const {
    if constexpr (std::is_same_v<T, bool>) {
      if (!in_->is_boolean()) refuse(en::say("is not true or false"));
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
      if (std::is_same_v<T, double> && in_->is_null() && rules_.null_is_nan) {
        value = std::numeric_limits<T>::quiet_NaN();
        return;
      }
      if (!in_->is_number()) refuse(en::say("is not a number"));
      const double number = in_->get<double>();
      if (!(std::abs(number) < rules_.largest)) refuse(en::say("is not a valid number"));
      if (std::is_same_v<T, int> && (number != std::floor(number) || std::abs(number) > 1e9))
        refuse(en::say("is not an integer"));
    }
    value = in_->get<T>();
  }

  const Json* in_ = nullptr;
  Json* out_ = nullptr;
  Rules rules_;
  std::string path_;  // empty for the entire file
};

/// What describe() writes.
template <class T>
[[nodiscard]] JsonFields::Json written_json(T value) {
  JsonFields::Json json;
  JsonFields fields(json);
  describe(fields, value);
  return json;
}

}  // namespace alltact
