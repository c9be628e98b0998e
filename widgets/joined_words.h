// Joins words and sentences with the punctuation of the window's language.
#pragma once

#include <QStringList>

namespace alltact {

/// Items of one kind: "left, right, up".
QString listed(const QStringList& things);

/// Parts of a sentence without the empty ones: "3 contacts, deepest 0.41 mm in frame 7".
QString joined(const QStringList& parts);

/// Clauses without full stops: "depth 0.41 mm; x 3.1, y 0.2, z 24.6 mm".
QString joined_clauses(const QStringList& clauses);

/// A label and its value: "Camera: front".
QString labelled(const QString& label, const QString& what);

}  // namespace alltact
