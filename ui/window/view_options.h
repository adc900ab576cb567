// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/dialogs/preferences.h"
#include "ui/scene/viewport.h"

#include <QObject>

namespace burin {

/// How the view shows things, as the user chooses it by actions; remembered from one start to the next.
class ViewOptions final : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    ViewOptions(Viewport& viewport, const Actions& actions, UserSettings& settings, QObject* parent);
};

} // namespace burin
