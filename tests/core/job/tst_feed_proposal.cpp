// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/haptics/cut_tick.h"
#include "core/job/feed_proposal.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QtTest>

#include <cmath>

namespace burin::tst_feed_proposal {

using namespace burin::tests;

namespace {

constexpr double diameter = 6.0, tablesChip = 0.05; // mm; mm per tooth

Property tabled(const std::string& id, double energy, double speed, double chip = tablesChip) {
    Property property = material(id, energy, 0.3);
    property.values[std::string(surfaceSpeed)] = {speed, "m/min", "test", false};
    property.values[std::string(chipLoadPerDiameter)] = {chip / diameter, "1", "test", false};
    property.values[std::string(plungeFeedRatio)] = {0.25, "1", "test", false};
    return property;
}

PropertyList tables() {
    PropertyList list;
    (void)list.add(tabled("soft", 0.5, 300.0));
    (void)list.add(tabled("hard", 2.0, 100.0, 0.03));
    return list;
}

Tool endMill() {
    Tool tool;
    tool.id = "flat";
    tool.fluteCount = 3;
    tool.cutter = flat(diameter, 20.0);
    return tool;
}

MachineProfile freeMachine() {
    MachineProfile machine;
    machine.maximumSpindleSpeed = 1e6;
    machine.maximumFeed = 1e6;
    return machine;
}

/// A cut with the side of a flat end, by geometry. @param share of the diameter, across the motion. @param depth mm
SmoothedCut sideCut(double share, double depth, PropertyIndex property) {
    SmoothedCut cut;
    cut.area = share * diameter * depth;
    cut.arc = std::acos(1.0 - 2.0 * share);
    cut.surface = cut.arc * 0.5 * diameter * depth;
    cut.depth = depth;
    cut.energy = 1.0;
    cut.materials[0] = property;
    return cut;
}

double feedOf(double speed, double chip) { // m/min, mm per tooth
    return speed * 1000.0 / (pi * diameter) * 3.0 * chip;
}

} // namespace

/// The feed that the meters propose is compared with closed formulas; the measurements of a cut with its geometry.
class TestFeedProposal : public QObject {
    Q_OBJECT
private slots:
    void aSlotGetsTheTablesFeed() {
        for (const double depth : {0.5, 3.0, 12.0}) {
            const auto proposal = proposeFeed(sideCut(1.0, depth, 1), endMill(), freeMachine(), tables());
            QVERIFY(proposal.has_value());
            QVERIFY(std::abs(proposal->feed / feedOf(300.0, tablesChip) - 1.0) < 1e-9);
            QVERIFY(std::abs(proposal->spindleSpeed / (300e3 / (pi * diameter)) - 1.0) < 1e-9);
            QCOMPARE(proposal->bound, FeedBound::chip);
        }
    }

    /// The mean chip, fz times width over arc length, equals that of a slot, until the feed is twice the tables'.
    void thinChipsAreMadeUpFor() {
        QVERIFY(rc::check([] {
            const double share = *rc::gen::inRange(1, 100) / 100.0;
            const auto proposal = proposeFeed(sideCut(share, 2.0, 1), endMill(), freeMachine(), tables());
            RC_ASSERT(proposal.has_value());
            const double arc = std::acos(1.0 - 2.0 * share), length = arc * 0.5 * diameter;
            const double perTooth = proposal->feed / proposal->spindleSpeed / 3.0;
            const double chip = perTooth * share * diameter / length, inSlot = tablesChip * 2.0 / pi;
            if (proposal->bound == FeedBound::thinned) {
                RC_ASSERT(std::abs(perTooth - 2.0 * tablesChip) < 1e-9);
                RC_ASSERT(chip < inSlot);
            } else {
                RC_ASSERT(perTooth >= tablesChip - 1e-9);
                // More than half of the width has chips as thick as a slot's, or thicker.
                RC_ASSERT((share >= 0.5 ? chip >= inSlot - 1e-9 : std::abs(chip - inSlot) < 1e-9));
            }
        }));
    }

    /// Power: energy per volume times the volume per second.
    void theSpindlesPowerBoundsIt() {
        MachineProfile machine = freeMachine();
        machine.spindlePower = 40.0; // W
        const auto proposal = proposeFeed(sideCut(1.0, 6.0, 1), endMill(), machine, tables());
        QVERIFY(proposal.has_value());
        QCOMPARE(proposal->bound, FeedBound::load);
        const double removal = 6.0 * 6.0 * proposal->feed / 60.0; // mm³/s
        QVERIFY2(std::abs(0.5 * removal / 40.0 - 1.0) < 1e-6, qPrintable(QString::number(0.5 * removal)));
    }

