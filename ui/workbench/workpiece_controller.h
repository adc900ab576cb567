// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/recorded_cuts.h"
#include "core/job/stroke_history.h"
#include "core/job/tool_bounds.h"
#include "ui/workbench/controller.h"
#include "ui/workbench/surroundings.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>

namespace burin {

/// The workpiece being milled: embeds the part in its stock, replays the cuts of recordings, and keeps the bounds of
/// the tool in force. Both are computed in the background; the previous ones stay in force meanwhile.
class WorkpieceController final : public Controller {
    Q_OBJECT
public:
    using Controller::Controller;

    /// Largest allowance for which fields are made, mm.
    static constexpr double maximumAllowance = 2.0;

    /// Sets the input of embedding. A workpiece that no longer matches is kept until the next `embed`.
    /// @param materials searched by id before the library
    void setRequested(std::shared_ptr<const Model> model, const Setup& setup, const std::vector<Property>& materials,
                      const Tool& tool);
    /// Sets the machine that it is milled for: its feeds and speeds, and the position of its travel.
    void setRequested(const MachineProfile& machine);
    /// Sets the bounds of the tool besides the part.
    void setRequested(const RequestedBounds& bounds);
    bool hasModel() const noexcept { return model_ != nullptr; }
    const Box& wantedStock() const noexcept { return setup_.stock; } ///< mm, setup frame
    bool embedded() const;                                           ///< whether the workpiece matches the settings
    bool embedding() const { return reading_ || desk_.tasks.running(TaskKind::embedding); }
    bool fieldBusy() const { return desk_.tasks.running(TaskKind::field); }
    bool ready() const; ///< whether it can be milled: workpiece and bounds exist
    /// Makes the stock before milling one of the bounds' layers (ToolBounds::addStock), in the background. Any stock
    /// but one from a file is one from the start. @param refused called if that fails or is cancelled
    void bringStock(std::function<void()> refused);
    /// Whether the stock is no layer of the bounds, but `bringStock` makes it one.
    bool canBringStock() const;
    /// Whether there are no bounds and none are being made, because that failed or was cancelled.
    bool lacksBounds() const { return embedded() && !bounds_ && !fieldBusy() && !changing(); }

    /// Whether it is about to change: no new reader may start.
    bool changing() const noexcept { return changes_ > 0; }

    /// Recomputes the workpiece: embeds, then replays the project's recordings.
    void embed();
    /// Recomputes the embedded workpiece after what counts of the recordings has changed, starting from stored states.
    /// If it is being embedded, that begins again.
    void remake();
    void clear();

    bool exporting() const { return desk_.tasks.running(TaskKind::exporting); }
    /// Writes the present workpiece in the format of the suffix (core/exchange/volume_output.h), in the background.
    void exportTo(const std::filesystem::path& file);

    /// Shared with background readers. During a session the workpiece belongs to the session.
    const std::shared_ptr<MillingContext>& milling() const noexcept { return milling_; }
    const std::shared_ptr<const ToolBounds>& bounds() const noexcept { return bounds_; }
    /// The input from which `bounds` was made.
    const RequestedBounds& bound() const noexcept { return bound_; }
    /// The part's clearance over tip positions, from `bounds`; null if there are none or the axis is free.
    std::shared_ptr<const ClearanceField> field() const;
    /// Whether the field is complete; while it grows, its values away from the tool are too small.
    bool fieldComplete() const { return bounds_ && bounds_->complete(); }
    StrokeHistory& strokes() noexcept { return strokes_; }

    /// Sets a function called before workpiece, tool or field change: it must make milling release them and then call
    /// its argument.
    void setGuard(std::function<void(std::function<void()>)> guard) { guard_ = std::move(guard); }

signals:
    void workpieceChanged(); ///< outside a session
    void exported(const QString& file);
    void toolChanged();         ///< the tool in force
    void surroundingsChanged(); ///< the requested obstacles or position of the travel
    void machineChanged();      ///< the requested machine
    void readersStop();         ///< the workpiece is about to change: background work that reads it is abandoned
    void readersGoOn();         ///< it has changed: abandoned work can be started again
    /// The workpiece was recomputed with these recordings; the map holds the number of strokes in effect of each.
    void replayed(const std::map<std::int64_t, std::size_t>& strokes);

private:
    void changeMaterials();
    bool otherMaterials() const;
    void changeZero();
    bool otherZero() const;
    /// @param fromKept false: the stored states could not be read
    void readWork(void (WorkpieceController::*then)(const RecordedWork&), bool fromKept = true);
    void embedWith(const RecordedWork& work);
    void remakeWith(const RecordedWork& work);
    void adopt(std::shared_ptr<MillingContext> milling);
    void buildBounds();
    std::shared_ptr<const TouchableStock> touchable() const;
    void keepTouchable();
    void adoptBounds(const Tool& tool, const RequestedBounds& wanted, std::shared_ptr<const ToolBounds> bounds);
    void watchGrowth();
    void switchObstacles();
    void stopReaders(std::function<void()> then); ///< `then` must end with `goOn`
    void goOn();
    void letGo(std::function<void()> then); ///< makes milling release the workpiece

    std::shared_ptr<const Model> model_;
    Setup setup_;
    std::vector<Property> materials_;
    Tool tool_;
    MachineProfile machine_;
    std::shared_ptr<MillingContext> milling_;
    std::shared_ptr<const ToolBounds> bounds_;
    RequestedBounds wanted_, bound_;
    std::shared_ptr<const TouchableStock> touchable_; ///< the stock as it was made last
    std::shared_ptr<const Model> touchableModel_;     ///< what it was made of
    Setup touchableSetup_;
    StrokeHistory strokes_;
    std::function<void(std::function<void()>)> guard_;
    int changes_ = 0;        ///< number of changes about to come
    bool reading_ = false;   ///< the takes are being read
    quint64 generation_ = 0; ///< counts `clear`: work started before belongs to another project or setup
};

} // namespace burin
