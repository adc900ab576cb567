// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/stock_panel.h"

#include "ui/panels/buttons.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/length_field.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/stock_shape_fields.h"
#include "ui/panels/texts.h"
#include "ui/panels/value_row.h"

#include <algorithm>
#include <array>
#include <functional>

namespace burin {

namespace {

constexpr double largestMargin = 1000.0; // mm
constexpr double smallestVoxel = 0.01, largestVoxel = 10.0;
constexpr double million = 1e6;
constexpr int voxelLines = 2; // of the voxel count, fixed so that a change of it moves nothing below

/// The margins of the four sides, which the panel shows as one.
std::array<double, 4> sides(const Setup& setup) {
    return {setup.marginLow.x, setup.marginLow.y, setup.marginHigh.x, setup.marginHigh.y};
}

bool hasMargins(const Setup& setup) {
    return !setup.stated && (setup.form == StockForm::box || setup.form == StockForm::cylinder);
}

} // namespace

class StockPanel::Fields : public QObject {
public:
    explicit Fields(StockPanel* panel);
    void refresh();
    void setUnit(LengthUnit next);

    StockState state;

private:
    LengthField* addField(const QString& label, const QString& toolTip, const char* name);
    void change(const std::function<void(Setup&)>& edit);
    void refreshNotices();
    QString reasonAgainstEmbedding() const;
    QString voxelText() const;

    StockPanel* panel_;
    QVBoxLayout* column_;
    StockShapeFields* shape_;
    LengthUnit unit_ = LengthUnit::millimetre;
    LengthField *sides_, *top_, *bottom_, *voxel_;
    std::vector<QWidget*> rows_; ///< the rows of these fields
    ValueRow* size_;
    QLabel* voxels_;
    QPushButton* embed_;
    Notice *notice_, *sidesNotice_;
};

StockPanel::Fields::Fields(StockPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(StockPanel::tr("Stock"), panel));
    shape_ = new StockShapeFields(panel);
    column_->addWidget(shape_);
    connect(shape_, &StockShapeFields::edited, panel, &StockPanel::setupEdited);
    connect(shape_, &StockShapeFields::fileRequested, panel, &StockPanel::fileRequested);
    sides_ = addField(StockPanel::tr("Margin, sides"), StockPanel::tr("Stock beside the part, on all four sides"),
                      "sideMarginField");
    top_ = addField(StockPanel::tr("Margin, top"), StockPanel::tr("Stock above the part"), "topMarginField");
    bottom_ = addField(StockPanel::tr("Margin, bottom"), StockPanel::tr("Stock below the part"), "bottomMarginField");
    size_ = new ValueRow(StockPanel::tr("Stock size"), panel);
    size_->setObjectName(QStringLiteral("stockSize"));
    column_->addWidget(size_);

    column_->addWidget(makeSectionTitle(StockPanel::tr("Voxels"), panel));
    voxel_ = addField(StockPanel::tr("Voxel size"),
                      StockPanel::tr("Smaller voxels show finer detail and take more memory"), "voxelField");
    voxel_->limit(smallestVoxel, largestVoxel);
    voxels_ = makeWrappedLabel(panel);
    voxels_->setObjectName(QStringLiteral("voxelCount"));
    voxels_->setProperty("look", "quiet");
    voxels_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column_->addWidget(voxels_);

    auto* notices = new NoticePlace(panel);
    sidesNotice_ = notices->add("sideMarginNotice");
    notice_ = notices->add("stockNotice");
    column_->addWidget(notices);
    embed_ = makePrimaryButton(StockPanel::tr("Embed the part"), QStringLiteral("embedButton"), panel);
    column_->addWidget(embed_);
    column_->addStretch(1);

    connect(sides_, &LengthField::valueEdited, this, [this](double margin) {
        change([margin](Setup& setup) {
            setup.marginLow.x = setup.marginLow.y = setup.marginHigh.x = setup.marginHigh.y = margin;
        });
    });
    connect(top_, &LengthField::valueEdited, this,
            [this](double margin) { change([margin](Setup& setup) { setup.marginHigh.z = margin; }); });
    connect(bottom_, &LengthField::valueEdited, this,
            [this](double margin) { change([margin](Setup& setup) { setup.marginLow.z = margin; }); });
    connect(voxel_, &LengthField::valueEdited, this,
            [this](double size) { change([size](Setup& setup) { setup.voxel = size; }); });
    connect(embed_, &QPushButton::clicked, panel, &StockPanel::embedRequested);
}

LengthField* StockPanel::Fields::addField(const QString& label, const QString& toolTip, const char* name) {
    auto* field = new LengthField(panel_);
    field->setObjectName(QLatin1String(name));
    field->limit(0.0, largestMargin);
    auto* row = new FieldRow(label, field, toolTip, panel_);
    column_->addWidget(row);
    rows_.push_back(row);
    return field;
}

