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

/// Inspects what a program leaves on each face of the part, in the background. The faces of the part are cached, so
/// that inspecting another program or tolerance takes less time.
class FaceController final : public Controller {
    Q_OBJECT
public:
    using Controller::Controller;

    /// Does nothing if the last request was the same, whatever its outcome. @param part the part that the deviations of
    /// the program refer to
    void inspect(const std::shared_ptr<const CheckedProgram>& program, const std::shared_ptr<const Model>& part,
                 const DeviationTolerance& tolerance);
    void stop();   ///< ends the inspection and discards its result; the faces of the part stay cached
    void forget(); ///< as `stop`, and also discards the cached faces
    bool busy() const { return desk_.tasks.running(TaskKind::faces); }
    /// Progress of the running inspection, 0 … 1
    double fraction() const { return desk_.tasks.fraction(TaskKind::faces); }
    /// The worst first; null if there was no inspection or it has not finished.
    std::shared_ptr<const std::vector<FaceQuality>> faces() const noexcept { return faces_; }
    const std::optional<Error>& problem() const noexcept { return problem_; } ///< why there are no faces

private:
    using Patches = std::shared_ptr<const std::vector<PartFacePatch>>;
    struct Inspected {
        Patches patches;
        std::shared_ptr<const std::vector<FaceQuality>> faces;
    };
    static Result<Inspected> inspected(Patches patches, const CheckedProgram& program, const Model& part,
                                       const DeviationTolerance& tolerance, Progress& progress);
    void take(const Result<Inspected>& outcome);

    std::shared_ptr<const CheckedProgram> program_; ///< of the last request
    std::shared_ptr<const Model> part_;
    DeviationTolerance tolerance_;
    Patches patches_; ///< of `part_`; null if not known
    std::shared_ptr<const std::vector<FaceQuality>> faces_;
    std::optional<Error> problem_;
};

} // namespace burin
