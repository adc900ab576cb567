// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/dialogs/preferences.h"
#include "ui/panels/view_bar.h"
#include "ui/scene/viewport.h"

#include <QObject>

#include <optional>

namespace burin {

/// How the view shows things, as the user chooses it by actions, on the bar below the view, or by the section's handle.
/// Projection and transparency are remembered from one start to the next.
class ViewOptions final : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    ViewOptions(Viewport& viewport, ViewBar& bar, const Actions& actions, UserSettings& settings, QObject* parent);

private:
    void setTransparency(int percent);
    void openSection(bool open);
    void chooseAxis(int axis);
    void moveSection(double position);
    void showSection();

    Viewport& viewport_;
    ViewBar& bar_;
    const Actions& actions_;
    UserSettings& settings_;
    int transparency_ = 0, usualTransparency_ = 0; ///< %: as it is, and as the action makes it
    std::optional<SectionPlane> section_;
};

} // namespace burin
