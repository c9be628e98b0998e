// The pictures of the first page that people read of this program. ALLTACT_RENEW_HELP=1 keeps what
// is shown now: look at them before committing.
#include "tests/studio/studio_rig.h"
#include "tests/support/same_everywhere.h"
#include "tests/support/unlike_part.h"
#include "widgets/image/overlays.h"

#include <QPainter>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

void expect_in_readme(const QImage& shown, const char* name) {
  const QString file =
      QStringLiteral(ALLTACT_SOURCE_DIR "/resources/pictures/%1").arg(QLatin1String(name));
  const QImage now = shown.convertToFormat(QImage::Format_RGB888);
  if (qEnvironmentVariableIsSet("ALLTACT_RENEW_HELP")) {
    ASSERT_TRUE(now.save(file, "PNG", 0));
    return;
  }
  const QImage kept(file);
  ASSERT_FALSE(kept.isNull()) << name << " is missing";
  EXPECT_EQ(kept.size(), now.size()) << name;
  EXPECT_LE(unlike_part(now, kept), kMostUnlike) << name;
}

bool shows_depth(Studio& studio) {
  return wait_until(
      [&] {
        const auto& view = studio.session().view();
        return view && view->depth_layer;
      },
      30000);
}

TEST(ReadmePictures, TheStudioIsLikeTheWindow) {
  const SameEverywhere same;
  Studio studio(simulated());
  ASSERT_TRUE(shows_depth(studio));
  QTest::qWait(600);
  expect_in_readme(studio.window().grab().toImage(), "studio.png");
}

/// What the camera sees beside the depth of every pixel of the face.
TEST(ReadmePictures, APressAndItsDepthAreAsMeasured) {
  const SameEverywhere same;
  constexpr QSize kHalf(470, 270);
  constexpr int kBetweenHalves = 20;
  Studio studio(simulated());
  ASSERT_TRUE(shows_depth(studio));
  const auto view = studio.session().view();
  QImage both(2 * kHalf.width() + kBetweenHalves, kHalf.height(), QImage::Format_RGB32);
  both.fill(Qt::white);
  QPainter painter(&both);
  const auto draw = [&](const cv::Mat& grey, std::vector<Overlay> overlays, int x) {
    ImageView image;
    image.setAttribute(Qt::WA_DontShowOnScreen);
    image.resize(kHalf);
    image.show_image(grey, std::move(overlays));
    image.show();
    painter.drawPixmap(x, 0, image.grab());
  };
  const cv::Mat& grey = view->result.grey;
  draw(grey, {}, 0);
  draw(cv::Mat(grey.size(), CV_8UC1, cv::Scalar(255)),
       {layer_overlay(view->depth_layer->pixels, view->depth_layer->at)},
       kHalf.width() + kBetweenHalves);
  painter.end();
  expect_in_readme(both, "press_and_depth.png");
}

}  // namespace
}  // namespace alltact::test
