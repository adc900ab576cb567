// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/workbench/workbench.h"

#include <QObject>

namespace burin {

/// Triggers the actions of the window that the user assigned to buttons of the device in use.
class ButtonActions final : public QObject {
    Q_OBJECT
public:
    /// Both outlive it.
    ButtonActions(Workbench& workbench, const Actions& actions, QObject* parent);

private:
    void follow();

    Workbench& workbench_;
    const Actions& actions_;
    std::uint32_t pressed_ = 0; ///< as in the newest sample
};

} // namespace burin
