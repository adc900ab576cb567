// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Moved and copied takes: how they are replayed, kept, listed and milled.
#include "core/document/database.h"
#include "core/job/job_paths.h"
#include "core/job/pass_strokes.h"
#include "core/job/path_takes.h"
#include "core/job/recorded_time.h"
#include "core/job/switched_off.h"
#include "core/job/take_moves.h"
#include "core/job/workpiece_in_time.h"
#include "core/volume/operations/fingerprint.h"
#include "tests/core/document/sample_project.h"
#include "tests/core/job/recorded_takes.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

#include <numeric>
#include <random>

namespace burin::tst_take_order {

using namespace burin::test;

namespace {

std::vector<std::int64_t> listed(const Project& project) {
    std::vector<std::int64_t> ids;
    const std::vector<TakeInfo> takes = *project.takes();
    for (const TakeInfo& info : takes) ids.push_back(info.id);
    return ids;
}

std::vector<Take> inOrder(const Project& project) {
    std::vector<Take> takes;
    for (const std::int64_t id : listed(project)) takes.push_back(*project.take(id));
    return takes;
}

/// Replayed from the stock, or from a kept workpiece; 0 on failure.
std::uint64_t hashOf(const Project& project, bool fromKept = false) {
    Progress progress;
    MillingContext milling = blockMilling();
    const Result<RecordedWork> work = recordedWork(project, fromKept);
    if (!work || !replayTakes(*work, milling, progress)) return 0;
    return fingerprint(milling.embedded.workpiece.snapshot());
}

bool keepAt(Project& project, const TakeMoment& at) {
    Progress progress;
    MillingContext milling = blockMilling();
    const Result<RecordedWork> work = recordedWork(project, at, false);
    if (!work || !replayTakes(*work, milling, progress)) return false;
    return project
        .keepWorkpiece(*keptAs(milling.embedded.workpiece.snapshot(), at, work->strokes, progress),
                       *project.recordedState())
        .hasValue();
}

} // namespace

class TestTakeOrder : public QObject {
    Q_OBJECT
private slots:
    /// Guide lines of a take are made once for what of it counts, and anew when that changes.
    void guideLinesAreKept() {
        Rows rows({3000});
        QVERIFY(rows.good);
        const std::int64_t take = rows.takes.front().info.id;
        KeptLeads kept;
        Progress progress;
        const Result<LeadLines> first = linesOfTake(rows.project, take, kept, progress);
        QVERIFY(first && !(*first)->empty());
        Result<LeadTake> again = readLead(rows.project, take, kept, progress);
        QVERIFY(again && again->lines == *first && again->strokes.strokes.empty()); // the same object, nothing was read
        const SampleRange half{1500, 1500};
        QVERIFY(rows.project.setSwitchedOff(take, {&half, 1}));
        Progress cancelled;
        cancelled.cancel();
        const Result<LeadTake> stopped = readLead(rows.project, take, kept, cancelled);
        QVERIFY(!stopped && stopped.error().code == ErrorCode::cancelled);
        const Result<LeadLines> shorter = linesOfTake(rows.project, take, kept, progress);
        QVERIFY(shorter);
        const auto count = [](const LeadLines& lines) {
            return std::accumulate(lines->begin(), lines->end(), std::size_t{0},
                                   [](std::size_t sum, const PassLine& line) { return sum + line.size(); });
        };
        QVERIFY(count(*shorter) < count(*first));
        QVERIFY(rows.project.setSwitchedOff(take, {}));
        const Result<LeadLines> whole = linesOfTake(rows.project, take, kept, progress);
        QVERIFY(whole && **whole == **first);
    }

