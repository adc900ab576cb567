// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/boolean.h"
#include "tests/core/volume/volumes.h"
#include "tests/oracles/dense_grid.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <random>

namespace burin::tst_boolean {

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

/// A little more than two bricks in each direction; compared unit by unit of 1/256 voxel.
const Grid& grid() {
    static const Grid it = cubeGrid({19, 18, 2});
    return it;
}
constexpr std::size_t reserve = std::size_t{4} << 20;

struct Pair {
    Pair() : Pair(someProperties()) {}
    explicit Pair(const PropertyList& properties) : volume(*RunVolume::make(grid(), properties, reserve)) {}
    RunVolume volume;
    DenseGrid dense{grid()};

    void fill(LineIndex low, LineIndex high, RunPosition from, RunPosition to, PropertyIndex property) {
        RC_ASSERT(volume.fillBlock(low, high, from, to, property));
        for (std::int32_t v = low.v; v < std::min(high.v, grid().lineCountV()); ++v)
            for (std::int32_t u = low.u; u < std::min(high.u, grid().lineCountU()); ++u)
                dense.fillSpan({u, v}, from, to, property);
    }
};

/// Bricks of air, solid ones and irregular ones.
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

/// Inclined layers: adjacent lines are mostly similar, but ends meet and pass each other in places, and sometimes a
/// line is irregular.
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

/// Properties named by their numbers; protected, because a list may be full of those.
PropertyList protectedList(int first, int last) {
    PropertyList list;
    for (int i = first; i <= last; ++i) {
        Property property;
        property.id = std::to_string(i);
        property.machinability = Machinability::isProtected;
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

        // Properties that only the second operand of a difference contains need not be known.
        RunVolume waxAlone = *RunVolume::make(line, listOf({"wax", "steel"}), room);
        QVERIFY(subtractInto(waxAlone, a.snapshot(), b.snapshot()));
        QCOMPARE(uniteInto(waxAlone, a.snapshot(), b.snapshot()).error().place, std::string("brass"));
    }

    /// The list's last entry, 255, sets all bits of a segment's property: it is a property like the others.
    void fullListsAreJoined() {
        QVERIFY(rc::check("entries of full lists against a dense grid", [] {
            const PropertyList full = protectedList(1, 255);
            Pair a(full), b(full);
            for (Pair* pair : {&a, &b})
                for (int i = *rc::gen::inRange(1, 30); i > 0; --i) {
                    const LineIndex low{*rc::gen::inRange(0, 19), *rc::gen::inRange(0, 18)};
                    pair->fill(low, {low.u + *rc::gen::inRange(1, 12), low.v + *rc::gen::inRange(1, 12)},
                               *rc::gen::inRange<RunPosition>(0, 512), *rc::gen::inRange<RunPosition>(0, 513),
                               *rc::gen::element<PropertyIndex>(0, 1, 127, 128, 254, 255));
                }
            const Operation operation = anyOperation();
            const Result<RunVolume> result = combined(operation, a.volume.snapshot(), b.volume.snapshot());
            const DenseGrid dense = expected(operation, a.dense, b.dense);
            RC_ASSERT(dense.equals(*result));
            RC_ASSERT(result->amounts() == dense.amounts());
            RC_ASSERT(result->properties().size() == 256);
        }));
    }

    void listsThatTogetherAreTooLongAreRefused_data() {
        QTest::addColumn<int>("own");
        QTest::addColumn<int>("others"); // not in the first one's list
        QTest::addColumn<bool>("fits");
        QTest::newRow("full together") << 200 << 55 << true;
        QTest::newRow("one too many") << 200 << 56 << false;
        QTest::newRow("the first one full") << 255 << 1 << false;
        QTest::newRow("both full") << 255 << 255 << false;
    }
    /// Only a union adds the second one's properties; if it can't, it reports that and nothing is changed.
    void listsThatTogetherAreTooLongAreRefused() {
        QFETCH(int, own);
        QFETCH(int, others);
        QFETCH(bool, fits);
        Pair a(protectedList(1, own)), b(protectedList(own + 1, own + others));
        const auto ownLast = static_cast<PropertyIndex>(own), othersLast = static_cast<PropertyIndex>(others);
        a.fill({0, 0}, {12, 18}, 30, 300, ownLast);
        b.fill({5, 3}, {19, 10}, 100, 400, othersLast);
        const VolumeSnapshot first = a.volume.snapshot(), second = b.volume.snapshot();
        const Result<RunVolume> both = unionOf(first, second);
        QCOMPARE(both.hasValue(), fits);
        if (fits) {
            const PropertyList& list = both->properties();
            QCOMPARE(list.size(), 1 + own + others);
            QVERIFY((both->line({0, 0})[1] == Segment(300, ownLast)));
            QCOMPARE(list[both->line({18, 3})[1].property()].id, b.volume.properties()[othersLast].id);
        } else {
            QCOMPARE(both.error().code, ErrorCode::argumentInvalid);
            // The first property that found no room, and the reason.
            const int refused = 256 - own;
            QCOMPARE(both.error().place, b.volume.properties()[static_cast<PropertyIndex>(refused)].id);
            QCOMPARE(both.error().detail, std::string("at most 255 properties beside air"));
        }
        RunVolume common = *intersectionOf(first, second), rest = *differenceOf(first, second);
        QCOMPARE(common.properties().size(), 1 + own);
        QVERIFY((common.line({5, 3})[1] == Segment(300, ownLast)));
        QVERIFY((rest.line({5, 3})[1] == Segment(100, ownLast)));

        // Into a volume that lacks some of them: its contents stay.
        Pair result(a.volume.properties());
        result.fill({2, 2}, {17, 17}, 0, 99, 1);
        const Result<void> into = uniteInto(result.volume, first, second);
        QCOMPARE(into.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(into.error().place, b.volume.properties()[1].id);
        QVERIFY(result.dense.equals(result.volume));
        QVERIFY(a.dense.equals(a.volume) && b.dense.equals(b.volume));
        QVERIFY(a.dense.equals(first) && b.dense.equals(second));
        QCOMPARE(a.volume.properties().size(), 1 + own);
        QCOMPARE(b.volume.properties().size(), 1 + others);
    }

    /// A list has room for fewer machinable materials: the same rule.
    void tooManyMachinableMaterialsAreRefused() {
        RunVolume a = *RunVolume::make(grid(), listOf({"1", "2", "3", "4", "5"}), reserve);
        RunVolume b = *RunVolume::make(grid(), listOf({"5", "6", "7", "8", "9"}), reserve);
        const Result<RunVolume> both = unionOf(a.snapshot(), b.snapshot());
        QCOMPARE(both.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(both.error().place, std::string("9"));
        QCOMPARE(a.properties().size(), 6);
        RunVolume fewer = *RunVolume::make(grid(), listOf({"5", "6", "7", "8"}), reserve);
        QCOMPARE(unionOf(a.snapshot(), fewer.snapshot())->properties().size(), 9);
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

BURIN_TEST(TestBoolean, NoApplication)

} // namespace burin::tst_boolean

#include "tst_boolean.moc"
