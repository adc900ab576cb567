// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/simulated_stylus.h"
#include "core/job/switched_off.h"
#include "ui/workbench/hand_device.h"
#include "ui/workbench/session_runner.h"
#include "ui/workbench/session_traces.h"
#include "ui/workbench/stylus_controller.h"
#include "ui/workbench/workpiece_controller.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>

namespace burin {

/// Milling by hand: mill mode with the mouse or a device as stylus, recordings, undone strokes, the allowance. The
/// first button of a device turns the spindle on, and starts a recording if none is running.
class MillController final : public Controller {
    Q_OBJECT
public:
    MillController(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session, StylusController& styluses,
                   QObject* parent);

    bool active() const noexcept { return active_; } ///< mill mode
    /// The stylus moved by the pointer; null outside mill mode and with a device. Owned by the session.
    SimulatedStylus* stylus() const noexcept { return mouse_; }
    /// The device in use; empty outside mill mode and with the mouse.
    const std::optional<HandDevice>& device() const noexcept { return device_; }
    bool recording() const noexcept { return session_.running() && session_.state().recording; }
    /// Whether a recording is running in which nothing was milled yet.
    bool recordsNothingYet() const noexcept { return recording() && recorded_ != 0; }
    double allowance() const noexcept { return allowance_; } ///< mm
    /// All takes except those whose strokes were all undone; redo restores those.
    const std::vector<TakeInfo>& takes() const noexcept { return standing_; }
    /// Including those with all strokes undone
    const std::vector<TakeInfo>& allTakes() const noexcept { return takes_; }
    std::size_t strokesOf(std::int64_t take) const; ///< number of strokes in effect
    /// The newest stroke in effect of each take that was milled since the project was opened, as a number that is
    /// unique among strokes.
    std::map<std::int64_t, std::uint64_t> newestStrokes() const;

    using Then = std::function<void()>;
    void enter();
    void leave(Then then = {});
    /// Ends the session for a moment; mill mode continues afterwards as before.
    void interrupt(std::function<void()> meanwhile);
    /// Enters mill mode if it is off. @return true if it starts, to be confirmed by `recordingBegan`; false if one is
    /// running
    bool startRecording();
    void stopRecording(Then then = {});
    void setAllowance(double millimetres);                                  ///< an entry of the undo stack
    void showAllowance(double millimetres) { applyAllowance(millimetres); } ///< no entry of the undo stack
    /// Sets the dead man's buttons, one bit each: forces only while one of them is held; 0: always. With a device in
    /// use, mill mode is restarted, as the change must not be felt in the middle of a stroke.
    void setForceButtons(std::uint32_t buttons);
    std::uint32_t forceButtons() const noexcept { return forceButtons_; }
    /// How much of the cutting a device lets the hand feel, from the next session on.
    void setFelt(const FeltCutting& felt) { felt_ = felt; }
    const FeltCutting& felt() const noexcept { return felt_; }
    /// Limits the gains of a device, from the next session on.
    void setGains(const GainLimits& gains) { gains_ = gains; }
    const GainLimits& gains() const noexcept { return gains_; }
    /// Records the sessions of mill mode as traces, from the next one on; mill mode that is on is restarted for it. The
    /// first one is written to `file`, replacing it; the following ones to files next to it with a number, none of
    /// which existed. Each is complete, with its name, when its session has ended. @param file empty: none is recorded
    void setTrace(const std::filesystem::path& file);
    const std::filesystem::path& trace() const noexcept { return traces_.chosen(); }
    const StockLayer& stockLayer() const noexcept { return stock_; }
    /// Whether, and how far, shank and holder keep away from the stock. Another distance restarts mill mode.
    void setStockLayer(const StockLayer& layer);
    void removeTake(std::int64_t id); ///< an entry of the undo stack; the workpiece is recomputed without the take
    using RequestedOff = std::function<Result<SwitchedOff>(const Project& project)>;
    /// An entry of the undo stack, unless nothing is to be changed; the workpiece is updated in the background.
    /// @param title of the entry
    /// @param wanted called on the project's thread; returns what is to be switched off in each take that it names
    /// @param then called when the project has stored it and the update of the workpiece begins
    void setSwitchedOff(const QString& title, RequestedOff wanted, Then then = {});
    void nameTake(std::int64_t id, const QString& name); ///< an entry of the undo stack
    /// The take that actions on one take apply to; 0: none. State of the user interface only, never saved.
    std::int64_t chosenTake() const noexcept;
    void chooseTake(std::int64_t id);
    /// Whether takes are being moved or copied: the undo stack gets its entry when that is done.
    bool changingTakes() const noexcept { return changesUnderWay_ != 0; }
    /// Whether a take can be swapped with its neighbour; false during a recording and while takes are changing. @param
    /// by -1: earlier; 1: later
    bool canMove(std::int64_t take, int by) const noexcept;
    /// Whether it can be copied, or moved to any position; false during a recording and while takes are changing.
    bool canCopy(std::int64_t take) const noexcept;
    // Entries of the undo stack that leave the workpiece unchanged.
    void moveTake(std::int64_t id, int by);                    ///< @param by as in canMove
    void moveTakeBefore(std::int64_t id, std::int64_t before); ///< @param before another take; none of them: to the end
    void duplicateTake(std::int64_t id);                       ///< the copy is appended and chosen

