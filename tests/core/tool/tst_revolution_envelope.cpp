// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/revolution_envelope.h"
#include "tests/core/geometry/shapes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

namespace burin::tst_revolution_envelope {

namespace {

double real(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'001) * 1e-6;
}

/// Radius of a profile at a height, the larger one where it jumps; mm.
double radiusAt(const std::vector<ProfileElement>& profile, double height) {
    double radius = -1.0;
    ProfileElement from;
    for (const ProfileElement& to : profile) {
        if (from.height <= height && height <= to.height) {
            const double rise = to.height - from.height;
            const double here =
                rise > 0.0 ? from.radius + (to.radius - from.radius) * ((height - from.height) / rise) : to.radius;
            radius = std::max({radius, here, rise > 0.0 ? here : from.radius});
        }
        from = to;
    }
    return radius;
}

} // namespace

class RevolutionEnvelopeTest : public QObject {
    Q_OBJECT
private slots:
    void aTurningBarIsACylinder() {
        const Result<RevolutionEnvelope> made =
            revolutionEnvelope(shapes::box({-3.0, -4.0, 0.0}, {3.0, 4.0, 10.0}), 0.01);
        QVERIFY(made);
        QCOMPARE(made->profile.size(), std::size_t(2)); // face and wall
        QCOMPARE(made->widest, 5.0);
        QCOMPARE(made->profile.back().height, 10.0);
        QVERIFY(made->excess < 1e-9);
    }

    /// A step is kept, however coarse the tolerance.
    void stepsStay() {
        TriangleMesh mesh = shapes::box({-1.0, 0.0, 0.0}, {1.0, 0.001, 4.0});
        append(mesh, shapes::box({-2.0, 0.0, 4.0}, {2.0, 0.001, 6.0}));
        const Result<RevolutionEnvelope> made = revolutionEnvelope(mesh, 0.5);
        QVERIFY(made);
        QVERIFY(std::abs(radiusAt(made->profile, 3.99) - 1.0) < 1e-6);
        QVERIFY(std::abs(radiusAt(made->profile, 4.01) - 2.0) < 1e-6);
    }

    /// Points on the triangles are the oracle: none is farther from the axis than the profile, and the profile is
    /// nowhere farther outside the mesh than stated.
    void nothingSticksOut() {
        QVERIFY(rc::check([] {
            TriangleMesh mesh = shapes::box({real(-3.0, -0.5), real(-3.0, -0.5), 0.0},
                                            {real(0.5, 3.0), real(0.5, 3.0), real(1.0, 9.0)});
            const double leanX = real(-0.5, 0.5), leanY = real(-0.5, 0.5), twist = real(-0.2, 0.2);
            for (glm::dvec3& v : mesh.vertices) {
                const double angle = twist * v.z, x = v.x + leanX * v.z, y = v.y + leanY * v.z;
                v = {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle), v.z};
            }
            const double tolerance = real(0.001, 0.2);
            const Result<RevolutionEnvelope> made = revolutionEnvelope(mesh, tolerance);
            RC_ASSERT(bool(made));
            constexpr int steps = 60;

            const double top = made->profile.back().height;
            for (const auto& [a, b, c] : mesh.triangles)
                for (int i = 0; i <= steps; ++i)
                    for (int j = 0; i + j <= steps; ++j) {
                        const double s = static_cast<double>(i) / steps, t = static_cast<double>(j) / steps;
                        const glm::dvec3 p =
                            (1.0 - s - t) * mesh.vertices[a] + s * mesh.vertices[b] + t * mesh.vertices[c];
                        RC_ASSERT(std::hypot(p.x, p.y) <= radiusAt(made->profile, std::clamp(p.z, 0.0, top)) + 1e-6);
                    }
            // The edges are where a rotating block is widest; they are approached from below and above at each height.
            for (int k = 1; k < 50; ++k) {
                const double height = top * (k + 0.37) / 51.0;
                double widest = 0.0;
                for (const auto& [a, b, c] : mesh.triangles)
                    for (const auto& [one, other] : {std::pair{a, b}, {b, c}, {c, a}}) {
                        const glm::dvec3 &p = mesh.vertices[one], &q = mesh.vertices[other];
                        if ((p.z < height) == (q.z < height)) continue;
                        const glm::dvec3 at = p + (q - p) * ((height - p.z) / (q.z - p.z));
                        widest = std::max(widest, std::hypot(at.x, at.y));
                    }
                RC_ASSERT(radiusAt(made->profile, height) - widest <= made->excess + 1e-6);
            }
            RC_ASSERT(made->excess <= 2.0 * tolerance + 0.02);
        }));
    }

    void whatIsNoFlutesIsRefused() {
        QVERIFY(!revolutionEnvelope({}, 0.01));
        QVERIFY(!revolutionEnvelope(shapes::box({-1.0, -1.0, 0.5}, {1.0, 1.0, 2.0}), 0.01));
        TriangleMesh apart = shapes::box({-1.0, -1.0, 0.0}, {1.0, 1.0, 1.0});
        append(apart, shapes::box({-1.0, -1.0, 2.0}, {1.0, 1.0, 3.0}));
        QVERIFY(!revolutionEnvelope(apart, 0.01));
    }
};

BURIN_TEST(RevolutionEnvelopeTest, NoApplication)

} // namespace burin::tst_revolution_envelope

#include "tst_revolution_envelope.moc"
