// Words put together, with the punctuation of the window's language.
#pragma once

#include <QStringList>

namespace alltact {

/// Things of one kind: "left, right, up".
QString listed(const QStringList& things);

/// Parts of a sentence, empty ones left out: "3 contacts, deepest 0.41 mm in frame 7".
QString joined(const QStringList& parts);

/// Sentences without their ends: "depth 0.41 mm; x 3.1, y 0.2, z 24.6 mm".
QString set_apart(const QStringList& clauses);

/// What has a name: "Camera: front".
QString labelled(const QString& label, const QString& what);

}  // namespace alltact
