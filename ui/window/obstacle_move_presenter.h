// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/fixture_placer.h"
#include "ui/panels/job_states.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// Moving a fixture or keep-out volume of no library in the view, by the pointer and keys that place one of the library
/// (FixturePlacer).
class ObstacleMovePresenter final : public Presenter {
    Q_OBJECT
public:
    ObstacleMovePresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    void setShown(JobStep step); ///< the move is accepted when another step than the stock's is shown

signals:
    void movingBegins(const QString& hint); ///< the stock step must be shown
    void movingEnded();
    void escapeChanged(); ///< the meaning of Esc may have changed

private:
    void present() override;
    void begin();
    void end();
    void followTool();

    Viewport& viewport_;
    FixturePlacer placer_;
    InteractiveTool* before_ = nullptr; ///< the view's tool before
    bool moving_ = false;
};

} // namespace burin
