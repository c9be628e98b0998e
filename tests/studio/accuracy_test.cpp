// The place Accuracy, as a person uses it: measured once, asked, used, taken back.
#include "calibration/finger/measuring_presets.h"
#include "calibration/study/recommended_settings.h"
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/measured_finger.h"
#include "widgets/pages/accuracy_page.h"

#include <QClipboard>
#include <QProgressBar>
#include <QTableView>

#include <gmock/gmock.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A finger of its own, which may keep a study.
class Accuracy : public testing::Test {
 protected:
  void open(bool is_measured, const fs::path& source = MadeFingers::get().touched()) {
    fs::copy(is_measured ? MeasuredFinger::get().folder() : MadeFingers::get().calibrated(),
             finger(), fs::copy_options::recursive);
    open_again(source);
  }
  void open_again(const fs::path& source = MadeFingers::get().touched()) {
    StudioOptions options;
    options.finger = finger();
    if (!source.empty()) options.source = {source};
    studio_ = std::make_unique<Studio>(options);
    studio_->window().go_to("accuracy");
    ASSERT_TRUE(wait_until([&] { return place().run().finger() != nullptr; }));
  }
  [[nodiscard]] fs::path finger() const { return folder_ / "finger"; }
  [[nodiscard]] AccuracyPage& place() { return *studio_->window().findChild<AccuracyPage*>(); }
  bool wait_for_study() {
    return wait_until([&] { return place().run().study() != nullptr; }, 120000);
  }
  [[nodiscard]] std::size_t row_with(const std::function<bool(const PipelineSettings&)>& is_so) {
    const auto& rows = place().run().study()->study.rows;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (is_so(rows[i].settings)) return i;
    ADD_FAILURE() << "no such row";
    return 0;
  }
  TemporaryFolder folder_;
  std::unique_ptr<Studio> studio_;
};

TEST_F(Accuracy, OffersToMeasureWhereNothingIsMeasured) {
  open(false, {});
  auto* button = studio_->find<QPushButton>("Measure settings on this finger (about 12 s)");
  ASSERT_NE(button, nullptr);
  EXPECT_TRUE(button->isEnabled());
  EXPECT_FALSE(place().plot().isVisible());
  studio_->click(button->text().remove('&'));
  ASSERT_TRUE(wait_until([&] { return place().run().work().fraction() > 0.3; }, 60000));
  EXPECT_NE(studio_->find<QProgressBar>("Progress of measuring"), nullptr);
  studio_->click("Stop");
  ASSERT_TRUE(wait_until([&] { return !place().run().is_running(); }, 20000));
  EXPECT_EQ(studio_->problems(), "");
  const bool has_some = place().run().study() != nullptr;
  const QString on =
      has_some ? QStringLiteral("Measure missing settings") : button->text().remove('&');
  EXPECT_NE(studio_->find<QPushButton>(on), nullptr);
  if (is_thorough()) {
    studio_->click(on);
    ASSERT_TRUE(wait_until(
        [&] { return place().run().study() && place().run().study()->has_all_single; }, 120000));
  }
  EXPECT_EQ(place().plot().isVisible(), place().run().study() != nullptr);
  const auto measured = place().run().study();
  studio_.reset();
  open_again({});
  if (!measured) return;
  ASSERT_TRUE(wait_for_study()) << "there at once on the second day";
  EXPECT_EQ(place().run().study()->study.rows.size(), measured->study.rows.size());
  EXPECT_EQ(place().run().study()->has_all_single, measured->has_all_single);
}

TEST_F(Accuracy, SaysWhatIsMissingFirst) {
  Studio studio;
  studio.window().go_to("accuracy");
  EXPECT_TRUE(says(studio, "Open a finger first."));
  studio.window().open_finger(MadeFingers::get().described());
  EXPECT_TRUE(wait_until([&] { return says(studio, "Calibrate this finger first."); }));
  EXPECT_FALSE(
      studio.find<QPushButton>("Measure settings on this finger (about 12 s)")->isEnabled());
}

TEST_F(Accuracy, AnswersTwoQuestionsWithOneSetting) {
  open(true, {});
  ASSERT_TRUE(wait_for_study());
  const AccuracyStudy& study = place().run().study()->study;
  auto* rate = studio_->find<QComboBox>("Images per second");
  for (const int wanted : {10, 100, 1000}) {
    rate->setEditText(QString::number(wanted));
    StudyQuestion question;
    question.frames_per_s = wanted;
    EXPECT_EQ(place().answer_row(), answer_to(question, study)->row) << wanted;
  }
  EXPECT_TRUE(says(*studio_, "95 % within"));
  auto* error = studio_->find<QDoubleSpinBox>("Maximum error");
  error->setValue(0.001);
  EXPECT_TRUE(says(*studio_, "No setting"));
  studio_->click("Copy command");
  EXPECT_EQ(QGuiApplication::clipboard()->text().toStdString(),
            "alltact study " + finger().string() + " --within-ms 1 --keep-mm 0.001");
}

