// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/removal.h"
#include "core/passes/thread_size.h"
#include "core/passes/thread_tooth.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/core/passes/pass_stage.h"
#include "tests/plate_with_hole.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <map>

namespace burin::tst_stud_thread_pass {

using namespace burin::test;

namespace {

constexpr double height = 12.0;             // mm, of the stud above the plate
constexpr double major = 8.0, pitch = 1.25; // mm: M8
// 3/4 H: from a crest of P/8 to the flat of P/8 of the shipped mills.
const double studDepth = 0.75 * 0.5 * std::sqrt(3.0) * pitch;
const double root = 0.5 * major - studDepth; // mm, radius

Tool studMill(const std::string& size = "m8") {
    return *loadTool("thread-mill-" + size);
}

/// What stands around the stud: rings up to their radius, by their heights; the part itself is no stock.
StandingStock ringsAround(const Box& box, const std::map<double, double>& rings) {
    constexpr double edge = 0.1; // mm
    StandingStock standing{glm::dvec2(box.low), edge, 400, 400, {}, {}};
    for (int row = 0; row < standing.rows; ++row)
        for (int column = 0; column < standing.columns; ++column) {
            const double far = glm::length(standing.low + edge * glm::dvec2(column + 0.5, row + 0.5));
            const auto ring = rings.lower_bound(far);
            standing.heights.push_back(far < root || ring == rings.end() ? WorkpieceHeights::nothing : ring->second);
        }
    return standing;
}

/// A plate with a stud for M8, milled to the major diameter in the stock.
Ground studPlate(const Tool& tool, const std::map<double, double>& rings = {{0.5 * major, height}},
                 double radius = root, const TriangleMesh& besides = {}) {
    const Box box{{-20.0, -20.0, -5.0}, {20.0, 20.0, height}};
    TriangleMesh part = plateWithStud({20.0, 20.0}, 5.0, radius, height);
    const auto first = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.insert(part.vertices.end(), besides.vertices.begin(), besides.vertices.end());
    for (const auto& corners : besides.triangles)
        part.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
    constexpr double coarse = 2.0; // mm: threads are planned without the field
    return {part, tool, box, 0.0, ringsAround(box, rings), coarse};
}

PassRequest studRequest() {
    PassRequest request;
    request.kind = PassKind::thread;
    request.external = true;
    request.pitch = pitch;
    request.majorDiameter = major;
    return request;
}

double angleFrom(const glm::dvec2& from, const glm::dvec2& to) {
    return std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
}

std::vector<glm::dvec3> onCircle(const TipLine& stroke, double radius) {
    std::vector<glm::dvec3> found;
    for (const glm::dvec3& tip : stroke)
        if (std::abs(glm::length(glm::dvec2(tip)) - radius) < 1e-6) found.push_back(tip);
    return found;
}

} // namespace

class StudThreadPassTest final : public QObject {
    Q_OBJECT

private slots:
    /// The depth of a thread by its profile: 5/8 H with the root of the basic profile, 3/4 H with a flat of P/8; ISO
    /// 724 prints 6.647 as the minor diameter of M8.
    void theRootFollowsTheFlatOfTheTooth() {
        const double basic = externalDepth(pitch, 0.25 * pitch);
        QVERIFY(std::abs(major - 2.0 * basic - 6.647) < 0.0006);
        QVERIFY(std::abs(externalDepth(pitch, 0.125 * pitch) - studDepth) < 1e-12);
        int mills = 0;
        for (const ThreadSize& size : coarseThreads) {
            std::string name(size.name);
            name.front() = 'm';
            const Result<Tool> mill = loadTool("thread-mill-" + name);
            if (!mill) continue;
            ++mills;
            const Result<ThreadTooth> tooth = externalThreadTooth(mill->cutter, size.pitch);
            QVERIFY2(tooth, name.c_str());
            QVERIFY(std::abs(tooth->flat - 0.125 * size.pitch) < 2e-5);
            // Its flat is that of a root up to P/4: half of its pitch, not less; and no wider pitch than its own.
            QVERIFY2(externalThreadTooth(mill->cutter, 0.8 * size.pitch), name.c_str());
            QVERIFY2(!externalThreadTooth(mill->cutter, 0.4 * size.pitch), name.c_str());
            QVERIFY2(!externalThreadTooth(mill->cutter, 1.4 * size.pitch), name.c_str());
        }
        QCOMPARE(mills, 7);
        QVERIFY(!externalThreadTooth(loadTool("lollipop-6")->cutter, pitch));
        QVERIFY(!externalThreadTooth(loadTool("flat-6")->cutter, pitch));
        Cutter thick = studMill().cutter;
        thick.shankDiameter = 4.5; // the crests leave 6 - 2 · 0.812 mm
        const Result<ThreadTooth> neck = externalThreadTooth(thick, pitch);
        QVERIFY(!neck && neck.error().place.find("4.38 mm") != std::string::npos);
    }

