#include "widgets/inspect/save_bar.h"

#include <QHBoxLayout>
#include <QStandardItemModel>
#include <cmath>

namespace alltact {

SaveBar::SaveBar(QWidget* parent)
    : Translated(parent),
      kind_(new QComboBox),
      save_(new QPushButton),
      stop_(new QPushButton),
      progress_(new QProgressBar) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  for (const char* ending : kSaveFormats) kind_->addItem(QString(), QLatin1String(ending));
  progress_->setMaximumWidth(160);
  kind_->setMinimumWidth(52);  // px, for small windows
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, stop_, kind_, save_})
    row->addWidget(widget, widget == kind_ ? 1 : 0);
  connect(save_, &QPushButton::clicked, this, [this] {
    Q_EMIT save_requested(kind_->currentData().toString());
  });
  connect(stop_, &QPushButton::clicked, this, &SaveBar::stop_requested);
  say([this] {
    const std::array<QString, kSaveFormats.size()> kinds{tr("Mesh, PLY"),
                                                         tr("Mesh, VTP (VTK)"),
                                                         tr("Mesh, STL"),
                                                         tr("Mesh, glTF"),
                                                         tr("Picture, PNG (300 dpi)"),
                                                         tr("Cross-section, PDF"),
                                                         tr("Cross-section, SVG"),
                                                         tr("Cross-section, CSV"),
                                                         tr("Video in 3D, MKV")};
    for (std::size_t i = 0; i < kinds.size(); ++i)
      kind_->setItemText(static_cast<int>(i), kinds[i]);
    kind_->setAccessibleName(tr("What is saved"));
    save_->setText(tr("&Save…"));
    stop_->setText(tr("Stop"));
    progress_->setAccessibleName(tr("Progress of saving"));
  });
  show_progress(std::nullopt);
  set_can_save({});
}

bool CanSave::saves(const std::string& ending) const {
  if (ending == "png") return image;
  if (ending == "pdf" || ending == "svg" || ending == "csv") return section;
  return ending == "mkv" ? film : surface;
}

void SaveBar::set_can_save(const CanSave& can) {
  auto* model = qobject_cast<QStandardItemModel*>(kind_->model());
  int first = -1;
  for (int i = 0; i < kind_->count(); ++i) {
    const bool is_on = can.saves(kSaveFormats[static_cast<std::size_t>(i)]);
    model->item(i)->setEnabled(is_on);
    if (is_on && first < 0) first = i;
  }
  kind_->setEnabled(first >= 0);
  save_->setEnabled(first >= 0);
  if (first >= 0 && !can.saves(kSaveFormats[static_cast<std::size_t>(kind_->currentIndex())]))
    kind_->setCurrentIndex(first);
}

void SaveBar::show_progress(std::optional<double> fraction) {
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, stop_})
    widget->setVisible(fraction.has_value());
  for (QWidget* widget : std::initializer_list<QWidget*>{kind_, save_})
    widget->setVisible(!fraction.has_value());
  if (!fraction) return;
  progress_->setRange(0, *fraction < 0 ? 0 : 100);
  progress_->setValue(static_cast<int>(std::lround(100 * *fraction)));
}

}  // namespace alltact
