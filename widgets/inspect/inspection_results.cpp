#include "widgets/inspect/inspection_results.h"

#include "core/base/atomic_file.h"
#include "core/base/program.h"
#include "core/base/utc_time.h"
#include "widgets/inspect/point_readings.h"
#include "widgets/inspect/recipe_box.h"
#include "widgets/language.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/report/document.h"
#include "widgets/theme.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace alltact {
namespace {

constexpr int kResultProblemsHeight_px = 40, kReadingPlotHeight_px = 240, kFailSymbol_px = 16;

QString number_or_dash(const std::optional<double>& value, int digits) {
  return value ? plain_number(*value, digits) : RecipeBox::tr("–");
}

QString heading_of(const RecipeReading& reading) {
  return QStringLiteral("%1, %2").arg(QString::fromStdString(reading.name),
                                      unit_text(reading.what));
}

/// Mean, spread, smallest and largest value.
QStringList figures_of(const ReadingSummary& summary, Measurand what) {
  QStringList figures;
  for (const auto& value : {summary.mean, summary.sd, summary.min, summary.max})
    figures << number_or_dash(value, decimals_of(what));
  return figures;
}

/// Frames that pass, fail and are undecided.
QStringList decisions_of(const ReadingSummary& summary) {
  QStringList decisions;
  for (const std::size_t count : {summary.passed, summary.failed, summary.undecided})
    decisions << plain_number(static_cast<double>(count), 0);
  return decisions;
}

QString inspection_verdict_text(const InspectionLog& log) {
  const int frames = static_cast<int>(log.rows.size());
  switch (log.verdict()) {
    case Conformity::kPass:
      return InspectionResults::tr(
          "Pass: all readings of %n frame(s) are within their tolerances with 95 % certainty each.",
          nullptr, frames);
    case Conformity::kFail:
      return InspectionResults::tr("Fail: readings are outside of their tolerance.");
    case Conformity::kUndecided:
      return InspectionResults::tr(
          "Undecided: readings are closer to a limit than their uncertainty allows to decide.");
    case Conformity::kNotMeasured:
      return InspectionResults::tr("Undecided: some frames could not be read.");
    case Conformity::kNoTolerance:
      break;
  }
  return InspectionResults::tr("%n frame(s), no tolerances.", nullptr, frames);
}

QString trend_text(const ReadingSummary& summary, Measurand what) {
  if (!summary.trend) return RecipeBox::tr("–");
  const QString unit = unit_text(what);
  return QStringLiteral("%1 %2").arg(
      number_and_sd(summary.trend->value, summary.trend->sd, decimals_of(what) + 1),
      summary.is_trend_per_second ? InspectionResults::tr("%1/s").arg(unit)
                                  : InspectionResults::tr("%1/frame").arg(unit));
}

}  // namespace

ReadingSeries series_of(const InspectionLog& log, std::size_t reading) {
  const RecipeReading& of = log.recipe.readings[reading];
  ReadingSeries series;
  series.lower = of.lower;
  series.upper = of.upper;
  series.label = QStringLiteral("%1 (%2)").arg(QString::fromStdString(of.name), unit_text(of.what));
  series.is_time = std::all_of(log.rows.begin(), log.rows.end(),
                               [](const InspectedRow& row) { return row.time_s.has_value(); });
  const double begin_s =
      series.is_time && !log.rows.empty() ? log.rows.front().time_s.value_or(0) : 0;
  for (const InspectedRow& row : log.rows) {
    const auto& measured = row.readings[reading].reading.measured;
    if (!measured) continue;
    series.x.push_back(series.is_time ? *row.time_s - begin_s : static_cast<double>(row.index + 1));
    series.values.push_back(measured->value);
    series.sd.push_back(std::isfinite(measured->sd) ? measured->sd : 0);
  }
  return series;
}

void ReadingPlot::set_series(ReadingSeries series) {
  series_ = std::move(series);
  rebuild();
}

QString ReadingPlot::empty_text() const { return tr("No value was measured"); }

