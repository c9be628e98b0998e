#include "widgets/settings_words.h"

#include "widgets/joined_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace alltact {
namespace {

/// The text of one value of one setting.
class SettingsWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::SettingsWords)
 public:
  static QString of(const std::string& name, const std::string& value) {
    if (name == "resolution")
      return value == "whole"  ? tr("every pixel")
             : value == "half" ? tr("half the pixels a side")
                               : tr("a quarter of the pixels a side");
    if (name == "average-frames")
      return tr("%n picture(s) averaged", nullptr, QString::fromStdString(value).toInt());
    if (name == "reference-neighbours")
      return tr("reference from %n picture(s)", nullptr, QString::fromStdString(value).toInt());
    if (name == "edge-method")
      return value == "integer" ? tr("edges at whole pixels") : tr("edges between pixels");
    if (name == "edge-columns")
      return tr("edges from %n column(s)", nullptr, QString::fromStdString(value).toInt());
    if (name == "profile-degree")
      return tr("edge curve of degree %1").arg(QString::fromStdString(value));
    if (name == "marker-method")
      return value == "paper"     ? tr("markers as two sorted rows")
             : value == "network" ? tr("markers found by a network")
                                  : tr("markers followed as spots");
    if (name == "reference-method")
      return value == "single"    ? tr("compared with the picture at rest")
             : value == "nearest" ? tr("compared with the nearest picture")
                                  : tr("compared with several pictures");
    if (name == "light-change")
      return value == "ignored" ? tr("light taken as recorded") : tr("light corrected");
    if (name == "undistortion")
      return value == "none" ? tr("lens taken as one that bends nothing")
                             : tr("lens corrected at every point");
    if (name == "rays")
      return value == "parallel" ? tr("parallel rays through the layer")
                                 : tr("exact rays through the layer");
    if (name == "smoothing-px") {
      const double sd_px = QString::fromStdString(value).toDouble();
      return sd_px == 0 ? tr("no smoothing")
                        : tr("smoothing of %1 px").arg(QLocale().toString(sd_px));
    }
    return QString::fromStdString(name + ' ' + value);
  }
};

}  // namespace

QString difference_words(const PipelineSettings& choice, const PipelineSettings& base) {
  QStringList differences;
  for (const auto& setting : pipeline_settings()) {
    const std::string value = setting.get(choice);
    if (value != setting.get(base)) differences << SettingsWords::of(setting.name, value);
  }
  return joined(differences);
}

}  // namespace alltact
