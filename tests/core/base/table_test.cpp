// Tables as other programs write them: what is read, bit for bit, and what is refused by its line.
#include "core/base/table.h"

#include "tests/support/locales.h"

#include <array>
#include <bit>
#include <clocale>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iconv.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

TableFormat forces() {
  return {
      {{"t_s", Measure::kTime, {"time", "zeit", "zaman", "temps", "xvalue", "时间", "timestamp"}},
       {"date", {}, {"datum"}},
       {.key = "fx_n",
        .measure = Measure::kForce,
        .names = {"kraftx", "forcex", "力"},
        .names_with_unit = {"x"}},
       {"fy_n", Measure::kForce, {"krafty", "forcey"}},
       {"block"}},
      en::say("a table with t_s")};
}

/// The bytes of a text in another encoding, by glibc.
std::string encoded(std::string text, const char* encoding) {
  const iconv_t converter = iconv_open(encoding, "UTF-8");
  std::string bytes(4 * text.size() + 8, '\0');
  char *from = text.data(), *to = bytes.data();
  std::size_t left = text.size(), room = bytes.size();
  EXPECT_NE(iconv(converter, &from, &left, &to, &room), static_cast<std::size_t>(-1)) << encoding;
  iconv_close(converter);
  bytes.resize(bytes.size() - room);
  return bytes;
}

struct Rows {
  std::vector<std::vector<double>> numbers;  ///< t, fx, fy, as far as there are columns
  std::string understood, refusal;
  std::vector<Message> remarks;
};

Rows rows_of(std::string_view bytes) {
  Rows rows;
  auto table = Table::open(bytes, "a.csv", forces());
  if (!table) {
    rows.refusal = table.error().sentence();
    return rows;
  }
  const int time = table->find("t_s"), date = table->find("date");
  for (auto more = table->next();; more = table->next()) {
    if (!more) rows.refusal = more.error().sentence();
    if (!more || !*more) break;
    std::vector<double> row;
    const auto add = [&](const Result<double>& number) {
      if (number) return row.push_back(*number);
      if (rows.refusal.empty()) rows.refusal = number.error().sentence();
    };
    if (time >= 0) add(table->time_s(time, date));
    for (const char* key : {"fx_n", "fy_n"})
      if (const int column = table->find(key); column >= 0) add(table->number(column));
    if (!rows.refusal.empty()) break;
    rows.numbers.push_back(std::move(row));
  }
  rows.understood = table->understood().english();
  rows.remarks = table->remarks();
  return rows;
}

using Numbers = std::vector<std::vector<double>>;