    /// A helix of whole turns about the stud, of (minor diameter + tool diameter) / 2; half circles outside of it lead
    /// onto it and off, at the height that the helix has at their angle. Clockwise, from the top down.
    void theHelixFollowsItsFormula() {
        const Tool mill = studMill();
        const double radius = 0.5 * (2.0 * root + mill.cutter.diameter), tooth = 0.5 * mill.cutter.fluteLength;
        const Ground ground = studPlate(mill);
        const Result<PlannedPass> pass = ground.plan(studRequest());
        QVERIFY(pass);
        QCOMPARE(pass->strokes.size(), std::size_t(1));
        QCOMPARE(pass->unreachedHoles, std::size_t(0));
        const TipLine& stroke = pass->strokes.front();
        const std::vector<double>& shares = pass->feedShares.front();
        QCOMPARE(shares.size(), stroke.size());
        const std::vector<glm::dvec3> helix = onCircle(stroke, radius);
        QVERIFY(helix.size() > 500);
        double turned = 0.0, lowest = 1e9;
        for (std::size_t i = 1; i < helix.size(); ++i) {
            turned += angleFrom(glm::dvec2(helix[i - 1]), glm::dvec2(helix[i]));
            QVERIFY(std::abs(helix[i].z - helix.front().z - pitch * turned / (2.0 * pi)) < 1e-9);
            QVERIFY(radius - glm::length(0.5 * glm::dvec2(helix[i - 1] + helix[i])) < 0.00051);
        }
        const double turns = -turned / (2.0 * pi);
        QVERIFY2(std::abs(turns - std::round(turns)) < 1e-6 && turns > 9.0, qPrintable(QString::number(turns)));
        // The crest begins half a pitch above the stud at least, less than a turn higher.
        const double crest = helix.front().z + tooth;
        QVERIFY(crest >= height + 0.5 * pitch - 1e-5 && crest < height + 1.5 * pitch);
        const double lead = 0.5 * (studDepth + 0.5), outside = radius + 2.0 * lead;
        const glm::dvec2 start = glm::dvec2(helix.front()), middle = start * ((radius + lead) / radius);
        int leading = 0;
        std::size_t faster = 0;
        for (std::size_t i = 1; i + 1 < stroke.size(); ++i) {
            const glm::dvec2 place(stroke[i]);
            lowest = std::min(lowest, stroke[i].z);
            if (std::abs(glm::length(place) - radius) < 1e-6) {
                if (std::abs(shares[i] - radius / root) < 1e-9) ++faster; // (D + d) / D
                continue;
            }
            ++leading;
            QVERIFY(std::abs(glm::distance(place, middle) - lead) < 1e-6);
            const bool first = stroke[i].z > 0.5 * height;
            const double angle = angleFrom(start, place); // against the helix before it, with it behind it
            QVERIFY(first ? angle > -1e-12 : angle < 1e-12);
            const double expected = (first ? helix.front().z : helix.back().z) + pitch * angle / (2.0 * pi);
            QVERIFY(std::abs(stroke[i].z - expected) < 1e-6);
        }
        QVERIFY(leading > 20);
        QCOMPARE(faster, helix.size() - 1); // the first point ends the way that leads there
        QVERIFY2(std::abs(lowest - 0.1) < 1e-4, qPrintable(QString::number(lowest))); // above the shoulder
        for (const glm::dvec3& end : {stroke.front(), stroke.back()}) {               // beside the crests
            QVERIFY(std::abs(glm::length(glm::dvec2(end)) - outside) < 1e-6 && end.z > height);
            QVERIFY(outside - mill.cutter.radius() > 0.5 * major + 0.49);
        }
        // Nothing of it enters the part.
        const std::vector<RevolvedPiece> tool = pieces(mill.cutter);
        double nearest = 1.0;
        follow(*pass, [&](const glm::dvec3& tip) {
            nearest = std::min(nearest, ground.part.clearance(tool, {tip, {0.0, 0.0, 1.0}}, 1.0).clearance);
        });
        QVERIFY2(nearest > -0.001, qPrintable(QString::number(nearest)));
    }

