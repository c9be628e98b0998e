// A quantity in mm over the face, seen from outside: base left, tip right.
#pragma once

#include "widgets/plots/plot.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct FaceMapData {
  QString quantity;  ///< quantity with its unit: "Residual (mm)"
  double length_mm = 0, width_mm = 0;
  int columns = 0, rows = 0;  ///< cells along and across
  std::vector<double> cells;  ///< row by row from small v; NaN: unknown
  struct Contact {
    double along_mm = 0, across_mm = 0, radius_mm = 0;
    std::string name;        ///< may be empty
    bool is_target = false;  ///< drawn bold and dashed: where a press is needed
    bool is_chosen = false;  ///< drawn bold
  };
  std::vector<Contact> contacts;  ///< drawn as circles
  bool has_base = true;           ///< false: a flat sensor, whose image has a left and a right side
};

class FaceMapPlot : public Plot {
  Q_OBJECT
 public:
  explicit FaceMapPlot(QWidget* parent = nullptr) : Plot(parent) {}
  ~FaceMapPlot() override;
  void set_data(FaceMapData data);
  /// A click into a contact's circle emits contact_chosen from now on.
  void enable_choice();

 Q_SIGNALS:
  /// Index of the smallest contact at the click.
  void contact_chosen(std::size_t contact);

 protected:
  bool draw() override;
  void fit(const QSize& size) override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_face();
  void draw_cells();
  void add_circle(const FaceMapData::Contact& contact, const QPen& pen);
  void draw_contacts();
  [[nodiscard]] std::optional<std::size_t> contact_at(const QPointF& pixel) const;
  FaceMapData data_;
  QObject* scale_ = nullptr;
};

/// Averages values at any positions on the face over the cells of a grid.
class FaceCells {
 public:
  FaceCells(double length_mm, double width_mm, double cell_mm);
  /// Values off the face are ignored.
  void add(double along_mm, double across_mm, double value);
  /// The map with sizes and cells.
  [[nodiscard]] FaceMapData map() const;

 private:
  FaceMapData map_;
  std::vector<double> sums_;
  std::vector<int> counts_;
};

}  // namespace alltact
