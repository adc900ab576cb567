// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/material_panel.h"

#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/model_labels.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"

#include <QSignalBlocker>

#include <algorithm>

namespace burin {

class MaterialPanel::Fields : public QObject {
public:
    explicit Fields(MaterialPanel* panel);
    void refresh();

    MaterialState state;

private:
    ChoiceBox* addChoice(const QString& label, const QString& toolTip, const char* name);
    void refreshChoices();
    void refreshValues();
    void showSource(int row);
    std::string bodyMaterial() const; ///< id of the shown body's material; that of the stock if the body has none
    const Property* material(const std::string& id) const;

    MaterialPanel* panel_;
    QVBoxLayout* column_;
    ChoiceBox *stock_, *body_, *bodyMaterial_;
    QWidget* bodies_;
    QLabel *figuresTitle_, *source_;
    RowList* values_;
    Notice *estimate_, *locked_;
    bool showsBody_ = false; ///< whether the values shown are those of the body's material
};

namespace {

QString numberText(double value) {
    return QLocale().toString(value, 'g', QLocale::FloatingPointShortest);
}

} // namespace

MaterialPanel::Fields::Fields(MaterialPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(MaterialPanel::tr("Material"), panel));
    stock_ = addChoice(MaterialPanel::tr("Stock"), MaterialPanel::tr("Material of the stock"), "stockMaterial");
    body_ = addChoice(MaterialPanel::tr("Body"), MaterialPanel::tr("Body whose material is shown below"), "body");
    bodyMaterial_ =
        addChoice(MaterialPanel::tr("Its material"), MaterialPanel::tr("Material of this body"), "bodyMaterial");
    auto* notices = new NoticePlace(panel);
    locked_ = notices->add("materialNotice");
    column_->addWidget(notices);
    figuresTitle_ = makeSectionTitle({}, panel);
    column_->addWidget(figuresTitle_);
    values_ = new RowList(panel);
    values_->setObjectName(QStringLiteral("materialValues"));
    values_->setAccessibleName(MaterialPanel::tr("Values of the material"));
    values_->setMaximumRows(8);
    column_->addWidget(values_);
    estimate_ = new Notice(panel);
    estimate_->setObjectName(QStringLiteral("estimateNotice"));
    column_->addWidget(estimate_);
    column_->addWidget(makeSectionTitle(MaterialPanel::tr("Source of the selected value"), panel));
    source_ = makeWrappedLabel(panel);
    source_->setObjectName(QStringLiteral("valueSource"));
    source_->setProperty("look", "quiet");
    source_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column_->addWidget(source_);
    column_->addStretch(1);

    connect(stock_, &ChoiceBox::activated, this, [this] {
        showsBody_ = false;
        state.stockMaterial = stock_->currentData().toString().toStdString();
        refresh();
        emit panel_->stockMaterialChosen(state.stockMaterial);
    });
    connect(body_, &ChoiceBox::activated, this, [this] {
        showsBody_ = true;
        refresh();
    });
    connect(bodyMaterial_, &ChoiceBox::activated, this, [this] {
        showsBody_ = true;
        const auto index = static_cast<std::size_t>(std::max(0, body_->currentIndex()));
        const std::string id = bodyMaterial_->currentData().toString().toStdString();
        if (state.bodyMaterials.size() <= index) state.bodyMaterials.resize(index + 1);
        state.bodyMaterials[index] = id;
        refresh();
        emit panel_->bodyMaterialChosen(index, id);
    });
    connect(values_, &RowList::rowChosen, this, &Fields::showSource);
}

ChoiceBox* MaterialPanel::Fields::addChoice(const QString& label, const QString& toolTip, const char* name) {
    auto* choice = new ChoiceBox(panel_);
    choice->setObjectName(QLatin1String(name));
    column_->addWidget(new FieldRow(label, choice, toolTip, panel_, FieldRow::choiceWidth));
    return choice;
}