    /// Right-hand threads rise anticlockwise. Climb milling goes clockwise around a stud.
    void handAndCutDecideTheDirection_data() {
        QTest::addColumn<bool>("leftHand");
        QTest::addColumn<bool>("conventional");
        QTest::addColumn<bool>("anticlockwise");
        QTest::addColumn<bool>("up");
        QTest::newRow("right-hand, climb") << false << false << false << false;
        QTest::newRow("right-hand, conventional") << false << true << true << true;
        QTest::newRow("left-hand, climb") << true << false << false << true;
        QTest::newRow("left-hand, conventional") << true << true << true << false;
    }
    void handAndCutDecideTheDirection() {
        QFETCH(bool, leftHand);
        QFETCH(bool, conventional);
        QFETCH(bool, anticlockwise);
        QFETCH(bool, up);
        PassRequest request = studRequest();
        request.leftHand = leftHand;
        request.conventional = conventional;
        request.radialPasses = 2;
        request.springPass = true;
        const Result<PlannedPass> pass = studPlate(studMill()).plan(request);
        QVERIFY(pass && pass->strokes.size() == 1);
        // The first pass takes √½ of the depth; each pass ends where the next begins.
        const double full = root + 3.0, first = full + studDepth * (1.0 - std::sqrt(0.5));
        QVERIFY(onCircle(pass->strokes.front(), first).size() > 500);
        const std::vector<glm::dvec3> helix = onCircle(pass->strokes.front(), full);
        QVERIFY(helix.size() > 1000);
        int back = 0;
        for (std::size_t i = 1; i < helix.size(); ++i) {
            const double angle = angleFrom(glm::dvec2(helix[i - 1]), glm::dvec2(helix[i]));
            if (std::abs(helix[i].z - helix[i - 1].z) > pitch) { // on to the spring pass
                ++back;
                QVERIFY(std::abs(angle) < 1e-6);
                continue;
            }
            QCOMPARE(angle > 0.0, anticlockwise);
            QCOMPARE(helix[i].z > helix[i - 1].z, up);
        }
        QCOMPARE(back, 1);
    }

