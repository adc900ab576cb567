// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/tool/tool.h"
#include "core/volume/run_volume.h"
#include "ui/input/mouse_stylus.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <functional>
#include <optional>

namespace burin {

/// How the tool's depth follows the pointer during a stroke.
enum class DepthRule {
    level, ///< stays on the height of the stroke's first place, less the depth of cut
    part   ///< presses onto the part under the pointer: the push-back leads the tool along it
};

struct MillToolSettings {
    DepthRule rule = DepthRule::level;
    double depthOfCut = 1.0; ///< mm below the surface under the pointer, DepthRule::level
    double press = 2.0;      ///< mm into the part, DepthRule::part
    double speed = 60.0;     ///< mm/s at most while cutting
};

/// The mouse over the workpiece as a stylus. Hovering, the tool floats above what is under the pointer, the spindle
/// off. Left drag cuts a stroke. Wheel moves the tool along its axis (0.5 mm a notch, with Shift 0.05 mm); Shift makes
/// the pointer fine (a tenth). The right button is the camera's. Esc leaves. Arrow keys move by a voxel, Page up and
/// down along the axis, Space holds the spindle on: the keyboard alone can mill.
class MillTool final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    /// @param view gives the newest workpiece, for the depth under the pointer; asked often, cheap
    MillTool(MouseStylus& stylus, const Tool& tool, std::function<VolumeSnapshot()> view, QObject* parent = nullptr);

    void setSettings(const MillToolSettings& settings);
    const MillToolSettings& settings() const noexcept { return settings_; }

    bool press(const ViewportEvent& event) override;
    bool move(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool wheel(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    void leave() override;

signals:
    void leaveRequested(); ///< Esc
    void strokeBegins();   ///< before the spindle starts: the moment to begin a recording
    void strokeEnds();
    void depthChanged(double offset); ///< mm along the axis that the wheel added

private:
    MouseStylus& stylus_;
    Tool tool_;
    std::function<VolumeSnapshot()> view_;
    MillToolSettings settings_;
};

} // namespace burin
