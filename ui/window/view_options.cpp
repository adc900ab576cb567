// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/view_options.h"

namespace burin {

ViewOptions::ViewOptions(Viewport& viewport, const Actions& actions, UserSettings& settings, QObject* parent)
    : QObject(parent) {
    QAction* parallel = actions[ActionId::parallelView];
    parallel->setChecked(settings.parallelView());
    viewport.setParallel(parallel->isChecked());
    connect(parallel, &QAction::toggled, this, [&viewport, &settings](bool wanted) {
        viewport.setParallel(wanted);
        settings.setParallelView(wanted);
    });
}

} // namespace burin
