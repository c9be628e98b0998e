#include "widgets/shell/gage_dialog.h"

#include "widgets/language.h"
#include "widgets/theme.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>
#include <array>

namespace alltact {
namespace {

constexpr int kGageProblemsHeight_px = 64, kAllRows = 7;
constexpr double kWidestTolerance_mm = 1e4;

void set_head(RowList& table, const QStringList& head) {
  table.setHeaderLabels(head);
  for (int i = 1; i < static_cast<int>(head.size()); ++i)
    table.headerItem()->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
}

QString as_lines(const RowList& table) {
  const auto line = [&table](const QTreeWidgetItem& row) {
    QStringList cells;
    for (int i = 0; i < table.columnCount(); ++i) cells << row.text(i).trimmed();
    return cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
  };
  QString text = line(*table.headerItem());
  for (int i = 0; i < table.topLevelItemCount(); ++i) text += line(*table.topLevelItem(i));
  return text;
}

}  // namespace

GageDialog::GageDialog(std::vector<std::filesystem::path> fingers, QWidget* parent)
    : FittedDialog(parent),
      fingers_(std::move(fingers)),
      intro_(wrapped_label()),
      tolerance_label_(new QLabel),
      counts_(new ReservedText),
      sentence_(new ReservedText(2)),
      tolerance_(new NumberField),
      variation_(new RowList),
      anova_(new RowList),
      problems_(new ProblemList),
      table_(new QPushButton),
      copy_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(intro_);
  auto* row = new QHBoxLayout;
  row->addWidget(counts_, 1);
  row->addWidget(tolerance_label_);
  row->addWidget(tolerance_);
  column->addLayout(row);
  column->addWidget(sentence_);
  column->addWidget(variation_);
  column->addWidget(anova_);
  problems_->show_in_full();
  problems_->setMinimumHeight(kGageProblemsHeight_px);
  column->addWidget(problems_, 1, Qt::AlignTop);
  auto* foot = new QHBoxLayout;
  add_widgets(*foot, {table_, copy_});
  foot->addStretch();
  foot->addWidget(buttons_);
  column->addLayout(foot);
  tolerance_->setRange(0, kWidestTolerance_mm);
  tolerance_->set_shown_decimals(3);
  tolerance_->setSingleStep(0.01);
  tolerance_label_->setBuddy(tolerance_);
  for (QPushButton* button : {table_, copy_}) button->setAutoDefault(false);
  connect(tolerance_, &NumberField::valueChanged, this, &GageDialog::show_study);
  connect(table_, &QPushButton::clicked, this, [this] {
    ask_for_file(this, FilesOf::kExports, tr("Table of readings"),
                 tr("Tables (*.csv *.txt *.tsv)") + QLatin1String(";;") + all_files_filter(),
                 [this](const QString& file) { open_table(file.toStdString()); });
  });
  connect(copy_, &QPushButton::clicked, this, &GageDialog::copy);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&reading_, &BackgroundWork::finished, this, &GageDialog::show_study);
  resize(720, 480);
  say([this] { name_parts(); });
  read([fingers = fingers_](const Job& job) { return read_gage_checks(fingers, job); });
}

void GageDialog::name_parts() {
  setWindowTitle(tr("Gage R&R"));
  intro_->setText(
      tr("How much of the variation of measured depths comes from measuring: from operators, and "
         "from repetitions. A reading is the mean depth error of one check; each operator checks "
         "each finger two times or more."));
  tolerance_label_->setText(tr("&Tolerance"));
  tolerance_->setSuffix(tr(" mm"));
  tolerance_->setSpecialValueText(tr("none"));
  tolerance_->setToolTip(tr("Width of the tolerance that is measured with the fingers"));
  variation_->setAccessibleName(tr("Variation by source"));
  anova_->setAccessibleName(tr("Analysis of variance"));
  table_->setText(tr("&From a table…"));
  table_->setToolTip(tr("With the columns part, operator and value_mm"));
  copy_->setText(tr("C&opy"));
  copy_->setToolTip(tr("Copies both tables for a spreadsheet"));
  buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  buttons_->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
  show_study();
}

void GageDialog::open_table(const std::filesystem::path& file) {
  read([file](const Job&) { return read_gage_table(file); });
}

