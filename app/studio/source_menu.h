// The menu of cameras and other sources of frames, and its dialogs. No dialog stops running work.
#pragma once

#include "app/studio/workspace.h"
#include "widgets/live/camera_finder.h"
#include "widgets/translated.h"

#include <QFileDialog>
#include <QMenu>

namespace alltact {

class SourceMenu : public Translated<QMenu> {
  Q_OBJECT
 public:
  /// `window` has the dialogs.
  SourceMenu(Workspace& work, const CameraFinder& finder, QWidget* window);

  void open_simulated();
  /// A full day: the finger is bent to be recorded, then pressed and held still.
  void open_simulated_day();
  void choose_video();
  void choose_folder();

 Q_SIGNALS:
  /// Nothing was opened.
  void failed(const alltact::Error& why);

 private:
  void fill();
  void choose_scene();
  void open_shipped(const char* name);
  void choose(const QString& title, QFileDialog::FileMode mode, const QString& filter = {});

  Workspace& work_;
  const CameraFinder& finder_;
};

}  // namespace alltact
