// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/pass_dialog.h"

#include "core/base/units.h"
#include "core/exchange/plan_drawing.h"
#include "core/recording/generated_moves.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/notice.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QLabel>

#include <algorithm>

namespace burin {

namespace {

constexpr int passDialogWidth = 460;    // pixels
constexpr double widestStep = 1000.0;   // mm
constexpr double rightAngle = 0.5 * pi; // rad

using Kinds = std::vector<PassKind>;
const Kinds allKinds{PassKind::levels, PassKind::pocket, PassKind::profile, PassKind::face,      PassKind::parallel,
                     PassKind::radial, PassKind::spiral, PassKind::flow,    PassKind::waterline, PassKind::scallop,
                     PassKind::pencil, PassKind::rest,   PassKind::engrave};
const Kinds levelKinds{PassKind::levels, PassKind::pocket, PassKind::profile, PassKind::face, PassKind::engrave};
const Kinds rowKinds{PassKind::parallel,  PassKind::radial,  PassKind::spiral, PassKind::flow,
                     PassKind::waterline, PassKind::scallop, PassKind::rest};
const Kinds surfaceKinds{PassKind::parallel,  PassKind::radial,  PassKind::spiral, PassKind::flow,
                         PassKind::waterline, PassKind::scallop, PassKind::rest,   PassKind::pencil};

bool contains(const Kinds& kinds, PassKind kind) {
    return std::ranges::find(kinds, kind) != kinds.end();
}
Kinds without(Kinds kinds, PassKind kind) {
    std::erase(kinds, kind);
    return kinds;
}
Kinds both(Kinds kinds, const Kinds& others) {
    kinds.insert(kinds.end(), others.begin(), others.end());
    return kinds;
}

QString passWords(const TextId& text) {
    return QCoreApplication::translate(text.context, text.text);
}

constexpr int areaDrawing = 1;                 // its place in the list "passArea"
constexpr int paintedArea = 1, areaBefore = 2; // what the list knows its further choices by

/// mm of what the list "passUnit" offers, in its order.
constexpr double fileUnits[] = {0.0, 1.0, 10.0, 25.4};

} // namespace

PassDialog::PassDialog(const Offer& offer, QWidget* parent)
    : QDialog(parent)
    , unit_(offer.unit)
    , defaults_(offer.defaults)
    , folder_(offer.folder)
    , painted_(offer.painted)
    , takes_(offer.takes)
    , wanted_(offer.last) {
    setObjectName(QStringLiteral("passDialog"));
    setWindowTitle(offer.last.instead ? tr("Change a pass") : tr("Compute a pass"));
    layOut(offer);
    setFixedWidth(passDialogWidth);
    kind_->setCurrentIndex(static_cast<int>(offer.last.request.kind));
    for (Figure& figure : figures_) { // as they were the last time
        const PassRequest& last = offer.last.request;
        std::optional<double> value = figure.member != nullptr ? last.*figure.member : last.*figure.height;
        if (figure.member != nullptr && *value == PassRequest{}.*figure.member) value.reset();
        if (!value) continue;
        figure.field->showValue(*value);
        figure.edited = true;
    }
    update();
    kind_->setFocus();
}

void PassDialog::layOut(const Offer& offer) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(6);
    const QString adds =
        tr("Computes moves of %1 for the stock that the earlier paths leave, and adds them to the path of "
           "this tool. You can edit, check and undo them like recorded ones.");
    const QString replaces =
        tr("Computes this pass of %1 again for the stock that is left before it. The pass keeps its "
           "position in the path.");
    auto* about = new QLabel((offer.last.instead ? replaces : adds).arg(offer.toolName), this);
    about->setWordWrap(true);
    column->addWidget(about);
    kind_ = new ChoiceBox(this);
    kind_->setObjectName(QStringLiteral("passKind"));
    for (const PassKindRow& row : passKinds) {
        kind_->addItem(passWords(row.title));
        kind_->setItemData(kind_->count() - 1, passWords(row.toolTip), Qt::ToolTipRole);
    }
    column->addWidget(new FieldRow(tr("Pass"), kind_, tr("What the pass does"), this, FieldRow::choiceWidth));
    addFigures();
    addDrawings(offer);
    auto* notices = new NoticePlace(this);
    notice_ = notices->add("passNotice");
    column->addWidget(notices);
    auto* compute = makePrimaryButton(tr("Compute"), QStringLiteral("computePassButton"), this);
    compute->setToolTip(tr("Compute the pass in the background; it can be cancelled in the status line"));
    compute->setDefault(true);
    auto* cancel = makeButton(tr("Cancel"), QStringLiteral("cancel"), QStringLiteral("cancelPassButton"), this);
    cancel->setToolTip(tr("Change nothing"));
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(compute);
    row->addWidget(cancel);
    column->addLayout(row);
    connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
        for (Figure& figure : figures_) figure.edited = false; // what roughing was given is no figure for finishing
        update();
    });
    connect(compute, &QPushButton::clicked, this, &PassDialog::confirm);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
}

