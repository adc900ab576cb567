// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/proxy.h"
#include "core/haptics/trace/trace_stylus.h"
#include "core/job/job_paths.h"
#include "core/job/milling_session.h"
#include "core/job/recorded_cuts.h"
#include "core/job/touched_stock.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/job/part_milling.h"
#include "tests/core/job/session_stage.h"
#include "tests/oracles/tool_depth.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <random>

namespace burin::tst_session_surroundings {

using namespace burin::test;

namespace {

const glm::dvec3 upright(0.0, 0.0, 1.0);
const glm::dvec3 leaning = glm::normalize(glm::dvec3(0.35, 0.2, 0.9));

/// A hand that roves through a region and tilts as it moves, its button down; or one that moves to a given point.
class RovingHand final : public Stylus {
public:
    RovingHand(const Box& region, unsigned seed, std::uint64_t ticks) : region_(region), ticks_(ticks) {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<double> phase(0.0, 6.28), pace(4.0, 10.0);
        for (Wave& wave : waves_) wave = {pace(engine), phase(engine), pace(engine), phase(engine)};
    }
    /// From now on the hand moves there, at 100 mm/s.
    void leadTo(const glm::dvec3& place) {
        const std::scoped_lock lock(mutex_);
        led_ = place;
    }
    bool arrived() {
        const std::scoped_lock lock(mutex_);
        return led_ && place_ == *led_;
    }
    void letButton(bool down) { down_ = down; }

