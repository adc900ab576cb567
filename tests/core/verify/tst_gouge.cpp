// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/setup.h"
#include "core/verify/gouge.h"
#include "core/verify/gouge_samples.h"
#include "tests/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace burin::tst_gouge {

namespace {

constexpr double side = 24.0; // mm

double heightAt(double x, double y) {
    return 8.0 + 1.2 * std::sin(0.7 * x) * std::cos(0.55 * y);
}

/// A block with waves on top.
TriangleMesh waves() {
    constexpr std::uint32_t n = 60, over = (n + 1) * (n + 1);
    TriangleMesh mesh;
    for (const bool top : {true, false})
        for (std::uint32_t j = 0; j <= n; ++j)
            for (std::uint32_t i = 0; i <= n; ++i) {
                const double x = side * i / n, y = side * j / n;
                mesh.vertices.emplace_back(x, y, top ? heightAt(x, y) : 0.0);
            }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    const auto at = [](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            quad(a, b, c, d);
            quad(over + a, over + d, over + c, over + b);
        }
    for (std::uint32_t i = 0; i < n; ++i) {
        quad(over + at(i, 0), over + at(i + 1, 0), at(i + 1, 0), at(i, 0));
        quad(over + at(n, i), over + at(n, i + 1), at(n, i + 1), at(n, i));
        quad(over + at(i + 1, n), over + at(i, n), at(i, n), at(i + 1, n));
        quad(over + at(0, i + 1), over + at(0, i), at(0, i), at(0, i + 1));
    }
    return mesh;
}

Tool toolOf(const Cutter& cutter) {
    Tool tool;
    tool.id = "tool";
    tool.cutter = cutter;
    return tool;
}

struct Job {
    Model model;
    MeshDistance part;
    VerifyRequest request;
    std::vector<Tool> tools;
    std::vector<ToolMove> moves;

    explicit Job(std::vector<Tool> its) : model(modelOf()), part(model.bodies.front().mesh), tools(std::move(its)) {
        request.model = &model;
        request.part = &part;
        Setup setup;
        setup.voxel = 0.4;
        request.setup = placeStock(model, setup).value();
    }
    static Model modelOf() {
        Body body;
        body.mesh = waves();
        body.box = boundingBox(body.mesh);
        Model made;
        made.bodies.push_back(std::move(body));
        return made;
    }

    /// Rows over the waves with every tool in turn, long and short moves, the tip lowered until the tool just touches
    /// and then displaced; between them rapids far above.
    void makeRows(double displaced, double spread) {
        std::mt19937_64 engine(7);
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        for (std::uint16_t tool = 0; tool < tools.size(); ++tool) {
            const std::vector<RevolvedPiece> stack = pieces(tools[tool].cutter);
            for (int row = 0; row < 5; ++row) {
                const double y = 2.0 + 5.0 * row, step = row % 2 == 0 ? 0.9 : 0.17;
                add({-6.0, y, 30.0}, tool, true, 0.0);
                for (double x = -2.0; x < side + 2.0; x += step) {
                    glm::dvec3 tip(x, y + 0.1 * number(engine), 30.0);
                    for (int i = 0; i < 12; ++i) // down to the part: never farther than the clearance
                        tip.z -= std::max(0.0, part.clearance(stack, {tip, {0.0, 0.0, 1.0}}, 40.0).clearance - 1e-9);
                    tip.z = std::max(tip.z, -1.0) + displaced + spread * number(engine);
                    add(tip, tool, false, x < 3.0 ? 300.0 : 600.0);
                }
                add({side + 6.0, y, 30.0}, tool, true, 0.0);
            }
        }
    }
    void add(const glm::dvec3& to, std::uint16_t tool, bool rapid, double feed) {
        ToolMove move;
        move.from.tip = moves.empty() ? to : moves.back().to.tip;
        move.to.tip = to;
        move.feed = feed;
        move.line = static_cast<std::uint32_t>(moves.size() + 1);
        move.motion = move.line - 1;
        move.tool = tool;
        move.rapid = rapid;
        move.spindleOn = move.startKnown = move.endKnown = true;
        moves.push_back(move);
    }

    std::vector<ShrunkOutline> outlines() const {
        Progress progress;
        const EmbeddedSetup embedded = embed(model, request.setup, {}, progress).value();
        std::vector<ShrunkOutline> made;
        for (const Tool& tool : tools) made.emplace_back(embedded.workpiece, tool.cutter.radius());
        return made;
    }
};

/// The results for single samples.
struct Answers {
    double deepest = 0.0;
    std::map<std::uint32_t, double> tooDeep; ///< by line, mm
    std::vector<double> depths;              ///< of all samples on the part
    std::size_t samples = 0, finishSamples = 0, onPart = 0, nearlyOnPart = 0;
};

Answers sampleBySample(const Job& job, const std::vector<ShrunkOutline>& outlines) {
    Answers answers;
    const auto ask = [&](const ToolMove& move, const glm::dvec3& tip) {
        ++answers.samples;
        const Cutter& cutter = job.tools[move.tool].cutter;
        const ToolPose pose{tip, {0.0, 0.0, 1.0}};
        const double clearance = job.part.clearance(pieces(cutter), pose, 1.0).clearance;
        if (clearance <= onPartDistance) answers.depths.push_back(-clearance);
        answers.deepest = std::max(answers.deepest, -clearance);
        if (-clearance > job.request.gougeTolerance)
            answers.tooDeep[move.line] = std::max(answers.tooDeep[move.line], -clearance);
        if (move.rapid || move.feed < 600.0 || !outlines[move.tool].contains(tip.x, tip.y)) return;
        ++answers.finishSamples;
        const double flutes = job.part.clearance(flutePieces(cutter), pose, 1.0).clearance;
        if (flutes <= onPartDistance) ++answers.onPart;
        if (std::abs(flutes - onPartDistance) <= 2e-4) ++answers.nearlyOnPart;
    };
    ask(job.moves.front(), job.moves.front().from.tip);
    for (const ToolMove& move : job.moves) {
        const int steps = std::max(1, int(std::ceil(glm::length(move.to.tip - move.from.tip) / job.request.sampling)));
        for (int i = 1; i <= steps; ++i) ask(move, glm::mix(move.from.tip, move.to.tip, double(i) / steps));
    }
    std::sort(answers.depths.begin(), answers.depths.end(), std::greater<>());
    return answers;
}

} // namespace

