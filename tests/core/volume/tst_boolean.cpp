// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/boolean.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"

#include <QtTest>
#include <rapidcheck.h>

#include <random>

using namespace burin;
using namespace burin::test;
using burin::oracles::DenseGrid;

namespace {

enum class Operation { unite, intersect, subtract };

PropertyIndex expected(Operation operation, PropertyIndex inA, PropertyIndex inB) {
    switch (operation) {
    case Operation::unite:
        return inA != airProperty ? inA : inB;
    case Operation::intersect:
        return inB != airProperty ? inA : airProperty;
    case Operation::subtract:
        break;
    }
    return inB == airProperty ? inA : airProperty;
}

Result<void> combineInto(Operation operation, RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return operation == Operation::unite       ? uniteInto(result, a, b)
           : operation == Operation::intersect ? intersectInto(result, a, b)
                                               : subtractInto(result, a, b);
}
Result<RunVolume> combined(Operation operation, const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return operation == Operation::unite       ? unionOf(a, b)
           : operation == Operation::intersect ? intersectionOf(a, b)
                                               : differenceOf(a, b);
}

/// Two bricks and a bit each way; unit by unit of 1/256 voxel.
const Grid& grid() {
    static const Grid it = cubeGrid({19, 18, 2});
    return it;
}
constexpr std::size_t reserve = std::size_t{4} << 20;

struct Pair {
    RunVolume volume = emptyVolume(grid(), reserve);
    DenseGrid dense{grid()};

    void fill(LineIndex low, LineIndex high, RunPosition from, RunPosition to, PropertyIndex property) {
        RC_ASSERT(volume.fillBlock(low, high, from, to, property));
        for (std::int32_t v = low.v; v < std::min(high.v, grid().lineCountV()); ++v)
            for (std::int32_t u = low.u; u < std::min(high.u, grid().lineCountU()); ++u)
                dense.fillSpan({u, v}, from, to, property);
    }
};

/// Bricks of air, solid ones and ragged ones.
void scatter(Pair& pair) {
    const int blocks = *rc::gen::inRange(0, 4), lines = *rc::gen::inRange(0, 60);
    for (int i = 0; i < blocks; ++i) {
        const LineIndex low{8 * *rc::gen::inRange(0, 3), 8 * *rc::gen::inRange(0, 3)};
        const auto from = *rc::gen::element<RunPosition>(0, 0, 100), to = *rc::gen::element<RunPosition>(512, 512, 300);
        pair.fill(low, {low.u + 8 * *rc::gen::inRange(1, 4), low.v + 8 * *rc::gen::inRange(1, 4)}, from, to,
                  *rc::gen::inRange<PropertyIndex>(0, 4));
    }
    for (int i = 0; i < lines; ++i) {
        const LineIndex low{*rc::gen::inRange(0, 19), *rc::gen::inRange(0, 18)};
        const auto from = *rc::gen::inRange<RunPosition>(0, 512), to = *rc::gen::inRange<RunPosition>(0, 513);
        pair.fill(low, {low.u + *rc::gen::inRange(1, 4), low.v + 1}, from, to, *rc::gen::inRange<PropertyIndex>(0, 4));
    }
}

/// Leaning layers: neighbouring lines are mostly alike, but ends meet and pass each other here and there, and now and
/// then a line is ragged.
void layer(Pair& pair) {
    const int layers = *rc::gen::inRange(1, 10);
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const int raggedInThousand = *rc::gen::element(0, 0, 20, 500);
    const auto between = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    for (int i = 0; i < layers; ++i) {
        const int from = between(-20, 500), to = from + between(1, 120), perU = between(-3, 3), perV = between(-3, 3);
        const auto property = static_cast<PropertyIndex>(between(0, 3));
        for (LineIndex line; line.v < grid().lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid().lineCountU(); ++line.u) {
                const int off =
                    line.u * perU + line.v * perV + (between(0, 999) < raggedInThousand ? between(-9, 9) : 0);
                const auto at = [&](int end) { return static_cast<RunPosition>(std::clamp(end + off, 0, 512)); };
                pair.fill(line, {line.u + 1, line.v + 1}, at(from), at(to), property);
            }
    }
}

DenseGrid expected(Operation operation, const DenseGrid& a, const DenseGrid& b) {
    DenseGrid result(grid());
    for (LineIndex line; line.v < grid().lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid().lineCountU(); ++line.u)
            for (RunPosition unit = 0; unit < grid().lineEnd(); ++unit)
                result.at(line, unit) = expected(operation, a.at(line, unit), b.at(line, unit));
    return result;
}

Operation anyOperation() {
    return *rc::gen::element(Operation::unite, Operation::intersect, Operation::subtract);
}

PropertyList listOf(std::initializer_list<const char*> ids) {
    PropertyList list;
    for (const char* id : ids) {
        Property property;
        property.id = id;
        (void)list.add(property);
    }
    return list;
}

} // namespace

class TestBoolean : public QObject {
    Q_OBJECT

private slots:
    void wholeBricksAndRaggedOnes() {
        QVERIFY(rc::check("new volumes against a dense grid", [] {
            Pair a, b;
            scatter(a);
            scatter(b);
            const Operation operation = anyOperation();
            const Result<RunVolume> result = combined(operation, a.volume.snapshot(), b.volume.snapshot());
            const DenseGrid dense = expected(operation, a.dense, b.dense);
            RC_ASSERT(dense.equals(*result));
            RC_ASSERT(result->amounts() == dense.amounts());
            RC_ASSERT(a.dense.equals(a.volume) && b.dense.equals(b.volume));
        }));
    }

