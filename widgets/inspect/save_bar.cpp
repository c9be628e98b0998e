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
  for (const char* ending : kSavedAs) kind_->addItem(QString(), QLatin1String(ending));
  progress_->setMaximumWidth(160);
  kind_->setMinimumWidth(52);  // where the window is small
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, stop_, kind_, save_})
    row->addWidget(widget);
  connect(save_, &QPushButton::clicked, this, [this] {
    Q_EMIT wanted(kind_->currentData().toString());
  });
  connect(stop_, &QPushButton::clicked, this, &SaveBar::stop_wanted);
  say([this] {
    const std::array<QString, kSavedAs.size()> kinds{tr("Mesh, PLY"),
                                                     tr("Mesh, VTP (VTK)"),
                                                     tr("Mesh, STL"),
                                                     tr("Mesh, glTF"),
                                                     tr("Picture, PNG"),
                                                     tr("Video in 3D, MKV")};
    for (std::size_t i = 0; i < kinds.size(); ++i)
      kind_->setItemText(static_cast<int>(i), kinds[i]);
    kind_->setAccessibleName(tr("What is saved"));
    save_->setText(tr("&Save…"));
    stop_->setText(tr("Stop"));
    progress_->setAccessibleName(tr("Progress of saving"));
  });
  show_progress(std::nullopt);
  set_can_save(false, false);
}

void SaveBar::set_can_save(bool can_anything, bool can_film) {
  kind_->setEnabled(can_anything);
  save_->setEnabled(can_anything);
  auto* model = qobject_cast<QStandardItemModel*>(kind_->model());
  model->item(static_cast<int>(kSavedAs.size()) - 1)->setEnabled(can_film);
  if (!can_film && kind_->currentIndex() == static_cast<int>(kSavedAs.size()) - 1)
    kind_->setCurrentIndex(0);
}

void SaveBar::show_progress(std::optional<double> fraction) {
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, stop_})
    widget->setVisible(fraction.has_value());
  for (QWidget* widget : std::initializer_list<QWidget*>{kind_, save_})
    widget->setVisible(!fraction.has_value());
  if (fraction) progress_->setValue(static_cast<int>(std::lround(100 * *fraction)));
}

}  // namespace alltact
