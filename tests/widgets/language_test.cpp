// Days are written so that nobody takes one for another, in every language.
#include "widgets/language.h"

#include "tests/support/source_texts.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

class Days : public testing::Test {
 protected:
  ~Days() override { QLocale::setDefault(before_); }
  QLocale before_;
};

TEST_F(Days, HaveTheirMonthAsAWord) {
  const QDate day(2026, 11, 30);
  for (const auto& [locale, text] : {std::pair{"en_US", "30 Nov 2026"},
                                     {"en_GB", "30 Nov 2026"},
                                     {"de_DE", "30. November 2026"},
                                     {"zh_CN", "2026年11月30日"}}) {
    QLocale::setDefault(QLocale(QLatin1String(locale)));
    EXPECT_EQ(day_text(day), QString::fromUtf8(text)) << locale;
  }
}

TEST_F(Days, StandWithTheMinute) {
  QLocale::setDefault(QLocale("en_US"));
  EXPECT_EQ(moment_text(QDateTime(QDate(2026, 11, 3), QTime(14, 5))), "3 Nov 2026, 14:05");
}

}  // namespace
}  // namespace alltact
