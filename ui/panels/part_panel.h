// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The CAD part: file, unit, bodies with volume and box, what was healed and what is doubtful.
class PartPanel : public QWidget {
    Q_OBJECT
public:
    explicit PartPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const PartState& state); ///< never emits
    void chooseBody(std::size_t body);     ///< its role can be chosen with the keys

signals:
    void importRequested();
    void roleChosen(std::size_t body, burin::BodyRole role); ///< @param body in PartState's order
    void fileUnitChosen(double millimetres);                 ///< a unit of the file means; it is to be read again

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
