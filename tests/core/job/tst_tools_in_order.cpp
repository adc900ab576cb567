// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/job_paths.h"
#include "core/path/path_removal.h"
#include "tests/core/job/session_milling.h"
#include "tests/core/path/path_fixture.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_tools_in_order {

using namespace burin::test;

namespace {

constexpr double depth = 2.0, diameter = 6.0;
const Box plate{{0, 0, 0}, {40, 20, 10}}; // mm

Tool flat(const char* id, int number, double width) {
    Tool tool = flatTool(width);
    tool.id = id;
    tool.number = number;
    tool.maximumSpindleSpeed = 20000.0;
    tool.maximumDepthOfCut = 5.0;
    tool.fluteCount = 2;
    return tool;
}

MillingContext plateMilling(const Tool& tool) {
    Setup setup = blockSetup();
    setup.voxel = 0.25;
    setup.stock = plate;
    setup.workOffset = {20, 10, 10};
    Progress progress;
    Result<MillingContext> milling =
        makeMillingContext({std::make_shared<const Model>(), setup, tool, "linuxcnc-mill", {}}, progress);
    if (!milling) std::abort(); // the test's own set-up
    return *std::move(milling);
}

/// A path of one recording along a polyline. @param from, to mm, tip
PathMatter matter(std::int64_t id, const Tool& tool, const std::vector<glm::dvec3>& corners,
                  const std::vector<Edit>& tuning = {}, double allowance = 0.0) {
    PathMatter made;
    made.path.id = id;
    made.path.sources = {{id}};
    made.path.edits = {{Simplify{}}, {Link{}}, {SetFeed{}}};
    made.path.edits.insert(made.path.edits.end(), tuning.begin(), tuning.end());
    made.tool = tool;
    Take take = takeOf(along(corners, 50.0), allowance);
    take.info.id = id;
    take.info.toolId = tool.id;
    made.sources = {*recordedStrokes(take)};
    return made;
}

/// The rougher's slot, along X through the centre of the plate; it ends at x = 13.
PathMatter slot() {
    return matter(1, flat("rougher", 1, diameter), {{-10, 10, 8}, {10, 10, 8}}, {}, 0.5);
}

FeedOptimisation levelRemoval() {
    FeedOptimisation edit;
    edit.goal = FeedOptimisation::Goal::removal;
    edit.target = 100.0; // mm³/s
    return edit;
}

/// Mills each path after those before it.
Result<std::vector<MilledPath>> milledInTurn(const MillingContext& milling, const std::vector<PathMatter>& matters) {
    Progress progress;
    std::vector<MilledPath> milled;
    for (const PathMatter& each : matters) {
        Result<EvaluatedPath> path = evaluateStored(each.sources, milling, each.tool, each.path, milled, progress);
        if (!path) return path.error();
        milled.push_back({std::make_shared<const EvaluatedPath>(std::move(*path)), each.tool});
    }
    return milled;
}

Result<EvaluatedPath> lastOf(const std::vector<PathMatter>& matters) {
    const Result<std::vector<MilledPath>> milled = milledInTurn(plateMilling(matters.front().tool), matters);
    if (!milled) return milled.error();
    return *milled->back().evaluated;
}

/// Lowest and highest feed of the cuts over an interval of x.
std::pair<double, double> feedsWithin(const Path& path, double from, double to) {
    double least = 1e9, most = 0.0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const double low = path.points[i - 1].pose.tip.x, high = path.points[i].pose.tip.x;
        if (path.points[i].kind != MoveKind::cut || high < from || low > to) continue;
        least = std::min(least, path.points[i].feed);
        most = std::max(most, path.points[i].feed);
    }
    return {least, most};
}

double lengthOn(const EvaluatedPath& path, MillingSide side) {
    double length = 0.0;
    for (const MillingInterval& interval : path.sides)
        for (std::size_t i = interval.first; interval.side == side && i <= interval.last; ++i)
            length += glm::distance(path.path.points[i - 1].pose.tip, path.path.points[i].pose.tip);
    return length;
}

