// Help where one is: hints for who comes for the first time, the glossary with its pictures, the
// guide to print. ALLTACT_RENEW_HELP=1 keeps the glossary's pictures as they are painted now: look
// at them before committing.
#include "app/studio/help.h"
#include "app/studio/onboarding.h"
#include "core/base/atomic_file.h"
#include "tests/gallery/gallery.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/picture_match.h"
#include "tests/support/same_everywhere.h"
#include "widgets/shell/finger_drawing.h"

#include <QSettings>
#include <QTextDocument>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::SizeIs;

const char* const kGuideLanguages[] = {"en", "de", "zh_CN"};
const char* const kGuidePlaces[] = {"live", "calibrate", "record", "inspect", "accuracy"};

class HelpTexts : public testing::TestWithParam<const char*> {
 protected:
  HelpTexts() { appearance_.apply({Theme::kLight, QLatin1String(GetParam())}); }
  ~HelpTexts() override { appearance_.apply({Theme::kLight, QStringLiteral("en")}); }
  ProgramAppearance appearance_;
};
INSTANTIATE_TEST_SUITE_P(Language, HelpTexts, testing::ValuesIn(kGuideLanguages),
                         [](const auto& of) { return std::string(of.param); });

TEST_P(HelpTexts, OfEveryPlaceBeginWithWhatItIsFor) {
  for (const char* place : kGuidePlaces) {
    SCOPED_TRACE(place);
    const HelpLead lead = lead_of(help_text(QLatin1String(place)));
    EXPECT_FALSE(lead.title.isEmpty());
    EXPECT_GE(lead.lead.size(), 12);
    EXPECT_LE(without_marks(lead.lead).size(), 320) << "a hint that nobody reads";
    EXPECT_FALSE(without_marks(lead.lead).contains(QLatin1Char('*')));
    EXPECT_GE(lead.steps.size(), 3);
    EXPECT_FALSE(QImage(QStringLiteral(":/alltact/help/%1").arg(lead.image)).isNull());
  }
}

int pages_of(const std::string& pdf) {
  int pages = 0;
  for (std::size_t at = pdf.find("/Type /Page"); at != std::string::npos;
       at = pdf.find("/Type /Page", at + 1))
    pages += pdf.compare(at, 12, "/Type /Pages") != 0 ? 1 : 0;
  return pages;
}

TEST_P(HelpTexts, MakeAGuideOfTwoPages) {
  const auto guide = quick_guide_pdf("2026-01-31T12:00:00Z");
  ASSERT_TRUE(guide) << guide.error().sentence();
  EXPECT_EQ(pages_of(*guide), 2);
  EXPECT_LT(guide->size(), 3'000'000U);
  const auto again = quick_guide_pdf("2026-01-31T12:00:00Z");
  ASSERT_TRUE(again);
  EXPECT_TRUE(*guide == *again) << "the same texts, other bytes";
  fs::create_directories(ALLTACT_SCREENS);
  must(write_file_atomically(
      fs::path(ALLTACT_SCREENS) / (std::string("quick_guide_") + GetParam() + ".pdf"), *guide));
}

TEST_P(HelpTexts, ExplainTheWordsInAGlossaryWithPictures) {
  Studio studio;
  appearance_.apply({Theme::kLight, QLatin1String(GetParam())});
  QTest::keyClick(&studio.window(), Qt::Key_F1);
  auto* window = studio.window().findChild<HelpWindow*>();
  ASSERT_NE(window, nullptr);
  window->show_page(QStringLiteral("glossary"));
  auto* page = window->findChild<QTextBrowser*>();
  QTest::qWait(50);
  for (const char* image : {"glossary_finger.png", "glossary_press.png", "glossary_picture.png"}) {
    EXPECT_THAT(page->toHtml().toStdString(), HasSubstr(image));
    EXPECT_TRUE(fs::exists(fs::path(ALLTACT_SOURCE_DIR) / "resources/help" / image)) << image;
  }
  // Each number in a picture is explained, and there is no other.
  const QString text = page->toPlainText();
  for (const char* open : {"(", "\xEF\xBC\x88"})
    for (int number = 11; number < 20; ++number)
      EXPECT_FALSE(text.contains(QString::fromUtf8(open) + QString::number(number)));
  for (int number = 1; number <= 10; ++number)
    EXPECT_TRUE(text.contains(QStringLiteral("(%1)").arg(number)) ||
                text.contains(QString::fromUtf8("\xEF\xBC\x88%1\xEF\xBC\x89").arg(number)))
        << number;
  window->grab().save(
      QStringLiteral(ALLTACT_SCREENS "/help_glossary_%1.png").arg(QLatin1String(GetParam())));
}

