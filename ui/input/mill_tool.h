// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/simulated_stylus.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"
#include "ui/input/fine_pointer.h"
#include "ui/input/stroke_feed.h"
#include "ui/input/stroke_memory.h"
#include "ui/input/stroke_shapes.h"
#include "ui/scene/interactive_tool.h"
#include "ui/scene/place_chains.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace burin {

/// How the tool's depth follows the pointer during a stroke.
enum class DepthRule {
    level, ///< stays on the height of the stroke's first place, less the depth of cut
    part   ///< presses onto the part under the pointer: the push-back leads the tool along it
};

/// What a drag with the left button cuts.
enum class DragRule {
    stroke, ///< the pointer's trail
    raster  ///< rows over the rectangle from the press to the release
};

struct MillToolSettings {
    DepthRule rule = DepthRule::level;
    DragRule drag = DragRule::stroke;
    double depthOfCut = 1.0; ///< mm below the surface under the pointer, DepthRule::level
    double press = 2.0;      ///< mm into the part, DepthRule::part
    /// mm/s at most while cutting. A sweep of the hand across a part of 100 mm in half a second is as fast.
    double speed = 200.0;
    double stepOver = 2.0; ///< mm between the rows of a raster, and to a stroke's repetition beside it
};

/// The mouse over the workpiece as a stylus. Hovering, the tool floats above what is under the pointer and on the way
/// there, the spindle off, and settles when it has arrived. Left drag cuts a stroke: down along the tool's axis from
/// where it hovers, then all of the pointer's trail, which it finishes after the button is released. Wheel moves the
/// tool along its axis during strokes (0.5 mm a notch, with Shift 0.05 mm; with Ctrl it is the camera's); Shift makes
/// the pointer fine: a tenth of its motion from where Shift went down, until the stroke is over. The right button is
/// the camera's. Shift-click cuts a straight line from the end of the last stroke, at its height or along the part.
/// With DragRule::raster a drag spans a rectangle, which is milled in rows as one stroke. X, Y and D lock strokes, and
/// lines, to an axis or to the direction in which they go, until the same key is pressed again. What is cut by itself
/// (line, raster, repetition) is a stroke like others. Esc gives up what is drawn, ends a stroke where it is, else
/// leaves. The keyboard alone can mill: arrow keys move by a voxel, as seen by the user (Ctrl: ten voxels, Shift: a
/// tenth), Page up and down along the axis, Space switches the spindle on and off. While it turns by the keyboard, the
/// pointer does nothing; otherwise the next motion of the pointer takes the tool again. Thread: user interface.
class MillTool final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    /// @param view gives the newest workpiece, for the depth under the pointer; asked often, cheap
    MillTool(SimulatedStylus& stylus, const Tool& tool, std::function<VolumeSnapshot()> view,
             QObject* parent = nullptr);

    /// @param grain mm at a place: the longest diagonal of a pixel there, on its level; what the pointer can't tell
    void setGrain(std::function<double(const glm::dvec3& place)> grain) { grain_ = std::move(grain); }
    void setSettings(const MillToolSettings& settings);
    const MillToolSettings& settings() const noexcept { return settings_; }

    /// Strokes wait until their recording runs.
    void hold() { feed_.hold(); }
    void goOn() { feed_.goOn(); }
    /// A recording that could not begin: the stroke is given up, nothing was cut.
    void giveUp() { endStroke(End::givenUp); }

    enum class Repetition : std::uint8_t { lower, left, right };
    /// Cuts the last stroke again: lower by the depth of cut, or beside it by the step-over, to its left or right as it
    /// went, seen from above. Nothing happens while a stroke is under way. @return why it can't be; empty: it begins
    QString repeat(Repetition how);
    bool canRepeat() const noexcept { return stroke_ == Stroke::none && memory_.last().places.size() > 1; }
    /// The newest stroke was undone, or redone: lines and repetitions go on from the one that is the last now.
    void strokeTakenBack(bool undo);

    StrokeLock lock() const noexcept { return lock_; }
    /// What Esc does now, a sentence.
    QString escapeMeaning() override;
    /// What is to be seen of strokes to come, mm, setup frame: what the tool has still to catch up with, a line or the
    /// rows that a release would cut.
    PlaceChains plans();

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
    void stateChanged();              ///< lock, plans, or what Esc does
    void refused(const QString& sentence);
    /// Where a press would lead the tip, mm, setup frame, the push-back not reckoned with; nothing: there will be none.
    void pressAimed(const std::optional<glm::dvec3>& tip);

