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

/// The workpiece that is milled: embeds the part in its stock, cuts again what recordings cut, and keeps the bounds of
/// the tool in force. Both are made in the background; what stood before stays in force meanwhile.
class WorkpieceController final : public Controller {
    Q_OBJECT
public:
    using Controller::Controller;

    /// Largest allowance that fields are made for, mm.
    static constexpr double maximumAllowance = 2.0;

    /// What embedding will take. A workpiece that no longer fits stays until the next `embed`.
    /// @param materials looked through by id before the library
    void setWanted(std::shared_ptr<const Model> model, const Setup& setup, const std::vector<Property>& materials,
                   const Tool& tool);
    /// The machine that it is milled for: its feeds and speeds, and where its travel lies.
    void setWanted(const MachineProfile& machine);
    /// What bounds the tool besides the part.
    void setWanted(const WantedBounds& bounds);
    bool hasModel() const noexcept { return model_ != nullptr; }
    const Box& wantedStock() const noexcept { return setup_.stock; } ///< mm, setup frame
    bool embedded() const;                                           ///< the workpiece matches the settings
    bool embedding() const { return reading_ || desk_.tasks.running(TaskKind::embedding); }
    bool fieldBusy() const { return desk_.tasks.running(TaskKind::field); }
    bool ready() const; ///< it can be milled: workpiece and bounds are there
    /// There are none and none are being made: that failed, or was cancelled.
    bool lacksBounds() const { return embedded() && !bounds_ && !fieldBusy() && !changing(); }

    /// It is about to change: nothing may begin to read it.
    bool changing() const noexcept { return changes_ > 0; }

    /// Makes the workpiece anew: embeds, then replays the project's recordings.
    void embed();
    /// Makes what was embedded anew from the recordings, which count otherwise than they did: from what is kept of
    /// them.
    void remake();
    void clear();

    bool exporting() const { return desk_.tasks.running(TaskKind::exporting); }
    /// Writes it as it stands by the suffix (core/exchange/volume_output.h), in the background.
    void exportTo(const std::filesystem::path& file);

    /// Shared with what reads it in the background. While a session runs the workpiece is the session's.
    const std::shared_ptr<MillingContext>& milling() const noexcept { return milling_; }
    const std::shared_ptr<const ToolBounds>& bounds() const noexcept { return bounds_; }
    /// What `bounds` were made of.
    const WantedBounds& bound() const noexcept { return bound_; }
    /// The part's clearance over tips, of `bounds`; null: there are none, or the axis is free.
    std::shared_ptr<const ClearanceField> field() const;
    /// All of the field is there; where it still grows it says too little away from the tool.
    bool fieldComplete() const { return bounds_ && bounds_->complete(); }
    StrokeHistory& strokes() noexcept { return strokes_; }

    /// Asked before workpiece, tool or field change: whoever mills lets go of them and then calls what it is given.
    void setGuard(std::function<void(std::function<void()>)> guard) { guard_ = std::move(guard); }

signals:
    void workpieceChanged(); ///< outside a session
    void exported(const QString& file);
    void toolChanged();         ///< the tool in force
    void surroundingsChanged(); ///< the requested obstacles or position of the travel
    void machineChanged();      ///< the requested one
    void readersStop();         ///< the workpiece is about to change: work in the background that reads it is abandoned
    void readersGoOn();         ///< it has changed: what was abandoned can be done again
    /// The workpiece was made anew with these recordings: how many strokes stand in each.
    void replayed(const std::map<std::int64_t, std::size_t>& strokes);

private:
    void changeMaterials();
    bool otherMaterials() const;
    void changeZero();
    bool otherZero() const;
    /// @param fromKept false: what was kept could not be read
    void readWork(void (WorkpieceController::*then)(const RecordedWork&), bool fromKept = true);
    void embedWith(const RecordedWork& work);
    void remakeWith(const RecordedWork& work);
    void adopt(std::shared_ptr<MillingContext> milling);
    void buildBounds();
    void adoptBounds(const Tool& tool, const WantedBounds& wanted, std::shared_ptr<const ToolBounds> bounds);
    void watchGrowth();
    void switchObstacles();
    void stopReaders(std::function<void()> then); ///< `then` ends with `goOn`
    void goOn();
    void letGo(std::function<void()> then); ///< of the workpiece, whoever mills it too

    std::shared_ptr<const Model> model_;
    Setup setup_;
    std::vector<Property> materials_;
    Tool tool_;
    MachineProfile machine_;
    std::shared_ptr<MillingContext> milling_;
    std::shared_ptr<const ToolBounds> bounds_;
    WantedBounds wanted_, bound_;
    StrokeHistory strokes_;
    std::function<void(std::function<void()>)> guard_;
    int changes_ = 0;        ///< that are about to come
    bool reading_ = false;   ///< the takes are being read
    quint64 generation_ = 0; ///< counts clear: what was begun before belongs to another project or setup
};

} // namespace burin
