// Qt's Fusion with what it lacks: outlines that can be seen on dark ground, a focus that can be
// seen at all, groups that are a title and a line instead of a box in a box, a button for what
// comes next, and one spacing everywhere.
#pragma once

#include <QProxyStyle>

namespace alltact {

class StudioStyle : public QProxyStyle {
 public:
  StudioStyle();

  void drawPrimitive(PrimitiveElement element,
                     const QStyleOption* option,
                     QPainter* painter,
                     const QWidget* widget = nullptr) const override;
  void drawControl(ControlElement element,
                   const QStyleOption* option,
                   QPainter* painter,
                   const QWidget* widget = nullptr) const override;
  void drawComplexControl(ComplexControl control,
                          const QStyleOptionComplex* option,
                          QPainter* painter,
                          const QWidget* widget = nullptr) const override;
  [[nodiscard]] QRect subControlRect(ComplexControl control,
                                     const QStyleOptionComplex* option,
                                     SubControl part,
                                     const QWidget* widget = nullptr) const override;
  [[nodiscard]] int pixelMetric(PixelMetric metric,
                                const QStyleOption* option = nullptr,
                                const QWidget* widget = nullptr) const override;
};

}  // namespace alltact