void PassDialog::addFigures() {
    const auto figure = [](double PassRequest::*member, const Kinds& kinds) {
        return Figure{nullptr, nullptr, member, nullptr, kinds};
    };
    const auto height = [](std::optional<double> PassRequest::*member, const Kinds& kinds) {
        return Figure{nullptr, nullptr, nullptr, member, kinds};
    };
    addFigure(figure(&PassRequest::allowance, allKinds), "passAllowance", tr("Allowance"),
              tr("Stock that stays on the part"), Quantity::length, 0.0, largestAllowance);
    addFigure(figure(&PassRequest::stepOver, both(rowKinds, {PassKind::levels, PassKind::pocket, PassKind::face})),
              "passStepOver", tr("Step-over"),
              tr("Distance between rows or loops, or between the heights of a waterline"), Quantity::length, 0.0,
              widestStep);
    addFigure(figure(&PassRequest::scallop, rowKinds), "passScallop", tr("Scallop height"),
              tr("Largest height of the ridges between rows; replaces the step-over. 0: not used"), Quantity::length,
              0.0, widestStep);
    addFigure(figure(&PassRequest::levelDepth, levelKinds), "passLevelDepth", tr("Depth of a level"),
              tr("Largest depth of a level. Default: what material, tool and spindle can take"), Quantity::length, 0.0,
              widestStep);
    addFigure(figure(&PassRequest::stairs, {PassKind::levels}), "passStairs", tr("Steps on slopes"),
              tr("Largest height of the steps that the levels leave on slopes"), Quantity::length, 0.0, widestStep);
    addFigure(figure(&PassRequest::depth, {PassKind::engrave}), "passDepth", tr("Depth"),
              tr("Depth of the lines below the top of the stock"), Quantity::length, 0.0, widestStep);
    addFigure(figure(&PassRequest::direction, {PassKind::parallel, PassKind::rest}), "passDirection", tr("Direction"),
              tr("Angle between the rows and X"), Quantity::angle, -pi, pi);
    addFigure(figure(&PassRequest::flattest, surfaceKinds), "passFlattest", tr("Steeper than"),
              tr("Only where the part is at least this steep"), Quantity::angle, 0.0, rightAngle);
    addFigure(figure(&PassRequest::steepest, surfaceKinds), "passSteepest", tr("Flatter than"),
              tr("Only where the part is at most this steep"), Quantity::angle, 0.0, rightAngle);
    addFigure(height(&PassRequest::top, levelKinds), "passTop", tr("From height"),
              tr("Height at which the pass begins, in the coordinates of the setup"), Quantity::length, -farthestInPlan,
              farthestInPlan);
    addFigure(height(&PassRequest::bottom, without(allKinds, PassKind::engrave)), "passBottom", tr("Down to height"),
              tr("Lowest height of the tip, in the coordinates of the setup"), Quantity::length, -farthestInPlan,
              farthestInPlan);
    addSwitch({nullptr, &PassRequest::restOnly, without(surfaceKinds, PassKind::rest)}, "passRest",
              tr("Only where stock is left"), tr("Skips rows that would touch no stock"));
    addSwitch({nullptr,
               &PassRequest::oneWay,
               {PassKind::parallel, PassKind::radial, PassKind::spiral, PassKind::flow, PassKind::rest}},
              "passOneWay", tr("All rows in one direction"), tr("The tool returns through the air after each row"));
    addSwitch({nullptr, &PassRequest::inside, {PassKind::profile}}, "passInside", tr("Inside the outline"),
              tr("The cutter follows the outline of the area on its inside"));
}

void PassDialog::addFigure(Figure figure, const char* name, const QString& label, const QString& toolTip,
                           Quantity quantity, double low, double high) {
    figure.field = new QuantityField(quantity, this);
    figure.field->setObjectName(QLatin1String(name));
    figure.field->setLengthUnit(unit_);
    figure.field->limit(low, high);
    figure.row = new FieldRow(label, figure.field, toolTip, this);
    layout()->addWidget(figure.row);
    connect(figure.field, &QuantityField::valueEdited, this,
            [this, place = figures_.size()] { figures_[place].edited = true; });
    figures_.push_back(std::move(figure));
}