const Property* MaterialPanel::Fields::material(const std::string& id) const {
    const auto found = std::ranges::find(state.materials, id, &Property::id);
    return found == state.materials.end() ? nullptr : &*found;
}

std::string MaterialPanel::Fields::bodyMaterial() const {
    const auto index = static_cast<std::size_t>(std::max(0, body_->currentIndex()));
    return index < state.bodyMaterials.size() ? state.bodyMaterials[index] : std::string();
}

void MaterialPanel::Fields::refreshChoices() {
    QStringList names, ids, bodies, places;
    for (const Property& entry : state.materials) {
        names.append(materialName(entry));
        ids.append(QString::fromStdString(entry.id));
    }
    for (std::size_t i = 0; i < state.bodyNames.size(); ++i) {
        bodies.append(bodyName(state.bodyNames[i]));
        places.append(QString::number(i));
    }
    stock_->offer(names, ids, QString::fromStdString(state.stockMaterial));
    const int shown = std::clamp(body_->currentIndex(), 0, std::max(0, static_cast<int>(bodies.size()) - 1));
    body_->offer(bodies, places, QString::number(shown));
    bodyMaterial_->offer(QStringList(MaterialPanel::tr("Same as the stock")) + names, QStringList(QString()) + ids,
                         QString::fromStdString(bodyMaterial()));
    setEnabledKeepingFocus(stock_, !state.locked);
    setEnabledKeepingFocus(bodyMaterial_, !state.locked && !bodies.isEmpty());
    setEnabledKeepingFocus(body_, !bodies.isEmpty());
    locked_->tell(Notice::Kind::information,
                  state.locked
                      ? MaterialPanel::tr("Stock and material can't be changed once there are takes.")
                      : MaterialPanel::tr("The material can be changed until the first take; the workpiece is kept."));
}

void MaterialPanel::Fields::refreshValues() {
    const std::string ofBody = bodyMaterial();
    const Property* shown = material(showsBody_ && !ofBody.empty() ? ofBody : state.stockMaterial);
    figuresTitle_->setText(shown != nullptr ? MaterialPanel::tr("Values of %1").arg(materialName(*shown)).toUpper()
                                            : MaterialPanel::tr("Values").toUpper());
    std::vector<ListRow> rows;
    int estimates = 0;
    if (shown != nullptr) {
        for (const auto& [name, figure] : shown->values) {
            ListRow row;
            row.title = valueNameText(name);
            row.value = numberText(figure.value);
            if (const QString unit = prettyUnit(figure.unit); !unit.isEmpty()) row.value += QChar(QChar::Nbsp) + unit;
            row.badge = figure.estimate ? MaterialPanel::tr("estimate") : QString();
            row.detail = row.toolTip = QString::fromStdString(figure.source);
            estimates += figure.estimate ? 1 : 0;
            rows.push_back(row);
        }
    }
    values_->setRows(rows);
    if (values_->currentRow() < 0 && !rows.empty()) values_->setChosen(0);
    estimate_->tell(
        Notice::Kind::warning,
        estimates == 0 ? QString()
        : estimates == 1
            ? MaterialPanel::tr("1 value is an estimate: calibrate it before you rely on results that depend on it.")
            : MaterialPanel::tr(
                  "%n values are estimates: calibrate them before you rely on results that depend on them.", nullptr,
                  estimates));
    showSource(values_->currentRow());
}

void MaterialPanel::Fields::showSource(int row) {
    const std::vector<ListRow>& rows = values_->rows();
    const bool there = row >= 0 && static_cast<std::size_t>(row) < rows.size();
    setWrappedText(source_, there ? rows[static_cast<std::size_t>(row)].toolTip : QStringLiteral("–"));
}

void MaterialPanel::Fields::refresh() {
    refreshChoices();
    refreshValues();
}

MaterialPanel::MaterialPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("materialPanel"));
    fields_->refresh();
}

// The values are shown in the unit that their source states; none is a length.
void MaterialPanel::setUnit(LengthUnit) {}

void MaterialPanel::setState(const MaterialState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin
