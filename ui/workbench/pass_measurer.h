// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/pass_figures.h"
#include "ui/workbench/path_controller.h"

#include <memory>
#include <vector>

namespace burin {

/// Computes on request how the passes of the path in force change the stock and what they leave on the part, in the
/// background.
class PassMeasurer final : public Controller {
    Q_OBJECT
public:
    PassMeasurer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path, QObject* parent);

    /// Whether the path in force has passes and its evaluation is up to date.
    bool possible() const;
    /// Does nothing unless `possible`. Can be cancelled as a task.
    void measure();
    void forget(); ///< another project
    bool busy() const noexcept { return busy_; }
    /// Of the path in force as last evaluated; empty if not measured.
    std::vector<PassFigures> figures() const;

private:
    void run(FigureMatter matter);
    void end();

    const WorkpieceController& workpiece_;
    const PathController& path_;
    std::shared_ptr<const EvaluatedPath> measured_; ///< to which `figures_` belong
    std::vector<PassFigures> figures_;
    bool busy_ = false;
    quint64 questions_ = 0;
};

} // namespace burin