private:
    enum class Stroke : std::uint8_t { none, pointer, keyboard };
    enum class Drawing : std::uint8_t { none, line, raster }; ///< what a release will cut

    double clearHeightTo(const VolumeSnapshot& workpiece, const glm::dvec3& place);
    void hoverOver(const Sight& sight);
    void hoverAt(const glm::dvec3& place);
    std::optional<glm::dvec3> aimPress(const VolumeSnapshot& workpiece, const Sight& sight);
    void showAim(const std::optional<glm::dvec3>& tip);
    void aim(const Sight& sight);
    double strokeHeight(const VolumeSnapshot& workpiece, const glm::dvec3& place);
    std::optional<glm::dvec3> strokePlace(const VolumeSnapshot& workpiece, const Sight& sight);
    double grainAt(const glm::dvec3& place) const;
    void cutTo(const glm::dvec3& tip, double clearHeight, double grain);
    void lookAt(const VolumeSnapshot& workpiece, const Sight& sight);
    void beginFreeStroke(const ViewportEvent& event);
    void beginDrawing(Drawing what, const ViewportEvent& event);
    void draw(const ViewportEvent& event);
    std::vector<glm::dvec3> drawnCorners() const;
    void finishDrawing();
    QString cutPlan(const std::vector<glm::dvec3>& corners, double speed, double grain);
    void toggleLock(StrokeLock lock);
    bool lockKey(int key);
    void settle();
    void missRelease();
    enum class End : std::uint8_t { finished, givenUp };
    void endStroke(End how);
    std::uint64_t begunStrokes() noexcept { return stylus_.strokesBegun() - begunBefore_; }
    void step(const glm::dvec3& way);
    void toggleSpindle();

    SimulatedStylus& stylus_;
    Tool tool_;
    std::function<VolumeSnapshot()> view_;
    std::function<double(const glm::dvec3&)> grain_;
    MillToolSettings settings_;
    FinePointer fine_;
    StrokeFeed feed_;
    QTimer settling_;
    Stroke stroke_ = Stroke::none;
    Drawing drawing_ = Drawing::none;
    ViewportEvent pressed_;                ///< that began what is drawn
    glm::dvec3 corner_{0.0}, across_{0.0}; ///< mm, of what is drawn: where it begins and where the pointer is
    StrokeMemory memory_;
    std::uint64_t begunBefore_ = 0; ///< strokes of the stylus that others led
    StrokeLock lock_ = StrokeLock::none;
    glm::dvec3 lockAnchor_{0.0}, lockDirection_{1.0, 0.0, 0.0}; ///< mm; unit
    glm::dvec3 target_;                                         ///< mm, that was requested last
    double wantedHeight_ = 0.0;                                 ///< mm, z that a hover asked for; clearance may lift it
    std::optional<double> surfaceHeight_;                       ///< mm, z of what was under the pointer last
    double pointedHeight_ = 0.0;          ///< mm, z of the plane on which the pointer draws a stroke: where it began
    double levelHeight_ = 0.0;            ///< mm, z of the stroke, the wheel not counted
    std::optional<glm::dvec3> strokeEnd_; ///< mm, of the last stroke, as long as the tool may be on its way there
    bool aimShown_ = false;               ///< a place to press on was told last
    double wheelOffset_ = 0.0;            ///< mm along the axis
    Sight lastSight_;                     ///< as the fine pointer has it
    glm::dvec3 lookingAlong_{0.0, 0.0, -1.0};
};

} // namespace burin
