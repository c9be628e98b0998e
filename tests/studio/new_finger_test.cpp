// The dialog that describes a new finger: where the focus is, what it reports, what Escape loses,
// and a flat sensor without a camera file.
#include "core/finger/finger.h"
#include "core/image/image_file.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/shell/new_finger_dialog.h"

#include <QMessageBox>
#include <QPointer>
#include <QSettings>
#include <QSignalSpy>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class NewFingerTest : public testing::Test {
 protected:
  NewFingerTest() : dialog_(new NewFingerDialog) {}
  ~NewFingerTest() override { delete dialog_; }
  void show() {
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    dialog_->show();
    QApplication::setActiveWindow(dialog_);
    QTest::qWait(30);
  }
  template <class T>
  T* find(const char* name) {
    for (T* one : dialog_->findChildren<T*>())
      if (one->accessibleName() == QLatin1String(name)) return one;
    ADD_FAILURE() << name;
    return nullptr;
  }
  QPushButton* button(QWidget& in, const char* text) {
    for (auto* one : in.findChildren<QPushButton*>())
      if (one->text().remove(QLatin1Char('&')) == QLatin1String(text)) return one;
    ADD_FAILURE() << text;
    return nullptr;
  }
  TemporaryFolder folder_;
  QPointer<NewFingerDialog> dialog_;
};

TEST_F(NewFingerTest, BeginsInItsFirstFieldAndReturnMakesTheFinger) {
  show();
  EXPECT_EQ(QApplication::focusWidget(), find<QLineEdit>("New folder"));
  EXPECT_TRUE(button(*dialog_, "Make the finger")->isDefault());
}

TEST_F(NewFingerTest, ReportsWhatIsMissingInFullAndMovesNothing) {
  show();
  auto* make = button(*dialog_, "Make the finger");
  const QPoint before = make->mapTo(dialog_, QPoint());
  const QSize size = dialog_->size();
  QTest::mouseClick(make, Qt::LeftButton);
  QTest::qWait(60);
  EXPECT_EQ(make->mapTo(dialog_, QPoint()), before);
  EXPECT_EQ(dialog_->size(), size);
  EXPECT_EQ(QApplication::focusWidget(), find<QLineEdit>("New folder"));
  int shown = 0;
  for (const QLabel* label : dialog_->findChild<ProblemList*>()->findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().size() < 20) continue;
    ++shown;
    EXPECT_EQ(qobject_cast<const ElidedLabel*>(label), nullptr) << "cut where it counts";
    EXPECT_GE(label->height(), label->heightForWidth(label->width()));
  }
  EXPECT_EQ(shown, 2);
}

TEST_F(NewFingerTest, EscapeDiscardsNothingThatWasTypedWithoutAQuestion) {
  show();
  auto* folder = find<QLineEdit>("New folder");
  QTest::keyClicks(folder, "left-07");
  QTest::keyClick(folder, Qt::Key_Escape);
  QTest::qWait(30);
  ASSERT_TRUE(dialog_ && dialog_->isVisible());
  auto* question = dialog_->findChild<QMessageBox*>();
  ASSERT_NE(question, nullptr);
  QTest::keyClick(question, Qt::Key_Escape);
  QTest::qWait(30);
  EXPECT_EQ(folder->text(), "left-07");
  QTest::keyClick(folder, Qt::Key_Escape);
  QTest::qWait(30);
  question = dialog_->findChild<QMessageBox*>();
  ASSERT_NE(question, nullptr);
  button(*question, "Discard")->click();
  QTest::qWait(30);
  EXPECT_FALSE(dialog_ && dialog_->isVisible());
}

TEST_F(NewFingerTest, EscapeClosesWhatNobodyFilledIn) {
  NewFinger known;
  known.camera = MadeFingers::get().camera();
  dialog_->set_description(known);
  show();
  QTest::keyClick(dialog_, Qt::Key_Escape);
  QTest::qWait(30);
  EXPECT_FALSE(dialog_ && dialog_->isVisible());
}