    StylusDescription description() const override {
        StylusDescription stylus = StrokeHand().description();
        stylus.name = "roving hand";
        return stylus;
    }
    Result<void> open() override { return {}; }
    StylusState read(double time) noexcept override {
        StylusState state;
        state.time = time;
        state.valid = true;
        const std::scoped_lock lock(mutex_);
        if (led_) {
            place_ += clampLength(*led_ - place_, 0.1);
        } else {
            const glm::dvec3 share(waves_[0].at(time), waves_[1].at(time), waves_[2].at(time));
            place_ = region_.centre() + 0.5 * share * region_.size();
        }
        state.pose.position = place_;
        const glm::dvec3 aside(waves_[3].at(time), waves_[4].at(time), 0.0);
        state.pose.rotation =
            glm::angleAxis(0.5 * glm::length(aside), glm::normalize(glm::dvec3(-aside.y, aside.x, 1e-9)));
        state.buttons = down_ ? 1u : 0u;
        ++tick_;
        return state;
    }
    void write(const Wrench&) noexcept override {}
    bool finished() const noexcept override { return ticks_ > 0 && tick_ >= ticks_; }
    void close() noexcept override {}

private:
    struct Wave {
        double pace = 1.0, phase = 0.0, otherPace = 1.0, otherPhase = 0.0;
        double at(double time) const {
            return 0.5 * (std::sin(pace * time + phase) + std::sin(otherPace * time + otherPhase));
        }
    };
    Box region_;
    std::uint64_t ticks_;
    std::array<Wave, 5> waves_;
    std::mutex mutex_;
    std::optional<glm::dvec3> led_;
    glm::dvec3 place_{0.0};
    std::atomic<std::uint64_t> tick_{0};
    std::atomic<bool> down_{true};
};

Tool toolWithHolder() {
    Tool tool = sessionTool();
    tool.cutter.holder = {{16.0, 20.0, 15.0}};
    return tool;
}

/// An obstacle with the closed formula of its distance, and points of its edges.
struct KnownObstacle {
    Obstacle obstacle;
    oracles::SolidDistance distance;
    std::vector<glm::dvec3> edges;
};

KnownObstacle knownBox(const char* name, const Box& box, double margin, bool asMesh) {
    KnownObstacle known;
    known.obstacle.name = name;
    known.obstacle.margin = margin;
    if (asMesh)
        known.obstacle.shape = shapes::box(box.low, box.high);
    else
        known.obstacle.shape = box;
    known.distance = [box](const glm::dvec3& place) { return shapes::boxDistance(box.low, box.high, place); };
    constexpr int steps = 30;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner)
            for (int i = 0; i <= steps; ++i) {
                glm::dvec3 place;
                place[axis] = glm::mix(box.low[axis], box.high[axis], static_cast<double>(i) / steps);
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                place[u] = corner & 1 ? box.low[u] : box.high[u];
                place[v] = corner & 2 ? box.low[v] : box.high[v];
                known.edges.push_back(place);
            }
    return known;
}

KnownObstacle knownColumn(const char* name, const CylinderShape& column) {
    KnownObstacle known;
    known.obstacle.name = name;
    known.obstacle.shape = column;
    known.distance = [column](const glm::dvec3& place) {
        const glm::dvec3 from = place - column.base;
        const double along = glm::dot(from, column.axis);
        const double across = glm::length(from - along * column.axis) - column.radius;
        const double beyond = std::max(-along, along - column.height);
        return std::min(std::max(across, beyond), 0.0) + std::hypot(std::max(across, 0.0), std::max(beyond, 0.0));
    };
    return known;
}

/// To the side of the stock, in front of it, and above it, where only shank and holder can reach it.
std::vector<KnownObstacle> aroundTheBlock() {
    return {knownBox("jaw", {{-12.0, 2.0, 0.0}, {-1.0, 12.0, 14.0}}, 0.5, false),
            knownColumn("clamp", {{10.0, -6.0, 0.0}, upright, 4.0, 18.0}),
            knownBox("beam", {{3.0, 22.0, 18.0}, {17.0, 30.0, 40.0}}, 0.3, true)};
}

Surroundings surroundingsOf(const std::vector<KnownObstacle>& known) {
    Surroundings surroundings;
    for (const KnownObstacle& one : known) surroundings.obstacles.push_back(one.obstacle);
    return surroundings;
}

struct AroundStage {
    AroundStage(const QTemporaryDir& folder, const AxisMode& axis, const Surroundings& surroundings,
                std::uint64_t ticks)
        : project(*Project::create(folder.filePath("p.burin").toStdString()))
        , hand({{-6.0, -6.0, 2.0}, {22.0, 26.0, 16.0}}, 7, ticks) {
        Progress progress;
        bounds =
            std::make_unique<ToolBounds>(*ToolBounds::build(milling, milling.tool, axis, surroundings, 0.5, progress));
        if (!project.setModel(*milling.model) || !project.setSetup(milling.setup) ||
            !project.setObstacles(surroundings.obstacles) || !project.setAxisMode(axis))
            std::abort();
    }
    std::unique_ptr<MillingSession> begin(const SessionRequest& request) {
        Result<std::unique_ptr<MillingSession>> session =
            MillingSession::begin(project, milling, *bounds, hand, strokes, request);
        return session ? *std::move(session) : nullptr;
    }

    Project project;
    MillingContext milling = partMilling(toolWithHolder());
    std::unique_ptr<ToolBounds> bounds;
    RovingHand hand;
    StrokeHistory strokes;
};

void addAxes() {
    QTest::addColumn<bool>("free");
    QTest::addColumn<glm::dvec3>("axis");
    QTest::newRow("three axes") << false << upright;
    QTest::newRow("3+2") << false << leaning;
    QTest::newRow("free") << true << upright;
}

} // namespace

