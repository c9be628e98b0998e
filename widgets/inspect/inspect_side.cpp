#include "widgets/inspect/inspect_side.h"

#include "core/sensing/pipeline_settings.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/scene3d/vtk_view.h"
#include "widgets/verdict_text.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLocale>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

namespace alltact {

InspectSide::InspectSide(QWidget* parent)
    : Translated(parent),
      view_(new ViewBox),
      points_(new PointsBox),
      section_group_(new QGroupBox),
      section_(new SectionPlot),
      surface_(new SurfaceBox),
      recipe_(new RecipeBox) {
  auto* column = without_margins(new QVBoxLayout(this));
  section_->setMinimumHeight(190);
  (new QVBoxLayout(section_group_))->addWidget(section_);
  add_widgets(*column, {view_, points_, section_group_, surface_, recipe_});
  column->addStretch();
  connect(view_, &ViewBox::changed, this, &InspectSide::changed);
  connect(points_, &PointsBox::changed, this, &InspectSide::changed);
  connect(surface_, &SurfaceBox::changed, this, &InspectSide::changed);
  connect(surface_, &SurfaceBox::add_requested, recipe_, &RecipeBox::add);
  connect(recipe_, &RecipeBox::changed, this, &InspectSide::changed);
  connect(recipe_, &RecipeBox::run_requested, this, &InspectSide::run_requested);
  connect(recipe_, &RecipeBox::run_in_folder_requested, this,
          &InspectSide::run_in_folder_requested);
  say([this] { section_group_->setTitle(tr("Cross-section")); });
  measure();
}

QSize InspectSide::minimumSizeHint() const {
  QSize hint = QWidget::minimumSizeHint();
  for (const QWidget* box : std::initializer_list<const QWidget*>{section_group_, surface_})
    hint = hint.expandedTo({box->minimumSizeHint().width(), 0});
  return hint;
}

void InspectSide::set_options(const InspectOptions& options) {
  options_ = options;
  view_->set_options(options);
  points_->set_options(options);
  surface_->set_options(options);
  recipe_->set_options(options);
  measure();
}

void InspectSide::show_frame(const std::shared_ptr<const InspectedFrame>& frame) {
  frame_ = frame;
  points_->show_frame(frame);
  recipe_->show_frame(frame);
  measure();
}

void InspectSide::measure() {
  const bool has_depth = frame_ && frame_->result.depth;
  const auto a = has_depth ? pixel_of(*frame_, options_.a) : std::nullopt;
  const auto b = has_depth ? pixel_of(*frame_, options_.b) : std::nullopt;
  surface_->show_readings(frame_, a, b);
  section_->set_other_name(comparand_text(options_.with));
  if (!a || !b) return section_->set_profiles({}, std::nullopt);
  std::optional<Profile> other;
  if (options_.shown_comparison() != Comparison::kNone)
    other = other_profile(*frame_, *options_.a, *options_.b);
  section_->set_profiles(profile_between(frame_->result, frame_->face, frame_->sd_mm, *a, *b),
                         std::move(other));
}

namespace {

// Merge ids of the fields' undo steps.
constexpr int kTop = 2001, kTimes = 2002, kDifferenceTop = 2003, kFrameNumber = 2004;

NumberField* spin(double low, double high, double step, int decimals) {
  auto* box = new NumberField;
  box->setRange(low, high);
  box->setSingleStep(step);
  box->set_shown_decimals(decimals);
  return box;
}

void set_entry_enabled(QComboBox& box, int index, bool is_enabled) {
  auto* model = qobject_cast<QStandardItemModel*>(box.model());
  model->item(index)->setEnabled(is_enabled);
}

/// One setting with one value other than its default.
struct SettingChoice {
  std::string name, value;
  QString words;
};
std::vector<SettingChoice> setting_choices() {
  std::vector<SettingChoice> choices;
  const PipelineSettings defaults;
  for (const auto& setting : pipeline_settings()) {
    if (!setting.trade) continue;
    for (const std::string& value : setting.trade->tried) {
      PipelineSettings choice;
      if (!setting.set(choice, value) || setting.get(choice) == setting.get(defaults)) continue;
      choices.push_back({setting.name, value, difference_words(choice, defaults)});
    }
  }
  return choices;
}

QString name_of(const std::filesystem::path& file) {
  return QString::fromStdString(file.filename().string());
}

OtherMethod method_at(int index) {
  return static_cast<OtherMethod>(index + static_cast<int>(OtherMethod::kPaper));
}

}  // namespace

QString comparand_text(const ComparisonSpec& other) {
  switch (other.method) {
    case OtherMethod::kSetting:
      for (const SettingChoice& choice : setting_choices())
        if (choice.name == other.setting && choice.value == other.value) return choice.words;
      return QString::fromStdString(other.setting + ' ' + other.value);
    case OtherMethod::kFrame:
      return ViewBox::tr("frame %1").arg(QLocale().toString(qulonglong{other.frame} + 1));
    case OtherMethod::kRecording:
      return ViewBox::tr("frame %1 of %2")
          .arg(QLocale().toString(qulonglong{other.frame} + 1), name_of(other.file));
    case OtherMethod::kFinger:
      return ViewBox::tr("frame %1 of %2, finger %3")
          .arg(QLocale().toString(qulonglong{other.frame} + 1), name_of(other.file),
               name_of(other.finger));
    case OtherMethod::kBody:
      return name_of(other.file);
    case OtherMethod::kPaper:
    case OtherMethod::kNone:
      break;
  }
  return ViewBox::tr("the source paper's method");
}

ViewBox::ViewBox(QWidget* parent)
    : Translated(parent),
      shown_as_(new QComboBox),
      standpoint_(new QComboBox),
      comparison_(new QComboBox),
      with_(new QComboBox),
      setting_(new QComboBox),
      file_(new QPushButton),
      frame_(new IntegerField),
      top_(spin(0.05, 10, 0.05, 2)),
      difference_top_(spin(0.01, 2, 0.01, 2)),
      times_(spin(1, 50, 1, 0)) {
  comparison_->setObjectName(QStringLiteral("comparison"));
  with_->setObjectName(QStringLiteral("with"));
  shown_as_->addItems({{}, {}});
  standpoint_->addItems({{}, {}, {}, {}});
  comparison_->addItems({{}, {}, {}});
  with_->addItems({{}, {}, {}, {}, {}, {}});
  file_->setObjectName(QStringLiteral("comparand"));
  for (QComboBox* box : {shown_as_, standpoint_, comparison_, with_, setting_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(10);
  }
  new QGridLayout(this);
  add_row(shown_as_, [] { return tr("Sho&w"); });
  add_row(standpoint_, [] { return tr("View f&rom"); });
  add_row(comparison_, [] { return tr("Com&pare"); });
  add_row(with_, [] { return tr("&With"); });
  add_row(setting_, [] { return tr("Set&ting"); });
  add_row(file_, [] { return tr("F&ile"); });
  add_row(frame_, [] { return tr("Frame &number"); });
  add_row(top_, [] { return tr("&Colours up to"); });
  add_row(difference_top_, [] { return tr("Differe&nce up to"); });
  add_row(times_, [] { return tr("Scale &depth"); });
  auto* grid = static_cast<QGridLayout*>(layout());
  parts_ = {{new QCheckBox, &SceneOptions::body, [] { return tr("Finger's bod&y"); }},
            {new QCheckBox, &SceneOptions::ruler, [] { return tr("R&uler"); }},
            {new QCheckBox, &SceneOptions::camera, [] { return tr("Ca&mera"); }},
            {new QCheckBox, &SceneOptions::untouched, [] { return tr("Untouched face"); }}};
  auto* boxes = new QGridLayout;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    boxes->addWidget(parts_[i].box, static_cast<int>(i / 2), static_cast<int>(i % 2));
  grid->addLayout(boxes, static_cast<int>(rows_.size()), 0, 1, 2);
  grid->setColumnStretch(1, 1);
  if (!VtkView::is_supported()) {
    set_entry_enabled(*shown_as_, 0, false);
    options_.shown_as = ShownAs::kHeightMap;
  }
  connect_view();
  connect_comparison();
  say([this] {
    setTitle(tr("View"));
    for (const Row& row : rows_) {
      row.label->setText(row.text());
      row.widget->setAccessibleName(row.text().remove(QLatin1Char('&')));
    }
    const std::array tips{tr("Side faces, back and base of the finger, in 3D"),
                          tr("Millimetres along the face, and a stick of a known height, in 3D"),
                          tr("The camera with its axes, from which coordinates count, in 3D"),
                          tr("Thin lines where the face lies without contact, in 3D")};
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      parts_[i].box->setText(parts_[i].text());
      parts_[i].box->setToolTip(tips.at(i));
    }
    shown_as_->setItemText(0, tr("in 3D"));
    shown_as_->setItemText(1, tr("as a height map"));
    shown_as_->setToolTip(VtkView::is_supported()
                              ? tr("The face in 3D, or its depth over the image")
                              : tr("3D needs OpenGL 3.2, which this screen does not support."));
    standpoint_->setItemText(0, tr("inside, tilted"));
    standpoint_->setToolTip(tr("Where the eye is; drag in the view to turn it"));
    standpoint_->setItemText(1, tr("the camera"));
    standpoint_->setItemText(2, tr("outside, tilted"));
    standpoint_->setItemText(3, tr("the side"));
    comparison_->setItemText(0, tr("no comparison"));
    comparison_->setToolTip(
        tr("Shows another measurement next to this one, or the difference of both"));
    comparison_->setItemText(1, tr("side by side"));
    comparison_->setItemText(2, tr("difference"));
    with_->setItemText(0, tr("the source paper"));
    with_->setItemText(1, tr("another setting"));
    with_->setItemText(2, tr("another frame"));
    with_->setItemText(3, tr("another recording"));
    with_->setItemText(4, tr("another finger"));
    with_->setItemText(5, tr("a body (STL, OBJ)"));
    with_->setToolTip(
        tr("The paper's formulas or another setting measure the same frame again. With another "
           "frame, recording or finger, the same positions on the face are compared. A body is "
           "turned and shifted until it fits the deeper part of the largest contact; the "
           "difference is then the skin's distance from the body."));
    file_->setToolTip(tr("Choose another file. An image stands for all the images in its folder."));
    for (NumberField* box : {top_, difference_top_}) box->setSuffix(tr(" mm"));
    difference_top_->setPrefix(QStringLiteral("± "));
    top_->setAccessibleName(tr("Depth at which the colours end"));
    top_->setToolTip(tr("Deeper contacts have the colour of the end of the scale"));
    difference_top_->setAccessibleName(tr("Difference at both ends of the colour scale"));
    difference_top_->setToolTip(tr("Larger differences have the colours of the ends of the scale"));
    times_->setSuffix(tr(" times"));
    times_->setAccessibleName(tr("Factor by which depth is drawn larger"));
    frame_->setToolTip(tr("Number of the frame to compare with, from 1"));
    setting_->setToolTip(tr("The same frame, measured with this setting"));
    times_->setToolTip(tr("Draws depth larger in 3D; measured values do not change"));
    fill_settings();
  });
  set_options(options_);
}

void ViewBox::add_row(QWidget* widget, QString (*text)()) {
  auto* grid = static_cast<QGridLayout*>(layout());
  auto* label = new QLabel;
  label->setBuddy(widget);
  const int row = static_cast<int>(rows_.size());
  grid->addWidget(label, row, 0);
  grid->addWidget(widget, row, 1);
  rows_.push_back({label, widget, text});
}

QLabel* ViewBox::label_of(const QWidget* widget) const {
  return std::find_if(rows_.begin(), rows_.end(),
                      [&](const Row& row) { return row.widget == widget; })
      ->label;
}

void ViewBox::fill_settings() {
  const QSignalBlocker quiet(setting_);
  setting_->clear();
  for (const SettingChoice& choice : setting_choices())
    setting_->addItem(choice.words, QStringList{QString::fromStdString(choice.name),
                                                QString::fromStdString(choice.value)});
  set_options(options_);
}

void ViewBox::connect_view() {
  connect(shown_as_, &QComboBox::activated, this, [this](int index) {
    InspectOptions next = options_;
    next.shown_as = static_cast<ShownAs>(index + 1);
    Q_EMIT changed(
        next, [this, index] { return tr("show as %1").arg(shown_as_->itemText(index)); }, -1);
  });
  connect(standpoint_, &QComboBox::activated, this, [this](int index) {
    InspectOptions next = options_;
    next.viewpoint = static_cast<Viewpoint>(index + 1);
    next.view_pose.reset();
    Q_EMIT changed(
        next, [this, index] { return tr("view from: %1").arg(standpoint_->itemText(index)); }, -1);
  });
  const auto on_number = [this](NumberField* box, double SceneOptions::*member, QString (*what)(),
                                int merge_id) {
    connect(box, &NumberField::valueChanged, this, [=, this](double value) {
      InspectOptions next = options_;
      next.scene.*member = value;
      Q_EMIT changed(next, what, merge_id);
    });
  };
  on_number(
      top_, &SceneOptions::top_mm, [] { return tr("change the depth colours"); }, kTop);
  on_number(
      difference_top_, &SceneOptions::difference_top_mm,
      [] { return tr("change the difference's colours"); }, kDifferenceTop);
  on_number(
      times_, &SceneOptions::exaggeration, [] { return tr("scale the depth"); }, kTimes);
  for (const Part& part : parts_)
    connect(part.box, &QCheckBox::clicked, this, [this, part](bool is_on) {
      InspectOptions next = options_;
      next.scene.*part.member = is_on;
      const auto what = [text = part.text, is_on] {
        const QString name = text().remove(QLatin1Char('&'));
        return is_on ? tr("show %1").arg(name) : tr("hide %1").arg(name);
      };
      Q_EMIT changed(next, what, -1);
    });
}

void ViewBox::connect_comparison() {
  connect(comparison_, &QComboBox::activated, this, [this](int index) {
    InspectOptions next = options_;
    next.comparison = static_cast<Comparison>(index + 1);
    Q_EMIT changed(
        next, [this, index] { return tr("compare: %1").arg(comparison_->itemText(index)); }, -1);
  });
  const auto change_with = [this](const ComparisonSpec& with, int merge_id) {
    InspectOptions next = options_;
    next.with = with;
    Q_EMIT changed(
        next, [with] { return tr("compare with %1").arg(comparand_text(with)); }, merge_id);
  };
  connect(with_, &QComboBox::activated, this, [this, change_with](int index) {
    ComparisonSpec with = options_.with;
    with.method = method_at(index);
    if (needs_file(with.method)) {
      set_options(options_);  // until a file is chosen
      return ask_for_comparand(
          with, [change_with](const ComparisonSpec& chosen) { change_with(chosen, -1); });
    }
    if (with.method == OtherMethod::kSetting && with.setting.empty()) {
      const SettingChoice first = setting_choices().front();
      with.setting = first.name;
      with.value = first.value;
    }
    change_with(with, -1);
  });
  connect(file_, &QPushButton::clicked, this, [this, change_with] {
    ask_for_comparand(options_.with,
                      [change_with](const ComparisonSpec& chosen) { change_with(chosen, -1); });
  });
  connect(setting_, &QComboBox::activated, this, [this, change_with](int index) {
    const QStringList choice = setting_->itemData(index).toStringList();
    ComparisonSpec with = options_.with;
    with.setting = choice[0].toStdString();
    with.value = choice[1].toStdString();
    change_with(with, -1);
  });
  connect(frame_, &IntegerField::valueChanged, this, [this, change_with](int number) {
    ComparisonSpec with = options_.with;
    with.frame = static_cast<std::size_t>(number - 1);
    change_with(with, kFrameNumber);
  });
}

void ViewBox::ask_for_comparand(const ComparisonSpec& with,
                                const std::function<void(const ComparisonSpec&)>& use) {
  const auto use_file = [with, use](const std::filesystem::path& file) {
    ComparisonSpec chosen = with;
    chosen.file = file;
    use(chosen);
  };
  if (with.method == OtherMethod::kBody)
    return ask_for_file(this, FilesOf::kMeshes, tr("Body to compare with, in mm"),
                        tr("Meshes (*.stl *.obj *.STL *.OBJ)"),
                        [use_file](const QString& file) { use_file(file.toStdString()); });
  if (with.method == OtherMethod::kFinger) {
    const bool is_known = !with.finger.empty();
    auto* dialog = new SecondFingerDialog(
        is_known ? std::optional(SecondFinger{with.finger, with.file}) : std::nullopt, this,
        SecondFingerDialog::Purpose::kComparison);
    connect(dialog, &SecondFingerDialog::chosen, this, [with, use](const SecondFinger& other) {
      ComparisonSpec chosen = with;
      chosen.finger = other.finger;
      chosen.file = other.recording;
      use(chosen);
    });
    return show_dialog(*dialog);
  }
  ask_for_file(this, FilesOf::kRecordings, tr("Recording to compare with"),
               video_filter() + QLatin1String(";;") + image_filter(),
               [use_file](const QString& chosen) {
                 const std::filesystem::path file = chosen.toStdString();
                 use_file(is_image_file(file) ? file.parent_path() : file);
               });
}

void ViewBox::set_frame_count(std::size_t count) {
  if (count == frame_count_) return;
  frame_count_ = count;
  show_rows();
}

void ViewBox::set_options(const InspectOptions& options) {
  options_ = options;
  const QSignalBlocker quiet[] = {QSignalBlocker(top_), QSignalBlocker(difference_top_),
                                  QSignalBlocker(times_)};
  shown_as_->setCurrentIndex(VtkView::is_supported() ? static_cast<int>(options.shown_as) - 1 : 1);
  standpoint_->setCurrentIndex(static_cast<int>(options.viewpoint) - 1);
  comparison_->setCurrentIndex(static_cast<int>(options.shown_comparison()) - 1);
  with_->setCurrentIndex(
      std::max(0, static_cast<int>(options.with.method) - static_cast<int>(OtherMethod::kPaper)));
  setting_->setCurrentIndex(setting_->findData(QStringList{
      QString::fromStdString(options.with.setting), QString::fromStdString(options.with.value)}));
  top_->setValue(options.scene.top_mm);
  difference_top_->setValue(options.scene.difference_top_mm);
  times_->setValue(options.scene.exaggeration);
  for (const Part& part : parts_) part.box->setChecked(options.scene.*part.member);
  show_rows();
}

/// Hides what depends on another choice above; disables what has no effect in this view.
void ViewBox::show_rows() {
  const QSignalBlocker quiet(frame_);
  constexpr int kOfAnyRecording = 999'999;  // the last frame stands for those beyond it
  frame_->setRange(1, options_.with.method != OtherMethod::kFrame
                          ? kOfAnyRecording
                          : std::max(1, static_cast<int>(frame_count_)));
  frame_->setValue(static_cast<int>(options_.with.frame) + 1);
  set_entry_enabled(*with_, 2, frame_count_ > 0);
  set_entry_enabled(*with_, 3, frame_count_ > 0);
  set_entry_enabled(*with_, 4, frame_count_ > 0);
  file_->setText(name_of(options_.with.file));
  const bool is_3d = shown_as_->currentIndex() == 0;
  standpoint_->setEnabled(is_3d);
  times_->setEnabled(is_3d);
  for (const Part& part : parts_) part.box->setEnabled(is_3d);
  comparison_->setEnabled(!options_.second);
  const Comparison comparison = options_.shown_comparison();
  const bool is_compared = comparison != Comparison::kNone;
  const auto show = [this](QWidget* widget, bool is_shown) {
    widget->setVisible(is_shown);
    label_of(widget)->setVisible(is_shown);
  };
  show(with_, is_compared);
  show(setting_, is_compared && options_.with.method == OtherMethod::kSetting);
  show(file_, is_compared && needs_file(options_.with.method));
  show(frame_, is_compared && is_other_frame(options_.with.method));
  show(top_, comparison != Comparison::kDifference);
  show(difference_top_, comparison == Comparison::kDifference);
}

}  // namespace alltact
