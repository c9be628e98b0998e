// Reference recordings, markers and what is read from a frame.
#include "widgets/words/catalogue.h"

#include <QtGlobal>

namespace alltact {
namespace {

constexpr const char* kAll[] = {
    QT_TRANSLATE_NOOP("Library", "%1 of %2 %3 reached"),
    QT_TRANSLATE_NOOP("Library", "degrees"),
    QT_TRANSLATE_NOOP("Library", "bend it further away from the camera"),
    QT_TRANSLATE_NOOP("Library", "bend it further towards the camera"),
    QT_TRANSLATE_NOOP("Library", "push its tip further to one side"),
    QT_TRANSLATE_NOOP("Library", "push its tip further to the other side"),
    QT_TRANSLATE_NOOP("Library", "twist it further one way"),
    QT_TRANSLATE_NOOP("Library", "twist it further the other way"),
    QT_TRANSLATE_NOOP("Library",
                      "bend it while its tip is pushed aside: %1 % of the combinations were seen"),
    QT_TRANSLATE_NOOP("Library", "no frame shows the face"),
    QT_TRANSLATE_NOOP("Library",
                      "a recording in which both long edges of the bright face are visible"),
    QT_TRANSLATE_NOOP("Library", "%1 dots were found but they fit no pose of the %2 markers"),
    QT_TRANSLATE_NOOP("Library", "the markers lie %1 px from where they can be"),
    QT_TRANSLATE_NOOP("Library", "stopped before the recording was read"),
    QT_TRANSLATE_NOOP("Library", "reading frame %1 of %2"),
    QT_TRANSLATE_NOOP("Library", "the picture"),
    QT_TRANSLATE_NOOP(
        "Library",
        "a recording made with this finger's camera, or the right camera.size and orientation"),
    QT_TRANSLATE_NOOP("Library", "the recording cannot be renamed: %1"),
    QT_TRANSLATE_NOOP("Library", "stopped before the recording was written"),
    QT_TRANSLATE_NOOP("Library", "writing the frames that are kept"),
    QT_TRANSLATE_NOOP("Library", "stopped before the recording was compared"),
    QT_TRANSLATE_NOOP("Library", "comparing frame %1 of %2"),
    QT_TRANSLATE_NOOP("Library", "frame %1"),
    QT_TRANSLATE_NOOP("Library", "only %1 of %2 frames can be used (%3)"),
    QT_TRANSLATE_NOOP("Library",
                      "record again with every marker in view and nothing on the contact face"),
    QT_TRANSLATE_NOOP("Library", "the recording's picture"),
    QT_TRANSLATE_NOOP("Library",
                      "frame %1: something pressed on the contact face, %2 mm from its base (%3 % "
                      "darker than untouched)"),
    QT_TRANSLATE_NOOP("Library", "the recording holds %1 frame; at least 2 are needed"),
    QT_TRANSLATE_NOOP("Library", "the recording holds %1 frames; at least 2 are needed"),
    QT_TRANSLATE_NOOP("Library", "recording"),
    QT_TRANSLATE_NOOP("Library",
                      "record the finger while it bends slowly in every direction, untouched"),
    QT_TRANSLATE_NOOP("Library", "numbering the markers"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 marker positions in %2 frames are estimates, because the markers were "
                      "covered or not found"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 frames are few: a recording of a minute (about 1500 frames) over all "
                      "directions of bending gives closer references"),
    QT_TRANSLATE_NOOP("Library", "this finger has no markers to record a reference with"),
    QT_TRANSLATE_NOOP("Library", "the recording could not be processed (%1)"),
    QT_TRANSLATE_NOOP("Library", "reference installed"),
    QT_TRANSLATE_NOOP("Library", "only a flat sensor takes one untouched picture as its reference"),
    QT_TRANSLATE_NOOP("Library", "a recording of the bending, untouched finger"),
    QT_TRANSLATE_NOOP("Library", "an untouched picture taken with this sensor's camera"),
    QT_TRANSLATE_NOOP("Library", "the two long edges of the face were not found"),
    QT_TRANSLATE_NOOP("Library",
                      "light the finger as in its recording, and check that the picture shows the "
                      "face from base to tip with the finger's length along the picture's width"),
    QT_TRANSLATE_NOOP("Library", "the face's edges"),
    QT_TRANSLATE_NOOP("Library",
                      "a picture in which both long edges of the bright face are visible and lit "
                      "evenly; check that the lamps are on and that the lens is clean"),
    QT_TRANSLATE_NOOP("Library",
                      "the shape of a Fin Ray needs a perspective camera, not an orthographic one"),
    QT_TRANSLATE_NOOP("Library", "the %1 edge of the face was seen in too few columns"),
    QT_TRANSLATE_NOOP("Library", "the two edges were never seen together"),
    QT_TRANSLATE_NOOP("Library", "no smooth shape fits them"),
    QT_TRANSLATE_NOOP("Library",
                      "no smooth shape fits the outline of the face: it jumps at column %1"),
    QT_TRANSLATE_NOOP("Library", "bending the finger less, until no part of it hides another"),
    QT_TRANSLATE_NOOP("Library", "the distance of the face is too uncertain in every column"),
    QT_TRANSLATE_NOOP("Library",
                      "only %1 recorded pictures show every marker; at least 2 are needed"),
    QT_TRANSLATE_NOOP("Library", "marker model"),
    QT_TRANSLATE_NOOP("Library",
                      "record the finger bending with both side faces in view and evenly lit"),
    QT_TRANSLATE_NOOP("Library", "%1 markers have a position but %2 have a size"),
    QT_TRANSLATE_NOOP("Library", "the markers' positions are not finite numbers"),
    QT_TRANSLATE_NOOP("Library", "make the reference anew from the recording"),
    QT_TRANSLATE_NOOP("Library", "the finger has no markers, so it has no marker table"),
    QT_TRANSLATE_NOOP("Library", "set markers.per_row"),
    QT_TRANSLATE_NOOP("Library", "%1, line %2"),
    QT_TRANSLATE_NOOP("Library", "not a marker table; its first line must be '%1'"),
    QT_TRANSLATE_NOOP("Library", "the table ends too early"),
    QT_TRANSLATE_NOOP("Library", "'%1' does not close a table of %2 frames"),
    QT_TRANSLATE_NOOP("Library", "'%1' is not '%2' with possible values"),
    QT_TRANSLATE_NOOP("Library", "marker %1 stands where marker %2 of %3 must"),
    QT_TRANSLATE_NOOP("Library", "frame %1 comes after frame %2"),
    QT_TRANSLATE_NOOP("Library", "frame %1 has %2 markers instead of %3"),
    QT_TRANSLATE_NOOP("Library", "marker %1 has another radius or contrast than before"),
    QT_TRANSLATE_NOOP("Library", "the table holds no frame"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 dots were found beside the face, but no third of the %2 markers among "
                      "them fits a pose of the reference recording"),
    QT_TRANSLATE_NOOP(
        "Library",
        "the markers were not found: the face's shape alone tells this pose, so that depth is less "
        "sure and neither twist nor what touches the finger is told; uncover and light the dots on "
        "the side faces"),
    QT_TRANSLATE_NOOP("Library", "a picture at the size that the finger was calibrated with"),
    QT_TRANSLATE_NOOP("Library",
                      "this pose was never recorded: the nearest reference frame is %1 px away; "
                      "record the finger bending further in this direction"),
    QT_TRANSLATE_NOOP("Library",
                      "the picture is black: its brightest parts reach %1 of 255 grey levels; take "
                      "the cap off the lens, switch the lamps on, or expose longer"),
    QT_TRANSLATE_NOOP(
        "Library",
        "the picture is too bright: %1 % of it is saturated; expose shorter, or dim the lamps"),
    QT_TRANSLATE_NOOP("Library",
                      "the picture is blank: all of it has %1 of 255 grey levels, without even a "
                      "camera's noise; plug the camera in again"),
    QT_TRANSLATE_NOOP("Library",
                      "the picture is the same as the one before to the last grey level: the "
                      "camera stands still; plug it in again"),
    QT_TRANSLATE_NOOP(
        "Library",
        "%1 % of the face is too bright to be measured; expose shorter, or dim the lamps"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 % of the face was never recorded in a pose like this; record the finger "
                      "bending further in this direction"),
    QT_TRANSLATE_NOOP("Library",
                      "%1 % of the face, at its end, is hidden in this frame: nothing is told of "
                      "it, neither that it is touched nor that it is not"),
    QT_TRANSLATE_NOOP("Library",
                      "the face is %1 % darker than when its reference was recorded; set exposure, "
                      "gain and lamps as they were then"),
    QT_TRANSLATE_NOOP("Library",
                      "the face is %1 % brighter than when its reference was recorded; set "
                      "exposure, gain and lamps as they were then"),
    QT_TRANSLATE_NOOP(
        "Library",
        "%1 % of the face is brighter than its reference: this is another finger, or its skin has "
        "changed; choose the finger that it is, or record the reference again"),
    QT_TRANSLATE_NOOP("Library",
                      "few recorded frames are near this pose: its reference is %1 times less sure "
                      "than usual; record the finger bending slowly through it"),
    QT_TRANSLATE_NOOP("Library", "the finger is not calibrated: calibrate it with ball presses"),
    QT_TRANSLATE_NOOP("Library",
                      "how the face's edges are placed: half-way crossing to a fiftieth of a "
                      "pixel, or the steepest whole pixel"),
    QT_TRANSLATE_NOOP("Library", "pixel columns averaged into one place on each edge"),
    QT_TRANSLATE_NOOP("Library", "degree of the smooth curve through each edge of the face"),
    QT_TRANSLATE_NOOP("Library",
                      "which untouched picture a frame is compared with: the nearest recorded one, "
                      "or one computed from the nearest several"),
    QT_TRANSLATE_NOOP("Library",
                      "whether a change of the light since the reference is read from the "
                      "untouched skin and taken out"),
    QT_TRANSLATE_NOOP(
        "Library", "standard deviation of the smoothing before depth is read, in pixels; 0: none"),
    QT_TRANSLATE_NOOP("Library", "depth that counts as touched, in millimetres"),
    QT_TRANSLATE_NOOP("Library", "stopped before the reference was read"),
    QT_TRANSLATE_NOOP("Library", "reading reference frame %1 of %2"),
    QT_TRANSLATE_NOOP("Library",
                      "the marker table names frame %1 but the recording ends after %2 frames"),
    QT_TRANSLATE_NOOP("Library", "the sensor has no untouched picture"),
    QT_TRANSLATE_NOOP("Library", "give one with the calibration"),
    QT_TRANSLATE_NOOP("Library", "the untouched picture"),
    QT_TRANSLATE_NOOP("Library", "give the untouched picture anew"),
    QT_TRANSLATE_NOOP("Library", "the finger has no reference recording"),
    QT_TRANSLATE_NOOP("Library", "record the bending, untouched finger and make its reference"),
    QT_TRANSLATE_NOOP("Library", "the reference recording is missing or no video"),
    QT_TRANSLATE_NOOP("Library", "the recording cannot be read (%1)"),
    QT_TRANSLATE_NOOP("Library", "the face was found in %1 of %2 recorded pictures; 2 are needed"),
    QT_TRANSLATE_NOOP("Library", "the reference picture is not an 8-bit grey picture"),
    QT_TRANSLATE_NOOP("Library", "save it as such"),
    QT_TRANSLATE_NOOP("Library", "too little of the face is seen to tell the pose by its shape"),
    QT_TRANSLATE_NOOP(
        "Library",
        "a frame shows %1 dots on the upper and %2 on the lower side face (median of %3 frames), "
        "but no two rows of up to %4 that keep their places on the finger"),
    QT_TRANSLATE_NOOP("Library",
                      "No markers can be used: %1; poses are told by the shape of the face alone, "
                      "which cannot tell twist; if the finger has dots, light both side faces so "
                      "that they stand out, and focus"),
    QT_TRANSLATE_NOOP("Library",
                      "Markers %1 were not found anywhere; the finger works with the other %2"),
    QT_TRANSLATE_NOOP("Library", "%1 shows what was found"),
    QT_TRANSLATE_NOOP("Library", "frame %1 cannot be the finger's rest: %2"),
    QT_TRANSLATE_NOOP("Library", "the recording has no such frame"),
    QT_TRANSLATE_NOOP("Library", "another frame in which the finger rests"),
    QT_TRANSLATE_NOOP("Library", "a flat sensor takes one untouched picture"),
    QT_TRANSLATE_NOOP("Library", "lines: edges of the face"),
    QT_TRANSLATE_NOOP("Library", "outlined: darker than the untouched face"),
    QT_TRANSLATE_NOOP("Library", "circle: a marker, with its number"),
    QT_TRANSLATE_NOOP("Library", "cross: looks like a dot, but is none of the rows"),
    QT_TRANSLATE_NOOP("Library", "broken circle: a marker should be here"),
    QT_TRANSLATE_NOOP("Library", "%1 in its frame %2 out of %3"),
    QT_TRANSLATE_NOOP("Library",
                      "none; poses are told by the shape of the face, which cannot tell twist"),
    QT_TRANSLATE_NOOP("Library", "of %1 markers none may be hidden"),
};

}  // namespace

const Patterns kReferenceWords = kAll;

}  // namespace alltact
