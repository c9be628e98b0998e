#include "tests/studio/layout_rig.h"

#include "widgets/image/image_view.h"
#include "widgets/panels/recording_checks.h"
#include "widgets/plots/plot.h"
#include "widgets/widget_base.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenuBar>
#include <QOpenGLWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSizeGrip>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QTextDocument>
#include <QToolButton>
#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace alltact::test {
namespace {

constexpr int kStep_px = 8;
constexpr QChar kEllipsis{0x2026};

bool is_shown(const QWidget& widget) {
  return widget.isVisible() && widget.width() > 0 && widget.height() > 0;
}

std::vector<const QWidget*> shown_below(const QWidget& root) {
  std::vector<const QWidget*> shown;
  for (const QWidget* widget : root.findChildren<QWidget*>())
    if (is_shown(*widget) && widget->window() == root.window()) shown.push_back(widget);
  return shown;
}

QString shown_text(const QWidget& widget) {
  for (const char* property : {"text", "title", "currentText"})
    if (widget.property(property).isValid()) return widget.property(property).toString();
  return {};
}

std::string told_of(const QWidget& widget) {
  QString text = shown_text(widget);
  if (text.isEmpty()) text = widget.accessibleName();
  text.replace(QLatin1Char('\n'), QLatin1Char(' '));
  return fmt::format("{} '{}' ({} x {})", widget.metaObject()->className(),
                     text.left(60).toStdString(), widget.width(), widget.height());
}

/// Without the letter that chooses it.
QString unmarked(QString text) { return text.remove(QLatin1Char('&')); }

bool is_told_by_tip(const QWidget& widget, const QString& text) {
  return !text.isEmpty() && widget.toolTip().contains(text);
}

/// The space that a text needs beyond what it has; 0: none.
QSize lacking(const QSize& wanted, const QSize& given) {
  return {std::max(0, wanted.width() - given.width()),
          std::max(0, wanted.height() - given.height())};
}

QSize lack_of_label(const QLabel& label) {
  if (label.text().isEmpty()) return {0, 0};
  if (const auto* line = qobject_cast<const ElidedLabel*>(&label);
      line != nullptr && line->is_elided())
    return is_told_by_tip(label, label.text()) ? QSize(0, 0) : QSize(1, 0);
  if (!label.wordWrap()) return lacking(label.sizeHint(), label.size());
  return lacking({label.minimumSizeHint().width(), label.heightForWidth(label.width())},
                 label.size());
}

QSize lack_of_button(const QAbstractButton& button) {
  if (button.text().isEmpty()) return {0, 0};
  return lacking(button.minimumSizeHint(), button.size());
}

QSize lack_of_field(const QLineEdit& field) {
  const QString text = field.text().isEmpty() ? field.placeholderText() : field.text();
  constexpr int kInside = 4;  // px of a field beside its text
  const int lack = field.fontMetrics().horizontalAdvance(text) + kInside - field.width();
  return lack > 0 && !is_told_by_tip(field, text) ? QSize(lack, 0) : QSize(0, 0);
}

QSize lack_of_choice(const QComboBox& box) {
  QStyleOptionComboBox option;
  option.initFrom(&box);
  option.editable = box.isEditable();
  const QRect room =
      box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
  const int lack = box.fontMetrics().horizontalAdvance(box.currentText()) - room.width();
  return lack > 0 && !is_told_by_tip(box, box.currentText()) ? QSize(lack, 0) : QSize(0, 0);
}

QSize lack_of(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return lack_of_label(*label);
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    return lack_of_button(*button);
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return lack_of_choice(*box);
  if (const auto* field = qobject_cast<const QLineEdit*>(&widget)) return lack_of_field(*field);
  if (const auto* group = qobject_cast<const QGroupBox*>(&widget);
      group && !group->title().isEmpty())
    return lacking({group->minimumSizeHint().width(), 0}, group->size());
  return {0, 0};
}

/// px by which the widget stands out of what cuts it off: its parents up to one that scrolls there.
QSize cut_off(const QWidget& widget) {
  int right = 0, bottom = 0;
  bool looks_right = true, looks_down = true;
  const QRect own = widget.rect();
  for (const QWidget* parent = widget.parentWidget(); parent != nullptr && !widget.isWindow();
       parent = parent->parentWidget()) {
    const QRect seen(widget.mapTo(parent, own.topLeft()), own.size());
    if (looks_right) right = std::max({right, seen.right() - parent->width() + 1, -seen.left()});
    if (looks_down) bottom = std::max({bottom, seen.bottom() - parent->height() + 1, -seen.top()});
    if (const auto* area = qobject_cast<const QAbstractScrollArea*>(parent)) {
      looks_right = looks_right && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff;
      looks_down = looks_down && area->verticalScrollBarPolicy() == Qt::ScrollBarAlwaysOff;
    }
    // Its viewport stands before the area itself.
    const auto* around = qobject_cast<const QAbstractScrollArea*>(parent->parentWidget());
    if (around != nullptr && around->viewport() == parent) {
      if (around->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) looks_right = false;
      if (around->verticalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) looks_down = false;
    }
    if (parent->isWindow()) break;
  }
  return {right, bottom};
}

/// Above a content that scrolls, what lies further down is cut off on purpose.
bool scrolls_down(const QWidget& widget) {
  for (const QWidget* parent = widget.parentWidget(); parent != nullptr;
       parent = parent->parentWidget()) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(parent);
    if (area != nullptr && area->verticalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) return true;
  }
  return false;
}

