// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/assembly.h"
#include "tests/core/volume/volumes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <map>
#include <random>
#include <stdexcept>

namespace burin::tst_brick_rewrite {

using namespace burin::test;

namespace {

using Lines = std::map<std::pair<int, int>, std::vector<Segment>>; ///< by v and u

std::vector<Segment> copyOf(std::span<const Segment> line) {
    return {line.begin(), line.end()};
}

template <class Volume>
Lines linesOf(const Volume& volume) {
    Lines lines;
    for (LineIndex line; line.v < volume.grid().lineCountV(); ++line.v)
        for (line.u = 0; line.u < volume.grid().lineCountU(); ++line.u)
            lines[{line.v, line.u}] = copyOf(volume.line(line));
    return lines;
}

/// Rising ends, some equal, sometimes adjacent segments of one property.
std::vector<Segment> someSegments(std::mt19937& random, RunPosition lineEnd, int most) {
    std::vector<Segment> segments;
    RunPosition end = 0;
    for (int count = static_cast<int>(random() % static_cast<unsigned>(most + 1)); count > 0; --count) {
        end += static_cast<RunPosition>(random() % (2 * lineEnd / static_cast<unsigned>(most)));
        segments.emplace_back(std::min(end, lineEnd), static_cast<PropertyIndex>(random() % 4));
    }
    segments.emplace_back(lineEnd, airProperty);
    return segments;
}

/// New lines for some bricks of a grid; some bricks get 64 equal ones.
Lines someLines(const Grid& grid, std::mt19937& random, int most) {
    Lines lines;
    for (LineIndex low; low.v < grid.lineCountV(); low.v += brickSide)
        for (low.u = 0; low.u < grid.lineCountU(); low.u += brickSide) {
            if (random() % 4 == 0) continue;
            const bool equal = random() % 3 == 0;
            const auto all = someSegments(random, grid.lineEnd(), 1);
            for (int v = low.v; v < std::min(low.v + brickSide, grid.lineCountV()); ++v)
                for (int u = low.u; u < std::min(low.u + brickSide, grid.lineCountU()); ++u)
                    lines[{v, u}] = equal ? all : someSegments(random, grid.lineEnd(), most);
        }
    return lines;
}

bool rewrite(RunVolume& volume, const Lines& lines) {
    const Grid& grid = volume.grid();
    return volume.rewriteBricks([&](std::int32_t row, BrickSink& sink) {
        BrickLines brick(grid.lineEnd());
        for (LineIndex low{0, row * brickSide}; low.u < grid.lineCountU(); low.u += brickSide) {
            if (!lines.contains({low.v, low.u})) continue;
            brick.clear();
            for (int line = 0; line < linesPerBrick; ++line) {
                const auto found = lines.find({low.v + line / brickSide, low.u + line % brickSide});
                if (found != lines.end()) brick.append(found->second);
                brick.endLine();
            }
            sink.put(low, brick);
        }
    });
}

} // namespace

class TestBrickRewrite : public QObject {
    Q_OBJECT

private slots:
    void itIsTheSameAsSettingEachLine() {
        QVERIFY(rc::check("bricks against lines", [] {
            std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
            const Grid grid = cubeGrid({*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40), *rc::gen::inRange(1, 30)},
                                       static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
            RunVolume byBrick = emptyVolume(grid, 2'000'000), byLine = emptyVolume(grid, 2'000'000);
            std::vector<std::pair<VolumeSnapshot, Lines>> seen;
            for (int round = 0; round < 4; ++round) {
                const Lines lines = someLines(grid, random, round == 2 ? 40 : 4);
                RC_ASSERT(rewrite(byBrick, lines));
                for (const auto& [place, segments] : lines)
                    RC_ASSERT(byLine.setLine({place.second, place.first}, segments));
                RC_ASSERT(linesOf(byBrick) == linesOf(byLine));
                RC_ASSERT(byBrick.amounts() == byLine.amounts());
                RC_ASSERT(byBrick.amounts() == byBrick.snapshot().amounts());
                seen.emplace_back(byBrick.snapshot(), linesOf(byBrick));
                const LineIndex line{static_cast<int>(random()) % grid.lineCountU(), 0};
                if (line.u < 0) continue;
                RC_ASSERT(byBrick.fillSpan(line, 10, 900, wax) && byLine.fillSpan(line, 10, 900, wax));
            }
            for (const auto& [snapshot, lines] : seen) RC_ASSERT(linesOf(snapshot) == lines);
            byBrick.restore(seen[1].first);
            RC_ASSERT(linesOf(byBrick) == seen[1].second);
            RC_ASSERT(byBrick.amounts() == byBrick.snapshot().amounts());
        }));
    }

