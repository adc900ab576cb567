// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/simulated_stylus.h"
#include "core/job/switched_off.h"
#include "ui/workbench/session_runner.h"
#include "ui/workbench/stylus_controller.h"
#include "ui/workbench/workpiece_controller.h"

#include <map>
#include <optional>

namespace burin {

/// Milling by hand: mill mode with the mouse or a device as stylus, recordings, strokes taken back, the allowance. With
/// a device its first button turns the spindle, and begins a recording where none runs.
class MillController final : public Controller {
    Q_OBJECT
public:
    MillController(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session, StylusController& styluses,
                   QObject* parent);

    bool active() const noexcept { return active_; } ///< mill mode
    /// For the pointer to lead; null outside mill mode and with a device. The session owns it.
    SimulatedStylus* stylus() const noexcept { return mouse_; }
    /// Of the device in the hand, and how it was laid over the workpiece; nothing outside mill mode and with the mouse.
    const std::optional<StylusDescription>& device() const noexcept { return device_; }
    const WorkspaceMapping& mapping() const noexcept { return mapping_; }
    bool recording() const noexcept { return session_.running() && session_.state().recording; }
    double allowance() const noexcept { return allowance_; } ///< mm
    /// Those without the ones whose strokes were all taken back: redo brings these back.
    const std::vector<TakeInfo>& takes() const noexcept { return standing_; }
    const std::vector<TakeInfo>& allTakes() const noexcept { return takes_; } ///< these as well
    std::size_t strokesOf(std::int64_t take) const;                           ///< that stand
    /// The newest stroke that stands of each take that was milled since the project was opened, by a number that no
    /// other stroke has.
    std::map<std::int64_t, std::uint64_t> newestStrokes() const;

    using Then = std::function<void()>;
    void enter();
    void leave(Then then = {});
    /// For a moment without a session, after which mill mode goes on as it was.
    void interrupt(std::function<void()> meanwhile);
    /// Enters mill mode where it is not on. @return true: it runs once `recordingBegan` tells so; false: one runs
    bool startRecording();
    void stopRecording(Then then = {});
    void setAllowance(double millimetres); ///< an entry of the undo stack
    /// Dead man's: forces only while one of these buttons of a device is held, by bit; 0: always. With a device in the
    /// hand mill mode begins anew, as nobody should feel the change in the middle of a stroke.
    void setForceButtons(std::uint32_t buttons);
    /// How much of the cutting a device lets the hand feel, from the next session on.
    void setFelt(const FeltCutting& felt) { felt_ = felt; }
    void removeTake(std::int64_t id); ///< an entry of the undo stack; the workpiece is made anew without it
    using WantedOff = std::function<Result<SwitchedOff>(const Project& project)>;
    /// An entry of the undo stack, unless nothing is to be changed; the workpiece follows in the background.
    /// @param title of the entry @param wanted on the project's thread: what is to be off of each take that it names
    /// @param then when the project has it and the workpiece begins to follow
    void setSwitchedOff(const QString& title, WantedOff wanted, Then then = {});
    void nameTake(std::int64_t id, const QString& name); ///< an entry of the undo stack

    /// What a project holds.
    void load(std::vector<TakeInfo> takes);
    void setStrokes(std::map<std::int64_t, std::size_t> strokes);
    /// Reads the list of recordings again. @param then when it is known
    void refreshTakes(Then then = {});

signals:
    void entered();
    void left();
    void recordingBegan(bool well);  ///< after startRecording
    void strokeTakenBack(bool undo); ///< the newest one; false: it was put back
    void takesChanged();             ///< recordings came, went, or strokes of them were taken back

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
    void applySwitchedOff(const SwitchedOff& off, const Then& then);
    void noteStrokes();
    void moveStroke(std::int64_t take, bool undo);
    void sortOut();
    void applyAllowance(double millimetres);
    void enterWithMouse();
    void enterWithDevice();
    void begin(AnyStylus stylus, SimulatedStylus* mouse, const SessionRequest& request);
    void begun(bool well, SimulatedStylus* mouse);
    void noteLeft();
    void followButton();

    WorkpieceController& workpiece_;
    SessionRunner& session_;
    StylusController& styluses_;
    SimulatedStylus* mouse_ = nullptr;
    bool active_ = false, buttonDown_ = false, entering_ = false, startingRecording_ = false,
         recordOnceEntered_ = false;
    bool recordingSince_ = false; ///< it was begun; the session's state may not tell yet
    std::optional<StylusDescription> device_;
    WorkspaceMapping mapping_;
    FeltCutting felt_;
    std::uint32_t forceButtons_ = 0;
    double allowance_ = 0.0;
    std::vector<TakeInfo> takes_;    ///< all of the project
    std::vector<TakeInfo> standing_; ///< of these, the ones that have strokes, or may yet
    std::uint64_t strokesSeen_ = 0;
    std::map<std::int64_t, std::size_t> strokes_;
    std::map<std::int64_t, std::vector<std::uint64_t>> numbers_; ///< of strokes that stand, rising
    std::vector<std::uint64_t> undoneNumbers_;                   ///< the one that is redone first last
};

} // namespace burin
