// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "path_fixture.h"

#include <rapidcheck.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace burin;
using namespace burin::test;

namespace {

constexpr double voxel = 0.25; // mm
/// A voxel and what the watch adds to the tool: neither its grid nor the oracle's knows a surface better, mm.
constexpr double blur = 0.3;
const Box block{{-10, -10, -16}, {10, 10, 0}};

Result<void> lendBlock(const StockUse& use, Progress&) {
    PropertyList list;
    Property property;
    property.id = "block";
    if (!list.add(property)) return Error{ErrorCode::internalFault, "block", "", ""};
    Result<RunVolume> volume = RunVolume::make(*Grid::make(block.low, voxel, {80, 80, 64}), list);
    if (!volume) return volume.error();
    volume->fillBlock({0, 0}, {80, 80}, 0, volume->grid().lineEnd(), 1);
    return use(*volume);
}

/// The flutes are short, the shank is wider than they are, the holder is near.
Tool stubbyTool(CutterType type) {
    Tool tool = type == CutterType::ball ? ballTool(4.0) : flatTool(4.0);
    tool.cutter.fluteLength = 6.0;
    tool.cutter.shankDiameter = 5.0;
    tool.cutter.stickOut = 9.0;
    tool.cutter.holder = {{10.0, 10.0, 20.0}};
    return tool;
}

PathContext blockContext(const Tool& tool) {
    static const MeshDistance nothing{TriangleMesh{}};
    PathContext context = contextOf(nothing, tool, block);
    context.lendStock = lendBlock;
    return context;
}

/// The stock as the lowest height that flutes, open to above, have left at points a little apart.
class Heights {
public:
    static constexpr double apart = 0.25, walked = 0.1; // mm, between points and between looks
    Heights() : heights_(side * side, block.high.z) {}
    void cut(const Cutter& cutter, const glm::dvec3& tip) {
        forEachWithin(tip, cutter.radius(), [&](double& height, double across) {
            // Higher than the flutes the stock stays: this stock knows no overhang, so that it is too high there.
            // By a step of the walk they have been higher.
            if (height > tip.z + cutter.fluteLength + walked) return;
            const double rise =
                cutter.type == CutterType::ball
                    ? cutter.radius() - std::sqrt(std::max(0.0, cutter.radius() * cutter.radius() - across * across))
                    : 0.0;
            height = std::min(height, tip.z + rise);
        });
    }
    double highestWithin(const glm::dvec3& tip, double radius) {
        double highest = -1e9;
        forEachWithin(tip, radius, [&](double& height, double) { highest = std::max(highest, height); });
        return highest;
    }

private:
    static constexpr int side = 80;
    void forEachWithin(const glm::dvec3& tip, double radius, const std::function<void(double&, double)>& visit) {
        const auto cell = [](double along, double low) {
            return std::clamp(static_cast<int>(std::floor((along - low) / apart)), 0, side - 1);
        };
        for (int y = cell(tip.y - radius, block.low.y); y <= cell(tip.y + radius, block.low.y); ++y)
            for (int x = cell(tip.x - radius, block.low.x); x <= cell(tip.x + radius, block.low.x); ++x) {
                const glm::dvec2 at = glm::dvec2(block.low) + apart * glm::dvec2(x + 0.5, y + 0.5);
                const double across = glm::distance(at, glm::dvec2(tip));
                if (across < radius) visit(heights_[static_cast<std::size_t>(y * side + x)], across);
            }
    }
    std::vector<double> heights_;
};

/// How deep shank or holder are in what is left at worst, along all moves, mm; those that lie within the blur of a
/// wall count as beside it.
double deepestGuard(const std::vector<PathPoint>& points, const Cutter& cutter) {
    Heights left;
    double deepest = 0.0;
    walk(points, Heights::walked, [&](const PathPoint& end, const glm::dvec3& tip) {
        if (tip.z + cutter.fluteLength < block.high.z)
            deepest = std::max(deepest,
                               left.highestWithin(tip, 0.5 * cutter.shankDiameter - blur) - tip.z - cutter.fluteLength);
        if (tip.z + cutter.stickOut < block.high.z)
            deepest = std::max(deepest, left.highestWithin(tip, 0.5 * cutter.holder.front().lowerDiameter - blur) -
                                            tip.z - cutter.stickOut);
        if (end.kind != MoveKind::rapid) left.cut(cutter, tip);
    });
    return deepest;
}

double lengthOfCuts(const std::vector<PathPoint>& points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].kind == MoveKind::cut) length += glm::distance(points[i - 1].tip, points[i].tip);
    return length;
}