/// The end point of the first rapid down.
double firstPlungeFrom(const Path& path) {
    for (std::size_t i = 1; i < path.points.size(); ++i)
        if (path.points[i].kind == MoveKind::plunge) return path.points[i - 1].pose.tip.z;
    return -1.0;
}

} // namespace

/// The stock that a tool meets after other tools.
class TestToolsInOrder : public QObject {
    Q_OBJECT
private slots:
    void feedsAreThoseOfTheAirWhereTheToolBeforeHasBeen();
    void rapidsGoDownIntoWhatTheToolBeforeCleared();
    void sidesAreThoseThatTheToolBeforeLeft();
    void theOrderIsTheProgramsWhicheverWasGivenFirst();
    void aKeptPathCountsOnlyBehindTheSamePaths();
    void whatIsCutOfALentStockIsForgotten();
    void aStockIsLentWhereverItCanBeCutAtAll();
    void theRequestToStopIsHeard();
};

void TestToolsInOrder::feedsAreThoseOfTheAirWhereTheToolBeforeHasBeen() {
    const PathMatter follower =
        matter(2, flat("follower", 2, diameter), {{-10, 10, 8}, {50, 10, 8}}, {{levelRemoval()}});
    const auto alone = lastOf({follower}), behind = lastOf({slot(), follower});
    QVERIFY(alone && behind);
    const MillingContext milling = plateMilling(follower.tool);
    const double inAir =
        std::min(milling.machine.maximumFeed, behind->path.spindleSpeed * 2 * levelRemoval().largestChip);
    const double inSlot = 60.0 * levelRemoval().target / (diameter * depth); // mm/min: width x depth x feed
    qInfo() << "in air" << inAir << "in a full slot" << inSlot << "mm/min";
    QVERIFY(inAir > 2.0 * inSlot);
    // Before the end of the cleared region, at 10 mm, it slows down: v² = v'² + 2 a s.
    const double braking =
        (std::pow(inAir / 60.0, 2) - std::pow(inSlot / 60.0, 2)) / (2.0 * milling.machine.acceleration);
    QVERIFY(braking < 8.0);
    const auto [least, most] = feedsWithin(behind->path, -3.0, 9.0 - braking);
    QVERIFY2(most <= inAir && least >= inAir / (1.0 + levelRemoval().leastChange),
             qPrintable(QString("%1 %2").arg(least).arg(most)));
    for (const EvaluatedPath& path : {*alone, *behind}) {
        const auto [low, high] = feedsWithin(path.path, 18.0, 35.0);
        QVERIFY2(low > 0.85 * inSlot && high < 1.1 * inSlot, qPrintable(QString("%1 %2").arg(low).arg(high)));
    }
    QVERIFY(feedsWithin(alone->path, 4.5, 8.0).second < 1.1 * inSlot);
}

void TestToolsInOrder::rapidsGoDownIntoWhatTheToolBeforeCleared() {
    const PathMatter narrow = matter(2, flat("narrow", 2, 4.0), {{5, 10, 6}, {8, 10, 6}});
    const auto alone = lastOf({narrow}), behind = lastOf({slot(), narrow});
    QVERIFY(alone && behind);
    const double approach = Link{}.approach;
    QCOMPARE(firstPlungeFrom(alone->path), 10.0 + approach);
    QCOMPARE(firstPlungeFrom(behind->path), 8.0 + approach);
    // Where only a part of the tool is over the cleared region, the plate's top counts.
    const PathMatter astride = matter(2, flat("narrow", 2, 4.0), {{5, 12, 6}, {8, 12, 6}});
    const auto held = lastOf({slot(), astride});
    QVERIFY(held);
    QCOMPARE(firstPlungeFrom(held->path), 10.0 + approach);
}

