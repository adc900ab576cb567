// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/stock_boundary.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/allocation_count.h"
#include "tests/oracles/simulated_handle.h"
#include "tests/test_program.h"

#include <QtTest>

#include <random>

namespace burin::tst_stock_boundary {

using namespace burin::test;

namespace {

constexpr double distance = 1.0;                 // mm, that shank and holder keep
constexpr double shankBottom = 5.0;              // mm above the tip
constexpr double shankRadius = 6.0;              // mm
constexpr double meets = distance - shankBottom; // mm, height of the tip at which the shank is at its distance

HapticSettings stockSettings(bool on = true) {
    HapticSettings settings = Rig::settings();
    settings.stock = {distance, on};
    return settings;
}

/// Its shank is wider than its flutes: over the flat top of the stock at 0 it is stopped by a flat face.
Tool wideShank() {
    return ballTool(shankBottom, 2.0 * shankRadius);
}

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
}

/// Blobs of stock and of part, and gaps, in lines along any axis.
RunVolume scattered(RunAxis axis, std::mt19937& random) {
    PropertyList properties;
    const PropertyIndex stock = *properties.add(material("stock", Machinability::machinable));
    const PropertyIndex part = *properties.add(material("part", Machinability::isProtected));
    const Grid grid = *Grid::make({-12.0, -10.0, -9.0}, voxel, {48, 40, 36}, axis);
    RunVolume volume = *RunVolume::make(grid, properties);
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            if (random() % 3 != 0) continue; // many lines are empty
            const auto at = [&] { return static_cast<RunPosition>(uniform(random, 0.0, double(grid.lineEnd()))); };
            for (int i = 0; i < 2; ++i) {
                const auto [from, to] = std::minmax({at(), at()});
                if (from < to && !volume.fillSpan({u, v}, from, to, random() % 4 == 0 ? part : stock)) std::abort();
            }
        }
    return volume;
}

/// The least signed distance from the centre lines of the machinable runs to shank and holder, by ternary search on
/// every run: the distance of a convex piece is convex along it.
double nearestByBruteForce(const RunVolume& volume, const Cutter& cutter, const ToolPose& pose) {
    const std::vector<RevolvedPiece> all = pieces(cutter);
    const Grid& grid = volume.grid();
    double least = 1e9;
    const auto along = [&](const RevolvedPiece& piece, LineIndex line, double place) {
        glm::dvec3 point;
        point[grid.axisOfU()] = grid.lineCentre(line).x;
        point[grid.axisOfV()] = grid.lineCentre(line).y;
        point[grid.axisOfRuns()] = place;
        const glm::dvec3 off = point - pose.tip;
        const double height = glm::dot(off, pose.axis);
        return signedDistance(piece, glm::length(off - height * pose.axis), height);
    };
    for (LineIndex line{0, 0}; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            RunPosition start = 0;
            for (const Segment segment : volume.line(line)) {
                const bool counts =
                    segment.property() != airProperty && !volume.properties().isProtected(segment.property());
                for (std::size_t i = flutePieces(cutter).size(); counts && i < all.size(); ++i) {
                    double low = grid.toMillimetres(start), high = grid.toMillimetres(segment.end());
                    // No point of the run is farther from its middle than half its length, nor is the distance lower.
                    if (along(all[i], line, 0.5 * (low + high)) - 0.5 * (high - low) >= least) continue;
                    for (int step = 0; step < 45; ++step) {
                        const double third = (high - low) / 3.0;
                        if (along(all[i], line, low + third) < along(all[i], line, high - third))
                            high -= third;
                        else
                            low += third;
                    }
                    least = std::min(least, along(all[i], line, 0.5 * (low + high)));
                }
                start = segment.end();
            }
        }
    return least;
}

ToolPose randomPose(std::mt19937& random) {
    const glm::dvec3 axis =
        glm::normalize(glm::dvec3(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0), uniform(random, -0.3, 1.0)));
    return {{uniform(random, -14.0, 14.0), uniform(random, -12.0, 12.0), uniform(random, -18.0, 6.0)}, axis};
}

double removedIn(const Sample& sample) {
    double units = 0.0;
    for (const RemovedMaterial& removed : sample.removed) units += static_cast<double>(removed.units);
    return units;
}

