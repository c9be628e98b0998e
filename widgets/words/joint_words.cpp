// How parts are put together: a list, a reason, a piece of advice.
#include "widgets/words/catalogue.h"

#include <QtGlobal>

namespace alltact {
namespace {

constexpr const char* kAll[] = {
    QT_TRANSLATE_NOOP("Library", "%1."),
    QT_TRANSLATE_NOOP("Library", "%1. %2"),
    QT_TRANSLATE_NOOP("Library", "%1; %2"),
    QT_TRANSLATE_NOOP("Library", "%1: %2"),
    QT_TRANSLATE_NOOP("Library", "%1, %2"),
    QT_TRANSLATE_NOOP("Library", "%1, and %2"),
    QT_TRANSLATE_NOOP("Library", "%1 and %2"),
    QT_TRANSLATE_NOOP("Library", "%1 or %2"),
    QT_TRANSLATE_NOOP("Library", "%1 (%2)"),
    QT_TRANSLATE_NOOP("Library", "one of %1"),
    QT_TRANSLATE_NOOP("Library", "Try: %1"),
    QT_TRANSLATE_NOOP("Library", "Warning: %1"),
    QT_TRANSLATE_NOOP("Library", "Left out: %1"),
    QT_TRANSLATE_NOOP("Library", "Remark: %1"),
    QT_TRANSLATE_NOOP("Library", "Not yet seen: %1"),
    QT_TRANSLATE_NOOP("Library", "unexpected: %1"),
    QT_TRANSLATE_NOOP("Library", "reporting this as a defect"),
    QT_TRANSLATE_NOOP("Library", "up to %1"),
    QT_TRANSLATE_NOOP("Library", "at most %1"),
    QT_TRANSLATE_NOOP("Library", "no"),
    QT_TRANSLATE_NOOP("Library", "nothing"),
    QT_TRANSLATE_NOOP("Library", "stopped"),
    QT_TRANSLATE_NOOP("Library", "done"),
};

}  // namespace

const Patterns kJointWords = kAll;

}  // namespace alltact
