// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/view_bar.h"
#include "ui/scene/viewport.h"
#include "ui/workbench/workbench.h"

#include <QObject>

namespace burin {

/// Colours the path in the view by the quantity chosen on the bar below it, or by an action that steps through the
/// quantities.
class PathColours final : public QObject {
    Q_OBJECT
public:
    /// All arguments outlive it.
    PathColours(Workbench& workbench, Viewport& viewport, ViewBar& bar, const Actions& actions, QObject* parent);

private:
    void choose(int place); ///< 0: by kind of move
    void show();

    Workbench& workbench_;
    Viewport& viewport_;
    ViewBar& bar_;
    QAction& next_;
};

} // namespace burin