void add_tabs(const QTabBar& bar, std::vector<std::string>& found) {
  for (int i = 0; i < bar.count(); ++i)
    if (bar.fontMetrics().horizontalAdvance(unmarked(bar.tabText(i))) > bar.tabRect(i).width() ||
        bar.tabRect(i).right() >= bar.width())
      found.push_back(fmt::format("tab '{}' is cut", bar.tabText(i).toStdString()));
}

/// Whether a text with wrapped words has room in a head of this width and height.
bool fits_wrapped(const QHeaderView& header, const QString& text, int width) {
  const QFontMetrics metrics = header.fontMetrics();
  const QRect needed = metrics.boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, text);
  return needed.width() <= width && needed.height() <= header.height();
}

void add_heads(const QHeaderView& header, std::vector<std::string>& found) {
  if (header.orientation() != Qt::Horizontal || header.model() == nullptr) return;
  for (int i = 0; i < header.count(); ++i) {
    const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
    const QString tip = header.model()->headerData(i, Qt::Horizontal, Qt::ToolTipRole).toString();
    const bool is_wrapped = header.defaultAlignment().testFlag(Qt::AlignmentFlag(Qt::TextWordWrap));
    const bool is_cut = is_wrapped ? !fits_wrapped(header, text, header.sectionSize(i))
                                   : header.sectionSizeHint(i) > header.sectionSize(i);
    if (!header.isSectionHidden(i) && is_cut && tip.isEmpty())
      found.push_back(fmt::format("head '{}' of a column is cut", text.toStdString()));
  }
}

/// Rows that do not scroll sideways.
void add_rows(const QAbstractItemView& view, std::vector<std::string>& found) {
  const auto* list = qobject_cast<const QListView*>(&view);
  if (view.model() == nullptr || (list != nullptr && list->wordWrap())) return;
  const auto* table = qobject_cast<const QTableView*>(&view);
  const int rows = std::min(view.model()->rowCount(), 30);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < view.model()->columnCount(); ++column) {
      const QModelIndex at = view.model()->index(row, column);
      const QRect room = view.visualRect(at);
      const bool is_elided = table != nullptr
                                 ? view.sizeHintForIndex(at).width() > room.width()
                                 : view.horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
                                       view.sizeHintForIndex(at).width() > view.viewport()->width();
      const QString text = at.data().toString();
      if (is_elided && !room.isEmpty() && !at.data(Qt::ToolTipRole).toString().contains(text))
        found.push_back(fmt::format("row '{}' is cut", text.left(60).toStdString()));
    }
}

/// Parts of Qt's own widgets, which it lays out itself.
bool is_part_of_another(const QWidget& widget) {
  const QWidget* parent = widget.parentWidget();
  return widget.objectName().startsWith(QLatin1String("qt_")) ||
         qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
         qobject_cast<const QComboBox*>(parent) != nullptr ||
         qobject_cast<const QSizeGrip*>(&widget) != nullptr ||
         qobject_cast<const QScrollBar*>(&widget) != nullptr;
}