class GougeTest : public QObject {
    Q_OBJECT

private slots:
    void asSampleBySample_data();
    void asSampleBySample();
    void theDeepestAreFound();
};

void GougeTest::asSampleBySample_data() {
    QTest::addColumn<double>("displaced");
    QTest::addColumn<double>("spread");
    QTest::newRow("touching") << 0.0 << 0.0;
    QTest::newRow("within the tolerance") << 0.0 << 0.004;
    QTest::newRow("deep here and there") << 0.0 << 0.05;
    QTest::newRow("too deep everywhere") << -0.4 << 0.1;
    QTest::newRow("clear by a finish allowance") << 0.12 << 0.04;
}

/// Whole moves are judged at once; the result must equal that of judging each sample separately.
void GougeTest::asSampleBySample() {
    QFETCH(double, displaced);
    QFETCH(double, spread);
    const Cutter ball{CutterType::ball, 3.0, 1.5, 6.0, 3.0, 12.0, {{12.0, 14.0, 10.0}}};
    Cutter bull = ball, flat = ball, drill = ball;
    bull.type = CutterType::bullNose;
    bull.cornerRadius = 0.5;
    flat.type = CutterType::flat;
    flat.cornerRadius = 0.0;
    drill.type = CutterType::drill;
    drill.cornerRadius = 0.0;
    drill.taperAngle = 1.0;
    Job job({toolOf(ball), toolOf(bull), toolOf(flat), toolOf(drill)});
    job.makeRows(displaced, spread);
    const std::vector<ShrunkOutline> outlines = job.outlines();
    const Answers wanted = sampleBySample(job, outlines);
    QVERIFY(wanted.finishSamples > 1000 && (displaced > 0.0 || wanted.onPart > 1000));

    Findings findings;
    Progress progress;
    const GougeJudgement found = judgeGouges(job.moves, job.tools, outlines, job.request, findings, progress).value();
    QCOMPARE(found.samples, wanted.samples);
    QCOMPARE(found.finishSamples, wanted.finishSamples);
    QVERIFY(found.onPart <= wanted.onPart + wanted.nearlyOnPart);
    QVERIFY(found.onPart + wanted.nearlyOnPart >= wanted.onPart);
    QVERIFY2(std::abs(found.maximumMesh - wanted.deepest) < 1e-6,
             qPrintable(QString("%1 %2").arg(found.maximumMesh).arg(wanted.deepest)));
    std::map<std::uint32_t, double> told;
    for (const Finding& finding : findings.inProgramOrder()) told[finding.line] = finding.amount;
    QCOMPARE(told.size(), wanted.tooDeep.size());
    for (const auto& [line, depth] : wanted.tooDeep) QVERIFY(std::abs(told[line] - depth) < 1e-6);
}

/// As many as are to be measured again on the exact part, and none deeper is left out.
void GougeTest::theDeepestAreFound() {
    Job job({toolOf({CutterType::ball, 3.0, 1.5, 6.0, 3.0, 12.0, {{12.0, 14.0, 10.0}}})});
    job.makeRows(0.0, 0.03);
    job.request.gougeTolerance = 1.0;
    const std::vector<ShrunkOutline> outlines = job.outlines();
    const Answers wanted = sampleBySample(job, outlines);
    const MoveSamples places(job.moves, job.request.sampling);
    for (const std::size_t count : {1UL, 20UL, 300UL, 100000UL}) {
        Progress progress;
        KeptSamples nothing;
        NearSamples near = nearSamples(job.moves, places, job.tools, outlines, job.request, count,
                                       KnownMoves().numbersOf(job.moves), nothing, progress);
        const std::size_t there = std::min(count, wanted.depths.size());
        QVERIFY(near.worst.size() >= there);
        std::sort(near.worst.begin(), near.worst.end(), [](const GougeSample& a, const GougeSample& b) {
            return a.clearance.clearance < b.clearance.clearance;
        });
        for (std::size_t i = 0; i < there; ++i) // clearances are accurate to 1e-4 mm
            QVERIFY(std::abs(-near.worst[i].clearance.clearance - wanted.depths[i]) < 1.1e-4);
    }
}

BURIN_TEST(GougeTest, NoApplication)

} // namespace burin::tst_gouge

#include "tst_gouge.moc"
