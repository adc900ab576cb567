// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// A stock of four materials, slotted at constant speed: the felt force, the program's feed and the check's loads follow
// the material that is under the tool. Oracle: K MRR / v of a slot, its front half a circle.
#include "core/base/units.h"
#include "core/cutting/cutting_force.h"
#include "core/cutting/removal.h"
#include "core/geometry/mesh_distance.h"
#include "core/path/material_feed.h"
#include "core/path/stroke.h"
#include "core/verify/load_chart.h"
#include "core/verify/verify.h"
#include "tests/core/setup/stock_bodies.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

namespace burin::tst_several_materials {

using namespace burin::test;

namespace {

constexpr double diameter = 6.0, depth = 3.0, edgeSpeed = 2000.0; // mm, mm, mm/s
constexpr double metal = 1.0, beech = 0.1, brass = 0.8;           // J/mm³
constexpr double firstBorder = 20.0, secondBorder = 40.0, thirdBorder = 60.0, length = 80.0, top = 12.0;

/// Specific energy of the graded foam, J/mm³.
double foamAt(double x) {
    return 0.05 + 0.002 * (x - secondBorder);
}

/// Metal up to 20 mm, beech up to 40, a foam that becomes harder up to 60, then a block of brass; the part lies to the
/// side.
Model bodies() {
    return modelOf({bodyOf("Part", boxMesh({0, 0, 0}, {4, 4, 2})),
                    bodyOf("Brass", boxMesh({thirdBorder, 0, 0}, {length, 20, top}))});
}

Setup fourRegions() {
    Setup setup = setupOf(0.25, 0.0);
    setup.stated = true;
    setup.stock = {glm::dvec3(0.0), {length, 20, top}};
    setup.roles = {BodyRole::part, BodyRole::insert};
    setup.bodyMaterials = {"", "brass"};
    MaterialRegion wood;
    wood.name = "Wood";
    wood.material = "beech";
    wood.axis = 0;
    wood.from = firstBorder;
    wood.to = secondBorder;
    MaterialRegion foam = wood;
    foam.name = "Foam";
    foam.material = "foam";
    foam.from = secondBorder;
    foam.to = thirdBorder;
    foam.grade.emplace();
    foam.grade->formula = "0.05 + 0.002 * (X - 40)";
    foam.grade->entries = 24;
    setup.regions = {wood, foam};
    return setup;
}

Tool endMill() {
    Tool tool;
    tool.id = "end mill";
    tool.source = "maker";
    tool.fluteCount = 2;
    tool.cutter = {CutterType::flat, diameter, 0.0, 20.0, diameter, 40.0, {}};
    tool.maximumDepthOfCut = 20.0;
    return tool;
}

/// Mean specific energy of the material on the slot's front, a half circle about x: its points x + sqrt(R² - y²), with
/// evenly spaced y.
double frontEnergy(double x, const std::function<double(double)>& energyAt) {
    constexpr int count = 2000;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double y = diameter * ((i + 0.5) / count - 0.5);
        sum += energyAt(x + std::sqrt(0.25 * diameter * diameter - y * y));
    }
    return sum / count;
}

double energyOf(double x) {
    if (x < firstBorder) return metal;
    if (x < secondBorder) return beech;
    return x < thirdBorder ? foamAt(x) : brass;
}

/// N, force of a slot at a speed in mm/s.
double slotForce(double energy, double speed) {
    return 1000.0 * energy * diameter * depth * speed / edgeSpeed;
}

struct Tick {
    double x = 0.0, force = 0.0;
};

/// Cuts along the centre line, a millisecond per tick, with the calculations of the haptic step.
std::vector<Tick> slotThrough(RunVolume& stock, double speed) {
    const Tool tool = endMill();
    MaterialRemoval removal(tool.cutter, stock.grid());
    const CuttingCoefficients coefficients = cuttingCoefficients(stock.properties(), diameter);
    const SpinningTool spinning = spinningTool(tool, edgeSpeed);
    constexpr double period = 0.001;
    std::vector<Tick> ticks;
    ToolPose pose{{-diameter, 10.0, top - depth}};
    while (pose.tip.x < length + diameter) {
        ToolPose next = pose;
        next.tip.x += speed * period;
        const CutResult cut = removal.cut(stock, pose.tip, next.tip);
        ticks.push_back({next.tip.x, cuttingForce(cut, coefficients, spinning, pose, next, period).tangential});
        pose = next;
    }
    return ticks;
}

double meanForce(const std::vector<Tick>& ticks, double from, double to) {
    double sum = 0.0;
    int count = 0;
    for (const Tick& tick : ticks)
        if (tick.x >= from && tick.x <= to) {
            sum += tick.force;
            ++count;
        }
    return sum / count;
}

/// The delay, in ticks, at which the felt force best matches the formula, between two positions.
int delayOf(const std::vector<Tick>& ticks, double from, double to, double speed) {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int delay = -50; delay <= 50; ++delay) {
        double sum = 0.0;
        for (const Tick& tick : ticks) {
            if (tick.x < from || tick.x > to) continue;
            const double expected = slotForce(frontEnergy(tick.x - delay * speed * 0.001, energyOf), speed);
            sum += (tick.force - expected) * (tick.force - expected);
        }
        if (sum >= least) continue;
        least = sum;
        best = delay;
    }
    return best;
}

