// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/nc/control.h"
#include "core/verify/kept_check.h"
#include "core/verify/report_json.h"
#include "core/verify/verify.h"
#include "core/volume/operations/fingerprint.h"
#include "tests/long_run.h"
#include "tests/test_program.h"

#include <QTest>

#include <cmath>
#include <random>
#include <sstream>

namespace burin::tst_kept_check {

namespace {

TriangleMesh blockMesh(const glm::dvec3& low, const glm::dvec3& high) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.emplace_back(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                   corner & 4 ? high.z : low.z);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// A move of the program to be changed.
struct Step {
    bool rapid = false;
    glm::dvec3 to{0.0};
    int feed = 800;
};

/// @param turn words of rotary axes, at the start
std::string wordsOf(const std::vector<Step>& steps, const std::string& turn = {}) {
    std::string text = "G21 G90 G17 G54\nT1 M6\nS10000 M3\nG0 X0 Y0 Z20" + turn + "\n";
    for (const Step& step : steps) {
        text += (step.rapid ? "G0 X" : "G1 X") + formatFixed(step.to.x, 3) + " Y" + formatFixed(step.to.y, 3) + " Z" +
                formatFixed(step.to.z, 3);
        text += step.rapid ? "\n" : " F" + std::to_string(step.feed) + "\n";
    }
    return text + "G0 Z20\nM2\n";
}

/// Rows over the top of the part, in levels; each row is reached by a rapid above the stock.
std::vector<Step> rows() {
    std::vector<Step> steps;
    for (const double level : {-3.6, -7.2})
        for (double y = -12.0; y <= 12.0; y += 6.0) {
            steps.push_back({true, {-24.0, y, 5.0}});
            for (double x = -20.0; x <= 20.0; x += 2.0)
                steps.push_back({false, {x, y, level + 0.4 * std::sin(0.3 * x + y) - 0.4}});
            steps.push_back({true, {20.0, y, 5.0}});
        }
    return steps;
}

/// Every number of a report, bit for bit.
class ReportText {
public:
    explicit ReportText(const VerifyReport& report) {
        text_ << std::hexfloat;
        add(report.gougeMax, report.gougeMaxMesh, report.samples, report.exactSamples, report.excessMax,
            report.excessMean, report.reachableShare, report.removed, report.onPartShare, report.onPartSamples,
            report.machiningSeconds, report.secondsWithoutAcceleration, report.toolChanges, report.untimedMoves);
        for (const MotionTime& time : report.times) add(time.start, time.duration, time.peakSpeed);
        for (const MotionLoad& load : report.loads)
            add(load.motion, load.line, load.start, load.volume, load.force, load.power, load.peak.force,
                load.peak.radial, load.peak.axial, load.peak.side, load.peak.torque, load.peak.chip, load.peak.depth,
                load.peak.width, load.peak.at);
        for (const LoadStep& step : report.loadSteps)
            add(step.start, step.duration, step.force, step.power, step.motion);
        for (const auto* findings : {&report.findings, &report.warnings})
            for (const Finding& finding : *findings) {
                add(idOf(finding.kind), finding.line, finding.amount, finding.limit, finding.count);
                add(finding.place);
            }
        for (const FeedLimit& limit : report.feedLimits) add(limit.motion, limit.feed);
        for (const NearPass& pass : report.nearPasses) {
            add(idOf(pass), pass.line, pass.distance, pass.lines);
            add(pass.place);
        }
        for (const DeviationSample& sample : report.deviations) {
            add(sample.excess, sample.gouge, sample.reachable);
            add(sample.place);
        }
        for (const TouchedVoxels& area : report.touched) {
            add(area.line, area.edge);
            for (const glm::dvec3& centre : area.centres) add(centre);
        }
    }
    std::string text() const { return text_.str(); }

private:
    void add(const glm::dvec3& place) { add(place.x, place.y, place.z); }
    template <class... Value>
    void add(const Value&... value) {
        ((text_ << value << ' '), ...);
        text_ << '\n';
    }
    std::ostringstream text_;
};

/// A plate of 40 × 30 × 8 mm in stock 8 mm higher, and a fixture beside it.
struct Plate {
    Model model;
    std::unique_ptr<MeshDistance> part;
    VerifyRequest request;

