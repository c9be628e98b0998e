// Something in mm over the face, seen from outside: base left, tip right.
#pragma once

#include "widgets/plots/plot.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct FaceMapData {
  QString quantity;  ///< what is shown, with its unit: "Residual (mm)"
  double length_mm = 0, width_mm = 0;
  int columns = 0, rows = 0;  ///< cells along and across
  std::vector<double> cells;  ///< row by row from small v, NaN: nothing is known there
  struct Contact {
    double along_mm = 0, across_mm = 0, radius_mm = 0;
    std::string name;        ///< may be empty
    bool is_wanted = false;  ///< drawn bold and dashed: where there should be one
    bool is_chosen = false;  ///< drawn bold
  };
  std::vector<Contact> contacts;  ///< drawn as circles
  bool has_base = true;           ///< false: a flat sensor, whose picture has a left and a right
};

class FaceMapPlot : public Plot {
  Q_OBJECT
 public:
  explicit FaceMapPlot(QWidget* parent = nullptr) : Plot(parent) {}
  ~FaceMapPlot() override;
  void set_data(FaceMapData data);
  /// From now on a click into a contact's circle tells of it.
  void let_choose();

 Q_SIGNALS:
  /// Of the data's contacts, the smallest there.
  void contact_chosen(std::size_t contact);

 protected:
  bool draw() override;
  void fit(const QSize& size) override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_face();
  void draw_cells();
  void draw_contacts();
  [[nodiscard]] std::optional<std::size_t> contact_at(const QPointF& place) const;
  FaceMapData data_;
  QObject* scale_ = nullptr;
};

/// Gathers values that lie anywhere on the face into cells: the mean of each cell.
class FaceCells {
 public:
  FaceCells(double length_mm, double width_mm, double cell_mm);
  /// Off the face it is ignored.
  void add(double along_mm, double across_mm, double value);
  /// Sizes and cells of a map.
  [[nodiscard]] FaceMapData map() const;

 private:
  FaceMapData map_;
  std::vector<double> sums_;
  std::vector<int> counts_;
};

}  // namespace alltact