TEST(Table, IsReadAsEveryProgramWritesIt) {
  const Numbers both{{0, 0.5, -2}, {0.01, 1.25, 3}};
  struct Example {
    const char* program;
    std::string bytes;
    Numbers numbers;
    const char* understood;
  };
  const std::vector<Example> examples{
      {"ours", "t_s,fx_n,fy_n\n0,0.5,-2\n0.01,1.25,3\n", both, "comma-separated: t_s, fx_n, fy_n"},
      {"Excel, German", "\xEF\xBB\xBFt_s;fx_n;fy_n\r\n0;0,5;-2\r\n0,01;1,25;3\r\n", both,
       "semicolon-separated with decimal commas"},
      {"Excel, German, 1252",
       encoded("Zeit [ms];Kraft X [N];Krafty;Größe\r\n0;0,5;-2;ä\r\n"
               "10;1,25;3;\r\n",
               "WINDOWS-1252"),
       both,
       "Windows-1252 semicolon-separated with decimal commas: t_s from 'Zeit [ms]' in ms, fx_n "
       "from 'Kraft X [N]' in N, fy_n from 'Krafty'"},
      {"Excel, Turkish",
       encoded("Zaman (sn);Fx (N);Fy (N);Ölçüm\r\n0;0,5;-2;ğ\r\n0,01;1,25;3;ş\r\n", "WINDOWS-1254"),
       both, "t_s from 'Zaman (sn)' in s"},
      {"Excel, French", "Temps (s);Fx;Fy\r\n0;0,5;-2\r\n0,01;1,25;3\r\n", both, "decimal commas"},
      {"Excel, Chinese", encoded("时间(毫秒),力(N),Fy\r\n0,0.5,-2\r\n10,1.25,3\r\n", "GB18030"),
       both, "GB18030 comma-separated: t_s from '时间(毫秒)' in ms"},
      {"Excel, Unicode text",
       "\xFF\xFE" + encoded("t_s\tfx_n\tfy_n\r\n0\t0,5\t-2\r\n0,01\t1,25\t3\r\n", "UTF-16LE"), both,
       "UTF-16 tab-separated with decimal commas"},
      {"Excel, for itself", "sep=;\r\nt_s;fx_n;fy_n\r\n0;0.5;-2\r\n0.01;1.25;3\r\n", both,
       "semicolon-separated: "},
      {"Excel, empty columns and lines",
       "t_s;fx_n;fy_n;;\r\n0;0,5;-2;;\r\n;;;;\r\n0,01;1,25;3;;\r\n", both, "semicolon"},
      {"LibreOffice", "\"t_s\",\"fx_n\",\"fy_n\"\n0,\"0,5\",-2\n\"0,01\",\"1,25\",3\n", both,
       "comma-separated with decimal commas"},
      {"LibreOffice, quotes and line breaks",
       "t_s,\"fx\n[N]\",\"he said \"\"N\"\"\",fy_n\n0,0.5,\"a\nb, c\",-2\n0.01,1.25,,3\n", both,
       "comma-separated"},
      {"Matlab", "t_s,fx_n,fy_n\n0,0.5,-2\n0.01,1.25,3\n", both, "comma"},
      {"pandas", "Unnamed: 0,t_s,fx_n,fy_n\n0,0.0,0.5,-2.0\n1,0.01,1.25,3.0\n", both, "comma"},
      {"numpy", "# t_s fx_n fy_n\n0.0e+00 5.0e-01 -2.0e+00\n1.0e-02 1.25e+00 3.0e+00\n", both,
       "blank-separated"},
      {"gnuplot", "# a remark\n  t_s   fx_n  fy_n\n  0      0.5    -2\n\n  0.01   1.25    3\n",
       both, "blank-separated"},
      {"fixed columns",
       "Time (s)  Force X (N)  Force Y (N)\n0.00      0.5   -2\n0.01      1.25  3\n", both,
       "blank-separated: t_s from 'Time (s)' in s"},
      {"LabVIEW",
       "LabVIEW Measurement\t\r\nWriter_Version\t2\r\nDate\t2026/03/01\r\nTime\t12:00:00,5\r\n"
       "***End_of_Header***\t\r\n\t\r\nX_Value\tforce_x\tforce_y\tComment\r\n0,000000\t0,500000\t"
       "-2,000000\r\n0,010000\t1,250000\t3,000000\r\n",
       both, "tab-separated with decimal commas: t_s from 'X_Value'"},
      {"units below", "Time\tForce X\tForce Y\n[ms]\t[mN]\t[N]\n0\t500\t-2\n10\t1250\t3\n", both,
       "t_s from 'Time' in ms, fx_n from 'Force X' in mN"},
      {"units in other forms", "Time/ms;X in N;fy, N\n0;0.5;-2\n10;1.25;3\n", both,
       "fy_n from 'fy, N' in N"},
      {"old Macintosh", "t_s,fx_n,fy_n\r0,0.5,-2\r0.01,1.25,3\r", both, "comma"},
      {"bars", "t_s|fx_n|fy_n\n0|0.5|-2\n0.01|1.25|3\n", both, "separated by '|'"},
      {"date and time",
       "Date,Time,fx_n,fy_n\n01.03.2026,12:00:00.5,0.5,-2\n01.03.2026,12:00:01,1.25,3\n",
       {{1772366400.5, 0.5, -2}, {1772366401, 1.25, 3}},
       "t_s from the time stamps of 'Time'"},
      {"milliseconds since 1970",
       "timestamp,fx_n,fy_n\n1772366400500,0.5,-2\n1772366401000,1.25,3\n",
       {{1772366400.5, 0.5, -2}, {1772366401, 1.25, 3}},
       "'timestamp' in ms since 1970"},
  };
  for (const Example& example : examples) {
    SCOPED_TRACE(example.program);
    const Rows rows = rows_of(example.bytes);
    EXPECT_EQ(rows.refusal, "");
    EXPECT_EQ(rows.numbers, example.numbers);
    EXPECT_THAT(rows.understood, HasSubstr(example.understood));
    EXPECT_TRUE(rows.remarks.empty());
  }
}