bool shows_text(const QWidget& widget) {
  return !shown_text(widget).isEmpty() || qobject_cast<const QLineEdit*>(&widget) != nullptr;
}

bool shows_picture(const QWidget& widget) {
  return qobject_cast<const ImageView*>(&widget) != nullptr ||
         qobject_cast<const Plot*>(&widget) != nullptr ||
         qobject_cast<const CoverageView*>(&widget) != nullptr ||
         qobject_cast<const QOpenGLWidget*>(&widget) != nullptr ||
         widget.property("alltact_drawing").toBool();
}

bool is_in_a_picture(const QWidget& widget) {
  for (const QWidget* parent = widget.parentWidget(); parent != nullptr;
       parent = parent->parentWidget())
    if (shows_picture(*parent)) return true;
  return false;
}

/// Where the text of a label or the last row of a list really stands, in the widget's pixels.
QRect content_of_label(const QLabel& label) {
  const bool is_wrapped = label.wordWrap();
  const QSize hint = label.sizeHint();
  const int width = is_wrapped ? label.width() : std::min(label.width(), hint.width());
  const int height =
      std::min(label.height(), is_wrapped ? label.heightForWidth(label.width()) : hint.height());
  return QStyle::alignedRect(label.layoutDirection(), label.alignment(), QSize(width, height),
                             label.rect());
}

QRect content_of_view(const QAbstractItemView& view) {
  QRect rows;
  const auto* model = view.model();
  const int count = model == nullptr ? 0 : model->rowCount();
  for (const int row : {0, count - 1})
    if (count > 0)
      for (const int column : {0, model->columnCount() - 1})
        rows |= view.visualRect(model->index(row, column));
  QRect all = rows.translated(view.viewport()->pos()) & view.rect();
  if (const auto* table = qobject_cast<const QTableView*>(&view);
      table && table->horizontalHeader()->isVisible())
    all |= table->horizontalHeader()->geometry();
  return all;
}

/// In the widget's own pixels; empty for what only holds others.
QRect content_of(const QWidget& widget) {
  if (const auto* view = qobject_cast<const ImageView*>(&widget))
    return view->image().empty() ? QRect() : view->rect();
  if (shows_picture(widget)) return widget.rect();
  if (const auto* label = qobject_cast<const QLabel*>(&widget))
    return label->text().isEmpty() && label->pixmap(Qt::ReturnByValue).isNull()
               ? QRect()
               : content_of_label(*label);
  if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget))
    return content_of_view(*view);
  if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
    return {0, 0, widget.width(), group->title().isEmpty() ? 0 : widget.fontMetrics().height()};
  const bool is_control =
      qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
      qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
      qobject_cast<const QAbstractSlider*>(&widget) || widget.inherits("QProgressBar") ||
      widget.inherits("QTextEdit") || widget.property("alltact_drawing").toBool();
  return is_control ? widget.rect() : QRect();
}

/// Largest rectangle of free cells, by the heights of free columns above each row.
QRect largest_free(const std::vector<std::vector<bool>>& taken) {
  const std::size_t rows = taken.size(), columns = rows == 0 ? 0 : taken.front().size();
  std::vector<int> height(columns, 0);
  QRect best;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < columns; ++i) height[i] = taken[row][i] ? 0 : height[i] + 1;
    for (std::size_t first = 0; first < columns; ++first) {
      int low = height[first];
      for (std::size_t last = first; last < columns && low > 0; ++last) {
        low = std::min(low, height[last]);
        const int width = static_cast<int>(last - first) + 1;
        if (width * low > best.width() * best.height())
          best = {static_cast<int>(first), static_cast<int>(row) - low + 1, width, low};
      }
    }
  }
  return best;
}

}  // namespace