class TestSessionSurroundings : public QObject {
    Q_OBJECT
private slots:
    void noPointOfTheToolIsInAnObstacleInAnyTick_data() { addAxes(); }
    void noPointOfTheToolIsInAnObstacleInAnyTick() {
        QFETCH(bool, free);
        QFETCH(glm::dvec3, axis);
        const QTemporaryDir folder;
        const std::vector<KnownObstacle> known = aroundTheBlock();
        AroundStage stage(folder, {free, axis}, surroundingsOf(known), 1800);
        SessionRequest request = handRequest(Pace::fast);
        request.takeName = "roving";
        const auto session = stage.begin(request);
        QVERIFY(session && await([&] { return session->ended(); }) && session->end());
        const Result<Take> take = stage.project.take(session->take());
        QVERIFY(take && take->samples.size() > 1700);

        const oracles::ToolDepth depth(pieces(stage.milling.tool.cutter), 0.25);
        const double allowed = 0.02 * stage.milling.setup.voxel; // during the motion between two ticks
        std::array<std::uint64_t, 3> near{};
        std::uint64_t flagged = 0, moved = 0;
        for (std::size_t i = 1; i < take->samples.size(); ++i) {
            const ToolPose &before = take->samples[i - 1].proxy, &now = take->samples[i].proxy;
            if (!free) QVERIFY(now.axis == axis);
            if ((take->samples[i].flags & sampleOnObstacle) != 0) ++flagged;
            if (now.tip != before.tip) ++moved;
            // Until the tool is picked up it is shown where it is free of contact, wherever the hand is: there is no
            // motion between.
            const bool takenUp = ((take->samples[i - 1].flags | take->samples[i].flags) & sampleForcesOff) == 0;
            const ToolPose middle =
                takenUp ? ToolPose{0.5 * (before.tip + now.tip), glm::normalize(before.axis + now.axis)} : now;
            for (std::size_t k = 0; k < known.size(); ++k)
                for (const ToolPose& pose : {middle, now}) {
                    // Grown by its margin and a little more, so that a tool in contact is detected.
                    constexpr double touch = 0.01; // mm
                    const auto grown = [&](const glm::dvec3& place) {
                        return known[k].distance(place) - known[k].obstacle.margin - touch;
                    };
                    const double inside = depth.at(pose, grown, known[k].edges) - touch;
                    QVERIFY2(
                        inside <= allowed,
                        qPrintable(
                            QString("%1 mm in %2, tick %3").arg(inside).arg(known[k].obstacle.name.c_str()).arg(i)));
                    if (inside > -touch) ++near[k];
                }
        }
        QVERIFY(moved > 1000 && flagged > 100);
        SessionState state;
        QVERIFY(session->newest(state));
        QCOMPARE(state.layers.size(), std::size_t{4});
        std::uint64_t ticksHeld = 0;
        for (std::size_t k = 0; k < known.size(); ++k) {
            QVERIFY2(near[k] > 20, known[k].obstacle.name.c_str()); // it was pressed against each of them
            QVERIFY(state.layers[k + 1].ticksHeld > 0);
            ticksHeld += state.layers[k + 1].ticksHeld;
        }
        QVERIFY(ticksHeld >= flagged);
    }

