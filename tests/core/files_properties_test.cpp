// What is saved, loaded and saved again is the same bytes, whatever the numbers.
#include "core/base/atomic_file.h"
#include "core/camera/camera.h"
#include "core/finger/finger_yaml.h"
#include "core/sensing/reference/reference_library.h"
#include "tests/support/temporary_folder.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace alltact {
namespace {

/// Any finite number of the size of `scale`, with all its digits.
double any_number(double scale) {
  const auto whole = *rc::gen::inRange<long>(-(1L << 52), 1L << 52);
  return scale * static_cast<double>(whole) / static_cast<double>(1L << 52);
}

CameraParameters any_camera() {
  CameraParameters p;
  p.model = *rc::gen::element(CameraModel::kPinhole, CameraModel::kBrown, CameraModel::kFisheye,
                              CameraModel::kOrthographic);
  p.width_px = *rc::gen::inRange(16, 4000), p.height_px = *rc::gen::inRange(16, 4000);
  p.cx_px = 0.5 * p.width_px + any_number(0.2 * p.width_px);
  p.cy_px = 0.5 * p.height_px + any_number(0.2 * p.height_px);
  p.orientation =
      *rc::gen::element(Orientation::kNone, Orientation::kFlipU, Orientation::kFlipV,
                        Orientation::kRotate180, Orientation::kRotate90, Orientation::kRotate270);
  if (p.model == CameraModel::kOrthographic) {
    p.mm_per_px = 1e-3 + std::abs(any_number(1.0));
    return p;
  }
  // Long lenses: few of them fold over inside the picture.
  p.fx_px = 1.5 * p.width_px * (1.0 + any_number(0.3));
  p.fy_px = 1.5 * p.width_px * (1.0 + any_number(0.3));
  const int most = p.model == CameraModel::kBrown ? 5 : p.model == CameraModel::kFisheye ? 4 : 0;
  const int count = *rc::gen::inRange(0, most + 1);
  for (int i = 0; i < count; ++i) p.distortion.push_back(any_number(i < 2 ? 0.1 : 0.002));
  return p;
}

TEST(SavedFiles, CamerasAreTheSameBytesAgain) {
  const test::TemporaryFolder folder;
  const bool holds = rc::check("camera files", [&] {
    const CameraParameters camera = any_camera();
    RC_PRE(check_camera_range(camera).ok());
    const LensRecord record{{"fx_sd_px", std::to_string(*rc::gen::inRange(0, 1000))}};
    RC_ASSERT(save_camera(folder / "one.yaml", camera, record).ok());
    const auto loaded = load_camera(folder / "one.yaml");
    RC_ASSERT(loaded.ok());
    RC_ASSERT(loaded->parameters == camera);
    RC_ASSERT(save_camera(folder / "two.yaml", loaded->parameters, loaded->lens).ok());
    RC_ASSERT(*read_file(folder / "one.yaml") == *read_file(folder / "two.yaml"));
  });
  EXPECT_TRUE(holds);
}

MarkerTable any_table() {
  const int frames = *rc::gen::inRange(1, 5), markers = 2 * *rc::gen::inRange(2, 6);
  MarkerTable table;
  table.layouts.resize(frames, 2 * markers);
  int number = 0;
  for (int i = 0; i < frames; ++i) {
    number += *rc::gen::inRange(1, 1000);
    table.frames.push_back(number);
    table.seen.emplace_back();
    for (int m = 0; m < markers; ++m) {
      table.layouts(i, 2 * m) = any_number(*rc::gen::element(1e-9, 1.0, 2000.0));
      table.layouts(i, 2 * m + 1) = any_number(2000.0);
      table.seen.back().push_back(*rc::gen::inRange<char>(0, 2));
    }
  }
  table.typical.resize(static_cast<std::size_t>(markers));
  for (Dot& dot : table.typical) {
    dot.radius_px = 1e-3 + std::abs(any_number(30.0));
    dot.contrast = 1.0 + std::abs(any_number(200.0));
  }
  return table;
}

TEST(SavedFiles, MarkerTablesAreTheSameBytesAgain) {
  const test::TemporaryFolder folder;
  const bool holds = rc::check("marker tables", [&] {
    const MarkerTable table = any_table();
    const int markers = static_cast<int>(table.typical.size());
    RC_ASSERT(table.save(folder / "one.csv").ok());
    const auto loaded = MarkerTable::load(folder / "one.csv", markers);
    RC_ASSERT(loaded.ok());
    RC_ASSERT(loaded->layouts == table.layouts);
    RC_ASSERT(loaded->save(folder / "two.csv").ok());
    RC_ASSERT(*read_file(folder / "one.csv") == *read_file(folder / "two.csv"));
  });
  EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace alltact