const char* const tablesText = "a test";

/// Speeds and chips of a table: the metal has the lowest spindle speed.
std::vector<Property> tabledMaterials() {
    std::vector<Property> materials = fourMaterials();
    const auto set = [&](const std::string& id, double speed, double chip) {
        Property& material = *std::ranges::find(materials, id, &Property::id);
        material.values[std::string(surfaceSpeed)] = {speed, "m/min", tablesText, true};
        material.values[std::string(chipLoadPerDiameter)] = {chip, "1", tablesText, true};
        material.values[std::string(plungeFeedRatio)] = {0.5, "1", tablesText, true};
    };
    set("metal", 100.0, 0.005);
    set("brass", 150.0, 0.006);
    set("beech", 300.0, 0.010);
    set("foam", 400.0, 0.015);
    return materials;
}

Result<EmbeddedSetup> tabled() {
    const Setup setup = *placeStock(bodies(), fourRegions());
    Progress progress;
    return embed(bodies(), setup, tabledMaterials(), progress);
}

/// One move through all four, without feeds of its own.
struct SlotPath {
    SlotPath() : made(tabled()) {
        if (!made) return;
        context.tool = endMill();
        context.machine.maximumFeed = 5000.0;
        context.machine.maximumSpindleSpeed = 24'000.0;
        const PropertyList& list = made->workpiece.properties();
        conditions.resize(static_cast<std::size_t>(list.size()));
        for (int i = 1; i < list.size(); ++i)
            if (const auto property = static_cast<PropertyIndex>(i); !list.isProtected(property))
                conditions[property] = *cuttingConditions(context.tool, list[property], 24'000.0, 5000.0);
        context.lendStock = [this, before = made->workpiece.snapshot()](const StockUse& use, Progress&) {
            made->workpiece.restore(before);
            return use(made->workpiece);
        };
        context.conditions = conditions[made->stockProperty];
        context.materialConditions = conditions;
        add({-10.0, 10.0, top - depth}, MoveKind::rapid);
        add({length + 10.0, 10.0, top - depth}, MoveKind::cut);
        state.linked = true;
    }

    void add(const glm::dvec3& tip, MoveKind kind) {
        PathPoint point;
        point.pose.tip = tip;
        point.kind = kind;
        point.feed = kind == MoveKind::rapid ? 0.0 : context.conditions.feed;
        state.points.push_back(point);
    }

    Result<EmbeddedSetup> made;
    std::vector<CuttingConditions> conditions; ///< by property
    PathContext context;
    PathUnderEdit state;
};

} // namespace

