// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/material_form.h"

#include "core/base/numbers.h"
#include "core/cutting/cutting_force.h"
#include "ui/panels/buttons.h"
#include "ui/panels/field_row.h"
#include "ui/panels/texts.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableWidget>
#include <QVBoxLayout>

#include <array>

namespace burin {

namespace {

constexpr auto editing =
    QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed;

enum Cell : int { keyCell, valueCell, unitCell, sourceCell, estimateCell, cellCount };

/// The purpose of the values that Burin reads.
QString purposeOf(std::string_view key) {
    if (key == specificCuttingEnergy)
        return MaterialForm::tr("K: energy to cut a volume; the cutting force comes from it");
    if (key == radialForceRatio) return MaterialForm::tr("Kr: force along the tool axis over that against the feed");
    if (key == kienzleForce) return MaterialForm::tr("kc1.1 of Kienzle's law; stands for K together with mc");
    if (key == kienzleExponent) return MaterialForm::tr("mc of Kienzle's law");
    if (key == density) return MaterialForm::tr("Density; masses come from it");
    if (key == surfaceSpeed) return MaterialForm::tr("Cutting speed with carbide; the spindle speed comes from it");
    if (key == chipLoadPerDiameter)
        return MaterialForm::tr("Chip load per tooth, as a share of the diameter; the feed follows from it");
    if (key == plungeFeedRatio) return MaterialForm::tr("Plunge feed over feed");
    for (const std::string_view each : valuesByCutter)
        if (key.starts_with(std::string(each) + '_'))
            return MaterialForm::tr("%1; used instead of the value for all cutters")
                .arg(valueNameText(std::string(key)));
    return MaterialForm::tr("A property of your own, kept with the material");
}

} // namespace

MaterialForm::MaterialForm(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    name_ = new QLineEdit(this);
    name_->setObjectName(QStringLiteral("materialName"));
    column->addWidget(
        new FieldRow(tr("Name"), name_, tr("Name in the list of materials"), this, FieldRow::choiceWidth));
    colour_ = new QPushButton(this);
    colour_->setObjectName(QStringLiteral("materialColour"));
    column->addWidget(new FieldRow(tr("Colour"), colour_, tr("In which it is drawn"), this));
    table_ = new QTableWidget(0, cellCount, this);
    table_->setObjectName(QStringLiteral("materialValues"));
    table_->setAccessibleName(tr("Values of the material"));
    table_->setHorizontalHeaderLabels({tr("Property"), tr("Value"), tr("Unit"), tr("Source"), tr("Estimate")});
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(sourceCell, QHeaderView::Stretch);
    table_->setTabKeyNavigation(false); // Tab moves to the buttons
    column->addWidget(table_, 1);
    auto* row = new QHBoxLayout;
    add_ = makeButton(tr("Add a value"), QStringLiteral("add"), QStringLiteral("addValueButton"), this);
    add_->setToolTip(tr("Add a property of your own"));
    remove_ = makeButton(tr("Remove the value"), QStringLiteral("remove"), QStringLiteral("removeValueButton"), this);
    row->addWidget(add_);
    row->addWidget(remove_);
    row->addStretch(1);
    column->addLayout(row);
    connect(name_, &QLineEdit::textEdited, this, &MaterialForm::take);
    connect(colour_, &QPushButton::clicked, this, &MaterialForm::chooseColour);
    connect(table_, &QTableWidget::itemChanged, this, [this] { take(); });
    connect(table_, &QTableWidget::itemSelectionChanged, this,
            [this] { remove_->setEnabled(!locked_ && table_->currentRow() >= 0); });
    connect(add_, &QPushButton::clicked, this, &MaterialForm::addValue);
    connect(remove_, &QPushButton::clicked, this, &MaterialForm::removeValue);
}

void MaterialForm::showMaterial(const Property& material, bool locked) {
    material_ = material;
    locked_ = locked;
    showing_ = true;
    name_->setText(QString::fromStdString(material.name));
    name_->setReadOnly(locked);
    for (QPushButton* button : {colour_, add_}) button->setEnabled(!locked);
    remove_->setEnabled(false);
    showColour();
    showRows();
    showing_ = false;
}

void MaterialForm::showRows() {
    table_->setRowCount(0);
    for (const auto& [key, value] : material_.values) addRow(key, value);
    table_->setEditTriggers(locked_ ? QAbstractItemView::NoEditTriggers : QAbstractItemView::EditTriggers(editing));
}

void MaterialForm::addRow(const std::string& key, const NamedValue& value) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    const std::array<QString, estimateCell> texts{
        QString::fromStdString(key), QString::fromStdString(formatShortest(value.value)),
        QString::fromStdString(value.unit), QString::fromStdString(value.source)};
    for (int column = 0; column < estimateCell; ++column) {
        auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
        item->setToolTip(column == sourceCell ? item->text() : purposeOf(key));
        if (column == valueCell) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        table_->setItem(row, column, item);
    }
    auto* estimate = new QTableWidgetItem;
    estimate->setFlags(locked_ ? Qt::ItemIsEnabled | Qt::ItemIsSelectable
                               : Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    estimate->setCheckState(value.estimate ? Qt::Checked : Qt::Unchecked);
    estimate->setToolTip(tr("Nobody published this number: calibrate before you trust what depends on it"));
    table_->setItem(row, estimateCell, estimate);
}

/// Reads the values from the cells.
void MaterialForm::take() {
    if (showing_) return;
    material_.name = name_->text().trimmed().toStdString();
    material_.values.clear();
    for (int row = 0; row < table_->rowCount(); ++row) {
        const auto text = [&](int column) { return table_->item(row, column)->text().trimmed().toStdString(); };
        const std::optional<double> number = parseNumber(text(valueCell));
        if (!number || text(keyCell).empty()) continue; // reported by `problem`
        material_.values[text(keyCell)] = {*number, text(unitCell), text(sourceCell),
                                           table_->item(row, estimateCell)->checkState() == Qt::Checked};
    }
    emit edited();
}

QString MaterialForm::problem() const {
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QString key = table_->item(row, keyCell)->text().trimmed();
        const QString value = table_->item(row, valueCell)->text().trimmed();
        if (key.isEmpty()) return tr("A value has no name; enter one, or remove the row.");
        if (!parseNumber(value.toStdString()))
            return tr("“%1” of “%2” is no number; enter one, with a decimal point.").arg(value, key);
        for (const int column : {unitCell, sourceCell})
            if (table_->item(row, column)->text().trimmed().isEmpty())
                return column == unitCell ? tr("“%1” has no unit; enter one, or 1 where it has none.").arg(key)
                                          : tr("“%1” has no source; enter where the number comes from.").arg(key);
    }
    if (material_.values.size() != static_cast<std::size_t>(table_->rowCount()))
        return tr("Two values have the same name; rename one of them.");
    return {};
}

