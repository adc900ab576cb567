// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/part_panel.h"

#include "core/cad/body_path.h"
#include "core/cad/file_unit.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/field_row.h"
#include "ui/panels/file_units.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/model_labels.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/role_labels.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"
#include "ui/panels/value_row.h"
#include "ui/theme/colour.h"

#include <QFileInfo>

#include <utility>

namespace burin {

class PartPanel::Fields : public QObject {
public:
    explicit Fields(PartPanel* panel);
    void refresh();
    void chooseBody(std::size_t body);

    PartState state;
    LengthUnit unit = LengthUnit::millimetre;

private:
    void makeFileUnit(PartPanel* panel);
    void refreshFile(const std::string& file);
    void refreshModel();
    void refreshPreview();
    void refreshFileUnit();
    void makeRole(PartPanel* panel);
    void refreshRole();
    BodyRole roleOfBody(std::size_t body) const;
    std::vector<ListRow> bodyRows() const;
    std::vector<ListRow> previewRows() const;
    std::vector<ListRow> noteRows() const;

    QPushButton* import_;
    QLabel* empty_;
    QWidget* content_;
    ElidedLabel* file_;
    ChoiceBox* fileUnit_;
    FieldRow* fileUnitRow_;
    ChoiceBox* role_;
    FieldRow* roleRow_;
    ValueRow *format_, *size_, *statedSize_, *volume_;
    QLabel *bodiesTitle_, *notesTitle_;
    RowList *bodies_, *notes_;
};

PartPanel::Fields::Fields(PartPanel* panel) : QObject(panel) {
    QVBoxLayout* column = makePanelLayout(panel);
    column->addWidget(makeSectionTitle(PartPanel::tr("Part"), panel));
    import_ = makePrimaryButton(PartPanel::tr("Import a part…"), QStringLiteral("importButton"), panel);
    connect(import_, &QPushButton::clicked, panel, &PartPanel::importRequested);
    column->addWidget(import_);
    empty_ = makeWrappedLabel(panel);
    empty_->setProperty("look", "quiet");
    column->addWidget(empty_);

    content_ = new QWidget(panel);
    auto* inner = new QVBoxLayout(content_);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(column->spacing());
    file_ = new ElidedLabel({}, content_);
    file_->setObjectName(QStringLiteral("partFile"));
    file_->setElideMode(Qt::ElideMiddle);
    file_->setProperty("look", "title");
    inner->addWidget(file_);
    for (auto [row, text] : {std::pair{&format_, PartPanel::tr("Format")},
                             {&size_, PartPanel::tr("Size")},
                             {&statedSize_, PartPanel::tr("Size as stated")},
                             {&volume_, PartPanel::tr("Volume")}}) {
        *row = new ValueRow(text, content_);
        inner->addWidget(*row);
    }
    makeFileUnit(panel);
    inner->addWidget(fileUnitRow_);
    bodiesTitle_ = makeSectionTitle(PartPanel::tr("Bodies"), content_);
    bodies_ = new RowList(content_);
    bodies_->setObjectName(QStringLiteral("bodyList"));
    bodies_->setAccessibleName(PartPanel::tr("Bodies"));
    makeRole(panel);
    notesTitle_ = makeSectionTitle(PartPanel::tr("Import notes"), content_);
    notes_ = new RowList(content_);
    notes_->setTextsWrap(true);
    notes_->setObjectName(QStringLiteral("noteList"));
    notes_->setAccessibleName(PartPanel::tr("Import notes"));
    for (QWidget* widget :
         {static_cast<QWidget*>(bodiesTitle_), static_cast<QWidget*>(bodies_), static_cast<QWidget*>(roleRow_),
          static_cast<QWidget*>(notesTitle_), static_cast<QWidget*>(notes_)})
        inner->addWidget(widget);
    column->addWidget(content_);
    column->addStretch(1);
}

void PartPanel::Fields::makeFileUnit(PartPanel* panel) {
    fileUnit_ = new ChoiceBox(content_);
    fileUnit_->setObjectName(QStringLiteral("fileUnit"));
    fileUnitRow_ =
        new FieldRow(PartPanel::tr("Unit of the file"), fileUnit_, QString(), content_, FieldRow::choiceWidth);
    connect(fileUnit_, &QComboBox::activated, panel, [this, panel](int index) {
        const double millimetres = fileUnit_->itemData(index).toDouble();
        if (!state.model || isSameUnit(millimetres, state.model->unitScale)) return;
        emit panel->fileUnitChosen(millimetres);
        refresh(); // shows the old unit until the file has been read again, if it is
    });
}

void PartPanel::Fields::makeRole(PartPanel* panel) {
    role_ = new ChoiceBox(content_);
    role_->setObjectName(QStringLiteral("bodyRole"));
    for (const BodyRole role : bodyRoles) role_->addItem(roleText(role));
    roleRow_ =
        new FieldRow(PartPanel::tr("Role of the selected body"), role_, roleToolTip(), content_, FieldRow::choiceWidth);
    connect(bodies_, &RowList::rowChosen, panel, [this] { refreshRole(); });
    connect(role_, &QComboBox::activated, panel, [this, panel](int index) {
        if (bodies_->currentRow() < 0) return;
        const auto body = static_cast<std::size_t>(bodies_->currentRow());
        if (state.roles.size() <= body) state.roles.resize(body + 1, BodyRole::part);
        state.roles[body] = bodyRoles[static_cast<std::size_t>(index)];
        emit panel->roleChosen(body, state.roles[body]);
    });
}

void PartPanel::Fields::chooseBody(std::size_t body) {
    if (!state.model || body >= state.model->bodies.size()) return;
    bodies_->setChosen(static_cast<int>(body));
    refreshRole();
    role_->setFocus();
}

BodyRole PartPanel::Fields::roleOfBody(std::size_t body) const {
    return body < state.roles.size() ? state.roles[body] : BodyRole::part;
}

void PartPanel::Fields::refreshRole() {
    if (bodies_->currentRow() < 0 && !bodies_->rows().empty()) bodies_->setChosen(0);
    const int body = bodies_->currentRow();
    const bool shown = state.model && !state.preview && body >= 0;
    roleRow_->setVisible(shown);
    if (!shown) return;
    role_->setCurrentIndex(static_cast<int>(roleOfBody(static_cast<std::size_t>(body))));
    setEnabledKeepingFocus(role_, !state.busy && !state.locked);
}

void PartPanel::Fields::refreshFileUnit() {
    const Model& model = *state.model;
    fileUnitRow_->show();
    setEnabledKeepingFocus(fileUnit_, !state.busy);
    offerFileUnits(*fileUnit_, model, unit);
    fileUnit_->setToolTip(
        statesUnit(model)
            ? PartPanel::tr(
                  "Choosing another unit than the stated one reads the file again: the part gets another size.")
            : PartPanel::tr("The file states no unit. Choosing another one reads it again."));
    const bool replaced = unitReplaced(model);
    statedSize_->setVisible(replaced);
    if (replaced) statedSize_->setValue(sizeText(sizeInUnit(model, model.statedUnit), unit));
}

void PartPanel::Fields::refresh() {
    const bool shown = state.model && !state.preview;
    import_->setText(state.model ? PartPanel::tr("Import another part…") : PartPanel::tr("Import a part…"));
    setLook(import_, state.model ? "" : "primary");
    enableUnless(import_, state.busy ? PartPanel::tr("A part is being read.") : QString(),
                 PartPanel::tr("Read a CAD file (STEP, IGES, BREP) or a mesh (STL, 3MF, OBJ, PLY, AMF, OFF)"));
    setWrappedText(empty_, state.preview ? PartPanel::tr("This is a preview. The fine mesh, which is milled to, is "
                                                         "being made…")
                           : state.busy  ? PartPanel::tr("The part is being read…")
                           : shown       ? QString()
                                   : PartPanel::tr("The CAD solid that is to be made. STEP keeps the exact surfaces, "
                                                   "a mesh (STL, 3MF, OBJ) has only triangles."));
    empty_->setVisible(state.busy || !shown);
    content_->setVisible(shown || state.preview);
    for (QWidget* row : {format_, size_, statedSize_, volume_}) row->setVisible(shown);
    if (shown) refreshModel();
    if (state.preview) refreshPreview();
}

void PartPanel::Fields::refreshFile(const std::string& name) {
    const QString file = QString::fromStdString(name);
    file_->setText(QFileInfo(file).fileName());
    file_->setToolTip(file);
}

/// Shows no values: there are none yet.
void PartPanel::Fields::refreshPreview() {
    refreshFile(state.preview->sourceFile);
    bodies_->setRows(previewRows());
    for (QWidget* row : {static_cast<QWidget*>(fileUnitRow_), static_cast<QWidget*>(roleRow_),
                         static_cast<QWidget*>(notesTitle_), static_cast<QWidget*>(notes_)})
        row->hide();
}

void PartPanel::Fields::refreshModel() {
    const Model& model = *state.model;
    refreshFile(model.sourceFile);
    const QString scale = QString::fromStdString(model.lengthUnit);
    format_->setValue(QString::fromStdString(model.format) +
                      (scale.isEmpty() || scale == QLatin1String("none") ? QString() : QStringLiteral(", ") + scale));
    const Box box = model.box();
    size_->setValue(box.empty() ? QString() : sizeText(box.size(), unit));
    volume_->setValue(volumeText(model.volume(), unit));
    refreshFileUnit();
    bodies_->setRows(bodyRows());
    refreshRole();
    notes_->setRows(noteRows());
    notesTitle_->setVisible(!model.notes.empty());
    notes_->setVisible(!model.notes.empty());
}

std::vector<ListRow> PartPanel::Fields::bodyRows() const {
    std::vector<ListRow> rows;
    for (const Body& body : state.model->bodies) {
        ListRow row;
        row.title = bodyName(std::string(lastElement(body.name)));
        row.toolTip = bodyName(body.name);
        row.value = volumeText(body.volume, unit);
        if (const BodyRole role = roleOfBody(rows.size()); role != BodyRole::part) row.badge = roleText(role);
        QStringList details;
        if (const std::string_view assembly = assemblyOf(body.name); !assembly.empty())
            details.append(bodyName(std::string(assembly)));
        if (!body.box.empty()) details.append(sizeText(body.box.size(), unit));
        if (body.openEdges > 0)
            details.prepend(body.openEdges == 1
                                ? PartPanel::tr("1 open edge")
                                : PartPanel::tr("%n open edges", nullptr, static_cast<int>(body.openEdges)));
        if (body.faceCount > 0)
            details.append(body.faceCount == 1 ? PartPanel::tr("1 face")
                                               : PartPanel::tr("%n faces", nullptr, static_cast<int>(body.faceCount)));
        row.detail = details.join(QStringLiteral(" · "));
        if (body.openEdges > 0) {
            row.icon = QStringLiteral("warning");
            row.iconRole = &Palette::accent;
        } else {
            row.swatch = colourFrom(rows.size() < state.colours.size() ? state.colours[rows.size()] : body.colour);
        }
        rows.push_back(row);
    }
    return rows;
}

std::vector<ListRow> PartPanel::Fields::previewRows() const {
    std::vector<ListRow> rows;
    for (const PreviewBody& body : state.preview->bodies) {
        ListRow row;
        row.title = bodyName(std::string(lastElement(body.name)));
        row.toolTip = bodyName(body.name);
        row.swatch = colourFrom(body.colour);
        rows.push_back(row);
    }
    return rows;
}

std::vector<ListRow> PartPanel::Fields::noteRows() const {
    std::vector<ListRow> rows;
    for (const ImportNote& note : state.model->notes) {
        ListRow row;
        row.detail = row.toolTip = importNoteText(note.text);
        switch (note.kind) {
        case ImportNote::Kind::unit:
            row.title = PartPanel::tr("Unit");
            row.icon = QStringLiteral("information");
            row.iconRole = &Palette::part;
            break;
        case ImportNote::Kind::healing:
            row.title = PartPanel::tr("Healed");
            row.icon = QStringLiteral("passed");
            row.iconRole = &Palette::inOrder;
            break;
        case ImportNote::Kind::warning:
            row.title = PartPanel::tr("Doubtful");
            row.icon = QStringLiteral("warning");
            row.iconRole = &Palette::accent;
            break;
        case ImportNote::Kind::leftOut:
            row.title = PartPanel::tr("Not imported");
            row.icon = QStringLiteral("information");
            row.iconRole = &Palette::part;
            break;
        }
        rows.push_back(row);
    }
    return rows;
}

PartPanel::PartPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("partPanel"));
    fields_->refresh();
}

void PartPanel::setUnit(LengthUnit unit) {
    fields_->unit = unit;
    fields_->refresh();
}

void PartPanel::chooseBody(std::size_t body) {
    fields_->chooseBody(body);
}

void PartPanel::setState(const PartState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin
