// The recordings in a finger's folder, newest first, each with a frame of its middle.
#pragma once

#include "widgets/background_work.h"
#include "widgets/widget_base.h"

#include <QAction>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <filesystem>
#include <optional>
#include <vector>

namespace alltact {

/// Minutes and seconds: "1:05".
[[nodiscard]] QString minutes_text(double seconds);

/// With the file of its times. False: it cannot be moved.
bool move_recording_to_trash(const std::filesystem::path& video);

class RecordingsDialog : public FittedDialog {
  Q_OBJECT
 public:
  /// The folder and its videos are read on a background thread.
  explicit RecordingsDialog(std::filesystem::path finger, QWidget* parent = nullptr);

 Q_SIGNALS:
  void chosen(const std::filesystem::path& recording);

 private:
  struct Recording {
    std::filesystem::path file;
    QDateTime written;
    bool is_reference = false, is_read = false;
    QImage image;  // null: none can be read
    std::optional<double> length_s;
  };
  void list_files();
  void read_next();
  void fill();
  void show_row(int row);
  void follow_choice();
  void open_chosen();
  void ask_for_trash();
  void remove(const std::filesystem::path& file);
  [[nodiscard]] const Recording* selected() const;

  std::filesystem::path finger_;
  std::vector<Recording> recordings_;  // as listed
  bool is_listed_ = false;
  QLabel* note_;
  QListWidget* list_;
  QAction *open_, *folder_, *trash_;
  QPushButton* open_button_;
  QDialogButtonBox* buttons_;
  BackgroundWork reading_;
};

}  // namespace alltact