class TestSeveralMaterials : public QObject {
    Q_OBJECT

private slots:
    void forceFollowsTheMaterial_data() {
        QTest::addColumn<double>("speed");
        QTest::newRow("10 mm/s") << 10.0;
        QTest::newRow("25 mm/s") << 25.0;
        QTest::newRow("60 mm/s") << 60.0;
    }
    void forceFollowsTheMaterial() {
        QFETCH(double, speed);
        auto made = embedded(bodies(), fourRegions());
        QVERIFY(made);
        const std::vector<Tick> ticks = slotThrough(made->workpiece, speed);
        struct Region {
            double from, to, energy;
        };
        constexpr double radius = 0.5 * diameter;
        // Positions where the front is in foam only; the front is on average a quarter of pi of the radius ahead of the
        // centre.
        const double foamMean = foamAt(0.5 * (secondBorder + 0.5 + thirdBorder - radius - 0.5) + radius * pi / 4.0);
        for (const Region& region : {Region{3.0, firstBorder - radius - 0.5, metal},
                                     {firstBorder + 0.5, secondBorder - radius - 0.5, beech},
                                     {secondBorder + 0.5, thirdBorder - radius - 0.5, foamMean},
                                     {thirdBorder + 0.5, length - radius - 0.5, brass}}) {
            const double expected = slotForce(region.energy, speed), felt = meanForce(ticks, region.from, region.to);
            QVERIFY2(std::abs(felt / expected - 1.0) < 0.05,
                     qPrintable(QStringLiteral("from %1 mm: %2 N of %3 N").arg(region.from).arg(felt).arg(expected)));
        }
        for (const double border : {firstBorder, secondBorder, thirdBorder}) {
            // The flutes look a voxel ahead of themselves, from points slightly apart.
            const int delay = delayOf(ticks, border - diameter, border + 1.0, speed);
            QVERIFY2(delay <= 2 && delay * speed * 0.001 >= -1.25 * 0.25, qPrintable(QString::number(delay)));
        }
    }

    /// Chip and speed of each material, at one spindle speed, the metal's.
    void aPathIsFedByItsMaterials() {
        SlotPath slot;
        QVERIFY(slot.made);
        Progress progress;
        PathUnderEdit& state = slot.state;
        QVERIFY(feedByMaterial(state, slot.context, slot.conditions, slot.context.conditions, SetFeed::Spindle::one,
                               progress));

        const double turns = 100'000.0 / (pi * diameter); // 1/min, of the metal
        QVERIFY(std::abs(state.spindleSpeed - turns) < 1e-6);
        const auto feedOf = [&](double chip) { return turns * 2 * chip * diameter; };
        // The front of the tool is in a material half a diameter before its centre; before a harder one it slows down
        // half a millimetre earlier, before a softer one it stays slow as long as it cuts any of the harder one.
        const auto feedAt = [&](double x) {
            for (const PathPoint& point : state.points)
                if (point.pose.tip.x >= x) return point.feed;
            return 0.0;
        };
        const auto equal = [](double one, double other) { return std::abs(one / other - 1.0) < 1e-9; };
        QVERIFY(equal(feedAt(0.0), feedOf(0.005)));
        QVERIFY(equal(feedAt(firstBorder - 0.1), feedOf(0.005)));
        QVERIFY(equal(feedAt(firstBorder + 1.1), feedOf(0.010)));
        QVERIFY(equal(feedAt(secondBorder - 0.1), feedOf(0.010)));
        QVERIFY(equal(feedAt(secondBorder + 1.1), std::min(5000.0, feedOf(0.015))));
        QVERIFY(equal(feedAt(thirdBorder - 0.5 * diameter + 0.1), feedOf(0.006)));
        QVERIFY(equal(feedAt(thirdBorder - 0.5 * diameter - 1.1), std::min(5000.0, feedOf(0.015))));
        QVERIFY(equal(feedAt(length - 1.0), feedOf(0.006)));
    }