TEST(Table, RefusesWithLineWhatCannotBeRead) {
  const std::string head = "t_s,fx_n,fy_n\n0.1,1.25,2.25\n";
  struct Example {
    const char* kind;
    std::string bytes;
    const char* sentence;
  };
  const std::vector<Example> examples{
      {"nothing", "", "a.csv: the table is empty"},
      {"only remarks", "\n# t\n# u\n", ""},
      {"a workbook", "PK\x03\x04zip", "a workbook of a spreadsheet program"},
      {"an old workbook", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "a workbook"},
      {"no names", "0.1,2,3\n0.2,3,4\n", "a.csv, line 1: there are numbers where the names"},
      {"two times", "time;Zeit [ms];fx_n\n1;2;3\n", "'time' and 'Zeit [ms]' both fit t_s"},
      {"the same name", "t_s,fx_n,fx_n\n1,2,3\n", "line 1: the column 'fx_n' appears twice"},
      {"another unit", "t_s,fx_mm,fy_n\n1,2,3\n", "'mm' is not a unit of the column 'fx_mm'"},
      {"meganewtons", "t_s,Fx [MN],fy_n\n1,2,3\n", "'MN' is not a unit"},
      {"two units", "t [s];fx_n;fy_n\nms;N;N\n1;2;3\n", "line 2: the column 't [s]' is in ms here"},
      {"another unit below", "t;fx_n;fy_n\ns;mm;N\n1;2;3\n", "line 2: 'mm' is not a unit"},
      {"a missing cell", head + "0.2,1.5\n", "a.csv, line 3: has 2 cells, not 3"},
      {"a cell too many", head + "0.2,1.5,2,7\n", "line 3: has 4 cells, not 3"},
      {"decimal commas between commas", "t_s,fx_n,fy_n\n0,1,1,25,2,25\n",
       "decimal points, or semi"},
      {"text", head + "0.2,five,2\n", "a.csv, line 3, column fx_n: 'five' is not a number"},
      {"no number", head + "0.2,nan,2\n", "'nan' is not a number"},
      {"infinity", head + "0.2,-inf,2\n", "'-inf' is not a number"},
      {"a spreadsheet's error", head + "#DIV/0!,1,2\n", "'#DIV/0!' is not a number"},
      {"an empty cell", head + "0.2,,2\n", "column fx_n: a number is missing"},
      {"too large", head + "0.2,1e999,2\n", "too large or too small"},
      {"thousands", head + "0.2,\"1,234.5\",2\n", "a thousands separator: write 1234.5"},
      {"thousands or not", "t_s;fx_n;fy_n\n1;1,250;2\n", "'1,250' can mean 1.25 or 1250"},
      {"German thousands", "t_s;fx_n;fy_n\n0,5;1.250;2\n", "'1.250' can mean 1.25 or 1250"},
      {"both marks", "t_s;fx_n;fy_n\n0,5;1;2\n0.75;1;2\n",
       "line 3, column t_s: '0.75' has another"},
      {"an open quote", head + "0.2,\"1,2\n0.3,1,2\n", "line 3: a quotation mark is not closed"},
      {"text behind a quote", head + "0.2,\"1\"5,2\n", "line 3: there is text behind a closing"},
      {"a second head", head + "t_s,fx_n,fy_n\n0.2,1,2\n", "line 3, column t_s: 't_s' is not a"},
      {"cut in a row", head + "0.2,1.2", "line 3: the file ends in the middle of this line"},
      {"cut in a number", head + "1,1,2.25\n2,1,2.25\n3,1,2.75\n4,1,2.50\n5,1,2.5",
       "line 7: the file ends in the middle of this line. Try: copying the file again"},
      {"cut in a character", "\xFF\xFEt\0_\0s", "in the middle of a character"},
      {"zeros of a lost file", head + std::string(40, '\0'), "a.csv, line 3: holds a zero byte"},
      {"hours or minutes", "t,fx_n,fy_n\n12:30,1,2\n", "'12:30' can be hours and minutes"},
      {"no such day", "t,fx_n,fy_n\n2026-02-30 12:00:00,1,2\n",
       "is not a date or time that exists"},
      {"day or month", "t,fx_n,fy_n\n03/01/2026 23:59:59,1,2\n04/01/2026 00:00:00,1,2\n",
       "'04/01/2026' can have the day or the month first"},
      {"another form", "t,fx_n,fy_n\n12:00:00,1,2\n0.5,1,2\n", "'0.5' is a time of another form"},
  };
  for (const Example& example : examples) {
    SCOPED_TRACE(example.kind);
    const Rows rows = rows_of(example.bytes);
    if (std::string_view(example.sentence).empty()) {
      EXPECT_TRUE(rows.numbers.empty());
    } else {
      EXPECT_THAT(rows.refusal, HasSubstr(example.sentence));
    }
  }
}

TEST(Table, RemarksThatItsLastLineHasNoEnd) {
  const Rows rows = rows_of("t_s,fx_n,fy_n\n1,2,3\n2,3,4");
  EXPECT_EQ(rows.numbers.size(), 2U);
  ASSERT_EQ(rows.remarks.size(), 1U);
  EXPECT_THAT(rows.remarks[0].english(), HasSubstr("a.csv (line 3) has no line end"));
}

