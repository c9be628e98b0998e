// How far along its back or a side a finger is pushed: simulated fingers and bodies drawn at
// random.
#include "core/sensing/contact/push.h"
#include "tests/core/sensing/contact/drawn_push.h"
#include "tests/support/slow_run.h"

#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

struct AlongErrors {
  std::vector<double> off_mm;
  double normalised = 0, sd_mm = 0;
  int pushes = 0;
  void add(double off, double sd) {
    off_mm.push_back(std::abs(off));
    normalised += off * off / (sd * sd), sd_mm += sd;
  }
  [[nodiscard]] double told() const { return static_cast<double>(off_mm.size()); }
  [[nodiscard]] double nees() const { return normalised / told(); }
  [[nodiscard]] double at(double share) {
    std::sort(off_mm.begin(), off_mm.end());
    return off_mm[static_cast<std::size_t>(share * (told() - 1))];
  }
  void print(const std::string& what) {
    if (off_mm.empty()) return;
    std::printf(
        "[ figures  ] %s: told of %d of %d pushes; off by %.1f mm in the median, 95 %% %.1f, "
        "worst %.1f; mean sd %.1f; NEES %.2f\n",
        what.c_str(), static_cast<int>(told()), pushes, at(0.5), at(0.95), at(1), sd_mm / told(),
        nees());
  }
};

/// Pushes of the back of so many fingers, drawn with this seed.
AlongErrors errors_on_drawn(unsigned seed, int fingers) {
  AlongErrors errors;
  Parameters random(seed);
  for (int f = 0; f < fingers; ++f) {
    const PushedDrawnFinger finger(random, 2);
    const std::string body = drawn_body(random, 0, 1);
    const double along_mm = random.between(0.25, 0.9) * finger.length_mm;
    const auto told = told_of(
        finger.with(pushing(fmt::format("s_mm: {}, y_mm: {}, radius_mm: 5, force_N: {}", along_mm,
                                        random.between(-3, 3), reaching(random.between(0.3, 3))),
                            "back") +
                    body),
        random);
    if (!told || !told->contact) continue;  // more than it bears, or hardly anything
    ++errors.pushes;
    const FingerContact& contact = *told->contact;
    EXPECT_EQ(contact.face, PushedFace::kBack);
    EXPECT_EQ(contact.position.has_value(), contact.no_position.empty());
    if (!contact.position) continue;
    EXPECT_FALSE(contact.position->across_mm || contact.position->depth_mm);
    if (!contact.position->along_sd_mm) continue;  // the base is out of the picture
    errors.add(contact.position->along_mm - along_mm, *contact.position->along_sd_mm);
  }
  return errors;
}

void expect_as_sure_as_it_says(AlongErrors errors, int fingers) {
  errors.print("along the back");
  EXPECT_GT(errors.told(), 0.6 * fingers);
  EXPECT_LT(errors.at(0.5), 8);
  EXPECT_LT(errors.at(1), 25);
  EXPECT_LT(errors.sd_mm / errors.told(), 10);
  // Bodies are not drawn as they are taken to be, so that some less than 1 is to be expected, too.
  EXPECT_GT(errors.nees(), 0.3);
  EXPECT_LT(errors.nees(), 1.7);
}

TEST(PushAlong, TheBacksPlaceIsAsSureAsItSaysOnDrawnFingers) {
  constexpr int kFingers = 26;
  expect_as_sure_as_it_says(errors_on_drawn(5, kFingers), kFingers);
}

TEST(PushAlong, TheBacksPlaceIsAsSureAsItSaysOnMoreFingers) {
  if (!test::is_slow_run()) GTEST_SKIP() << "packaging/test --slow";
  constexpr int kFingers = 60;
  for (const unsigned seed : {5U, 2611U, 977U, 40123U})
    expect_as_sure_as_it_says(errors_on_drawn(seed, kFingers), kFingers);
}

TEST(PushAlong, ASideIsToldWithoutAPlaceAndWhy) {
  Parameters random(9);
  const PushedDrawnFinger finger(random);
  for (const char* face : {"upper", "lower"}) {
    const auto told =
        told_of(finger.with(pushing(fmt::format("s_mm: {}, y_mm: 0, radius_mm: 5, force_N: {}",
                                                0.7 * finger.length_mm, reaching(1)),
                                    face) +
                            drawn_body(random, 0.3, 0.6)),
                random);
    ASSERT_TRUE(told && told->contact);
    EXPECT_EQ(to_string(told->contact->face), face);
    EXPECT_FALSE(told->contact->position);
    EXPECT_NE(told->contact->no_position.english().find("side"), std::string::npos);
  }
}

}  // namespace
}  // namespace alltact
