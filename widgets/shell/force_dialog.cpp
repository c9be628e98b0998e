#include "widgets/shell/force_dialog.h"

#include "core/base/guarded.h"
#include "widgets/language.h"
#include "widgets/theme.h"
#include "widgets/undo_step.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <array>
#include <cmath>

namespace alltact {
namespace {

constexpr int kForceProblemsHeight_px = 64, kKinds = 4;

/// It is pushed when the model is installed already; revert_force() changes between both models.
class ForceStep : public UndoStep {
 public:
  explicit ForceStep(std::filesystem::path finger)
      : UndoStep([] { return ForceDialog::tr("train the forces"); }), finger_(std::move(finger)) {}
  void undo() override { revert(); }
  void redo() override {
    if (is_pushed_) revert();
    is_pushed_ = true;
  }

 private:
  void revert() {
    const auto reverted = revert_force(finger_);
    if (!reverted) report_unexpected(reverted.error());
  }
  std::filesystem::path finger_;
  bool is_pushed_ = false;
};

/// The values of all axes: "0.12, 0.10".
QString by_axis(const Eigen::VectorXd& values, int digits) {
  QStringList texts;
  for (const double value : values) texts << plain_number(value, digits);
  return joined_clauses(texts);
}

QString kind_name(ForceKind kind) {
  switch (kind) {
    case ForceKind::kMean:
      return ForceDialog::tr("mean force");
    case ForceKind::kRidge:
      return ForceDialog::tr("linear");
    case ForceKind::kQuadratic:
      return ForceDialog::tr("quadratic");
    case ForceKind::kNetwork:
      break;
  }
  return ForceDialog::tr("network");
}

}  // namespace

ForceDialog::ForceDialog(std::filesystem::path finger, QUndoStack& undo, QWidget* parent)
    : FittedDialog(parent),
      finger_(std::move(finger)),
      undo_(undo),
      intro_(wrapped_label()),
      tables_text_(new ElidedLabel(Qt::ElideMiddle)),
      choose_(new QPushButton),
      stop_(new QPushButton),
      install_(new QPushButton),
      discard_(new QPushButton),
      bar_(new QProgressBar),
      comparison_(new RowList),
      sentence_(new ReservedText(2)),
      problems_(new ProblemList),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(intro_);
  auto* row = new QHBoxLayout;
  row->addWidget(choose_);
  row->addWidget(tables_text_, 1);
  column->addLayout(row);
  auto* progress = new QHBoxLayout;
  progress->addWidget(bar_, 1);
  progress->addWidget(stop_);
  column->addLayout(progress);
  add_widgets(*column, {comparison_, sentence_});
  problems_->show_in_full();
  problems_->setMinimumHeight(kForceProblemsHeight_px);
  column->addWidget(problems_, 1, Qt::AlignTop);
  auto* foot = new QHBoxLayout;
  add_widgets(*foot, {install_, discard_});
  foot->addStretch();
  foot->addWidget(buttons_);
  column->addLayout(foot);
  bar_->setRange(0, 100);
  for (QPushButton* button : {choose_, stop_, install_, discard_}) button->setAutoDefault(false);
  connect(choose_, &QPushButton::clicked, this, &ForceDialog::choose_tables);
  connect(stop_, &QPushButton::clicked, &work_, &BackgroundWork::stop);
  connect(install_, &QPushButton::clicked, this, &ForceDialog::install);
  connect(discard_, &QPushButton::clicked, this, &ForceDialog::discard);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&work_, &BackgroundWork::progressed, this, &ForceDialog::show_state);
  connect(&work_, &BackgroundWork::finished, this, &ForceDialog::show_state);
  resize(640, 460);
  say([this] { name_parts(); });
}

void ForceDialog::name_parts() {
  setWindowTitle(tr("Train the forces"));
  intro_->setText(
      tr("A table has the markers' positions of each frame and the forces of a gauge, as "
         "alltact force --collect writes it. Each stretch is held out once to measure the error."));
  choose_->setText(tr("Choose &tables…"));
  choose_->setToolTip(tr("One or more tables of this finger (CSV); training begins at once"));
  stop_->setText(tr("&Stop"));
  stop_->setToolTip(tr("Ends the training without a result"));
  install_->setText(tr("&Install"));
  install_->setToolTip(tr("Forces come from this model from now on; undo restores the one before"));
  discard_->setText(tr("&Discard"));
  discard_->setToolTip(tr("Forgets this result; the finger stays as it is"));
  bar_->setAccessibleName(tr("Progress of the training"));
  comparison_->setAccessibleName(tr("Errors on held-out frames"));
  comparison_->setHeaderLabels({tr("Model"), tr("Mean error, N"), tr("R²"), tr("Chosen")});
  tables_text_->setAccessibleName(tr("Tables"));
  auto* close = buttons_->button(QDialogButtonBox::Close);
  close->setText(tr("&Close"));
  close->setToolTip(tr("Closes this window (Esc)"));
  show_state();
}

