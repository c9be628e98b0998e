// In a German and in a Chinese window the libraries speak German and Chinese, too.
#include "core/base/atomic_file.h"
#include "tests/studio/calibrate_rig.h"
#include "tests/support/ts_file.h"
#include "tests/support/words_left.h"
#include "widgets/shell/problem_list.h"

#include <QListWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

/// As the translations have it.
std::string in(const std::string& language, const char* source) {
  for (const TsMessage& message : messages_of(ts_file(language)))
    if (message.context == QLatin1String(kSaidContext) && message.source == QLatin1String(source))
      return message.translations.first().toStdString();
  ADD_FAILURE() << "not translated: " << source;
  return {};
}

QString texts_of(const QWidget& root) {
  QString texts;
  for (const QLabel* label : root.findChildren<QLabel*>())
    if (label->isVisible()) texts += label->text() + QLatin1Char('\n');
  for (const QListWidget* list : root.findChildren<QListWidget*>())
    for (int i = 0; list->isVisible() && i < list->count(); ++i)
      texts += list->item(i)->text() + QLatin1Char('\n');
  return texts;
}

void expect_nothing_clipped(const QWidget& root) {
  for (const QLabel* label : root.findChildren<QLabel*>())
    if (label->isVisible() && label->wordWrap()) {
      EXPECT_GE(label->height(), label->heightForWidth(label->width()))
          << "clipped: " << label->text().toStdString();
    }
}

/// Says the open window anew in each language, looks for English that is left, and keeps a picture.
class Spoken : public testing::Test {
 protected:
  template <class Check>
  void in_every_language(Studio& studio, const QString& name, const Check& check) {
    for (const char* language : {"de", "zh_CN"}) {
      SCOPED_TRACE(language);
      appearance_.apply({Theme::kLight, QLatin1String(language)});
      QTest::qWait(400);
      const QString texts = texts_of(studio.window());
      EXPECT_TRUE(words_left(texts).isEmpty()) << words_left(texts).join("; ").toStdString();
      expect_nothing_clipped(studio.window());
      check(std::string(language), texts.toStdString());
      std::filesystem::create_directories(ALLTACT_SCREENS);
      studio.window().grab().save(
          QStringLiteral(ALLTACT_SCREENS "/spoken_%1_%2.png").arg(name, QLatin1String(language)));
    }
  }
  ProgramAppearance appearance_;
};

TEST_F(Spoken, AFingerThatCannotBeReadAndACameraThatIsNotThere) {
  const TemporaryFolder folder;
  std::filesystem::copy(MadeFingers::get().described(), folder / "finger",
                        std::filesystem::copy_options::recursive);
  std::string yaml = read_file(folder / "finger" / "finger.yaml", 1 << 20).value();
  const std::string key = "layer_mm: ";
  yaml.replace(yaml.find(key), key.size(), key + "thick # ");
  ASSERT_TRUE(write_file_atomically(folder / "finger" / "finger.yaml", yaml).ok());
  StudioOptions options;
  options.finger = folder / "finger";
  options.source = {"/dev/video77"};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] {
    const std::string reported = studio.problems();
    return reported.find("layer_mm") != std::string::npos &&
           reported.find("camera") != std::string::npos;
  })) << studio.problems();
  in_every_language(studio, "problems", [&](const std::string& language, const std::string& texts) {
    const std::string reported = studio.problems();
    EXPECT_THAT(reported, HasSubstr("face.layer_mm"));
    EXPECT_THAT(reported, HasSubstr(in(language, "a length in mm")));
    EXPECT_THAT(reported, HasSubstr("/dev/video77"));
    EXPECT_THAT(QString::fromStdString(reported).toLower().toStdString(),
                HasSubstr(in(language, "it is not connected")));
    EXPECT_THAT(
        reported,
        HasSubstr(in(language, "plug the camera in; 'alltact devices' lists what is found")));
    // The newest stands there, which may be either; the other one unfolds.
    EXPECT_THAT(QString::fromStdString(texts).toLower().toStdString(),
                ::testing::AnyOf(HasSubstr(in(language, "it is not connected")),
                                 HasSubstr("face.layer_mm")));
  });
}

TEST_F(Spoken, TheVerdictTheAdviceAndTheRemarks) {
  CalibrateStudio rig(3);
  rig.open();
  rig.collection().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(3));
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  const FingerCalibration& done = *rig.run().result();
  ASSERT_TRUE(done.calibration.next_press);
  ASSERT_THAT(done.calibration.next_press->sentence.english(), HasSubstr(" mm from the base"));
  for (const char* step : {"3", "4", "5", "6"}) {
    rig.go_to_step(step);
    if (*step == '5') rig.place().findChild<VerdictPage*>()->unfold();
    in_every_language(
        rig.studio(), QStringLiteral("step_%1").arg(step),
        [&](const std::string& language, const std::string& texts) {
          if (*step == '4') {
            EXPECT_THAT(texts, HasSubstr(language == "de" ? "Abbildung: " : "映射："));
          }
          if (*step != '5') return;
          EXPECT_THAT(texts, HasSubstr(language == "de" ? "Bisher erwarteter Fehler: ±" : " mm"));
          EXPECT_THAT(texts,
                      HasSubstr(language == "de" ? "Kugel von 8,00 mm Durchmesser" : "8.00 mm"));
          EXPECT_THAT(texts, HasSubstr(language == "de" ? " mm vom Fuß, " : "距根部 "));
          EXPECT_THAT(texts, HasSubstr(in(language, "upper half")));
          EXPECT_THAT(texts, HasSubstr(language == "de" ? "Am unsichersten ist" : "最不确定的是"));
        });
  }
}

}  // namespace
}  // namespace alltact::test
