// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/guide_panel.h"
#include "ui/window/presenter.h"

namespace burin {

/// The guides of the hand.
class GuidePresenter final : public Presenter {
    Q_OBJECT
public:
    GuidePresenter(Workbench& workbench, GuidePanel& panel, QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// Guides on and off, the nearest edge, levels.
    void connectActions(const Actions& actions);

private:
    void present() override;
    GuidePanel& panel_;
};

} // namespace burin
