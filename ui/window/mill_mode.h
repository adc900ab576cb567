// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/mill_tool.h"
#include "ui/scene/viewport.h"
#include "ui/workbench/workbench.h"

#include <QObject>

#include <memory>

namespace burin {

/// Milling with the mouse: in mill mode, the viewport's pointer moves the tool.
class MillMode final : public QObject {
    Q_OBJECT
public:
    /// Both arguments outlive it.
    MillMode(Workbench& workbench, Viewport& viewport, QObject* parent);
    ~MillMode() override;

    const MillToolSettings& settings() const noexcept { return settings_; }
    void setSettings(const MillToolSettings& settings);
    void repeat(MillTool::Repetition how);
    bool canRepeat() const noexcept { return tool_ && tool_->canRepeat(); }
    bool hasPen() const noexcept { return hasPen_; } ///< a tablet was found, or a pen came near the view
    /// Whether a tilted pen draws in mill mode.
    bool penLeans() const noexcept { return tool_ && tool_->penLeans(); }
    StrokeLock lock() const noexcept { return tool_ ? tool_->lock() : StrokeLock::none; }

signals:
    void settingsChanged();
    void toolChanged(); ///< lock, possible repetitions, meaning of Esc, tilt of a pen
    void refused(const QString& sentence);

private:
    void begin();
    void end();
    void record();
    void showPlans();
    void showAim(const std::optional<glm::dvec3>& tip);

    Workbench& workbench_;
    Viewport& viewport_;
    MillToolSettings settings_;
    bool hasPen_ = false;
    std::unique_ptr<MillTool> tool_;
    PlaceChains plans_; ///< as drawn
};

} // namespace burin
