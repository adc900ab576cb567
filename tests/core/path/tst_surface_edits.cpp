// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "random_edits.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

namespace burin::tst_surface_edits {

using namespace burin::test;

namespace {

constexpr double toolRadius = 3.0;

/// A dome that rises out of a plate. Its mesh deviates by at most 0.002 mm.
const Box plate{{-18, -18, -6}, {18, 18, 0}};
constexpr double domeRadius = 12.0;
const glm::dvec3 domeCentre(2.0, 1.0, -4.0);

TriangleMesh domeMesh() {
    TriangleMesh mesh = boxMesh(plate);
    append(mesh, sphereMesh(domeCentre, domeRadius, 90)); // chord error 0.0018 mm between rings and between columns
    return mesh;
}

double boxDistance(const Box& box, const glm::dvec3& point) {
    const glm::dvec3 outside = glm::max(glm::max(box.low - point, point - box.high), glm::dvec3(0.0));
    if (outside != glm::dvec3(0.0)) return glm::length(outside);
    const glm::dvec3 inside = glm::min(point - box.low, box.high - point);
    return -std::min({inside.x, inside.y, inside.z});
}

/// Clearance of the ball and its equally wide shank from the true dome and plate, by formulas.
double clearanceOf(const glm::dvec3& tip) {
    const glm::dvec3 centre = tip + glm::dvec3(0, 0, toolRadius);
    const glm::dvec3 besideDome(tip.x, tip.y, std::max(centre.z, domeCentre.z));
    const glm::dvec3 besidePlate(tip.x, tip.y, std::max(centre.z, std::min(plate.high.z, centre.z)));
    return std::min(glm::distance(besideDome, domeCentre) - domeRadius, boxDistance(plate, besidePlate)) - toolRadius;
}

const MeshDistance& domePart() {
    static const MeshDistance part(domeMesh());
    return part;
}

PathContext domeContext() {
    return contextOf(domePart(), ballTool(), {{-30, -30, -6}, {30, 30, 12}});
}

/// Height of the tip at which the ball rests on dome or plate.
double restingHeight(double x, double y) {
    const double across = std::hypot(x - domeCentre.x, y - domeCentre.y), reach = domeRadius + toolRadius;
    const double onDome =
        across < reach ? domeCentre.z + std::sqrt(reach * reach - across * across) - toolRadius : -1e9;
    return std::max(onDome, 0.0);
}

std::vector<Tick> overTheDome() {
    return along({{-15, -3, 14}, {15, 2, 9}, {14, 9, 2}, {-15, 8, -3}}, 60.0);
}

} // namespace

class TestSurfaceEdits : public QObject {
    Q_OBJECT

private slots:
    void aStrokeIsLaidOnThePart_data() {
        QTest::addColumn<double>("allowance");
        QTest::newRow("finish") << 0.0;
        QTest::newRow("semi-finish") << 0.4;
    }
    void aStrokeIsLaidOnThePart() {
        QFETCH(double, allowance);
        LayOnPart project;
        project.allowance = allowance;
        const auto path = run({takeOf(overTheDome())}, {{project}, {Simplify{0.002}}}, domeContext());
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        QCOMPARE(std::ranges::count(path->path.points, MoveKind::rapid, &PathPoint::kind), std::ptrdiff_t{1});
        walk(path->path.points, 0.05, [&](const PathPoint&, const glm::dvec3& place) {
            const double clearance = clearanceOf(place);
            QVERIFY2(clearance >= allowance - 0.004, qPrintable(QString::number(clearance)));
            QVERIFY2(clearance <= allowance + 0.04, qPrintable(QString::number(clearance))); // across the crease
        });
        for (const PathPoint& point : path->path.points) QVERIFY(clearanceOf(point.pose.tip) <= allowance + 0.012);
        if (allowance == 0.0)
            for (const PathPoint& point : path->path.points)
                QVERIFY(std::abs(point.pose.tip.z - restingHeight(point.pose.tip.x, point.pose.tip.y)) < 0.05);
    }

