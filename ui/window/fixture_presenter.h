// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/input/fixture_placer.h"
#include "ui/panels/job_states.h"
#include "ui/scene/viewport.h"
#include "ui/window/fixture_dialog.h"
#include "ui/window/presenter.h"

namespace burin {

/// Placing a fixture of the library: its dialog, and the pointer that places it in the view.
class FixturePresenter final : public Presenter {
    Q_OBJECT
public:
    FixturePresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    void connectActions(const Actions& actions);
    void setShown(JobStep step); ///< placing ends when another step than the stock's is shown

signals:
    void placingBegins(); ///< the stock step must be shown
    void escapeChanged(); ///< the meaning of Esc may have changed

private:
    void present() override;
    void begin();
    void end();
    FixtureDialogState state() const;

    Viewport& viewport_;
    FixturePlacer placer_;
    FixtureDialog* dialog_ = nullptr;   ///< null unless placing
    InteractiveTool* before_ = nullptr; ///< the view's tool before placing
};

} // namespace burin
