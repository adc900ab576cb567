// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"
#include "core/verify/face_quality.h"
#include "ui/workbench/controller.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// Inspects what a program leaves on each face of the part, in the background. What the part's faces are is kept, so
/// that another program or tolerance takes less.
class FaceController final : public Controller {
    Q_OBJECT
public:
    using Controller::Controller;

    /// Nothing where that was asked for last already, however it ended. @param part that the program's deviations are
    /// of
    void inspect(const std::shared_ptr<const CheckedProgram>& program, const std::shared_ptr<const Model>& part,
                 const DeviationTolerance& tolerance);
    void stop();   ///< nothing is inspected any more; what the part's faces are is kept
    void forget(); ///< that, too
    bool busy() const { return desk_.tasks.running(TaskKind::faces); }
    double fraction() const; ///< 0 … 1, of what is being inspected
    /// The worst first; null: none was inspected, or that is not over.
    std::shared_ptr<const std::vector<FaceQuality>> faces() const noexcept { return faces_; }
    const std::optional<Error>& problem() const noexcept { return problem_; } ///< why there are none

private:
    using Patches = std::shared_ptr<const std::vector<PartFacePatch>>;
    struct Inspected {
        Patches patches;
        std::shared_ptr<const std::vector<FaceQuality>> faces;
    };
    static Result<Inspected> inspected(Patches patches, const CheckedProgram& program, const Model& part,
                                       const DeviationTolerance& tolerance, Progress& progress);
    void take(const Result<Inspected>& outcome);

    std::shared_ptr<const CheckedProgram> program_; ///< that was asked about
    std::shared_ptr<const Model> part_;
    DeviationTolerance tolerance_;
    Patches patches_; ///< of `part_`; null: not known
    std::shared_ptr<const std::vector<FaceQuality>> faces_;
    std::optional<Error> problem_;
};

} // namespace burin