    void theNearestWayLeadsToThePartToo() {
        std::vector<Tick> ticks; // a ring about the dome, partly inside, partly outside
        for (int i = 0; i <= 600; ++i) {
            const double angle = 0.004 * i, reach = 11.0 + 1.5 * std::sin(5.0 * angle);
            ticks.push_back({domeCentre + glm::dvec3(reach * std::cos(angle), reach * std::sin(angle), 6.0)});
        }
        LayOnPart project;
        project.along = LayOnPart::Along::normal;
        const auto path = run({takeOf(ticks)}, {{project}}, domeContext());
        QVERIFY(path);
        double heights = 0.0;
        walk(path->path.points, 0.05, [&](const PathPoint&, const glm::dvec3& place) {
            QVERIFY(clearanceOf(place) >= -0.004 && clearanceOf(place) <= 0.02);
            heights = std::max(heights, std::abs(place.z - domeCentre.z - 6.0));
        });
        QVERIFY(heights > 0.3); // neither straight down nor level
    }

    void besideThePartNothingIsLeft() {
        const auto path = run({takeOf(along({{-40, 0, 5}, {40, 0, 5}}, 60.0))}, {{LayOnPart{}}}, domeContext());
        QVERIFY(path);
        for (const PathPoint& point : path->path.points)
            QVERIFY(std::abs(point.pose.tip.x) <= 18.0 + toolRadius + 0.01);
    }

    void anOffsetKeepsItsDistance_data() {
        QTest::addColumn<std::vector<glm::dvec3>>("corners");
        using Corners = std::vector<glm::dvec3>;
        QTest::newRow("line") << Corners{{0, 0, -1}, {20, 0, -2}};
        QTest::newRow("corner") << Corners{{0, 0, -1}, {20, 0, -1}, {20, 15, -1}};
        QTest::newRow("zigzag") << Corners{{0, 0, -1}, {10, 0, -1}, {10, 3, -1}, {20, 3, -1}, {14, 12, -1}, {0, 9, -1}};
        QTest::newRow("narrow slot") << Corners{{0, 0, -1}, {20, 0, -1}, {20, 1.5, -1}, {0, 1.5, -1}};
    }
    void anOffsetKeepsItsDistance() {
        QFETCH(std::vector<glm::dvec3>, corners);
        const PathContext context = contextOf(nothing_, ballTool(), {{-50, -50, -20}, {50, 50, 0}});
        std::vector<glm::dvec3> flat = corners;
        for (glm::dvec3& corner : flat) corner.z = 0.0;
        for (const double distance : {1.0, -1.0, 4.0, -0.3}) {
            const auto path = run({takeOf(along(corners, 100.0))}, {{Offset{{}, distance}}}, context);
            if (!path) { // there is no room inside the slot
                QVERIFY(path.error().code == ErrorCode::pathEmpty && distance >= 1.0 && corners.size() == 4);
                continue;
            }
            for (std::size_t i = 1; i < path->path.points.size(); ++i) {
                if (path->path.points[i].kind == MoveKind::rapid) continue;
                for (const glm::dvec3& place :
                     placesOf(path->path.points[i - 1].pose.tip, path->path.points[i], 0.02)) {
                    const double off = distanceToPolyline({place.x, place.y, 0.0}, flat);
                    QVERIFY2(std::abs(off - std::abs(distance)) <= 0.002, qPrintable(QString::number(off)));
                }
            }
            const glm::dvec3 start = path->path.points.front().pose.tip;
            QVERIFY(glm::distance(start, corners[0] + glm::dvec3(0, distance, 0)) < 1e-6); // all begin along X
        }
    }

