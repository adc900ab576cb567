// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/bounds_panel.h"
#include "ui/panels/surroundings_panel.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// Fixtures, keep-out volumes, travel and axis: on the set-up page, as switches during milling, and in the viewport.
class SurroundingsPresenter final : public Presenter {
    Q_OBJECT
public:
    SurroundingsPresenter(Workbench& workbench, SurroundingsPanel& panel, BoundsPanel& switches, Viewport& viewport,
                          QObject* parent);
    void setUnit(LengthUnit unit) override;
    /// Sets the tool axis to the view direction.
    void connectActions(const Actions& actions);

signals:
    void fixtureFileRequested();
    void libraryFixtureRequested();

private:
    void present() override;
    void add(SurroundingsPanel::Addition addition);
    void change(std::size_t place);
    SurroundingsPanel& panel_;
    BoundsPanel& switches_;
    Viewport& viewport_;
};

} // namespace burin