    Plate() {
        Body body;
        body.name = "plate";
        body.mesh = blockMesh({-20.0, -15.0, -16.0}, {20.0, 15.0, -8.0});
        body.volume = 9600.0;
        body.box = boundingBox(body.mesh);
        model.bodies.push_back(body);
        part = std::make_unique<MeshDistance>(model.bodies.front().mesh);
        Setup setup;
        setup.voxel = 0.5;
        setup.marginLow = glm::dvec3(3.0);
        setup.marginHigh = {3.0, 3.0, 8.0};
        request.setup = placeStock(model, setup).value();
        request.model = &model;
        request.part = part.get();
        request.tool.id = "ball";
        request.tool.cutter = {CutterType::ball, 4.0, 2.0, 5.0, 3.0, 12.0, {{16.0, 16.0, 15.0}}};
        request.nearDistance = 0.3;
        request.obstacles = {{"clamp", Box{{22.0, -6.0, -16.0}, {30.0, 6.0, 0.0}}}};
        request.machine.travel = {300.0, 300.0, 100.0};
        request.machine.maximumFeed = 2000.0;
        request.machine.rapidFeed = 6000.0;
        request.machine.maximumSpindleSpeed = 20000.0;
    }

    struct Judged {
        std::string report;
        std::uint64_t workpiece = 0;
        std::size_t findings = 0;
        bool operator==(const Judged&) const = default;
    };
    Judged judge(const std::vector<Step>& steps, KeptCheck* kept, const std::string& turn = {}) {
        const Control& control = withRotaryAxes(defaultControl(), request.machine.axes());
        const ParsedProgram program = parseProgram(wordsOf(steps, turn), "test.ngc", control).value();
        request.program = &program;
        Progress progress;
        VolumeSnapshot machined;
        const VerifyReport report = verify(request, progress, &machined, kept).value();
        return {ReportText(report).text(), fingerprint(machined), report.findings.size()};
    }
};

/// Changes a program as edits of a path and hands in a text do.
class Changes {
public:
    void make(std::vector<Step>& steps) {
        const std::size_t at = below(steps.size());
        switch (below(7)) {
        case 0: // a point
            steps[at].to += glm::dvec3(millimetres(1.0), millimetres(1.0), millimetres(1.5));
            break;
        case 1: // feeds
            for (std::size_t i = at; i < std::min(at + 25, steps.size()); ++i)
                steps[i].feed = 300 + 40 * int(below(30));
            break;
        case 2: // points left out
            steps.erase(steps.begin() + std::ptrdiff_t(at),
                        steps.begin() + std::ptrdiff_t(std::min(at + 1 + below(12), steps.size())));
            break;
        case 3: // points inserted
            steps.insert(steps.begin() + std::ptrdiff_t(at), 1 + below(5),
                         Step{false, steps[at].to + glm::dvec3(0.0, 0.0, millimetres(2.0))});
            break;
        case 4: // a part of it lies deeper: into the part, or with the holder in the stock
            for (std::size_t i = at; i < std::min(at + 8, steps.size()); ++i) steps[i].to.z -= 0.8 * double(below(8));
            break;
        case 5: // a cut becomes a rapid, or the other way round
            steps[at].rapid = !steps[at].rapid;
            break;
        default: // the same is milled twice
            steps.insert(steps.end(), steps.begin() + std::ptrdiff_t(at),
                         steps.begin() + std::ptrdiff_t(std::min(at + 30, steps.size())));
        }
    }

private:
    std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }
    double millimetres(double most) { return std::uniform_real_distribution<double>(-most, most)(random_); }
    std::mt19937 random_{37};
};

} // namespace

class KeptCheckTest : public QObject {
    Q_OBJECT
private slots:
    void aCheckAfterEditsReportsWhatAFullOneDoes();
    void anotherToolOrObstacleBeginsAnew();
    void anotherTiltIsExaminedAnew();
    void aCancelledCheckLeavesNothingWrong();
    void memoryIsBounded();
};

