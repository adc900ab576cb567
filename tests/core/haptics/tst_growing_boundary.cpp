// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/growing_boundary.h"
#include "core/haptics/trace/step_change_text.h"
#include "core/haptics/trace/traced_session.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/random_number.h"
#include "tests/test_program.h"

#include <QtTest>

#include <rapidcheck.h>

#include <array>

namespace burin::tst_growing_boundary {

using namespace burin::test;

namespace {

const glm::dvec3 upright(0.0, 0.0, 1.0);
const glm::dmat3 noTurn(1.0);

/// The part of `stockOnPart` with a boss on it that rises into the stock.
TriangleMesh bossedFloor() {
    TriangleMesh mesh = shapes::box({-20.0, -20.0, -20.0}, {20.0, 20.0, floorHeight});
    append(mesh, shapes::box({-4.0, -5.0, floorHeight - 5.0}, {5.0, 6.0, -4.0}));
    return mesh;
}

/// A boundary of which nothing is there yet, and all its tiles, to be announced one by one.
struct Growth {
    Growth() {
        Progress progress;
        const ToolFieldRequest request{pieces(ballTool().cutter), {{-24, -24, -16}, {24, 24, 20}}, 0.25, 1.0};
        auto laid = GrowingField::lay(part, request, {}, progress);
        if (!laid) std::abort(); // the test's own set-up
        field = *std::move(laid);
        made.resize(field->layout().count());
        for (std::uint32_t tile = 0; tile < made.size(); ++tile) {
            auto bricks = field->tile(tile, progress);
            if (!bricks) std::abort();
            made[tile] = *bricks;
            if (made[tile]) needed.push_back(tile);
        }
    }
    BoundaryLayers layers() const { return BoundaryLayers(std::make_unique<GrowingBoundary>(field, noTurn, made)); }
    /// Distance of the tool from the mesh.
    double clearance(const glm::dvec3& tip) const {
        return part->clearance(pieces(ballTool().cutter), {tip, upright}).clearance;
    }

    std::shared_ptr<const MeshDistance> part = std::make_shared<const MeshDistance>(bossedFloor());
    std::shared_ptr<GrowingField> field;
    GrowingBoundary::Tiles made;
    std::vector<std::uint32_t> needed;
};

/// A step whose boundary grows, and the values observed.
struct GrowingSession {
    GrowingSession(const Growth& growing, double allowance)
        : growth(growing)
        , volume(stockOnPart())
        , there(growth.made.size(), false)
        , step(volume, growth.layers(), ballTool(), settings(allowance)) {}

    static HapticSettings settings(double allowance) {
        HapticSettings settings = Rig::settings();
        settings.allowance = allowance;
        return settings;
    }
    void tell(std::uint32_t tile, bool comes) {
        step.apply(StepChange(TileChange{tile, comes}));
        there[tile] = comes;
    }
    Sample feed(const glm::dvec3& hand) {
        StylusState state;
        state.pose.position = hand;
        state.valid = true;
        const Sample sample = step.advance(state, period);
        note(sample);
        return sample;
    }
    void note(const Sample& sample) {
        const TileLayout& layout = growth.field->layout();
        const glm::dvec3 tip = sample.proxy.tip;
        if ((sample.flags & sampleForcesOff) != 0) { // not active yet: the tool is shown, and has no effect
            last.reset();
            return;
        }
        if (last) {
            const glm::dvec3 change = sample.force - last->force;
            steepest = std::max(steepest,
                                glm::length(change) / std::max(step.limiter().riseStep(), step.limiter().fallStep()));
            for (int i = 0; i <= 4; ++i)
                deepest = std::min(deepest, growth.clearance(glm::mix(last->proxy.tip, tip, 0.25 * i)));
        }
        finite = finite && isFinite(sample.force) && isFinite(tip);
        if (!there[layout.tileOf(layout.kept(tip))] && growth.made[layout.tileOf(layout.kept(tip))])
            farthestIn = std::min(farthestIn, growth.field->outline(layout.kept(tip)).clearance);
        last = sample;
    }

    const Growth& growth;
    RunVolume volume;
    std::vector<bool> there;
    HapticStep step;
    std::optional<Sample> last;
    double deepest = 1e9;    ///< mm, the least clearance from the mesh, also between ticks
    double farthestIn = 1e9; ///< mm, the outline's clearance for a tip where its tile was not there
    double steepest = 0.0;   ///< largest change of force in a tick, as a share of the limiter's limit
    bool finite = true;
};

glm::dvec3 wander(double t, double seed) {
    return {15.0 * std::sin(1.9 * t + seed), 14.0 * std::cos(2.3 * t + 2.0 * seed),
            -6.0 + 9.0 * std::sin(3.1 * t + 0.7 * seed)};
}

} // namespace

class TestGrowingBoundary : public QObject {
    Q_OBJECT
    std::unique_ptr<Growth> growth_;
private slots:
    void initTestCase() { growth_ = std::make_unique<Growth>(); }