void expect_glossary_picture(const QImage& painted, const char* name) {
  const fs::path file = fs::path(ALLTACT_SOURCE_DIR) / "resources/help" / name;
  const QImage now = painted.convertToFormat(QImage::Format_RGB888);
  if (qEnvironmentVariableIsSet("ALLTACT_RENEW_HELP")) {
    ASSERT_TRUE(now.save(QString::fromStdString(file.string()), "PNG", 0));
    return;
  }
  EXPECT_EQ(what_differs(now, QImage(QString::fromStdString(file.string()))), "") << name;
  EXPECT_LT(fs::file_size(file), 60'000U);
}

TEST(Glossary, PicturesAreAsTheyArePainted) {
  const SameEverywhere same;
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QStringLiteral("en")});
  for (const auto& [what, name] : {std::pair{DrawnThing::kFinger, "glossary_finger.png"},
                                   std::pair{DrawnThing::kPress, "glossary_press.png"}}) {
    FingerDrawing drawing(what);
    drawing.show_numbers(true);
    drawing.setAttribute(Qt::WA_DontShowOnScreen);
    drawing.resize(640, 320);
    drawing.show();
    expect_glossary_picture(drawing.grab().toImage(), name);
  }
  const auto image = gallery().at("outline_editor")();
  image->setAttribute(Qt::WA_DontShowOnScreen);
  image->resize(640, 360);
  image->show();
  QTest::qWait(50);
  expect_glossary_picture(image->grab().toImage(), "glossary_picture.png");
}

TEST(Hints, ComeOnceAndStayAwayWhenSentAway) {
  Studio studio;
  auto* hint = studio.window().findChild<PageHint*>();
  ASSERT_NE(hint, nullptr);
  QSettings().remove(PageHint::key("inspect"));
  studio.window().go_to("record");
  EXPECT_FALSE(hint->isVisible()) << "it is known already";
  studio.window().go_to("inspect");
  ASSERT_TRUE(hint->isVisible());
  const QString text = hint->findChild<QLabel*>()->text();
  EXPECT_EQ(text, lead_of(help_text("inspect")).lead) << "the help's own words";
  studio.click("How it is done (F1)");
  EXPECT_NE(studio.window().findChild<HelpWindow*>(), nullptr);
  studio.click("Understood");
  EXPECT_FALSE(hint->isVisible());
  studio.window().go_to("live");
  studio.window().go_to("inspect");
  EXPECT_FALSE(hint->isVisible());
  EXPECT_TRUE(QSettings().value(PageHint::key("inspect")).toBool()) << "the next day, too";
}

TEST(Hints, AreSilentWhileTheGuideSpeaks) {
  Studio studio;
  QSettings().remove(PageHint::key("record"));
  auto* hint = studio.window().findChild<PageHint*>();
  studio.click("Try with a simulated finger");
  studio.window().go_to("record");
  EXPECT_FALSE(hint->isVisible());
  studio.click("End the guide");
  EXPECT_TRUE(hint->isVisible());
}

TEST(Hints, ComeToLiveWithTheFirstSource) {
  Studio studio;
  QSettings().remove(PageHint::key("live"));
  auto* hint = studio.window().findChild<PageHint*>();
  studio.window().go_to("live");
  EXPECT_FALSE(hint->isVisible()) << "the first page speaks for itself";
  studio.window().open_source({MadeFingers::get().bending()});
  EXPECT_TRUE(hint->isVisible());
}

TEST(HelpLeads, AreReadFromMarkdown) {
  const HelpLead lead = lead_of(
      "# A place\n\nThe *first* [paragraph](page.md)\nof two lines.\n\n![what](picture.png)\n\n"
      "1. **One.** Do\n   this.\n2. Two.\n\nMore.\n\n3. No step.\n");
  EXPECT_EQ(lead.title, "A place");
  EXPECT_EQ(lead.lead, "The *first* [paragraph](page.md) of two lines.");
  EXPECT_EQ(without_marks(lead.lead), "The first paragraph of two lines.");
  EXPECT_EQ(lead.image, "picture.png");
  EXPECT_THAT(lead.steps, SizeIs(2));
  EXPECT_EQ(lead.steps.first(), "**One.** Do this.");
  const HelpLead bare = lead_of("# Bare\n");
  EXPECT_TRUE(bare.lead.isEmpty() && bare.steps.isEmpty() && bare.image.isEmpty());
}

}  // namespace
}  // namespace alltact::test
