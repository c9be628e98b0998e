// What the programs themselves say where there is no window: errors of the Studio's work and of the
// command line it runs.
#include "widgets/words/catalogue.h"

#include <QtGlobal>

namespace alltact {
namespace {

constexpr const char* kAll[] = {
    QT_TRANSLATE_NOOP("Library", "the report could not be printed"),
    QT_TRANSLATE_NOOP("Library",
                      "this computer cannot draw in 3D: there is no EGL with OpenGL 3.2"),
    QT_TRANSLATE_NOOP("Library", "installing libegl1 and libgl1-mesa-dri, which draw in software"),
    QT_TRANSLATE_NOOP("Library", "the press could not be removed: %1"),
    QT_TRANSLATE_NOOP("Library", "no finger is open, so the recording cannot be measured"),
    QT_TRANSLATE_NOOP("Library", "opening a finger"),
    QT_TRANSLATE_NOOP("Library", "there is no face to save"),
    QT_TRANSLATE_NOOP("Library", "another frame"),
    QT_TRANSLATE_NOOP("Library", "no frame of the recording shows a face"),
    QT_TRANSLATE_NOOP("Library", "this is not a session of this program"),
    QT_TRANSLATE_NOOP("Library", "beginning a new one"),
    QT_TRANSLATE_NOOP("Library", "there is a finger already, and it is never overwritten"),
    QT_TRANSLATE_NOOP("Library", "another folder, or moving that one away"),
    QT_TRANSLATE_NOOP("Library", "this file that comes with the program is not there"),
    QT_TRANSLATE_NOOP("Library", "installing the program again"),
    QT_TRANSLATE_NOOP("Library", "standard output could not be written"),
    QT_TRANSLATE_NOOP("Library", "looking at what reads it"),
    QT_TRANSLATE_NOOP("Library", "'%1' is not excluded"),
    QT_TRANSLATE_NOOP("Library", "the finger that belongs to this camera, or this finger's camera"),
    QT_TRANSLATE_NOOP("Library", "stopped by hand"),
    QT_TRANSLATE_NOOP("Library", "the source ended"),
    QT_TRANSLATE_NOOP("Library", "frame %1 of %2"),
    QT_TRANSLATE_NOOP("Library", "%1 has no camera matrix, so %2 has no form for it"),
    QT_TRANSLATE_NOOP("Library", "an orthographic camera"),
    QT_TRANSLATE_NOOP("Library", "a camera behind a window"),
    QT_TRANSLATE_NOOP("Library", "json, or zip for the whole finger"),
    QT_TRANSLATE_NOOP("Library", "is a link to another folder, which a zip cannot hold"),
    QT_TRANSLATE_NOOP("Library", "is neither a file nor a folder, so a zip cannot hold it"),
    QT_TRANSLATE_NOOP("Library", "moving it out of the finger's folder"),
    QT_TRANSLATE_NOOP("Library", "the finger's folder could not be read"),
    QT_TRANSLATE_NOOP("Library", "its permissions, and that its disk is there"),
    QT_TRANSLATE_NOOP("Library", "a zip of the finger cannot lie in the finger's own folder"),
    QT_TRANSLATE_NOOP("Library", "another folder"),
    QT_TRANSLATE_NOOP("Library", "stopped before it was written"),
    QT_TRANSLATE_NOOP("Library", "could not write the archive"),
    QT_TRANSLATE_NOOP("Library", "another name for the file that is meant"),
    QT_TRANSLATE_NOOP("Library", "stopped before it was packed"),
    QT_TRANSLATE_NOOP("Library", "this recording is not there any more"),
    QT_TRANSLATE_NOOP("Library", "plugging in the disk it lies on, or opening another one"),
};

}  // namespace

const Patterns kProgramWords = kAll;

}  // namespace alltact
