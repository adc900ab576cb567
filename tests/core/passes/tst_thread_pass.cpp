// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/removal.h"
#include "core/passes/thread_pass.h"
#include "core/passes/thread_size.h"
#include "core/passes/thread_tooth.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/core/passes/pass_stage.h"
#include "tests/plate_with_hole.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <map>

namespace burin::tst_thread_pass {

using namespace burin::test;

namespace {

constexpr double thickness = 12.0;               // mm, of the plate
constexpr double holeRadius = 4.0, pitch = 1.25; // mm: M8

Tool millOf(const std::string& size) {
    return *loadTool("thread-mill-" + size);
}

/// The stock of a plate with a hole drilled from above down to a height; below 0: through.
StandingStock drilledStock(const Box& box, double drilledTo, double radius = 3.4) {
    StandingStock standing{glm::dvec2(box.low), 0.1, 200, 200, {}, {}};
    for (int row = 0; row < standing.rows; ++row)
        for (int column = 0; column < standing.columns; ++column) {
            const glm::dvec2 place = standing.low + standing.edge * glm::dvec2(column + 0.5, row + 0.5);
            const double under = drilledTo < 0.0 ? WorkpieceHeights::nothing : drilledTo;
            standing.heights.push_back(glm::length(place) < radius ? under : thickness);
        }
    return standing;
}

/// A plate with a hole of M8, drilled.
Ground plate(const Tool& tool, double drilledTo = -1.0, double radius = holeRadius) {
    const Box box{{-10.0, -10.0, 0.0}, {10.0, 10.0, thickness}};
    constexpr double coarse = 2.0; // mm: threads are planned without the field
    return {plateWithHole({10.0, 10.0}, thickness, radius), tool, box, 0.0, drilledStock(box, drilledTo), coarse};
}

PassRequest threadRequest() {
    PassRequest request;
    request.kind = PassKind::thread;
    request.pitch = pitch;
    request.majorDiameter = 2.0 * holeRadius;
    return request;
}

/// The angle between two points about the origin, rad, anticlockwise, within half a turn.
double turnBetween(const glm::dvec2& from, const glm::dvec2& to) {
    return std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
}

/// The points of a stroke at a distance from the axis, in order.
std::vector<glm::dvec3> atRadius(const TipLine& stroke, double radius) {
    std::vector<glm::dvec3> found;
    for (const glm::dvec3& tip : stroke)
        if (std::abs(glm::length(glm::dvec2(tip)) - radius) < 1e-6) found.push_back(tip);
    return found;
}

} // namespace

class ThreadPassTest final : public QObject {
    Q_OBJECT

private slots:
    /// Minor diameters as ISO 724 prints them.
    void coreHolesAreThoseOfTheStandard() {
        const std::map<std::string_view, double> minor{
            {"M3", 2.459},   {"M3.5", 2.850}, {"M4", 3.242},   {"M5", 4.134},   {"M6", 4.917},
            {"M8", 6.647},   {"M10", 8.376},  {"M12", 10.106}, {"M14", 11.835}, {"M16", 13.835},
            {"M18", 15.294}, {"M20", 17.294}, {"M22", 19.294}, {"M24", 20.752}};
        QCOMPARE(minor.size(), coarseThreads.size());
        for (const ThreadSize& size : coarseThreads)
            QVERIFY2(std::abs(minorDiameter(size) - minor.at(size.name)) < 0.0006, size.name.data());
    }

    void designationsAreRead() {
        const Result<ThreadSize> coarse = threadSizeNamed("M10"), fine = threadSizeNamed("M10x1.25");
        QVERIFY(coarse && coarse->diameter == 10.0 && coarse->pitch == 1.5);
        QVERIFY(fine && fine->diameter == 10.0 && fine->pitch == 1.25);
        for (const char* wrong : {"", "M", "M7.3", "10", "M8x", "Mx1", "M8x9", "M8x-1", "M1e400x1", "m8"}) {
            const Result<ThreadSize> size = threadSizeNamed(wrong);
            QVERIFY2(!size && size.error().code == ErrorCode::nameUnknown, wrong);
        }
    }

