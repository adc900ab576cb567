// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/path_values.h"
#include "core/job/program_job.h"
#include "core/job/program_path.h"
#include "tests/core/job/session_milling.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_path_values {

using namespace burin::test;

namespace {

/// A slot along X 1.5 mm deep at 600 mm/min, back 0.5 mm deeper at 300 mm/min, through the middle of the block.
constexpr const char* slot = "G21 G90 G17 G94 G54\nM3 S10000\nG0 X-14 Y0\nZ2\nG1 Z-1.5 F200\nX14 F600\n"
                             "G0 Z5\nX14 Y0\nG1 Z-2 F200\nX-14 F300\nG0 Z5\nM2\n";

struct Milled {
    MilledPath path;
    std::vector<SourceStrokes> sources;
};

Milled milled(const MillingContext& milling, std::vector<Edit> edits) {
    Progress progress;
    const ToolChoice tools{{sessionTool()}, true};
    Result<ProgramPasses> passes = passesOfProgram(slot, "slot.ngc", "linuxcnc", milling, tools, progress);
    if (!passes) qFatal("no program");
    GeneratedMoves moves = passes->passes.front().moves;
    moves.info.id = -1;
    Milled made{{nullptr, milling.tool}, {*strokesOf(moves)}};
    Result<EvaluatedPath> path =
        evaluateStored({*strokesOf(moves)}, milling, milling.tool, {1, "slot", {{-1}}, std::move(edits)}, {}, progress);
    if (!path) qFatal("%s %s", path.error().subject.c_str(), path.error().detail.c_str());
    made.path.evaluated = std::make_shared<const EvaluatedPath>(std::move(*path));
    return made;
}

} // namespace

class TestPathValues : public QObject {
    Q_OBJECT
private slots:
    void namesComeBack() {
        for (const PathQuantity quantity : pathQuantities) {
            QVERIFY(pathQuantityFromId(idOf(quantity)) == quantity);
            QVERIFY(!unitOf(quantity).empty());
        }
        QVERIFY(!pathQuantityFromId("colour"));
    }

    void feedSpeedAndHeightAreThePaths() {
        const Milled path = milled(milling_, programEdits());
        const PathValues feeds = valuesOf(PathQuantity::feed, path), heights = valuesOf(PathQuantity::height, path),
                         speeds = valuesOf(PathQuantity::spindleSpeed, path);
        QCOMPARE(feeds.high, 600.0);
        QCOMPARE(speeds.low, 10000.0);
        QCOMPARE(speeds.high, 10000.0);
        QVERIFY(!feeds.pieces.empty() && feeds.pieces.size() == heights.pieces.size());
        std::size_t level = 0;
        for (std::size_t i = 0; i < feeds.pieces.size(); ++i) {
            const ValuedPiece& piece = feeds.pieces[i];
            const double height = piece.to.z - milling_.setup.workOffset.z;
            if (std::abs(piece.from.z - piece.to.z) > 1e-9 || height > -1.0) continue;
            QVERIFY(std::abs(*heights.pieces[i].value - height) < 1e-9);
            QCOMPARE(*piece.value, height < -1.7 ? 300.0 : 600.0);
            ++level;
        }
        QVERIFY(level >= 2);
    }

    /// In the middle of the slot: area of the ball's segment times feed, and F = 1000 K MRR / v with the wax's constant
    /// K.
    void removalAndForceAreThoseOfTheSlot() {
        const Milled path = milled(milling_, programEdits());
        const PathValues rates = valuesOf(PathQuantity::removalRate, path),
                         forces = valuesOf(PathQuantity::force, path);
        const double radius = 2.0, angle = std::acos(0.5 / radius);
        const double area = radius * radius * angle - 0.5 * std::sqrt(radius * radius - 0.25); // 1.5 mm deep
        const double rate = area * 600.0 / 60.0;
        const double speed = std::acos(-1.0) * 4.0 * 10000.0 / 60.0; // mm/s
        const double force = 1000.0 * 0.06 * rate / speed;
        double meanRate = 0.0, meanForce = 0.0;
        int count = 0;
        for (std::size_t i = 0; i < rates.pieces.size(); ++i) {
            const ValuedPiece& piece = rates.pieces[i];
            const glm::dvec3 middle = 0.5 * (piece.from + piece.to) - milling_.setup.workOffset;
            if (std::abs(middle.x) > 6.0 || std::abs(middle.z + 1.5) > 1e-6) continue;
            meanRate += *piece.value;
            meanForce += *forces.pieces[i].value;
            ++count;
        }
        QVERIFY(count >= 20);
        meanRate /= count;
        meanForce /= count;
        QVERIFY2(std::abs(meanRate / rate - 1.0) < 0.03, qPrintable(QString::number(meanRate / rate)));
        QVERIFY2(std::abs(meanForce / force - 1.0) < 0.05, qPrintable(QString::number(meanForce / force)));
        QCOMPARE(rates.low, 0.0); // before the tool is in the stock
    }

    /// Earlier milling counts: nothing is left to cut for the same path.
    void whatWasMilledBeforeCounts() {
        const Milled path = milled(milling_, programEdits());
        Progress progress;
        const std::vector<MilledPath> before{path.path};
        const Result<PathValues> values =
            pathValues(PathQuantity::removalRate, path.path, before, path.sources, milling_, progress);
        QVERIFY(values);
        // Except for remains of voxels at the ends of intervals: the slot itself removes 20 to 50 mm³/s.
        QVERIFY2(values->high < 1.0, qPrintable(QString::number(values->high)));
    }

    void deviationIsHowFarEditsMovedIt() {
        const Milled same = milled(milling_, {{Link{}}, {SetFeed{}}});
        const PathValues none = valuesOf(PathQuantity::deviation, same);
        QVERIFY(none.high < 1e-9);
        Offset aside;
        aside.distance = 0.75;
        const Milled moved = milled(milling_, {{aside}, {HoldOut{}}, {Link{}}, {SetFeed{}}});
        const PathValues off = valuesOf(PathQuantity::deviation, moved);
        // Along the slots; the move between them was a rapid of the program, which the path's link does not follow.
        for (const ValuedPiece& piece : off.pieces)
            if (std::abs(piece.to.x - piece.from.x) > 20.0)
                QVERIFY2(std::abs(piece.value.value_or(0.0) - 0.75) < 1e-6,
                         qPrintable(QString::number(piece.value.value_or(-1.0))));
        // Links were made by an edit, so there is no recording from which they could deviate.
        QVERIFY(std::ranges::any_of(off.pieces, [](const ValuedPiece& piece) { return !piece.value; }));
    }

    void itCanBeCancelled() {
        const Milled path = milled(milling_, programEdits());
        Progress progress;
        progress.cancel();
        const Result<PathValues> values =
            pathValues(PathQuantity::force, path.path, {}, path.sources, milling_, progress);
        QVERIFY(!values);
        QCOMPARE(values.error().code, ErrorCode::cancelled);
    }

private:
    PathValues valuesOf(PathQuantity quantity, const Milled& path) {
        Progress progress;
        Result<PathValues> values = pathValues(quantity, path.path, {}, path.sources, milling_, progress);
        if (!values) qFatal("no values");
        return std::move(*values);
    }

    MillingContext milling_ = blockMilling();
};

BURIN_TEST(TestPathValues, QCoreApplication)

} // namespace burin::tst_path_values

#include "tst_path_values.moc"