    void theMostCarefulMaterialCounts() {
        SmoothedCut both = sideCut(1.0, 2.0, 1);
        both.materials = {1, 2};
        const auto proposal = proposeFeed(both, endMill(), freeMachine(), tables());
        QVERIFY(proposal.has_value());
        QCOMPARE(proposal->material, PropertyIndex{2});
        QVERIFY(std::abs(proposal->spindleSpeed / (100e3 / (pi * diameter)) - 1.0) < 1e-9);
        QVERIFY(std::abs(proposal->feed / feedOf(100.0, 0.03) - 1.0) < 1e-9);
    }

    void aPlungeGetsThePlungeFeed() {
        SmoothedCut down = sideCut(1.0, 1.0, 1);
        down.arc = 2.0 * pi;
        const auto proposal = proposeFeed(down, endMill(), freeMachine(), tables());
        QVERIFY(proposal.has_value());
        QCOMPARE(proposal->bound, FeedBound::plunge);
        QVERIFY(std::abs(proposal->feed / (0.25 * feedOf(300.0, tablesChip)) - 1.0) < 1e-9);
    }

    void limitsOfMachineAndToolHold() {
        MachineProfile machine = freeMachine();
        machine.maximumFeed = 500.0;
        auto proposal = proposeFeed(sideCut(1.0, 1.0, 1), endMill(), machine, tables());
        QCOMPARE(proposal->feed, 500.0);
        Tool tool = endMill();
        tool.maximumChipLoad = 0.02;
        proposal = proposeFeed(sideCut(0.1, 1.0, 1), tool, freeMachine(), tables());
        QCOMPARE(proposal->bound, FeedBound::limit);
        QVERIFY(std::abs(proposal->feed / feedOf(300.0, 0.02) - 1.0) < 1e-9);
    }

    void nothingIsProposedForNothing() {
        QVERIFY(!proposeFeed({}, endMill(), freeMachine(), tables()));
        QVERIFY(!proposeFeed(sideCut(1.0, 1.0, 1), endMill(), freeMachine(), materials())); // without tables
    }

    void aCutIsMetAsWideAndDeepAsItIs_data() {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("depth");
        QTest::newRow("slot") << 6.0 << 2.0;
        QTest::newRow("half") << 3.0 << 4.0;
        QTest::newRow("shallow") << 1.0 << 6.0;
    }
    /// Along a block of soft material whose second half is hard.
    void aCutIsMetAsWideAndDeepAsItIs() {
        QFETCH(double, width);
        QFETCH(double, depth);
        const Grid cells = grid({0.0, 0.0, 0.0}, 0.2, {200, 100, 50});
        RunVolume workpiece = block(cells);
        const double top = cells.box().high.z, border = 20.0;
        for (LineIndex line; line.v < cells.lineCountV(); ++line.v)
            for (line.u = 0; line.u < cells.lineCountU(); ++line.u)
                if (placeOn(cells, line, 0.0).x > border) (void)workpiece.fillSpan(line, 0, cells.lineEnd(), hardStock);
        CutTick tick(workpiece, endMill(), {}, nullptr);
        RecentCut recent;
        constexpr double period = 0.001, speed = 20.0; // s, mm/s
        ToolPose from{{-4.0, width - 3.0, top - depth}};
        const double y = width == diameter ? 10.0 : from.tip.y;
        from.tip.y = y;
        while (from.tip.x < 36.0) {
            ToolMotion motion;
            motion.from = from;
            motion.to = from;
            motion.to.tip.x += speed * period;
            Sample sample;
            (void)tick.cut(motion, period, sample);
            recent.add(sample, tick.met(), period);
            from = motion.to;
            const bool inSoft = from.tip.x > 8.0 && from.tip.x < border - 4.0;
            if (!inSoft && !(from.tip.x > border + 4.0)) continue;
            const SmoothedCut& cut = recent.newest();
            QVERIFY2(std::abs(cut.area / (width * depth) - 1.0) < 0.02, qPrintable(QString::number(cut.area)));
            QVERIFY2(std::abs(cut.depth - depth) < 0.1, qPrintable(QString::number(cut.depth)));
            // A patch that slides along the stock may or may not count (Engagement): the arc comes out shorter, and
            // with it the chip thicker and the feed lower, never the other way.
            const double arc = std::acos(1.0 - 2.0 * width / diameter);
            QVERIFY2(cut.arc > arc - 0.5 && cut.arc < arc + 0.1, qPrintable(QString::number(cut.arc)));
            const double ratio = cut.area / cut.surface, expected = width / (arc * 0.5 * diameter);
            QVERIFY2(ratio > 0.9 * expected, qPrintable(QStringLiteral("%1 of %2").arg(ratio).arg(expected)));
            QCOMPARE(cut.materials[0], inSoft ? softStock : hardStock);
            QCOMPARE(cut.materials[1], airProperty);
        }
        QCOMPARE(recent.heaviest().materials[0], hardStock);
        recent.beginTake();
        QVERIFY(!recent.heaviest().cuts());
    }
};

BURIN_TEST(TestFeedProposal, NoApplication)

} // namespace burin::tst_feed_proposal

#include "tst_feed_proposal.moc"