    /// Each shipped mill cuts its own pitch, and none that differs by a fifth.
    void aMillCutsItsOwnPitchAlone() {
        int mills = 0;
        for (const ThreadSize& size : coarseThreads) {
            std::string name(size.name);
            name.front() = 'm';
            const Result<Tool> mill = loadTool("thread-mill-" + name);
            if (!mill) continue;
            ++mills;
            QVERIFY(validate(*mill));
            const Result<ThreadTooth> tooth = threadTooth(mill->cutter, size.pitch);
            QVERIFY2(tooth, name.c_str());
            QCOMPARE(tooth->radius, mill->cutter.radius());
            QVERIFY(std::abs(tooth->height - 0.5 * mill->cutter.fluteLength) < 1e-5); // it is symmetric
            QVERIFY(mill->cutter.diameter < minorDiameter(size));
            QVERIFY2(!threadTooth(mill->cutter, 0.8 * size.pitch), name.c_str());
            QVERIFY2(!threadTooth(mill->cutter, 1.2 * size.pitch), name.c_str());
            QVERIFY(mayPlan(PassKind::thread, *mill) && !mayPlan(PassKind::levels, *mill));
        }
        QCOMPARE(mills, 7);
        QVERIFY(!threadTooth(loadTool("lollipop-6")->cutter, pitch));
        QVERIFY(!threadTooth(loadTool("flat-6")->cutter, pitch));
        Cutter thick = millOf("m8").cutter;
        thick.shankDiameter = 5.0; // the crests leave 4.65 mm
        const Result<ThreadTooth> neck = threadTooth(thick, pitch);
        QVERIFY(!neck && neck.error().place.find("4.65 mm") != std::string::npos);
    }

    /// A helix by its formula, led onto and off by half circles that lie on the same surface; its feed.
    void theHelixFollowsItsFormula() {
        const Tool mill = millOf("m8");
        const double radius = holeRadius - mill.cutter.radius(), tooth = 0.5 * mill.cutter.fluteLength;
        const Ground ground = plate(mill);
        const Result<PlannedPass> pass = ground.plan(threadRequest());
        QVERIFY(pass);
        QCOMPARE(pass->strokes.size(), std::size_t(1));
        QCOMPARE(pass->unreachedHoles, std::size_t(0));
        const TipLine& stroke = pass->strokes.front();
        const std::vector<double>& shares = pass->feedShares.front();
        QCOMPARE(shares.size(), stroke.size());
        const std::vector<glm::dvec3> helix = atRadius(stroke, radius);
        QVERIFY(helix.size() > 500);
        // From half a pitch below the plate (and the quarter turn before it) to half a pitch above it.
        QVERIFY(std::abs(stroke[1].z - (-0.75 * pitch - tooth)) < 1e-5);
        QVERIFY(std::abs(helix.front().z - (-0.5 * pitch - tooth)) < 1e-5);
        QVERIFY(std::abs(helix.back().z - (thickness + 0.5 * pitch - tooth)) < 1e-5);
        double turned = 0.0;
        for (std::size_t i = 1; i < helix.size(); ++i) {
            turned += turnBetween(glm::dvec2(helix[i - 1]), glm::dvec2(helix[i]));
            QVERIFY(std::abs(helix[i].z - helix.front().z - pitch * turned / (2.0 * pi)) < 1e-9);
            const double chord = glm::length(0.5 * glm::dvec2(helix[i - 1] + helix[i]));
            QVERIFY(radius - chord < 0.00051);
        }
        const glm::dvec2 begin(helix.front()), end(helix.back());
        int leading = 0;
        for (std::size_t i = 1; i + 1 < stroke.size(); ++i) {
            const glm::dvec2 place(stroke[i]);
            const double share = shares[i];
            if (std::abs(glm::length(place) - radius) < 1e-6) {
                if (stroke[i].z > helix.front().z) QVERIFY(std::abs(share - radius / holeRadius) < 1e-12);
                continue;
            }
            if (glm::length(place) < 1e-9) continue; // on the axis
            ++leading;
            const bool first = stroke[i].z < helix.front().z;
            const glm::dvec2 middle = 0.5 * (first ? begin : end);
            QVERIFY(std::abs(glm::distance(place, middle) - 0.5 * radius) < 1e-9);
            const double angle = turnBetween(first ? begin : end, place); // behind the begin, beyond the end
            QVERIFY(first ? angle < 0.0 : angle > 0.0);
            const double expected = (first ? helix.front().z : helix.back().z) + pitch * angle / (2.0 * pi);
            QVERIFY(std::abs(stroke[i].z - expected) < 1e-9);
            QVERIFY(std::abs(share - 0.5 * radius / (0.5 * radius + mill.cutter.radius())) < 1e-12);
        }
        QVERIFY(leading > 20);
        QVERIFY(glm::length(glm::dvec2(stroke.front())) < 1e-9 && glm::length(glm::dvec2(stroke.back())) < 1e-9);
        QVERIFY(stroke.front().z > thickness && stroke.back().z > thickness);
        // Nothing of it enters the part beyond the facets of the hole, at any point.
        const std::vector<RevolvedPiece> tool = pieces(mill.cutter);
        follow(*pass, [&](const glm::dvec3& tip) {
            QVERIFY(ground.part.clearance(tool, {tip, {0.0, 0.0, 1.0}}, 1.0).clearance > -0.007);
        });
    }