void TestToolsInOrder::sidesAreThoseThatTheToolBeforeLeft() {
    // Along the slot's wall at y = 7, which is to the right of the motion: climb.
    const PathMatter wall = matter(2, flat("narrow", 2, 4.0), {{1, 8, 8}, {6, 8, 8}});
    const auto alone = lastOf({wall}), behind = lastOf({slot(), wall});
    QVERIFY(alone && behind);
    QVERIFY(lengthOn(*alone, MillingSide::climb) < 1.0);
    QVERIFY(lengthOn(*behind, MillingSide::climb) > 4.0 && lengthOn(*behind, MillingSide::conventional) < 1.0);
}

/// The rougher is milled first, and the follower's feeds show it.
void TestToolsInOrder::theOrderIsTheProgramsWhicheverWasGivenFirst() {
    const PathMatter follower =
        matter(2, flat("follower", 2, diameter), {{-10, 10, 8}, {50, 10, 8}}, {{levelRemoval()}});
    const MillingContext milling = plateMilling(follower.tool);
    Progress progress;
    const auto one = evaluateInOrder(milling, {slot(), follower}, progress),
               other = evaluateInOrder(milling, {follower, slot()}, progress);
    QVERIFY(one && other);
    for (const auto& job : {*one, *other}) {
        QCOMPARE(job.program.paths.size(), std::size_t{2});
        QCOMPARE(job.program.paths[0].toolId, std::string("rougher"));
        QVERIFY(feedsWithin(job.program.paths[1], 3.0, 5.0).first > 1000.0);
    }
    QVERIFY(progress.fraction() > 0.99);
}

void TestToolsInOrder::aKeptPathCountsOnlyBehindTheSamePaths() {
    PathMatter first = slot(),
               follower = matter(2, flat("follower", 2, diameter), {{-10, 10, 8}, {50, 10, 8}}, {{levelRemoval()}});
    const MillingContext milling = plateMilling(first.tool);
    Progress progress;
    const auto path = evaluateStored(follower.sources, milling, follower.tool, follower.path, {}, progress);
    QVERIFY(path);
    EvaluatedPath marked = *path;
    marked.path.spindleSpeed = 4321.0; // to identify it later
    follower.evaluated = std::make_shared<const EvaluatedPath>(marked);
    const auto alone = evaluateInOrder(milling, {follower}, progress),
               behind = evaluateInOrder(milling, {first, follower}, progress);
    QVERIFY(alone && behind);
    QCOMPARE(alone->program.paths[0].spindleSpeed, 4321.0);
    QVERIFY(behind->program.paths[1].spindleSpeed != 4321.0);
    QVERIFY(feedsWithin(behind->program.paths[1], 3.0, 5.0).first > 1000.0);
    // Only what is taken over needs no strokes.
    QVERIFY(areEvaluated({follower}) && !areEvaluated({first, follower}) && !areEvaluated({first}));
    for (SourceStrokes& source : follower.sources) source.strokes.clear();
    const auto spared = evaluateInOrder(milling, {follower}, progress);
    QVERIFY(spared && spared->program.paths[0].points.size() == alone->program.paths[0].points.size());
}

void TestToolsInOrder::whatIsCutOfALentStockIsForgotten() {
    const PathMatter rough = slot(), across = matter(2, flat("across", 2, 4.0), {{5, -5, 6}, {5, 25, 6}});
    const MillingContext milling = plateMilling(rough.tool);
    Progress progress;
    const auto milled = milledInTurn(milling, {rough, across});
    QVERIFY(milled);
    const auto cutOneAfterTheOther = [&](std::size_t count) {
        MillingContext fresh = plateMilling(rough.tool);
        for (std::size_t i = 0; i < count; ++i)
            if (!cutPath((*milled)[i].evaluated->path, (*milled)[i].tool.cutter, fresh.embedded.workpiece, progress))
                std::abort(); // the test's own set-up
        return linesOf(fresh.embedded.workpiece);
    };
    const glm::dvec3 size = plate.size();
    const double whole = size.x * size.y * size.z;
    const auto lost = [&](const RunVolume& stock) {
        return whole - static_cast<double>(stock.amounts().units[1]) * stock.grid().unitVolume();
    };
    for (const std::size_t count : {2u, 0u, 1u, 2u}) {
        const auto wanted = cutOneAfterTheOther(count);
        double removed = 0.0;
        const auto lent = milling.stock->lend(
            std::span(*milled).first(count),
            [&](RunVolume& stock) -> Result<void> {
                if (linesOf(stock) != wanted) return Error{ErrorCode::internalFault, "stock", "", ""};
                removed = lost(stock);
                return cutPath((*milled)[1].evaluated->path, (*milled)[0].tool.cutter, stock,
                               progress); // to be discarded
            },
            progress);
        QVERIFY(lent);
        // A slot of 13 mm, round at its end, and a narrower one across it, deeper.
        const double round = 0.125 * pi * diameter * diameter, first = depth * (10.0 * diameter + round),
                     second = 4.0 * (20.0 * 4.0) - depth * diameter * 4.0;
        const double closed = (count > 0 ? first : 0.0) + (count > 1 ? second : 0.0);
        QVERIFY2(std::abs(removed - closed) < 0.01 * closed + 1e-6,
                 qPrintable(QString("%1 %2").arg(removed).arg(closed)));
    }
}

