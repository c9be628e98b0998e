// The 3D view of the place Inspect, once nothing moves it any more.
#pragma once

#include "tests/studio/studio_rig.h"
#include "tests/support/sanitized.h"
#include "widgets/inspect/inspect_pane.h"

#include <QTest>

namespace alltact::test {

/// Until it is shown, and what comes around it has taken its room. False: it was not, or goes on.
inline bool wait_for_standing_view(Studio& studio) {
  constexpr int kPatience_ms = 20000, kTries = 20, kMoment_ms = kIsSanitized ? 2500 : 500;
  const auto shown = [&]() -> FacePane* {
    auto* view = studio.window().findChild<FacePane*>();
    return view != nullptr && view->isVisible() && view->renders() > 0 ? view : nullptr;
  };
  if (!wait_until([&] { return shown() != nullptr; }, kPatience_ms)) return false;
  const FacePane& view = *shown();
  for (int i = 0; i < kTries; ++i) {
    const ViewPose before = view.scene().view_pose();
    const QSize size = view.size();
    QTest::qWait(kMoment_ms);
    if (view.size() == size && view.scene().view_pose() == before) return true;
  }
  return false;
}

}  // namespace alltact::test