    /// With any axis, the recording reproduces the workpiece, and undone strokes are missing from both.
    void theRecordingMakesTheWorkpieceAgain_data() { addAxes(); }
    void theRecordingMakesTheWorkpieceAgain() {
        QFETCH(bool, free);
        QFETCH(glm::dvec3, axis);
        const QTemporaryDir folder;
        AroundStage stage(folder, {free, axis}, surroundingsOf(aroundTheBlock()), 0);
        const auto session = stage.begin(handRequest(Pace::realtime));
        stage.hand.letButton(false);
        QVERIFY(session && session->startRecording("strokes"));
        std::vector<Lines> states{linesOf(stage.milling.embedded.workpiece)};
        SessionState state;
        for (const glm::dvec3& end : {glm::dvec3(18.0, 4.0, 7.0), glm::dvec3(3.0, 17.0, 6.5)}) {
            stage.hand.leadTo({end.x, end.y, 14.0});
            QVERIFY(await([&] { return stage.hand.arrived(); }));
            stage.hand.letButton(true);
            stage.hand.leadTo(end);
            QVERIFY(await([&] { return stage.hand.arrived(); }));
            stage.hand.letButton(false);
            QVERIFY(await([&] { return session->newest(state) && !state.cutting; }));
        }
        QVERIFY(await([&] { return session->newest(state), stage.strokes.count() == 2; }));
        QVERIFY(session->undoStroke() && session->stopRecording() && session->end());
        const Lines standing = linesOf(stage.milling.embedded.workpiece);
        QVERIFY(standing != states.front());

        MillingContext again = partMilling(toolWithHolder());
        Progress progress;
        QVERIFY(replayTakes(stage.project, again, progress));
        QVERIFY(linesOf(again.embedded.workpiece) == standing);
        MillingContext handedOver = partMilling(toolWithHolder());
        QVERIFY(replayTakes(*recordedWork(stage.project, false), handedOver, progress));
        QVERIFY(linesOf(handedOver.embedded.workpiece) == standing);
        // The axis of each sample is that of the tool: the removed volume is where the tilted tool was.
        const Result<Take> take = stage.project.take(session->take());
        QVERIFY(take && !take->undone.empty());
        bool tilted = false;
        for (const Sample& sample : take->samples) {
            QVERIFY(std::abs(glm::length(sample.proxy.axis) - 1.0) < 1e-9);
            tilted = tilted || sample.proxy.axis.z < 0.999;
        }
        QCOMPARE(tilted, free || axis != upright);
    }

    /// A path that a three-axis program can't express is refused with a message, not posted.
    void aPathOfATiltedToolIsRefused() {
        const QTemporaryDir folder;
        AroundStage stage(folder, {false, leaning}, {}, 400);
        SessionRequest request = handRequest(Pace::fast);
        request.takeName = "leaning";
        const auto session = stage.begin(request);
        QVERIFY(session && await([&] { return session->ended(); }) && session->end());
        const Result<StoredPath> path = standardPath(stage.project, stage.milling.tool.id);
        Progress progress;
        const Result<EvaluatedPath> evaluated = evaluateStored(stage.project, stage.milling, *path, progress);
        QVERIFY(!evaluated);
        QCOMPARE(evaluated.error().code, ErrorCode::notSupported);
        QVERIFY(evaluated.error().place.find("--axis fixed") != std::string::npos);
    }

    /// The stock from 0 to 20 mm holds a tool that does not cut where its layer is switched on, and a face is found on
    /// it within the contact gap; without contact none is. A recording switches the layer off: the tool goes on into
    /// the stock and cuts it.
    void theStockHoldsAToolUntilItIsToCut() {
        const QTemporaryDir folder;
        AroundStage stage(folder, {}, {}, 0);
        Progress progress;
        stage.bounds->addStock(std::make_shared<const TouchableStock>(
            *TouchableStock::of(*stage.milling.model, stage.milling.setup, progress)));
        QCOMPARE(stage.bounds->layers().back().kind, BoundLayer::Kind::stock);
        const std::size_t stock = stage.bounds->layers().size() - 1;
        stage.hand.letButton(false);
        const Tool& tool = stage.milling.tool;
        const glm::dvec3 before(-12.0, 10.0, 5.0), inside(3.0, 10.0, 5.0);
        stage.hand.leadTo(before);
        const auto session = stage.begin(handRequest(Pace::realtime));
        QVERIFY(session && session->setLayer(stock, true));
        SessionState state;
        const auto tip = [&] { return session->newest(state), state.sample.proxy.tip; };
        QVERIFY(await([&] { return stage.hand.arrived() && glm::length(tip() - before) < 0.01; }));
        QCOMPARE(touchedFace(state.sample, tool, 0.0).outcome, TouchedFace::Outcome::nothing);

        stage.hand.leadTo(inside);
        QVERIFY(await([&] { return stage.hand.arrived() && session->newest(state) && state.layers[stock].holds; }));
        const TouchedFace face = touchedFace(state.sample, tool, 0.0);
        QCOMPARE(face.outcome, TouchedFace::Outcome::found);
        QVERIFY(face.axis == 0 && !face.high && std::abs(face.place.x) <= Proxy::contactGap);
        QCOMPARE(stage.bounds->stock()->sideTouched(face, tool)->coordinate, 0.0);

        QVERIFY(session->startRecording("cut"));
        QVERIFY(!session->setLayer(stock, true));
        QVERIFY(await([&] { return glm::length(tip() - inside) < 0.01; }));
        QCOMPARE(state.layers[stock].state, BoundaryLayers::State::off);
        QVERIFY(session->stopRecording() && session->end());
    }

