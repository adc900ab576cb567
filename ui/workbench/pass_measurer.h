// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/pass_figures.h"
#include "ui/workbench/path_controller.h"

#include <memory>
#include <vector>

namespace burin {

/// Measures what the passes of the path in force do to the stock and leave on the part, on request, in the background.
class PassMeasurer final : public Controller {
    Q_OBJECT
public:
    PassMeasurer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path, QObject* parent);

    /// The path in force has passes, and is evaluated as it is.
    bool possible() const;
    /// Nothing happens where it is not possible. Can be cancelled as a task.
    void measure();
    void forget(); ///< another project
    bool busy() const noexcept { return busy_; }
    /// Of the path in force, as it was evaluated last; empty: not measured.
    std::vector<PassFigures> figures() const;

private:
    void run(FigureMatter matter);
    void end();

    const WorkpieceController& workpiece_;
    const PathController& path_;
    std::shared_ptr<const EvaluatedPath> measured_; ///< what the figures are of
    std::vector<PassFigures> figures_;
    bool busy_ = false;
    quint64 questions_ = 0;
};

} // namespace burin
