#include "widgets/panels/image_panel.h"

#include "widgets/image/image_view.h"
#include "widgets/image/overlays.h"
#include "widgets/language.h"
#include "widgets/theme.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPainter>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <cmath>

namespace alltact {
namespace {

constexpr int kFlash_ms = 500;
constexpr int kStripIcon = 16;

}  // namespace

ImagePanel::ImagePanel(LiveSession& session, QWidget* parent)
    : Translated(parent),
      session_(session),
      column_(new QVBoxLayout(this)),
      strip_(new QHBoxLayout),
      title_(new QLabel),
      view_(new ImageView),
      readout_(new ElidedLabel),
      zoom_(new QLabel),
      freeze_(new QToolButton),
      snapshot_(new QToolButton),
      zoom_in_(new QToolButton),
      zoom_out_(new QToolButton),
      fit_(new QToolButton),
      actual_(new QToolButton) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(2);
  title_->hide();
  title_->setMinimumWidth(1);
  column_->addWidget(title_);
  column_->addWidget(view_, 1);
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  zoom_->setMinimumWidth(zoom_->fontMetrics().horizontalAdvance(QStringLiteral("6400 %")));
  zoom_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  strip_->addWidget(readout_, 1);
  strip_->addWidget(zoom_);
  strip_->setSpacing(2);
  for (QToolButton* button : {freeze_, snapshot_, zoom_out_, zoom_in_, fit_, actual_}) {
    button->setAutoRaise(true);
    button->setIconSize({kStripIcon, kStripIcon});
    strip_->addWidget(button);
  }
  freeze_->setCheckable(true);
  flash_.setSingleShot(true);
  flash_.setInterval(kFlash_ms);
  connect(&flash_, &QTimer::timeout, this, &ImagePanel::show_frame);
  connect(freeze_, &QToolButton::clicked, this, &ImagePanel::freeze);
  connect(snapshot_, &QToolButton::clicked, this, &ImagePanel::save_snapshot);
  column_->addLayout(strip_);
  connect(zoom_in_, &QToolButton::clicked, view_, [this] { view_->zoom_by(1.5); });
  connect(zoom_out_, &QToolButton::clicked, view_, [this] { view_->zoom_by(1 / 1.5); });
  connect(fit_, &QToolButton::clicked, view_, &ImageView::fit);
  connect(actual_, &QToolButton::clicked, view_, &ImageView::show_actual_size);
  connect(view_, &ImageView::probe_changed, this, &ImagePanel::show_readout);
  connect(view_, &ImageView::zoom_changed, this, &ImagePanel::show_zoom);
  connect(&session_, &LiveSession::view_ready, this, [this] {
    if (!instead_ && !frozen_) show_frame();
  });
  connect(&session_, &LiveSession::status_ready, this, &ImagePanel::show_state);
  set_icons();
  say([this] {
    const auto name = [](QToolButton* button, const QString& text, const QString& key) {
      button->setAccessibleName(text);
      button->setToolTip(QStringLiteral("%1 (%2)").arg(text, key));
    };
    name(zoom_in_, tr("Zoom in"), QStringLiteral("+"));
    name(zoom_out_, tr("Zoom out"), QStringLiteral("-"));
    name(fit_, tr("Show the entire image"), QStringLiteral("0"));
    name(actual_, tr("Show the image at original size"), QStringLiteral("1"));
    actual_->setText(tr("1:1"));
    freeze_->setAccessibleName(tr("Freeze the image"));
    freeze_->setToolTip(tr("Freeze this image; measuring continues"));
    snapshot_->setAccessibleName(tr("Save the image"));
    snapshot_->setToolTip(tr("Save the image, with or without its overlays"));
    readout_->setAccessibleName(tr("Values at the probe"));
    zoom_->setAccessibleName(tr("Zoom"));
    show_state();
    show_readout();
  });
}

