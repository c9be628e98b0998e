// What VTK needs of Qt, checked on a real (if unseen) screen: each of these once went wrong in some
// program.
#include "widgets/scene3d/vtk_view.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QOpenGLContext>
#include <QScreen>
#include <QTest>
#include <QWheelEvent>
#include <memory>

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

namespace alltact::test {
namespace {

constexpr int kPatience_ms = 10000;

/// A view of a red sphere on blue ground; what it shows is grabbed from the screen.
class Ball {
 public:
  explicit Ball(QWidget* parent = nullptr) : view(new VtkView(parent)) {
    const vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    const vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(1, 0, 0);
    actor->GetProperty()->LightingOff();
    renderer->AddActor(actor);
    renderer->SetBackground(0, 0, 1);
    view->render_window()->AddRenderer(renderer);
  }
  [[nodiscard]] vtkCamera* camera() const { return renderer->GetActiveCamera(); }
  [[nodiscard]] bool wait_for_picture() const {
    return QTest::qWaitFor([this] { return view->renders() > 0; }, kPatience_ms);
  }

  vtkNew<vtkRenderer> renderer;
  VtkView* view;
};

QImage picture_of(VtkView& view) {
  QTest::qWait(50);
  return view.grabFramebuffer();
}

/// Red in the middle, blue in the corners, opaque everywhere.
void expect_the_ball(VtkView& view) {
  const QImage image = picture_of(view);
  const QSize pixels = (QSizeF(view.size()) * view.devicePixelRatioF()).toSize();
  EXPECT_EQ(image.size(), pixels);
  EXPECT_EQ(image.pixelColor(image.width() / 2, image.height() / 2), QColor(255, 0, 0));
  EXPECT_EQ(image.pixelColor(4, 4), QColor(0, 0, 255));
  EXPECT_EQ(image.pixelColor(image.width() - 5, image.height() - 5), QColor(0, 0, 255));
  int see_through = 0;
  for (int y = 0; y < image.height(); y += 7)
    for (int x = 0; x < image.width(); x += 7) see_through += image.pixelColor(x, y).alpha() < 255;
  EXPECT_EQ(see_through, 0);
}

std::unique_ptr<QMainWindow> window_around(QWidget* view) {
  auto window = std::make_unique<QMainWindow>();
  window->setCentralWidget(view);
  window->resize(640, 480);
  window->show();
  return window;
}

class VtkViewTest : public testing::Test {
 protected:
  Ball ball_;
};

TEST_F(VtkViewTest, ShowsWhatVtkRenders) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  EXPECT_TRUE(ball_.view->can_draw());
  expect_the_ball(*ball_.view);
}

TEST_F(VtkViewTest, ReachesTheScreenAndNotOnlyItsOwnMemory) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  ASSERT_TRUE(ball_.wait_for_picture());
  QTest::qWait(300);
  const QImage screen = window->screen()->grabWindow(window->winId()).toImage();
  ASSERT_FALSE(screen.isNull());
  EXPECT_EQ(screen.pixelColor(screen.width() / 2, screen.height() / 2), QColor(255, 0, 0));
  EXPECT_EQ(screen.pixelColor(6, screen.height() / 2), QColor(0, 0, 255));
}

TEST_F(VtkViewTest, CountsInDevicePixels) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  const double ratio = ball_.view->devicePixelRatioF();
  const QSize pixels = (QSizeF(ball_.view->size()) * ratio).toSize();
  const int* size = ball_.view->render_window()->GetSize();
  EXPECT_EQ(QSize(size[0], size[1]), pixels);
  EXPECT_EQ(ball_.view->render_window()->GetDPI(), std::lround(72 * ratio));
  if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR")) {
    EXPECT_EQ(ratio, qEnvironmentVariable("QT_SCALE_FACTOR").toDouble());
  }
}

TEST_F(VtkViewTest, FollowsTheWindowsSize) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  for (const QSize& size : {QSize(500, 300), QSize(300, 500)}) {
    const int before = ball_.view->renders();
    window->resize(size);
    ASSERT_TRUE(QTest::qWaitFor([&] { return ball_.view->renders() > before; }, kPatience_ms));
    expect_the_ball(*ball_.view);
  }
}

TEST_F(VtkViewTest, IsNotRenderedAgainByRepaints) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  QTest::qWait(200);
  const int before = ball_.view->renders();
  for (int i = 0; i < 5; ++i) {
    ball_.view->update();
    QTest::qWait(30);
  }
  EXPECT_EQ(ball_.view->renders(), before);
  for (int i = 0; i < 5; ++i) ball_.view->draw_later();
  QTest::qWait(100);
  EXPECT_EQ(ball_.view->renders(), before + 1) << "what is asked for at once is drawn once";
}

TEST_F(VtkViewTest, SurvivesFloatingAndDockingAgain) {
  QMainWindow window;
  window.setCentralWidget(new QWidget);
  auto* dock = new QDockWidget(QStringLiteral("3D"));
  dock->setWidget(ball_.view);
  window.addDockWidget(Qt::LeftDockWidgetArea, dock);
  window.resize(800, 600);
  window.show();
  ASSERT_TRUE(ball_.wait_for_picture());
  for (const bool floats : {true, false, true, false}) {
    dock->setFloating(floats);
    QTest::qWait(300);
    expect_the_ball(*ball_.view);
  }
  const bool is_shared = QCoreApplication::testAttribute(Qt::AA_ShareOpenGLContexts);
  if (is_shared) {
    EXPECT_EQ(ball_.view->contexts_made(), 1);
  } else {
    EXPECT_GT(ball_.view->contexts_lost(), 1) << "contexts are lost here, or this tests nothing";
  }
}

