#include "widgets/inspect/recipe_box.h"

#include "widgets/inspect/point_readings.h"
#include "widgets/language.h"
#include "widgets/theme.h"

#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

constexpr int kReadingName = 0, kReadingValue = 1, kReadingDecision = 2;
constexpr int kDecisionSymbol_px = 16, kReadingProblemsHeight_px = 40;
constexpr double kUnlimited = -1e6, kFurthestLimit = 1e6;

NumberField* limit_field(const std::optional<double>& limit, Measurand what) {
  auto* field = new NumberField;
  field->setRange(kUnlimited, kFurthestLimit);
  field->set_shown_decimals(decimals_of(what));
  field->setSingleStep(0.01);
  field->setSuffix(QLatin1Char(' ') + unit_text(what));
  field->setValue(limit.value_or(kUnlimited));
  return field;
}

}  // namespace

QString conformity_text(Conformity conformity) {
  switch (conformity) {
    case Conformity::kPass:
      return RecipeBox::tr("pass");
    case Conformity::kFail:
      return RecipeBox::tr("fail");
    case Conformity::kUndecided:
      return RecipeBox::tr("undecided");
    case Conformity::kNotMeasured:
      return RecipeBox::tr("not measured");
    case Conformity::kNoTolerance:
      break;
  }
  return RecipeBox::tr("no tolerance");
}

Meaning meaning_of(Conformity conformity) {
  if (conformity == Conformity::kPass) return Meaning::kGood;
  return conformity == Conformity::kFail ? Meaning::kBad : Meaning::kDoubtful;
}

QString tolerance_text(const RecipeReading& reading) {
  const auto number = [&reading](double value) {
    return plain_number(value, decimals_of(reading.what));
  };
  const QString unit = unit_text(reading.what);
  if (reading.lower && reading.upper)
    return RecipeBox::tr("%1 to %2 %3").arg(number(*reading.lower), number(*reading.upper), unit);
  if (reading.lower) return RecipeBox::tr("at least %1 %2").arg(number(*reading.lower), unit);
  if (reading.upper) return RecipeBox::tr("at most %1 %2").arg(number(*reading.upper), unit);
  return {};
}

RecipeBox::RecipeBox(QWidget* parent)
    : Translated(parent),
      hint_(wrapped_label()),
      list_(new RowList),
      problems_(new ProblemList),
      change_(new QPushButton),
      remove_(new QPushButton),
      open_(new QPushButton),
      save_(new QPushButton),
      run_(new QPushButton),
      run_in_folder_(new QPushButton) {
  list_->setColumnCount(kReadingDecision + 1);
  list_->installEventFilter(this);
  auto* column = new QVBoxLayout(this);
  add_widgets(*column, {hint_, list_});
  auto* buttons = new QGridLayout;
  buttons->addWidget(change_, 0, 0);
  buttons->addWidget(remove_, 0, 1);
  buttons->addWidget(open_, 1, 0);
  buttons->addWidget(save_, 1, 1);
  buttons->addWidget(run_, 2, 0);
  buttons->addWidget(run_in_folder_, 2, 1);
  column->addLayout(buttons);
  problems_->show_in_full();
  column->addWidget(problems_);
  connect_parts();
  say([this] { name_parts(); });
}

void RecipeBox::connect_parts() {
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &RecipeBox::follow_selection);
  connect(list_, &QTreeWidget::itemActivated, this, &RecipeBox::change_selected);
  connect(change_, &QPushButton::clicked, this, &RecipeBox::change_selected);
  connect(remove_, &QPushButton::clicked, this, &RecipeBox::remove_selected);
  connect(open_, &QPushButton::clicked, this, &RecipeBox::choose_file);
  connect(save_, &QPushButton::clicked, this, &RecipeBox::save);
  connect(run_, &QPushButton::clicked, this, &RecipeBox::run_requested);
  connect(run_in_folder_, &QPushButton::clicked, this, &RecipeBox::run_in_folder_requested);
}

void RecipeBox::name_parts() {
  setTitle(tr("Recipe"));
  hint_->setText(
      tr("Readings to repeat on every frame, with their tolerances. Select a reading between A and "
         "B, then Add to recipe; or open a recipe."));
  list_->setHeaderLabels({tr("Reading"), tr("Value"), tr("Decision")});
  list_->setAccessibleName(tr("Readings of the recipe"));
  change_->setText(tr("Name, tolerance…"));
  change_->setToolTip(tr("Name and limits of the selected reading"));
  remove_->setText(tr("Remove"));
  remove_->setToolTip(tr("Takes the selected reading out of the recipe"));
  open_->setText(tr("Open recipe…"));
  open_->setToolTip(tr("Replaces the readings by those of a file"));
  save_->setText(tr("Save recipe…"));
  save_->setToolTip(tr("Writes the readings to a file, for other recordings and fingers"));
  run_in_folder_->setText(tr("Inspect a folder…"));
  run_in_folder_->setToolTip(tr("Measures the recipe in every recording of a folder: one table"));
  run_->setText(tr("Inspect all frames…"));
  run_->setToolTip(tr("Measures the recipe in every frame of the recording"));
  fill();
}

