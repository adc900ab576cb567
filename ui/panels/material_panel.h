// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The materials of stock and bodies with each value, its unit and its source; estimates are marked.
class MaterialPanel : public QWidget {
    Q_OBJECT
public:
    explicit MaterialPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const MaterialState& state); ///< never emits

signals:
    void stockMaterialChosen(const std::string& id);
    void bodyMaterialChosen(std::size_t body, const std::string& id); ///< @param body index in MaterialState's order

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
