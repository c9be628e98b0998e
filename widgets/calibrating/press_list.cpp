#include "widgets/calibrating/press_list.h"

#include "calibration/presses/press.h"
#include "core/geometry/ball.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/image/image_view.h"
#include "widgets/image/overlays.h"
#include "widgets/language.h"
#include "widgets/report/document.h"
#include "widgets/theme.h"

#include <QFont>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QSignalBlocker>
#include <algorithm>
#include <filesystem>

namespace alltact {
namespace {

QString punch_state_text(double step_mm, const CollectedPress& press, const StepFit* fit) {
  if (fit != nullptr && fit->step_mm == step_mm)
    return PressModel::tr("%1 mm step measured as %2 mm")
        .arg(local_mm(fit->step_mm, 3), local_mm(fit->estimated_mm, 3));
  if (press.is_analysed && press.analysis.problem) return refusal_word(*press.analysis.problem);
  return PressModel::tr("a punch with a step of %1 mm").arg(local_mm(step_mm, 3));
}

QString body_state_text(const std::string& file, const CollectedPress& press, const BodyFit* fit) {
  const QString name = as_text(std::filesystem::path(file).filename().string());
  if (fit != nullptr)
    return PressModel::tr("depths on %1 read %2 % of the true ones")
        .arg(name, number_and_sd(100 * fit->scale, 100 * fit->sd, 1));
  if (press.is_analysed && press.analysis.problem) return refusal_word(*press.analysis.problem);
  return PressModel::tr("the body %1").arg(name);
}

QString ball_state_text(const BallFit& ball) {
  const QString depth = local_mm(ball.depth_mm, 2);
  const auto error = press_error_mm(ball);
  const QString found =
      error ? PressModel::tr("%1 mm deep, error %2 mm: %3")
                  .arg(depth, local_mm(*error, 3), error_word(meaning_of_error(*error)))
            : PressModel::tr("%1 mm deep, error unknown").arg(depth);
  if (!ball.given_depth) return found;
  return found + QLatin1Char('\n') +
         PressModel::tr("depth measured %1 mm, fitted %2 mm")
             .arg(local_mm(ball.given_depth->mm, 3), local_mm(ball.indentation_mm, 3));
}

}  // namespace

const BallFit* fitted_ball(const CalibrationRun& run, const std::string& press) {
  if (!run.result()) return nullptr;
  for (const BallFit& ball : run.result()->calibration.balls)
    if (ball.press == press) return &ball;
  return nullptr;
}

const StepFit* fitted_step(const CalibrationRun& run, const std::string& press) {
  if (!run.result()) return nullptr;
  for (const StepFit& step : run.result()->calibration.steps)
    if (step.press == press) return &step;
  return nullptr;
}

const BodyFit* fitted_body(const CalibrationRun& run, const std::string& press,
                           const std::string& file) {
  if (!run.result()) return nullptr;
  const std::string name = std::filesystem::path(file).filename().string();
  for (const BodyFit& body : run.result()->calibration.bodies)
    if (body.press == press && body.body == name) return &body;
  return nullptr;
}

QString press_state_text(const CollectedPress& press, const PressCollection& collection,
                         const CalibrationRun& run) {
  const PressNote& note = collection.press_set().of(press.name);
  if (!collection.is_saved(press.name)) return PressModel::tr("not saved to disk");
  if (note.excluded)
    return note.excluded->empty() ? PressModel::tr("left out")
                                  : PressModel::tr("left out: %1").arg(as_text(*note.excluded));
  if (note.body)
    return body_state_text(*note.body, press, fitted_body(run, press.name, *note.body));
  if (note.step_mm) return punch_state_text(*note.step_mm, press, fitted_step(run, press.name));
  if (const BallFit* ball = fitted_ball(run, press.name)) return ball_state_text(*ball);
  if (note.ball_mm) return PressModel::tr("ball set by hand");
  if (!press.is_analysed) return PressModel::tr("being analysed");
  if (press.analysis.found_mm) return PressModel::tr("ball found");
  if (press.analysis.problem)
    return press.analysis.shape || press.analysis.grey.empty()
               ? refusal_word(*press.analysis.problem)
               : PressModel::tr("no face found");
  return PressModel::tr("the ball's radius is missing");
}

std::optional<Meaning> press_meaning(const CollectedPress& press, const PressCollection& collection,
                                     const CalibrationRun& run) {
  const PressNote& note = collection.press_set().of(press.name);
  if (!collection.is_saved(press.name)) return Meaning::kBad;
  if (note.excluded) return std::nullopt;
  if (note.is_ball())
    if (const BallFit* ball = fitted_ball(run, press.name))
      if (const auto error = press_error_mm(*ball)) return meaning_of_error(*error);
  if (press.is_analysed && press.analysis.problem && !note.ball_mm) return Meaning::kDoubtful;
  return std::nullopt;
}

PressModel::PressModel(const PressCollection& collection, const CalibrationRun& run,
                       QObject* parent)
    : QAbstractListModel(parent), collection_(collection), run_(run) {
  connect(&collection_, &PressCollection::changed, this, &PressModel::follow);
  connect(&run_, &CalibrationRun::changed, this, &PressModel::follow);
  follow();
}

void PressModel::follow() {
  std::vector<std::string> names;
  for (const CollectedPress& press : collection_.presses()) names.push_back(press.name);
  const auto error = [this](const std::string& name) {
    const BallFit* ball =
        collection_.press_set().of(name).excluded ? nullptr : fitted_ball(run_, name);
    return ball == nullptr ? 0.0 : press_error_mm(*ball).value_or(0.0);
  };
  std::stable_sort(names.begin(), names.end(),
                   [&](const auto& a, const auto& b) { return error(a) > error(b); });
  if (names != names_) {
    beginResetModel();
    names_ = std::move(names);
    endResetModel();
  } else if (!names_.empty()) {
    Q_EMIT dataChanged(index(0), index(static_cast<int>(names_.size()) - 1));
  }
}

int PressModel::row_of(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
}

std::string PressModel::name_at(int row) const {
  return row < 0 || row >= rowCount() ? std::string() : names_[static_cast<std::size_t>(row)];
}

int PressModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(names_.size());
}

