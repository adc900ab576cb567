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

#include <QElapsedTimer>
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
    level, ///< keeps the height of the stroke's first point, less the depth of cut
    part   ///< presses onto the part under the pointer: the reaction force guides the tool along it
};

/// What a drag with the left button cuts.
enum class DragRule {
    stroke, ///< the trail of the pointer
    raster  ///< rows over the rectangle from press to release
};

/// What the pressure of a pen does during a stroke. The full depth is the depth of cut below the surface under the pen
/// (DepthRule::level), or `press` into the part (DepthRule::part).
enum class PenRule {
    depth, ///< the tool is at the pressure's share of the full depth: at the surface without pressure
    sink   ///< the tool sinks from the surface at the pressure's share of `sinkSpeed`, to the full depth at most
};

struct MillToolSettings {
    DepthRule rule = DepthRule::level;
    DragRule drag = DragRule::stroke;
    double depthOfCut = 1.0; ///< mm below the surface under the pointer, DepthRule::level
    double press = 2.0;      ///< mm into the part, DepthRule::part
    /// Largest cutting speed, mm/s. A hand that moves across a part of 100 mm in half a second is as fast.
    double speed = 200.0;
    /// Distance between the rows of a raster, and from a stroke to its repetition to the left or right, mm
    double stepOver = 2.0;
    PenRule pen = PenRule::depth;
    double sinkSpeed = 2.0; ///< mm/s at full pressure, PenRule::sink
};

/// The mouse over the workpiece as a stylus. While hovering, the tool stays above what is under the pointer and under
/// its move there, the spindle off, and descends when it has arrived. Left drag cuts a stroke: down along the tool axis
/// from the hover position, then along the complete trail of the pointer, which is finished after the button is
/// released. The wheel moves the tool along its axis during strokes (0.5 mm a notch, with Shift 0.05 mm; with Ctrl it
/// is left to the camera); Shift makes the pointer fine: a tenth of its motion from where Shift was pressed, until the
/// end of the stroke. The right button is left to the camera. Shift-click cuts a straight line from the end of the last
/// stroke, at its height or along the part. With DragRule::raster a drag spans a rectangle, which is milled in rows as
/// one stroke. X, Y and D lock strokes and lines to an axis or to their present direction, until the same key is
/// pressed again. A line, raster or repetition, which is cut automatically, is a stroke like others. Esc cancels what
/// is being drawn, or ends a stroke at the tool's position, or else leaves mill mode. Milling is possible with the
/// keyboard alone: arrow keys move by a voxel, as seen by the user (Ctrl: ten voxels, Shift: a tenth), Page up and down
/// along the axis, Space switches the spindle on and off. While the spindle was switched on by the keyboard, the
/// pointer has no effect; otherwise the next motion of the pointer controls the tool again.
///
/// A pen is a mouse whose tip is the left button. Its pressure sets the depth of a free stroke or the speed at which
/// the tool sinks (PenRule); lines, rasters and repetitions are cut at full depth. During a stroke the tool axis leans
/// as the pen does; a session with a fixed axis ignores that. While the eraser is near, the tool stays retracted above
/// all of the workpiece; a stroke ends as with Esc. Thread: user interface.
class MillTool final : public QObject, public InteractiveTool {
    Q_OBJECT
public:
    /// @param view returns the newest workpiece, for the depth under the pointer; called often, must be cheap
    MillTool(SimulatedStylus& stylus, const Tool& tool, std::function<VolumeSnapshot()> view,
             QObject* parent = nullptr);

    /// @param grain mm: the resolution of the pointer at a point, i.e. the longest diagonal of a pixel in its level
    /// plane
    void setGrain(std::function<double(const glm::dvec3& place)> grain) { grain_ = std::move(grain); }
    void setSettings(const MillToolSettings& settings);
    const MillToolSettings& settings() const noexcept { return settings_; }

    /// Strokes wait until their recording runs.
    void hold() { feed_.hold(); }
    void goOn() { feed_.goOn(); }
    /// The recording could not begin: cancels the stroke; nothing was cut.
    void giveUp() { endStroke(End::givenUp); }

    enum class Repetition : std::uint8_t { lower, left, right };
    /// Cuts the last stroke again: lower by the depth of cut, or offset by the step-over to its left or right in the
    /// direction of motion, seen from above. Does nothing during a stroke. @return why it is not possible; empty: it
    /// begins
    QString repeat(Repetition how);
    bool canRepeat() const noexcept { return stroke_ == Stroke::none && memory_.last().places.size() > 1; }
    /// The newest stroke was undone or redone: lines and repetitions continue from the stroke that is now the last.
    void strokeTakenBack(bool undo);

    StrokeLock lock() const noexcept { return lock_; }
    /// Whether the pen that moved last is tilted so far that its user may expect the tool to lean.
    bool penLeans() const noexcept;
    /// Describes the effect of Esc, one sentence.
    QString escapeMeaning() override;
    /// Preview of strokes to come, mm, setup frame: the trail that the tool has still to follow, and the line or rows
    /// that a release would cut.
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
    void depthChanged(double offset); ///< mm along the axis, added by the wheel
    void stateChanged();              ///< lock, plans or the meaning of Esc
    void refused(const QString& sentence);
    /// Tip position to which a press would lead, mm, setup frame, without the reaction force; empty: none.
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
    QString cutPlan(const DrawnStroke& stroke, double speed);
    void notePen(const ViewportEvent& event);
    bool erases() const noexcept { return pen_ && pen_->eraser; }
    double fullDepth() const noexcept;
    void beginPressure();
    void followPressure();
    void sink();
    void retract(const Sight& sight);
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
    QTimer settling_, sinking_;
    QElapsedTimer sinkClock_;
    std::optional<PenState> pen_; ///< of the newest event
    double raised_ = 0.0;         ///< mm by which the pen keeps the tip above the full depth of its stroke
    Stroke stroke_ = Stroke::none;
    Drawing drawing_ = Drawing::none;
    ViewportEvent pressed_;                ///< the press that began the drawing
    glm::dvec3 corner_{0.0}, across_{0.0}; ///< mm, start of the drawing and position of the pointer
    StrokeMemory memory_;
    std::uint64_t begunBefore_ = 0; ///< strokes of the stylus that were not made by this tool
    StrokeLock lock_ = StrokeLock::none;
    glm::dvec3 lockAnchor_{0.0}, lockDirection_{1.0, 0.0, 0.0}; ///< mm; unit
    glm::dvec3 target_;                                         ///< mm, requested last
    double wantedHeight_ = 0.0;           ///< mm, z requested for hovering; the clearance may raise it
    std::optional<double> surfaceHeight_; ///< mm, z of the last surface under the pointer
    double pointedHeight_ = 0.0;          ///< mm, z of the plane in which the pointer draws a stroke: that of its start
    double levelHeight_ = 0.0;            ///< mm, z of the stroke without the wheel's offset
    std::optional<glm::dvec3> strokeEnd_; ///< mm, of the last stroke, while the tool may be on its way there
    bool aimShown_ = false;               ///< a position was emitted by `pressAimed` last
    double wheelOffset_ = 0.0;            ///< mm along the axis
    Sight lastSight_;                     ///< after the fine pointer
    glm::dvec3 lookingAlong_{0.0, 0.0, -1.0};
};

} // namespace burin
