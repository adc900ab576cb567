// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"

#include <QWidget>

namespace burin {

/// Switches for the fixtures and limits that the tool avoids in addition to the part, within reach while milling.
/// Hidden if there are none.
class BoundsPanel : public QWidget {
    Q_OBJECT
public:
    explicit BoundsPanel(QWidget* parent = nullptr);
    void setState(const SurroundingsState& state); ///< never emits

signals:
    void obstacleSwitched(std::size_t place, bool on); ///< @param place index in SurroundingsState::obstacles
    void travelSwitched(bool on);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