    /// 200 random moves, compared with erase and insert in a list; a take that is removed meanwhile keeps its position.
    void movesAreThoseOfAList() {
        QTemporaryDir folder;
        Project project = *Project::create(folder.filePath("p.burin").toStdString());
        std::vector<std::int64_t> expected;
        for (int i = 0; i < 6; ++i) {
            auto writer = project.beginTake(fixture::takeInfo("t"));
            QVERIFY(writer && writer->append(fixture::handSamples(0, 5)) && writer->finish());
            expected.push_back(writer->id());
        }
        std::mt19937 random(11);
        for (int i = 0; i < 200; ++i) {
            const std::int64_t moved = expected[random() % expected.size()];
            std::vector<std::int64_t> others = expected;
            std::erase(others, moved);
            const std::size_t place = random() % expected.size();
            const bool before = random() % 2 == 0 && place < others.size();
            const Result<TakeOrder> order =
                before ? orderWithTakeBefore(project, moved, others[place]) : orderWithTakeAt(project, moved, place);
            QVERIFY(order && project.setTakeOrder(*order));
            others.insert(others.begin() + static_cast<std::ptrdiff_t>(place), moved);
            expected = others;
            QCOMPARE(listed(project), expected);
            if (i % 20 == 10) { // a removed take keeps its position
                QVERIFY(project.removeTake(expected[2]));
                const Result<TakeOrder> end = orderWithTakeAt(project, expected[0], 4);
                QVERIFY(end && project.setTakeOrder(*end) && project.restoreTake(expected[2]));
                std::ranges::rotate(expected, expected.begin() + 1);
                QCOMPARE(listed(project), expected);
            }
        }
        QVERIFY(project.setTakeOrder({})); // in the order of recording
        std::ranges::sort(expected);
        QCOMPARE(listed(project), expected);
        for (const Result<TakeOrder>& wrong :
             {orderWithTakeAt(project, expected[0], 6), orderWithTakeAt(project, 99, 0),
              orderWithTakeBefore(project, expected[0], 99), orderWithTakeBefore(project, expected[0], expected[0])})
            QVERIFY(!wrong);
        QCOMPARE(project.setTakeOrder(TakeOrder({1, 2, 1})).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(project.setTakeOrder(TakeOrder({1, 99})).error().code, ErrorCode::nameUnknown);
        QCOMPARE(listed(project), expected);
    }

    /// The workpiece at the end is bitwise the same in any order; at each moment between, also at the ends of takes, it
    /// is the result of a replay of the takes before it.
    void theWorkpieceFollowsTheOrder() {
        Rows recorded({2200, 1700, 1300});
        QVERIFY(recorded.good);
        Project& project = recorded.project;
        const std::uint64_t hash = hashOf(project);
        std::mt19937 random(3);
        std::vector<std::int64_t> ids = listed(project);
        Progress progress;
        for (const std::vector<std::size_t>& places :
             {std::vector<std::size_t>{2, 0, 1}, {1, 0, 2}, {2, 1, 0}, {0, 2, 1}}) {
            std::vector<std::int64_t> wanted;
            for (const std::size_t place : places) wanted.push_back(ids[place]);
            QVERIFY(project.setTakeOrder(TakeOrder(wanted)));
            QCOMPARE(listed(project), wanted);
            const std::vector<Take> takes = inOrder(project);
            QCOMPARE(hashOf(project), hash);
            QCOMPARE(hashOf(project, true), hash);
            const TakeOrder order = orderOf(takes);
            std::vector<TakeMoment> moments{{0, 0}};
            for (const Take& take : takes)
                for (const std::uint64_t at :
                     {std::uint64_t{0}, random() % take.samples.size(), std::uint64_t{take.samples.size()}})
                    moments.push_back({take.info.id, at});
            const std::vector<Lines> expected = replayedTo(takes, moments);
            Result<WorkpieceInTime> time = WorkpieceInTime::make(stock(), sharedCuts(project), {}, progress);
            const Result<RecordedTime> recordedTime = readRecordedTime(project);
            QVERIFY(time && recordedTime && recordedTime->order == order);
            std::vector<std::size_t> visits(moments.size());
            std::iota(visits.begin(), visits.end(), 0);
            std::ranges::shuffle(visits, random);
            for (const std::size_t i : visits) {
                const Result<VolumeSnapshot> workpiece = time->at(moments[i], progress);
                QVERIFY(workpiece && linesOf(*workpiece) == expected[i]);
                MillingContext milling = blockMilling();
                QVERIFY(replayTakes(*recordedWork(project, moments[i]), milling, progress));
                QVERIFY(linesOf(milling.embedded.workpiece) == expected[i]);
                if (moments[i].take != 0 && moments[i].samples > 0) {
                    const TakeMoment again = recordedTime->momentAt(recordedTime->secondsAt(moments[i]));
                    QVERIFY(again == moments[i]);
                }
            }
            const Result<VolumeSnapshot> end = time->at(moments.back(), progress);
            QVERIFY(end);
            QCOMPARE(fingerprint(*end), hash);
            // The workpieces that scrubbing found worth keeping are valid in this order, and only in this one.
            for (const KeptWorkpiece& kept : time->takeWorthKeeping())
                QVERIFY(project.keepWorkpiece(kept, recordedTime->state));
            QCOMPARE(hashOf(project, true), hash);
        }
    }

    /// A kept workpiece is valid exactly as long as the takes before its moment are the same, in any order; one made in
    /// one order is not kept in another.
    void whatIsKeptHoldsWhereItIsMadeOfTheSame() {
        Rows recorded({900, 800, 700});
        QVERIFY(recorded.good);
        Project& project = recorded.project;
        const std::vector<std::int64_t> ids = listed(project);
        const std::int64_t a = ids[0], b = ids[1], c = ids[2];
        const TakeMoment midA{a, 400}, endA{a, 900}, midB{b, 300}, endB{b, 800}, midC{c, 100}, endC{c, 700};
        const std::vector<TakeMoment> all{midA, endA, midB, endB, midC, endC};
        for (const TakeMoment& at : all) QVERIFY(keepAt(project, at));
        QCOMPARE(*project.keptMoments(), all);
        const RecordedState state = *project.recordedState();
        const std::uint64_t hash = hashOf(project);

        QVERIFY(project.setTakeOrder(TakeOrder({b, a, c})));
        QCOMPARE(*project.keptMoments(), (std::vector{midC, endC}));
        QCOMPARE(hashOf(project, true), hash);
        QVERIFY(recordedWork(project)->kept && recordedWork(project)->cuts.empty()); // nothing is cut again
        const Result<RecordedWork> border = recordedWork(project, endB);
        QVERIFY(border && !border->kept && border->cuts.size() == 1 && border->end == endB);
        // The end is the same, but the workpiece was made in the other order.
        QVERIFY(project.recordedState()->end == state.end);
        QVERIFY(project.keepWorkpiece({endB, {}, "of the other order"}, state));
        QCOMPARE(project.keptMoments()->size(), std::size_t{2});
        QVERIFY(keepAt(project, endB));
        QCOMPARE(*project.keptMoments(), (std::vector{endB, midC, endC}));

        QVERIFY(project.setTakeOrder(TakeOrder({a, b, c})));
        QCOMPARE(*project.keptMoments(), (std::vector{midA, endA, midB, midC, endC})); // not endB of the other order
        QCOMPARE(hashOf(project, true), hash);
        QVERIFY(project.setTakeOrder(TakeOrder({c, a, b})));
        QVERIFY(project.keptMoments()->empty());
        // "After a moment" refers to the order of the takes.
        const Result<SwitchedOff> off = offAfter(project, {a, 500});
        QVERIFY(off && off->size() == 2 && !off->contains(c));
        QVERIFY(project.setMarkers(std::vector<TimeMarker>{{midA, "A"}, {endB, "B"}, {midC, "C"}}));
        const std::vector<TimeMarker> markers = *project.markers();
        QVERIFY(markers[0].name == "C" && markers[1].name == "A" && markers[2].name == "B");
        const std::map<std::int64_t, std::size_t> over = strokesBefore(sharedCuts(project), {a, 900});
        QVERIFY(over.size() == 2 && over.contains(c) && over.contains(a));
        QVERIFY(strokesBefore(sharedCuts(project), {c, 600}).empty());
    }

    /// A copy has all data of its original and replaces it when that is removed: the workpiece is the same.
    void aCopyStandsForItsOriginal() {
        Rows recorded({900, 800});
        QVERIFY(recorded.good);
        Project& project = recorded.project;
        const std::vector<std::int64_t> ids = listed(project);
        QVERIFY(project.nameTake(ids[1], "crown"));
        QVERIFY(project.setSwitchedOff(ids[1], std::vector<SampleRange>{{20, 30}}));
        const std::uint64_t hash = hashOf(project);
        QVERIFY(keepAt(project, {ids[1], 800}));
        const std::int64_t digest = *project.jobDigest();
        const Result<std::int64_t> copy = project.duplicateTake(ids[1]);
        QVERIFY(copy);
        QCOMPARE(listed(project), (std::vector{ids[0], ids[1], *copy}));
        const Take original = *project.take(ids[1]), copied = *project.take(*copy);
        QCOMPARE(copied.info.name, std::string("crown (copy)"));
        QCOMPARE(copied.info.copyOf, ids[1]);
        QCOMPARE(original.info.copyOf, std::int64_t{0});
        QVERIFY(fixture::identical(original.samples, copied.samples));
        QVERIFY(original.undone == copied.undone && *project.switchedOff(*copy) == *project.switchedOff(ids[1]));
        QVERIFY(copied.info.complete && copied.info.toolId == original.info.toolId &&
                copied.info.materials == original.info.materials && copied.info.seconds == original.info.seconds);
        QCOMPARE(project.keptMoments()->size(), std::size_t{1}); // the copy comes after it
        QCOMPARE(hashOf(project), hash);
        QVERIFY(project.removeTake(ids[1]));
        QCOMPARE(hashOf(project), hash);
        QCOMPARE(hashOf(project, true), hash);
        QCOMPARE(project.takes()->back().copyOf, ids[1]); // it stays a copy
        QVERIFY(project.restoreTake(ids[1]));
        // The original of a copy of a copy is the recording.
        const Result<std::int64_t> second = project.duplicateTake(*copy);
        QVERIFY(second && project.takeOutline(*second)->info.copyOf == ids[1]);
        QVERIFY(project.removeTake(*copy) && project.takeOutline(*second)->info.copyOf == ids[1]);
        QVERIFY(project.removeTake(*second));
        QCOMPARE(*project.jobDigest(), digest);
        QCOMPARE(project.duplicateTake(99).error().code, ErrorCode::nameUnknown);
    }

    /// A removed take is erased when its project is opened. A copy of an erased copy is a copy of the recording, and
    /// copies of an erased recording remain copies; nothing else names erased takes.
    void anErasedTakeIsForgotten() {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("p.burin").toStdString();
        std::vector<std::int64_t> ids;
        std::int64_t copy = 0, second = 0;
        {
            Project project = *Project::create(file);
            for (int i = 0; i < 2; ++i) {
                auto writer = project.beginTake(fixture::takeInfo("t"));
                QVERIFY(writer && writer->append(fixture::handSamples(0, 5)) && writer->finish());
                ids.push_back(writer->id());
            }
            copy = *project.duplicateTake(ids[0]);
            second = *project.duplicateTake(copy);
            QVERIFY(project.setTakeOrder(TakeOrder({second, copy, ids[1], ids[0]})));
            QVERIFY(project.removeTake(copy) && project.save());
        }
        const auto row = [&file](const char* name) {
            Result<Database> database = Database::open(file, "", Database::Access::write);
            if (!database) return std::string("not opened");
            Result<Statement> rows = Statement::prepare(
                *database, std::string("SELECT json FROM setup_setting WHERE name = '") + name + "'");
            return *rows->step() ? std::string(rows->text(0)) : std::string();
        };
        const auto listOf = [](std::initializer_list<std::int64_t> takes) {
            std::string text;
            for (const std::int64_t take : takes) text += (text.empty() ? "[" : ",") + std::to_string(take);
            return text + "]";
        };
        QCOMPARE(row("take_order"), listOf({second, copy, ids[1], ids[0]}));
        {
            Project project = *Project::open(file);
            QCOMPARE(listed(project), (std::vector{second, ids[1], ids[0]}));
            QCOMPARE(project.takes()->front().copyOf, ids[0]);
            QVERIFY(project.save());
        }
        QCOMPARE(row("take_order"), listOf({second, ids[1], ids[0]}));
        QCOMPARE(row("take_copies"), "[" + listOf({second, ids[0]}) + "]");
        {
            Project project = *Project::open(file);
            QVERIFY(project.removeTake(ids[0]) && project.save());
        }
        {
            Project project = *Project::open(file);
            QCOMPARE(listed(project), (std::vector{second, ids[1]}));
            QCOMPARE(project.takes()->front().copyOf, ids[0]);
            QVERIFY(project.save());
        }
        QCOMPARE(row("take_order"), listOf({second, ids[1]}));
        QCOMPARE(row("take_copies"), "[" + listOf({second, ids[0]}) + "]");
    }

    /// The order of takes does not affect the job: paths keep their takes, tools their order, and results that depend
    /// on the job stay up to date. A copy is added to a path only on request.
    void pathsKeepTheirTakes() {
        Rows recorded({300, 250, 200});
        QVERIFY(recorded.good);
        Project& project = recorded.project;
        const std::vector<std::int64_t> ids = listed(project);
        const std::string tool = sessionTool().id;
        const Result<std::vector<StoredPath>> paths = jobPaths(project);
        QVERIFY(paths && takesOf(paths->front().sources) == ids);
        const auto strokes = [&] {
            StoredPath path = project.paths()->front();
            addNewerTakes(path, *sourcesOf(project));
            std::vector<std::pair<std::int64_t, std::size_t>> found;
            const PathMatter matter = *matterOf(project, path);
            for (const SourceStrokes& each : matter.sources)
                found.emplace_back(each.info.source.id, each.strokes.size());
            return found;
        };
        const auto before = strokes();
        const std::int64_t digest = *project.jobDigest();
        QVERIFY(project.setTakeOrder(TakeOrder({ids[2], ids[0], ids[1]})));
        QVERIFY(strokes() == before);
        QCOMPARE(*project.jobDigest(), digest);
        std::vector<std::int64_t> sources;
        const std::vector<SourceInfo> known = *sourcesOf(project);
        for (const SourceInfo& each : known) sources.push_back(each.source.id);
        QCOMPARE(sources, ids);
        // A new path lists them in their present order.
        QCOMPARE(takesOf(standardPath(project, tool)->sources), (std::vector{ids[2], ids[0], ids[1]}));

        const std::int64_t copy = *project.duplicateTake(ids[0]);
        QVERIFY(strokes() == before);
        QCOMPARE(takesOf(standardPath(project, tool)->sources), (std::vector{ids[2], ids[0], ids[1]}));
        const StoredPath path = project.paths()->front();
        const Result<StoredPath> with = withTake(project, path, copy);
        QVERIFY(with && project.setPath(*with));
        QCOMPARE(strokes().size(), before.size() + 1);
        QVERIFY(!withTake(project, *with, copy) && !withTake(project, path, 99));
        const Result<StoredPath> without = withoutTake(project, *with, copy);
        QVERIFY(without && without->sources == path.sources && !withoutTake(project, *without, copy));
        // The newest recording would be added again, an earlier one stays out.
        QCOMPARE(withoutTake(project, path, ids[2]).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(takesOf(withoutTake(project, path, ids[0])->sources), (std::vector{ids[1], ids[2]}));
        // A take that was recorded since belongs to the path although the copy has a later number.
        StoredPath older = path;
        older.sources.pop_back();
        QCOMPARE(takesOf(withTake(project, older, copy)->sources), (std::vector{ids[0], ids[1], ids[2], copy}));
        QVERIFY(project.setPath(*without));
        QVERIFY(strokes() == before);
        // If the original is removed, the copy is not added to paths that lack it; a new path has it, and one alone.
        const Result<StoredPath> shorter = withoutTake(project, path, ids[0]);
        QVERIFY(shorter && project.setPath(*shorter) && project.duplicateTake(copy) && project.removeTake(ids[0]));
        QCOMPARE(strokes().size(), before.size() - 1);
        QVERIFY(project.removePath(path.id));
        QCOMPARE(takesOf(standardPath(project, tool)->sources), (std::vector{ids[2], ids[1], copy}));
    }

    /// Saved and opened again; also for an older project. Wrong values in the file are reported as damage.
    void theOrderIsKept() {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("p.burin").toStdString();
        QVERIFY(QFile::copy(BURIN_SOURCE_DIRECTORY "/tests/fixtures/projects/v10/small.burin",
                            QString::fromStdString(file.string())));
        {
            Project project = *Project::open(file);
            const std::vector<std::int64_t> ids = listed(project);
            QCOMPARE(project.takeOrder()->takes(), ids);
            QVERIFY(project.takes()->front().copyOf == 0);
            const std::int64_t copy = *project.duplicateTake(ids.front());
            QVERIFY(project.setTakeOrder(*orderWithTakeAt(project, copy, 0)) && project.save());
        }
        const auto opened = [&](const char* change) {
            if (*change != 0) {
                Result<Database> database = Database::open(file, "", Database::Access::write);
                if (!database->execute((std::string(change) + "; UPDATE document SET digest = NULL").c_str())) return 0;
            }
            const Result<Project> project = Project::openForReading(file);
            if (!project) return -1;
            const Result<std::vector<TakeInfo>> takes = project->takes();
            if (!takes) return takes.error().code == ErrorCode::fileDamaged ? -2 : -3;
            return static_cast<int>(takes->front().id) * 10 + static_cast<int>(takes->front().copyOf);
        };
        const int moved = opened("");
        QVERIFY(moved > 20);
        for (const char* wrong : {"[1, 1]", "[-1]", "[\"1\"]", "{}", "[1.5]", "x", "[99999999999999999999]"}) {
            const std::string change =
                std::string("UPDATE setup_setting SET json = '") + wrong + "' WHERE name = 'take_order'";
            QCOMPARE(opened(change.c_str()), -2);
        }
        QCOMPARE(opened("UPDATE setup_setting SET json = '[77]' WHERE name = 'take_order'") / 10, 1); // no such take
        for (const char* wrong : {"[[1, 1]]", "[[1, 2]]", "[[2]]", "[2, 1]", "{}", "x", "[[2, -1]]"}) {
            const std::string change =
                std::string("UPDATE setup_setting SET json = '") + wrong + "' WHERE name = 'take_copies'";
            QCOMPARE(opened(change.c_str()), -2);
        }
    }
};

BURIN_TEST(TestTakeOrder, QCoreApplication)

} // namespace burin::tst_take_order

#include "tst_take_order.moc"