const EditReport& reportOf(const EvaluatedPath& path, std::string_view edit) {
    return *std::ranges::find(path.reports, edit, &EditReport::edit);
}

/// Five rows at a height, to and fro, over a square about the origin; then up.
void appendRows(std::vector<Tick>& ticks, double half, double z) {
    std::vector<glm::dvec3> corners{{-half, -half, 8}};
    double side = -1.0;
    for (double y = -half; y <= half + 1e-9; y += 0.5 * half) {
        corners.push_back({side * half, y, z});
        corners.push_back({-side * half, y, z});
        side = -side;
    }
    append(ticks, along({corners.front(), corners[1]}, 400.0, false));
    append(ticks, along({corners.begin() + 1, corners.end()}, 400.0));
    append(ticks, along({corners.back(), {corners.back().x, corners.back().y, 8}}, 400.0, false));
}

/// The same work as `linkedEdits`, with all that bends ends and corners.
std::vector<Edit> allEdits(Link link) {
    RoundCorners round;
    round.tolerance = 0.05;
    LeadIn in;
    in.form = *rc::gen::element(LeadIn::Form::arc, LeadIn::Form::line, LeadIn::Form::ramp);
    LeadOut out;
    return {{DropAirCuts{}}, {SmoothSpline{}}, {HoldOut{}}, {Simplify{}}, {round}, {FitArcs{}}, {in},
            {out},           {link},           {SetFeed{}}};
}

} // namespace

class TestOmissions : public QObject {
    Q_OBJECT

private slots:
    /// A pocket 6 mm deep that reaches 7 mm far, then a deep groove out of it: the shank, 2.5 mm wide to a side, comes
    /// as far as its wall.
    void aGrooveEndsWhereTheShankWouldTouch() {
        const Tool tool = stubbyTool(CutterType::flat);
        std::vector<Tick> ticks;
        appendRows(ticks, 5.0, -5.0);
        append(ticks, along({{-4, 0, 8}, {-4, 0, -8}}, 400.0, false));
        append(ticks, along({{-4, 0, -8}, {9, 0, -8}}, 400.0));
        const auto path = run({takeOf(ticks)}, {{DropAirCuts{}}, {Simplify{}}, {Link{}}}, blockContext(tool));
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        double farthest = -1e9;
        for (const PathPoint& point : path->path.points)
            if (point.tip.z < -7.9) farthest = std::max(farthest, point.tip.x);
        constexpr double wall = 7.0 - 2.5;
        QVERIFY2(farthest <= wall + 1e-6 && farthest > wall - blur, qPrintable(QString::number(farthest)));
        const EditReport& link = reportOf(*path, "link");
        QCOMPARE(link.omissions.size(), std::size_t{1});
        const Omission& part = link.omissions.front();
        QVERIFY(part.reason == OmissionReason::shank);
        QCOMPARE(part.take, std::int64_t{1});
        QCOMPARE(part.line.front(), glm::dvec3(farthest, 0, -8));
        QCOMPARE(part.line.back(), glm::dvec3(9, 0, -8));
        QVERIFY(std::abs(part.length - (9.0 - farthest)) < 1e-9);
        // The hand was there at those moments: 0.4 mm a tick.
        const double tickAt = static_cast<double>(ticks.size() - 1) - (9.0 - farthest) / 0.4;
        QVERIFY(std::abs(static_cast<double>(part.first) - tickAt) <= 33.0 &&
                part.last == std::int64_t(ticks.size()) - 1);
        QVERIFY(link.lengthBefore >= lengthOfCuts(path->path.points) + part.length - 1e-6);
        QVERIFY(deepestGuard(path->path.points, tool.cutter) < blur);
    }

