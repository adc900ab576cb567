// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/preset_table.h"

#include "core/tool/tool_ranges.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/texts.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace burin {

namespace {

constexpr int presetFieldWidth = 124, presetColumns = 4; // pixels

/// Adds a field below its label.
void addLabelled(QGridLayout& grid, int row, int column, QWidget* field, const QString& label, const QString& toolTip) {
    auto* name = new QLabel(label, field->parentWidget());
    name->setProperty("look", "quiet");
    name->setBuddy(field);
    name->setToolTip(toolTip);
    field->setAccessibleName(label);
    field->setToolTip(toolTip);
    field->setFixedWidth(presetFieldWidth);
    grid.addWidget(name, 2 * row, column);
    grid.addWidget(field, 2 * row + 1, column);
}

} // namespace

PresetTable::PresetTable(std::vector<Property> materials, QWidget* parent)
    : QWidget(parent), materials_(std::move(materials)) {
    setObjectName(QStringLiteral("toolPresets"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    add_ = makeButton(tr("Add a preset"), QStringLiteral("add"), QStringLiteral("addPresetButton"), this);
    add_->setToolTip(tr("Feeds and speeds for one material, or for any"));
    add_->setAutoDefault(false); // Enter is handled by the fields
    column->addWidget(add_, 0, Qt::AlignLeft);
    connect(add_, &QPushButton::clicked, this, &PresetTable::addPreset);
}

void PresetTable::showPresets(const std::vector<CuttingPreset>& presets, double radius, double deepestCut) {
    presets_ = presets;
    radius_ = radius;
    deepestCut_ = deepestCut;
    while (cards_.size() > presets.size()) removeCard();
    while (cards_.size() < presets.size()) addCard();
    for (std::size_t i = 0; i < presets.size(); ++i) show(cards_[i], presets[i]);
    setReadOnly(readOnly_);
}

void PresetTable::show(const Card& card, const CuttingPreset& preset) {
    const QString name = QString::fromStdString(preset.name);
    if (card.name->text().trimmed() != name) card.name->setText(name);
    offerMaterials(card, preset);
    card.coolant->setCurrentIndex(preset.coolant ? 1 + static_cast<int>(*preset.coolant) : 0);
    card.stepDown->limit(0.0, std::max(deepestCut_, preset.stepDown));
    card.stepOver->limit(0.0, std::max(radius_, preset.stepOver));
    card.speed->showValue(preset.spindleSpeed);
    card.feed->showValue(preset.feed);
    card.chipLoad->showValue(preset.chipLoad);
    card.plunge->showValue(preset.plungeFeed);
    card.stepDown->showValue(preset.stepDown);
    card.stepOver->showValue(preset.stepOver);
}

/// A material that the library lacks stays the preset's own.
void PresetTable::offerMaterials(const Card& card, const CuttingPreset& preset) {
    QStringList texts{tr("any material")}, ids{QString()};
    for (const Property& material : materials_) {
        texts << materialName(material);
        ids << QString::fromStdString(material.id);
    }
    const QString id = QString::fromStdString(preset.material);
    if (!ids.contains(id)) {
        texts << tr("%1 (not available)").arg(id);
        ids << id;
    }
    card.material->offer(texts, ids, id);
}

void PresetTable::setReadOnly(bool readOnly) {
    readOnly_ = readOnly;
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        const Card& card = cards_[i];
        card.name->setReadOnly(readOnly);
        for (ChoiceBox* box : {card.material, card.coolant}) box->setEnabled(!readOnly);
        for (QuantityField* field : card.numbers()) field->setReadOnly(readOnly);
        card.raise->setVisible(!readOnly && i > 0);
        card.remove->setVisible(!readOnly);
    }
    add_->setVisible(!readOnly);
}

void PresetTable::setUnit(LengthUnit unit) {
    unit_ = unit;
    for (const Card& card : cards_)
        for (QuantityField* field : card.numbers()) field->setLengthUnit(unit);
}

void PresetTable::addCard() {
    Card card;
    card.box = new QWidget(this);
    auto* grid = new QGridLayout(card.box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(presetColumns, 1);
    addTexts(card, *grid);
    addNumbers(card, *grid);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->insertWidget(static_cast<int>(cards_.size()), card.box);
    card.box->show(); // now, so that its fields can get the focus
    std::vector<QWidget*> chain{cards_.empty() ? add_ : static_cast<QWidget*>(cards_.back().remove), card.name,
                                card.material, card.coolant};
    for (QuantityField* field : card.numbers()) chain.push_back(field);
    for (QWidget* button : std::initializer_list<QWidget*>{card.raise, card.remove, add_}) chain.push_back(button);
    for (std::size_t i = 1; i < chain.size(); ++i) setTabOrder(chain[i - 1], chain[i]);
    cards_.push_back(card);
}

void PresetTable::addTexts(Card& card, QGridLayout& grid) {
    const std::size_t at = cards_.size();
    const QString number = QString::number(at);
    card.name = new QLineEdit(card.box);
    card.name->setObjectName(QStringLiteral("presetName") + number);
    connect(card.name, &QLineEdit::textEdited, this, [this, at](const QString& typed) {
        change(at, [&](CuttingPreset& preset) { preset.name = typed.trimmed().toStdString(); });
    });
    addLabelled(grid, 0, 0, card.name, tr("Name"),
                tr("Name of the preset, different from those of the tool's other presets"));
    card.material = new ChoiceBox(card.box);
    card.material->setObjectName(QStringLiteral("presetMaterial") + number);
    connect(card.material, &QComboBox::activated, this, [this, at](int index) {
        const std::string id = cards_[at].material->itemData(index).toString().toStdString();
        change(at, [&](CuttingPreset& preset) { preset.material = id; });
    });
    addLabelled(grid, 0, 1, card.material, tr("Material"), tr("Material of the stock that the preset is for"));
    card.coolant = new ChoiceBox(card.box);
    card.coolant->setObjectName(QStringLiteral("presetCoolant") + number);
    card.coolant->addItems({tr("by material"), tr("off"), tr("mist"), tr("flood")}); // in the order of Coolant
    connect(card.coolant, &QComboBox::activated, this, [this, at](int index) {
        change(at, [&](CuttingPreset& preset) {
            preset.coolant = index > 0 ? std::optional(static_cast<Coolant>(index - 1)) : std::nullopt;
        });
    });
    addLabelled(grid, 0, 2, card.coolant, tr("Coolant"), tr("Coolant that paths with this preset use"));
    card.raise = makeIconButton(QStringLiteral("previous"), tr("Prefer preset %1 to the one before it").arg(at + 1),
                                QStringLiteral("raisePreset") + number, card.box);
    card.remove = makeIconButton(QStringLiteral("remove"), tr("Delete preset %1").arg(at + 1),
                                 QStringLiteral("removePreset") + number, card.box);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(card.raise);
    buttons->addWidget(card.remove);
    grid.addLayout(buttons, 1, presetColumns - 1, Qt::AlignLeft);
    connect(card.raise, &QToolButton::clicked, this, [this, at] { raisePreset(at); });
    connect(card.remove, &QToolButton::clicked, this, [this, at] { removePreset(at); });
}

void PresetTable::addNumbers(Card& card, QGridLayout& grid) {
    using namespace tool_range;
    const std::size_t at = cards_.size();
    const auto add = [&](const char* name, int row, int column, const QString& label, const QString& toolTip,
                         Quantity quantity, double high, const std::function<void(CuttingPreset&, double)>& set) {
        auto* field = new QuantityField(quantity, card.box);
        field->setObjectName(QLatin1String(name) + QString::number(at));
        field->limit(0.0, high);
        field->setLengthUnit(unit_);
        connect(field, &QuantityField::valueEdited, this,
                [this, at, set](double value) { change(at, [&](CuttingPreset& preset) { set(preset, value); }); });
        addLabelled(grid, row, column, field, label, toolTip);
        return field;
    };
    card.speed = add("presetSpeed", 1, 0, tr("Spindle speed"), tr("Speed of the spindle at which the feed applies"),
                     Quantity::rotation, presetSpeed.high,
                     [](CuttingPreset& preset, double value) { preset.spindleSpeed = value; });
    card.feed = add("presetFeed", 1, 1, tr("Feed"), tr("0: by the feed per tooth"), Quantity::feed, presetFeed.high,
                    [](CuttingPreset& preset, double value) {
                        if (value > 0.0) preset.chipLoad = 0.0;
                        preset.feed = value;
                    });
    card.chipLoad = add("presetChipLoad", 1, 2, tr("Feed per tooth"), tr("0: by the feed"), Quantity::length,
                        presetChipLoad.high, [](CuttingPreset& preset, double value) {
                            if (value > 0.0) preset.feed = 0.0;
                            preset.chipLoad = value;
                        });
    card.plunge =
        add("presetPlunge", 1, 3, tr("Plunge feed"), tr("0: the share of the feed that the material states"),
            Quantity::feed, presetFeed.high, [](CuttingPreset& preset, double value) { preset.plungeFeed = value; });
    card.stepDown =
        add("presetStepDown", 2, 0, tr("Step-down"),
            tr("Depth of a level, at most the deepest cut. 0: what material, tool and spindle can take"),
            Quantity::length, presetStep.high, [](CuttingPreset& preset, double value) { preset.stepDown = value; });
    card.stepOver =
        add("presetStepOver", 2, 1, tr("Step-over"),
            tr("Between the loops of a level, at most half the diameter. 0: a share of the diameter"), Quantity::length,
            presetStep.high, [](CuttingPreset& preset, double value) { preset.stepOver = value; });
}

void PresetTable::removeCard() {
    const Card& card = cards_.back();
    layout()->removeWidget(card.box);
    card.box->hide();
    for (QWidget* widget : card.box->findChildren<QWidget*>()) widget->setObjectName({}); // no longer found by name
    card.box->deleteLater(); // it may contain the button that was clicked
    cards_.pop_back();
}

void PresetTable::change(std::size_t at, const std::function<void(CuttingPreset&)>& how) {
    if (readOnly_ || at >= presets_.size()) return;
    std::vector<CuttingPreset> presets = presets_;
    how(presets[at]);
    emit edited(presets);
}

void PresetTable::addPreset() {
    if (readOnly_) return;
    std::vector<CuttingPreset> presets = presets_;
    CuttingPreset next;
    if (!presets.empty()) next = presets.back();
    next.name = freePresetName(presets, tr("Preset").toStdString());
    presets.push_back(next);
    emit edited(presets);
    if (cards_.size() < presets.size()) return;
    cards_.back().name->setFocus();
    cards_.back().name->selectAll();
}

void PresetTable::removePreset(std::size_t at) {
    if (readOnly_ || at >= presets_.size()) return;
    std::vector<CuttingPreset> presets = presets_;
    presets.erase(presets.begin() + static_cast<std::ptrdiff_t>(at));
    add_->setFocus(); // the last card is removed
    emit edited(presets);
}

void PresetTable::raisePreset(std::size_t at) {
    if (readOnly_ || at == 0 || at >= presets_.size()) return;
    std::vector<CuttingPreset> presets = presets_;
    std::swap(presets[at - 1], presets[at]);
    emit edited(presets);
}

} // namespace burin
