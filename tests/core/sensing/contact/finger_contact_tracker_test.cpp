#include "core/sensing/contact/finger_contact.h"
#include "tests/core/simulation/effects/pushed_scene.h"

#include <random>

namespace alltact {
namespace {

ContactEvidence strong(double time_s, double strength) {
  ContactEvidence seen;
  seen.time_s = time_s;
  seen.push = strength;
  return seen;
}

TEST(FingerContactTracker, BeginsAndEndsOnceWhateverChattersAroundTheThreshold) {
  std::mt19937 random(12);
  std::normal_distribution<double> noise(0.0, 0.08);
  for (const double rate : {15.0, 30.0, 60.0, 120.0}) {
    FingerContactTracker contacts;
    int began = 0, touched = 0, crossings = 0;
    bool was = false;
    const int n = static_cast<int>(4 * rate);
    for (int i = 0; i < n; ++i) {
      const double t = i / rate;
      // Rests, rises slowly through the threshold, stays near it, falls slowly.
      const double level = t < 1   ? 0.2
                           : t < 2 ? 0.2 + 0.9 * (t - 1)
                           : t < 3 ? 1.05
                                   : 1.05 * (4 - t);
      const double strength = level + noise(random);
      crossings += (strength >= 1) != was;
      was = strength >= 1;
      const auto told = contacts(strong(t, strength));
      began += told && told->is_new;
      touched += told.has_value();
    }
    EXPECT_EQ(began, 1) << rate;
    EXPECT_GT(crossings, 4) << "the sequence chatters";
    EXPECT_NEAR(touched / rate, 1.6, 0.25) << rate;
  }
}

TEST(FingerContactTracker, OneStrayFrameIsNoContactAndOneWeakFrameNoEnd) {
  FingerContactTracker contacts;
  for (int i = 0; i < 60; ++i)
    EXPECT_FALSE(contacts(strong(i / 30.0, i % 7 == 3 ? 5.0 : 0.1))) << i;
  contacts.forget();
  for (int i = 0; i < 60; ++i) {
    const auto told = contacts(strong(i / 30.0, i % 7 == 3 ? 0.0 : 3.0));
    ASSERT_TRUE(told) << i;
    EXPECT_EQ(told->is_new, i == 0);
    EXPECT_NEAR(told->held_s.value(), i / 30.0, 1e-12);
  }
}

TEST(FingerContactTracker, LostFramesAndUnsteadyTimesDoNotMatter) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> one(0.0, 1.0);
  for (int run = 0; run < 200; ++run) {
    const double on = 0.5 + one(random), off = on + 0.3 + one(random);
    FingerContactTracker contacts;
    std::optional<double> first, last;
    int began = 0;
    double longest = 0, before = 0;
    for (double t = 0; t < off + 0.7;) {
      const auto told = contacts(strong(t, t >= on && t < off ? 2.0 : 0.0));
      began += told && told->is_new;
      if (told && !first) first = t;
      if (told) last = t;
      longest = std::max(longest, t - before);
      before = t;
      t += one(random) < 0.15 ? 0.2 * one(random) : 0.004 + 0.03 * one(random);
    }
    ASSERT_TRUE(first && last);
    EXPECT_EQ(began, 1);
    // Told within the duration and the gap that it fell into and the one behind.
    EXPECT_GE(*first, on);
    EXPECT_LT(*first, on + FingerContactTracker::kOnset_s + 2 * longest);
    EXPECT_GE(*last + longest, off);
    EXPECT_LT(*last, off + FingerContactTracker::kRelease_s + longest);
  }
}

TEST(FingerContactTracker, WithoutTimesEachFrameCountsByItself) {
  FingerContactTracker contacts;
  ContactEvidence seen;
  for (const auto& [strength, touched] :
       {std::pair{0.9, false}, {1.0, true}, {0.7, true}, {0.5, false}, {0.9, false}, {1.1, true}}) {
    seen.push = strength;
    const auto told = contacts(seen);
    EXPECT_EQ(told.has_value(), touched) << strength;
    EXPECT_FALSE(told && (told->held_s || told->is_slipping));
  }
}

TEST(FingerContactTracker, APauseOrTimeGoingBackBeginsAnew) {
  for (const double next : {9.0, -1.0}) {
    FingerContactTracker contacts;
    for (int i = 0; i < 5; ++i) (void)contacts(strong(i / 30.0, 2));
    const auto told = contacts(strong(next, 2));
    ASSERT_TRUE(told);
    EXPECT_TRUE(told->is_new);
    EXPECT_EQ(told->held_s.value(), 0);
    contacts.forget();
    (void)contacts(strong(0, 2));
    EXPECT_FALSE(contacts(strong(next, 0.7)));
  }
}

ContactEvidence deflected(double time_s, PushedFace face) {
  ContactEvidence seen = strong(time_s, 4);
  seen.deflection = {face, Eigen::Vector3d::UnitY(), 1.0, std::nullopt};
  return seen;
}

TEST(FingerContactTracker, AnotherFaceIsAnotherContact) {
  FingerContactTracker contacts;
  constexpr double kRate = 100;
  // From the back for 3 s, then from the upper side for 2 s; one frame of each shows the other.
  const auto truth = [](int i) { return i < 300 ? PushedFace::kBack : PushedFace::kUpper; };
  int began = 0;
  double longest_s = 0;
  for (int i = 0; i < 500; ++i) {
    const bool is_stray = i == 150 || i == 400;
    const auto seen = contacts(deflected(i / kRate, truth(is_stray ? 500 - i : i)));
    ASSERT_TRUE(seen) << i;
    began += seen->is_new;
    longest_s = std::max(longest_s, seen->held_s.value());
    if (i < 300 || i >= 300 + kRate * FingerContactTracker::kRelease_s + 1) {
      EXPECT_EQ(seen->face, truth(i)) << i;
      EXPECT_NEAR(seen->held_s.value(), (i - (i < 300 ? 0 : 300)) / kRate, 1e-9) << i;
    }
  }
  EXPECT_EQ(began, 2);
  EXPECT_LT(longest_s, 3.1);
}

TEST(FingerContactTracker, PressedSkinBeginsAContactAtOnce) {
  FingerContactTracker contacts;
  for (int i = 0; i < 90; ++i) (void)contacts(deflected(i / 30.0, PushedFace::kLower));
  ContactEvidence pressed = deflected(3.0, PushedFace::kLower);
  pressed.depth = 2;
  pressed.indentation.emplace();
  pressed.indentation->position.along_mm = 46;
  const auto contact = contacts(pressed);
  ASSERT_TRUE(contact && contact->position);
  EXPECT_EQ(contact->face, PushedFace::kContact);
  EXPECT_TRUE(contact->is_new);
  EXPECT_EQ(contact->held_s, 0);
}

// The share of frames told as slipping, of a simulated push, its place told with that noise.
struct Slips {
  int slipping = 0, frames = 0;
};
Slips slips_of(const std::string& push, double sd_mm, unsigned seed, double skin_drift_mm = 0) {
  const int n = 45;
  const PlacedScene placed(with_frames(n, pushing(push) + kPushedBody));
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, sd_mm);
  FingerContactTracker contacts;
  Slips slips;
  for (int i = 0; i < n; ++i) {
    const FrameGeometry truth = placed.at(i);
    ContactEvidence seen = strong(i / 30.0, truth.contacts.empty() ? 0 : 5);
    if (!truth.contacts.empty()) {
      // Where the base comes into the picture, places along the face begin.
      const double skin_mm = skin_drift_mm * i / n;
      const Eigen::Vector2d place_mm(truth.contacts[0].along_mm + skin_mm + noise(random),
                                     truth.contacts[0].across_mm + noise(random));
      auto& indentation = seen.indentation.emplace();
      indentation.on_skin_mm = place_mm - Eigen::Vector2d(skin_mm, 0);
      indentation.on_skin_covariance_mm2 = sd_mm * sd_mm * Eigen::Matrix2d::Identity();
    }
    const auto told = contacts(seen);
    if (i < 12) continue;  // once the window is full
    ++slips.frames;
    slips.slipping += told && told->is_slipping.value_or(false);
  }
  return slips;
}

