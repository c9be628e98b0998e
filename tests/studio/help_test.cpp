// The help pages: one for every place, in words that stand in the window, with a picture of it.
// ALLTACT_RENEW_HELP=1 keeps what the window shows now as the pages' pictures in resources/help:
// look at them before committing.
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/measured_finger.h"
#include "tests/support/same_everywhere.h"
#include "tests/support/unlike_part.h"
#include "widgets/pages/accuracy_page.h"

#include <QElapsedTimer>
#include <QFile>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QTextDocument>
#include <QXmlStreamReader>
#include <set>

#include <gmock/gmock.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

const char* const kPlaces[] = {"live", "calibrate", "record", "inspect", "accuracy"};

struct Page {
  std::string place, language;  ///< "en", "de", "zh_CN"
  [[nodiscard]] std::string name() const {
    return place + (language == "en" ? "" : "_" + language);
  }
  [[nodiscard]] fs::path file(const char* ending) const {
    return fs::path(ALLTACT_SOURCE_DIR) / "resources/help" / (name() + ending);
  }
  [[nodiscard]] QString text() const { return QString::fromStdString(text_of(file(".md"))); }
};
void PrintTo(const Page& page, std::ostream* out) { *out << page.name(); }

std::vector<Page> pages() {
  std::vector<Page> all;
  for (const char* place : kPlaces)
    for (const char* language : {"en", "de", "zh_CN"}) all.push_back({place, language});
  return all;
}

class Help : public testing::TestWithParam<Page> {};
INSTANTIATE_TEST_SUITE_P(Page, Help, testing::ValuesIn(pages()),
                         [](const auto& page) { return page.param.name(); });

/// Without accelerators and the dots of what opens a dialog.
QString plain(QString text) {
  static const QRegularExpression key(QStringLiteral("\\(&[A-Z0-9]\\)"));
  text.remove(key);
  text.remove(QLatin1Char('&'));
  text.remove(QChar(0x2026));
  return text.trimmed();
}

/// All that the program says in a language.
std::set<QString> said_in(const std::string& language) {
  QFile file(QStringLiteral(ALLTACT_SOURCE_DIR "/translations/alltact_%1.ts")
                 .arg(QLatin1String(language == "en" ? "de" : language.c_str())));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  std::set<QString> reported;
  const QString wanted =
      language == "en" ? QStringLiteral("source") : QStringLiteral("translation");
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement() || xml.name() != wanted) continue;
    QString text = plain(xml.readElementText(QXmlStreamReader::IncludeChildElements));
    reported.insert(text);
    // Words of the libraries begin a line of the window with a capital.
    if (!text.isEmpty()) reported.insert(text.replace(0, 1, text.at(0).toUpper()));
  }
  return reported;
}

/// What a page sets in italics, which is what stands in the window.
QStringList named_in(const QString& page) {
  static const QRegularExpression form(
      QStringLiteral("(?<!\\*)\\*(?!\\*)([^*\\n]+)(?<!\\*)\\*(?!\\*)"));
  QStringList names;
  for (auto found = form.globalMatch(page); found.hasNext();) names << found.next().captured(1);
  return names;
}

TEST_P(Help, NamesOnlyWhatStandsInTheWindow) {
  const QStringList names = named_in(GetParam().text());
  EXPECT_GE(names.size(), 3);
  const std::set<QString> reported = said_in(GetParam().language);
  ASSERT_GT(reported.size(), 400U);
  for (const QString& name : names)
    EXPECT_TRUE(reported.count(plain(name)) == 1) << name.toStdString() << " stands nowhere";
}

TEST_P(Help, ShowsItsPictureAndLeavesNoMarkBehind) {
  Studio studio;
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QString::fromStdString(GetParam().language)});
  studio.window().go_to(GetParam().place);
  QTest::keyClick(&studio.window(), Qt::Key_F1);
  auto* page = studio.window().findChild<QTextBrowser*>();
  ASSERT_NE(page, nullptr);
  const QString html = page->toHtml();
  const QString image = QString::fromStdString(GetParam().name() + ".png");
  EXPECT_TRUE(html.contains(QStringLiteral("<img src=\"%1\"").arg(image)));
  const QVariant loaded = page->document()->resource(QTextDocument::ImageResource, QUrl(image));
  EXPECT_EQ(loaded.value<QImage>().isNull() && loaded.value<QPixmap>().isNull() &&
                loaded.toByteArray().isEmpty(),
            false)
      << image.toStdString();
  EXPECT_LT(fs::file_size(GetParam().file(".png")), 80'000U);
  EXPECT_FALSE(page->toPlainText().contains(QLatin1Char('*'))) << "emphasis that is none";
  page->window()->resize(880, 720);
  QTest::qWait(100);
  fs::create_directories(ALLTACT_SCREENS);
  page->window()->grab().save(
      QString::fromStdString(std::string(ALLTACT_SCREENS) + "/help_" + GetParam().name() + ".png"));
}

TEST_P(Help, OfLiveLeadsToTheEffects) {
  if (GetParam().place != "live") GTEST_SKIP() << "speaks of no scene";
  Studio studio;
  ProgramAppearance appearance;
  appearance.apply({Theme::kLight, QString::fromStdString(GetParam().language)});
  studio.window().go_to("live");
  QTest::keyClick(&studio.window(), Qt::Key_F1);
  auto* page = studio.window().findChild<QTextBrowser*>();
  ASSERT_NE(page, nullptr);
  const QString effects =
      QString::fromStdString("effects" + GetParam().name().substr(GetParam().place.size()) + ".md");
  EXPECT_TRUE(page->toHtml().contains(QStringLiteral("href=\"%1\"").arg(effects)));
  page->setSource(QUrl(effects));  // as a click does
  EXPECT_TRUE(page->toPlainText().contains(QLatin1String("interreflection")));
  EXPECT_TRUE(page->toHtml().contains(QLatin1String("<table")));
}