void RecipeBox::set_options(const InspectOptions& options) {
  const bool is_same =
      options.recipe == options_.recipe && options.recording.empty() == options_.recording.empty();
  options_ = options;
  if (!is_same) fill();
}

void RecipeBox::show_frame(const std::shared_ptr<const InspectedFrame>& frame) {
  frame_ = frame;
  if (!options_.recipe.readings.empty()) fill();
}

void RecipeBox::fill() {
  const auto& readings = options_.recipe.readings;
  const int before = selected();
  const QSignalBlocker quiet(list_);
  list_->clear();
  std::vector<InspectedReading> now;
  if (frame_ && frame_->mapping) now = inspect_frame(face_of(*frame_), options_.recipe);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    auto* row = new QTreeWidgetItem(list_);
    row->setText(kReadingName, QString::fromStdString(readings[i].name));
    const QString filter = filter_text(readings[i].filter);
    const QString read = name_of(readings[i].what);
    row->setToolTip(kReadingName, filter.isEmpty() ? read : labelled(read, filter));
    const QString tolerance = tolerance_text(readings[i]);
    row->setToolTip(kReadingDecision,
                    tolerance.isEmpty() ? QString() : labelled(tr("Tolerance"), tolerance));
    if (now.empty()) continue;
    const auto& [reading, decision] = now[i];
    row->setText(kReadingValue, value_text(readings[i].what, reading));
    if (!reading.measured) row->setToolTip(kReadingValue, window_sentence(reading.reason));
    if (decision == Conformity::kNoTolerance) continue;
    const Meaning meaning = meaning_of(decision);
    row->setText(kReadingDecision, conformity_text(decision));
    row->setIcon(kReadingDecision,
                 QIcon(symbol(meaning_symbol(meaning), meaning_colour(meaning, palette()),
                              kDecisionSymbol_px, devicePixelRatioF())));
  }
  list_->fit_columns();
  if (before >= 0 && before < list_->topLevelItemCount())
    list_->setCurrentItem(list_->topLevelItem(before));
  const bool is_any = !readings.empty();
  hint_->setVisible(!is_any);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{list_, change_, remove_, save_, run_, run_in_folder_})
    widget->setVisible(is_any);
  constexpr int kLeastRows = 2, kMostRows = 8;
  list_->fit_height(kLeastRows, kMostRows);
  run_->setEnabled(!options_.recording.empty());
  follow_selection();
}

int RecipeBox::selected() const {
  const auto rows = list_->selectedItems();
  return rows.isEmpty() ? -1 : list_->indexOfTopLevelItem(rows.front());
}

void RecipeBox::follow_selection() {
  for (QPushButton* button : {change_, remove_}) button->setEnabled(selected() >= 0);
}

void RecipeBox::set_recipe(InspectionRecipe recipe, const StepWords& what) {
  InspectOptions options = options_;
  options.recipe = std::move(recipe);
  problems_->set_problems({});
  Q_EMIT changed(options, what, -1);
}

void RecipeBox::add(Measurand what) {
  if (!options_.a || !options_.b) return;
  InspectionRecipe recipe = options_.recipe;
  const std::string name = recipe.free_name(name_of(what).toStdString());
  const RoughnessFilter filter =
      what == Measurand::kRoughness ? options_.filter : RoughnessFilter();
  recipe.readings.push_back({name, what, *options_.a, *options_.b, {}, {}, filter});
  set_recipe(std::move(recipe), [] { return tr("add a reading to the recipe"); });
}

void RecipeBox::change_selected() {
  const int at = selected();
  if (at < 0) return;
  const auto index = static_cast<std::size_t>(at);
  auto* dialog = new ReadingDialog(options_.recipe.readings[index], options_.recipe, this);
  connect(dialog, &ReadingDialog::accepted_reading, this,
          [this, index, before = options_.recipe](const RecipeReading& reading) {
            if (options_.recipe != before) return;  // undone meanwhile
            InspectionRecipe recipe = before;
            recipe.readings[index] = reading;
            set_recipe(std::move(recipe), [] { return tr("change a reading of the recipe"); });
          });
  show_dialog(*dialog);
}