TEST_F(NewFingerTest, AFlatSensorNeedsOnlyTheSizeOfAPixelAndItsUntouchedImage) {
  must(write_image(folder_ / "untouched.png", cv::Mat(60, 80, CV_8UC1, cv::Scalar(120))));
  show();
  find<QComboBox>("Kind")->setCurrentIndex(1);
  find<QLineEdit>("New folder")->setText(QString::fromStdString((folder_ / "flat").string()));
  auto* pixel = find<QDoubleSpinBox>("Size of a pixel");
  pixel->setFocus();
  pixel->selectAll();
  QTest::keyClicks(pixel, "0.025");
  find<QLineEdit>("Untouched image")
      ->setText(QString::fromStdString((folder_ / "untouched.png").string()));
  QSignalSpy made(dialog_, &NewFingerDialog::made);
  QTest::mouseClick(button(*dialog_, "Make the finger"), Qt::LeftButton);
  ASSERT_TRUE(wait_until([&] { return made.count() == 1; }));
  const Finger finger = Finger::load(folder_ / "flat").value();
  EXPECT_EQ(finger.face.kind, FaceKind::kFlat);
  EXPECT_EQ(finger.camera.model, CameraModel::kOrthographic);
  EXPECT_EQ(finger.camera.mm_per_px, 0.025);
  EXPECT_EQ(finger.camera.width_px, 80);
  EXPECT_EQ(finger.camera.height_px, 60);
  ASSERT_TRUE(finger.reference);
  EXPECT_FALSE(finger.reference->image.empty());
}

/// From the page, too: no camera is open.
TEST(FlatFinger, TakesItsUntouchedImageFromAFile) {
  const TemporaryFolder folder;
  must(write_image(folder / "untouched.png", cv::Mat(60, 80, CV_8UC1, cv::Scalar(120))));
  CameraParameters camera;
  camera.model = CameraModel::kOrthographic;
  camera.width_px = 80;
  camera.height_px = 60;
  camera.cx_px = 39.5;
  camera.cy_px = 29.5;
  camera.mm_per_px = 0.025;
  must(save_camera(folder / "camera.yaml", camera));
  NewFinger flat;
  flat.finger = folder / "flat";
  flat.camera = folder / "camera.yaml";
  flat.kind = FaceKind::kFlat;
  flat.layer_mm = 1;
  ASSERT_TRUE(make_finger(flat));
  StudioOptions options;
  options.finger = folder / "flat";
  Studio studio(options);
  ASSERT_TRUE(
      wait_until([&] { return studio.session().status().finger.state == FingerState::kReady; }));
  studio.window().go_to("calibrate");
  studio.click("Untouched image from a file…");
  auto* dialog = studio.window().findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  Q_EMIT dialog->fileSelected(QString::fromStdString((folder / "untouched.png").string()));
  dialog->close();
  EXPECT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }))
      << studio.problems();
  studio.window().go_to("record");
  EXPECT_FALSE(says(studio, "markers must be visible")) << "it cannot bend";
}

/// A dialog for files begins where it was used last for the same purpose, never where the program
/// happened to be started.
TEST(FileDialogs, BeginInTheFolderThatWasUsedLast) {
  const TemporaryFolder folder;
  QSettings().remove("folders");
  QWidget window;
  ask_for_folder(&window, FilesOf::kFingers, "a finger", [](const QString&) {});
  auto* first = window.findChild<QFileDialog*>();
  ASSERT_NE(first, nullptr);
  EXPECT_NE(first->directory().absolutePath(), QDir::currentPath());
  std::filesystem::create_directories(folder / "fingers/left-07");
  Q_EMIT first->filesSelected({QString::fromStdString((folder / "fingers/left-07").string())});
  delete first;
  ask_for_folder(&window, FilesOf::kFingers, "a finger", [](const QString&) {});
  auto* again = window.findChild<QFileDialog*>();
  EXPECT_EQ(again->directory().absolutePath().toStdString(), (folder / "fingers").string());
  delete again;
  ask_for_file(&window, FilesOf::kMeshes, "a mesh", {}, [](const QString&) {});
  EXPECT_NE(window.findChild<QFileDialog*>()->directory().absolutePath().toStdString(),
            (folder / "fingers").string())
      << "another purpose";
  QSettings().remove("folders");
}

TEST(FileDialogs, BeginInTheOpenFingersFolder) {
  QSettings().remove("folders");
  StudioOptions options;
  options.finger = MadeFingers::get().described();
  Studio studio(options);
  QWidget window;
  const auto begins_in = [&](FilesOf what) {
    ask_for_file(&window, what, "a file", {}, [](const QString&) {});
    auto* dialog = window.findChild<QFileDialog*>();
    const std::string folder = dialog->directory().absolutePath().toStdString();
    delete dialog;
    return folder;
  };
  EXPECT_EQ(begins_in(FilesOf::kRecordings), MadeFingers::get().described());
  EXPECT_EQ(begins_in(FilesOf::kFingers), MadeFingers::get().described().parent_path())
      << "other fingers lie next to it";
  studio.window().open_finger({});
  EXPECT_NE(begins_in(FilesOf::kRecordings), MadeFingers::get().described());
  QSettings().remove("folders");
}

}  // namespace
}  // namespace alltact::test
