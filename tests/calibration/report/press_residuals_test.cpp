#include "calibration/report/press_errors.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(ZoneSentence, TellsOfEveryZoneWhetherPressedOnceOftenOrNever) {
  const std::vector<ZoneError> zones{{Message::typed("base"), 2, 0.004},
                                     {Message::typed("middle"), 1, 0.0034},
                                     {Message::typed("tip"), 0, {}}};
  EXPECT_EQ(zone_sentence(zones).english(),
            "base 0.004 mm (2 presses), middle 0.003 mm (1 press), tip unknown: no press there");
  EXPECT_TRUE(zone_sentence({}).empty());
}

}  // namespace
}  // namespace alltact