bool ReadingPlot::draw() {
  const auto& [x, values, sd, lower, upper, is_time, label] = series_;
  if (x.empty()) return false;
  double low = values.front(), high = values.front();
  for (std::size_t i = 0; i < x.size(); ++i) {
    low = std::min(low, values[i] - sd[i]);
    high = std::max(high, values[i] + sd[i]);
  }
  for (const auto& limit : {lower, upper})
    if (limit) low = std::min(low, *limit), high = std::max(high, *limit);
  const double room = std::max(0.08 * (high - low), 1e-6);
  const double side = std::max(0.02 * (x.back() - x.front()), is_time ? 0.01 : 0.5);
  chart().xAxis->setRange(x.front() - side, x.back() + side);
  chart().yAxis->setRange(low - room, high + room);
  for (const auto& limit : {lower, upper})
    if (limit) {
      auto* line = chart().addGraph();
      line->addData(x.front() - side, *limit);
      line->addData(x.back() + side, *limit);
      line->setPen(QPen(meaning_colour(Meaning::kBad, palette()), 1.5, Qt::DashLine));
      line->removeFromLegend();
    }
  auto* graph = chart().addGraph();
  graph->setLineStyle(x.size() > 1 ? QCPGraph::lsLine : QCPGraph::lsNone);
  graph->setPen(QPen(role_colour(ColourRole::kMeasured, palette()), 1.5));
  graph->setScatterStyle(
      QCPScatterStyle(QCPScatterStyle::ssDisc, role_colour(ColourRole::kMeasured, palette()), 5));
  auto* bars = new QCPErrorBars(chart().xAxis, chart().yAxis);
  bars->setDataPlottable(graph);
  bars->setPen(QPen(role_colour(ColourRole::kMeasured, palette()), 1));
  for (std::size_t i = 0; i < x.size(); ++i) {
    graph->addData(x[i], values[i]);
    bars->addData(sd[i]);
  }
  chart().xAxis->setLabel(is_time ? tr("Time (s)") : tr("Frame"));
  chart().yAxis->setLabel(label);
  return true;
}

namespace {

/// Sorted by numbers, not by their text.
class FrameRow : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;
  void set(int column, const QString& text, std::optional<double> value) {
    setText(column, text);
    setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    setData(column, Qt::UserRole, value.value_or(-std::numeric_limits<double>::infinity()));
  }
  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget()->sortColumn();
    return data(column, Qt::UserRole).toDouble() < other.data(column, Qt::UserRole).toDouble();
  }
};

QString cell_text(const FaceReading& reading, int decimals) {
  if (!reading.measured) return RecipeBox::tr("–");
  const auto& [value, sd] = *reading.measured;
  return reading.is_lower_bound ? limit_and_sd(value, sd, decimals)
                                : number_and_sd(value, sd, decimals);
}

}  // namespace

FrameTable::FrameTable(QWidget* parent) : RowList(parent) {
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setSortingEnabled(true);
  sortByColumn(0, Qt::AscendingOrder);
  // The mouse makes a row current before it selects it, keys after; the focus alone selects none.
  connect(this, &QTreeWidget::currentItemChanged, this, &FrameTable::follow_selection);
  connect(this, &QTreeWidget::itemSelectionChanged, this, &FrameTable::follow_selection);
}

void FrameTable::follow_selection() {
  const QTreeWidgetItem* row = currentItem();
  if (row == nullptr || !row->isSelected()) return;
  const auto index = static_cast<std::size_t>(row->data(0, Qt::UserRole).toDouble());
  if (std::exchange(chosen_, index) != index) Q_EMIT frame_chosen(index);
}

