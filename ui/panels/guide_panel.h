// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/mill_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The guides (virtual fixtures) that lead the hand while milling.
class GuidePanel : public QWidget {
    Q_OBJECT
public:
    explicit GuidePanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const GuideState& state); ///< never emits

signals:
    void guidesToggled(bool on);
    void guideRequested(burin::GuideKind kind);
    // `place`: index in GuideState::guides.
    void guideEdited(std::size_t place, const burin::Guide& guide);
    void guideRemovalRequested(std::size_t place);
    void levelStepped(int levels); ///< +1: one level along the normal of the guides that have levels

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
