// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/hand_panel.h"
#include "ui/window/presenter.h"

namespace burin {

/// The device in the user's hand.
class HandPresenter final : public Presenter {
    Q_OBJECT
public:
    HandPresenter(Workbench& workbench, HandPanel& panel, QObject* parent);

private:
    void present() override;
    HandPanel& panel_;
};

} // namespace burin