double PassDialog::defaultOf(const Figure& figure) const {
    const PassKind chosen = kind();
    const bool rough = chosen == PassKind::levels || chosen == PassKind::pocket || chosen == PassKind::face;
    if (figure.height == &PassRequest::top) return defaults_.top;
    if (figure.height == &PassRequest::bottom) return chosen == PassKind::face ? defaults_.partTop : defaults_.bottom;
    if (figure.member == &PassRequest::stepOver) return rough ? defaults_.roughStep : defaults_.fineStep;
    if (figure.member == &PassRequest::levelDepth) return defaults_.levelDepth;
    if (figure.member == &PassRequest::stairs) return defaults_.stairs;
    if (figure.member == &PassRequest::steepest) return rightAngle;
    return 0.0;
}

/// What nobody entered follows the kind of pass.
void PassDialog::showDefaults() {
    for (const Figure& figure : figures_)
        if (!figure.edited) figure.field->showValue(defaultOf(figure));
}

void PassDialog::addSwitch(Switch one, const char* name, const QString& label, const QString& toolTip) {
    one.box = new QCheckBox(label, this);
    one.box->setObjectName(QLatin1String(name));
    one.box->setToolTip(toolTip);
    one.box->setChecked(wanted_.request.*one.member);
    layout()->addWidget(one.box);
    switches_.push_back(std::move(one));
}

void PassDialog::addDrawings(const Offer& offer) {
    area_ = new ChoiceBox(this);
    area_->setObjectName(QStringLiteral("passArea"));
    area_->addItems({tr("whole part"), tr("from a drawing…")});
    if (!painted_.empty()) area_->addItem(tr("painted area"), paintedArea);
    if (!wanted_.request.area.empty()) area_->addItem(tr("area of this pass"), areaBefore);
    const int chosen = area_->findData(wanted_.instead ? areaBefore : paintedArea);
    if (chosen >= 0) area_->setCurrentIndex(chosen);
    areaRow_ =
        new FieldRow(tr("Area"), area_,
                     tr("Where the tool may go: what was painted on the part, or the closed curves of a DXF or SVG "
                        "drawing, in the coordinates of the setup"),
                     this, FieldRow::choiceWidth);
    layout()->addWidget(areaRow_);
    areaOnPart_ = new QCheckBox(tr("Area on the part"), this);
    areaOnPart_->setObjectName(QStringLiteral("passAreaOnPart"));
    areaOnPart_->setToolTip(tr("The area limits where the tool touches the part, not where its tip goes"));
    areaOnPart_->setChecked(wanted_.instead ? wanted_.request.areaOnPart : !painted_.empty());
    layout()->addWidget(areaOnPart_);
    lines_ = new ChoiceBox(this);
    lines_->setObjectName(QStringLiteral("passLines"));
    lines_->addItems({tr("nothing"), tr("from a drawing…")});
    for (const TakeInfo& take : offer.takes)
        lines_->addItem(tr("strokes of take %1").arg(take.id), static_cast<qlonglong>(take.id));
    if (!wanted_.request.lines.empty()) {
        lines_->addItem(tr("lines of this pass"));
        lines_->setCurrentIndex(lines_->count() - 1);
    }
    linesRow_ =
        new FieldRow(tr("Lines"), lines_,
                     tr("What the rows follow, or what is engraved: strokes of a recording or curves of a drawing"),
                     this, FieldRow::choiceWidth);
    layout()->addWidget(linesRow_);
    fileUnit_ = new ChoiceBox(this);
    fileUnit_->setObjectName(QStringLiteral("passUnit"));
    fileUnit_->addItems({tr("as stated in the file"), tr("mm"), tr("cm"), tr("inch")});
    fileUnitRow_ =
        new FieldRow(tr("Unit of the drawing"), fileUnit_, tr("Unit of the coordinates; not every drawing states it"),
                     this, FieldRow::choiceWidth);
    layout()->addWidget(fileUnitRow_);
    connect(area_, &QComboBox::activated, this, [this](int index) {
        if (index == areaDrawing) chooseDrawing(area_, areaFile_);
        areaOnPart_->setChecked(index > areaDrawing);
        update();
    });
    connect(lines_, &QComboBox::activated, this, [this](int index) {
        if (index == 1) chooseDrawing(lines_, linesFile_);
        update();
    });
}

void PassDialog::chooseDrawing(ChoiceBox* box, QString& file) {
    const QString chosen = askDrawingToRead(this, folder_);
    if (!chosen.isEmpty()) {
        file = chosen;
        folder_ = QFileInfo(chosen).absolutePath();
        box->setItemText(1, QFileInfo(chosen).fileName());
    }
    if (file.isEmpty()) box->setCurrentIndex(0);
}

PassKind PassDialog::kind() const {
    return passKinds[static_cast<std::size_t>(std::max(0, kind_->currentIndex()))].kind;
}