    /// Tiles come and go in random order while a hand roves through part and stock: the tool is never in the part,
    /// never where the known boundary does not permit it, and the force stays finite and within the slew limit.
    void theToolKeepsToWhatIsThere() {
        const Growth& growth = *growth_;
        QVERIFY(growth.needed.size() >= 8);
        int without = 0; // ticks in which the outline held the tool: the subject of this test
        const bool held = rc::check("tiles come and go", [&] {
            const double allowance = *rc::gen::element(0.0, 0.4), seed = randomNumber(0.0, 6.0);
            GrowingSession session(growth, allowance);
            for (int tick = 0; tick < 1500; ++tick) {
                if (tick % 25 == 0) {
                    const std::uint32_t tile = *rc::gen::elementOf(growth.needed);
                    const TileLayout& layout = growth.field->layout();
                    const bool far = !session.last || layout.distance(tile, session.last->proxy.tip) > layout.edge;
                    if (!session.there[tile] || far) session.tell(tile, !session.there[tile]);
                }
                session.feed(wander(0.001 * tick, seed));
                if (session.last && !session.there[growth.field->layout().tileOf(session.last->proxy.tip)]) ++without;
            }
            RC_ASSERT(session.finite);
            RC_ASSERT(session.steepest <= 1.0 + 1e-9);
            RC_ASSERT(session.deepest >= allowance - 0.1 * 0.25 - 0.022); // as in push_back at edges
            RC_ASSERT(session.farthestIn >= allowance - 0.02);
        });
        QVERIFY(held);
        QVERIFY(without > 1000);
    }

    /// The tool is held above the part by tiles that are not there yet, and a force indicates that; when they arrive,
    /// the tool continues to the part and the force falls no faster than the slew limit.
    void whatComesLetsTheToolGoOn() {
        const Growth& growth = *growth_;
        GrowingSession session(growth, 0.0);
        const auto press = [&](int ticks) {
            Sample sample;
            for (int i = 0; i < ticks; ++i)
                sample = session.feed({12.0, 12.0, std::max(floorHeight - 1.0, 10.0 - 0.05 * pressed_++)});
            return sample;
        };
        pressed_ = 0;
        const Sample held = press(800);
        QVERIFY(held.proxy.tip.z > floorHeight + 0.2);
        QVERIFY(held.force.z > 0.3);
        QVERIFY(growth.clearance(held.proxy.tip) > 0.2);
        for (const std::uint32_t tile : growth.needed) session.tell(tile, true);
        const Sample free = press(300);
        QVERIFY2(std::abs(free.proxy.tip.z - floorHeight) < 0.05, qPrintable(QString::number(free.proxy.tip.z)));
        QVERIFY(session.steepest <= 1.0 + 1e-9 && session.finite && session.deepest > -0.03);
    }

    /// The same axis seen from elsewhere: a part and a tool that are rotated together are held in the same way.
    void aTurnedBoundaryHoldsAlike() {
        const Growth& growth = *growth_;
        const glm::dmat3 turn(glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0));
        GrowingBoundary straight(growth.field, noTurn, growth.made), turned(growth.field, turn, growth.made);
        for (const std::uint32_t tile : growth.needed) {
            straight.apply({tile, true});
            turned.apply({tile, true});
        }
        const glm::dmat3 back = glm::transpose(turn);
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 tip = wander(0.05 * i, 1.0);
            const PoseSample one = straight.at({tip, upright}, 1.0), other = turned.at({back * tip, upright}, 1.0);
            QVERIFY(std::abs(one.clearance - other.clearance) < 1e-9);
            QVERIFY(glm::length(back * one.gradient - other.gradient) < 1e-9);
        }
    }

    /// Changes of a boundary's tiles, and its state at the start of a session, are written to its trace.
    void changesOfTilesAreWrittenAndRead() {
        for (const TileChange& told : {TileChange{0, true}, TileChange{70000, false}}) {
            std::string text;
            StepChangeWriter().append(text, "", StepChange(told));
            StepChangeReader reader;
            const auto read = reader.read(text, "trace");
            QVERIFY(read && *read && std::holds_alternative<TileChange>(**read));
            const TileChange again = std::get<TileChange>(**read);
            QVERIFY(again.tile == told.tile && again.there == told.there);
        }
        TracedSession session;
        session.stylus = desktopStylus();
        const auto plain = readTracedSession(formatTracedSession(session), "trace");
        QVERIFY(plain && !plain->growth);
        session.growth = {0.75, true};
        const auto grown = readTracedSession(formatTracedSession(session), "trace");
        QVERIFY(grown && grown->growth && grown->growth->maximumAllowance == 0.75 && grown->growth->whole);
    }

private:
    int pressed_ = 0;
};

BURIN_TEST(TestGrowingBoundary, NoApplication)

} // namespace burin::tst_growing_boundary

#include "tst_growing_boundary.moc"