TEST(Table, ListsTheColumnsItFound) {
  const auto table = Table::open("Zeit;Druck\n1;2\n", "a.csv", forces());
  ASSERT_TRUE(table);
  EXPECT_EQ(
      table->missing("fx_n").sentence(),
      "a.csv, line 1: the column 'fx_n' is missing; found: 'Zeit', 'Druck'. Try: a table with "
      "t_s.");
}

TEST(Table, CellsInQuotesComeBack) {
  for (const char* text :
       {"plain", "a, b", "\"", "a\"\"b", "# no remark", "% 5", "a\nb", "#DIV/0!"}) {
    const std::string csv = fmt::format("block,t_s,fx_n\n{},1,2\n", table_cell(text));
    auto table = Table::open(csv, "a.csv", forces());
    ASSERT_TRUE(table) << csv;
    const auto more = table->next();
    ASSERT_TRUE(more && *more) << csv;
    EXPECT_EQ(table->text(table->find("block")), text);
  }
}

/// Numbers of every magnitude, in the shortest form that identifies them.
std::vector<double> some_numbers(std::mt19937_64& random, std::size_t count) {
  std::vector<double> numbers;
  while (numbers.size() < count) {
    const double any = std::bit_cast<double>(random());
    const double typical =
        1e-4 * static_cast<double>(static_cast<int>(random() % 2000001) - 1000000);
    const double number = numbers.size() % 3 == 0 ? any : typical;
    if (std::isnormal(number) || number == 0) numbers.push_back(number);
  }
  return numbers;
}

struct Form {
  const char* encoding;
  std::string_view mark;  ///< byte order mark
  std::string_view separator, line_end;
  char decimal;
};

std::string written(const std::vector<double>& numbers, const Form& form) {
  const auto cell = [&](double number) {
    std::string text = fmt::format("{}", number);
    std::replace(text.begin(), text.end(), '.', form.decimal);
    const bool is_quoted = form.separator == "," && text.find(',') != std::string::npos;
    return is_quoted ? '"' + text + '"' : text;
  };
  std::string text = fmt::format("t_s{0}fx_n{0}fy_n{0}Größe{1}", form.separator, form.line_end);
  // The first row has a number that separates no thousands.
  text += fmt::format("{0}{1}{0}{1}{0}{1}0{2}", cell(0.5), form.separator, form.line_end);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    text += fmt::format("{1}{0}{2}{0}{3}{0}1{4}", form.separator, cell(numbers[i]),
                        cell(numbers[i + 1]), cell(numbers[i + 2]), form.line_end);
  return std::string(form.mark) + encoded(text, form.encoding);
}

class TableInLocale : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!is_made(GetParam())) GTEST_SKIP() << "localedef makes no locale " << GetParam();
    std::setlocale(LC_ALL, GetParam());
  }
  void TearDown() override { std::setlocale(LC_ALL, "C"); }
};

TEST_P(TableInLocale, EveryFormHoldsTheSameNumbersBitForBit) {
  using namespace std::string_view_literals;
  std::mt19937_64 random(7);
  int forms = 0;
  for (const auto& [encoding, mark] : {std::pair{"UTF-8", ""sv},
                                       {"UTF-8", "\xEF\xBB\xBF"sv},
                                       {"UTF-16LE", "\xFF\xFE"sv},
                                       {"UTF-16LE", ""sv},
                                       {"UTF-16BE", "\xFE\xFF"sv},
                                       {"UTF-16BE", ""sv},
                                       {"ISO-8859-1", ""sv},
                                       {"WINDOWS-1252", ""sv}})
    for (const auto separator : {","sv, ";"sv, "\t"sv, "|"sv, " "sv, "   "sv})
      for (const auto line_end : {"\n"sv, "\r\n"sv, "\r"sv})
        for (const char decimal : {'.', ','}) {
          const Form form{encoding, mark, separator, line_end, decimal};
          const auto numbers = some_numbers(random, 60);
          const Rows rows = rows_of(written(numbers, form));
          SCOPED_TRACE(fmt::format("{} '{}' {} {}", encoding, separator, line_end.size(), decimal));
          ASSERT_EQ(rows.refusal, "");
          ASSERT_EQ(rows.numbers.size(), 21U);
          for (std::size_t i = 0; i < numbers.size(); ++i)
            ASSERT_EQ(std::bit_cast<std::uint64_t>(rows.numbers[1 + i / 3][i % 3]),
                      std::bit_cast<std::uint64_t>(numbers[i]));
          ++forms;
        }
  EXPECT_EQ(forms, 8 * 6 * 3 * 2);
}

INSTANTIATE_TEST_SUITE_P(Each, TableInLocale,
                         testing::Values("C", "de_DE.UTF-8", "tr_TR.UTF-8", "zh_CN.UTF-8"));

}  // namespace
}  // namespace alltact::test