TEST(FingerContactTracker, ABallThatSlidesSlipsAndOneThatIsDraggedOrPressedHarderDoesNot) {
  Parameters random(8);
  Slips sliding, dragged, pressed;
  const auto add = [](Slips& all, const Slips& one) {
    all.slipping += one.slipping;
    all.frames += one.frames;
  };
  for (unsigned run = 0; run < 12; ++run) {
    const double s = random.between(45, 75), y = random.between(-4, 4), sd = random.between(0, 0.1);
    const double mm_per_s = random.between(4, 20), drift = random.between(-3, 3);
    const double way = mm_per_s * 1.5 * (run % 2 == 0 ? 1 : -1);
    const std::string ball = fmt::format("radius_mm: 4, y_mm: {}", y);
    add(sliding,
        slips_of(fmt::format("{}, force_N: 1, s_mm: [{{at: 0, is: {}}}, {{at: 44, is: {}}}]", ball,
                             s, s + way),
                 sd, run, drift));
    add(dragged,
        slips_of(fmt::format("{}, force_N: 1, s_mm: {}, friction: 0.9, along_N: [{{at: 0, is: 0}}, "
                             "{{at: 44, is: 0.8}}]",
                             ball, s),
                 sd, run, drift));
    add(pressed,
        slips_of(fmt::format("{}, s_mm: {}, force_N: [{{at: 0, is: 0.2}}, {{at: 44, is: 1.5}}]",
                             ball, s),
                 sd, run, drift));
  }
  printf("slipping: sliding %d of %d frames, dragged %d of %d, pressed harder %d of %d\n",
         sliding.slipping, sliding.frames, dragged.slipping, dragged.frames, pressed.slipping,
         pressed.frames);
  EXPECT_GE(sliding.slipping, 0.98 * sliding.frames);
  EXPECT_EQ(dragged.slipping, 0);
  EXPECT_EQ(pressed.slipping, 0);
}

}  // namespace
}  // namespace alltact