void ImagePanel::set_options(const ViewOptions& options) {
  options_ = options;
  show_frame();
}

void ImagePanel::show_instead(std::shared_ptr<const LiveView> view) {
  instead_ = std::move(view);
  show_frame();
  show_state();
}

void ImagePanel::set_title(const QString& title) {
  title_->setText(title);
  if (title_->isHidden() == title.isEmpty()) return;
  title_->setVisible(!title.isEmpty());
  strip_->removeWidget(readout_);
  column_->removeWidget(readout_);
  if (title.isEmpty())
    strip_->insertWidget(0, readout_, 1);
  else
    column_->insertWidget(column_->indexOf(view_) + 1, readout_);
}

const std::shared_ptr<const LiveView>& ImagePanel::live() const {
  if (frozen_) return frozen_;
  return instead_ ? instead_ : session_.view();
}

void ImagePanel::set_extra_overlays(ExtraOverlays extra) {
  extra_overlays_ = std::move(extra);
  show_frame();
}

void ImagePanel::freeze(bool is_frozen) {
  frozen_ = is_frozen ? live() : nullptr;
  freeze_->setChecked(frozen_ != nullptr);
  show_frame();
}

void ImagePanel::flash(const QString& words) {
  flash_words_ = words;
  flash_.start();
  show_frame();
}

std::vector<Overlay> ImagePanel::overlays() const {
  std::vector<Overlay> overlays = overlays_for(*live(), options_);
  if (extra_overlays_)
    for (Overlay& one : extra_overlays_(*live())) overlays.push_back(std::move(one));
  if (frozen_) overlays.push_back(banner_overlay(tr("Frozen")));
  return overlays;
}

void ImagePanel::show_frame() {
  if (!isVisible() || !live() || live()->result.grey.empty()) return;
  std::vector<Overlay> drawn = overlays();
  if (flash_.isActive()) drawn.push_back(flash_overlay(flash_words_));
  view_->show_image(live()->result.grey, std::move(drawn));
  show_readout();
}

void ImagePanel::save_snapshot() {
  if (!live() || live()->result.grey.empty()) return;
  choose_snapshot(live()->result.grey, overlays(), *this);
}

QString ImagePanel::message() const {
  switch (session_.status().source.state) {
    case SourceState::kOpening:
      return tr("The source is being opened.");
    case SourceState::kFailed:
      return tr("The source could not be opened; the reason is above.");
    case SourceState::kClosed:
      return tr("No source is open. Choose a camera, a recording or the simulated finger.");
    default:
      return tr("Waiting for the first image.");
  }
}

void ImagePanel::show_state() {
  if (frozen_ && session_.status().source.state == SourceState::kClosed) freeze(false);
  freeze_->setEnabled(live() != nullptr);
  snapshot_->setEnabled(live() != nullptr);
  if (!live()) view_->show_message(message());
}

void ImagePanel::show_readout() {
  const auto probe = view_->probe();
  const auto& shown = live();
  const bool is_inside =
      probe && shown &&
      QRect(0, 0, shown->result.grey.cols, shown->result.grey.rows).contains(*probe);
  readout_->set_text(is_inside ? readout_text(*shown, *probe)
                               : tr("Point at a pixel, or press Shift and an arrow key."));
}

void ImagePanel::show_zoom() {
  const double percent = 100 * view_->transform().scale * devicePixelRatioF();
  zoom_->setText(view_->image().empty() ? QString()
                                        : tr("%1 %").arg(QLocale().toString(percent, 'f', 0)));
}

void ImagePanel::set_icons() {
  freeze_->setIcon(icon(QStringLiteral("freeze"), palette()));
  snapshot_->setIcon(icon(QStringLiteral("snapshot"), palette()));
  zoom_in_->setIcon(icon(QStringLiteral("zoom_in"), palette()));
  zoom_out_->setIcon(icon(QStringLiteral("zoom_out"), palette()));
  fit_->setIcon(icon(QStringLiteral("fit"), palette()));
}