void RecipeBox::remove_selected() {
  const int at = selected();
  if (at < 0) return;
  InspectionRecipe recipe = options_.recipe;
  recipe.readings.erase(recipe.readings.begin() + at);
  set_recipe(std::move(recipe), [] { return tr("remove a reading from the recipe"); });
}

void RecipeBox::choose_file() {
  ask_for_file(this, FilesOf::kRecipes, tr("Open a recipe"), tr("Recipes (*.yaml *.yml)"),
               [this](const QString& file) { open(file.toStdString()); });
}

void RecipeBox::open(const std::filesystem::path& file) {
  auto recipe = InspectionRecipe::load(file);
  if (!recipe) return problems_->set_problems({Problem::of(recipe.error())});
  set_recipe(std::move(*recipe), [] { return tr("open a recipe"); });
}

void RecipeBox::save() {
  ask_where_to_save(this, FilesOf::kRecipes, tr("Save the recipe"), QStringLiteral("yaml"), {},
                    [this, recipe = options_.recipe](const QString& file) {
                      const Status saved = recipe.save(file.toStdString());
                      problems_->set_problems(saved ? std::vector<Problem>()
                                                    : std::vector{Problem::of(saved.error())});
                    });
}

void RecipeBox::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) fill();
}

bool RecipeBox::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
    remove_selected();
    return true;
  }
  return Translated::eventFilter(watched, event);
}

ReadingDialog::ReadingDialog(RecipeReading reading, InspectionRecipe recipe, QWidget* parent)
    : FittedDialog(parent),
      reading_(std::move(reading)),
      recipe_(std::move(recipe)),
      name_label_(new QLabel),
      lower_label_(new QLabel),
      upper_label_(new QLabel),
      name_(new QLineEdit(QString::fromStdString(reading_.name))),
      lower_(limit_field(reading_.lower, reading_.what)),
      upper_(limit_field(reading_.upper, reading_.what)),
      problems_(new ProblemList),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  form->addRow(name_label_, name_);
  form->addRow(lower_label_, lower_);
  form->addRow(upper_label_, upper_);
  name_label_->setBuddy(name_);
  lower_label_->setBuddy(lower_);
  upper_label_->setBuddy(upper_);
  column->addLayout(form);
  problems_->show_in_full();
  problems_->setMinimumHeight(kReadingProblemsHeight_px);
  column->addWidget(problems_, 1, Qt::AlignTop);
  column->addWidget(buttons_);
  buttons_->button(QDialogButtonBox::Ok)->setDefault(true);
  connect(buttons_, &QDialogButtonBox::accepted, this, &ReadingDialog::take);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  say([this] {
    setWindowTitle(name_of(reading_.what));
    name_label_->setText(tr("&Name"));
    lower_label_->setText(tr("&Lower limit"));
    upper_label_->setText(tr("&Upper limit"));
    name_->setToolTip(tr("Name of the value in tables and reports"));
    for (NumberField* field : {lower_, upper_}) {
      field->setSpecialValueText(tr("none"));
      field->setToolTip(tr("A value beyond it fails; near it, the standard deviation decides"));
    }
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("OK"));
    buttons_->button(QDialogButtonBox::Ok)->setToolTip(tr("Takes this name and these limits"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    buttons_->button(QDialogButtonBox::Cancel)
        ->setToolTip(tr("Closes this window without a change (Esc)"));
  });
}

void ReadingDialog::take() {
  for (NumberField* field : {lower_, upper_}) {
    if (!field->typed()) return field->setFocus();
    field->interpretText();
  }
  const auto limit_of = [](const NumberField& field) {
    return field.value() > kUnlimited ? std::optional(field.value()) : std::nullopt;
  };
  RecipeReading changed = reading_;
  changed.name = name_->text().trimmed().toStdString();
  changed.lower = limit_of(*lower_);
  changed.upper = limit_of(*upper_);
  const bool is_taken =
      changed.name != reading_.name && recipe_.free_name(changed.name) != changed.name;
  QString problem;
  if (changed.name.empty()) problem = tr("Enter a name.");
  if (is_taken) problem = tr("Another reading has this name.");
  if (changed.lower && changed.upper && !(*changed.lower < *changed.upper))
    problem = tr("The lower limit must be below the upper one.");
  if (!problem.isEmpty()) return problems_->set_problems({{Meaning::kBad, problem}});
  Q_EMIT accepted_reading(changed);
  accept();
}

}  // namespace alltact
