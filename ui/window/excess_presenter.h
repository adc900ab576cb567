// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// Colours the workpiece by the stock left on the part during milling, and shows its thickness at the pointer.
class ExcessPresenter final : public Presenter {
    Q_OBJECT
public:
    ExcessPresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    void connectActions(const Actions& actions);
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void present() override;
    std::optional<ExcessColours> wanted() const; ///< empty: off, or nothing to colour
    QString textAt(const QPointF& position) const;

    Viewport& viewport_;
    QAction* action_ = nullptr;
    std::optional<ExcessColours> shown_;
};

} // namespace burin
