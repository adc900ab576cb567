// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"
#include "ui/scene/interactive_tool.h"

#include <QObject>

#include <functional>

namespace burin {

/// Picks points on a workpiece: a click selects the point of it that appears there, Esc ends it; clicks beside it and
/// drags are left to the camera. Thread: user interface.
class WorkpiecePicker final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    /// @param shown returns the workpiece that is drawn; empty: none
    explicit WorkpiecePicker(std::function<VolumeSnapshot()> shown, QObject* parent = nullptr)
        : QObject(parent), shown_(std::move(shown)) {}

    bool press(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    bool key(int key, Qt::KeyboardModifiers modifiers) override;
    QString escapeMeaning() override;

signals:
    /// @param place mm, setup frame @param direction unit, of the line of sight
    void chosen(const glm::dvec3& place, const glm::dvec3& direction);
    void cancelled();

private:
    std::function<VolumeSnapshot()> shown_;
    bool taken_ = false; ///< the current press was on the workpiece
};

} // namespace burin