    /// Right-hand threads rise anticlockwise. Climb milling goes anticlockwise in a hole.
    void handAndCutDecideTheDirection_data() {
        QTest::addColumn<bool>("leftHand");
        QTest::addColumn<bool>("conventional");
        QTest::addColumn<bool>("anticlockwise");
        QTest::addColumn<bool>("up");
        QTest::newRow("right-hand, climb") << false << false << true << true;
        QTest::newRow("right-hand, conventional") << false << true << false << false;
        QTest::newRow("left-hand, climb") << true << false << true << false;
        QTest::newRow("left-hand, conventional") << true << true << false << true;
    }
    void handAndCutDecideTheDirection() {
        QFETCH(bool, leftHand);
        QFETCH(bool, conventional);
        QFETCH(bool, anticlockwise);
        QFETCH(bool, up);
        PassRequest request = threadRequest();
        request.leftHand = leftHand;
        request.conventional = conventional;
        const Result<PlannedPass> pass = plate(millOf("m8")).plan(request);
        QVERIFY(pass && pass->strokes.size() == 1);
        const std::vector<glm::dvec3> helix = atRadius(pass->strokes.front(), 1.0);
        QVERIFY(helix.size() > 500);
        double lowest = 1e9;
        for (const glm::dvec3& tip : pass->strokes.front()) lowest = std::min(lowest, tip.z);
        QVERIFY(std::abs(lowest - (-0.75 * pitch - 0.5 * millOf("m8").cutter.fluteLength)) < 1e-5);
        for (std::size_t i = 1; i < helix.size(); ++i) {
            QCOMPARE(turnBetween(glm::dvec2(helix[i - 1]), glm::dvec2(helix[i])) > 0.0, anticlockwise);
            QCOMPARE(helix[i].z > helix[i - 1].z, up);
        }
    }

    /// Three passes remove equal parts of a triangle; the spring pass repeats the last one.
    void passesShareTheDepth() {
        PassRequest request = threadRequest();
        request.radialPasses = 3;
        request.springPass = true;
        const Result<PlannedPass> pass = plate(millOf("m8")).plan(request);
        QVERIFY(pass && pass->strokes.size() == 1);
        const TipLine& stroke = pass->strokes.front();
        std::map<long, int> turnsAt;
        for (const glm::dvec3& tip : stroke) ++turnsAt[std::lround(1e4 * glm::length(glm::dvec2(tip)))];
        for (int k = 1; k <= 3; ++k) {
            const double depth = 0.625 * std::sqrt(0.75) * pitch; // 5/8 H
            const int points = turnsAt[std::lround(1e4 * (1.0 - depth + depth * std::sqrt(k / 3.0)))];
            QVERIFY2(points > (k == 3 ? 1000 : 300), qPrintable(QString("%1: %2").arg(k).arg(points)));
        }
    }

