// What is to be saved, and how that goes.
#pragma once

#include "widgets/translated.h"

#include <QComboBox>
#include <QProgressBar>
#include <QPushButton>
#include <array>
#include <optional>

namespace alltact {

/// What can be saved: the endings that files get.
inline constexpr std::array<const char*, 6> kSavedAs{"ply", "vtp", "stl", "glb", "png", "mkv"};

class SaveBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit SaveBar(QWidget* parent = nullptr);

  /// Videos are made of recordings only.
  void set_can_save(bool can_anything, bool can_film);
  /// None: nothing is being saved.
  void show_progress(std::optional<double> fraction);

 Q_SIGNALS:
  void wanted(const QString& ending);
  void stop_wanted();

 private:
  QComboBox* kind_;
  QPushButton *save_, *stop_;
  QProgressBar* progress_;
};

}  // namespace alltact
