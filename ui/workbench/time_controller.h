// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_time.h"
#include "core/job/recorded_time.h"
#include "core/job/workpiece_in_time.h"
#include "ui/workbench/mill_controller.h"

#include <QElapsedTimer>
#include <QTimer>

#include <set>
#include <string>

namespace burin {

/// What stood there at a moment of the recordings.
struct MomentView {
    TakeMoment moment;
    VolumeSnapshot workpiece;
    std::optional<Sample> sample; ///< the last one before it; nothing: it is not read yet
    Tool tool;                    ///< of its take
};

/// Goes through the recordings of the setup in use, or through a program: to any moment, forwards and backwards, or
/// along with a clock. The
/// workpiece that is milled stays as it is; what stood there is made beside it, in the background. While one moment is
/// on its way the newest wish waits, and those in between are left out. Ends where a session begins, and where the
/// workpiece becomes another.
class TimeController final : public Controller {
    Q_OBJECT
public:
    TimeController(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session, MillController& mill,
                   QObject* parent);

    /// Reads recordings as long as somebody looks at them.
    void setFollowed(bool followed);
    /// The program to go through in the recordings' stead; null: the recordings again.
    void showProgram(std::shared_ptr<const CheckedProgram> program);
    bool showsProgram() const noexcept { return program_ != nullptr; }
    const std::shared_ptr<const CheckedProgram>& program() const noexcept { return program_; } ///< null: none is shown
    /// Goes where a line of the program begins, from 1, if the past is shown.
    void followLine(int line);
    /// The line of the program that is milled at the moment that is wanted, from 1; 0: there is none.
    int line() const;
    /// What is gone through, in order; null: not read yet, or none.
    const std::shared_ptr<const RecordedTime>& recorded() const noexcept { return program_ ? spread_ : recorded_; }
    bool reading() const { return program_ ? desk_.tasks.running(TaskKind::programTime) : reading_; }
    /// It can be gone through: there are recordings, and nobody mills.
    bool possible() const;

    bool away() const noexcept { return away_; }         ///< in the past, wanted or there
    double seconds() const noexcept { return seconds_; } ///< s from the first take's start: what is wanted
    const std::optional<MomentView>& shown() const noexcept { return shown_; } ///< nothing: the present
    bool arriving() const { return desk_.tasks.running(TaskKind::time); }
    void goTo(double seconds);
    void goTo(const TakeMoment& moment);
    /// Shows the workpiece that is milled again.
    void backToPresent();

    /// An entry of the undo stack. What is switched off counts no more, until it is switched on again: that mills it on
    /// top of what is there.
    void switchStretch(std::int64_t take, const SampleRange& stretch, bool on);
    /// Mills on from the moment that is shown: what came after it is switched off, and a recording begins as soon as
    /// the workpiece is as it was then.
    void punchIn();

    /// Of the recordings, in order.
    const std::vector<TimeMarker>& markers() const noexcept { return markers_; }
    /// The program that is gone through, as it lies in time; null: none, or not read yet. A play stops at its findings
    /// and at breakpoints.
    const std::shared_ptr<const ProgramTime>& programTime() const noexcept { return programTime_; }
    /// Lines of the program that is gone through, from 1, before which a play stops. Those whose text stays the same
    /// outlast another program.
    const std::set<int>& breakpoints() const noexcept { return breakpoints_; }
    void toggleBreakpoint(int line);
    /// Marks the moment that is wanted; one that is marked already gets the name. An entry of the undo stack.
    void addMarker(const QString& name);
    /// @param marker its place in `markers` @param name empty: it goes. An entry of the undo stack.
    void changeMarker(std::size_t marker, const QString& name);

    bool playing() const noexcept { return play_.isActive(); }
    double speed() const noexcept { return speed_; }
    /// From the moment that is wanted, or from the start where that is the end.
    void play();
    void pause();
    void setSpeed(double speed) { speed_ = speed; }
    /// What was read belongs to another project or setup.
    void forget();

signals:
    void momentChanged();   ///< `shown` is another one
    void recordedChanged(); ///< `recorded` is another one
    void breakpointsChanged();

private:
    /// What recordings did, on whichever thread goes to a moment; one at a time.
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
    std::map<std::int64_t, std::size_t> strokesBefore(const TakeMoment& moment) const;
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
    std::shared_ptr<const RecordedTime> spread_; ///< of it
    std::shared_ptr<Source> programSource_;
    bool followed_ = false, stale_ = true, reading_ = false, away_ = false, recordWhenReady_ = false;
    quint64 generation_ = 0; ///< counts `forget`, and what was read
    double seconds_ = 0.0;
    std::optional<TakeMoment> wanted_; ///< that is not on its way yet
    std::optional<MomentView> shown_;
    std::vector<TimeMarker> markers_;
    std::set<int> breakpoints_;
    std::string lastText_; ///< of the program that was shown last
    double speed_ = 1.0;
    QTimer play_, readSoon_;
    QElapsedTimer clock_, onItsWay_;
};

} // namespace burin
