// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/growing_field.h"
#include "tests/core/geometry/shapes.h"
#include "tests/oracles/allocation_count.h"
#include "tests/oracles/random_number.h"
#include "tests/random_cases.h"
#include "tests/test_program.h"

#include <QtTest>

#include <rapidcheck.h>

#include <array>
#include <cstdlib>
#include <new>
#include <random>
#include <thread>

namespace burin::tst_growing_field {

namespace {

constexpr double voxel = 0.25, largestAllowance = 1.0;
const glm::dvec3 upright(0.0, 0.0, 1.0);

std::vector<RevolvedPiece> tool(double corner) {
    return {{0.0, 12.0, 2.0, 2.0, corner}, {12.0, 24.0, 1.9, 1.9, 0.0}, {24.0, 40.0, 8.0, 12.0, 0.0}};
}

/// A block with a pocket: sharp edges outside, concave corners inside, and a floor close to the holder.
std::shared_ptr<const MeshDistance> pocketPart() {
    TriangleMesh mesh = shapes::pocket(11.0, 12.0, 6.0, 7.0);
    for (glm::dvec3& vertex : mesh.vertices) vertex.z += 12.0;
    return std::make_shared<const MeshDistance>(mesh);
}
const Box tipsOfPocket{{-20.0, -19.0, -4.0}, {19.0, 21.0, 24.0}};

ToolFieldRequest requestFor(double corner, const Box& tips = tipsOfPocket) {
    return {tool(corner), tips, voxel, largestAllowance};
}

std::shared_ptr<GrowingField> laid(std::shared_ptr<const MeshDistance> part, const ToolFieldRequest& request,
                                   const GrowthLimits& limits = {}) {
    Progress progress;
    auto field = GrowingField::lay(std::move(part), request, limits, progress);
    if (!field) std::abort(); // the test's own set-up
    return *std::move(field);
}

bool make(GrowingField& field, std::uint32_t tile) {
    Progress progress;
    return field.tile(tile, progress).hasValue();
}

glm::dvec3 randomIn(const Box& box) {
    return {test::randomNumber(box.low.x, box.high.x), test::randomNumber(box.low.y, box.high.y),
            test::randomNumber(box.low.z, box.high.z)};
}

/// A point on a face between two tiles, or very close to it.
glm::dvec3 onJoint(const TileLayout& layout) {
    glm::dvec3 tip = randomIn(layout.tips);
    const int axis = *rc::gen::inRange(0, 3);
    const int joint = *rc::gen::inRange(1, std::max(2, layout.tiles[axis]));
    constexpr std::array hairs{-1e-3, -1e-9, 0.0, 1e-9, 1e-3};
    tip[axis] = layout.tips.low[axis] + layout.edge * joint + *rc::gen::elementOf(hairs);
    return glm::clamp(tip, layout.tips.low, layout.tips.high);
}

/// Makes all tiles, without a background thread.
void makeAll(GrowingField& field) {
    for (std::uint32_t tile = 0; tile < field.layout().count(); ++tile)
        if (!make(field, tile)) std::abort(); // the test's own set-up
}

} // namespace

class GrowingFieldTest : public QObject {
    Q_OBJECT
private slots:
    void noAnswerIsAboveItsBoundWhateverHasCome();
    void whatTheOutlineLetsBeStaysOutsideTheBoundary();
    void tilesMeetWithoutAStep();
    void theOrderOfTilesChangesNothing();
    void aToolGoesFreeWhereItIsClear();
    void tilesComeInTheOrderOfTheirDistance();
    void aRovingToolFindsItsTilesInBoundedMemory();
    void askingDoesNotAllocate();
    void canBeCancelled();
    void refusesWhatMakesNoField();
};

/// Tiles arrive in random order; after each of them the field is queried, mainly on joints. The mesh is the reference.
void GrowingFieldTest::noAnswerIsAboveItsBoundWhateverHasCome() {
    const std::shared_ptr<const MeshDistance> part = pocketPart();
    int fine = 0; // with all tiles
    const bool held = testing::holdsInShare("ball, bull nose and flat end", [&] {
        const double corner = *rc::gen::element(0.0, 0.7, 2.0);
        const ToolFieldRequest request = requestFor(corner);
        const auto field = laid(part, request);
        RC_ASSERT(field->layout().count() >= 12U);
        int outlined = 0;
        for (int round = 0; round < 5; ++round) {
            RC_ASSERT(make(*field, *rc::gen::inRange<std::uint32_t>(0, field->layout().count())));
            for (int i = 0; i < 150; ++i) {
                const glm::dvec3 tip = i % 3 == 0 ? randomIn(request.tips) : onJoint(field->layout());
                const FieldSample sample = field->at(tip);
                const double exact = part->clearance(request.tool, {tip, upright}).clearance;
                (sample.fine ? fine : outlined) += 1;
                RC_ASSERT(isFinite(sample.gradient));
                if (exact < -voxel && sample.clearance < -0.5 * voxel) continue; // only the exit matters there
                RC_ASSERT(sample.clearance <= exact + field->errorBoundAt(tip) + 1e-6);
            }
        }
        RC_ASSERT(outlined > 100);
    });
    QVERIFY(held && fine > testing::inLongRun(2000, 400));
}

/// A tool that the outline held, or did not hold, is not inside the boundary when the tile arrives, whatever the
/// allowance: it is not pushed out of its position.
void GrowingFieldTest::whatTheOutlineLetsBeStaysOutsideTheBoundary() {
    for (const double corner : {0.0, 2.0}) {
        const ToolFieldRequest request = requestFor(corner);
        const auto field = laid(pocketPart(), request);
        std::mt19937 engine(3);
        std::vector<std::pair<glm::dvec3, double>> tips;
        for (int i = 0; i < 60000; ++i) {
            std::uniform_real_distribution<double> share(0.0, 1.0);
            const glm::dvec3 tip = request.tips.low + glm::dvec3(share(engine), share(engine), share(engine)) *
                                                          (request.tips.high - request.tips.low);
            tips.emplace_back(tip, field->at(tip).clearance);
        }
        makeAll(*field);
        int held = 0;
        for (const auto& [tip, outline] : tips) {
            const double now = field->at(tip).clearance;
            const double kept = std::min(outline, largestAllowance);
            if (outline >= 0.0 && outline < largestAllowance) ++held;
            QVERIFY2(kept < 0.0 || now >= kept, qPrintable(QString("%1 before, %2 now").arg(outline).arg(now)));
        }
        QVERIFY(held > 300);
    }
}

/// Over smooth faces the field states its error, and so do two tiles at their joint: a tool that slides over the joint
/// meets no larger step than between two bricks anywhere.
void GrowingFieldTest::tilesMeetWithoutAStep() {
    const Box tips{{-16.0, -16.0, 2.0}, {16.0, 16.0, 12.0}};
    const auto field = laid(std::make_shared<const MeshDistance>(shapes::sphere(10.0, 400, 200)),
                            {{{0.0, 12.0, 2.0, 2.0, 2.0}}, tips, voxel, largestAllowance});
    makeAll(*field);
    const TileLayout& layout = field->layout();
    QVERIFY(layout.tiles.x >= 2 && layout.tiles.y >= 2);
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    int met = 0;
    double largest = 0.0;
    for (int i = 0; i < 40000; ++i) {
        glm::dvec3 tip = tips.low + glm::dvec3(share(engine), share(engine), share(engine)) * (tips.high - tips.low);
        const int axis = i % 2;
        tip[axis] = layout.tips.low[axis] + layout.edge * (1 + i / 2 % (layout.tiles[axis] - 1));
        glm::dvec3 below = tip;
        below[axis] -= 1e-9;
        if (layout.tileOf(tip) == layout.tileOf(below)) continue;
        const FieldSample one = field->at(tip), other = field->at(below);
        if (!one.fine || !other.fine || one.clearance < -voxel) continue;
        ++met;
        largest = std::max(largest, std::abs(one.clearance - other.clearance));
    }
    QVERIFY(met > 2000);
    QVERIFY2(largest <= field->errorBound(), qPrintable(QString("%1 mm").arg(largest)));
}

/// The contents of a tile depend only on its number and the request: a session that is replayed meets the same
/// boundary.
void GrowingFieldTest::theOrderOfTilesChangesNothing() {
    const auto inOrder = laid(pocketPart(), requestFor(0.7)), background = laid(pocketPart(), requestFor(0.7)),
               atOnce = laid(pocketPart(), requestFor(0.7));
    makeAll(*inOrder);
    Progress progress;
    background->grow({20.0, -20.0, 3.0});
    QVERIFY(background->waitUntilQuiet(progress, 300.0) && atOnce->finish(progress));
    QVERIFY(inOrder->complete() && background->complete() && atOnce->whole());
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> share(-0.05, 1.05);
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 tip = tipsOfPocket.low + glm::dvec3(share(engine), share(engine), share(engine)) *
                                                      (tipsOfPocket.high - tipsOfPocket.low);
        const FieldSample one = inOrder->at(tip), other = background->at(tip), third = atOnce->at(tip);
        QVERIFY(one.clearance == other.clearance && one.gradient == other.gradient && one.fine == other.fine);
        QVERIFY(one.clearance == third.clearance && one.gradient == third.gradient && one.fine == third.fine);
    }
}

