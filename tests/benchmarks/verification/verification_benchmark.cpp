// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// burin-bench-verify: the time to read a program back and check it on its part. `burin bench verify` starts it.
#include "core/setup/setup.h"
#include "core/verify/excess.h"
#include "core/verify/gouge.h"
#include "core/verify/known_moves.h"
#include "core/verify/obstacles.h"
#include "core/verify/replay.h"
#include "tests/benchmarks/measure/program.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/verification/relief_job.h"
#include "tests/benchmarks/verification/slot_plate.h"

namespace {

using namespace burin;
using namespace burin::benchmarks;

struct Task {
    std::string name;
    ReliefJob job;
    double limit = 0.0; ///< s
    double peer = 0.0;  ///< s, CAMotics on a comparable relief; 0: not measured
    glm::ivec3 voxels{0};
    int replays = 8; ///< the figure is the least of them: the intrinsic time
};

/// The share of each part of verification: each part by itself, as `verify` calls it.
void splitFigures(Session& session, const std::string& name, ReliefScene& scene) {
    Progress progress;
    VerifyRequest& request = scene.request;
    const ParsedProgram program = require(parseProgram(scene.text, "relief.ngc"), "a benchmark's program");
    const std::vector<Tool> tools{request.tool};
    const std::vector<ToolMove> moves = toolMoves(program, request.setup.workOffset, request.machine);
    std::optional<EmbeddedSetup> embedded;
    const auto add = [&](const char* part, double spent) {
        session.add(figure(name + "." + part, session.least(name + "." + part, spent), "s"));
    };
    add("parse", leastSeconds(3, [&] { (void)parseProgram(scene.text, "relief.ngc"); }));
    add("embed",
        leastSeconds(3, [&] { embedded = require(embed(scene.model, request.setup, {}, progress), "stock"); }));
    std::vector<ShrunkOutline> outlines;
    add("outline", leastSeconds(3, [&] {
            outlines.clear();
            outlines.emplace_back(embedded->workpiece, request.tool.cutter.radius());
        }));
    Findings findings;
    add("collisions", leastSeconds(3, [&] {
            KeptDips nothing;
            (void)judgeObstacles(moves, tools, request, KnownMoves().numbersOf(moves), nothing, findings, progress);
        }));
    add("gouge", leastSeconds(3, [&] { (void)judgeGouges(moves, tools, outlines, request, findings, progress); }));
    add("replay", leastSeconds(
                      3, [&] { embedded = require(embed(scene.model, request.setup, {}, progress), "stock"); },
                      [&] { (void)require(replay(moves, tools, embedded->workpiece, findings, progress), "replay"); }));
    add("excess", leastSeconds(3, [&] { (void)measureExcess(embedded->workpiece, request, tools, progress); }));
}

void reliefFigures(Session& session, const Task& task) {
    if (!session.wants(task.name)) return;
    session.stage(task.name);
    ReliefScene scene(task.job);
    Progress progress;
    VerifyReport report;
    const glm::ivec3 voxels(glm::ceil(scene.request.setup.stock.size() / scene.request.setup.voxel - 1e-6));
    session.check(voxels == task.voxels, task.name + " has the voxels that it says");
    const double spent = leastSeconds(task.replays, [&] {
        const ParsedProgram program = require(parseProgram(scene.text, "relief.ngc"), "a benchmark's program");
        scene.request.program = &program;
        report = require(verify(scene.request, progress), "verification");
    });
    session.check(report.gougeMax <= 0.02, task.name + " gouges nowhere");
    session.check(report.findings.empty(), task.name + " passes");
    session.check(report.removed > 0.0 && report.reachableShare > 0.1, task.name + " is really milled");
    Figure own = figure(task.name, session.least(task.name, spent), "s", task.limit);
    session.add(task.peer > 0.0 ? against(std::move(own), "CAMotics", task.peer, 30.0) : std::move(own));
    splitFigures(session, task.name, scene);
}

void reliefs(Session& session) {
    ReliefJob coarse;
    coarse.overTop = 1.1;
    ReliefJob fine = coarse;
    fine.voxel = 0.1;
    fine.overTop = 1.2;
    reliefFigures(session, {"verify.relief.512", coarse, 0.5, 18.0, {512, 512, 78}});
    reliefFigures(session, {"verify.relief.1024", fine, 1.5, 123.0, {1024, 1024, 157}});
    ReliefJob blocks; // 250 rows of 400 moves, 0.3 mm each
    blocks.side = 118.0;
    blocks.voxel = 0.25;
    blocks.base = 100.0;
    blocks.below = 20.0;
    blocks.overTop = 5.0;
    blocks.rows = 250;
    blocks.movesPerRow = 400;
    blocks.meshCells = 320;
    reliefFigures(session, {"verify.blocks100k.512", blocks, 5.0, 0.0, {512, 512, 512}, 3});
}

void slotPlate(Session& session) {
    if (!session.wants("verify.slot_plate")) return;
    session.stage("verify.slot_plate");
    SlotPlate plate;
    const ParsedProgram program = require(parseProgram(plate.text, "slots.ngc"), "a benchmark's program");
    plate.request.program = &program;
    Progress progress;
    const VerifyReport report = require(verify(plate.request, progress), "verification");
    session.add(figure("verify.slot_plate.error", 100.0 * std::abs(report.removed / plate.volume - 1.0), "%", 0.2));
}

} // namespace

int main(int argc, char** argv) {
    return run({"burin-bench-verify", "Reading programs back and judging them", {reliefs, slotPlate}}, argc, argv);
}
