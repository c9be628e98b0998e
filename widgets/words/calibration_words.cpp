// Calibrating: mapping, verdict, advice and what is kept of it.
#include "widgets/words/catalogue.h"

#include <QtGlobal>

namespace alltact {
namespace {

constexpr const char* kAll[] = {
    QT_TRANSLATE_NOOP("Library", "stopped before there was a solution"),
    QT_TRANSLATE_NOOP("Library", "solving: round %1, unknowns move by %2 mm"),
    QT_TRANSLATE_NOOP("Library", "no increasing mapping fits the presses"),
    QT_TRANSLATE_NOOP("Library", "the ball lies %1 mm deep in a layer of %2 mm"),
    QT_TRANSLATE_NOOP(
        "Library",
        "pressing less deep, and checking the ball's radius and the camera's scale in "
        "mm per px"),
    QT_TRANSLATE_NOOP("Library",
                      "leaving out presses with the largest residual, a lower degree, or checking "
                      "the ball's radius"),
    QT_TRANSLATE_NOOP("Library", "solving all presses together"),
    QT_TRANSLATE_NOOP("Library", "%1, because the %2 does not increase on all samples"),
    QT_TRANSLATE_NOOP("Library", "the solution is no mapping: %1"),
    QT_TRANSLATE_NOOP("Library", "more presses of different depth, or a lower degree"),
    QT_TRANSLATE_NOOP("Library",
                      "one press cannot separate the ball's depth from the mapping: add presses of "
                      "different depth at other places"),
    QT_TRANSLATE_NOOP("Library", "the presses do not determine every unknown: add presses"),
    QT_TRANSLATE_NOOP("Library",
                      "how presses become a mapping: all balls and the mapping in one fit; or, to "
                      "compare with, every ball from its dark border alone: the source paper's "
                      "way, a circle on the face, or the cone of the ball's outline"),
    QT_TRANSLATE_NOOP("Library",
                      "the mapping's curve; auto: whichever predicts presses left out best"),
    QT_TRANSLATE_NOOP("Library", "degree of the polynomial; 0: chosen by leaving presses out"),
    QT_TRANSLATE_NOOP(
        "Library",
        "which thickness of the layer brightness follows: along z, along its normal, or that along "
        "z projected onto the normal; auto: along the normal unless presses left out say "
        "otherwise"),
    QT_TRANSLATE_NOOP("Library",
                      "whether the mapping may vary slowly over the face, for uneven light or an "
                      "uneven layer; auto: when presses left out agree clearly better then"),
    QT_TRANSLATE_NOOP("Library", "the calibration failed: %1"),
    QT_TRANSLATE_NOOP("Library", "fewer presses"),
    QT_TRANSLATE_NOOP("Library", "stopped before the calibration was done"),
    QT_TRANSLATE_NOOP("Library", "the reference picture"),
    QT_TRANSLATE_NOOP("Library",
                      "the untouched picture of this sensor, at the size of its presses"),
    QT_TRANSLATE_NOOP("Library", "this is not the picture that the finger was calibrated with"),
    QT_TRANSLATE_NOOP("Library", "calibrating anew with the pictures that are there"),
    QT_TRANSLATE_NOOP("Library", "solving"),
    QT_TRANSLATE_NOOP("Library",
                      "stopped before the end: this is the best solution until then, without a "
                      "report; calibrating again from what is kept finishes it"),
    QT_TRANSLATE_NOOP("Library", "comparing with other methods"),
    QT_TRANSLATE_NOOP(
        "Library",
        "The finger has another reference than it was calibrated with: this is a new calibration"),
    QT_TRANSLATE_NOOP("Library",
                      "The finger's camera, face or markers are not what they were when it was "
                      "calibrated: this is a new calibration"),
    QT_TRANSLATE_NOOP(
        "Library",
        "The finger was calibrated by version %1: this is a new calibration, by version %2"),
    QT_TRANSLATE_NOOP("Library", "writing the report"),
    QT_TRANSLATE_NOOP("Library", "only a flat sensor has one untouched picture"),
    QT_TRANSLATE_NOOP(
        "Library", "leaving --reference out; this finger is compared with its reference recording"),
    QT_TRANSLATE_NOOP("Library", "is no checksum of 16 digits"),
    QT_TRANSLATE_NOOP("Library", "calibrating again"),
    QT_TRANSLATE_NOOP("Library", "names no press"),
    QT_TRANSLATE_NOOP("Library", "has %1 entries for %2 presses"),
    QT_TRANSLATE_NOOP("Library", "one for each press"),
    QT_TRANSLATE_NOOP("Library", "'%1' is no picture's name"),
    QT_TRANSLATE_NOOP("Library", "'%1' is no checksum of 16 digits"),
    QT_TRANSLATE_NOOP("Library", "names '%1' twice"),
    QT_TRANSLATE_NOOP("Library", "leave one of the two"),
    QT_TRANSLATE_NOOP("Library", "'%1' is not among the presses, and something is said of it"),
    QT_TRANSLATE_NOOP("Library", "remove that"),
    QT_TRANSLATE_NOOP("Library",
                      "only the joint method uses measured depths and punches with a step"),
    QT_TRANSLATE_NOOP("Library", "leaving them out, or --method joint"),
    QT_TRANSLATE_NOOP("Library", "or --bursts where each video shows one press held still"),
    QT_TRANSLATE_NOOP("Library", "remove it"),
    QT_TRANSLATE_NOOP("Library", "'%1' cannot be read by this version"),
    QT_TRANSLATE_NOOP("Library",
                      "the version of this program that wrote it, or calibrating again with the "
                      "pictures in presses/ (this version writes '%1')"),
    QT_TRANSLATE_NOOP("Library",
                      "there is nothing to repeat: this finger was not calibrated, or by a version "
                      "that did not keep what with"),
    QT_TRANSLATE_NOOP("Library",
                      "calibrating it with the pictures in presses/ and --ball-radius-mm"),
    QT_TRANSLATE_NOOP("Library", "this is not YAML: %1"),
    QT_TRANSLATE_NOOP("Library", "results and truth are of different size"),
    QT_TRANSLATE_NOOP("Library",
                      "not as `alltact simulate` and `alltact reconstruct` write it (%1)"),
    QT_TRANSLATE_NOOP("Library", "%1 with %2"),
    QT_TRANSLATE_NOOP("Library", "running both again"),
    QT_TRANSLATE_NOOP("Library",
                      "the brightness of the untouched face changes from press to press (standard "
                      "deviation %1 %): exposure or gain is automatic, or the room's light gets "
                      "in; lock them, shade the finger and press again"),
    QT_TRANSLATE_NOOP(
        "Library",
        "the untouched face is %1 % %2 in all presses than in the reference: the light, the "
        "exposure or the gain has changed between them; depth is corrected for it as far as it is "
        "smooth, but let the lamps warm up and record the reference again"),
    QT_TRANSLATE_NOOP("Library",
                      "in %1 of %2 presses the finger is bent in a way that the reference "
                      "recording does not hold, or it has moved in its mount since: record a "
                      "reference that bends as far, or press with less bending"),
    QT_TRANSLATE_NOOP("Library", "no untouched picture; give one to calibrate with --reference"),
    QT_TRANSLATE_NOOP("Library",
                      "no recording of the bending, untouched finger; run alltact reference"),
    QT_TRANSLATE_NOOP("Library", "one untouched picture"),
    QT_TRANSLATE_NOOP("Library",
                      "only %1 frames; poses between them are guessed, record more bending"),
    QT_TRANSLATE_NOOP("Library",
                      "no layout at rest, so touch cannot be told; run alltact reference again"),
    QT_TRANSLATE_NOOP("Library", "%1 markers; touch is told from %2 px of summed offset"),
    QT_TRANSLATE_NOOP("Library", "not calibrated; run alltact calibrate with ball presses"),
    QT_TRANSLATE_NOOP(
        "Library", "nothing says how it came about or how good it is; run alltact calibrate again"),
    QT_TRANSLATE_NOOP("Library",
                      "the reference (%1) is newer than the calibration (%2); calibrate again"),
    QT_TRANSLATE_NOOP("Library", "made %1"),
    QT_TRANSLATE_NOOP("Library", "at an unknown date"),
    QT_TRANSLATE_NOOP("Library", "the calibration cannot be repeated"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 of %2 press pictures are gone, so the calibration cannot be repeated"),
    QT_TRANSLATE_NOOP("Library",
                      "what is kept is of a calibration that was cut off; complete it with %1"),
    QT_TRANSLATE_NOOP("Library", "%1 pictures kept"),
    QT_TRANSLATE_NOOP("Library", "%1 frames"),
    QT_TRANSLATE_NOOP("Library", "fine"),
    QT_TRANSLATE_NOOP("Library", "weak"),
    QT_TRANSLATE_NOOP("Library", "stale"),
    QT_TRANSLATE_NOOP("Library", "missing"),
    QT_TRANSLATE_NOOP("Library", "Moebius curve"),
    QT_TRANSLATE_NOOP("Library", "Kubelka-Munk curve"),
    QT_TRANSLATE_NOOP("Library", "polynomial of degree %1"),
    QT_TRANSLATE_NOOP("Library", "%1 that varies over the face"),
    QT_TRANSLATE_NOOP("Library", "no mapping came of it"),
    QT_TRANSLATE_NOOP("Library",
                      "the inner %1 % of each contact's radius was used, where the skin surely "
                      "touches the ball"),
    QT_TRANSLATE_NOOP("Library",
                      "the inner %1 % of each contact's radius was used; the skin comes back from "
                      "the ball over %2 mm"),
    QT_TRANSLATE_NOOP("Library", "trying a %1"),
    QT_TRANSLATE_NOOP("Library", "with one press nothing can be held out"),
    QT_TRANSLATE_NOOP("Library", "as asked for"),
    QT_TRANSLATE_NOOP("Library", "least error on presses left out, %1 mm"),
    QT_TRANSLATE_NOOP(
        "Library",
        "%1 mm on presses left out, not distinguishable from the best (%2, %3 mm) and simpler"),
    QT_TRANSLATE_NOOP("Library",
                      "brightness follows the layer's thickness %1: %2 mm on presses left out, "
                      "against %3 mm along its normal"),
    QT_TRANSLATE_NOOP("Library", "along z"),
    QT_TRANSLATE_NOOP("Library", "along z projected onto its normal"),
    QT_TRANSLATE_NOOP(
        "Library",
        "the mapping varies over the face, as uneven light or an uneven layer make it: by %1 % "
        "from the presses nearest to the base to those nearest to the tip, by %2 % from side to "
        "side; %3 mm on presses left out, against %4 mm with one mapping for all"),
    QT_TRANSLATE_NOOP("Library", "the polynomial through the balls' depths does not increase"),
    QT_TRANSLATE_NOOP("Library", "the cubic does not increase; degree %1 was used instead"),
    QT_TRANSLATE_NOOP("Library", "the source paper's"),
    QT_TRANSLATE_NOOP("Library", "%1, in place of the paper's cubic"),
};

}  // namespace

const Patterns kCalibrationWords = kAll;

}  // namespace alltact
