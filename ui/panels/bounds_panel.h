// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"

#include <QWidget>

namespace burin {

/// Switches of what keeps the tool out besides the part, at hand while one mills. Hidden where there is nothing.
class BoundsPanel : public QWidget {
    Q_OBJECT
public:
    explicit BoundsPanel(QWidget* parent = nullptr);
    void setState(const SurroundingsState& state); ///< never emits

signals:
    void obstacleSwitched(std::size_t place, bool on); ///< @param place in SurroundingsState::obstacles
    void travelSwitched(bool on);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