void ImagePanel::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) set_icons();
}

void ImagePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show_frame();
}

namespace {

QString proposed_file() {
  const QDir images_dir(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
  const QDir where = images_dir.exists() ? images_dir : QDir::home();
  return where.filePath(
      QStringLiteral("finger_%1.png")
          .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss"))));
}

}  // namespace

void choose_snapshot(const cv::Mat& grey, const std::vector<Overlay>& overlays, QWidget& parent) {
  auto* dialog = new QFileDialog(&parent, ImagePanel::tr("Save the image"), proposed_file());
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("png"));
  const QString bare_filter = ImagePanel::tr("Only the camera's image (*.png)");
  dialog->setNameFilters({ImagePanel::tr("As shown (*.png)"), bare_filter});
  const QImage drawn = image_with_overlays(grey, overlays), bare = grey_image(grey).copy();
  QObject::connect(dialog, &QFileDialog::fileSelected, &parent,
                   [drawn, bare, bare_filter, dialog, &parent](const QString& file) {
                     const bool is_bare = dialog->selectedNameFilter() == bare_filter;
                     if ((is_bare ? bare : drawn).save(file, "PNG")) return;
                     auto* box = new QMessageBox(
                         QMessageBox::Warning, ImagePanel::tr("Save the image"),
                         ImagePanel::tr("%1 could not be written. Choose another folder, or free "
                                        "some disk space.")
                             .arg(QDir::toNativeSeparators(file)),
                         QMessageBox::Ok, &parent);
                     show_dialog(*box);
                   });
  show_dialog(*dialog);
}

std::vector<Overlay> overlays_for(const LiveView& view, const ViewOptions& options) {
  const FrameResult& result = view.result;
  std::vector<Overlay> overlays;
  if (options.depth && view.depth_layer)
    overlays.push_back(layer_overlay(view.depth_layer->pixels, view.depth_layer->at));
  if (options.faults && !view.faults_layer.empty())
    overlays.push_back(layer_overlay(view.faults_layer));
  if (options.focus && !view.focus_layer.empty())
    overlays.push_back(layer_overlay(view.focus_layer));
  if (options.edges && result.edges) overlays.push_back(edges_overlay(*result.edges));
  if (options.markers && result.markers) overlays.push_back(markers_overlay(*result.markers));
  if (options.markers && !view.result.dots.empty())
    overlays.push_back(dots_overlay(view.result.dots));
  if (options.direction && result.push && result.markers)
    overlays.push_back(force_overlay(*result.push, *result.markers));
  if (options.depth && view.depth_layer)
    overlays.push_back(
        colour_bar_overlay(depth_scale(view.depth_top_mm), ImagePanel::tr("Depth, mm")));
  return overlays;
}

QString readout_text(const LiveView& view, QPoint pixel) {
  const FrameResult& result = view.result;
  const int grey = result.grey.at<std::uint8_t>(pixel.y(), pixel.x());
  const QString text =
      ImagePanel::tr("u %1 px, v %2 px, grey %3").arg(pixel.x()).arg(pixel.y()).arg(grey);
  if (!result.depth) return text;
  const float depth = result.depth->depth_mm.at<float>(pixel.y(), pixel.x());
  const std::uint8_t flag = result.depth->flags.at<std::uint8_t>(pixel.y(), pixel.x());
  return joined(
      {text, std::isfinite(depth)
                 ? ImagePanel::tr("depth %1 mm")
                       .arg(is_at_limit(flag) ? limit_and_sd(depth, {}, 2) : plain_number(depth, 2))
             : flag == kTooDark   ? ImagePanel::tr("no depth: too dark")
             : flag == kSaturated ? ImagePanel::tr("no depth: too bright")
                                  : ImagePanel::tr("no depth: off the face")});
}

}  // namespace alltact