void GageDialog::read(const Reader& reader) {
  reading_.restart([this, reader](const Job& job) {
    auto readings = reader(job);
    auto study = readings ? gage_study(readings->readings) : Result<GageStudy>(readings.error());
    return std::function<void()>([this, readings, study] {
      study_.reset();
      std::vector<Problem> problems;
      if (study) {
        study_ = *study;
        origin_mm_ = readings->origin_mm;
      } else {
        problems.push_back(Problem::of(study.error()));
      }
      if (readings)
        for (const Message& remark : readings->remarks)
          problems.push_back({Meaning::kDoubtful, in_window_language(remark)});
      problems_->set_problems(std::move(problems));
    });
  });
  show_study();
}

void GageDialog::show_study() {
  copy_->setEnabled(study_.has_value());
  for (RowList* table : {variation_, anova_}) table->clear();
  if (study_) {
    counts_->setText(
        joined({tr("%n part(s)", nullptr, static_cast<int>(study_->parts.size())),
                tr("%n operator(s)", nullptr, static_cast<int>(study_->operators.size())),
                tr("%n repeat(s)", nullptr, study_->repeats),
                tr("%n distinct categorie(s)", nullptr, study_->categories)}));
    sentence_->setText(in_window_language(gage_sentence(*study_, tolerance_->value())));
  } else {
    counts_->setText(reading_.is_running() ? tr("Reading the checks…") : tr("No result."));
    sentence_->clear();
  }
  show_variation();
  show_anova();
}

void GageDialog::show_variation() {
  set_head(*variation_,
           {tr("Variation"), tr("SD, mm"), tr("95 %, mm"), tr("% of total"), tr("% of tolerance")});
  if (study_) {
    const GageStudy& study = *study_;
    const auto add = [&](const QString& name, double sd, const SdInterval* range) {
      const double tolerance_mm = tolerance_->value();
      variation_->add_numbers(
          {name, plain_number(sd, 4),
           range != nullptr
               ? tr("%1 to %2").arg(plain_number(range->low, 4), plain_number(range->high, 4))
               : QString(),
           plain_number(study.percent(sd), 1),
           tolerance_mm > 0 ? plain_number(GageStudy::percent_of(tolerance_mm, sd), 1)
                            : QString()});
    };
    const QString inner(4, QLatin1Char(' '));
    add(tr("Gage R&R"), study.gage, &study.gage_95);
    add(inner + tr("Repeatability"), study.repeatability, &study.repeatability_95);
    add(inner + tr("Reproducibility"), study.reproducibility, nullptr);
    add(inner + inner + tr("Operators"), study.operators_sd, nullptr);
    add(inner + inner + tr("Parts × operators"), study.interaction_sd, nullptr);
    add(tr("Parts"), study.parts_sd, nullptr);
    add(tr("Total"), study.total_sd, nullptr);
  }
  variation_->fit_columns();
  variation_->fit_height(1, kAllRows);
}

void GageDialog::show_anova() {
  set_head(*anova_, {tr("Analysis of variance"), tr("df"), tr("SS"), tr("MS"), tr("F"), tr("p")});
  if (study_) {
    const auto add = [this](const QString& name, const AnovaRow& row) {
      if (row.df < 1) return;
      const QLocale locale;
      anova_->add_numbers({name, locale.toString(row.df), locale.toString(row.ss, 'g', 5),
                           locale.toString(row.ms, 'g', 5),
                           row.f ? plain_number(*row.f, 3) : QString(),
                           row.p ? plain_number(*row.p, 4) : QString()});
    };
    add(tr("Parts"), study_->by_part);
    add(tr("Operators"), study_->by_operator);
    add(study_->is_pooled ? tr("Parts × operators (pooled)") : tr("Parts × operators"),
        study_->interaction);
    add(tr("Repetitions"), study_->repetition);
    add(tr("Total"), study_->total);
  }
  anova_->fit_columns();
  anova_->fit_height(1, kAllRows);
}

void GageDialog::copy() const {
  QGuiApplication::clipboard()->setText(sentence_->text() + QLatin1String("\n\n") +
                                        as_lines(*variation_) + QLatin1Char('\n') +
                                        as_lines(*anova_));
}

}  // namespace alltact