bool sameBits(const Sample& one, const Sample& other) {
    return one.proxy.tip == other.proxy.tip && one.force == other.force && one.cuttingForce == other.cuttingForce &&
           one.flags == other.flags && removedIn(one) == removedIn(other);
}

/// The energy that the device gives to a handle and a hand that presses the shank on the stock and lets go.
double energyOfAPress(const SimulatedGrip& grip, double stiffness, double encoder) {
    constexpr int pressing = 500, settling = 200, most = 1200; // ticks
    HapticSettings settings = stockSettings();
    settings.stylus.maximumStiffness.value = stiffness;
    settings.stylus.positionStep.value = encoder;
    settings.felt.gain = settings.felt.friction = 0.0; // only the boundary pushes
    Rig rig(settings, wideShank());
    const double above = meets + 1.0;
    SimulatedHandle handle(grip, {0.08, 0.5, encoder, 0}, {0.0, 0.0, above});
    rig.begin({0.0, 0.0, 5.0}); // the flutes cut their way first, so that pressing meets nothing but the boundary
    rig.moveTo({0.0, 0.0, meets + 0.3}, 20.0);
    rig.moveTo({0.0, 0.0, above}, 20.0);
    rig.rest(200);
    double before = 0.0, worst = 0.0;
    for (int tick = 0; tick < most; ++tick) {
        const bool presses = tick > settling && tick < settling + pressing;
        const double intent = presses ? meets - 2.0 : above;
        const Sample sample = rig.feed(handle.reading());
        handle.hold(sample.force, {0.0, 0.0, intent}, {}, period);
        if (tick == settling) before = handle.energy();
        worst = std::max(worst, std::abs(handle.position().x));
    }
    return worst < 0.5 ? 1e3 * (handle.energy() - before) : 1e9; // mJ; it is not pushed aside
}

} // namespace