void FrameTable::show_log(const InspectionLog& log) {
  constexpr int kReadings = 2;  // columns before the readings
  QStringList head{tr("Frame"), tr("Time, s")};
  for (const RecipeReading& reading : log.recipe.readings)
    head << QStringLiteral("%1, %2").arg(QString::fromStdString(reading.name),
                                         unit_text(reading.what));
  clear();
  setColumnCount(static_cast<int>(head.size()));
  setHeaderLabels(head);
  setSortingEnabled(false);
  const QIcon fail(symbol(meaning_symbol(Meaning::kBad), meaning_colour(Meaning::kBad, palette()),
                          kFailSymbol_px, devicePixelRatioF()));
  for (const InspectedRow& frame : log.rows) {
    auto* row = new FrameRow(this);
    row->set(0, QString::number(frame.index + 1), static_cast<double>(frame.index));
    row->set(1, number_or_dash(frame.time_s, 3), frame.time_s);
    for (std::size_t i = 0; i < frame.readings.size(); ++i) {
      const auto& [reading, decision] = frame.readings[i];
      const int column = kReadings + static_cast<int>(i);
      row->set(column, cell_text(reading, decimals_of(log.recipe.readings[i].what)),
               reading.measured ? std::optional(reading.measured->value) : std::nullopt);
      row->setToolTip(column, reading.measured ? conformity_text(decision)
                                               : in_window_language(reading.reason));
      if (decision == Conformity::kFail) row->setIcon(column, fail);
    }
  }
  setSortingEnabled(true);
  header()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

QString FrameTable::text() const {
  const auto line_of = [this](const QTreeWidgetItem& row) {
    QStringList cells;
    for (int column = 0; column < columnCount(); ++column) cells << row.text(column);
    return cells.join(QLatin1Char('\t'));
  };
  QStringList lines{line_of(*headerItem())};
  const bool is_all = selectedItems().isEmpty();
  for (int i = 0; i < topLevelItemCount(); ++i)
    if (is_all || topLevelItem(i)->isSelected()) lines << line_of(*topLevelItem(i));
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void FrameTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return QGuiApplication::clipboard()->setText(text());
  RowList::keyPressEvent(event);
}

InspectionResults::InspectionResults(InspectionOrder order, QWidget* parent)
    : FittedDialog(parent),
      order_(std::move(order)),
      verdict_(new ReservedText(2)),
      tabs_(new QTabWidget),
      table_(new RowList),
      plot_(new ReadingPlot),
      frames_(new FrameTable),
      bar_(new QProgressBar),
      problems_(new ProblemList),
      stop_(new QPushButton),
      copy_(new QPushButton),
      save_table_(new QPushButton),
      save_report_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  plot_->setMinimumHeight(kReadingPlotHeight_px);
  problems_->show_in_full();
  problems_->setMinimumHeight(kResultProblemsHeight_px);
  for (QWidget* shown : std::initializer_list<QWidget*>{bar_, stop_}) reserve_room(*shown);
  auto* column = new QVBoxLayout(this);
  auto* running = new QHBoxLayout;
  running->addWidget(bar_, 1);
  running->addWidget(stop_);
  add_widgets(*column, {verdict_});
  column->addLayout(running);
  auto* readings = new QWidget;
  auto* over_frames = new QVBoxLayout(readings);
  over_frames->addWidget(table_);
  over_frames->addWidget(plot_, 1);
  tabs_->addTab(readings, {});
  tabs_->addTab(frames_, {});
  column->addWidget(tabs_, 1);
  column->addWidget(problems_);
  auto* foot = new QHBoxLayout;
  add_widgets(*foot, {copy_, save_table_, save_report_});
  foot->addStretch();
  foot->addWidget(buttons_);
  column->addLayout(foot);
  for (QPushButton* button : {copy_, save_table_, save_report_, stop_})
    button->setAutoDefault(false);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(stop_, &QPushButton::clicked, &work_, &BackgroundWork::stop);
  connect(table_, &QTreeWidget::currentItemChanged, this, &InspectionResults::show_plot);
  connect(frames_, &FrameTable::frame_chosen, this, &InspectionResults::frame_requested);
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(frames_->text()); });
  connect(save_table_, &QPushButton::clicked, this,
          [this] { choose_file(QStringLiteral("csv"), &InspectionResults::save_table); });
  connect(save_report_, &QPushButton::clicked, this,
          [this] { choose_file(QStringLiteral("pdf"), &InspectionResults::save_report); });
  connect(&work_, &BackgroundWork::progressed, this,
          [this] { bar_->setValue(static_cast<int>(100 * work_.fraction())); });
  connect(&work_, &BackgroundWork::finished, this, &InspectionResults::show_log);
  resize(960, 640);
  work_.start([this, order = order_](const Job& job) {
    auto log = inspect_recording(order, job);
    return std::function<void()>([this, log = std::move(log)] {
      if (!log) return problems_->set_problems({Problem::of(log.error())});
      log_ = std::make_shared<const InspectionLog>(*log);
      std::vector<Problem> remarks;
      for (const Message& remark : log_->remarks)
        remarks.push_back({Meaning::kDoubtful, in_window_language(remark)});
      problems_->set_problems(std::move(remarks));
    });
  });
  say([this] { name_parts(); });
}

