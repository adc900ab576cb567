// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/take_score.h"
#include "ui/workbench/mill_controller.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// Scores a take of the setup in use, and a reference to compare it with, in the background.
class ScoreController final : public Controller {
    Q_OBJECT
public:
    ScoreController(const Desk& desk, const WorkpieceController& workpiece, const SessionRunner& session,
                    MillController& mill, QObject* parent);

    /// Whether there are a workpiece and a take, and no milling session is running.
    bool possible() const;
    /// Starts scoring both and discards earlier scores. @param reference 0 or equal to `take`: none
    void choose(std::int64_t take, std::int64_t reference);
    /// The same with the previous reference, or else the first other take, then emits `asked`. Does nothing if scoring
    /// is not possible. @param take 0: the newest one
    void ask(std::int64_t take);
    std::int64_t take() const noexcept { return take_; }           ///< 0: none was chosen
    std::int64_t reference() const noexcept { return reference_; } ///< 0: none
    bool busy() const noexcept { return reading_ != nullptr || desk_.tasks.running(TaskKind::score); }
    /// Progress of the running work, 0 … 1
    double fraction() const { return desk_.tasks.fraction(TaskKind::score); }
    /// The score of the take, then that of the reference if there is one. Empty if not (yet) scored.
    const std::vector<TakeScore>& scores() const noexcept { return scores_; }
    /// Ends the running work, if any, without scores.
    void cancel();
    void discard(); ///< cancels and discards the scores; the choice of takes stays
    /// Whether the timeline draws the reference behind the take.
    void setDrawn(bool drawn);
    bool drawn() const noexcept { return drawn_; }
    void forget(); ///< called for another project or setup

signals:
    void asked(); ///< the user requested a score

private:
    void run(std::vector<ScoreMatter> matters);
    void followTakes();

    const WorkpieceController& workpiece_;
    const SessionRunner& session_;
    const MillController& mill_;
    std::int64_t take_ = 0, reference_ = 0;
    std::shared_ptr<Progress> reading_; ///< of the running read; null if there is none
    std::vector<TakeScore> scores_;
    bool drawn_ = true;
};

} // namespace burin