    /// What is cut of the ring between root and crest is the groove of the profile: a trapezoid of P/8 and 7/8 P that
    /// turns about the axis (Pappus and Guldin).
    void theVolumeIsThatOfTheGroove() {
        const Tool mill = studMill();
        const Ground ground = studPlate(mill);
        const Result<PlannedPass> pass = ground.plan(studRequest());
        QVERIFY(pass);
        constexpr int across = 2000;
        double ofTurn = 0.0; // mm³
        for (int i = 0; i < across; ++i) {
            const double in = studDepth * (i + 0.5) / across;
            ofTurn += 2.0 * pi * (root + in) * (0.125 * pitch + 2.0 * in / std::sqrt(3.0)) * studDepth / across;
        }
        constexpr double edge = 0.06, low = 3.0, high = low + 3.0 * pitch; // mm
        const Grid grid = tests::grid({-4.5, -4.5, 2.0}, edge, {150, 150, 100});
        RunVolume stock = tests::block(grid);
        MaterialRemoval removal(mill.cutter, grid);
        const TipLine& stroke = pass->strokes.front();
        for (std::size_t i = 1; i < stroke.size(); ++i)
            if (stroke[i].z > 0.5 && stroke[i].z < 8.5) removal.cut(stock, stroke[i - 1], stroke[i]);
        removal.settle(stock);
        double removed = 0.0, inside = 0.0;
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                const double far = glm::length(glm::dvec2(tests::placeOn(grid, line, 0.0)));
                if (far > 0.5 * major) continue;
                double from = grid.low().z;
                for (const Segment& segment : stock.line(line)) {
                    const double to = grid.toMillimetres(segment.end());
                    if (segment.property() == airProperty)
                        (far < root - 0.001 ? inside : removed) +=
                            edge * edge * std::max(0.0, std::min(to, high) - std::max(from, low));
                    from = to;
                }
            }
        // The tool follows its groove aslant and cuts it slightly wider: found by trying positions of its tooth.
        const double radius = root + mill.cutter.radius();
        constexpr int steps = 100, tries = 60;
        double swept = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double r = root + studDepth * (i + 0.5) / steps;
            for (int k = 0; k < 2 * steps; ++k) {
                const double z = pitch * ((k + 0.5) / (2 * steps) - 0.5);
                bool cut = false;
                for (int t = -tries; t <= tries && !cut; ++t) {
                    const double angle = 0.6 * t / tries, aside = std::abs(z - pitch * angle / (2.0 * pi));
                    const double away = std::sqrt(r * r + radius * radius - 2.0 * r * radius * std::cos(angle));
                    cut = away < mill.cutter.radius() - std::max(0.0, aside - pitch / 16.0) * std::sqrt(3.0);
                }
                if (cut) swept += 2.0 * pi * r * studDepth / steps * pitch / (2 * steps);
            }
        }
        QVERIFY2(std::abs(swept / ofTurn - 1.0) < 0.02, qPrintable(QString("%1, %2").arg(swept).arg(ofTurn)));
        QVERIFY2(std::abs(removed / (3.0 * swept) - 1.0) < 0.015,
                 qPrintable(QString("%1 mm³ instead of %2").arg(removed).arg(3.0 * swept)));
        QCOMPARE(inside, 0.0); // nothing of the stud
    }

    /// Depths: to the shoulder, or as stated; stock and part around the stud, and a stud of another size in the stock,
    /// leave it without a thread, which is counted.
    void roomAroundTheStudDecides() {
        const Tool mill = studMill();
        const double tooth = 0.5 * mill.cutter.fluteLength, radius = root + 3.0, lead = 0.5 * (studDepth + 0.5);
        const double leads = pitch * std::asin(lead / (radius + lead)) / (2.0 * pi);
        PassRequest request = studRequest();
        request.depth = 5.0;
        const auto planned = [&](const Ground& ground) { return *ground.plan(request); };
        const auto lowest = [](const PlannedPass& pass) {
            return pass.strokes.empty() ? 1e9 : std::ranges::min(pass.strokes.front(), {}, &glm::dvec3::z).z;
        };
        QVERIFY(std::abs(lowest(planned(studPlate(mill))) - (height - 5.0 - tooth - leads)) < 1e-4);
        // A floor of stock below the tool doesn't matter, one in its way does.
        QVERIFY(lowest(planned(studPlate(mill, {{0.5 * major, height}, {20.0, 6.0}}))) < 7.0);
        const PlannedPass floor = planned(studPlate(mill, {{0.5 * major, height}, {20.0, 7.0}}));
        QVERIFY(floor.strokes.empty() && floor.unreachedHoles == 1 && floor.unmilledStud);
        QVERIFY(std::abs(floor.neededDrilling - (height - 5.0 - tooth)) < 1e-5);
        QVERIFY(std::abs(floor.unmilledStud->allowed - major) < 1e-6);
        // What stands farther around is not in the way.
        QVERIFY(lowest(planned(studPlate(mill, {{0.5 * major, height}, {12.5, 0.0}, {20.0, height}}))) < 7.0);
        for (const auto& [diameter, fits] : {std::pair{7.7, false}, {7.8, true}, {8.1, true}, {8.25, false}}) {
            const PlannedPass other = planned(studPlate(mill, {{0.5 * diameter, height}}));
            QCOMPARE(other.strokes.size(), std::size_t(fits ? 1 : 0));
            QCOMPARE(other.unmilledStud.has_value(), !fits);
            if (!fits) QVERIFY(std::abs(other.unmilledStud->diameter - diameter) < 0.05);
        }
        request.depth = 11.8; // the tool would be in the plate
        QCOMPARE(planned(studPlate(mill)).unreachedHoles, std::size_t(1));
        request.depth = 0.0;
        QVERIFY(std::abs(lowest(planned(studPlate(mill))) - 0.1) < 1e-4);
        // A wall beside the stud: 9 mm away the tool of 6 mm has no room, 9.4 mm away it is led onto the helix
        // elsewhere.
        for (const auto& [wall, fits] : {std::pair{9.0, false}, {9.4, true}}) {
            TriangleMesh beside = plateWithStud({1.0, 15.0}, 8.0, 0.5, 0.1);
            for (glm::dvec3& vertex : beside.vertices) vertex += glm::dvec3(wall + 1.0, 0.0, 8.0);
            const PlannedPass pass = planned(studPlate(mill, {{0.5 * major, height}}, root, beside));
            QCOMPARE(pass.strokes.size(), std::size_t(fits ? 1 : 0));
            QVERIFY(!pass.unmilledStud);
            if (fits) QVERIFY(pass.strokes.front().front().x + 3.0 < wall);
        }
        // Its holder, of 6 mm there, would cut off the crests above 8 mm; it may stay above them.
        Tool stubby = mill;
        stubby.cutter.stickOut = 8.0;
        QCOMPARE(planned(studPlate(stubby)).unreachedHoles, std::size_t(1));
        request.depth = 7.2;
        QVERIFY(lowest(planned(studPlate(stubby))) + 8.0 > height);
        request.depth = 7.6;
        QCOMPARE(planned(studPlate(stubby)).unreachedHoles, std::size_t(1));
        stubby.cutter.holder.front() = {4.3, 4.3, 12.0}; // as thin as its neck
        QCOMPARE(planned(studPlate(stubby)).unreachedHoles, std::size_t(0));
    }

    void whatDoesNotFitIsRefused() {
        PassRequest request = studRequest();
        request.places = {{1.0, 1.0}};
        const auto refusal = [&](const Ground& ground) {
            const Result<PlannedPass> pass = ground.plan(request);
            return pass ? std::string() : pass.error().place + ": " + pass.error().detail;
        };
        QCOMPARE(refusal(studPlate(studMill())), std::string());
        // The part has the major diameter instead.
        const std::string drawn = refusal(studPlate(studMill(), {}, 0.5 * major));
        QVERIFY2(drawn.find(
                     "1, 1: a stud modelled with the minor diameter that this mill cuts, 6.38 mm, not with 8.00") == 0,
                 drawn.c_str());
        const std::string pitchOfOther = refusal(studPlate(studMill("m6")));
        QVERIFY2(pitchOfOther.find("one tooth for a pitch of 1.25 mm") != std::string::npos, pitchOfOther.c_str());
        for (const double top : {1e5, height + 4.0 * pitch + 0.1, 0.0}) {
            request.top = top;
            const std::string apart = refusal(studPlate(studMill()));
            QVERIFY2(apart.find(": above 0.00 and at most 17.00 mm for the stud at") != std::string::npos,
                     apart.c_str());
        }
        request.top.reset();
        request.places = {{9.0, 9.0}};
        const std::string none = refusal(studPlate(studMill()));
        QVERIFY2(none.find("9, 9: a round upright stud") == 0, none.c_str());
        // Without named studs, those of another diameter are not meant.
        request.places.clear();
        const Result<PlannedPass> other = studPlate(studMill(), {}, 0.5 * major).plan(request);
        QVERIFY(other && other->strokes.empty() && other->unreachedHoles == 0);
        request.kind = PassKind::levels;
        QVERIFY(!validate(request));
    }
};

BURIN_TEST(StudThreadPassTest, QCoreApplication)

} // namespace burin::tst_stud_thread_pass

#include "tst_stud_thread_pass.moc"
