// Lists the connected cameras and reports each change.
#pragma once

#include "core/sources/v4l2/camera_list.h"

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

namespace alltact {

/// Lists on a background thread, because a camera may answer slowly.
class CameraFinder : public QObject {
  Q_OBJECT
 public:
  using Lister = std::function<std::vector<FoundCamera>()>;

  explicit CameraFinder(Lister lister = {}, QObject* parent = nullptr);
  ~CameraFinder() override;
  [[nodiscard]] const std::vector<FoundCamera>& cameras() const { return cameras_; }

 Q_SIGNALS:
  void cameras_changed();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  std::vector<FoundCamera> cameras_;
};

}  // namespace alltact
