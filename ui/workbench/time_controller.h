// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_time.h"
#include "core/job/recorded_time.h"
#include "core/job/workpiece_in_time.h"
#include "core/path/edit_values.h"
#include "ui/workbench/mill_controller.h"

#include <QElapsedTimer>
#include <QTimer>

#include <set>
#include <string>

namespace burin {

/// The state at a moment of the recordings.
struct MomentView {
    TakeMoment moment;
    VolumeSnapshot workpiece;
    std::optional<Sample> sample; ///< the last one before it; empty if not read yet
    Tool tool;                    ///< of its take
};

/// Shows the state at any moment of the recordings of the setup in use, or of a program: by position, forwards and
/// backwards, or in play. The workpiece being milled is not changed; that of the past is computed separately, in the
/// background. While one moment is being computed only the newest request waits; those in between are skipped. Ends
/// when a session begins or the workpiece changes.
class TimeController final : public Controller {
    Q_OBJECT
public:
    TimeController(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session, MillController& mill,
                   QObject* parent);

    /// Whether recordings are read: only while they are shown.
    void setFollowed(bool followed);
    /// Sets the program to show instead of the recordings; null: the recordings again.
    void showProgram(std::shared_ptr<const CheckedProgram> program);
    bool showsProgram() const noexcept { return program_ != nullptr; }
    const std::shared_ptr<const CheckedProgram>& program() const noexcept { return program_; } ///< null: none is shown
    /// Goes to the start of a line of the program, from 1, if the past is shown.
    void followLine(int line);
    /// The line of the program that is milled at the requested moment, from 1; 0: none.
    int line() const;
    /// The recordings or program motions shown, in order; null: not read yet, or none.
    const std::shared_ptr<const RecordedTime>& recorded() const noexcept { return program_ ? spread_ : recorded_; }
    /// The recordings alone, even while a program is shown; null: not read yet.
    const std::shared_ptr<const RecordedTime>& recordings() const noexcept { return recorded_; }
    /// Adds the deviation of a take to the recordings. Ignored if the take has changed since.
    /// @param samples of the take when it was computed
    void addDeviation(std::int64_t take, std::uint64_t samples, std::vector<float> values);
    bool reading() const { return program_ ? desk_.tasks.running(TaskKind::programTime) : reading_; }
    /// Whether there are recordings and no session is running.
    bool possible() const;

    bool away() const noexcept { return away_; }         ///< whether a moment of the past is requested or shown
    double seconds() const noexcept { return seconds_; } ///< the requested moment, s from the start of the first take
    const std::optional<MomentView>& shown() const noexcept { return shown_; } ///< empty: the present
    bool arriving() const { return desk_.tasks.running(TaskKind::time); }
    void goTo(double seconds);
    void goTo(const TakeMoment& moment);
    /// The requested moment of the recordings as paths name it: the tick of the last sample before it. Empty in the
    /// present and for a program.
    std::optional<Moment> handMoment() const;
    /// The tip of the tool at `handMoment`, mm, setup frame; empty while it is not read yet.
    std::optional<glm::dvec3> handTip() const;
    /// The time of a moment of a path, s from the start of the first take, when its tick is over. Empty if it belongs
    /// to none of the takes that were read.
    std::optional<double> secondsAt(const Moment& moment) const;
    /// Goes to a moment of a path, if it belongs to a take that was read and no program is shown.
    void goTo(const Moment& moment);
    /// The same if the past is shown.
    void followPath(const Moment& moment);
    /// Shows the workpiece being milled again.
    void backToPresent();

    /// An entry of the undo stack. A part that is switched off has no effect until it is switched on again, which mills
    /// it on top of the present workpiece.
    void switchInterval(std::int64_t take, const SampleRange& interval, bool on);
    /// Continues milling from the moment that is shown: everything after it is switched off, and a recording starts as
    /// soon as the workpiece is in the state of that moment.
    void punchIn();

    /// Of the recordings, in order.
    const std::vector<TimeMarker>& markers() const noexcept { return markers_; }
    /// The program that is shown, with its times; null: none, or not read yet. Play stops at its findings and at
    /// breakpoints.
    const std::shared_ptr<const ProgramTime>& programTime() const noexcept { return programTime_; }
    /// Lines of the program that is shown, from 1, before which play stops. Those whose text is unchanged are kept for
    /// the next program.
    const std::set<int>& breakpoints() const noexcept { return breakpoints_; }
    void toggleBreakpoint(int line);
    /// Marks the requested moment; if it is marked already, renames the marker. An entry of the undo stack.
    void addMarker(const QString& name);
    /// @param marker index in `markers` @param name empty: removes it. An entry of the undo stack.
    void changeMarker(std::size_t marker, const QString& name);

    bool playing() const noexcept { return play_.isActive(); }
    double speed() const noexcept { return speed_; }
    /// From the requested moment, or from the start if that is the end.
    void play();
    void pause();
    void setSpeed(double speed) { speed_ = speed; }
    /// Discards what was read: the project or setup is another one.
    void forget();

signals:
    void momentChanged();   ///< `shown` has changed
    void recordedChanged(); ///< `recorded` has changed
    void breakpointsChanged();

private:
    /// Effects of the recordings; used on the thread that computes a moment, one at a time.
    struct Source;
    void stale();
    void read();
    void adopt(RecordedTime time);
    void arrive();
    void show(const TakeMoment& moment, const VolumeSnapshot& workpiece);
    void readSample(const TakeMoment& moment);
    void keepWorthKeeping();
    void keepInProject(KeptWorkpiece kept, const RecordedState& state);
    void spread();
    std::optional<double> stopWithin(double from, double to) const;
    void keepBreakpoints(const std::string& before);
    const std::shared_ptr<Source>& source() const noexcept { return program_ ? programSource_ : source_; }
    void tick();
    void recordFromHere();
    void setMarkers(const QString& title, std::vector<TimeMarker> markers);
    std::optional<Tool> toolOf(std::int64_t take) const;

    WorkpieceController& workpiece_;
    SessionRunner& session_;
    MillController& mill_;
    std::shared_ptr<const RecordedTime> recorded_;
    std::shared_ptr<Source> source_;
    std::shared_ptr<const CheckedProgram> program_; ///< null: the recordings are shown
    std::shared_ptr<const ProgramTime> programTime_;
    std::shared_ptr<const RecordedTime> spread_; ///< of the program
    std::shared_ptr<Source> programSource_;
    bool followed_ = false, stale_ = true, reading_ = false, away_ = false, recordWhenReady_ = false;
    quint64 generation_ = 0; ///< counts `forget` and reads
    double seconds_ = 0.0;
    std::optional<TakeMoment> wanted_; ///< requested, computing not begun yet
    std::optional<MomentView> shown_;
    std::vector<TimeMarker> markers_;
    std::set<int> breakpoints_;
    std::string lastText_; ///< of the program that was shown last
    double speed_ = 1.0;
    QTimer play_, readSoon_;
    QElapsedTimer clock_, onItsWay_;
};

} // namespace burin
