// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_job.h"
#include "core/nc/parser.h"
#include "tests/benchmarks/scale/scale.h"
#include "tests/benchmarks/verification/relief_job.h"

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace burin::benchmarks {

namespace {

/// A hand that follows a program over a relief, tick by tick, with increasing length.
class Paths {
public:
    static std::size_t points(int step) { return std::size_t{50000} << step; }

    Paths() : scene_(job()), milling_(millingOf(scene_)), samples_(samplesOf(scene_)) {
        path_.name = "rows";
        path_.sources = {{1}};
        path_.edits = standardEdits();
    }

    void record(int step) {
        TakeOutline take;
        take.info.id = 1;
        take.info.toolId = milling_.tool.id;
        StrokeReader reader(take);
        if (Result<void> read = reader.add(std::span(samples_).first(points(step))); !read)
            throw std::runtime_error(read.error().subject);
        recorded_ = {reader.finish()};
    }
    void edit() {
        Progress progress;
        evaluated_ = require(evaluateStored(recorded_, milling_, milling_.tool, path_, {}, progress), "editing");
    }
    double pathPoints() const { return static_cast<double>(evaluated_->path.points.size()); }
    CheckedProgram post() const {
        ProgramRequest request;
        request.name = "rows.ngc";
        request.exactSamples = 0; // the part has no B-rep
        Progress progress;
        return require(makeProgram(milling_, evaluated_->path, request, progress), "posting");
    }

private:
    static ReliefJob job() {
        ReliefJob job;
        job.overTop = 1.1;
        job.meshCells = 128;
        job.voxel = 0.4;
        return job;
    }
    static MillingContext millingOf(const ReliefScene& scene) {
        Progress progress;
        Tool tool = scene.request.tool;
        tool.maximumDepthOfCut = 4.0;
        tool.maximumSpindleSpeed = 20000.0;
        return require(
            makeMillingContext(
                {std::make_shared<const Model>(scene.model), scene.request.setup, tool, "linuxcnc-mill", {}}, progress),
            "bench");
    }
    /// 40 mm/s along the rows, with a tremor.
    static std::vector<Sample> samplesOf(const ReliefScene& scene) {
        constexpr double step = 0.04; // mm
        const ParsedProgram program = require(parseProgram(scene.text, "relief.ngc"), "a benchmark's program");
        const glm::dvec3 zero = scene.request.setup.workOffset;
        std::vector<Sample> samples;
        for (const NcMotion& motion : program.motions) {
            if (motion.kind != NcMotionKind::line) continue;
            const auto count =
                static_cast<int>(std::ceil(glm::distance(motion.from.linear(), motion.to.linear()) / step));
            for (int i = 0; i < count && samples.size() < points(2); ++i) {
                const auto t = static_cast<double>(samples.size());
                Sample sample;
                sample.tick = samples.size();
                sample.time = 0.001 * t;
                sample.proxy.tip = zero +
                                   glm::mix(motion.from.linear(), motion.to.linear(), static_cast<double>(i) / count) +
                                   0.02 * glm::dvec3(std::sin(0.06 * t), std::sin(0.05 * t + 1.0), 1.0);
                sample.removed[0] = {100, 2};
                samples.push_back(sample);
            }
        }
        if (samples.size() < points(2)) throw std::runtime_error("the program is too short for the hand");
        return samples;
    }

    ReliefScene scene_;
    MillingContext milling_;
    std::vector<Sample> samples_;
    StoredPath path_;
    std::vector<SourceStrokes> recorded_;
    std::optional<EvaluatedPath> evaluated_;
};

} // namespace

void pointScale(Session& session) {
    if (!session.wants("scale.points")) return;
    Paths paths;
    ScaledWork editing{"points.edit"};
    editing.size = [](int step) { return static_cast<double>(Paths::points(step)); };
    editing.prepare = [&](int step) { paths.record(step); };
    editing.work = [&](int) { paths.edit(); };
    scaleFigures(session, editing);

    ScaledWork posting{"points.post"};
    posting.size = [&](int) { return paths.pathPoints(); };
    posting.prepare = [&](int step) {
        paths.record(step);
        paths.edit();
    };
    posting.work = [&](int) {
        const CheckedProgram program = paths.post();
        session.check(!program.parsed.motions.empty(), "the path becomes a program");
    };
    scaleFigures(session, posting);
}

} // namespace burin::benchmarks
