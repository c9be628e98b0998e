// Numbers as people type them, in millimetres, and what each means to whoever types it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace alltact::test {

/// What a text means where the language writes a decimal point and where it writes a comma;
/// nullopt: it can mean two things, or none, and must be refused.
struct TypedExample {
  std::string text;
  std::optional<double> with_point, with_comma;
};

/// Over 200: the figures of a laboratory in every way in which keyboards, calipers, spreadsheets
/// and input methods of English, German and Chinese computers write them.
inline std::vector<TypedExample> typed_examples() {
  std::vector<TypedExample> all;
  const auto both = [&all](const std::string& text, double value) {
    all.push_back({text, value, value});
  };
  const auto neither = [&all](const std::string& text) {
    all.push_back({text, std::nullopt, std::nullopt});
  };
  // Written out by hand: whole part, digits behind the mark, value.
  const struct {
    const char *whole, *behind;
    double value;
  } plain[] = {{"4", "5", 4.5},       {"1", "6", 1.6},       {"3", "18", 3.18},
               {"0", "5", 0.5},       {"0", "05", 0.05},     {"1", "50", 1.5},
               {"24", "0", 24.0},     {"23", "75", 23.75},   {"12", "7", 12.7},
               {"0", "1234", 0.1234}, {"2", "0001", 2.0001}, {"7", "9375", 7.9375},
               {"15", "875", 15.875}, {"1234", "5", 1234.5}, {"9", "99", 9.99},
               {"0", "250", 0.25},    {"0", "125", 0.125},   {"1234", "567", 1234.567},
               {"00", "500", 0.5},    {"06", "350", 6.35}};
  for (const auto& [whole, behind, value] : plain) {
    const std::string w = whole, b = behind;
    const bool may_part_thousands = b.size() == 3 && w.size() <= 3 && w[0] != '0';
    const auto other = [&](double v) {
      return may_part_thousands ? std::nullopt : std::optional(v);
    };
    for (const char* unit : {"", " mm"}) {
      all.push_back({w + "." + b + unit, value, other(value)});
      all.push_back({w + "," + b + unit, other(value), value});
    }
    all.push_back({"-" + w + "." + b, -value, other(-value)});
    all.push_back({"−" + w + "," + b, other(-value), -value});
    all.push_back({" +" + w + "." + b + " ", value, other(value)});
  }
  // The case that was seen: a ball of an eighth of an inch.
  all.push_back({"3.175", 3.175, std::nullopt});
  all.push_back({"3,175", std::nullopt, 3.175});
  all.push_back({"4.500", 4.5, std::nullopt});
  all.push_back({"4,500", std::nullopt, 4.5});
  all.push_back({"45.000", 45.0, std::nullopt});
  all.push_back({"4，500", std::nullopt, 4.5});
  all.push_back({"4。500", 4.5, std::nullopt});
  both("4", 4);
  both("24", 24);
  both("1000", 1000);
  both("007", 7);
  both("4.", 4);
  both("4,", 4);
  both(".5", 0.5);
  both(",5", 0.5);
  both(",500", 0.5);
  both("1e-3", 0.001);
  both("1.5e1", 15);
  both("1,5E+1", 15);
  both("25e-2", 0.25);
  both("４", 4);
  both("４．５", 4.5);
  both("４，５", 4.5);
  both("4。5", 4.5);
  both("4｡5", 4.5);
  both("４。５ mm", 4.5);
  both("－４．５", -4.5);
  both("＋４．５", 4.5);
  both("–4.5", -4.5);
  both("\u00A04,5\u00A0", 4.5);
  both("\u20094.5\u202Fmm", 4.5);
  both("\uFEFF4.5", 4.5);
  both("4.5mm", 4.5);
  both("4,5 mm", 4.5);
  both("4.5\u00A0mm", 4.5);
  both("\t4.5", 4.5);
  for (const char* text : {"",
                           " ",
                           "-",
                           "+",
                           ".",
                           ",",
                           "mm",
                           "1.234,5",
                           "1,234.5",
                           "1.234.567",
                           "1,234,567",
                           "1'000",
                           "1’000",
                           "1 000",
                           "1\u00A0000",
                           "1\u202F234",
                           "1_000",
                           "12,345.678",
                           "4..5",
                           "4,,5",
                           "4.,5",
                           "4.5.6",
                           "4,5,6",
                           "4 5",
                           "4.5 5",
                           "1/2",
                           "4x5",
                           "4*5",
                           "=4.5",
                           "4:5",
                           "4;5",
                           "nan",
                           "NaN",
                           "inf",
                           "-inf",
                           "infinity",
                           "0x1f",
                           "0x1p3",
                           "1e999",
                           "-1e999",
                           "4.5 cm",
                           "4.5cm",
                           "4.5 MM",
                           "4.5 m",
                           "4.5 in",
                           "4.5\"",
                           "4.5 µm",
                           "4.5%",
                           "4.5 mm mm",
                           "four",
                           "vier",
                           "四",
                           "4,5 Millimeter",
                           "--4.5",
                           "+-4.5",
                           "4.5-",
                           "4-5",
                           "4.5+-0.1",
                           "(4.5)",
                           "~4.5",
                           "<4.5",
                           "4·5",
                           "4、5",
                           "٤٫٥",
                           "4'5",
                           "4e",
                           "4e+",
                           "e5",
                           "4.5e1.5",
                           "4.5 e1",
                           "1.5k",
                           "1.23 456",
                           "12 34",
                           "4.5\n5"})
    neither(text);
  return all;
}

}  // namespace alltact::test