/// 25 changes in turn, some of them undone again: the report and the workpiece are those of a check from scratch, bit
/// for bit.
void KeptCheckTest::aCheckAfterEditsReportsWhatAFullOneDoes() {
    Plate plate;
    KeptCheck kept;
    Changes changes;
    std::vector<Step> steps = rows();
    std::size_t faulty = 0;
    for (int i = 0; i <= testing::inLongRun(200, 25); ++i) {
        const std::vector<Step> before = steps;
        if (i > 0) changes.make(steps);
        const Plate::Judged spared = plate.judge(steps, &kept), full = plate.judge(steps, nullptr);
        QVERIFY2(spared.report == full.report, qPrintable(QString::number(i)));
        QCOMPARE(spared.workpiece, full.workpiece);
        if (full.findings > 0) ++faulty;
        if (i % 3 == 0) steps = before;
    }
    QVERIFY(faulty > 3);
    QVERIFY(kept.bytes() > 0);
}

void KeptCheckTest::anotherToolOrObstacleBeginsAnew() {
    Plate plate;
    KeptCheck kept;
    const std::vector<Step> steps = rows();
    (void)plate.judge(steps, &kept);
    plate.request.tool.cutter = {CutterType::flat, 5.0, 0.0, 4.0, 5.0, 12.0, {{20.0, 20.0, 15.0}}};
    QCOMPARE(plate.judge(steps, &kept), plate.judge(steps, nullptr));
    plate.request.obstacles.front().shape = Box{{-4.0, -6.0, -16.0}, {4.0, 6.0, -2.0}};
    QCOMPARE(plate.judge(steps, &kept), plate.judge(steps, nullptr));
    plate.request.gougeTolerance = 0.2;
    QCOMPARE(plate.judge(steps, &kept), plate.judge(steps, nullptr));
}

/// Moves of the same tips with another axis of the tool are other moves.
void KeptCheckTest::anotherTiltIsExaminedAnew() {
    Plate plate;
    RotaryAxis c, a;
    c.axis = Axis::c;
    a.axis = Axis::a;
    plate.request.machine.rotaryAxes = {c, a};
    KeptCheck kept;
    std::vector<Step> steps = rows();
    steps.resize(25);
    std::vector<Plate::Judged> judged;
    for (const char* turn : {" A0 C0", " A30 C0", " A30 C90", " A0 C0"}) {
        judged.push_back(plate.judge(steps, &kept, turn));
        QCOMPARE(judged.back(), plate.judge(steps, nullptr, turn));
    }
    QVERIFY(judged[0].workpiece != judged[1].workpiece && judged[1].workpiece != judged[2].workpiece);
}

void KeptCheckTest::aCancelledCheckLeavesNothingWrong() {
    Plate plate;
    KeptCheck kept;
    std::vector<Step> steps = rows();
    (void)plate.judge(steps, &kept);
    steps[100].to.z -= 3.0;
    const ParsedProgram program = parseProgram(wordsOf(steps), "test.ngc").value();
    plate.request.program = &program;
    Progress progress;
    progress.cancel();
    QVERIFY(!verify(plate.request, progress, nullptr, &kept));
    QCOMPARE(plate.judge(steps, &kept), plate.judge(steps, nullptr));
}

/// Programs that have nothing in common don't add up for ever.
void KeptCheckTest::memoryIsBounded() {
    Plate plate;
    KeptCheck kept;
    std::size_t most = 0;
    for (int i = 0; i < 4; ++i) {
        std::vector<Step> steps = rows();
        for (Step& step : steps) step.to.y += 0.01 * i;
        (void)plate.judge(steps, &kept);
        if (i == 0) most = kept.bytes();
    }
    QVERIFY(most > 0 && kept.bytes() < 2 * most);
    QVERIFY(kept.bytes() < KeptCheck::mostBytes);
}

BURIN_TEST(KeptCheckTest, NoApplication)

} // namespace burin::tst_kept_check

#include "tst_kept_check.moc"