    /// What is cut between two heights has the volume of the profile of one turn, found by trying all positions of the
    /// tool for a dense grid of points in a plane through the axis.
    void theVolumeIsThatOfTheProfile() {
        const Tool mill = millOf("m8");
        const double radius = holeRadius - mill.cutter.radius(), core = 0.5 * 6.6468;
        const Ground ground = plate(mill);
        const Result<PlannedPass> pass = ground.plan(threadRequest());
        QVERIFY(pass);
        // The tooth: a flat of P/8 and flanks of 60°.
        const auto toothRadius = [&](double height) {
            return mill.cutter.radius() - std::max(0.0, std::abs(height) - pitch / 16.0) * std::sqrt(3.0);
        };
        constexpr int across = 120, along = 240, turns = 160;
        double ofTurn = 0.0; // mm³
        for (int i = 0; i < across; ++i) {
            const double r = core + (holeRadius - core) * (i + 0.5) / across;
            for (int k = 0; k < along; ++k) {
                const double z = pitch * ((k + 0.5) / along - 0.5);
                bool cut = false;
                for (int t = -turns; t <= turns && !cut; ++t) {
                    const double angle = 1.2 * t / turns;
                    const double away = std::sqrt(r * r + radius * radius - 2.0 * r * radius * std::cos(angle));
                    cut = away < toothRadius(z - pitch * angle / (2.0 * pi));
                }
                if (cut) ofTurn += 2.0 * pi * r * (holeRadius - core) / across * pitch / along;
            }
        }
        constexpr double edge = 0.06, low = 3.0, high = low + 3.0 * pitch; // mm
        const Grid grid = tests::grid({-4.5, -4.5, 2.0}, edge, {150, 150, 100});
        RunVolume stock = tests::block(grid);
        MaterialRemoval removal(mill.cutter, grid);
        const TipLine& stroke = pass->strokes.front();
        for (std::size_t i = 1; i < stroke.size(); ++i)
            if (stroke[i].z > 1.0 && stroke[i].z < 8.5) removal.cut(stock, stroke[i - 1], stroke[i]);
        removal.settle(stock);
        double removed = 0.0;
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                if (glm::length(glm::dvec2(tests::placeOn(grid, line, 0.0))) < core) continue;
                double from = grid.low().z;
                for (const Segment& segment : stock.line(line)) {
                    const double to = grid.toMillimetres(segment.end());
                    if (segment.property() == airProperty)
                        removed += edge * edge * std::max(0.0, std::min(to, high) - std::max(from, low));
                    from = to;
                }
            }
        QVERIFY2(std::abs(removed / (3.0 * ofTurn) - 1.0) < 0.015,
                 qPrintable(QString("%1 mm³ instead of %2").arg(removed).arg(3.0 * ofTurn)));
    }

    /// Depths: from the top of the hole, or as deep as it is drilled; otherwise the hole is left out and counted.
    void theDrillingDecidesTheDepth() {
        const Tool mill = millOf("m8");
        const double tooth = 0.5 * mill.cutter.fluteLength;
        PassRequest request = threadRequest();
        request.depth = 5.0;
        const auto lowest = [&](double drilledTo) {
            const Result<PlannedPass> pass = plate(mill, drilledTo).plan(request);
            if (!pass || pass->strokes.empty()) return 1e9;
            return std::ranges::min(pass->strokes.front(), {}, &glm::dvec3::z).z;
        };
        // The crest at 5 mm, the quarter of a pitch that leads there, and half of the tooth.
        const double needed = thickness - 5.0 - 0.25 * pitch - tooth;
        QVERIFY(std::abs(lowest(-1.0) - needed) < 1e-5);
        QVERIFY(std::abs(lowest(needed - 0.1) - needed) < 1e-5);
        QVERIFY(lowest(needed + 0.2) == 1e9);
        const Result<PlannedPass> shallow = plate(mill, needed + 0.2).plan(request);
        QVERIFY(shallow && shallow->unreachedHoles == 1);
        request.depth = 20.0; // no farther than the hole
        QVERIFY(std::abs(lowest(-1.0) - (-0.75 * pitch - tooth)) < 1e-5);
        request.depth = 0.0; // a through hole that is not drilled through
        const Result<PlannedPass> half = plate(mill, 6.0).plan(request);
        QVERIFY(half && half->strokes.empty() && half->unreachedHoles == 1);
    }

