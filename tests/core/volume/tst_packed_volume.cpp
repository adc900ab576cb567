// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/packed_volume.h"
#include "core/volume/runs/volume_memory.h"
#include "tests/core/volume/random_volumes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_packed_volume {

using namespace burin::test;

namespace {

PackedVolume packedOf(const VolumeSnapshot& snapshot) {
    Progress progress;
    return PackedVolume::pack(snapshot, progress).value();
}

/// Lines of a packed volume in the form in which a volume returns them.
struct PackedLines {
    const PackedVolume& volume;
    const Grid& grid() const { return volume.grid(); }
    std::vector<Segment> line(LineIndex line) const { return volume.line(line); }
};

TileView viewOf(const BrickLines& lines) {
    TileView view;
    for (int i = 0; i < linesPerTile; ++i) view[static_cast<std::size_t>(i)] = lines.line(i);
    return view;
}

bool sameLines(const BrickLines& a, const BrickLines& b) {
    for (int i = 0; i < linesPerTile; ++i)
        if (!std::ranges::equal(a.line(i), b.line(i))) return false;
    return true;
}

/// A tile with one surface: `height(u, v)` in run units.
template <class Height>
BrickLines surfaceTile(RunPosition lineEnd, Height height) {
    BrickLines tile(lineEnd);
    for (int line = 0; line < linesPerTile; ++line) {
        tile.append(static_cast<RunPosition>(height(line % 8, line / 8)), wax);
        tile.endLine();
    }
    return tile;
}

std::size_t packedSize(const BrickLines& tile, const PackedTileFrame& frame) {
    std::string bytes;
    TilePacker(frame).pack(viewOf(tile), bytes);
    return bytes.size();
}

} // namespace

class TestPackedVolume : public QObject {
    Q_OBJECT

private slots:
    void anyVolumeComesBack() {
        QVERIFY(rc::check("packed, read line by line, and back", [] {
            const Grid grid = randomGrid(*rc::gen::arbitrary<std::uint32_t>(), 40);
            const auto content = static_cast<Content>(*rc::gen::inRange(0, contentCount));
            RunVolume volume = emptyVolume(grid, std::size_t{8} << 20);
            RandomContent(*rc::gen::arbitrary<std::uint32_t>(), content).fill(volume);
            const LineCopies copies(volume);
            const PackedVolume packed = packedOf(volume.snapshot());
            RC_ASSERT(copies.equals(PackedLines{packed}));
            RC_ASSERT(packed.amounts() == copies.amounts());
            Progress progress;
            const RunVolume back = packed.unpack(progress).value();
            RC_ASSERT(copies.equals(back));
            RC_ASSERT(back.amounts() == copies.amounts());
        }));
    }

    void anUnpackedVolumeIsEditedLikeAnother() {
        const Grid grid = cubeGrid({40, 24, 64});
        RunVolume volume = emptyVolume(grid);
        QVERIFY(volume.fillBlock({0, 0}, {40, 24}, 100, 9000, wax)); // bricks share memory
        Progress progress;
        RunVolume back = packedOf(volume.snapshot()).unpack(progress).value();
        RunAmounts removed;
        for (LineIndex line{3, 0}; line.v < 24; ++line.v) {
            QVERIFY(volume.removeSpan(line, 500, 700, removed) == Removal::removed);
            QVERIFY(back.removeSpan(line, 500, 700, removed) == Removal::removed);
        }
        QVERIFY(LineCopies(volume).equals(back));
        QVERIFY(back.snapshot().amounts() == volume.amounts());
    }

    /// Slopes of integer values leave almost no residuals: 64 ends take a few bytes.
    void surfacesTakeWhatTheirShapeTakes() {
        const PackedTileFrame frame{1U << 18, 4};
        const std::size_t level = packedSize(surfaceTile(frame.lineEnd, [](int, int) { return 70000; }), frame);
        const std::size_t plane =
            packedSize(surfaceTile(frame.lineEnd, [](int u, int v) { return 70000 + 37 * u - 91 * v; }), frame);
        const std::size_t bowl = packedSize(
            surfaceTile(frame.lineEnd, [](int u, int v) { return 70000 + 5 * u * u - 3 * u * v + 9 * v * v; }), frame);
        QVERIFY2(level <= 8, qPrintable(QString::number(level)));
        QVERIFY2(plane <= 16, qPrintable(QString::number(plane)));
        QVERIFY2(bowl <= 24, qPrintable(QString::number(bowl)));
    }

    void aTileOfMoreThan65535SegmentsComesBack() {
        const PackedTileFrame frame{32768 * unitsPerVoxel, 256};
        BrickLines tile(frame.lineEnd);
        for (RunPosition line = 0; line < linesPerTile; ++line) {
            const RunPosition step = line < 4 ? 101 : 4001; // lines of 83,000 segments, of 2,100
            auto property = static_cast<PropertyIndex>(line);
            for (RunPosition at = step; at < frame.lineEnd; at += step + at % 7)
                tile.append(at, property = static_cast<PropertyIndex>(property * 5 + 3));
            tile.append(frame.lineEnd, static_cast<PropertyIndex>(property + 1));
            tile.endLine();
        }
        QVERIFY(tile.segmentCount() > 400000);
        std::string bytes = "before";
        TilePacker(frame).pack(viewOf(tile), bytes);
        BrickLines back(frame.lineEnd);
        std::size_t length = 0;
        QVERIFY(unpackTile(std::string_view(bytes).substr(6), frame, back, &length));
        QVERIFY(sameLines(tile, back));
        QCOMPARE(length, bytes.size() - 6);
    }