void StockPanel::Fields::change(const std::function<void(Setup&)>& edit) {
    edit(state.setup);
    emit panel_->setupEdited(state.setup);
}

void StockPanel::Fields::setUnit(LengthUnit next) {
    unit_ = next;
    for (LengthField* field : {sides_, top_, bottom_, voxel_}) field->setLengthUnit(next);
    shape_->setUnit(next);
    refresh();
}

QString StockPanel::Fields::voxelText() const {
    if (!state.size) return {};
    const glm::ivec3 voxels = state.size->voxels;
    const double count = 1.0 * voxels.x * voxels.y * voxels.z;
    const QString total = count >= million
                              ? StockPanel::tr("%1\u00a0million").arg(QLocale().toString(count / million, 'f', 1))
                              : QLocale().toString(count, 'f', 0);
    return StockPanel::tr("%1 × %2 × %3 voxels = %4, %5\u00a0MB")
        .arg(voxels.x)
        .arg(voxels.y)
        .arg(voxels.z)
        .arg(total, QLocale().toString(state.size->megabytes, 'f', state.size->megabytes < 10.0 ? 1 : 0));
}

QString StockPanel::Fields::reasonAgainstEmbedding() const {
    if (!state.hasPart) return StockPanel::tr("Import a part first.");
    if (state.busy) return StockPanel::tr("Work is under way.");
    if (state.locked) return StockPanel::tr("Stock and material can't be changed once there are takes.");
    if (!state.problem.isEmpty()) return state.problem;
    if (state.embedded) return StockPanel::tr("The workpiece matches these settings.");
    return {};
}

void StockPanel::Fields::refreshNotices() {
    const Setup& setup = state.setup;
    const std::array<double, 4> margins = sides(setup);
    const bool equal = std::ranges::all_of(margins, [&](double margin) { return margin == margins[0]; });
    sidesNotice_->tell(
        Notice::Kind::information,
        equal || !hasMargins(setup) || !state.problem.isEmpty() || state.locked
            ? QString() // problems have priority
            : StockPanel::tr("The margins of the sides differ: %1 to %2. An entry sets all four.")
                  .arg(lengthText(std::ranges::min(margins), unit_), lengthText(std::ranges::max(margins), unit_)));
    if (!state.problem.isEmpty())
        notice_->tell(Notice::Kind::error, state.problem);
    else if (!state.hasPart)
        notice_->tell(Notice::Kind::information, StockPanel::tr("Import a part first."));
    else if (!state.findings.empty())
        notice_->tell(Notice::Kind::warning,
                      state.findings.size() == 1
                          ? StockPanel::tr("Embedding has 1 finding. See the end of this page.")
                          : StockPanel::tr("Embedding has %n findings. See the end of this page.", nullptr,
                                           static_cast<int>(state.findings.size())));
    else if (state.locked)
        notice_->tell(Notice::Kind::information,
                      StockPanel::tr("Stock and material can't be changed once there are takes."));
    else if (state.embedded)
        notice_->tell(Notice::Kind::passed,
                      StockPanel::tr("The workpiece matches these settings; after a change of stock or voxels "
                                     "it has to be embedded again."));
    else
        notice_->clear();
}

void StockPanel::Fields::refresh() {
    const Setup& setup = state.setup;
    shape_->showSetup(setup, state.locked);
    constexpr std::size_t margins = 3;
    for (std::size_t i = 0; i < margins; ++i) rows_[i]->setVisible(hasMargins(setup));
    sides_->showValue(std::ranges::max(sides(setup)));
    top_->showValue(setup.marginHigh.z);
    bottom_->showValue(setup.marginLow.z);
    voxel_->showValue(setup.voxel);
    for (LengthField* field : {sides_, top_, bottom_}) setEnabledKeepingFocus(field, !state.locked);
    setEnabledKeepingFocus(voxel_, !state.locked && setup.form != StockForm::file); // a volume has its own voxel size
    size_->setValue(setup.stock.empty() || !state.hasPart ? QStringLiteral("–") : sizeText(setup.stock.size(), unit_));
    setWrappedText(voxels_, voxelText());
    voxels_->ensurePolished(); // the style may set another font
    voxels_->setFixedHeight(voxelLines * voxels_->fontMetrics().lineSpacing());
    embed_->setText(state.embedded ? StockPanel::tr("Embedded") : StockPanel::tr("Embed the part"));
    enableUnless(embed_, reasonAgainstEmbedding(),
                 StockPanel::tr("Embed the part in its stock; this makes the workpiece"));
    refreshNotices();
}

StockPanel::StockPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("stockPanel"));
    fields_->refresh();
}

void StockPanel::setUnit(LengthUnit unit) {
    fields_->setUnit(unit);
}

void StockPanel::setState(const StockState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin
