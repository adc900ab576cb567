// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Burin's proxy compared with a god-object on the mesh and a point shell in voxels: the same hand and parts, in one
// run.
#include "core/base/units.h"
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/peers/finger_proxy.h"
#include "tests/benchmarks/peers/point_shell.h"
#include "tests/benchmarks/scenes/part_meshes.h"
#include "tests/benchmarks/scenes/tool_paths.h"
#include "tests/core/haptics/tip_proxy.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace burin::benchmarks {

namespace {

constexpr double radius = 3.0;    // mm, of the ball
constexpr double voxel = 0.25;    // mm
constexpr double stiffness = 1.0; // N/mm, from the ball to the hand
constexpr double stride = 0.03;   // mm a tick: 30 mm/s
constexpr double press = 0.5;     // mm of the hand below the contact position

/// Follows a hand with the centre of a ball.
class Follower {
public:
    virtual ~Follower() = default;
    virtual void place(const glm::dvec3& centre) = 0;
    virtual glm::dvec3 advance(const glm::dvec3& goal) = 0;
};

class OwnFollower final : public Follower {
public:
    OwnFollower(const MeshDistance& part, const Box& region) : field_(fieldOf(part, region)), proxy_(field_) {}
    void place(const glm::dvec3& centre) override { tip_ = centre - upTo; }
    glm::dvec3 advance(const glm::dvec3& goal) override {
        tip_ = proxy_.advance(tip_, goal - upTo, 0.0, 1.0).tip;
        return tip_ + upTo;
    }

private:
    static ToolField fieldOf(const MeshDistance& part, const Box& region) {
        ToolFieldRequest request;
        request.tool = pieces(cutterOf(CutterType::ball, radius, fluteLengthFromAbove));
        request.tips = Box{region.low - upTo, region.high - upTo};
        request.voxel = voxel;
        Progress progress;
        return require(ToolField::build(part, request, progress), "a benchmark's field");
    }
    static constexpr glm::dvec3 upTo{0.0, 0.0, radius}; // from tip to centre
    ToolField field_;
    test::TipProxy proxy_;
    glm::dvec3 tip_{0.0};
};

template <class Peer>
class PeerFollower final : public Follower {
public:
    template <class... Arguments>
    explicit PeerFollower(const Arguments&... arguments) : peer_(arguments...) {}
    void place(const glm::dvec3& centre) override { peer_.place(centre); }
    glm::dvec3 advance(const glm::dvec3& goal) override { return peer_.advance(goal); }

private:
    Peer peer_;
};

/// A part, and a hand that presses a ball against it.
struct PressedBall {
    TriangleMesh mesh;
    Box region; ///< of the centre, with a margin, mm
    glm::dvec3 begin{0.0};
    std::vector<glm::dvec3> goals;
};

struct Followed {
    std::vector<glm::dvec3> centres;
    std::vector<double> microseconds;
};

Followed follow(Follower& follower, const PressedBall& ball) {
    follower.place(ball.begin);
    for (int i = 0; i < 200; ++i) (void)follower.advance(ball.goals.front()); // it settles
    Followed followed;
    for (const glm::dvec3& goal : ball.goals) {
        const double begun = processorMicroseconds();
        const glm::dvec3 centre = follower.advance(goal);
        followed.microseconds.push_back(processorMicroseconds() - begun);
        followed.centres.push_back(centre);
    }
    return followed;
}

/// The centre of a ball that touches the part when it comes down from above.
glm::dvec3 touchedFromAbove(const MeshDistance& part, glm::dvec3 centre) {
    for (int i = 0; i < 1000; ++i) {
        const double gap = part.closest(centre).signedDistance - radius;
        if (gap < 1e-9) break;
        centre.z -= gap;
    }
    return centre;
}

/// Moves in a circle on the top of a bumpy part of 60,000 triangles.
PressedBall onBumps() {
    PressedBall ball;
    ball.mesh = bumpyPart(100.0, 6e4);
    const MeshDistance part(ball.mesh);
    constexpr double across = 8.0; // mm
    for (double turn = 0.0; turn < 2.0 * pi; turn += stride / across) {
        const glm::dvec3 above(50.0 + across * std::cos(turn), 50.0 + across * std::sin(turn), 110.0);
        ball.goals.push_back(touchedFromAbove(part, above) - glm::dvec3(0.0, 0.0, press));
        ball.region.include(ball.goals.back());
    }
    ball.begin = ball.goals.front() + glm::dvec3(0.0, 0.0, press + 0.01);
    ball.region = ball.region.grown(radius + 3.0);
    return ball;
}

/// Moves along the edge of a block, pressed equally towards both of its faces: an ideal ball stays beside the edge.
PressedBall alongEdge() {
    PressedBall ball;
    ball.mesh = shapes::box({0.0, 0.0, 0.0}, {40.0, 40.0, 20.0});
    const glm::dvec3 out = glm::normalize(glm::dvec3(-1.0, 0.0, 1.0));
    ball.begin = glm::dvec3(0.0, 10.0, 20.0) + (radius + 0.01) * out;
    for (double way = 0.0; way < 18.0; way += stride)
        ball.goals.push_back(glm::dvec3(0.0, 10.0 + way, 20.0) + (radius - press) * out);
    for (const glm::dvec3& goal : ball.goals) ball.region.include(goal);
    ball.region = ball.region.grown(radius + 3.0);
    return ball;
}

/// Moves against a wall of 0.4 mm and through it, by 3 mm.
PressedBall atThinWall() {
    PressedBall ball;
    ball.mesh = shapes::box({0.0, -20.0, 0.0}, {0.4, 20.0, 20.0});
    ball.begin = {-radius - 0.5, 0.0, 10.0};
    for (double x = ball.begin.x; x < 3.0; x += stride) ball.goals.emplace_back(x, 0.0, 10.0);
    for (const glm::dvec3& goal : ball.goals) ball.region.include(goal);
    ball.region = ball.region.grown(radius + 3.0);
    return ball;
}

double gougeOf(const MeshDistance& part, const Followed& followed) {
    double worst = 0.0;
    for (const glm::dvec3& centre : followed.centres)
        worst = std::max(worst, radius - part.closest(centre).signedDistance);
    return worst;
}

/// The mean distance between ball and part, mm, by which the surface is felt too early.
double gapOf(const MeshDistance& part, const Followed& followed) {
    double sum = 0.0;
    for (const glm::dvec3& centre : followed.centres) sum += std::abs(part.closest(centre).signedDistance - radius);
    return sum / static_cast<double>(followed.centres.size());
}

/// The root mean square of the difference between a force and the mean of its neighbours, N.
double noiseOf(const PressedBall& ball, const Followed& followed) {
    const auto force = [&](std::size_t tick) { return stiffness * (ball.goals[tick] - followed.centres[tick]); };
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < ball.goals.size(); ++i) {
        const glm::dvec3 off = force(i) - 0.5 * (force(i - 1) + force(i + 1));
        sum += glm::dot(off, off);
    }
    return std::sqrt(sum / static_cast<double>(ball.goals.size() - 2));
}

/// The largest distance from the ideal position beside the edge, mm.
double strayOf(const Followed& followed) {
    const glm::dvec3 ideal = glm::dvec3(0.0, 0.0, 20.0) + radius * glm::normalize(glm::dvec3(-1.0, 0.0, 1.0));
    double worst = 0.0;
    for (const glm::dvec3& centre : followed.centres)
        worst = std::max(worst, std::hypot(centre.x - ideal.x, centre.z - ideal.z));
    return worst;
}

/// How far the ball gets beyond the position where the wall holds it, mm.
double passedWall(const Followed& followed) {
    double farthest = 0.0;
    for (const glm::dvec3& centre : followed.centres) farthest = std::max(farthest, centre.x + radius);
    return farthest;
}

struct Measured {
    std::vector<double> microseconds;
    double gouge = 0.0, gap = 0.0, noise = 0.0, stray = 0.0, passed = 0.0;
};

/// @param make  makes a follower for a part and a region
template <class Make>
Measured measured(Session& session, const std::string& name, const Make& make) {
    Measured result;
    session.stage("peer." + name);
    const auto run = [&](const PressedBall& ball, const auto& look) {
        const MeshDistance part(ball.mesh);
        const std::unique_ptr<Follower> follower = make(part, ball.region);
        look(part, ball, follow(*follower, ball));
    };
    run(onBumps(), [&](const MeshDistance& part, const PressedBall& ball, const Followed& followed) {
        result.microseconds = session.least("peer." + name, followed.microseconds);
        result.gouge = gougeOf(part, followed);
        result.gap = gapOf(part, followed);
        result.noise = noiseOf(ball, followed);
    });
    run(alongEdge(),
        [&](const MeshDistance&, const PressedBall&, const Followed& followed) { result.stray = strayOf(followed); });
    run(atThinWall(), [&](const MeshDistance&, const PressedBall&, const Followed& followed) {
        result.passed = passedWall(followed);
    });
    return result;
}

void compare(Session& session, const std::string& name, const std::string& peer, const Measured& own,
             const Measured& other) {
    const std::string stem = "peer." + name;
    const auto add = [&](const char* what, double value, const char* unit, double peerValue) {
        session.add(against(figure(stem + what, value, unit), peer, peerValue));
    };
    add(".tick_us.p50", percentile(own.microseconds, 0.5), "us", percentile(other.microseconds, 0.5));
    add(".tick_us.p999", percentile(own.microseconds, 0.999), "us", percentile(other.microseconds, 0.999));
    add(".gouge_mm", own.gouge, "mm", other.gouge);
    add(".gap_mm", own.gap, "mm", other.gap);
    add(".force_noise_n", own.noise, "N", other.noise);
    add(".edge_stray_mm", own.stray, "mm", other.stray);
    add(".wall_passed_mm", own.passed, "mm", other.passed);
}

} // namespace

void peerFigures(Session& session) {
    if (!session.wants("peer.")) return;
    const auto own = [](const MeshDistance& part, const Box& region) -> std::unique_ptr<Follower> {
        return std::make_unique<OwnFollower>(part, region);
    };
    const auto godObject = [](const MeshDistance& part, const Box&) -> std::unique_ptr<Follower> {
        return std::make_unique<PeerFollower<FingerProxy>>(part, radius);
    };
    const auto pointShell = [](const MeshDistance& part, const Box& region) -> std::unique_ptr<Follower> {
        PointShell::Settings settings;
        settings.radius = radius;
        settings.voxel = voxel;
        settings.coupling = stiffness;
        return std::make_unique<PeerFollower<PointShell>>(part, region, settings);
    };
    const Measured ours = measured(session, "own", own);
    compare(session, "god_object", "god-object", ours, measured(session, "god_object", godObject));
    compare(session, "point_shell", "point shell", ours, measured(session, "point_shell", pointShell));
}

} // namespace burin::benchmarks
