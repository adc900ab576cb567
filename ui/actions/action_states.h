// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/workbench/workbench.h"

#include <QObject>

namespace burin {

/// Enables the actions that are possible in the present state, and disables the others.
class ActionStates final : public QObject {
    Q_OBJECT
public:
    /// Both arguments outlive it.
    ActionStates(Actions& actions, Workbench& workbench, QObject* parent);

private:
    void update();
    void updateUndo();
    void enable(ActionId id, bool enabled) { actions_[id]->setEnabled(enabled); }

    Actions& actions_;
    Workbench& workbench_;
};

} // namespace burin