std::vector<std::string> cut_texts(const QWidget& root) {
  std::vector<std::string> found;
  for (const QWidget* widget : shown_below(root)) {
    if (const auto* bar = qobject_cast<const QTabBar*>(widget)) add_tabs(*bar, found);
    if (const auto* header = qobject_cast<const QHeaderView*>(widget))
      add_heads(*header, found);
    else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget))
      add_rows(*view, found);
    if (is_part_of_another(*widget)) continue;
    if (const QSize lack = lack_of(*widget); lack.width() > 0 || lack.height() > 0)
      found.push_back(fmt::format("{} lacks {} x {} px for its text", told_of(*widget),
                                  lack.width(), lack.height()));
    if (!shows_text(*widget)) continue;
    const QSize out = cut_off(*widget);
    if (out.width() > 0 || (out.height() > 0 && !scrolls_down(*widget)))
      found.push_back(fmt::format("{} is cut off by {} x {} px by what it stands in",
                                  told_of(*widget), out.width(), out.height()));
  }
  return found;
}

std::vector<std::string> overlaps(const QWidget& root) {
  std::vector<std::string> found;
  std::vector<const QWidget*> parents = shown_below(root);
  parents.push_back(&root);
  for (const QWidget* parent : parents) {
    if (shows_picture(*parent) || is_part_of_another(*parent)) continue;
    std::vector<const QWidget*> children;
    for (const QObject* child : parent->children()) {
      const auto* widget = qobject_cast<const QWidget*>(child);
      if (widget == nullptr || widget->isWindow() || !is_shown(*widget) ||
          is_part_of_another(*widget) || widget->inherits("QRubberBand") ||
          widget->inherits("QFocusFrame"))
        continue;
      children.push_back(widget);
    }
    for (std::size_t i = 0; i < children.size(); ++i)
      for (std::size_t k = i + 1; k < children.size(); ++k) {
        const QRect both = children[i]->geometry() & children[k]->geometry();
        if (both.isEmpty()) continue;
        found.push_back(fmt::format("{} and {} share {} x {} px", told_of(*children[i]),
                                    told_of(*children[k]), both.width(), both.height()));
      }
  }
  return found;
}

std::vector<std::string> blank_pictures(const QWidget& root) {
  std::vector<std::string> found;
  for (const QWidget* widget : shown_below(root)) {
    const bool is_drawn = shows_picture(*widget) && !qobject_cast<const QOpenGLWidget*>(widget);
    if (!is_drawn || widget->visibleRegion().isEmpty()) continue;
    const auto* view = qobject_cast<const ImageView*>(widget);
    if (view != nullptr && view->image().empty()) continue;  // nothing to show yet
    // Drawing changes nothing that a widget shows.
    const QImage image = const_cast<QWidget*>(widget)->grab().toImage();
    std::map<QRgb, int> count;
    int most = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) most = std::max(most, ++count[image.pixel(x, y)]);
    if (most > 0.995 * image.width() * image.height())
      found.push_back(fmt::format("{} is blank", told_of(*widget)));
  }
  return found;
}

double pictured_part(const QWidget& page) {
  double area = 0;
  for (const QWidget* widget : shown_below(page))
    if (shows_picture(*widget) && !is_in_a_picture(*widget))
      area += static_cast<double>(widget->width()) * widget->height();
  return area / (static_cast<double>(page.width()) * page.height());
}

QRect largest_empty(const QWidget& page) {
  const auto columns = static_cast<std::size_t>(page.width() / kStep_px);
  const auto rows = static_cast<std::size_t>(page.height() / kStep_px);
  std::vector<std::vector<bool>> taken(rows, std::vector<bool>(columns, false));
  for (const QWidget* widget : shown_below(page)) {
    const QRect own = content_of(*widget);
    if (own.isEmpty()) continue;
    const QRect placed = QRect(widget->mapTo(&page, own.topLeft()), own.size()) & page.rect();
    for (int y = placed.top() / kStep_px; y <= placed.bottom() / kStep_px; ++y)
      for (int x = placed.left() / kStep_px; x <= placed.right() / kStep_px; ++x)
        if (y >= 0 && x >= 0 && static_cast<std::size_t>(y) < rows &&
            static_cast<std::size_t>(x) < columns)
          taken[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = true;
  }
  const QRect cells = largest_free(taken);
  return {kStep_px * cells.topLeft(), kStep_px * cells.size()};
}

double empty_part(const QWidget& page) {
  const QRect empty = largest_empty(page);
  return static_cast<double>(empty.width()) * empty.height() /
         (static_cast<double>(page.width()) * page.height());
}

}  // namespace alltact::test