    /// A holder of 6 mm passes the wall of the hole, but would cut off the crests of the thread: it stays above them.
    void theHolderSparesTheCrests() {
        Tool mill = millOf("m8");
        mill.cutter.stickOut = 8.0;
        PassRequest request = threadRequest();
        for (const auto& [depth, threads] : {std::pair{5.0, 1U}, std::pair{7.5, 0U}, std::pair{0.0, 0U}}) {
            request.depth = depth;
            const Result<PlannedPass> pass = plate(mill).plan(request);
            QVERIFY(pass);
            QCOMPARE(pass->strokes.size(), std::size_t(threads));
            QCOMPARE(pass->unreachedHoles, std::size_t(1 - threads));
            if (threads > 0) QVERIFY(std::ranges::min(pass->strokes.front(), {}, &glm::dvec3::z).z + 8.0 > thickness);
        }
    }

    /// The tool of 6 mm comes down on the axis of the hole, and is no drill.
    void aNarrowDrillingIsNoHole() {
        for (const auto& [diameter, threads] : {std::pair{6.4, 1U}, std::pair{5.5, 0U}, std::pair{4.0, 0U}}) {
            Ground ground = plate(millOf("m8"));
            ground.ground.standing = drilledStock(ground.stock, -1.0, 0.5 * diameter);
            const Result<PlannedPass> pass = ground.plan(threadRequest());
            QVERIFY(pass);
            QCOMPARE(pass->strokes.size(), std::size_t(threads));
            QCOMPARE(pass->unreachedHoles, std::size_t(1 - threads));
        }
    }

    void whatDoesNotFitIsRefused() {
        PassRequest request = threadRequest();
        request.places = {{1.0, 1.0}};
        const auto refusal = [&](const Ground& ground) {
            const Result<PlannedPass> pass = ground.plan(request);
            return pass ? std::string() : pass.error().place + ": " + pass.error().detail;
        };
        QCOMPARE(refusal(plate(millOf("m8"))), std::string());
        // The part has its core hole instead.
        const std::string drawn = refusal(plate(millOf("m8"), -1.0, 3.4));
        QVERIFY2(drawn.find("1, 1: a hole modelled with the major diameter, 8.00 mm, not with 6.80 mm") == 0,
                 drawn.c_str());
        const std::string pitchOfOther = refusal(plate(millOf("m6")));
        QVERIFY2(pitchOfOther.find("one tooth for a pitch of 1.25 mm") != std::string::npos, pitchOfOther.c_str());
        request.pitch = 1.5;
        const std::string wide = refusal(plate(millOf("m10")));
        QVERIFY2(wide.find("a thread mill of at most 6.28 mm for that hole") != std::string::npos, wide.c_str());
        request.pitch = pitch;
        for (const double top : {1e5, thickness + 4.0 * pitch + 0.1, 0.0}) { // a helix in the air, or below the hole
            request.top = top;
            const std::string apart = refusal(plate(millOf("m8")));
            QVERIFY2(apart.find(": above 0.00 and at most 17.00 mm for the hole at") != std::string::npos,
                     apart.c_str());
        }
        request.top = thickness + 1.0;
        QCOMPARE(refusal(plate(millOf("m8"))), std::string());
        request.top.reset();
        request.places = {{9.0, 9.0}};
        const std::string none = refusal(plate(millOf("m8")));
        QVERIFY2(none.find("9, 9: a round upright hole") == 0, none.c_str());
        // Without named holes, those of another diameter are not meant.
        request.places.clear();
        const Result<PlannedPass> other = plate(millOf("m8"), -1.0, 3.4).plan(request);
        QVERIFY(other && other->strokes.empty() && other->unreachedHoles == 0);
    }
};

BURIN_TEST(ThreadPassTest, QCoreApplication)

} // namespace burin::tst_thread_pass

#include "tst_thread_pass.moc"
