#include "widgets/joined_words.h"

#include <QCoreApplication>

namespace alltact {
namespace {

struct JoinedWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::JoinedWords)
 public:
  static QString between_things() { return tr(", ", "between things of one kind"); }
  static QString between_parts() { return tr(", ", "between parts of a sentence"); }
  static QString between_clauses() { return tr("; ", "between clauses"); }
  static QString after_label() { return tr(": ", "after what names the next"); }
};

}  // namespace

QString listed(const QStringList& things) {
  return things.join(JoinedWords::between_things());
}

QString joined(const QStringList& parts) {
  QStringList parts_shown = parts;
  parts_shown.removeAll(QString());
  return parts_shown.join(JoinedWords::between_parts());
}

QString joined_clauses(const QStringList& clauses) {
  return clauses.join(JoinedWords::between_clauses());
}

QString labelled(const QString& label, const QString& what) {
  return label + JoinedWords::after_label() + what;
}

}  // namespace alltact