void ForceDialog::choose_tables() {
  auto* dialog =
      new QFileDialog(this, tr("Tables of markers and forces"), QString(),
                      tr("Tables (*.csv *.txt *.tsv)") + QLatin1String(";;") + all_files_filter());
  dialog->setFileMode(QFileDialog::ExistingFiles);
  begin_in_last_folder(*dialog, FilesOf::kExports);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    std::vector<std::filesystem::path> tables;
    for (const QString& file : files) tables.emplace_back(file.toStdString());
    train(std::move(tables));
  });
  show_dialog(*dialog);
}

void ForceDialog::train(std::vector<std::filesystem::path> tables, const ForceTraining& training) {
  tables_ = std::move(tables);
  trained_.reset();
  is_installed_ = false;
  problems_->set_problems({});
  work_.restart([this, finger_folder = finger_, files = tables_, training](const Job& job) {
    const auto finger = open_finger(finger_folder);
    auto table = finger ? ForceTable::load_all(files) : Result<ForceTable>(finger.error());
    auto trained = table ? train_for_finger((*finger)->finger, *table, training, job)
                         : Result<TrainedForce>(table.error());
    return std::function<void()>([this, table, trained] {
      if (!trained) return show_problem(trained.error());
      table_ = std::make_shared<ForceTable>(*table);
      trained_ = std::make_shared<TrainedForce>(*trained);
      std::vector<Problem> remarks;
      for (const auto* list : {&table->remarks, &trained->remarks})
        for (const Message& remark : *list)
          remarks.push_back({Meaning::kDoubtful, window_sentence(remark)});
      problems_->set_problems(std::move(remarks));
    });
  });
  show_state();
}

void ForceDialog::show_problem(const Error& error) {
  problems_->set_problems({Problem::of(error)});
}

void ForceDialog::install() {
  work_.start([this, finger = finger_, table = table_, trained = trained_](const Job&) {
    const Status installed = install_force(finger, *table, *trained);
    return std::function<void()>([this, installed] {
      if (!installed) return show_problem(installed.error());
      is_installed_ = true;
      trained_.reset();
      undo_.push(new ForceStep(finger_));
    });
  });
  show_state();
}

void ForceDialog::discard() {
  trained_.reset();
  tables_.clear();
  problems_->set_problems({});
  show_state();
}

void ForceDialog::show_state() {
  QStringList names;
  for (const auto& table : tables_) names << QString::fromStdString(table.filename().string());
  tables_text_->set_text(names.isEmpty() ? tr("No table yet.") : listed(names));
  const bool is_running = work_.is_running(), has_result = trained_ && !is_running;
  choose_->setEnabled(!is_running);
  stop_->setEnabled(is_running);
  install_->setEnabled(has_result);
  discard_->setEnabled(has_result);
  set_primary(*choose_, !has_result);
  set_primary(*install_, has_result);
  bar_->setEnabled(is_running);
  bar_->setValue(is_running ? static_cast<int>(std::lround(100 * work_.fraction())) : 0);
  show_comparison();
}

void ForceDialog::show_comparison() {
  comparison_->clear();
  sentence_->setText(is_installed_ ? tr("The model is installed.") : QString());
  if (trained_) {
    for (const ForceComparison& row : trained_->comparison)
      comparison_->add_numbers({kind_name(row.kind), by_axis(row.mae_N, 3), by_axis(row.r2, 3),
                                row.kind == trained_->model.kind ? tr("yes") : QString()});
    sentence_->setText(
        tr("Of the held-out frames %1 % lie within the 95 % interval; the gauge's "
           "noise is at most %2 N. Values are by axis: Fx, Fy, Fz.")
            .arg(by_axis(100 * trained_->covered_95, 0), by_axis(trained_->label_noise_N, 3)));
  }
  comparison_->fit_columns();
  comparison_->fit_height(kKinds, kKinds);
}

bool can_train_force(const FingerStatus& finger) {
  return finger.finger && !finger.folder.empty() && finger.finger->marker_count() > 0 &&
         finger.finger->contact.has_value();
}

void open_force_training(const LiveSession& session, QUndoStack& undo, QWidget& parent) {
  if (can_train_force(session.status().finger))
    show_dialog(*new ForceDialog(session.status().finger.folder, undo, &parent));
}

}  // namespace alltact