    void linesThatAreNearlyAlike() {
        QVERIFY(rc::check("leaning layers against a dense grid", [] {
            Pair a, b;
            layer(a);
            layer(b);
            const Operation operation = anyOperation();
            const Result<RunVolume> result = combined(operation, a.volume.snapshot(), b.volume.snapshot());
            const DenseGrid dense = expected(operation, a.dense, b.dense);
            RC_ASSERT(dense.equals(*result));
            RC_ASSERT(result->amounts() == dense.amounts());
        }));
    }

    void intoAVolumeThatStands() {
        QVERIFY(rc::check("a chain of operations in place against a dense grid", [] {
            Pair result, other;
            scatter(result);
            const VolumeSnapshot before = result.volume.snapshot();
            const DenseGrid denseBefore = result.dense;
            const int steps = *rc::gen::inRange(1, 4);
            for (int step = 0; step < steps; ++step) {
                scatter(other);
                const Operation operation = anyOperation();
                const bool turned = *rc::gen::arbitrary<bool>();
                const VolumeSnapshot own = result.volume.snapshot(), others = other.volume.snapshot();
                RC_ASSERT(combineInto(operation, result.volume, turned ? others : own, turned ? own : others));
                result.dense = turned ? expected(operation, other.dense, result.dense)
                                      : expected(operation, result.dense, other.dense);
                RC_ASSERT(result.dense.equals(result.volume));
                RC_ASSERT(result.volume.amounts() == result.dense.amounts());
                RC_ASSERT(denseBefore.equals(before));
            }
        }));
    }

    void propertiesKeepTheirNames() {
        const Grid line = cubeGrid({9, 9, 4});
        const std::size_t room = std::size_t{1} << 20;
        RunVolume a = *RunVolume::make(line, listOf({"wax", "steel"}), room);
        RunVolume b = *RunVolume::make(line, listOf({"steel", "brass"}), room);
        RunVolume result = *RunVolume::make(line, listOf({"brass", "air gun", "steel", "wax"}), room);
        const auto idAt = [](const RunVolume& volume, LineIndex at, std::size_t run) {
            return volume.properties()[volume.line(at)[run].property()].id;
        };
        QVERIFY(a.fillBlock({0, 0}, {9, 9}, 0, 300, 1));   // wax
        QVERIFY(b.fillBlock({0, 0}, {9, 9}, 200, 700, 2)); // brass
        QVERIFY(b.fillBlock({8, 8}, {9, 9}, 0, 700, 1));   // steel, where its brick is cut off by the grid
        QVERIFY(uniteInto(result, a.snapshot(), b.snapshot()));
        QCOMPARE(idAt(result, {3, 3}, 0), std::string("wax"));
        QCOMPARE(idAt(result, {3, 3}, 1), std::string("brass"));
        QCOMPARE(idAt(result, {8, 8}, 1), std::string("steel"));
        QVERIFY(subtractInto(result, b.snapshot(), a.snapshot()));
        QCOMPARE(idAt(result, {3, 3}, 1), std::string("brass"));
        QVERIFY(intersectInto(result, a.snapshot(), b.snapshot()));
        QCOMPARE(idAt(result, {3, 3}, 1), std::string("wax"));
        QVERIFY(result.line({3, 3})[1].end() == 300);

        // What only the second operand of a difference is made of need not be known.
        RunVolume waxAlone = *RunVolume::make(line, listOf({"wax", "steel"}), room);
        QVERIFY(subtractInto(waxAlone, a.snapshot(), b.snapshot()));
        QCOMPARE(uniteInto(waxAlone, a.snapshot(), b.snapshot()).error().place, std::string("brass"));
    }

    void whatFindsNoRoomIsSaid() {
        const Grid wide = cubeGrid({64, 64, 64});
        RunVolume a = emptyVolume(wide), b = emptyVolume(wide), small = emptyVolume(wide, 4096);
        for (LineIndex line; line.v < 64; ++line.v)
            for (line.u = 0; line.u < 64; ++line.u) {
                const auto from = static_cast<RunPosition>(line.u * 100 + line.v);
                QVERIFY(a.fillSpan(line, from, from + 5000, wax) && b.fillSpan(line, from + 300, from + 900, wax));
            }
        QVERIFY(subtractInto(small, a.snapshot(), b.snapshot()).error().code == ErrorCode::volumeOutOfMemory);
    }

    void differentGridsAreRefused() {
        RunVolume a = emptyVolume(cubeGrid({2, 2, 2})), b = emptyVolume(cubeGrid({2, 2, 2}, RunAxis::x));
        QVERIFY(uniteInto(a, a.snapshot(), b.snapshot()).error().code == ErrorCode::argumentInvalid);
        QVERIFY(intersectInto(b, a.snapshot(), a.snapshot()).error().code == ErrorCode::argumentInvalid);
        QVERIFY(subtractInto(a, b.snapshot(), a.snapshot()).error().code == ErrorCode::argumentInvalid);
    }
};

QTEST_APPLESS_MAIN(TestBoolean)
#include "tst_boolean.moc"
