// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/face_controller.h"

#include <utility>

namespace burin {

void FaceController::inspect(const std::shared_ptr<const CheckedProgram>& program,
                             const std::shared_ptr<const Model>& part, const DeviationTolerance& tolerance) {
    if (program == program_ && part == part_ && tolerance == tolerance_ && (faces_ || problem_ || busy())) return;
    if (std::exchange(part_, part) != part) patches_.reset();
    program_ = program;
    tolerance_ = tolerance;
    faces_.reset();
    problem_.reset();
    desk_.tasks.start(
        TaskKind::faces, tr("Inspecting the faces"),
        [patches = patches_, program, part, tolerance](Progress& progress) {
            return inspected(patches, *program, *part, tolerance, progress);
        },
        [this](const Result<Inspected>& outcome) { take(outcome); });
    emit changed();
}

Result<FaceController::Inspected> FaceController::inspected(Patches patches, const CheckedProgram& program,
                                                            const Model& part, const DeviationTolerance& tolerance,
                                                            Progress& progress) {
    constexpr double meshed = 0.8; // of the total time
    if (!patches) {
        const ProgressPart first(progress, 0.0, meshed);
        Result<std::vector<PartFacePatch>> found = partFaces(part, {}, progress);
        if (!found) return std::move(found).error();
        patches = std::make_shared<const std::vector<PartFacePatch>>(std::move(*found));
    }
    const ProgressPart rest(progress, meshed, 1.0);
    Result<std::vector<FaceQuality>> faces = faceQualities(*patches, program.report.deviations, tolerance, progress);
    if (!faces) return std::move(faces).error();
    sortByQuality(*faces);
    return Inspected{std::move(patches), std::make_shared<const std::vector<FaceQuality>>(std::move(*faces))};
}

void FaceController::take(const Result<Inspected>& outcome) {
    if (outcome) {
        patches_ = outcome->patches;
        faces_ = outcome->faces;
    } else {
        problem_ = outcome.error();
    }
    emit changed();
}

void FaceController::stop() {
    if (!program_) return;
    desk_.tasks.abandon(TaskKind::faces);
    program_.reset();
    faces_.reset();
    problem_.reset();
    emit changed();
}

void FaceController::forget() {
    part_.reset();
    patches_.reset();
    stop();
}

} // namespace burin