void InspectionResults::name_parts() {
  setWindowTitle(tr("Inspection"));
  tabs_->setTabText(0, tr("Readin&gs"));
  tabs_->setTabText(1, tr("&Frames"));
  tabs_->setAccessibleName(tr("Results of the inspection"));
  frames_->setAccessibleName(tr("Readings of each frame"));
  frames_->setToolTip(tr("A frame that is selected here is shown on the page Inspect."));
  copy_->setText(tr("C&opy frames"));
  copy_->setToolTip(tr("Copies the selected frames, or all, for a spreadsheet."));
  table_->setAccessibleName(tr("Readings of all frames"));
  table_->setHeaderLabels({tr("Reading"), tr("Mean"), tr("Spread"), tr("Smallest"), tr("Largest"),
                           tr("Trend"), tr("Pass"), tr("Fail"), tr("Undecided")});
  bar_->setAccessibleName(tr("Progress of the inspection"));
  save_report_->setToolTip(tr("A PDF to sign, in English"));
  save_table_->setToolTip(tr("The table that alltact inspect writes, to the byte"));
  plot_->setAccessibleName(tr("The selected reading over the frames"));
  stop_->setText(tr("&Stop"));
  stop_->setToolTip(tr("Ends the inspection without a result"));
  save_table_->setText(tr("Save &table (CSV)…"));
  save_report_->setText(tr("Save &report (PDF)…"));
  buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  buttons_->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
  show_log();
}

void InspectionResults::show_log() {
  for (QWidget* widget : std::initializer_list<QWidget*>{bar_, stop_})
    widget->setVisible(work_.is_running());
  for (QPushButton* button : {copy_, save_table_, save_report_})
    button->setEnabled(log_ != nullptr);
  table_->clear();
  frames_->show_log(log_ ? *log_ : InspectionLog());
  if (!log_) {
    verdict_->setText(work_.is_running() ? tr("The frames are being measured…")
                                         : tr("Nothing was inspected."));
    return show_plot();
  }
  verdict_->setText(inspection_verdict_text(*log_));
  const auto summaries = log_->summaries();
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const ReadingSummary& one = summaries[i];
    const RecipeReading& reading = log_->recipe.readings[i];
    auto* row =
        table_->add_numbers(QStringList{heading_of(reading)} + figures_of(one, reading.what) +
                            QStringList{trend_text(one, reading.what)} + decisions_of(one));
    if (one.failed > 0)
      row->setIcon(
          0, QIcon(symbol(meaning_symbol(Meaning::kBad), meaning_colour(Meaning::kBad, palette()),
                          kFailSymbol_px, devicePixelRatioF())));
  }
  constexpr int kLeastRows = 2, kMostRows = 8;
  table_->fit_columns();
  table_->fit_height(kLeastRows, kMostRows);
  if (table_->topLevelItemCount() > 0) table_->setCurrentItem(table_->topLevelItem(0));
  show_plot();
}

void InspectionResults::show_plot() {
  const int at = table_->indexOfTopLevelItem(table_->currentItem());
  plot_->set_series(log_ && at >= 0 ? series_of(*log_, static_cast<std::size_t>(at))
                                    : ReadingSeries());
}

void InspectionResults::choose_file(
    const QString& ending, void (InspectionResults::*save)(const std::filesystem::path& file)) {
  ask_where_to_save(this, FilesOf::kExports, tr("Save the inspection"), ending, {},
                    [this, save](const QString& file) { (this->*save)(file.toStdString()); });
}