    /// Switched off, a fixture lets the tool in; switched on again around it, the fixture waits, and the tool stays
    /// with the hand.
    void layersAreSwitchedWithoutAKick() {
        const QTemporaryDir folder;
        AroundStage stage(folder, {}, surroundingsOf(aroundTheBlock()), 0);
        stage.hand.letButton(false);
        const glm::dvec3 before(1.0 + 3.0, 7.0, 12.0), inside(-6.0, 7.0, 12.0);
        stage.hand.leadTo(before);
        const auto session = stage.begin(handRequest(Pace::realtime));
        QVERIFY(session && session->startRecording("switching"));
        SessionState state;
        const auto tip = [&] { return session->newest(state), state.sample.proxy.tip; };
        using State = BoundaryLayers::State;
        const auto becomes = [&](State wanted) {
            return await([&] { return session->newest(state) && state.layers[1].state == wanted; });
        };
        QVERIFY(await([&] { return stage.hand.arrived() && glm::length(tip() - before) < 0.01; }));
        stage.hand.leadTo(inside);
        QVERIFY(await([&] { return stage.hand.arrived() && session->newest(state) && state.layers[1].holds; }));
        QVERIFY(std::abs(state.sample.proxy.tip.x - (-1.0 + 2.0 + 0.5)) < 0.01); // face, radius, margin
        QVERIFY((state.sample.flags & sampleOnObstacle) != 0);

        QVERIFY(session->setLayer(1, false) && becomes(State::off));
        QVERIFY(await([&] { return glm::length(tip() - inside) < 0.01; }));
        QVERIFY(session->setLayer(1, true) && becomes(State::waiting));
        const std::uint64_t waitingFrom = state.sample.tick;
        stage.hand.leadTo(inside + glm::dvec3(0.0, 1.0, 0.0));
        QVERIFY(await([&] { return glm::length(tip() - inside - glm::dvec3(0.0, 1.0, 0.0)) < 0.01; }));
        QCOMPARE(state.layers[1].state, State::waiting);
        const std::uint64_t waitingUntil = state.sample.tick;
        stage.hand.leadTo(before);
        QVERIFY(becomes(State::inForce));
        QVERIFY(session->stopRecording() && session->end());

        // While the fixture waits nothing holds the tool, and the hand feels nothing.
        const Result<Take> take = stage.project.take(session->take());
        QVERIFY(take && waitingUntil > waitingFrom + 5);
        for (std::uint64_t i = waitingFrom; i <= waitingUntil; ++i) {
            const Sample& sample = take->samples[i];
            QVERIFY(glm::distance(sample.proxy.tip, sample.stylusTip) < 0.01);
            QVERIFY(glm::length(sample.force) < 0.05);
            QVERIFY((sample.flags & (sampleOnBoundary | sampleOnObstacle)) == 0);
        }
        for (const std::size_t wrong : {std::size_t{0}, std::size_t{4}})
            QCOMPARE(session->setLayer(wrong, false).error().code, ErrorCode::argumentInvalid);
    }

