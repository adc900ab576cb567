// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// Colours the workpiece by the stock that is left on the part, as it is milled, and tells how much it is where the
/// pointer rests.
class ExcessPresenter final : public Presenter {
    Q_OBJECT
public:
    ExcessPresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    void connectActions(const Actions& actions);
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void present() override;
    std::optional<ExcessColours> wanted() const; ///< nothing: it is off, or there is nothing to be coloured
    QString textAt(const QPointF& position) const;

    Viewport& viewport_;
    QAction* action_ = nullptr;
    std::optional<ExcessColours> shown_;
};

} // namespace burin