void InspectionResults::show_saved(const Status& status, const std::filesystem::path& file) {
  problems_->set_problems(
      {status
           ? Problem{Meaning::kGood, tr("Written: %1.").arg(QString::fromStdString(file.string()))}
           : Problem::of(status.error())});
}

void InspectionResults::save_table(const std::filesystem::path& file) {
  if (log_) show_saved(write_file_atomically(file, log_->to_csv()), file);
}

void InspectionResults::save_report(const std::filesystem::path& file) {
  if (!log_) return;
  const auto pdf = inspection_report_pdf(*log_, order_, utc_now());
  show_saved(pdf ? write_file_atomically(file, *pdf) : Status(pdf.error()), file);
}

RecordingsInspection::RecordingsInspection(InspectionOrder order, QWidget* parent)
    : FittedDialog(parent),
      summary_(new ReservedText(2)),
      table_(new RowList),
      bar_(new QProgressBar),
      problems_(new ProblemList),
      stop_(new QPushButton),
      save_table_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  problems_->show_in_full();
  problems_->setMinimumHeight(kResultProblemsHeight_px);
  for (QWidget* shown : std::initializer_list<QWidget*>{bar_, stop_}) reserve_room(*shown);
  auto* column = new QVBoxLayout(this);
  auto* running = new QHBoxLayout;
  running->addWidget(bar_, 1);
  running->addWidget(stop_);
  column->addWidget(summary_);
  column->addLayout(running);
  column->addWidget(table_, 1);
  column->addWidget(problems_);
  auto* foot = new QHBoxLayout;
  foot->addWidget(save_table_);
  foot->addStretch();
  foot->addWidget(buttons_);
  column->addLayout(foot);
  for (QPushButton* button : {save_table_, stop_}) button->setAutoDefault(false);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(stop_, &QPushButton::clicked, &work_, &BackgroundWork::stop);
  connect(save_table_, &QPushButton::clicked, this, [this] {
    ask_where_to_save(this, FilesOf::kExports, tr("Save the table"), QStringLiteral("csv"), {},
                      [this](const QString& file) { save_table(file.toStdString()); });
  });
  connect(&work_, &BackgroundWork::progressed, this,
          [this] { bar_->setValue(static_cast<int>(100 * work_.fraction())); });
  connect(&work_, &BackgroundWork::finished, this, &RecordingsInspection::show_recordings);
  resize(960, 480);
  work_.start([this, order = std::move(order)](const Job& job) {
    auto recordings = inspect_recordings(order, job);
    return std::function<void()>([this, recordings = std::move(recordings)] {
      if (!recordings) return problems_->set_problems({Problem::of(recordings.error())});
      recordings_ = *recordings;
    });
  });
  say([this] { name_parts(); });
}

void RecordingsInspection::name_parts() {
  setWindowTitle(tr("Inspection of a folder"));
  table_->setAccessibleName(tr("Readings of each recording"));
  table_->setHeaderLabels({tr("Recording"), tr("Reading"), tr("Mean"), tr("Spread"), tr("Smallest"),
                           tr("Largest"), tr("Pass"), tr("Fail"), tr("Undecided")});
  bar_->setAccessibleName(tr("Progress of the inspection"));
  stop_->setText(tr("&Stop"));
  stop_->setToolTip(tr("Ends the inspection without a result"));
  save_table_->setText(tr("Save &table (CSV)…"));
  save_table_->setToolTip(tr("The table that alltact inspect --each writes, to the byte"));
  buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  buttons_->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
  show_recordings();
}

