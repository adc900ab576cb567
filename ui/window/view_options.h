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

/// The display options of the view, chosen by actions, on the bar below the view, or by the handle of the section
/// plane. Projection, transparency and the switch of the handles are remembered between sessions of the program.
class ViewOptions final : public QObject {
    Q_OBJECT
public:
    /// All arguments outlive it.
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
    int transparency_ = 0, usualTransparency_ = 0; ///< %: at present, and as set by the action
    std::optional<SectionPlane> section_;
};

} // namespace burin
