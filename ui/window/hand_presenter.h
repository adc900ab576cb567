// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/hand_panel.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// The device in the user's hand.
class HandPresenter final : public Presenter {
    Q_OBJECT
public:
    HandPresenter(Workbench& workbench, HandPanel& panel, QObject* parent);
    /// @param viewport with which the hand is aligned; outlives the presenter
    void connectActions(const Actions& actions, const Viewport& viewport);

private:
    void present() override;
    void setRate(bool on);
    HandPanel& panel_;
};

} // namespace burin