    /// Loads the takes of a project.
    void load(std::vector<TakeInfo> takes);
    void setStrokes(std::map<std::int64_t, std::size_t> strokes);
    /// Reads the list of recordings again. @param then called when it is known
    void refreshTakes(Then then = {});

signals:
    void entered();
    void left();
    void recordingBegan(bool well);         ///< after startRecording
    void traceWritten(const QString& file); ///< the trace of a session is complete
    void strokeTakenBack(bool undo);        ///< the newest one; false: it was redone
    void takesChanged();                    ///< recordings were added or removed, or strokes of them undone
    /// A recording without strokes is undone or redone.
    void takeUndone(qint64 take, bool undo);

private:
    /// A stroke of a take.
    struct StrokePlace {
        std::int64_t take = 0;
        SampleRange samples;
    };
    void takeBack(const StrokePlace& stroke, bool undo);
    void takeBackInProject(const StrokePlace& stroke, bool undo);
    void tookBack(std::int64_t take, bool undo);
    void changeTake(std::int64_t id, bool remove, const Then& then);
    std::optional<std::size_t> placeOf(std::int64_t take) const noexcept; ///< index in allTakes
    void countChanges(int by);
    void reorder(std::function<Result<TakeOrder>(const Project& project)> wanted);
    void applyOrder(const TakeOrder& order);
    void showCopy(std::int64_t id, bool shown);
    void applySwitchedOff(const SwitchedOff& off, const Then& then);
    void noteStrokes();
    void noteRecording();
    void moveStroke(std::int64_t take, bool undo);
    void sortOut();
    void applyAllowance(double millimetres);
    void enterWithMouse();
    void enterWithDevice();
    void begin(AnyStylus stylus, SimulatedStylus* mouse, const SessionRequest& request);
    void begun(bool well, SimulatedStylus* mouse);
    bool outdated() const;
    void noteLeft();
    void followButton();

    WorkpieceController& workpiece_;
    SessionRunner& session_;
    StylusController& styluses_;
    SimulatedStylus* mouse_ = nullptr;
    bool active_ = false, buttonDown_ = false, entering_ = false, startingRecording_ = false,
         recordOnceEntered_ = false;
    bool recordingSince_ = false; ///< a recording was begun; the session's state may not show it yet
    std::optional<HandDevice> device_;
    FeltCutting felt_;
    GainLimits gains_;
    SessionTraces traces_;
    SessionRequest requested_; ///< of the session that is running, or about to begin
    StockLayer stock_{StockLayer::usualDistance, false};
    std::uint32_t forceButtons_ = 0;
    double allowance_ = 0.0;
    std::vector<TakeInfo> takes_;    ///< all of the project
    std::vector<TakeInfo> standing_; ///< the takes that have strokes, or may still get some
    std::int64_t chosen_ = 0;        ///< may no longer exist
    int changesUnderWay_ = 0;        ///< of the order of takes and copies, that the project has yet to answer
    std::uint64_t strokesSeen_ = 0;
    std::int64_t recorded_ = 0; ///< the newest recording, until it has an entry of the undo stack; 0: none
    bool takeAwaited_ = false;  ///< a recording was begun, whose take is not known yet
    std::map<std::int64_t, std::size_t> strokes_;
    std::map<std::int64_t, std::vector<std::uint64_t>> numbers_; ///< of strokes in effect, ascending
    std::vector<std::uint64_t> undoneNumbers_;                   ///< the one to redo first comes last
};

} // namespace burin