/// As pages show it: smaller, and in few shades, which is what makes its file small.
QImage reduced(const QImage& window) {
  constexpr int kWidthPx = 720, kShades = 32;
  QImage small = window.convertToFormat(QImage::Format_RGB888)
                     .scaledToWidth(kWidthPx, Qt::SmoothTransformation);
  for (int y = 0; y < small.height(); ++y) {
    uchar* line = small.scanLine(y);
    for (int i = 0; i < 3 * small.width(); ++i)
      line[i] = static_cast<uchar>((line[i] * kShades + 127) / 255 * 255 / kShades);
  }
  return small;
}

/// `is_calm`: when the window shows what is to be seen.
void expect_like_kept(
    MainWindow& window, const char* place,
    const std::function<bool()>& is_calm = [] { return true; }) {
  for (const Page& page : {Page{place, "zh_CN"}, Page{place, "de"}, Page{place, "en"}}) {
    ProgramAppearance appearance;
    appearance.apply({Theme::kLight, QString::fromStdString(page.language)});
    QTest::qWait(400);
    ASSERT_TRUE(wait_until(is_calm));
    QTest::qWait(100);  // plots are painted with the next turns of the loop
    const QImage now = reduced(window.grab().toImage());
    const QString file = QString::fromStdString(page.file(".png").string());
    if (qEnvironmentVariableIsSet("ALLTACT_RENEW_HELP")) {
      ASSERT_TRUE(now.save(file, "PNG", 0));
      continue;
    }
    const QImage kept(file);
    ASSERT_FALSE(kept.isNull()) << file.toStdString() << " is missing";
    EXPECT_EQ(kept.size(), now.size());
    const double unlike = unlike_part(now, kept);
    std::printf("[ figures  ] %-16s %.4f unlike\n", page.name().c_str(), unlike);
    if (unlike <= kMostUnlike) continue;
    const QString differs = QString::fromStdString(std::string(ALLTACT_SCREENS) + "/help_" +
                                                   page.name() + "_differs.png");
    fs::create_directories(ALLTACT_SCREENS);
    now.save(differs);
    ADD_FAILURE() << unlike << " of the picture is unlike; compare " << differs.toStdString()
                  << " with " << file.toStdString();
  }
}

TEST(HelpPictures, OfLiveIsLikeTheWindow) {
  const SameEverywhere same;
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().touched()};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] {
    const auto& view = studio.session().view();
    return view && view->depth_layer;
  }));
  expect_like_kept(studio.window(), "live");
}

TEST(HelpPictures, OfRecordIsLikeTheWindow) {
  const SameEverywhere same;
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  QTest::qWait(1500);
  // A finger that bends quickly may be taken for one that is touched; the window then makes room
  // for the warning, and when it has gone takes a moment to close up.
  QElapsedTimer calm;
  calm.start();
  expect_like_kept(studio.window(), "record", [&] {
    if (!studio.problems().empty()) calm.restart();
    return calm.elapsed() > 250;
  });
}

TEST(HelpPictures, OfCalibrateIsLikeTheWindow) {
  const SameEverywhere same;
  CalibrateStudio rig(6);
  rig.open();
  rig.go_to_step("Presses");
  ASSERT_TRUE(wait_until([&] { return rig.collection().presses().size() == 6; }));
  rig.collection().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  auto* list = rig.place().findChild<PressesPage*>()->findChild<QListView*>();
  list->setCurrentIndex(list->model()->index(2, 0));
  expect_like_kept(rig.studio().window(), "calibrate",
                   [&] { return rig.place().forecast().result() != nullptr; });
}

TEST(HelpPictures, OfInspectIsLikeTheWindow) {
  const SameEverywhere same;
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  studio.window().go_to("inspect");
  auto& place = *studio.window().findChild<InspectPage*>();
  place.open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until([&] { return place.inspection().frame() != nullptr; }));
  ASSERT_TRUE(wait_until([&] { return place.inspection().summaries().size() == 6; }, 20000));
  for (const char* button : {"deepest", "across"})
    place.findChild<QPushButton*>(QLatin1String(button))->click();
  QTest::qWait(300);
  expect_like_kept(studio.window(), "inspect");
}

TEST(HelpPictures, OfAccuracyIsLikeTheWindow) {
  const SameEverywhere same;
  StudioOptions options;
  options.finger = MeasuredFinger::get().folder();
  Studio studio(options);
  studio.window().go_to("accuracy");
  auto& place = *studio.window().findChild<AccuracyPage*>();
  ASSERT_TRUE(wait_until([&] { return place.run().study() != nullptr; }));
  expect_like_kept(studio.window(), "accuracy");
}

TEST(HelpPictures, OfTwoPlacesOrLanguagesAreUnlike) {
  const auto image = [](const Page& page) {
    return QImage(QString::fromStdString(page.file(".png").string()));
  };
  for (const Page& a : pages())
    for (const Page& b : pages()) {
      if (a.name() == b.name()) continue;
      const double unlike = unlike_part(image(a), image(b));
      EXPECT_GT(unlike, a.place == b.place ? 0.005 : kMostUnlike) << a.name() << ", " << b.name();
    }
}

}  // namespace
}  // namespace alltact::test
