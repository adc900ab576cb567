// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/axis_map_json.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/meter_bar.h"
#include "ui/panels/quantity_field.h"

#include <QCheckBox>
#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;

namespace burin {

/// A table of the axes and buttons of a device: what each does, and its live reading.
class AxisRows final : public QWidget {
    Q_OBJECT
public:
    AxisRows(const MappableDevice& device, QWidget* parent);
    void showMap(const AxisMap& map); ///< never emits
    void showReading(const AxisReading& reading);

signals:
    void mapEdited(const burin::AxisMap& map);

private:
    struct AxisRow {
        MeterBar* bar = nullptr;
        ChoiceBox* motion = nullptr;
        QCheckBox* reversed = nullptr;
        QuantityField *gain = nullptr, *deadZone = nullptr;
        QLabel* range = nullptr;
    };
    struct ButtonRow {
        QLabel* name = nullptr;
        ChoiceBox* action = nullptr;
    };
    void addAxisRow(QGridLayout& grid, std::size_t axis, const QString& name);
    void addButtonRow(QGridLayout& grid, std::size_t button);
    QuantityField* addShareField(const QString& objectName, const QString& name, const QString& toolTip, double low,
                                 double high, std::size_t axis, double AxisUse::*value);
    template <class Change>
    void edit(Change change);

    MappableDevice device_;
    AxisMap map_;
    std::vector<AxisRow> axes_;
    std::vector<ButtonRow> buttons_;
};

} // namespace burin
