#include "widgets/widget_base.h"

#include "widgets/theme.h"

#include <QAccessibleWidget>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <array>

namespace alltact {
namespace {

constexpr const char* kRole = "alltact_accessible_role";
constexpr const char* kValue = "alltact_accessible_value";

/// Also reports a value as text.
class AccessibleWidget : public QAccessibleWidget {
 public:
  using QAccessibleWidget::QAccessibleWidget;
  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    if (kind == QAccessible::Value) return object()->property(kValue).toString();
    return QAccessibleWidget::text(kind);
  }
};

QAccessibleInterface* make_interface(const QString& /*class_name*/, QObject* object) {
  auto* widget = qobject_cast<QWidget*>(object);
  if (widget == nullptr) return nullptr;
  const QVariant role = widget->property(kRole);
  if (!role.isValid()) return nullptr;
  return new AccessibleWidget(widget, static_cast<QAccessible::Role>(role.toInt()));
}

}  // namespace

void set_accessible_role(QWidget& widget, QAccessible::Role role) {
  static const bool is_installed = (QAccessible::installFactory(make_interface), true);
  static_cast<void>(is_installed);
  widget.setProperty(kRole, static_cast<int>(role));
}

void set_accessible_value(QWidget& widget, const QString& text) {
  if (widget.property(kValue).toString() == text) return;
  widget.setProperty(kValue, text);
  QAccessibleValueChangeEvent event(&widget, text);
  QAccessible::updateAccessibility(&event);
}

void set_accessible_description(QWidget& widget, const QString& text) {
  if (widget.accessibleDescription() == text) return;
  widget.setAccessibleDescription(text);
  QAccessibleEvent event(&widget, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&event);
}

ElidedLabel::ElidedLabel(Qt::TextElideMode cut, QWidget* parent)
    : QLabel(parent), elide_mode_(cut) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ElidedLabel::set_text(const QString& text, int bold) {
  bold_ = bold;
  setText(text);
  setToolTip(text);
  updateGeometry();
}

QFont ElidedLabel::bold_font() const {
  QFont heavy = font();
  heavy.setBold(true);
  return heavy;
}

int ElidedLabel::full_width() const {
  return QFontMetrics(bold_font()).horizontalAdvance(text().left(bold_)) +
         fontMetrics().horizontalAdvance(text().mid(bold_));
}

bool ElidedLabel::is_elided() const { return full_width() > contentsRect().width(); }

QSize ElidedLabel::minimumSizeHint() const { return {1, fontMetrics().height()}; }

QSize ElidedLabel::sizeHint() const { return {full_width() + 1, fontMetrics().height()}; }

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(
      palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
  QRect room = contentsRect();
  const QString head = text().left(bold_);
  if (!head.isEmpty()) {
    painter.setFont(bold_font());
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, head);
    room.setLeft(room.left() + QFontMetrics(bold_font()).horizontalAdvance(head));
    painter.setFont(font());
  }
  painter.drawText(
      room, static_cast<int>(alignment() & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter,
      fontMetrics().elidedText(text().mid(bold_), elide_mode_, std::max(0, room.width())));
}

QLabel* wrapped_label() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  return label;
}