/// As with a field that was made at once: a tool whose clearance exceeds the largest allowance by a tenth of a voxel is
/// held by nothing; also where no tile arrives.
void GrowingFieldTest::aToolGoesFreeWhereItIsClear() {
    const ToolFieldRequest request = requestFor(2.0);
    const std::shared_ptr<const MeshDistance> part = pocketPart();
    const auto field = laid(part, request);
    makeAll(*field);
    std::mt19937 engine(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    int clear = 0;
    for (int i = 0; i < 40000; ++i) {
        const glm::dvec3 tip = request.tips.low + glm::dvec3(share(engine), share(engine), share(engine)) *
                                                      (request.tips.high - request.tips.low);
        if (part->clearance(request.tool, {tip, upright}).clearance < largestAllowance + 0.1 * voxel) continue;
        ++clear;
        QVERIFY(field->at(tip).clearance >= largestAllowance);
    }
    QVERIFY(clear > 10000);
}

void GrowingFieldTest::tilesComeInTheOrderOfTheirDistance() {
    const glm::dvec3 tip(-8.0, 9.0, 13.0);
    const auto field = laid(pocketPart(), requestFor(2.0), {std::size_t{1} << 30U, 1});
    field->grow(tip);
    const std::shared_ptr<TileFeed> feed = field->feed();
    feed->toolAt(tip);
    Progress progress;
    QVERIFY(field->waitUntilQuiet(progress, 300.0));
    double before = 0.0;
    int count = 0;
    for (TileNews news; feed->next(news); ++count) {
        QVERIFY(news.bricks != nullptr);
        const double distance = field->layout().distance(news.tile, tip);
        QVERIFY(distance >= before);
        before = distance;
    }
    QVERIFY2(count >= 8 && before > 5.0, qPrintable(QString("%1 tiles, up to %2 mm").arg(count).arg(before)));
}

/// A tool moves back and forth with memory for a few tiles only: those around it arrive, others are released, and tiles
/// that it reads stay until it has let go of them.
void GrowingFieldTest::aRovingToolFindsItsTilesInBoundedMemory() {
    ToolFieldRequest request = requestFor(2.0, {{-14.0, -14.0, 2.0}, {14.0, 14.0, 16.0}});
    request.voxel = 0.12;
    const auto all = laid(pocketPart(), request);
    makeAll(*all);
    const std::size_t limit = all->memoryBytes() / 4;
    const auto field = laid(pocketPart(), request, {limit, 2});
    const TileLayout& layout = field->layout();
    std::vector<const BrickField*> inForce(layout.count(), nullptr);
    const std::shared_ptr<TileFeed> feed = field->feed();
    int let = 0, kept = 0;
    std::size_t most = 0;
    const auto read = [&](const glm::dvec3& tip) {
        feed->toolAt(tip);
        for (TileNews news; feed->next(news);) {
            if (news.bricks == nullptr) {
                const bool letsGo = layout.distance(news.tile, tip) > 0.0 && (let + kept) % 5 != 4;
                if (letsGo) inForce[news.tile] = nullptr;
                ++(letsGo ? let : kept);
                feed->answer(news.tile, letsGo);
            } else {
                inForce[news.tile] = news.bricks;
            }
        }
        for (const BrickField* tile : inForce) // all of its tiles are readable
            if (tile != nullptr && !std::isfinite(tile->sample(tile->tips.centre()).clearance)) return false;
        most = std::max(most, field->memoryBytes());
        return true;
    };
    constexpr std::array<glm::dvec3, 5> stops{
        glm::dvec3(-12.0, -12.0, 10.0), {12.0, 12.0, 10.0}, {0.0, 0.0, 6.0}, {-12.0, 12.0, 10.0}, {12.0, -12.0, 3.0}};
    for (int round = 0; round < 2; ++round)
        for (const glm::dvec3& stop : stops) {
            const std::uint32_t under = layout.tileOf(stop);
            for (int wait = 0; wait < 20000 && inForce[under] == nullptr; ++wait) {
                QVERIFY(read(stop));
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            QVERIFY2(inForce[under] != nullptr,
                     qPrintable(QString("round %1, no tile at (%2, %3, %4), %5 let go, %6 kept")
                                    .arg(round)
                                    .arg(stop.x)
                                    .arg(stop.y)
                                    .arg(stop.z)
                                    .arg(let)
                                    .arg(kept)));
        }
    // The number depends on the progress of the tiles while the tool waits; of every five, one is kept.
    QVERIFY2(let >= 5 && kept > 0, qPrintable(QString("%1 let go, %2 kept").arg(let).arg(kept)));
    QVERIFY2(most < limit + all->memoryBytes() / 3, qPrintable(QString("%1 of %2").arg(most).arg(all->memoryBytes())));
}

void GrowingFieldTest::askingDoesNotAllocate() {
    const auto field = laid(pocketPart(), requestFor(2.0));
    QVERIFY(make(*field, field->layout().tileOf({0.0, 0.0, 6.0})));
    TileFeed feed(field->layout().count());
    double sum = 0.0;
    const std::size_t before = allocationCount.load();
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 tip(0.01 * i - 10.0, 3.0, 5.0 + 0.005 * i);
        sum += field->at(tip).clearance + field->outline(tip).clearance + field->errorBoundAt(tip);
        feed.toolAt(tip);
        TileNews news;
        if (feed.next(news)) feed.answer(news.tile, true);
    }
    QCOMPARE(allocationCount.load(), before);
    QVERIFY(std::isfinite(sum));
}

void GrowingFieldTest::canBeCancelled() {
    Progress cancelled;
    cancelled.cancel();
    const auto none = GrowingField::lay(pocketPart(), requestFor(2.0), {}, cancelled);
    QVERIFY(!none && none.error().code == ErrorCode::cancelled);
    const auto field = laid(pocketPart(), requestFor(2.0));
    const Result<void> whole = field->finish(cancelled);
    QVERIFY(!whole && whole.error().code == ErrorCode::cancelled && !field->whole());
    field->grow({0.0, 0.0, 20.0});
    QVERIFY(!field->waitUntilQuiet(cancelled, 100.0)); // and destroying it stops ongoing work
}

void GrowingFieldTest::refusesWhatMakesNoField() {
    Progress progress;
    const auto code = [&](const ToolFieldRequest& request) {
        const auto field = GrowingField::lay(pocketPart(), request, {}, progress);
        return field ? ErrorCode::internalFault : field.error().code;
    };
    QCOMPARE(code({{}, tipsOfPocket, voxel, 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({tool(2.0), tipsOfPocket, 0.0, 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({tool(2.0), Box(), voxel, 1.0}), ErrorCode::argumentInvalid);
    QCOMPARE(code({tool(2.0), {glm::dvec3(-1e9), glm::dvec3(1e9)}, 1e-3, 1.0}), ErrorCode::outOfMemory);
    QVERIFY(!laid(pocketPart(), requestFor(2.0))->tile(1U << 20U, progress));
}

BURIN_TEST(GrowingFieldTest, NoApplication)

} // namespace burin::tst_growing_field

#include "tst_growing_field.moc"
