// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QString>

#include <chrono>
#include <vector>

namespace burin::testing {

/// An application that measures how long its thread stays away from the event loop: from the first event that is
/// handled until the loop, or that of a dialog within it, looks for new ones. This includes posted events, timers and
/// painting.
class StallWatch final : public QApplication {
public:
    using Clock = std::chrono::steady_clock;
    struct Stall {
        double milliseconds = 0.0;
        double rendering = 0.0; ///< ms of it spent rendering the view
        double processor = 0.0; ///< ms of it in which the thread itself computed: not affected by other programs
        double after = 0.0;     ///< s since the phase began
        QString what;           ///< the event that took longest, and the events that it caused
    };

    StallWatch(int& argc, char** argv);

    void beginPhase();
    const std::vector<Stall>& worst() const { return worst_; } ///< of the phase, longest first
    Stall longest() const { return worst_.empty() ? Stall{} : worst_.front(); }
    std::size_t longerThan(double milliseconds) const;
    /// Processor time of this thread for rendering the view once, ms, the mean of the phase. It is the whole time if
    /// software renders in this thread (LP_NUM_THREADS=0), and not affected by other programs.
    double processorPerRendering() const { return renderings_ > 0 ? renderingProcessor_ / renderings_ : 0.0; }

    bool notify(QObject* receiver, QEvent* event) override;

private:
    struct Handled {
        int depth = 0;
        const char* receiver = "";
        int type = 0;
        double milliseconds = 0.0;
    };
    void cameBack();
    QString longestChain() const;

    static constexpr std::size_t kept = 5;
    int depth_ = 0;
    bool away_ = false;
    Clock::time_point left_, phase_;
    double processorLeft_ = 0.0, rendering_ = 0.0; ///< ms: when the loop was left, and since then
    double renderingProcessor_ = 0.0;              ///< ms, of the phase
    int renderings_ = 0;
    std::vector<Handled> handled_; ///< since the loop was left; an event follows those that were handled within it
    std::vector<double> all_;
    std::vector<Stall> worst_;
};

} // namespace burin::testing