QLabel* wrapped_text() {
  QLabel* label = wrapped_label();
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

ReservedText::ReservedText(int lines) : lines_(lines) {
  setWordWrap(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  setAlignment(Qt::AlignLeft | Qt::AlignTop);
}

void ReservedText::reserve_for(const QStringList& texts) {
  texts_ = texts;
  updateGeometry();
}

int ReservedText::reserved_height(int width_px) const {
  int height = lines_ * fontMetrics().lineSpacing();
  for (const QString& text : texts_)
    height = std::max(
        height, fontMetrics().boundingRect(0, 0, width_px, 10000, Qt::TextWordWrap, text).height());
  return height;
}

int ReservedText::heightForWidth(int width_px) const {
  return std::max(QLabel::heightForWidth(width_px), reserved_height(width_px));
}

QSize ReservedText::sizeHint() const {
  const QSize hint = QLabel::sizeHint();
  return hint.expandedTo({0, lines_ * fontMetrics().lineSpacing()});
}

QSize ReservedText::minimumSizeHint() const {
  return QLabel::minimumSizeHint().expandedTo({0, lines_ * fontMetrics().lineSpacing()});
}

void reserve_room(QWidget& widget) {
  QSizePolicy policy = widget.sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  widget.setSizePolicy(policy);
}

QString without_mnemonic(QString text) {
  static const QRegularExpression behind(QStringLiteral("\\(&[^&]\\)"));
  const QChar ampersand(1);
  text.replace(QLatin1String("&&"), ampersand);
  text.remove(behind).remove(QLatin1Char('&'));
  return text.replace(ampersand, QLatin1Char('&'));
}

QString elided_path(const QString& path, const QFontMetrics& metrics, int room) {
  return metrics.elidedText(path, Qt::ElideLeft, room);
}

void show_dialog(QDialog& dialog) {
  dialog.setAttribute(Qt::WA_DeleteOnClose);
  dialog.show();
}

QString video_filter(const QString& more) {
  QStringList patterns;
  for (const char* ending : {"mkv", "webm", "avi", "mp4", "m4v", "mov", "ts", "mpg", "wmv"})
    for (const QString& one : {QString::fromLatin1(ending), QString::fromLatin1(ending).toUpper()})
      patterns << QStringLiteral("*.") + one;
  if (!more.isEmpty()) patterns << more;
  const QString videos = QCoreApplication::translate("alltact::FileFilter", "Videos (%1)")
                             .arg(patterns.join(QLatin1Char(' ')));
  return videos + QLatin1String(";;") + all_files_filter();
}

QString all_files_filter() {
  return QCoreApplication::translate("alltact::FileFilter", "All files (*)");
}

QString image_filter() {
  return QCoreApplication::translate("alltact::FileFilter",
                                     "Images (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)");
}

void begin_in_last_folder(QFileDialog& dialog, FilesOf what, const QString& otherwise) {
  static const std::array<const char*, 8> kNames{"fingers", "recordings", "images",  "cameras",
                                                 "meshes",  "grippers",   "exports", "recipes"};
  const QString key =
      QStringLiteral("folders/") + QLatin1String(kNames.at(static_cast<std::size_t>(what) - 1));
  // Of the open finger, set by the main window. Other fingers lie next to it.
  QString finger = QCoreApplication::instance()->property("alltact_finger_folder").toString();
  if (what == FilesOf::kFingers && !finger.isEmpty()) finger = QFileInfo(finger).absolutePath();
  for (const QString& folder :
       {QSettings().value(key).toString(), otherwise, finger,
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation), QDir::homePath()})
    if (!folder.isEmpty() && QDir(folder).exists()) {
      dialog.setDirectory(folder);
      break;
    }
  QObject::connect(&dialog, &QFileDialog::filesSelected, &dialog, [key](const QStringList& files) {
    QSettings().setValue(key, QFileInfo(files.front()).absolutePath());
  });
}

namespace {

void ask_for(QFileDialog::FileMode mode, QWidget* parent, FilesOf what, const QString& title,
             const QString& filter, const UsePath& use, const QString& start) {
  auto* dialog = new QFileDialog(parent, title, start, filter);
  dialog->setFileMode(mode);
  begin_in_last_folder(*dialog, what);
  if (!start.isEmpty()) dialog->setDirectory(start);
  QObject::connect(dialog, &QFileDialog::fileSelected, dialog, use);
  show_dialog(*dialog);
}

}  // namespace

void ask_for_file(QWidget* parent, FilesOf what, const QString& title, const QString& filter,
                  const UsePath& use, const QString& start) {
  const QFileInfo file(start);
  ask_for(QFileDialog::ExistingFile, parent, what, title, filter, use,
          start.isEmpty() || file.isDir() ? start : file.absolutePath());
}

void ask_for_folder(QWidget* parent, FilesOf what, const QString& title, const UsePath& use,
                    const QString& start) {
  ask_for(QFileDialog::Directory, parent, what, title, {}, use, start);
}

void ask_where_to_save(QWidget* parent, FilesOf what, const QString& title, const QString& ending,
                       const QString& name, const UsePath& use) {
  auto* dialog = new QFileDialog(parent, title);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(ending);
  dialog->setNameFilter(QStringLiteral("*.") + ending);
  begin_in_last_folder(*dialog, what);
  if (!name.isEmpty()) dialog->selectFile(name);
  QObject::connect(dialog, &QFileDialog::fileSelected, dialog, use);
  show_dialog(*dialog);
}

AgeLabel::AgeLabel(QWidget* parent) : Translated<QLabel>(parent) {
  say([this] {
    setAccessibleName(tr("Image age"));
    show_now();
  });
}

void AgeLabel::show_age(std::optional<double> age_ms) {
  age_ms_ = age_ms;
  show_now();
}

void AgeLabel::show_now() {
  const QLocale locale;
  constexpr double kSecond_ms = 1000;
  const bool was_late = std::exchange(is_late_, age_ms_ && *age_ms_ > kLate_ms);
  QString text = tr("images without timestamps");
  if (age_ms_ && *age_ms_ >= kSecond_ms)
    text = tr("image %1 s old").arg(locale.toString(*age_ms_ / kSecond_ms, 'f', 1));
  else if (age_ms_)
    text = tr("image %1 ms old").arg(locale.toString(*age_ms_, 'f', 0));
  // The sign does not rely on the colour.
  setText(is_late_ ? QString(QChar(0x25b2)) + QLatin1Char(' ') + text : text);
  setToolTip(is_late_ ? tr("Motion appears late. Close other programs, or choose a faster setting "
                           "on the Accuracy page.")
                      : QString());
  if (is_late_ != was_late) colour();
}

void AgeLabel::colour() {
  QPalette own;
  if (is_late_)
    own.setColor(QPalette::WindowText, meaning_colour(Meaning::kBad, QApplication::palette(this)));
  setPalette(own);
}

void AgeLabel::changeEvent(QEvent* event) {
  Translated<QLabel>::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && is_late_) colour();
}

}  // namespace alltact