void MaterialForm::addValue() {
    showing_ = true;
    addRow({}, {0.0, "1", "entered by hand", true});
    showing_ = false;
    const int row = table_->rowCount() - 1;
    table_->setCurrentCell(row, keyCell);
    table_->editItem(table_->item(row, keyCell));
    take();
}

void MaterialForm::removeValue() {
    if (table_->currentRow() < 0) return;
    table_->removeRow(table_->currentRow());
    take();
}

void MaterialForm::chooseColour() {
    const auto& [red, green, blue] = material_.colour;
    QColorDialog dialog(QColor(red, green, blue), this);
    dialog.setObjectName(QStringLiteral("colourDialog"));
    dialog.setOption(QColorDialog::DontUseNativeDialog);
    if (dialog.exec() != QDialog::Accepted) return;
    const QColor chosen = dialog.selectedColor();
    material_.colour = {static_cast<std::uint8_t>(chosen.red()), static_cast<std::uint8_t>(chosen.green()),
                        static_cast<std::uint8_t>(chosen.blue())};
    showColour();
    emit edited();
}

void MaterialForm::showColour() {
    const auto& [red, green, blue] = material_.colour;
    QPixmap swatch(32, 16);
    swatch.fill(QColor(red, green, blue));
    colour_->setIcon(QIcon(swatch));
    colour_->setIconSize(swatch.size());
    colour_->setText(QColor(red, green, blue).name());
}

} // namespace burin