    /// The boundary grows while the tool mills, at unpredictable ticks: the trace contains the changes, and replays the
    /// same session bitwise. Without them it would be another one.
    void aSessionWhoseBoundaryGrewIsPlayedAgain_data() {
        QTest::addColumn<glm::dvec3>("axis");
        QTest::newRow("three axes") << upright;
        QTest::newRow("3+2") << leaning;
    }
    void aSessionWhoseBoundaryGrewIsPlayedAgain() {
        QFETCH(glm::dvec3, axis);
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("trace.csv").toStdString();
        const Surroundings surroundings = surroundingsOf(aroundTheBlock());
        AroundStage live(folder, {false, axis}, surroundings, 1500);
        Progress progress;
        const Result<ToolBounds> grown = ToolBounds::grow(live.milling, lent(live.milling.part), live.milling.tool,
                                                          {false, axis}, surroundings, 0.75, GrowthLimits{}, progress);
        QVERIFY(grown && grown->growth() && !grown->growth()->whole);
        SessionRequest request = handRequest(Pace::realtime);
        request.takeName = "grown";
        request.trace = file;
        const auto session =
            MillingSession::begin(live.project, live.milling, *grown, live.hand, live.strokes, request);
        QVERIFY(session && await([&] { return (*session)->ended(); }) && (*session)->end());
        const Result<Take> original = live.project.take((*session)->take());
        QVERIFY(original && original->samples.size() > 1000);

        Result<SessionTrace> trace = readSessionTrace(file);
        QVERIFY(trace && trace->began && trace->began->growth && trace->began->growth->maximumAllowance == 0.75);
        const auto isTile = [](const TimedChange& timed) { return std::holds_alternative<TileChange>(timed.change); };
        QVERIFY(std::ranges::count_if(trace->changes, isTile) >= 2);
        const auto play = [&] {
            const QTemporaryDir again;
            AroundStage stage(again, {false, axis}, surroundings, 0);
            const Result<ToolBounds> bounds =
                ToolBounds::asGrown(stage.milling, stage.milling.tool, {false, axis}, surroundings, *trace, progress);
            SessionRequest replay = handRequest(Pace::fast);
            replay.takeName = "again";
            replay.replayed = &*trace;
            TraceStylus stylus(trace->readings, trace->began->stylus);
            if (!bounds) return Take{};
            const auto played =
                MillingSession::begin(stage.project, stage.milling, *bounds, stylus, stage.strokes, replay);
            if (!played || !await([&] { return (*played)->ended(); }) || !(*played)->end()) return Take{};
            return stage.project.take((*played)->take()).value();
        };
        const auto same = [&](const Take& other) {
            const auto alike = [](const Sample& one, const Sample& again) {
                return one.proxy.tip == again.proxy.tip && one.cuttingForce == again.cuttingForce &&
                       (one.force == again.force || (one.flags & sampleForceLate) != 0);
            };
            return std::ranges::equal(original->samples, other.samples, alike);
        };
        QVERIFY(same(play()));
        std::erase_if(trace->changes, isTile);
        QVERIFY(!same(play()));
        // With a rig of fewer tiles it is refused.
        trace->changes.push_back({0, TileChange{100000, true}});
        const Result<ToolBounds> strange =
            ToolBounds::asGrown(live.milling, live.milling.tool, {false, axis}, surroundings, *trace, progress);
        QVERIFY(!strange && strange.error().code == ErrorCode::traceInvalid);
    }

    void aFieldAloneStillWillDo() {
        const QTemporaryDir folder;
        Stage stage(folder.filePath("p.burin").toStdString(), 1);
        stage.hand.mill(1);
        SessionRequest request = handRequest(Pace::fast);
        request.takeName = "one stroke";
        const auto session = stage.begin(request);
        QVERIFY(session && await([&] { return session->ended(); }) && session->end());
        SessionState state;
        QVERIFY(session->newest(state));
        QCOMPARE(state.layers.size(), std::size_t{1});
        QVERIFY(!session->setLayer(1, true));
    }
};

BURIN_TEST(TestSessionSurroundings, QCoreApplication)

} // namespace burin::tst_session_surroundings

#include "tst_session_surroundings.moc"
