// Choice of a file format, and the progress of saving.
#pragma once

#include "widgets/translated.h"

#include <QComboBox>
#include <QProgressBar>
#include <QPushButton>
#include <array>
#include <optional>
#include <string>

namespace alltact {

/// File endings of all formats.
inline constexpr std::array<const char*, 9> kSaveFormats{
    "ply", "vtp", "stl", "glb", "png", "pdf", "svg", "csv", "mkv"};

struct CanSave {
  bool surface = false;  ///< PLY, VTP, STL, glTF
  bool image = false;    ///< PNG
  bool section = false;  ///< PDF, SVG, CSV of the cross-section
  bool film = false;     ///< MKV
  [[nodiscard]] bool saves(const std::string& ending) const;
};

class SaveBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit SaveBar(QWidget* parent = nullptr);

  void set_can_save(const CanSave& can);
  /// None: nothing is being saved. Below 0: saving continues until it is stopped.
  void show_progress(std::optional<double> fraction);

 Q_SIGNALS:
  void save_requested(const QString& ending);
  void stop_requested();

 private:
  QComboBox* kind_;
  QPushButton *save_, *stop_;
  QProgressBar* progress_;
};

}  // namespace alltact