    /// The spindle speed follows the materials if feeds are so low that the spindle has time to change its speed.
    void aSpindleTurnsByTheMaterials() {
        SlotPath slot;
        QVERIFY(slot.made);
        constexpr double slow = 0.01;
        for (CuttingConditions& each : slot.conditions) each.feed *= slow;
        slot.context.conditions.feed *= slow;
        for (PathPoint& point : slot.state.points) point.feed *= slow;
        Progress progress;
        QVERIFY(feedByMaterial(slot.state, slot.context, slot.conditions, slot.context.conditions,
                               SetFeed::Spindle::byMaterial, progress));
        const auto turnsOf = [](double speed) { return std::min(24'000.0, speed * 1000.0 / (pi * diameter)); };
        // The lowest speed permitted by the materials under the tool, up to its front.
        const auto allowed = [&](double from, double to) {
            double least = turnsOf(to > thirdBorder ? 150.0 : 400.0);
            if (from < secondBorder && to > firstBorder) least = std::min(least, turnsOf(300.0));
            return from < firstBorder ? turnsOf(100.0) : least;
        };
        double before = 0.0, reached = 0.0;
        std::set<double> speeds;
        for (const PathPoint& point : slot.state.points) {
            const double to = point.pose.tip.x, crumb = 0.6; // mm: an interval, and remains thinner than a voxel
            if (point.kind == MoveKind::cut) {
                QVERIFY2(point.spindleSpeed <= allowed(before + crumb, to + 0.5 * diameter - crumb) + 1e-6,
                         qPrintable(QStringLiteral("%1/min up to %2 mm").arg(point.spindleSpeed).arg(to)));
                speeds.insert(std::round(point.spindleSpeed));
                reached = std::max(reached, to);
            }
            before = to;
        }
        QVERIFY(reached > length - diameter);
        for (const double speed : {100.0, 150.0, 300.0, 400.0}) QVERIFY(speeds.contains(std::round(turnsOf(speed))));
        QCOMPARE(slot.state.spindleSpeed, slot.state.points[1].spindleSpeed);
    }

    /// The check's loads, along the slot, and for a layer that is half of the depth.
    void loadsAreThoseOfTheMaterials_data() {
        QTest::addColumn<bool>("halves");
        QTest::newRow("one after the other") << false;
        QTest::newRow("one above the other") << true;
    }
    void loadsAreThoseOfTheMaterials() {
        QFETCH(bool, halves);
        Setup asked = fourRegions();
        Model model = bodies();
        if (halves) {
            asked.roles[1] = BodyRole::ignored;
            asked.regions.resize(1);
            asked.regions[0].axis = 2;
            asked.regions[0].from = top - 0.5 * depth;
            asked.regions[0].to = std::numeric_limits<double>::infinity();
        }
        const auto partModel = protectedPart(std::make_shared<const Model>(model), asked);
        const MeshDistance part(partModel->bodies.front().mesh);
        VerifyRequest request;
        request.model = &model;
        request.partModel = partModel.get();
        request.part = &part;
        request.setup = *placeStock(model, asked);
        request.materials = tabledMaterials();
        request.tool = endMill();
        request.machine.acceleration = 1e6;
        request.machine.maximumFeed = request.machine.rapidFeed = 10'000.0;
        request.machine.maximumSpindleSpeed = 24'000.0;
        constexpr double feed = 1500.0; // mm/min; at 6366.2 1/min the edge has 2,000 mm/s
        const ParsedProgram program =
            parseProgram(
                "G21 G90 G17 G54\nT1 M6\nS6366.2 M3\nG0 X-50 Y0 Z5\nG0 Z-3\nG1 X-37 F1500\nX-26\nX-19\nX-6\nX1\n"
                "X14\nX21\nX34\nX50\nG0 Z5\nM2\n",
                "test.ngc")
                .value();
        request.program = &program;
        Progress progress;
        const auto report = verify(request, progress);
        QVERIFY(report);
        struct Move {
            double from, to; // of the tip, in the setup frame
        };
        const double expectedHalves = slotForce(0.5 * (metal + beech), feed / 60.0);
        int judged = 0;
        for (const auto& [line, move] :
             {std::pair(7U, Move{3, 14}), {9U, Move{21, 34}}, {11U, Move{41, 54}}, {13U, Move{61, 74}}}) {
            const auto load = std::ranges::find(report->loads, line, &MotionLoad::line);
            QVERIFY(load != report->loads.end());
            double energy = 0.0;
            constexpr int places = 50;
            for (int i = 0; i < places; ++i)
                energy += frontEnergy(move.from + (i + 0.5) / places * (move.to - move.from), energyOf) / places;
            const double expected = halves ? expectedHalves : slotForce(energy, feed / 60.0);
            QVERIFY2(std::abs(load->force / expected - 1.0) < 0.05,
                     qPrintable(QStringLiteral("line %1: %2 N of %3 N").arg(line).arg(load->force).arg(expected)));
            ++judged;
        }
        QCOMPARE(judged, 4);
    }
};

BURIN_TEST(TestSeveralMaterials, QCoreApplication)

} // namespace burin::tst_several_materials

#include "tst_several_materials.moc"
