// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/job_states.h"
#include "ui/panels/mill_states.h"
#include "ui/panels/path_states.h"
#include "ui/panels/program_states.h"
#include "ui/panels/setup_states.h"

#include <array>
#include <cmath>

/// States of the panels halfway through a job, with everything that a panel can show.
namespace burin::examples {

inline PartState part() {
    auto model = std::make_shared<Model>();
    model->sourceFile = "/models/customer/housing for the pump, revision 7 (approved by the customer).step";
    model->format = "STEP AP214";
    model->lengthUnit = "mm";
    Body shell;
    shell.name = "Shell";
    shell.colour = {90, 169, 234};
    shell.volume = 84512.0;
    shell.box = {{0.0, 0.0, 0.0}, {110.0, 60.0, 34.5}};
    shell.faceCount = 24;
    Body insert;
    insert.name = "An insert whose name is far too long for a panel of this width";
    insert.volume = 812.0;
    insert.box = {{0.0, 0.0, 0.0}, {12.0, 8.0, 8.5}};
    insert.openEdges = 3;
    insert.faceCount = 1;
    model->bodies = {shell, insert};
    model->notes = {{ImportNote::Kind::unit, "millimetre, as the file states"},
                    {ImportNote::Kind::healing, "2 small edges were merged"},
                    {ImportNote::Kind::warning, "body 2 is open at 3 edges"}};
    return {model, false};
}

inline StockState stock() {
    StockState state;
    state.hasPart = true;
    state.setup.voxel = 0.25;
    state.setup.marginLow = {5.0, 5.0, 2.0};
    state.setup.marginHigh = {5.0, 5.0, 1.0};
    state.setup.stock = {{-5.0, -5.0, -2.0}, {115.0, 65.0, 43.0}};
    state.size = EmbeddingSize{{480, 280, 180}, 37.2};
    return state;
}

inline MaterialState material() {
    MaterialState state;
    for (const std::string& id : materialIds()) state.materials.push_back(*loadMaterial(id));
    state.stockMaterial = "aluminium-6061";
    state.bodyNames = {"Shell", "An insert whose name is far too long for a panel of this width"};
    state.bodyMaterials = {"", "machinable-wax"};
    return state;
}

inline ToolState tool() {
    ToolState state;
    for (const std::string& id : toolIds()) state.tools.push_back(*loadTool(id));
    state.current = "bull-10-r2";
    state.feed = 1528.0;
    state.plungeFeed = 458.0;
    state.spindleSpeed = 9549.0;
    state.conditionsEstimated = true;
    return state;
}

inline TakeRow take(std::int64_t id, const char* name, std::uint64_t samples, std::size_t strokes) {
    TakeRow row;
    row.info.id = id;
    row.info.name = name;
    row.tool = QStringLiteral("Ball-end mill 6 mm");
    row.info.sampleCount = samples;
    row.info.complete = true;
    row.strokes = strokes;
    return row;
}

inline MillState mill() {
    MillState state;
    state.ready = true;
    state.active = true;
    state.recording = true;
    state.recordedSeconds = 102.3;
    state.canUndoStroke = true;
    state.alarm = QStringLiteral("The shank touches the stock.");
    state.pen = true;
    state.penRule = PenChoice::sink;
    state.takes = {take(1, "Take 1, roughing", 58210, 12), take(2, "Take 2, left flank", 31044, 1)};
    return state;
}

inline SurroundingsState surroundings() {
    SurroundingsState state;
    state.hasPart = true;
    state.zero = {60.0, 35.0, 45.0};
    state.axis.direction = {0.0, -0.5, std::sqrt(0.75)};
    const auto add = [&state](const char* name, std::variant<Box, CylinderShape, TriangleMesh> shape, ObstacleKind kind,
                              BoundNews news) {
        Obstacle obstacle;
        obstacle.name = name;
        obstacle.shape = std::move(shape);
        obstacle.kind = kind;
        obstacle.margin = 1.0;
        state.obstacles.push_back({std::make_shared<const Obstacle>(std::move(obstacle)), true, news});
    };
    add("Fixture 1", Box{{-120.5, -40.25, 0.0}, {-10.0, 80.0, 32.0}}, ObstacleKind::fixture, BoundNews::holds);
    add("Keep-out 1", CylinderShape{{150.0, 20.0, 0.0}, {0.0, 0.0, 1.0}, 12.0, 60.0}, ObstacleKind::keepOut,
        BoundNews::waits);
    add("vise jaw, left, with a name that is too long", TriangleMesh{}, ObstacleKind::fixture, BoundNews::none);
    return state;
}

inline GuideState guides() {
    GuideState state;
    state.live = true;
    for (const GuideKind kind : {GuideKind::levels, GuideKind::plane, GuideKind::line, GuideKind::surface,
                                 GuideKind::stepOver, GuideKind::axis}) {
        Guide guide;
        guide.kind = kind;
        guide.on = true;
        state.guides.push_back(guide);
    }
    state.news[0] = {GuideNews::Is::holding, -2, 0.1};
    state.news[1] = {GuideNews::Is::overruled, 0, 0.0};
    state.news[2] = {GuideNews::Is::away, 0, 128.5};
    return state;
}

inline HandState hand() {
    HandState state;
    state.hasDevice = state.motors = state.canRate = true;
    state.scale = 1.25;
    state.buttons = 3;
    state.clutchButton = 2;
    state.forceButton = 1;
    state.battery = 0.42;
    state.charging = true;
    state.heat = 0.71;
    return state;
}

inline PathState path() {
    PathState state;
    state.hasTakes = state.exists = state.outdated = true;
    state.path.id = 1;
    state.path.name = "Path 1";
    state.path.sources = {{1}, {2}};
    state.path.edits = standardEdits();
    state.path.edits[1].enabled = false;
    for (const char* id : {"drop-air-cuts", "smooth-shape", "hold-out", "fit-arcs", "link", "set-feed"}) {
        EditReport report;
        report.edit = id;
        report.pointsBefore = 89254;
        report.pointsAfter = 12408;
        report.largestDeviation = std::string_view(id) == "smooth-shape" ? 0.0183 : 0.0;
        state.reports.push_back(report);
    }
    state.errorBudget = 0.0332;
    state.points = 12408;
    state.cuttingLength = 8421.7;
    state.climbLength = 0.62 * state.cuttingLength;
    state.conventionalLength = 0.31 * state.cuttingLength;
    return state;
}

inline QString programText() {
    QString text = QStringLiteral("%\n(Burin, path 1, T4 ball-end mill 6 mm)\nG21 G90 G94 G17\nT4 M6\nS12000 M3\n"
                                  "G0 X-42.180 Y12.044 Z20.000\nG1 Z-1.250 F420 ; plunge\n");
    for (int i = 0; i < 40; ++i)
        text += QStringLiteral("N%1 G1 X%2 Y%3 Z%4 F1400\n")
                    .arg(10 * i)
                    .arg(-42.18 + 0.8 * i, 0, 'f', 3)
                    .arg(12.044, 0, 'f', 3)
                    .arg(-1.25 - 0.11 * i, 0, 'f', 3);
    return text + QStringLiteral("M5\nM30\n%\n");
}

inline ProgramState program() {
    ProgramState state;
    state.hasPath = state.upToDate = true;
    state.text = programText();
    state.blocks = 4812;
    VerifyReport report;
    report.gougeMax = 0.0021;
    report.exactSamples = 500;
    report.excessMax = 0.412;
    report.excessMean = 0.0284;
    report.onPartShare = 0.973;
    report.removed = 112404.0;
    report.machiningSeconds = 1504.0;
    state.report = std::make_shared<const VerifyReport>(report);
    state.released = true;
    return state;
}

inline ProgramState failedProgram() {
    ProgramState state = program();
    state.released = false;
    VerifyReport report = *state.report;
    report.gougeMax = 0.134;
    report.findings = {{FindingKind::gouge, 12, {}, 0.134},
                       {FindingKind::rapidInStock, 21, {}, 40.2},
                       {FindingKind::shankCollision, 33, {}, 3.4},
                       {FindingKind::feedLimit, 40, {}, 6200.0}};
    state.report = std::make_shared<const VerifyReport>(report);
    return state;
}

inline MeterState meters() {
    MeterState state;
    state.running = true;
    state.rateHz = 1000.2;
    state.intervalP999 = 1183.0;
    state.workP999 = 112.0;
    state.missed = 3;
    state.late = 1;
    state.scheduling = SchedulingClass::roundRobin;
    state.force = 1.8;
    state.forceScale = 3.3;
    state.removalRate = 412.0;
    state.removalScale = 600.0;
    state.tip = {16.214, 2.047, -11.38};
    state.stylus = QStringLiteral("Virtual operator 8 ×");
    state.proposed = ProposedFeed{1528.0,
                                  15915.0,
                                  2.5,
                                  3.0,
                                  QStringLiteral("Aluminium 6061"),
                                  QStringLiteral("Limited by the strength of the tool or the power of the spindle")};
    return state;
}

inline std::array<JobStepState, 8> job() {
    using enum StepProgress;
    return {{{done, QStringLiteral("mouse.step")},
             {done, QStringLiteral("120 × 70 × 45 mm")},
             {done, QStringLiteral("Aluminium 6061-T6")},
             {done, QStringLiteral("T4 ball Ø 6")},
             {ready, QStringLiteral("0.000 mm")},
             {current, QStringLiteral("Take 3 · 01:42")},
             {ready, QStringLiteral("7 edits")},
             {missing, QStringLiteral("Make a path first")}}};
}

} // namespace burin::examples
