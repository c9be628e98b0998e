// Balls pressed into the face: finding, placing and checking them.
#include "widgets/words/catalogue.h"

#include <QtGlobal>

namespace alltact {
namespace {

constexpr const char* kAll[] = {
    QT_TRANSLATE_NOOP("Library",
                      "hardly any pixel of the face could be compared with the reference"),
    QT_TRANSLATE_NOOP("Library",
                      "a press and a reference of the same size in which the face is lit"),
    QT_TRANSLATE_NOOP("Library",
                      "nothing on the face is clearly darker than in the reference (the darkest "
                      "part differs by %1 %, the rest scatters by %2 %)"),
    QT_TRANSLATE_NOOP("Library",
                      "pressing the ball in deeper, and checking that the reference shows the same "
                      "finger in the same pose"),
    QT_TRANSLATE_NOOP("Library", "only specks are dark, none larger than %1 pixels"),
    QT_TRANSLATE_NOOP("Library", "pressing the ball in deeper"),
    QT_TRANSLATE_NOOP("Library", "two contacts were found, the second with %1 % of the first"),
    QT_TRANSLATE_NOOP("Library", "a press in which only the ball touches the face"),
    QT_TRANSLATE_NOOP("Library", "the border of the dark part is no arc of a circle"),
    QT_TRANSLATE_NOOP("Library", "a press in which the ball lies wholly on the face"),
    QT_TRANSLATE_NOOP("Library", "only %1 degrees of the dark disc's rim lie on the face"),
    QT_TRANSLATE_NOOP("Library", "a press nearer to the middle of the face"),
    QT_TRANSLATE_NOOP("Library", "the dark part has a radius of %1 mm, more than the ball's %2 mm"),
    QT_TRANSLATE_NOOP("Library",
                      "checking the ball's radius, or a picture in which only the ball touches"),
    QT_TRANSLATE_NOOP("Library",
                      "the dark part is no disc: its rim is off a circle by %1 % of the radius, "
                      "and %2 % of the circle is dark"),
    QT_TRANSLATE_NOOP("Library", "a picture in which a ball, and only the ball, touches the face"),
    QT_TRANSLATE_NOOP("Library", "the middle of the dark disc lies off the face"),
    QT_TRANSLATE_NOOP("Library", "a ball radius of %1 mm is impossible"),
    QT_TRANSLATE_NOOP("Library", "the radius in millimetres, as measured with callipers"),
    QT_TRANSLATE_NOOP("Library", "the press has no difference picture"),
    QT_TRANSLATE_NOOP("Library", "taking the picture again"),
    QT_TRANSLATE_NOOP("Library", "OpenCV failed: %1"),
    QT_TRANSLATE_NOOP("Library", "a smaller picture"),
    QT_TRANSLATE_NOOP("Library", "looking for the ball in %1"),
    QT_TRANSLATE_NOOP("Library", "the same picture as %1, counted once"),
    QT_TRANSLATE_NOOP("Library", "the contact covers too few pixels"),
    QT_TRANSLATE_NOOP("Library", "pressing deeper, or a larger picture"),
    QT_TRANSLATE_NOOP("Library", "no press was given"),
    QT_TRANSLATE_NOOP("Library", "at least one picture of a pressed ball"),
    QT_TRANSLATE_NOOP("Library", "none of %1 presses could be used: %2"),
    QT_TRANSLATE_NOOP(
        "Library",
        "pictures in which the ball, and nothing else, is pressed 0.3 mm or more into the face"),
    QT_TRANSLATE_NOOP("Library", "there are only presses of a punch with a step"),
    QT_TRANSLATE_NOOP("Library",
                      "pressing a ball as well, once at least: a step tells how far apart two "
                      "depths are, not where they begin"),
    QT_TRANSLATE_NOOP("Library", "the punch touches too little of the face"),
    QT_TRANSLATE_NOOP("Library", "one of the punch's levels touches too little of the face"),
    QT_TRANSLATE_NOOP("Library", "no step is to be seen"),
    QT_TRANSLATE_NOOP("Library",
                      "pressing the punch in until the skin lies on both of its levels, each 4 mm "
                      "wide or more"),
    QT_TRANSLATE_NOOP("Library",
                      "its measured depth of %1 +- %2 mm was left out, because the pictures say %3 "
                      "+- %4 mm; it counts from where the ball first touches, normal to the face"),
    QT_TRANSLATE_NOOP("Library",
                      "its step of %1 mm was left out, because the balls say %2 +- %3 mm; is the "
                      "balls' radius right"),
    QT_TRANSLATE_NOOP("Library",
                      "the finger moves: no more than %1 of %2 frames in a row show the same"),
    QT_TRANSLATE_NOOP("Library",
                      "holding ball and finger still for half a second, at a steady light"),
    QT_TRANSLATE_NOOP("Library", "the mean of %1 frames held still, of %2 read"),
    QT_TRANSLATE_NOOP("Library", "'%1' is not NAME=R, a press and its ball's radius in mm"),
    QT_TRANSLATE_NOOP("Library",
                      "'%1' is not NAME=MM+-SD, a press, how deep its ball was pressed in and how "
                      "well that is known, in mm"),
    QT_TRANSLATE_NOOP("Library",
                      "'%1' is not NAME=MM, a press and the height of its punch's step in mm"),
    QT_TRANSLATE_NOOP("Library", "no face was found"),
    QT_TRANSLATE_NOOP("Library", "two presses are called '%1'"),
    QT_TRANSLATE_NOOP("Library",
                      "giving the pictures different names; they are kept by name with the finger"),
    QT_TRANSLATE_NOOP("Library", "reading %1"),
    QT_TRANSLATE_NOOP("Library", "no press is called '%1'"),
    QT_TRANSLATE_NOOP("Library", "excluded"),
    QT_TRANSLATE_NOOP(
        "Library", "%1 mm, more than three times the others; look at the picture, or leave it out"),
    QT_TRANSLATE_NOOP("Library", "no press can be used"),
    QT_TRANSLATE_NOOP("Library", "pictures of this finger with a ball pressed into its face"),
    QT_TRANSLATE_NOOP("Library", "only %1 of %2 markers found"),
    QT_TRANSLATE_NOOP("Library", "no circle goes through the dark border"),
    QT_TRANSLATE_NOOP("Library", "the circle's middle lies off the face"),
    QT_TRANSLATE_NOOP("Library", "the circle lies off the face"),
    QT_TRANSLATE_NOOP("Library", "the circle is larger than the ball"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 degrees of the ball's outline are seen, a cone needs %2; the rest of the "
                      "dark border is where the skin leaves the ball"),
    QT_TRANSLATE_NOOP("Library", "no cone touches the outline"),
    QT_TRANSLATE_NOOP("Library", "the camera does not see the circle's middle"),
    QT_TRANSLATE_NOOP("Library", "no place of the ball gives a cubic"),
    QT_TRANSLATE_NOOP("Library",
                      "the ball that follows from the dark border hardly touches the face"),
    QT_TRANSLATE_NOOP("Library", "no ball follows from the dark border of any of %1 presses (%2)"),
    QT_TRANSLATE_NOOP("Library", "the joint method, which fits the ball itself"),
    QT_TRANSLATE_NOOP("Library", "the joint method, or more presses of different depth"),
    QT_TRANSLATE_NOOP("Library", "'%1' does not say where a ball is"),
    QT_TRANSLATE_NOOP(
        "Library",
        "NAME=X,Y,Z with the ball's centre in mm before the camera, as press_3=1.5,-2,48"),
    QT_TRANSLATE_NOOP("Library", "the ball that was put there by hand does not touch the face"),
    QT_TRANSLATE_NOOP("Library", "moving its outline onto the dark disc, or having the ball found"),
    QT_TRANSLATE_NOOP("Library", "no ball fits the contact"),
    QT_TRANSLATE_NOOP("Library", "a clean ball"),
    QT_TRANSLATE_NOOP("Library", "pass"),
    QT_TRANSLATE_NOOP("Library", "drifting"),
    QT_TRANSLATE_NOOP("Library", "recalibrate"),
    QT_TRANSLATE_NOOP("Library", "the contacts have no ball's shape: is ball or face dirty?"),
    QT_TRANSLATE_NOOP(
        "Library", "the mapping reads %1 % too %2: layer, ball or camera are not what they were"),
    QT_TRANSLATE_NOOP("Library", "shallow"),
    QT_TRANSLATE_NOOP("Library", "deep"),
    QT_TRANSLATE_NOOP("Library",
                      "the face is %1 % %2 than it was: look at lamps, exposure and layer"),
    QT_TRANSLATE_NOOP("Library", "brighter"),
    QT_TRANSLATE_NOOP("Library", "darker"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 mm of depth error on %2 press (passes up to %3 mm), light %4 %"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 mm of depth error on %2 presses (passes up to %3 mm), light %4 %"),
    QT_TRANSLATE_NOOP("Library", "calibrate again soon"),
    QT_TRANSLATE_NOOP("Library", "calibrate again before measuring with it"),
    QT_TRANSLATE_NOOP("Library", "stopped before the check was done"),
    QT_TRANSLATE_NOOP("Library", "the finger is not calibrated, so there is nothing to check"),
    QT_TRANSLATE_NOOP("Library", "the finger does not tell the ball it was calibrated with"),
    QT_TRANSLATE_NOOP("Library", "--ball-radius-mm with the radius of the ball that was pressed"),
    QT_TRANSLATE_NOOP("Library", "measuring the presses"),
    QT_TRANSLATE_NOOP("Library",
                      "pictures of this finger with the ball pressed 0.3 mm or more into its face"),
    QT_TRANSLATE_NOOP("Library", "measuring the presses of the calibration"),
    QT_TRANSLATE_NOOP("Library", "moving it away; only what was said of presses is lost with it"),
    QT_TRANSLATE_NOOP("Library", "one for each press, \"\" where there is nothing to say"),
    QT_TRANSLATE_NOOP(
        "Library",
        "the face is %1 % %2 than when its reference was recorded; false depth %3 mm in the worst "
        "twentieth of it (%4 mm if the light were not corrected; up to %5 mm is noise)"),
    QT_TRANSLATE_NOOP("Library",
                      "let the lamps warm up, look at exposure and gain, and record the reference "
                      "again when it goes on"),
    QT_TRANSLATE_NOOP("Library", "record the reference again"),
    QT_TRANSLATE_NOOP("Library", "the finger is not calibrated yet"),
    QT_TRANSLATE_NOOP("Library", "calibrate with ball presses"),
    QT_TRANSLATE_NOOP("Library", "nothing could be measured"),
    QT_TRANSLATE_NOOP("Library", "none of the pictures can be compared with the reference"),
    QT_TRANSLATE_NOOP("Library", "pictures of the untouched finger in poses that were recorded"),
    QT_TRANSLATE_NOOP("Library", "this is no check and is left out"),
};

}  // namespace

const Patterns kPressWords = kAll;

}  // namespace alltact