TEST_F(VtkViewTest, SurvivesHidingAndShowing) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  for (int i = 0; i < 3; ++i) {
    ball_.view->hide();
    QTest::qWait(50);
    ball_.view->show();
    QTest::qWait(100);
    expect_the_ball(*ball_.view);
    window->hide();
    QTest::qWait(50);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    expect_the_ball(*ball_.view);
  }
}

TEST_F(VtkViewTest, LivesBesideAnotherAndOutlivesIt) {
  auto* both = new QWidget;
  both->resize(800, 300);
  auto other = std::make_unique<Ball>(both);
  ball_.view->setParent(both);
  ball_.view->setGeometry(0, 0, 400, 300);
  other->view->setGeometry(400, 0, 400, 300);
  const auto window = window_around(both);
  ASSERT_TRUE(ball_.wait_for_picture());
  ASSERT_TRUE(other->wait_for_picture());
  expect_the_ball(*ball_.view);
  expect_the_ball(*other->view);
  delete other->view;
  const int before = ball_.view->renders();
  ball_.view->draw_later();
  ASSERT_TRUE(QTest::qWaitFor([&] { return ball_.view->renders() > before; }, kPatience_ms));
  expect_the_ball(*ball_.view);
}

TEST_F(VtkViewTest, TurnsTheCameraByDragging) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  const auto place = [&] {
    const double* at = ball_.camera()->GetPosition();
    return std::array{at[0], at[1], at[2]};
  };
  const auto before = place();
  QTest::mousePress(ball_.view, Qt::LeftButton, {}, {200, 200});
  QTest::mouseMove(ball_.view, {240, 210});
  QTest::mouseMove(ball_.view, {280, 220});
  EXPECT_NE(place(), before);
  QTest::mouseRelease(ball_.view, Qt::LeftButton, {}, {280, 220});
  const auto after = place();
  QTest::mouseMove(ball_.view, {100, 100});
  EXPECT_EQ(place(), after) << "hovering turns nothing";
}

TEST_F(VtkViewTest, ComesCloserByTheWheelStepByStep) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  const auto wheel = [&](int eighths) {
    const QPointF at(300, 200);
    QWheelEvent event(at, ball_.view->mapToGlobal(at), {}, {0, eighths}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(ball_.view, &event);
  };
  const double before = ball_.camera()->GetDistance();
  wheel(60);
  EXPECT_EQ(ball_.camera()->GetDistance(), before) << "half a step is kept for later";
  wheel(60);
  const double closer = ball_.camera()->GetDistance();
  EXPECT_LT(closer, before);
  wheel(-120);
  EXPECT_NEAR(ball_.camera()->GetDistance(), before, 1e-9);
}

TEST_F(VtkViewTest, LettersDoNothingOfVtksOwn) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  ball_.view->setFocus();
  for (const char key : {'3', 'w', 'e', 'q', 'r'}) QTest::keyClick(ball_.view, key);
  QTest::qWait(50);
  EXPECT_EQ(ball_.view->render_window()->GetStereoRender(), 0);
  expect_the_ball(*ball_.view);
}

TEST_F(VtkViewTest, TimersRunOnQtsLoop) {
  const auto window = window_around(ball_.view);
  ASSERT_TRUE(ball_.wait_for_picture());
  vtkRenderWindowInteractor* interactor = ball_.view->interactor();
  int once = 0, again = 0;
  const int single = interactor->CreateOneShotTimer(10);
  const int repeating = interactor->CreateRepeatingTimer(10);
  struct Counts {
    int single, repeating, *once, *again;
  } counts{single, repeating, &once, &again};
  const vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&counts);
  command->SetCallback([](vtkObject*, unsigned long, void* to, void* id) {
    auto* of = static_cast<Counts*>(to);
    *of->once += *static_cast<int*>(id) == of->single;
    *of->again += *static_cast<int*>(id) == of->repeating;
  });
  const unsigned long observer = interactor->AddObserver(vtkCommand::TimerEvent, command);
  EXPECT_TRUE(QTest::qWaitFor([&] { return again > 3; }, kPatience_ms));
  EXPECT_EQ(once, 1);
  interactor->DestroyTimer(repeating);
  const int so_far = again;
  QTest::qWait(60);
  EXPECT_EQ(again, so_far);
  interactor->RemoveObserver(observer);
}

TEST_F(VtkViewTest, IsSupportedHere) {
  EXPECT_TRUE(VtkView::is_supported());
  delete ball_.view;  // never shown, so it never had a context
}

/// On Qt's offscreen platform there is no OpenGL.
TEST(VtkViewWithoutOpenGl, IsKnownBeforeAnythingBreaks) { EXPECT_FALSE(VtkView::is_supported()); }

}  // namespace
}  // namespace alltact::test