QVariant PressModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const CollectedPress* press = collection_.find(name_at(index.row()));
  if (press == nullptr) return {};
  switch (role) {
    case Qt::DisplayRole:
      return QStringLiteral("%1\n%2").arg(as_text(press->name),
                                          press_state_text(*press, collection_, run_));
    case Qt::ToolTipRole:
      return press->analysis.problem
                 ? in_window_language(en::say("{}.", press->analysis.problem->message()))
                 : QString();
    case Qt::DecorationRole: {
      const QPixmap thumbnail = thumbnails_.of(*press, known_ball(*press, collection_, run_),
                                               press_meaning(*press, collection_, run_));
      return thumbnail.isNull() ? QVariant() : thumbnail;
    }
    case Qt::FontRole: {
      QFont font;
      font.setStrikeOut(collection_.press_set().of(press->name).excluded.has_value());
      return font;
    }
    case Qt::ForegroundRole:
      return collection_.press_set().of(press->name).excluded
                 ? QVariant(role_colour(ColourRole::kLeftOut, QGuiApplication::palette()))
                 : QVariant();
    case kName:
      return as_text(press->name);
    default:
      return {};
  }
}

namespace {

constexpr int kOutlinePoints = 120;
constexpr double kAroundBall = 1.5;  // height of the crop over that of the outline
constexpr double kMinCut_px = 24;
const QColor kBallOutline(255, 214, 64);

QPolygonF outline_polygon(const ShownBall& ball) {
  QPolygonF polygon;
  for (const auto& p : ball_outline_px(ball.camera, ball.centre_mm, ball.radius_mm, kOutlinePoints))
    polygon << QPointF(p.x() + 0.5, p.y() + 0.5);  // from pixel centres to pixel corners
  return polygon;
}

/// Drawn on an image, so the colours are those of the dark theme for every palette.
void paint_meaning(QPainter& painter, Meaning meaning, const QSize& size, double ratio) {
  constexpr int kBar = 5, kSymbol = 16;
  const QColor colour = meaning_colour(meaning, theme_palette(Theme::kDark));
  painter.fillRect(QRect(0, 0, kBar, size.height()), colour);
  const QRect plate(kBar + 2, 2, kSymbol + 4, kSymbol + 4);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  painter.drawRoundedRect(plate, 4, 4);
  painter.drawPixmap(plate.topLeft() + QPoint(2, 2),
                     symbol(meaning_symbol(meaning), colour, kSymbol, ratio));
}

/// Crop of the image around the outline, in the aspect ratio of `size`.
QRectF cut_around(const QPolygonF& outline, const cv::Mat& grey, const QSize& size) {
  const QRectF full(0, 0, grey.cols, grey.rows);
  const double shape = static_cast<double>(size.width()) / size.height();
  if (outline.isEmpty() || !full.intersects(outline.boundingRect())) return full;
  const QRectF box = outline.boundingRect();
  const double height = std::clamp(kAroundBall * std::max(box.height(), box.width() / shape),
                                   kMinCut_px, std::max(kMinCut_px, full.height()));
  QRectF cut(0, 0, shape * height, height);
  cut.moveCenter(box.center());
  return cut;
}

}  // namespace