TEST_F(Accuracy, TheFigureTakesTheRoomAndEqualsTheTable) {
  open(true, {});
  ASSERT_TRUE(wait_for_study());
  for (const QSize size : {QSize(1024, 700), QSize(1440, 900)}) {
    studio_->window().resize(size);
    QTest::qWait(100);
    EXPECT_EQ(studio_->window().size(), size);
    const AccuracyPlot& plot = place().plot();
    EXPECT_GE(plot.width() * plot.height(), 0.6 * place().width() * place().height());
  }
  const auto dots = place().plot().dots();
  const auto* model = place().findChild<AccuracyModel*>();
  const AccuracyStudy& study = place().run().study()->study;
  ASSERT_EQ(model->rowCount(), static_cast<int>(dots.size()));
  std::size_t seen = 0;
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const StudyRow& row = study.rows[i];
    const int line = static_cast<int>(i);
    EXPECT_EQ(model->index(line, AccuracyModel::kTime).data(AccuracyModel::kSortRole).toDouble(),
              frame_ms(study, row));
    if (!dots[i]) continue;
    ++seen;
    EXPECT_EQ(dots[i]->x(), frame_ms(study, row));
    EXPECT_EQ(dots[i]->y(), row.depth->median_mm);
  }
  EXPECT_GE(seen, dots.size() / 2);
}

/// Mean difference of neighbours' depths, mm: of noise that is not smoothed away.
double roughness_mm(const cv::Mat& depth_mm) {
  double sum = 0;
  int count = 0;
  for (int v = 0; v < depth_mm.rows; ++v)
    for (int u = 1; u < depth_mm.cols; ++u) {
      const double step = depth_mm.at<float>(v, u) - depth_mm.at<float>(v, u - 1);
      if (!std::isfinite(step)) continue;
      sum += std::abs(step);
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

TEST_F(Accuracy, UseItChangesWhatTheLivePictureIsMeasuredWithAndUndoTakesItBack) {
  open(true);
  ASSERT_TRUE(wait_for_study());
  const auto roughness = [&]() -> double {
    const auto& view = studio_->session().view();
    return view && view->result.depth ? roughness_mm(view->result.depth->depth_mm) : 0;
  };
  ASSERT_TRUE(wait_until([&] { return roughness() > 0; }, 60000));
  const double before_mm = roughness();
  const std::size_t row = row_with([](const PipelineSettings& settings) {
    PipelineSettings usual;
    usual.smoothing_px = 0;
    return key_of(settings) == key_of(usual);
  });
  auto* view = place().findChild<QTableView*>();
  place().findChild<QTabWidget*>()->setCurrentIndex(1);
  const auto* sorted = static_cast<const QSortFilterProxyModel*>(view->model());
  view->setCurrentIndex(
      sorted->mapFromSource(sorted->sourceModel()->index(static_cast<int>(row), 0)));
  EXPECT_EQ(place().answer_row(), row);
  EXPECT_TRUE(says(*studio_, "No smoothing"));
  studio_->click("Use it");
  EXPECT_EQ(studio_->window().undo_stack().undoText(), "use other settings");
  ASSERT_TRUE(wait_until([&] { return roughness() > 1.5 * before_mm; }, 60000))
      << "the live picture";
  EXPECT_EQ(measuring_settings(finger()).smoothing_px, 0);
  EXPECT_EQ(place().run().row_in_use(), row);
  EXPECT_NE(studio_->find<QPushButton>("In use"), nullptr);
  QTest::keyClick(&studio_->window(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait_until([&] { return roughness() > 0 && roughness() < 1.2 * before_mm; }, 60000));
  EXPECT_EQ(measuring_settings(finger()).smoothing_px, PipelineSettings().smoothing_px);
  EXPECT_EQ(place().run().row_in_use(), 0U);
  QTest::keyClick(&studio_->window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(wait_until([&] { return measuring_settings(finger()).smoothing_px == 0; }));
  studio_->click("Restore as calibrated");
  ASSERT_TRUE(wait_until([&] { return measuring_settings(finger()).smoothing_px > 0; }));
  EXPECT_EQ(presets_of_finger(finger())->used, "");
}

TEST_F(Accuracy, SaysThatTheFingerHasChangedSince) {
  open(true, {});
  ASSERT_TRUE(wait_for_study());
  EXPECT_FALSE(says(*studio_, "The finger has changed"));
  const auto changed = FingerStore::of(finger())->update([](Finger& now) {
    now.mapping->a_mm *= 1.01;
    return Status();
  });
  ASSERT_TRUE(changed);
  EXPECT_TRUE(wait_until([&] { return says(*studio_, "The finger has changed"); }));
  EXPECT_NE(studio_->find<QPushButton>("Measure again (about 12 s)"), nullptr);
}

}  // namespace
}  // namespace alltact::test
