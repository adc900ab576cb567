// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/parser.h"
#include "core/verify/verify.h"
#include "tests/benchmarks/scale/scale.h"
#include "tests/benchmarks/verification/relief_job.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace burin::benchmarks {

namespace {

/// A relief that is finished with an increasing number of rows: the milled length grows with the number of blocks.
class Programs {
public:
    const ReliefScene& scene(std::size_t step) {
        if (!scenes_[step]) {
            ReliefJob job;
            job.overTop = 1.1;
            job.meshCells = 128;
            job.rows = 60 << step;
            scenes_[step] = std::make_unique<ReliefScene>(job);
        }
        return *scenes_[step];
    }
    double blocks(std::size_t step) {
        const std::string& text = scene(step).text;
        return static_cast<double>(std::ranges::count(text, '\n'));
    }
    ParsedProgram parsed(std::size_t step) {
        return require(parseProgram(scene(step).text, "relief.ngc"), "a benchmark's program");
    }

private:
    std::array<std::unique_ptr<ReliefScene>, 3> scenes_;
};

} // namespace

void blockScale(Session& session) {
    Programs programs;
    const auto at = [](int step) { return static_cast<std::size_t>(step); };
    ScaledWork reading{"blocks.read"};
    reading.size = [&](int step) { return programs.blocks(at(step)); };
    reading.prepare = [&](int step) { (void)programs.scene(at(step)); };
    reading.work = [&](int step) { (void)programs.parsed(at(step)); };
    scaleFigures(session, reading);

    std::optional<ParsedProgram> program;
    ScaledWork verifying{"blocks.verify"};
    verifying.size = reading.size;
    verifying.prepare = [&](int step) { program = programs.parsed(at(step)); };
    verifying.work = [&](int step) {
        VerifyRequest request = programs.scene(at(step)).request;
        request.program = &*program;
        Progress progress;
        const VerifyReport report = require(verify(request, progress), "verification");
        session.check(report.removed > 0.0, "the relief is really milled");
    };
    scaleFigures(session, verifying);
}

} // namespace burin::benchmarks