std::optional<ShownBall> known_ball(const CollectedPress& press, const PressCollection& collection,
                                    const CalibrationRun& run) {
  const PressNote& note = collection.press_set().of(press.name);
  const double radius = collection.press_set().radius_of(press.name);
  if (collection.analyser() == nullptr || !(radius > 0) || !note.is_ball()) return std::nullopt;
  const auto shown = [&](const Eigen::Vector3d& centre, bool is_by_hand) {
    ShownBall ball{collection.analyser()->camera(), radius, centre, is_by_hand,
                   Eigen::Vector3d::UnitZ()};
    const Face& face = collection.analyser()->finger().face;
    const auto contact = press.analysis.shape
                             ? ball_on_face(*press.analysis.shape, face, centre, radius)
                             : std::nullopt;
    if (contact) ball.normal = contact->normal;
    return ball;
  };
  if (note.ball_mm) return shown(*note.ball_mm, true);
  const bool is_current = run.state() == CalibrationState::kCurrent;
  if (const BallFit* fitted = is_current ? fitted_ball(run, press.name) : nullptr)
    return shown(fitted->centre_mm, false);
  if (press.analysis.found_mm) return shown(*press.analysis.found_mm, false);
  return std::nullopt;
}

QString refusal_word(const Error& problem) {
  const std::string& words = problem.what.words();
  const auto begins = [&words](const char* with) { return words.rfind(with, 0) == 0; };
  if (begins("hardly any pixel")) return PressModel::tr("not comparable");
  if (begins("nothing on the face is")) return PressModel::tr("nothing pressed in");
  if (begins("only specks")) return PressModel::tr("only specks");
  if (begins("two contacts")) return PressModel::tr("two contacts");
  if (begins("the dark part has a radius")) return PressModel::tr("larger than the ball");
  if (begins("only {:.0f} degrees") || begins("the middle of the dark disc"))
    return PressModel::tr("over the edge");
  if (begins("the border of the dark part") || begins("the dark part is no disc"))
    return PressModel::tr("no disc of a ball");
  return PressModel::tr("not usable");
}

QImage press_thumbnail(const cv::Mat& grey, const std::optional<ShownBall>& ball, const QSize& size,
                       double ratio, std::optional<Meaning> meaning) {
  QImage thumbnail(size * ratio, QImage::Format_RGB32);
  thumbnail.setDevicePixelRatio(ratio);
  thumbnail.fill(Qt::black);
  if (grey.empty()) return thumbnail;
  const QPolygonF outline = ball ? outline_polygon(*ball) : QPolygonF();
  const QRectF cut = cut_around(outline, grey, size);
  const double scale = std::min(size.width() / cut.width(), size.height() / cut.height());
  const QPointF corner(0.5 * (size.width() - scale * cut.width()),
                       0.5 * (size.height() - scale * cut.height()));
  const QRect inside = cut.toAlignedRect() & QRect(0, 0, grey.cols, grey.rows);
  QPainter painter(&thumbnail);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  QTransform to_thumbnail;
  to_thumbnail.translate(corner.x(), corner.y());
  to_thumbnail.scale(scale, scale);
  to_thumbnail.translate(-cut.x(), -cut.y());
  const QImage image = grey_image(grey);
  // Scaling by the painter would alias.
  const QRectF target = to_thumbnail.mapRect(QRectF(inside));
  painter.drawImage(
      target, image.copy(inside).scaled((target.size() * ratio).toSize(), Qt::IgnoreAspectRatio,
                                        Qt::SmoothTransformation));
  if (!outline.isEmpty()) {
    QPainterPath path;
    path.addPolygon(to_thumbnail.map(outline));
    path.closeSubpath();
    stroke_over(painter, path, kBallOutline, 1.4, ball->is_by_hand ? Qt::SolidLine : Qt::DashLine);
  }
  if (meaning) paint_meaning(painter, *meaning, size, ratio);
  return thumbnail;
}

QPixmap PressThumbnails::of(const CollectedPress& press, const std::optional<ShownBall>& ball,
                            std::optional<Meaning> meaning) {
  if (press.analysis.grey.empty()) return {};
  Drawn& drawn = drawn_[press.name];
  Eigen::Vector4d now = Eigen::Vector4d::Zero();
  if (ball) now << ball->centre_mm, ball->radius_mm;
  const bool is_by_hand = ball && ball->is_by_hand;
  if (drawn.grey.data != press.analysis.grey.data || drawn.ball != now ||
      drawn.is_by_hand != is_by_hand || drawn.meaning != meaning)
    drawn = {press.analysis.grey, now, is_by_hand, meaning,
             QPixmap::fromImage(press_thumbnail(press.analysis.grey, ball, size(),
                                                qGuiApp->devicePixelRatio(), meaning))};
  return drawn.pixmap;
}

PressListView::PressListView(QWidget* parent) : QListView(parent) {
  setWordWrap(true);
  setIconSize(PressThumbnails::size());
  setSpacing(2);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  mark_always();
}

void PressListView::set_empty_text(const QString& text) {
  empty_text_ = text;
  setAccessibleDescription(text);
  viewport()->update();
}

void PressListView::paintEvent(QPaintEvent* event) {
  QListView::paintEvent(event);
  if (model() == nullptr || model()->rowCount() > 0) return;
  constexpr int kMargin_px = 12;
  QPainter painter(viewport());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(viewport()->rect().adjusted(kMargin_px, 0, -kMargin_px, 0),
                   Qt::AlignCenter | Qt::TextWordWrap, empty_text_);
}

void PressListView::focusInEvent(QFocusEvent* event) {
  // Qt makes the first row the current one where none is.
  const bool is_by_keys = !currentIndex().isValid() && event->reason() != Qt::MouseFocusReason;
  if (!is_by_keys || selectionModel() == nullptr) return QListView::focusInEvent(event);
  const QSignalBlocker quiet(selectionModel());
  QListView::focusInEvent(event);
  selectionModel()->clear();
}

void PressListView::changeEvent(QEvent* event) {
  QListView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) mark_always();
}

void PressListView::mark_always() {
  QPalette marks;  // only the changed roles
  bool is_other = false;
  for (const auto role : {QPalette::Highlight, QPalette::HighlightedText}) {
    const QColor active = palette().color(QPalette::Active, role);
    is_other = is_other || palette().color(QPalette::Inactive, role) != active;
    marks.setColor(QPalette::Inactive, role, active);
  }
  if (is_other) setPalette(marks);
}

}  // namespace alltact