void RecordingsInspection::show_recordings() {
  for (QWidget* widget : std::initializer_list<QWidget*>{bar_, stop_})
    widget->setVisible(work_.is_running());
  save_table_->setEnabled(!recordings_.empty());
  table_->clear();
  int failed = 0;
  for (const InspectedRecording& one : recordings_) {
    const QString name = QString::fromStdString(one.recording.filename().string());
    if (!one.log) {
      ++failed;
      auto* row = table_->add_numbers({name, in_window_language(one.problem)});
      row->setTextAlignment(1, Qt::AlignLeft | Qt::AlignVCenter);
      continue;
    }
    const auto summaries = one.log->summaries();
    for (std::size_t i = 0; i < summaries.size(); ++i) {
      const ReadingSummary& all = summaries[i];
      const RecipeReading& reading = one.log->recipe.readings[i];
      auto* row = table_->add_numbers(QStringList{name, heading_of(reading)} +
                                      figures_of(all, reading.what) + decisions_of(all));
      row->setTextAlignment(1, Qt::AlignLeft | Qt::AlignVCenter);
    }
  }
  table_->fit_columns();
  const int count = static_cast<int>(recordings_.size());
  summary_->setText(
      work_.is_running() ? tr("The recordings are being measured…")
      : count == 0       ? tr("Nothing was inspected.")
      : failed == 0
          ? tr("%n recording(s) inspected.", nullptr, count)
          : tr("%n recording(s), of which %1 could not be inspected.", nullptr, count).arg(failed));
}

void RecordingsInspection::save_table(const std::filesystem::path& file) {
  if (recordings_.empty()) return;
  const Status saved = write_file_atomically(file, csv_of(recordings_));
  problems_->set_problems(
      {saved
           ? Problem{Meaning::kGood, tr("Written: %1.").arg(QString::fromStdString(file.string()))}
           : Problem::of(saved.error())});
}

Result<std::string> inspection_report_pdf(const InspectionLog& log, const InspectionOrder& order,
                                          const std::string& date) {
  const EnglishScope english;
  const auto digits_of = [](const RecipeReading& reading) { return decimals_of(reading.what); };
  Document document(text("Inspection report"));
  document.heading(text("Inspection report"));
  QStringList inputs;
  for (const auto& input : order.inputs) inputs << as_text(input.string());
  document.table({},
                 {{{text("Recipe")}, {as_text(log.recipe.name)}},
                  {{text("Finger")}, {as_text(order.finger.string())}},
                  {{text("Recording")}, {inputs.join(text(", "))}},
                  {{text("Date")}, {when(as_text(date))}},
                  {{text("Program")}, {as_text("AllTact " + program_version())}}},
                 {false, false});
  const Meaning meaning = meaning_of(log.verdict());
  document.box(inspection_verdict_text(log),
               text("Decision by ISO 14253-1: a reading passes or fails where it is inside or "
                    "outside of its limits by 1.645 standard deviations or more."),
               meaning_colour(meaning, QPalette(Qt::white)));
  std::vector<Document::Row> rows;
  const auto summaries = log.summaries();
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const RecipeReading& reading = log.recipe.readings[i];
    const ReadingSummary& one = summaries[i];
    const auto cell = [&](const std::optional<double>& value) {
      return Document::Cell{value ? mm(*value, digits_of(reading)) : text("–")};
    };
    rows.push_back({{as_text(reading.name)},
                    {unit_text(reading.what)},
                    {tolerance_text(reading)},
                    cell(one.mean),
                    cell(one.sd),
                    cell(one.min),
                    cell(one.max),
                    {trend_text(one, reading.what)},
                    {QString::number(one.passed)},
                    {QString::number(one.failed)},
                    {QString::number(one.undecided)}});
  }
  document.table({text("Reading"), text("Unit"), text("Tolerance"), text("Mean"), text("Spread"),
                  text("Smallest"), text("Largest"), text("Trend"), text("Pass"), text("Fail"),
                  text("Undecided")},
                 rows, {false, false, false, true, true, true, true, true, true, true, true});
  constexpr QSize kFigure(660, 260);
  constexpr double kFigureScale = 2;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    ReadingPlot plot;
    plot.setPalette(QPalette(Qt::white));
    plot.set_series(series_of(log, i));
    document.figure(plot.image(kFigure, kFigureScale), kFigure.width(),
                    as_text(log.recipe.readings[i].name));
  }
  document.paragraph(text("Inspected by: ______________________________   Date: ____________"));
  document.paragraph(text("Approved by:  ______________________________   Date: ____________"));
  return document.pdf(date);
}

}  // namespace alltact
