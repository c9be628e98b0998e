// Includes QCustomPlot, whose header uses Qt's lower-case keywords; this project compiles without
// them.
#pragma once

#include <QtCore/qobjectdefs.h>
// NOLINTBEGIN: names of the library
#define signals Q_SIGNALS
#define slots Q_SLOTS
#define emit Q_EMIT
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef emit
#undef foreach
// NOLINTEND