void PassDialog::update() {
    const PassKind chosen = kind();
    kind_->setToolTip(passWords(rowOf(chosen).toolTip));
    showDefaults();
    for (const Figure& figure : figures_) figure.row->setVisible(contains(figure.kinds, chosen));
    for (const Switch& one : switches_) one.box->setVisible(contains(one.kinds, chosen));
    areaRow_->setVisible(chosen != PassKind::engrave);
    areaOnPart_->setVisible(contains(surfaceKinds, chosen) && area_->currentIndex() != 0);
    linesRow_->setVisible(chosen == PassKind::engrave || chosen == PassKind::flow);
    fileUnitRow_->setVisible(area_->currentIndex() == areaDrawing ||
                             (linesRow_->isVisibleTo(this) && lines_->currentIndex() == 1));
    notice_->clear();
    adjustSize();
}

/// What the kind of pass can't do without, in words.
QString PassDialog::missing(const WantedPass& wanted) const {
    const PassRequest& request = wanted.request;
    if (area_->currentIndex() == 0 && request.kind == PassKind::pocket)
        return tr("Paint the area of the pocket, or choose a drawing with its outline.");
    if (area_->currentIndex() == 0 && request.kind == PassKind::profile && request.inside)
        return tr("Paint an area, or choose a drawing with the outline to follow.");
    if (lines_->currentIndex() == 0 && request.kind == PassKind::engrave)
        return tr("Choose the strokes or the drawing to engrave.");
    if (lines_->currentIndex() == 0 && request.kind == PassKind::flow)
        return tr("Choose the strokes or the drawing that the rows follow.");
    if (request.kind == PassKind::engrave && request.depth == 0.0) return tr("Enter the depth of the lines.");
    return {};
}

/// Reads the drawings here and now: a drawing that can't be used is told where another can be chosen.
void PassDialog::confirm() {
    for (Figure& figure : figures_) { // what is typed and not entered yet counts
        const double before = figure.field->value();
        figure.field->interpretText();
        figure.edited = figure.edited || figure.field->value() != before;
    }
    WantedPass wanted;
    wanted.instead = wanted_.instead;
    PassRequest& request = wanted.request;
    request.kind = kind();
    for (const Figure& figure : figures_) {
        if (!contains(figure.kinds, request.kind)) continue;
        const double value = figure.field->value();
        if (figure.member != nullptr)
            request.*figure.member = value;
        else if (value != 0.0)
            request.*figure.height = value;
    }
    if (request.steepest >= rightAngle) request.steepest = anySlope;
    if (request.scallop > 0.0) request.stepOver = 0.0; // a step-over of its own would go before it
    for (const Switch& one : switches_)
        if (contains(one.kinds, request.kind)) request.*one.member = one.box->isChecked();
    request.areaOnPart = areaOnPart_->isVisibleTo(this) && areaOnPart_->isChecked();
    const double unit = fileUnits[std::max(0, fileUnit_->currentIndex())];
    if (const QString lacks = missing(wanted); !lacks.isEmpty()) return notice_->tell(Notice::Kind::error, lacks);
    const auto refuse = [this](const Error& error) { notice_->tell(Notice::Kind::error, Messages::sentence(error)); };
    if (areaRow_->isVisibleTo(this) && area_->currentData() == paintedArea) request.area = painted_;
    if (areaRow_->isVisibleTo(this) && area_->currentData() == areaBefore) request.area = wanted_.request.area;
    if (areaRow_->isVisibleTo(this) && area_->currentIndex() == areaDrawing) {
        const Result<PlanDrawing> drawing = readDrawing(areaFile_.toStdString(), unit);
        if (!drawing) return refuse(drawing.error());
        Result<PlanRegion> region = regionOf(*drawing, areaFile_.toStdString());
        if (!region) return refuse(region.error());
        request.area = std::move(*region);
    }
    if (linesRow_->isVisibleTo(this) && lines_->currentIndex() == 1) {
        const Result<PlanDrawing> drawing = readDrawing(linesFile_.toStdString(), unit);
        if (!drawing) return refuse(drawing.error());
        request.lines = linesOf(*drawing);
    } else if (linesRow_->isVisibleTo(this) && lines_->currentIndex() > 1 && lines_->currentData().isNull()) {
        request.lines = wanted_.request.lines;
    } else if (linesRow_->isVisibleTo(this) && lines_->currentIndex() > 1) {
        wanted.leads.push_back(lines_->currentData().toLongLong());
    }
    PassRequest checked = request;
    if (!wanted.leads.empty()) checked.lines = {{glm::dvec3(0.0), glm::dvec3(1.0, 0.0, 0.0)}}; // stand for the strokes
    if (const Result<void> valid = validate(checked); !valid) return refuse(valid.error());
    wanted_ = std::move(wanted);
    accept();
}

} // namespace burin
