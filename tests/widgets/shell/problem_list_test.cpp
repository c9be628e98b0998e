// Notices: one line for all of them, newest first, with age and a way to send each away.
#include "widgets/shell/problem_list.h"

#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::ElementsAre;

Problem note(const char* what, const char* advice = "") {
  return {Meaning::kDoubtful, what, advice, {}, {}};
}

class Notices : public testing::Test {
 protected:
  Notices() {
    window_.resize(600, 300);
    list_.setGeometry(0, 0, 600, 40);
    window_.show();
  }
  void give(std::vector<Problem> problems) {
    list_.set_problems(std::move(problems));
    QTest::qWait(10);
  }
  void press(const QString& name) {
    auto* wanted = button(name);
    ASSERT_NE(wanted, nullptr) << name.toStdString();
    QTest::mouseClick(wanted, Qt::LeftButton);
    QTest::qWait(10);
  }
  [[nodiscard]] std::vector<std::string> told() const {
    std::vector<std::string> told;
    for (const Problem& problem : list_.problems()) told.push_back(problem.what.toStdString());
    return told;
  }
  [[nodiscard]] int rows() const {
    int rows = 0;
    for (const auto* row : window_.findChildren<QFrame*>(QStringLiteral("problem")))
      rows += row->isVisible() ? 1 : 0;
    return rows;
  }
  QToolButton* button(const QString& name) {
    for (auto* one : window_.findChildren<QToolButton*>())
      if (one->isVisible() && one->accessibleName() == name) return one;
    return nullptr;
  }
  QWidget window_;
  ProblemList& list_{*new ProblemList(&window_)};
};

TEST_F(Notices, TakeOneLineHoweverMany) {
  give({note("The first."), note("The second."), note("The third.")});
  EXPECT_EQ(rows(), 1);
  const int height = list_.sizeHint().height();
  give(
      {note("A single one that says so much that it never fits into the line which "
            "it has, so that its end is to be looked at by unfolding it first.",
            "And something to try beside.")});
  EXPECT_EQ(rows(), 1);
  EXPECT_LE(list_.sizeHint().height(), height);
  EXPECT_LT(list_.minimumSizeHint().width(), 300) << "nor do they widen the window";
}

TEST_F(Notices, TheNewestStandsFirst) {
  give({note("old")});
  QTest::qWait(5);
  give({note("old"), note("new")});
  EXPECT_THAT(told(), ElementsAre("new", "old"));
  QTest::qWait(5);
  give({note("newest"), note("old"), note("new")});
  EXPECT_THAT(told(), ElementsAre("newest", "new", "old"));
}

TEST_F(Notices, OneWhoseFiguresGrowIsStillTheSame) {
  give({note("3 frames are lost.")});
  QTest::qWait(5);
  give({note("3 frames are lost."), note("new")});
  QTest::qWait(5);
  give({note("1,204 frames are lost."), note("new")});
  EXPECT_THAT(told(), ElementsAre("new", "1,204 frames are lost."));
}

TEST_F(Notices, UnfoldToAllInFull) {
  give({note("The first.", "Do this."), note("The second.")});
  auto* fold = button("Show all in full");
  ASSERT_NE(fold, nullptr);
  EXPECT_TRUE(fold->text().contains('1')) << "one more";
  press("Show all in full");
  EXPECT_EQ(rows(), 2);
  press("Show only the newest");
  EXPECT_EQ(rows(), 1);
}

TEST_F(Notices, DismissedTheyStayAwayUntilTheyHappenAgain) {
  give({note("a"), note("b")});
  press("Dismiss: a");
  EXPECT_THAT(told(), ElementsAre("b"));
  give({note("a"), note("b")});
  EXPECT_THAT(told(), ElementsAre("b")) << "it goes on, and somebody knows";
  press("Dismiss: b");
  EXPECT_EQ(rows(), 0);
  give({});
  give({note("a")});
  EXPECT_THAT(told(), ElementsAre("a"));
  EXPECT_EQ(rows(), 1);
}

/// What is below the list stays where it is, whatever the list shows.
TEST_F(Notices, TakeTheSameRoomWithNoneWithOneAndUnfolded) {
  const int room = list_.minimumHeight();
  EXPECT_GT(room, 20);
  give({note("The first.", "Do this."), note("The second.")});
  EXPECT_LE(list_.sizeHint().height(), room);
  press("Show all in full");
  EXPECT_EQ(rows(), 2);
  EXPECT_LE(list_.sizeHint().height(), room);
  EXPECT_EQ(list_.height(), 40) << "what is shown lies over the window";
}

TEST_F(Notices, SayHowOldTheyAre) {
  give({note("a")});
  bool is_told = false;
  for (const auto* label : list_.findChildren<QLabel*>())
    is_told = is_told || (label->isVisible() && label->text() == "now");
  EXPECT_TRUE(is_told);
}

TEST(ElidedLabel, CutsAPathAtItsBeginning) {
  const QFontMetrics metrics{QFont()};
  const QString path = "/home/lab/measurements/2026/fingers/silicone/left-07";
  const QString cut = elided_path(path, metrics, metrics.horizontalAdvance(path) / 2);
  EXPECT_TRUE(cut.endsWith("left-07")) << cut.toStdString();
  EXPECT_LE(metrics.horizontalAdvance(cut), metrics.horizontalAdvance(path) / 2);
  EXPECT_EQ(elided_path(path, metrics, 10000), path);
}

}  // namespace
}  // namespace alltact
