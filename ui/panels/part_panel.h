// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The CAD part: file, unit, bodies with volume and bounding box, and what was healed or is doubtful.
class PartPanel : public QWidget {
    Q_OBJECT
public:
    explicit PartPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const PartState& state); ///< never emits
    void chooseBody(std::size_t body);     ///< selects a body, so that its role can be chosen with the keyboard

signals:
    void importRequested();
    void roleChosen(std::size_t body, burin::BodyRole role); ///< @param body index in the order of PartState
    void fileUnitChosen(double millimetres); ///< the size of the file's unit, mm; the file must be read again

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
