// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/axis_rows.h"

#include "ui/messages/messages.h"
#include "ui/panels/device_labels.h"
#include "ui/panels/panel_layout.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>

#include <array>

namespace burin {

namespace {

constexpr int buttonColumns = 3;
constexpr int barWidth = 120; // pixels
constexpr std::array motions{AxisMotion::none, AxisMotion::x, AxisMotion::y, AxisMotion::z,
                             AxisMotion::a,    AxisMotion::b, AxisMotion::c};
constexpr std::array buttonActions{ButtonAction::none,     ButtonAction::mill,       ButtonAction::lift,
                                   ButtonAction::undo,     ButtonAction::redo,       ButtonAction::clutch,
                                   ButtonAction::recentre, ButtonAction::levelAbove, ButtonAction::levelBelow,
                                   ButtonAction::edge,     ButtonAction::fit};

} // namespace

AxisRows::AxisRows(const MappableDevice& device, QWidget* parent) : QWidget(parent), device_(device) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    const QString titles[] = {tr("Axis"), tr("Reading"), tr("Moves"), {}, tr("Gain"), tr("Dead zone"), tr("Range")};
    for (int i = 0; i < 7; ++i) grid->addWidget(makeSectionTitle(titles[i], this), 0, i);
    for (std::size_t i = 0; i < device_.axes.size(); ++i)
        addAxisRow(*grid, i, Messages::text({"Device", device_.axes[i].name.c_str()}));
    column->addLayout(grid);
    if (device_.buttons > 0) column->addWidget(makeSectionTitle(tr("Buttons"), this));
    auto* pairs = new QGridLayout;
    pairs->setHorizontalSpacing(8);
    pairs->setVerticalSpacing(4);
    for (std::size_t i = 0; i < device_.buttons; ++i) addButtonRow(*pairs, i);
    column->addLayout(pairs);
    column->addStretch(1);
}

template <class Change>
void AxisRows::edit(Change change) {
    AxisMap map = map_;
    change(map);
    if (map == map_) return;
    map_ = map;
    emit mapEdited(map);
}

void AxisRows::addAxisRow(QGridLayout& grid, std::size_t axis, const QString& name) {
    const QString number = QString::number(axis + 1);
    AxisRow row;
    auto* label = new QLabel(name, this);
    row.bar = new MeterBar(&Palette::accent, this);
    row.bar->setObjectName(QStringLiteral("axisBar") + number);
    row.bar->setMinimumWidth(barWidth);
    row.bar->setAccessibleName(name);
    row.motion = new ChoiceBox(this);
    row.motion->setObjectName(QStringLiteral("axisMotion") + number);
    row.motion->setAccessibleName(name);
    row.motion->setToolTip(tr("What this axis moves, as seen from the user"));
    for (const AxisMotion motion : motions) row.motion->addItem(motionName(motion));
    row.reversed = new QCheckBox(tr("reversed"), this);
    row.reversed->setObjectName(QStringLiteral("axisReversed") + number);
    row.reversed->setToolTip(tr("The axis moves the other way"));
    row.reversed->setAccessibleName(name + QStringLiteral(", ") + row.reversed->text());
    row.gain = addShareField(QStringLiteral("axisGain") + number, name + QStringLiteral(", ") + tr("Gain"),
                             tr("Share of the full motion at full deflection; more than 1 reaches it earlier"), 0.05,
                             10.0, axis, &AxisUse::gain);
    row.deadZone =
        addShareField(QStringLiteral("axisDead") + number, name + QStringLiteral(", ") + tr("Dead zone"),
                      tr("Share of the deflection from rest that has no effect"), 0.0, 0.5, axis, &AxisUse::deadZone);
    row.range = new QLabel(this);
    row.range->setObjectName(QStringLiteral("axisRange") + number);
    row.range->setToolTip(tr("Lower end, rest and upper end of the axis, % of its nominal range"));
    const int line = static_cast<int>(axis) + 1;
    QWidget* const widgets[] = {label, row.bar, row.motion, row.reversed, row.gain, row.deadZone, row.range};
    for (int i = 0; i < 7; ++i) grid.addWidget(widgets[i], line, i);
    connect(row.motion, &QComboBox::activated, this, [this, axis](int index) {
        edit([&](AxisMap& map) { map.axes[axis].motion = motions[static_cast<std::size_t>(index)]; });
    });
    connect(row.reversed, &QCheckBox::clicked, this,
            [this, axis](bool on) { edit([&](AxisMap& map) { map.axes[axis].reversed = on; }); });
    axes_.push_back(row);
}

QuantityField* AxisRows::addShareField(const QString& objectName, const QString& name, const QString& toolTip,
                                       double low, double high, std::size_t axis, double AxisUse::*value) {
    auto* field = new QuantityField(Quantity::ratio, this);
    field->setObjectName(objectName);
    field->setAccessibleName(name);
    field->setToolTip(toolTip);
    field->limit(low, high);
    connect(field, &QuantityField::valueEdited, this,
            [this, axis, value](double edited) { edit([&](AxisMap& map) { map.axes[axis].*value = edited; }); });
    return field;
}

void AxisRows::addButtonRow(QGridLayout& grid, std::size_t button) {
    ButtonRow row;
    row.name = new QLabel(this);
    row.name->setObjectName(QStringLiteral("axisButton") + QString::number(button + 1));
    row.action = new ChoiceBox(this);
    row.action->setObjectName(QStringLiteral("buttonAction") + QString::number(button + 1));
    row.action->setAccessibleName(tr("Button %1").arg(button + 1));
    row.action->setToolTip(tr("What this button does while the device mills"));
    for (const ButtonAction action : buttonActions) row.action->addItem(actionName(action));
    const int place = static_cast<int>(button), line = place / buttonColumns, column = 2 * (place % buttonColumns);
    grid.addWidget(row.name, line, column);
    grid.addWidget(row.action, line, column + 1);
    connect(row.action, &QComboBox::activated, this, [this, button](int index) {
        edit([&](AxisMap& map) { map.buttons[button] = buttonActions[static_cast<std::size_t>(index)]; });
    });
    buttons_.push_back(row);
}

void AxisRows::showMap(const AxisMap& map) {
    map_ = map;
    const auto percent = [](double share) { return QLocale().toString(100.0 * share, 'f', 0); };
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const AxisUse& use = map.axes[i];
        axes_[i].motion->setCurrentIndex(static_cast<int>(use.motion));
        axes_[i].reversed->setChecked(use.reversed);
        axes_[i].gain->showValue(use.gain);
        axes_[i].deadZone->showValue(use.deadZone);
        axes_[i].range->setText(
            tr("%1 to %3 %, rest %2 %").arg(percent(use.low), percent(use.rest), percent(use.high)));
    }
    for (std::size_t i = 0; i < buttons_.size(); ++i)
        buttons_[i].action->setCurrentIndex(static_cast<int>(map.buttons[i]));
}

void AxisRows::showReading(const AxisReading& reading) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const AxisUse& use = map_.axes[i];
        axes_[i].bar->setShare((reading.values[i] - use.low) / (use.high - use.low));
    }
    for (std::size_t i = 0; i < buttons_.size(); ++i) {
        const QString name = tr("Button %1").arg(i + 1);
        const bool pressed = (reading.buttons >> i & 1U) != 0;
        buttons_[i].name->setText(pressed ? QStringLiteral("● ") + name : name);
    }
}

} // namespace burin
