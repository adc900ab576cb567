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

    /// There are a workpiece and a take, and nobody mills.
    bool possible() const;
    /// Begins to score them; what was scored before is forgotten. @param reference 0, or the take: none
    void choose(std::int64_t take, std::int64_t reference);
    /// The same with the reference of before, or else the first other take; then `asked`. Nothing where it is not
    /// possible. @param take 0: the newest one
    void ask(std::int64_t take);
    std::int64_t take() const noexcept { return take_; }           ///< 0: none was chosen
    std::int64_t reference() const noexcept { return reference_; } ///< 0: none
    bool busy() const noexcept { return reading_ != nullptr || desk_.tasks.running(TaskKind::score); }
    double fraction() const; ///< of the work that runs, 0 … 1
    /// The take's, then the reference's if there is one; empty: not scored, or not yet.
    const std::vector<TakeScore>& scores() const noexcept { return scores_; }
    /// The work that runs, if any, ends without scores.
    void cancel();
    /// Whether the timeline draws the reference behind the take.
    void setDrawn(bool drawn);
    bool drawn() const noexcept { return drawn_; }
    void forget(); ///< another project or setup

signals:
    void asked(); ///< somebody wants to see a score

private:
    void run(std::vector<ScoreMatter> matters);
    void followTakes();

    const WorkpieceController& workpiece_;
    const SessionRunner& session_;
    const MillController& mill_;
    std::int64_t take_ = 0, reference_ = 0;
    std::shared_ptr<Progress> reading_; ///< of what is read now; null: nothing is
    std::vector<TakeScore> scores_;
    bool drawn_ = true;
};

} // namespace burin
