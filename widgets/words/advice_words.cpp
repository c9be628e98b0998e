// What a calibration is worth and what to press next, zone by zone.
#include "widgets/words/catalogue.h"

#include <QtGlobal>

namespace alltact {
namespace {

constexpr const char* kAll[] = {
    QT_TRANSLATE_NOOP("Library", "in the middle of the face"),
    QT_TRANSLATE_NOOP("Library", "%1 mm from the middle on the %2 side"),
    QT_TRANSLATE_NOOP("Library", "upper"),
    QT_TRANSLATE_NOOP("Library", "lower"),
    QT_TRANSLATE_NOOP("Library", "%1 mm from the base, %2"),
    QT_TRANSLATE_NOOP("Library",
                      "least certain is the scale: all depths may be too large or too small "
                      "together, by %1 mm at %2 mm (one standard deviation)"),
    QT_TRANSLATE_NOOP("Library",
                      "least certain is how shallow and deep go together: by %1 mm at %2 mm (one "
                      "standard deviation), the other way at the other end"),
    QT_TRANSLATE_NOOP("Library",
                      "a ball 1 % larger than said makes depths %1 % %2; the residual is %3 mm "
                      "with a radius 1 % smaller, %4 mm as given, %5 mm with one 1 % larger"),
    QT_TRANSLATE_NOOP("Library", "smaller"),
    QT_TRANSLATE_NOOP("Library", "larger"),
    QT_TRANSLATE_NOOP("Library", "a wrong radius would be noticed"),
    QT_TRANSLATE_NOOP("Library",
                      "the presses cannot show a wrong radius, so measure the ball to a hundredth "
                      "of a millimetre"),
    QT_TRANSLATE_NOOP("Library", "press next: at another place, 0.5 to 1 mm deep"),
    QT_TRANSLATE_NOOP(
        "Library",
        "press next: %1, %2 mm deep; no press tells whether the mapping holds in that third"),
    QT_TRANSLATE_NOOP("Library",
                      "enough: one press more would take the standard deviation of depth from %1 "
                      "mm to %2 mm at best"),
    QT_TRANSLATE_NOOP("Library",
                      "press next: %1, %2 mm deep; that would take the standard deviation of depth "
                      "from %3 mm to %4 mm"),
    QT_TRANSLATE_NOOP("Library", "left"),
    QT_TRANSLATE_NOOP("Library", "middle"),
    QT_TRANSLATE_NOOP("Library", "right"),
    QT_TRANSLATE_NOOP("Library", "base"),
    QT_TRANSLATE_NOOP("Library", "tip"),
    QT_TRANSLATE_NOOP("Library", "upper half"),
    QT_TRANSLATE_NOOP("Library", "lower half"),
    QT_TRANSLATE_NOOP("Library", "%1 %2 mm (%3 press)"),
    QT_TRANSLATE_NOOP("Library", "%1 %2 mm (%3 presses)"),
    QT_TRANSLATE_NOOP("Library", "%1 unknown: no press there"),
    QT_TRANSLATE_NOOP("Library", "must be above 0 and at most 1000"),
    QT_TRANSLATE_NOOP("Library", "the ball's radius in mm"),
    QT_TRANSLATE_NOOP("Library", "is not the centre of a ball before the camera"),
    QT_TRANSLATE_NOOP("Library", "x, y, z in mm"),
    QT_TRANSLATE_NOOP("Library", "the balls' radii in mm"),
    QT_TRANSLATE_NOOP("Library", "must be above 0 and at most 100"),
    QT_TRANSLATE_NOOP("Library", "a depth and its standard deviation in mm"),
    QT_TRANSLATE_NOOP("Library", "the steps' heights in mm"),
    QT_TRANSLATE_NOOP("Library", "%1 mm of depth error on the very presses it was made from"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 mm of depth error to be expected (%2 mm in shape, on presses it had not "
                      "seen; %3 mm as a whole)"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 mm of depth error to be expected (%2 mm in shape, on presses it had not "
                      "seen; %3 mm as a whole; %4 mm of a single pixel)"),
    QT_TRANSLATE_NOOP("Library", "not fit to measure with"),
    QT_TRANSLATE_NOOP("Library",
                      "press again with a clean ball of the radius given, whole on the face"),
    QT_TRANSLATE_NOOP("Library", "unproven"),
    QT_TRANSLATE_NOOP("Library", "none was left out to show what happens on others"),
    QT_TRANSLATE_NOOP(
        "Library", "one press cannot show what happens on others, add presses of different depth"),
    QT_TRANSLATE_NOOP("Library", "usable for contact and its place"),
    QT_TRANSLATE_NOOP("Library", "usable"),
    QT_TRANSLATE_NOOP("Library", "good"),
    QT_TRANSLATE_NOOP("Library", "add presses of different depth and place to measure relief"),
    QT_TRANSLATE_NOOP("Library", "The %1 was not taken with one setting of camera and light: %2"),
    QT_TRANSLATE_NOOP("Library", "Lock them, and record it again"),
    QT_TRANSLATE_NOOP("Library", "reference"),
    QT_TRANSLATE_NOOP("Library", "set of presses"),
    QT_TRANSLATE_NOOP("Library", "presses"),
    QT_TRANSLATE_NOOP("Library", "The %1 and the %2 were taken with other settings: %3"),
    QT_TRANSLATE_NOOP("Library",
                      "Depth comes from comparing their brightness: record one of them again"),
    QT_TRANSLATE_NOOP("Library", "The finger was calibrated with other settings: %1"),
    QT_TRANSLATE_NOOP("Library", "Set them as they were, or calibrate again"),
    QT_TRANSLATE_NOOP("Library", "%1 was %2 and is %3"),
};

}  // namespace

const Patterns kAdviceWords = kAll;

}  // namespace alltact