    void blocksThatAreReplacedComeBack() {
        const Grid grid = cubeGrid({64, 64, 32});
        RunVolume volume = emptyVolume(grid, 300'000);
        std::mt19937 random(7);
        std::size_t most = 0;
        for (int round = 0; round < 40; ++round) { // some 150 kB of runs each time
            const Lines lines = someLines(grid, random, 8);
            QVERIFY(rewrite(volume, lines));
            most = std::max(most, volume.usedBytes());
        }
        QVERIFY(most < 300'000);
        QVERIFY(volume.amounts() == volume.snapshot().amounts());
    }

    void whatFillsTheMemoryHalfIsStillRewrittenRowByRow() {
        // New bricks exist together with the old ones for a while: more than fits at once.
        const Grid grid = cubeGrid({128, 128, 32});
        const auto comb = [&](PropertyIndex property) {
            Lines lines;
            for (int v = 0; v < 128; ++v)
                for (int u = 0; u < 128; ++u)
                    for (RunPosition end = 256; end <= grid.lineEnd(); end += 256)
                        lines[{v, u}].emplace_back(end + static_cast<RunPosition>((u + v) % 2),
                                                   end / 256 % 2 == 0 ? airProperty : property);
            return lines;
        };
        RunVolume volume = emptyVolume(grid, 128 * 128 * 32 * 4 * 5 / 4);
        QVERIFY(rewrite(volume, comb(wax)));
        QVERIFY(volume.usedBytes() > volume.reservedBytes() / 2);
        QVERIFY(rewrite(volume, comb(aluminium)));
        QCOMPARE(volume.amounts().units[wax], std::uint64_t{0});
        QVERIFY(volume.amounts() == volume.snapshot().amounts());
    }

    void usedUpMemoryLeavesAWholeVolume() {
        const Grid grid = cubeGrid({64, 64, 32});
        RunVolume volume = emptyVolume(grid, 20'000);
        const VolumeSnapshot start = volume.snapshot();
        const std::size_t used = volume.usedBytes();
        std::mt19937 random(3);
        const Lines lines = someLines(grid, random, 30);
        QVERIFY(!rewrite(volume, lines));
        QVERIFY(volume.amounts() == volume.snapshot().amounts());
        // Nothing leaked: after restoring the start, the memory that was allocated is free again.
        volume.restore(start);
        QCOMPARE(volume.usedBytes(), used);
    }

    void equalBricksShareOneBlock() {
        const Grid grid = cubeGrid({512, 512, 32});
        RunVolume volume = emptyVolume(grid);
        const std::size_t empty = volume.usedBytes();
        BrickLines brick(grid.lineEnd());
        brick.append(1000, airProperty);
        brick.append(2000, wax);
        brick.endLine();
        brick.repeatFirst();
        QVERIFY(volume.rewriteBricks([&](std::int32_t row, BrickSink& sink) {
            for (LineIndex low{0, row * brickSide}; low.u < grid.lineCountU(); low.u += brickSide) sink.put(low, brick);
        }));
        QVERIFY(volume.usedBytes() < empty + 2000);
        QCOMPARE(volume.amounts().units[wax], std::uint64_t{512 * 512 * 1000});
        QCOMPARE(copyOf(volume.line({511, 3})).size(), std::size_t{3});
        // One of them is changed, the others stay shared.
        QVERIFY(volume.fillSpan({5, 5}, 0, 300, part));
        QCOMPARE(volume.amounts().units[part], std::uint64_t{300});
        QVERIFY(volume.amounts() == volume.snapshot().amounts());
    }

    void aBrickThatIsAlreadySoIsNotWritten() {
        const Grid grid = cubeGrid({32, 32, 32});
        RunVolume volume = emptyVolume(grid);
        std::mt19937 random(11);
        const Lines lines = someLines(grid, random, 5);
        QVERIFY(rewrite(volume, lines));
        const VolumeSnapshot before = volume.snapshot();
        QVERIFY(rewrite(volume, lines));
        const VolumeSnapshot after = volume.snapshot();
        for (int v = 0; v < 32; v += 8)
            for (int u = 0; u < 32; u += 8) QVERIFY(after.sharesBrick(before, {u, v}));
    }

    void anExceptionLeavesAWholeVolume() {
        const Grid grid = cubeGrid({64, 64, 32});
        RunVolume volume = emptyVolume(grid);
        const std::size_t empty = volume.usedBytes();
        const auto failing = [&](std::int32_t row, BrickSink& sink) {
            BrickLines brick(grid.lineEnd());
            for (int line = 0; line < linesPerBrick; ++line) {
                brick.append(static_cast<RunPosition>(100 + line), wax);
                brick.endLine();
            }
            sink.put({0, row * brickSide}, brick);
            if (row == 5) throw std::runtime_error("row 5");
        };
        QVERIFY_EXCEPTION_THROWN((void)volume.rewriteBricks(failing), std::runtime_error);
        QVERIFY(volume.amounts() == volume.snapshot().amounts());
        QCOMPARE(volume.usedBytes(), empty);
    }

    void assemblingFindsTheMemoryThatALatticeNeeds() {
        const Grid grid = cubeGrid({32, 32, 4096});
        const auto describe = [&](std::int32_t row, BrickSink& sink) {
            BrickLines brick(grid.lineEnd());
            for (LineIndex low{0, row * brickSide}; low.u < grid.lineCountU(); low.u += brickSide) {
                brick.clear();
                for (int line = 0; line < linesPerBrick; ++line) {
                    for (RunPosition end = 128; end < grid.lineEnd(); end += 128 + static_cast<RunPosition>(line))
                        brick.append(end, end / 128 % 2 == 0 ? wax : airProperty);
                    brick.endLine();
                }
                sink.put(low, brick);
            }
        };
        const auto volume = assembleBricks(grid, someProperties(), describe, 100'000);
        QVERIFY(volume);
        QVERIFY(volume->usedBytes() > 16'000'000);
        QVERIFY(volume->usedBytes() <= volume->reservedBytes() / 2);
        QVERIFY(volume->amounts().units[wax] > 0);
    }
};

BURIN_TEST(TestBrickRewrite, NoApplication)

} // namespace burin::tst_brick_rewrite

#include "tst_brick_rewrite.moc"
