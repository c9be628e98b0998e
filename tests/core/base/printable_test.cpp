#include "core/base/message.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace alltact {
namespace {

TEST(Printable, LeavesPlainTextAloneInEveryLanguage) {
  for (const char* text : {"", "fin_ray", "24.0 mm", "Größe", "标记点", "😀"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, WritesOutWhatATerminalWouldObey) {
  EXPECT_EQ(printable("a\nb\tc\rd"), "a\\nb\\tc\\x0dd");
  EXPECT_EQ(printable("\x1b[2J\x7f"), "\\x1b[2J\\x7f");
  EXPECT_EQ(printable(std::string_view("\0x", 2)), "\\x00x");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b") << "U+009B begins a command, too";
}

TEST(Printable, WritesOutWhatIsNoUtf8) {
  for (const auto& [bytes, shown] : {std::pair{"\xff", "\\xff"},
                                     {"\xc3", "\\xc3"},
                                     {"\xc0\xaf", "\\xc0\\xaf"},
                                     {"\xed\xa0\x80", "\\xed\\xa0\\x80"},
                                     {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},
                                     {"\xe2\x82", "\\xe2\\x82"}})
    EXPECT_EQ(printable(bytes), shown);
}

TEST(Printable, CutsAtSixtyCharactersNotBytes) {
  EXPECT_EQ(printable(std::string(60, 'x')), std::string(60, 'x'));
  EXPECT_EQ(printable(std::string(61, 'x')), std::string(57, 'x') + "...");
  EXPECT_EQ(printable(std::string(10000, 'x')), std::string(57, 'x') + "...");
  std::string umlauts;
  for (int i = 0; i < 60; ++i) umlauts += "ü";
  EXPECT_EQ(printable(umlauts), umlauts);
  EXPECT_EQ(printable(umlauts + "ü"), umlauts.substr(0, 114) + "...");
  // Nothing is cut within what was written out.
  EXPECT_EQ(printable(std::string(100, '\x1b')).size(), 14 * 4 + 3);
}

TEST(Printable, IsAlwaysOneShortLine) {
  const bool holds = rc::check("any bytes", [] {
    const auto text = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    const std::string shown = printable(text + text + text);
    RC_ASSERT(shown.size() <= 4 * kMaxPrinted);
    for (const char c : shown) RC_ASSERT(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F);
  });
  EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace alltact
