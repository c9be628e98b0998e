// When a contact holds still: told once, and not while it moves.
#include "core/live/stationary_contact.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr double kFrame_s = 1.0 / 30;

/// Feeds frames and counts how often it says so.
class Contact {
 public:
  int hold(double seconds, const Eigen::Vector2d& speed_mm_s = {0, 0}, double deeper_part_s = 0) {
    int told = 0;
    for (double t = 0; t < seconds; t += kFrame_s) {
      patch_.place_mm += kFrame_s * speed_mm_s;
      patch_.darkness *= 1 + kFrame_s * deeper_part_s;
      // What noise does to it.
      DarkPatch seen = patch_;
      seen.place_mm.x() += (frame_ % 2 != 0 ? 0.03 : -0.03);
      seen.darkness *= frame_ % 3 == 0 ? 1.01 : 0.995;
      ++frame_;
      told += watch_.add(seen, time_ += kFrame_s) ? 1 : 0;
    }
    return told;
  }
  int lift(double seconds) {
    int told = 0;
    for (double t = 0; t < seconds; t += kFrame_s)
      told += watch_.add(std::nullopt, time_ += kFrame_s) ? 1 : 0;
    return told;
  }

 private:
  StationaryContactDetector watch_;
  DarkPatch patch_{{30, 2}, 0.3};
  double time_ = 100;
  int frame_ = 0;
};

TEST(StationaryContactDetector, TellsOnceOfAContactThatHoldsStill) {
  Contact contact;
  EXPECT_EQ(contact.hold(0.35), 0) << "too short yet";
  EXPECT_EQ(contact.hold(0.2), 1);
  EXPECT_EQ(contact.hold(5), 0);
}

TEST(StationaryContactDetector, TellsAgainAfterLiftingAndAfterMovingOn) {
  Contact contact;
  EXPECT_EQ(contact.hold(1), 1);
  EXPECT_EQ(contact.lift(0.2), 0);
  EXPECT_EQ(contact.hold(1), 1);
  EXPECT_EQ(contact.hold(0.5, {6, 0}), 0);  // 3 mm further
  EXPECT_EQ(contact.hold(1), 1);
  EXPECT_EQ(contact.hold(0.5, {2, 0}), 0);  // 1 mm: still the same place
  EXPECT_EQ(contact.hold(2), 0);
}

TEST(StationaryContactDetector, NeverTellsOfWhatMovesOrIsPressedIn) {
  Contact sliding;
  EXPECT_EQ(sliding.hold(4, {0, 3}), 0);
  Contact pressing;
  EXPECT_EQ(pressing.hold(2, {0, 0}, 0.5), 0);
  Contact empty;
  EXPECT_EQ(empty.lift(3), 0);
}

TEST(StationaryContactDetector, DoesNotCountATimeWithoutFrames) {
  StationaryContactDetector watch;
  const DarkPatch patch{{30, 2}, 0.3};
  EXPECT_FALSE(watch.add(patch, 1.0));
  EXPECT_FALSE(watch.add(patch, 1.1));
  EXPECT_FALSE(watch.add(patch, 9.0)) << "nobody knows what it did meanwhile";
}

}  // namespace
}  // namespace alltact