/// The states that are kept need memory too; where that is short they are discarded.
void TestToolsInOrder::aStockIsLentWhereverItCanBeCutAtAll() {
    const PathMatter rough = slot(), deeper = matter(2, flat("deeper", 2, diameter), {{-10, 10, 6}, {50, 10, 6}});
    const MillingContext milling = plateMilling(rough.tool);
    Progress progress;
    const auto milled = milledInTurn(milling, {rough, deeper});
    QVERIFY(milled);
    int madeAnew = 0, plain = 0;
    for (std::size_t reserve = 20'000; reserve < 400'000; reserve += 4'000) {
        int made = 0;
        const auto make = [&](Progress&) -> Result<RunVolume> {
            ++made;
            const RunVolume& like = milling.embedded.workpiece;
            Result<RunVolume> volume = RunVolume::make(like.grid(), like.properties(), reserve);
            if (!volume) return volume;
            if (!volume->fillBlock({0, 0}, {like.grid().lineCountU(), like.grid().lineCountV()}, 0,
                                   like.grid().lineEnd(), 1))
                return Error{ErrorCode::volumeOutOfMemory, "", "", ""};
            return volume;
        };
        Result<RunVolume> straight = make(progress);
        if (!straight) continue;
        bool possible = true;
        for (const MilledPath& path : *milled)
            possible = possible && cutPath(path.evaluated->path, path.tool.cutter, *straight, progress);
        if (!possible) continue;
        made = 0;
        MilledStock stock(make);
        bool same = false;
        const auto lent = stock.lend(
            *milled,
            [&](RunVolume& volume) -> Result<void> {
                same = linesOf(volume) == linesOf(*straight);
                return {};
            },
            progress);
        QVERIFY2(lent && same, qPrintable(QString::number(reserve)));
        ++(made > 1 ? madeAnew : plain);
    }
    qInfo() << plain << "kept," << madeAnew << "made anew";
    QVERIFY(plain > 0 && madeAnew > 0);
}

void TestToolsInOrder::theRequestToStopIsHeard() {
    const PathMatter first = slot();
    const MillingContext milling = plateMilling(first.tool);
    Progress progress;
    progress.cancel();
    QCOMPARE(evaluateInOrder(milling, {first}, progress).error().code, ErrorCode::cancelled);
    Progress other;
    const auto path = evaluateStored(first.sources, milling, first.tool, first.path, {}, other);
    QVERIFY(path);
    const MilledPath milled{std::make_shared<const EvaluatedPath>(*path), first.tool};
    QCOMPARE(milling.stock
                 ->lend(
                     std::span(&milled, 1), [](RunVolume&) { return Result<void>(); }, progress)
                 .error()
                 .code,
             ErrorCode::cancelled);
    QVERIFY(milling.stock->lend(
        std::span(&milled, 1), [](RunVolume&) { return Result<void>(); }, other));
}

BURIN_TEST(TestToolsInOrder, QCoreApplication)

} // namespace burin::tst_tools_in_order

#include "tst_tools_in_order.moc"
