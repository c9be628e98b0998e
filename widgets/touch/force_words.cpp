#include "widgets/touch/force_words.h"

#include "widgets/language.h"

#include <QCoreApplication>

namespace alltact {
namespace {

struct ForceWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::ForceWords)
 public:
  static QString why_none(const FingerStatus& status) {
    if (status.state == FingerState::kLoading) return tr("The finger is being loaded.");
    if (!status.finger) return tr("Open a finger to see its forces.");
    const Finger& finger = *status.finger;
    if (finger.markers.per_row == 0) return tr("A finger without markers tells no forces.");
    if (status.force_problem)
      return window_sentence(status.force_problem->message()).toHtmlEscaped();
    if (finger.force_model.empty()) return no_model(status.folder);
    if (!status.has_reference) return tr("Forces are told once there is a reference recording.");
    return tr("No force is told of this picture.");
  }

  static QString no_model(const std::filesystem::path& folder) {
    const QString name = folder.empty() ? QStringLiteral("FINGER")
                                        : QString::fromStdString(folder.filename().string());
    return tr("This finger has no force model yet. A table of its markers beside a gauge's forces "
              "trains one:") +
           QStringLiteral("<br><code>alltact force %1 TABLE.csv</code>").arg(name.toHtmlEscaped());
  }
};

}  // namespace

QString no_force_reason(const FingerStatus& finger) {
  return ForceWords::why_none(finger);
}

}  // namespace alltact