    /// For any bytes, the lines read are without gaps, rise and end at the line end, or the bytes are refused.
    void damagedBytesGiveSoundLinesOrNone() {
        const PackedTileFrame frame{1U << 14, 4};
        int refused = 0, read = 0;
        const bool held = rc::check("flipped, cut or made up", [&] {
            RunVolume volume = emptyVolume(cubeGrid({8, 8, 64}));
            RandomContent(*rc::gen::arbitrary<std::uint32_t>(), static_cast<Content>(*rc::gen::inRange(0, 6)))
                .fill(volume);
            std::string bytes;
            TileView lines;
            for (int i = 0; i < linesPerTile; ++i) lines[static_cast<std::size_t>(i)] = volume.line({i % 8, i / 8});
            TilePacker(frame).pack(lines, bytes);
            for (int flips = *rc::gen::inRange(1, 4); flips > 0; --flips)
                bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] ^=
                    static_cast<char>(1 << *rc::gen::inRange(0, 8));
            if (*rc::gen::inRange(0, 4) == 0) bytes.resize(*rc::gen::inRange<std::size_t>(0, bytes.size()));
            BrickLines tile(frame.lineEnd);
            if (!unpackTile(bytes, frame, tile)) {
                ++refused;
                return;
            }
            ++read;
            for (int i = 0; i < linesPerTile; ++i) {
                const auto line = tile.line(i);
                RC_ASSERT(!line.empty());
                RC_ASSERT(line.back().end() == frame.lineEnd);
                RunPosition before = 0;
                for (const Segment segment : line) {
                    RC_ASSERT(segment.end() > before);
                    RC_ASSERT(segment.property() < frame.properties);
                    before = segment.end();
                }
            }
        });
        QVERIFY(held);
        QVERIFY(refused > 0 && read > 0);
    }

    /// A property that occurred twice in a brick's palette would let one run follow another of the same property.
    void aPaletteThatDoesNotRiseIsRefused() {
        const PackedTileFrame frame{1024, 41};
        const auto isRead = [&](PropertyIndex first, PropertyIndex second) {
            std::string bytes;
            BitWriter writer(bytes);
            writer.putNumber(1); // two properties in the palette
            writer.put(first, 6);
            writer.put(second, 6);
            writer.putNumber(0); // one group
            writer.putNumber(1); // of two segments, the first of the first property
            writer.put(0, 1);
            writer.put(0, 1 + 2 + 5); // predicted, constant, nothing left
            writer.put(9, 6);
            writer.put(300, 9);
            writer.finish();
            BrickLines tile(frame.lineEnd);
            if (!unpackTile(bytes, frame, tile)) return false;
            return tile.line(63)[0] == Segment(300, first) && tile.line(63)[1] == Segment(1024, second);
        };
        QVERIFY(isRead(5, 6));
        QVERIFY(!isRead(5, 5));
        QVERIFY(!isRead(6, 5));
    }

    void packingCanBeStopped() {
        RunVolume volume = emptyVolume(cubeGrid({16, 16, 16}));
        Progress progress;
        progress.cancel();
        QCOMPARE(PackedVolume::pack(volume.snapshot(), progress).error().code, ErrorCode::cancelled);
        QCOMPARE(packedOf(volume.snapshot()).unpack(progress).error().code, ErrorCode::cancelled);
    }

    /// The parts add up to the memory allocated by the arena, and shared bricks count once.
    void memoryIsCountedToTheByte() {
        const Grid grid = cubeGrid({61, 43, 64});
        RunVolume volume = emptyVolume(grid);
        QVERIFY(volume.fillBlock({0, 0}, {61, 43}, 100, 9000, wax));
        const VolumeMemory filled = memoryOf(volume.snapshot());
        QCOMPARE(filled.runs, std::size_t{61 * 43});
        QCOMPARE(filled.lines, std::size_t{61 * 43});
        QCOMPARE(filled.places, std::size_t{8 * 6});
        QCOMPARE(filled.tiles, std::size_t{1 + 8 + 5}); // inner ones are shared, those at the rim are not
        RandomContent(5, Content::creases).fill(volume);
        (void)volume.snapshot();
        const VolumeMemory memory = memoryOf(volume.snapshot());
        std::size_t segments = 0, runs = 0;
        for (LineIndex line; line.v < 43; ++line.v)
            for (line.u = 0; line.u < 61; ++line.u)
                for (const Segment segment : volume.line(line)) {
                    ++segments;
                    if (segment.property() != airProperty) ++runs;
                }
        QCOMPARE(memory.tiles, memory.places);
        QCOMPARE(memory.runs, runs);
        QCOMPARE(memory.segmentBytes, (segments + (64 * 48 - 61 * 43)) * sizeof(Segment)); // air outside the grid
        const std::size_t root = sizeof(std::uint32_t); // one page, in the snapshot itself
        QCOMPARE(memory.bytes() - root, volume.usedBytes());
    }

    void whatASnapshotHoldsBackComesFreeWithIt() {
        const Grid grid = cubeGrid({64, 64, 64});
        RunVolume volume = emptyVolume(grid);
        RandomContent(5, Content::sheets).fill(volume);
        (void)volume.snapshot();
        VolumeSnapshot before = volume.snapshot();
        RunAmounts removed;
        for (LineIndex line; line.v < 20; ++line.v)
            for (line.u = 8; line.u < 40; ++line.u) (void)volume.removeSpan(line, 3000, 5000, removed);
        const VolumeSnapshot now = volume.snapshot();
        const std::size_t held = bytesHeldBack(before, now), used = volume.usedBytes();
        before = {};
        QVERIFY(held > 12 * 64);
        QCOMPARE(used - volume.usedBytes(), held);
        QCOMPARE(bytesHeldBack(now, now), std::size_t{0});
    }
};

BURIN_TEST(TestPackedVolume, NoApplication)

} // namespace burin::tst_packed_volume

#include "tst_packed_volume.moc"