    void rowsKeepTheirStepBesideTheGuide() {
        StepOverRows rows;
        rows.guide = {{-16, -8, 0}, {0, -10, 0}, {16, -6, 0}};
        rows.stepOver = 0.8;
        rows.left = 12;
        rows.right = 2;
        const auto path = run({takeOf(along({{25, 25, 20}, {26, 25, 20}}, 20.0))}, {{rows}}, domeContext());
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        std::vector<std::size_t> found(15);
        for (std::size_t i = 1; i < path->path.points.size(); ++i) {
            const PathPoint& point = path->path.points[i];
            if (point.kind == MoveKind::rapid || point.source != 0) continue;
            const glm::dvec3& tip = point.pose.tip;
            const double off = distanceToPolyline({tip.x, tip.y, 0.0}, rows.guide), row = off / 0.8;
            QVERIFY2(std::abs(row - std::round(row)) * 0.8 < 0.004, qPrintable(QString::number(off)));
            QVERIFY(std::abs(tip.z - restingHeight(tip.x, tip.y)) < 0.05);
            ++found[static_cast<std::size_t>(std::round(row))];
        }
        for (std::size_t row = 0; row <= 12; ++row) QVERIFY(found[row] > 20);
        QVERIFY(found[2] > found[4]); // on both sides
    }

    void noRandomSequenceOfEditsGouges() {
        int judged = 0;
        QVERIFY(rc::check("with the hold-out last", [&] {
            const std::vector<Edit> recorded = randomEdits(false), later = randomEdits(true);
            std::vector<Edit> edits = recorded;
            edits.insert(edits.end(), later.begin(), later.end());
            edits.push_back({HoldOut{}});
            if (*rc::gen::arbitrary<bool>()) edits.push_back({Simplify{0.01}});
            if (*rc::gen::arbitrary<bool>()) edits.push_back({FitArcs{0.01}});
            const auto path = run({randomTake()}, edits, domeContext());
            if (isEmpty(path) || missesMoment(path)) return;
            RC_ASSERT(static_cast<bool>(path));
            expectNoGouge(*path);
            ++judged;
        }));
        QVERIFY2(judged > 60, qPrintable(QString::number(judged))); // of a hundred
    }

    void noOrderOfEditsGouges() {
        int judged = 0;
        QVERIFY(rc::check("an order is refused, or what comes of it does not enter the part", [&] {
            std::vector<Edit> edits = randomEdits(false);
            for (const Edit& edit : randomEdits(true)) edits.push_back(edit);
            Link link;
            link.travel = *rc::gen::element(Link::Travel::safe, Link::Travel::lowest, Link::Travel::around);
            link.rounding = *rc::gen::element(0.0, 2.0);
            for (const Edit& edit : std::vector<Edit>{{HoldOut{}}, {FitArcs{}}, {link}, {SetFeed{}}})
                edits.push_back(edit);
            const auto from = *rc::gen::inRange<std::size_t>(0, edits.size());
            const auto to = *rc::gen::inRange<std::size_t>(0, edits.size());
            std::swap(edits[from], edits[to]);
            const auto path = run({randomTake()}, edits, domeContext());
            const bool linked = std::ranges::any_of(
                edits, [](const Edit& edit) { return std::holds_alternative<Link>(edit.parameters); });
            if (path && linked) {
                expectNoGouge(*path);
                ++judged;
            }
            if (path) return;
            const ErrorCode why = path.error().code;
            RC_ASSERT(!path.error().detail.empty() || why == ErrorCode::pathEmpty || why == ErrorCode::editMisplaced ||
                      why == ErrorCode::editRepeated);
        }));
        QVERIFY2(judged > 15, qPrintable(QString::number(judged)));
    }

private:
    static void expectNoGouge(const EvaluatedPath& path) {
        for (std::size_t i = 1; i < path.path.points.size(); ++i) {
            const PathPoint& point = path.path.points[i];
            if (point.kind == MoveKind::rapid && point.source != 0) continue; // between strokes, without links
            for (const glm::dvec3& place : placesOf(path.path.points[i - 1].pose.tip, point, 0.05))
                RC_ASSERT(clearanceOf(place) >= -0.01);
        }
    }

    const MeshDistance nothing_{TriangleMesh{}};
};

BURIN_TEST(TestSurfaceEdits, NoApplication)

} // namespace burin::tst_surface_edits

#include "tst_surface_edits.moc"
