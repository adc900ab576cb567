// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/mill_tool.h"
#include "ui/scene/viewport.h"
#include "ui/workbench/workbench.h"

#include <QObject>

#include <memory>

namespace burin {

/// The tool in the user's hand: while mill mode is on, the viewport's pointer leads it.
class MillMode final : public QObject {
    Q_OBJECT
public:
    /// Both outlive it.
    MillMode(Workbench& workbench, Viewport& viewport, QObject* parent);
    ~MillMode() override;

    const MillToolSettings& settings() const noexcept { return settings_; }
    void setSettings(const MillToolSettings& settings);
    void repeat(MillTool::Repetition how);
    bool canRepeat() const noexcept { return tool_ && tool_->canRepeat(); }
    StrokeLock lock() const noexcept { return tool_ ? tool_->lock() : StrokeLock::none; }

signals:
    void settingsChanged();
    void toolChanged(); ///< lock, what can be repeated, what Esc does
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
    std::unique_ptr<MillTool> tool_;
    PlaceChains plans_; ///< that are drawn
};

} // namespace burin
