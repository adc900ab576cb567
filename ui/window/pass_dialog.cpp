// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/pass_dialog.h"

#include "ui/dialogs/file_dialogs.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/notice.h"
#include "ui/window/hole_labels.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QScreen>
#include <QShortcut>

#include <algorithm>

namespace burin {

namespace {

constexpr int passDialogWidth = 460;           // pixels
constexpr int mostHoleRows = 5;                // shown at once
constexpr int previewDelay = 120;              // ms: while a value is typed
constexpr int areaDrawing = 1;                 // its index in the list "passArea"
constexpr int paintedArea = 1, areaBefore = 2; // data of the list's further choices

/// mm per unit of the entries of the list "passUnit", in order.
constexpr double fileUnits[] = {0.0, 1.0, 10.0, 25.4};

} // namespace

PassDialog::PassDialog(const Offer& offer, QWidget* parent)
    : QDialog(parent)
    , folder_(offer.folder)
    , painted_(offer.painted)
    , takes_(offer.takes)
    , holes_(offer.holes)
    , picked_(offer.last.request.places)
    , external_(offer.last.request.external)
    , unit_(offer.unit)
    , wanted_(offer.last) {
    setObjectName(QStringLiteral("passDialog"));
    setWindowTitle(offer.last.instead ? tr("Change a pass") : tr("Compute a pass"));
    layOut(offer);
    setFixedWidth(passDialogWidth);
    update();
    form_->setFocus();
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
    form_ = new PassForm(offer.last.request, offer.defaults, offer.unit, offer.kinds, this);
    column->addWidget(form_);
    addHoles();
    addDrawings(offer);
    preview_ = new QLabel(this);
    preview_->setObjectName(QStringLiteral("passPreview"));
    preview_->setWordWrap(true);
    preview_->setMinimumHeight(2 * preview_->fontMetrics().lineSpacing()); // avoids changes of the dialog's layout
    preview_->setAlignment(Qt::AlignTop);
    column->addWidget(preview_);
    auto* notices = new NoticePlace(this);
    notice_ = notices->add("passNotice");
    column->addWidget(notices);
    auto* compute = makePrimaryButton(tr("Compute"), QStringLiteral("computePassButton"), this);
    compute->setToolTip(tr("Compute the pass in the background; it can be cancelled in the status line"));
    compute->setDefault(true);
    auto* cancel = makeButton(tr("Cancel"), QStringLiteral("cancel"), QStringLiteral("cancelPassButton"), this);
    cancel->setToolTip(tr("Change nothing"));
    showMe_ = makeButton(tr("Show me"), QStringLiteral("play"), QStringLiteral("passShowMeButton"), this);
    showMe_->setToolTip(
        tr("Plays in the view how this pass is made: the stroke that leads it, the directions, then its "
           "rows one after the other. Changes nothing; Esc stops it"));
    auto* row = new QHBoxLayout;
    row->addWidget(showMe_);
    row->addStretch(1);
    row->addWidget(compute);
    row->addWidget(cancel);
    column->addLayout(row);
    connect(form_, &PassForm::kindChanged, this, &PassDialog::update);
    connect(form_, &PassForm::changed, this, [this] {
        fit();
        previewSoon();
    });
    previewTimer_.setSingleShot(true);
    previewTimer_.setInterval(previewDelay);
    connect(&previewTimer_, &QTimer::timeout, this, &PassDialog::askPreview);
    connect(areaOnPart_, &QCheckBox::toggled, this, &PassDialog::previewSoon);
    connect(fileUnit_, &QComboBox::activated, this, &PassDialog::previewSoon);
    connect(compute, &QPushButton::clicked, this, &PassDialog::confirm);
    connect(showMe_, &QPushButton::clicked, this, &PassDialog::toggleShow);
    connect(cancel, &QPushButton::clicked, this, [this] { done(Rejected); });
}

void PassDialog::toggleShow() {
    if (showing_) return emit showStopped();
    form_->commitTyping();
    const Result<RequestedPass> wanted = wantedNow();
    if (!wanted) return notice_->tell(Notice::Kind::error, Messages::sentence(wanted.error()));
    previewTimer_.stop(); // it would replace what is shown
    emit showMeRequested(*wanted);
}

void PassDialog::setShowing(bool showing) {
    if (showing == showing_) return;
    showing_ = showing;
    showMe_->setText(showing ? tr("Stop showing") : tr("Show me"));
    if (!showing) previewSoon(); // a sample may have been shown
}

void PassDialog::reject() {
    if (showing_)
        emit showStopped();
    else
        QDialog::reject();
}

/// The part's holes, those that were picked, and the buttons to pick them and to use all of them.
void PassDialog::addHoles() {
    holesBox_ = new QWidget(this);
    auto* column = new QVBoxLayout(holesBox_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    holesLabel_ = new QLabel(holesBox_);
    holesLabel_->setObjectName(QStringLiteral("passHoles"));
    holesLabel_->setWordWrap(true);
    column->addWidget(holesLabel_);
    holeList_ = new QListWidget(holesBox_);
    holeList_->setObjectName(QStringLiteral("passPickedHoles"));
    holeList_->setAccessibleName(tr("Picked holes or studs"));
    holeList_->setToolTip(tr("The holes or studs of this pass, in the coordinates of the setup; Del removes one"));
    column->addWidget(holeList_);
    auto* removal = new QShortcut(QKeySequence(Qt::Key_Delete), holeList_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(removal, &QShortcut::activated, this, &PassDialog::removeChosenHole);
    auto* pick = makeButton(tr("Pick holes…"), {}, QStringLiteral("pickHolesButton"), holesBox_);
    enableUnless(
        pick, holes_.empty() ? tr("The part has no round upright holes.") : QString(),
        tr("Click holes of the part in the view, or studs for an external thread; a second click removes one"));
    allHoles_ = makeButton(tr("All that fit"), {}, QStringLiteral("allHolesButton"), holesBox_);
    allHoles_->setToolTip(tr("Clear the selection: the pass uses every hole or stud of the part that fits"));
    auto* row = new QHBoxLayout;
    row->addWidget(pick);
    row->addWidget(allHoles_);
    row->addStretch(1);
    column->addLayout(row);
    layout()->addWidget(holesBox_);
    connect(pick, &QPushButton::clicked, this, &PassDialog::goPicking);
    connect(allHoles_, &QPushButton::clicked, this, [this] {
        picked_.clear();
        showHoles();
        update();
    });
    showHoles();
}

void PassDialog::showHoles() {
    const std::vector<UprightHole> offered = sideOf(holes_, external_);
    const QString sizes = holeSizesText(offered, unit_);
    const QString none =
        external_ ? tr("The part has no round upright studs.") : tr("The part has no round upright holes.");
    const QString some = external_ ? tr("Upright studs of the part: %1") : tr("Upright holes of the part: %1");
    holesLabel_->setText(sizes.isEmpty() ? none : some.arg(sizes));
    holeList_->clear();
    for (const glm::dvec2& place : picked_) holeList_->addItem(pickedText(place, offered, unit_));
    holeList_->setVisible(!picked_.empty());
    allHoles_->setVisible(!picked_.empty());
    const int rows = std::min(mostHoleRows, holeList_->count());
    if (rows > 0) holeList_->setFixedHeight(rows * holeList_->sizeHintForRow(0) + 2 * holeList_->frameWidth());
}

void PassDialog::removeChosenHole() {
    const int row = holeList_->currentRow();
    if (row < 0) return;
    picked_.erase(picked_.begin() + row);
    showHoles();
    holeList_->setCurrentRow(std::min(row, holeList_->count() - 1));
    update();
}

/// Closes the dialog; it is shown again with its values when the holes are picked.
void PassDialog::goPicking() {
    form_->commitTyping();
    Result<RequestedPass> wanted = wantedNow();
    if (!wanted) return notice_->tell(Notice::Kind::error, Messages::sentence(wanted.error()));
    wanted_ = std::move(*wanted);
    done(pickHoles);
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
    // A pass that one take leads follows the strokes that this take has now.
    if (const auto& leads = wanted_.request.leads;
        leads.size() == 1 && leads.front().lines == static_cast<int>(wanted_.request.lines.size()))
        if (const int take = lines_->findData(static_cast<qlonglong>(leads.front().take)); take > 0)
            lines_->setCurrentIndex(take);
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
        read_.drawing.reset(); // the file may have changed
        file = chosen;
        folder_ = QFileInfo(chosen).absolutePath();
        box->setItemText(1, QFileInfo(chosen).fileName());
    }
    if (file.isEmpty()) box->setCurrentIndex(0);
}

void PassDialog::update() {
    const PassKind chosen = form_->kind();
    if (form_->external() != external_) {
        external_ = !external_;
        picked_.clear(); // they are of the other side
        showHoles();
    }
    areaRow_->setVisible(chosen != PassKind::engrave && !(isInHoles(chosen) && !picked_.empty()));
    holesBox_->setVisible(isInHoles(chosen));
    areaOnPart_->setVisible(laidOnPart(chosen) && area_->currentIndex() != 0);
    linesRow_->setVisible(chosen == PassKind::engrave || (chosen == PassKind::flow && !form_->extendsStrokes()) ||
                          chosen == PassKind::pencil);
    fileUnitRow_->setVisible(area_->currentIndex() == areaDrawing ||
                             (linesRow_->isVisibleTo(this) && lines_->currentIndex() == 1));
    notice_->clear();
    fit();
    previewSoon();
}

/// As high as its fields need: adjustSize would squeeze them into two thirds of the screen.
void PassDialog::fit() {
    layout()->activate();
    const int needed = layout()->totalHeightForWidth(passDialogWidth);
    resize(passDialogWidth, std::min(needed, screen()->availableGeometry().height()));
}

void PassDialog::showPreview(const QString& text) {
    preview_->setText(text);
}

/// Text being typed is not used yet.
void PassDialog::askPreview() {
    if (const Result<RequestedPass> wanted = wantedNow(); wanted && missing(*wanted).isEmpty())
        emit previewRequested(*wanted);
    else
        emit previewUnwanted();
}

Result<PlanDrawing> PassDialog::drawingOf(const QString& file) {
    const double unit = fileUnits[std::max(0, fileUnit_->currentIndex())];
    if (read_.drawing && read_.file == file && read_.unit == unit) return *read_.drawing;
    Result<PlanDrawing> drawing = readDrawing(file.toStdString(), unit);
    if (drawing) read_ = {file, unit, *drawing};
    return drawing;
}

/// Explains what the kind of pass lacks.
QString PassDialog::missing(const RequestedPass& wanted) const {
    const PassRequest& request = wanted.request;
    if (area_->currentIndex() == 0 && request.kind == PassKind::pocket)
        return tr("Paint the area of the pocket, or choose a drawing with its outline.");
    if (area_->currentIndex() == 0 && request.kind == PassKind::profile && request.inside)
        return tr("Paint an area, or choose a drawing with the outline to follow.");
    if (lines_->currentIndex() == 0 && request.kind == PassKind::engrave)
        return tr("Choose the strokes or the drawing to engrave.");
    if (lines_->currentIndex() == 0 && request.kind == PassKind::flow && request.hand != HandStrokes::extend)
        return tr("Choose the strokes or the drawing that the rows follow.");
    if (request.kind == PassKind::engrave && request.depth == 0.0) return tr("Enter the depth of the lines.");
    if (request.kind == PassKind::thread && request.pitch == 0.0) return tr("Choose a thread, or enter its pitch.");
    if (request.kind == PassKind::thread && request.majorDiameter == 0.0 && request.places.empty())
        return tr("Enter the diameter of the thread, or pick its holes or studs.");
    return {};
}

Result<RequestedPass> PassDialog::wantedNow() {
    RequestedPass wanted;
    wanted.instead = wanted_.instead;
    PassRequest& request = wanted.request;
    form_->writeTo(request);
    if (isInHoles(request.kind)) request.places = picked_;
    request.areaOnPart = areaOnPart_->isVisibleTo(this) && areaOnPart_->isChecked();
    if (areaRow_->isVisibleTo(this) && area_->currentData() == paintedArea) request.area = painted_;
    if (areaRow_->isVisibleTo(this) && area_->currentData() == areaBefore) request.area = wanted_.request.area;
    if (areaRow_->isVisibleTo(this) && area_->currentIndex() == areaDrawing) {
        const Result<PlanDrawing> drawing = drawingOf(areaFile_);
        if (!drawing) return drawing.error();
        Result<PlanRegion> region = regionOf(*drawing, areaFile_.toStdString());
        if (!region) return std::move(region).error();
        request.area = std::move(*region);
    }
    if (linesRow_->isVisibleTo(this) && lines_->currentIndex() == 1) {
        const Result<PlanDrawing> drawing = drawingOf(linesFile_);
        if (!drawing) return drawing.error();
        request.lines = linesOf(*drawing);
    } else if (linesRow_->isVisibleTo(this) && lines_->currentIndex() > 1 && lines_->currentData().isNull()) {
        request.lines = wanted_.request.lines;
        request.leads = wanted_.request.leads;
    } else if (linesRow_->isVisibleTo(this) && lines_->currentIndex() > 1) {
        wanted.leads.push_back(lines_->currentData().toLongLong());
    }
    return wanted;
}

/// Reads the drawings here: an error is reported where another drawing can be chosen.
void PassDialog::confirm() {
    form_->commitTyping();
    const auto refuse = [this](const Error& error) { notice_->tell(Notice::Kind::error, Messages::sentence(error)); };
    Result<RequestedPass> wanted = wantedNow();
    if (!wanted) return refuse(wanted.error());
    if (const QString lacks = missing(*wanted); !lacks.isEmpty()) return notice_->tell(Notice::Kind::error, lacks);
    PassRequest checked = wanted->request;
    // The line stands in for the strokes.
    if (!wanted->leads.empty()) checked.lines = {{glm::dvec3(0.0), glm::dvec3(1.0, 0.0, 0.0)}};
    if (const Result<void> valid = validate(checked); !valid) return refuse(valid.error());
    wanted_ = std::move(*wanted);
    accept();
}

} // namespace burin