class TestStockBoundary : public QObject {
    Q_OBJECT
private slots:
    void theNearestRunIsThatOfBruteForce_data() {
        QTest::addColumn<int>("axis");
        QTest::newRow("runs along x") << static_cast<int>(RunAxis::x);
        QTest::newRow("runs along y") << static_cast<int>(RunAxis::y);
        QTest::newRow("runs along z") << static_cast<int>(RunAxis::z);
    }
    void theNearestRunIsThatOfBruteForce() {
        QFETCH(int, axis);
        std::mt19937 random(7);
        RunVolume volume = scattered(static_cast<RunAxis>(axis), random);
        Tool tool = ballTool(8.0, 10.0);
        tool.cutter.stickOut = 22.0;
        tool.cutter.holder = {{30.0, 30.0, 12.0}, {30.0, 40.0, 20.0}};
        StockBoundary boundary(volume, tool.cutter, distance);
        constexpr double enough = 6.0; // mm
        int near = 0;
        RunAmounts unseen;
        for (int i = 0; i < 60; ++i) {
            if (i % 10 == 9) // material is cut in between: what was remembered stays a bound
                for (int cut = 0; cut < 60; ++cut) {
                    const auto below = [&](std::int32_t count) {
                        return static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(count));
                    };
                    const LineIndex line{below(volume.grid().lineCountU()), below(volume.grid().lineCountV())};
                    volume.removeSpan(line, 0, volume.grid().lineEnd(), unseen);
                }
            boundary.beginTick(nullptr, true);
            const ToolPose pose = randomPose(random);
            const PoseSample sample = boundary.at(pose, enough);
            const double truth = nearestByBruteForce(volume, tool.cutter, pose) - distance;
            if (truth >= enough) {
                QVERIFY(sample.clearance >= enough && sample.clearance <= truth + 1e-6);
                continue;
            }
            ++near;
            QVERIFY2(std::abs(sample.clearance - truth) < 1e-6,
                     qPrintable(QString("pose %1: %2 instead of %3").arg(i).arg(sample.clearance).arg(truth)));
            QVERIFY(sample.fine);
            if (truth < 0.1 - distance) continue; // in a piece, its distance has ridges
            // The gradients are those of the difference quotients, except where two runs are equally near.
            constexpr double step = 1e-5;
            const glm::dvec3 way = glm::normalize(sample.gradient);
            boundary.beginTick(nullptr, true);
            const double out = boundary.at({pose.tip + step * way, pose.axis}, enough).clearance;
            QVERIFY(std::abs((out - sample.clearance) / step - glm::length(sample.gradient)) < 0.02);
        }
        QVERIFY(near > 20);
    }

    void aStoppedSpindleMeetsNothing() {
        std::mt19937 random(3);
        const RunVolume volume = scattered(RunAxis::z, random);
        StockBoundary boundary(volume, wideShank().cutter, distance);
        boundary.beginTick(nullptr, false);
        const PoseSample sample = boundary.at({{0.0, 0.0, -6.0}, {0.0, 0.0, 1.0}}, 4.0);
        QCOMPARE(sample.clearance, 4.0);
        QVERIFY(!sample.fine);
    }

    /// The flat face of the shank over the flat top of the stock: it stops at the distance, and the hand feels the
    /// spring to there. Without the layer it touches.
    void theHandIsPushedBackBeforeTheShankTouches() {
        for (const bool on : {true, false}) {
            HapticSettings settings = stockSettings(on);
            settings.felt.gain = settings.felt.friction = 0.0;
            Rig rig(settings, wideShank());
            rig.begin({0.0, 0.0, 4.0});
            bool touched = false;
            double lowest = 4.0, firstForce = 0.0;
            glm::dvec3 before(0.0);
            rig.onTick = [&](const Sample& sample) {
                touched = touched || (sample.flags & sampleShankContact) != 0;
                lowest = std::min(lowest, sample.proxy.tip.z);
                if (firstForce == 0.0 && sample.force.z > 0.05) firstForce = sample.stylusTip.z;
                const double most = std::max(rig.step.limiter().riseStep(), rig.step.limiter().fallStep());
                QVERIFY(isFinite(sample.force) && glm::length(sample.force - before) < most + 1e-9);
                QVERIFY(glm::length(sample.force) <= settings.maximumForce() + 1e-9);
                before = sample.force;
            };
            const double depth = 1.5; // mm that the hand presses on
            rig.moveTo({0.0, 0.0, meets - depth}, 20.0);
            const Sample held = rig.rest(300);
            QCOMPARE(touched, !on);
            if (!on) continue;
            QVERIFY2(std::abs(lowest - meets) < 2e-3, qPrintable(QString::number(lowest, 'g', 10)));
            QVERIFY(firstForce < meets && firstForce > meets - 0.3);
            const double spring = rig.step.couplingStiffness() * depth / millimetresPerMetre;
            QVERIFY(std::abs(held.force.z - std::min(spring, settings.maximumForce())) < 0.01 * held.force.z);
            QVERIFY((held.flags & sampleOnObstacle) != 0);
            QCOMPARE(rig.step.heldBy(), std::uint64_t{2});
            // Sideways the shank slides over the stock, at its distance.
            rig.moveTo({5.0, 0.0, meets - depth}, 20.0);
            const Sample slid = rig.rest(50);
            QVERIFY(std::abs(slid.proxy.tip.x - 5.0) < 0.05 && std::abs(slid.proxy.tip.z - meets) < 2e-3);
            // And out it comes free.
            rig.moveTo({5.0, 0.0, 2.0}, 50.0);
            QVERIFY(glm::length(rig.rest(50).force) < 1e-6);
        }
    }

    /// What the flutes have cut no longer holds the shank, in the same tick, although it is still to be written.
    void theShankFollowsThroughWhatTheFlutesHaveCut() {
        HapticSettings settings = stockSettings();
        settings.felt.gain = settings.felt.friction = 0.0;
        Rig rig(settings, ballTool(4.0, 2.0)); // a shank thinner than the flutes by two millimetres all around
        rig.begin({0.0, 0.0, 1.0});
        bool held = false;
        rig.onTick = [&](const Sample& sample) { held = held || (sample.flags & sampleOnObstacle) != 0; };
        for (const double x : {0.0, 9.0}) {
            rig.moveTo({x, 0.0, 1.0}, 200.0);
            rig.moveTo({x, 0.0, -9.0}, 200.0); // the shank is 5 mm deep in the hole
            QVERIFY(std::abs(rig.rest(20).proxy.tip.z + 9.0) < 0.01);
            rig.moveTo({x, 0.0, 1.0}, 200.0);
        }
        QVERIFY(!held);
    }

    /// A layer that is off changes no bit of a session.
    void aLayerThatIsOffChangesNothing() {
        Rig without(Rig::settings(), wideShank()), off(stockSettings(false), wideShank());
        std::mt19937 random(11);
        glm::dvec3 hand(0.0, 0.0, 4.0), velocity(0.0);
        for (int tick = 0; tick < 4000; ++tick) {
            velocity = 0.97 * velocity + 0.03 * glm::dvec3(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0),
                                                           uniform(random, -1.2, 1.0));
            hand = glm::clamp(hand + 0.3 * velocity, glm::dvec3(-16.0, -16.0, -11.0), glm::dvec3(16.0, 16.0, 6.0));
            QVERIFY2(sameBits(without.feed(hand), off.feed(hand)), qPrintable(QString::number(tick)));
        }
        QCOMPARE(off.step.layers().state(1), BoundaryLayers::State::off);
    }

    /// Switched on, or stock put back, around the shank: the layer waits until the shank is clear, and pushes nothing.
    void itWaitsWhereTheShankIsTooNear() {
        HapticSettings settings = stockSettings(false);
        settings.felt.gain = settings.felt.friction = 0.0;
        Rig rig(settings, wideShank());
        const VolumeSnapshot whole = rig.volume.snapshot();
        rig.begin({0.0, 0.0, 4.0});
        rig.moveTo({0.0, 0.0, meets - 0.5}, 20.0);
        rig.rest(100);
        rig.step.switchLayer(1, true);
        QVERIFY(glm::length(rig.rest(100).force) < 1e-6);
        QCOMPARE(rig.step.layers().state(1), BoundaryLayers::State::waiting);
        rig.moveTo({0.0, 0.0, meets + 1.0}, 20.0);
        rig.rest(10);
        QCOMPARE(rig.step.layers().state(1), BoundaryLayers::State::inForce);
        rig.moveTo({0.0, 0.0, meets - 1.0}, 20.0);
        QVERIFY(rig.rest(100).force.z > 0.3);
        // The tool goes down where the stock was taken away; then it is put back around it.
        rig.moveTo({0.0, 0.0, 4.0}, 50.0);
        rig.step.settle();
        RunAmounts unseen;
        for (std::int32_t v = 0; v < rig.volume.grid().lineCountV(); ++v)
            for (std::int32_t u = 0; u < rig.volume.grid().lineCountU(); ++u)
                rig.volume.removeSpan({u, v}, 0, rig.volume.grid().lineEnd(), unseen);
        rig.step.workpieceChanged({});
        rig.moveTo({0.0, 0.0, -7.0}, 50.0);
        rig.step.settle();
        rig.volume.restore(whole);
        rig.step.workpieceChanged({});
        glm::dvec3 last(0.0);
        rig.onTick = [&](const Sample& sample) {
            QVERIFY(isFinite(sample.force) && isFinite(sample.proxy.tip));
            last = sample.force;
        };
        rig.rest(50);
        QCOMPARE(rig.step.layers().state(1), BoundaryLayers::State::waiting);
        QVERIFY(glm::length(last) < 1e-6);
    }

    /// A press on the stock and its release return no more energy than the other layers do.
    void aPressGivesNoEnergy() {
        double worst = 0.0;
        for (const SimulatedGrip& grip : {lightGrip, middleGrip, firmGrip})
            for (const double stiffness : {400.0, 1000.0})
                for (const double encoder : {0.02, 0.055})
                    worst = std::max(worst, energyOfAPress(grip, stiffness, encoder));
        QVERIFY2(worst <= 0.02, qPrintable(QString("%1 mJ").arg(worst)));
    }

    void aTickAllocatesNothing() {
        Rig rig(stockSettings(), wideShank());
        rig.begin({0.0, 0.0, 4.0});
        rig.moveTo({0.0, 0.0, 1.0}, 50.0);
        const std::size_t before = allocationCount.load();
        rig.moveTo({0.0, 0.0, meets - 1.0}, 50.0);
        rig.moveTo({6.0, 3.0, meets - 1.0}, 50.0);
        rig.step.switchLayer(1, false);
        rig.rest(20);
        rig.step.switchLayer(1, true);
        rig.moveTo({0.0, 0.0, 2.0}, 50.0);
        QCOMPARE(allocationCount.load() - before, std::size_t{0});
    }
};

BURIN_TEST(TestStockBoundary, QCoreApplication)

} // namespace burin::tst_stock_boundary

#include "tst_stock_boundary.moc"
