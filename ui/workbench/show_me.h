// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling.h"
#include "ui/workbench/session_runner.h"
#include "ui/workbench/workpiece_controller.h"

namespace burin {

/// Demonstration: a virtual operator roughs and finishes the part, eight times as fast as a hand, through the same
/// session as the user's own strokes. Its recordings are kept, even when it is stopped.
class ShowMe final : public Controller {
    Q_OBJECT
public:
    ShowMe(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session, QObject* parent);

    static constexpr int timeLapse = 8;

    bool showing() const noexcept { return stage_ != Stage::none; }
    void start(); ///< requires a ready workpiece and no running session
    void stop();

signals:
    void finished(bool whole); ///< false: it was stopped

private:
    enum class Stage { none, planning, milling };
    void millNext();
    void sessionEnded();
    void endShow(bool whole);

    WorkpieceController& workpiece_;
    SessionRunner& session_;
    Stage stage_ = Stage::none;
    bool stopped_ = false;
    OperatorPlan plan_;
    std::size_t next_ = 0; ///< index of the next stage of the plan to mill
};

} // namespace burin
