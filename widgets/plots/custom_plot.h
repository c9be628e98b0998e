// QCustomPlot, whose header is written in Qt's lower-case keywords, which we go without.
#pragma once

#include <QtCore/qobjectdefs.h>
// NOLINTBEGIN: the library's words, not ours
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