    void whatFlutesReachIsNeverLeftOut() {
        QVERIFY(rc::check("strokes no deeper than the flutes are long are made in whole", [] {
            const Tool tool = stubbyTool(*rc::gen::element(CutterType::ball, CutterType::flat));
            std::vector<Tick> ticks;
            for (int i = 0; i < 3; ++i) {
                const glm::dvec3 from(*rc::gen::inRange(-9, 9), *rc::gen::inRange(-9, 9), -*rc::gen::inRange(1, 6));
                const glm::dvec3 to(*rc::gen::inRange(-9, 9), *rc::gen::inRange(-9, 9), -*rc::gen::inRange(1, 6));
                append(ticks, along({from, to}, 400.0));
                append(ticks, along({to, {to.x, to.y, 8}}, 400.0, false));
            }
            const auto path = run({takeOf(ticks)}, {{DropAirCuts{}}, {Simplify{}}, {Link{}}}, blockContext(tool));
            RC_PRE(static_cast<bool>(path));
            for (const EditReport& report : path->reports) RC_ASSERT(report.omissions.empty());
        }));
    }

    /// Spline, rounded corners, arcs, leads, links at each height with rounding: whatever bends the path, and wherever
    /// it links, shank and holder stay out of what is left.
    void shankAndHolderStayOutWithAllEditsTogether() {
        double made = 0.0, omitted = 0.0;
        QVERIFY(rc::check("no move takes shank or holder into stock", [&] {
            const Tool tool = stubbyTool(*rc::gen::element(CutterType::ball, CutterType::flat));
            std::vector<Tick> ticks;
            appendRows(ticks, 5.0, -5.0);
            for (int i = 0; i < 2; ++i) {
                std::vector<glm::dvec3> corners;
                for (int k = 0; k < 3; ++k)
                    corners.push_back({*rc::gen::inRange(-8, 9), *rc::gen::inRange(-8, 9), -*rc::gen::inRange(5, 13)});
                append(ticks, along(corners, 400.0));
                append(ticks, along({corners.back(), {corners.back().x, corners.back().y, 8}}, 400.0, false));
            }
            Link link;
            link.travel = *rc::gen::element(Link::Travel::safe, Link::Travel::lowest, Link::Travel::around);
            link.rounding = *rc::gen::element(0.0, 0.7, 3.0);
            const auto path = run({takeOf(ticks)}, allEdits(link), blockContext(tool));
            RC_ASSERT(static_cast<bool>(path));
            RC_ASSERT(deepestGuard(path->path.points, tool.cutter) < blur);
            made += lengthOfCuts(path->path.points);
            omitted += lengthOf(reportOf(*path, "link").omissions);
        }));
        QVERIFY(made > 1000.0 && omitted > 100.0); // of both there was something to judge
    }

    /// Without the stock nobody can tell, and nothing is left out.
    void withoutStockNothingIsWatched() {
        std::vector<Tick> ticks = along({{-8, 0, -12}, {8, 0, -12}}, 400.0);
        PathContext context = blockContext(stubbyTool(CutterType::flat));
        const std::vector<Edit> edits{{DropAirCuts{}}, {Simplify{}}, {Link{}}};
        const auto watched = run({takeOf(ticks)}, edits, context);
        QVERIFY(!watched);
        QVERIFY(watched.error().code == ErrorCode::pathGouges);
        QCOMPARE(watched.error().place, std::string("-8.000 0.000 -12.000 mm"));
        QCOMPARE(watched.error().detail, std::string(remedyOf(OmissionReason::shank).text));
        context.lendStock = {};
        const auto path = run({takeOf(ticks)}, edits, context);
        QVERIFY(path);
        QVERIFY(reportOf(*path, "link").omissions.empty());
    }
};

QTEST_APPLESS_MAIN(TestOmissions)
#include "tst_omissions.moc"
