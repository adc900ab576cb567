// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/mesh_distance.h"
#include "tests/core/geometry/shapes.h"
#include "tests/imported_mesh.h"
#include "tests/long_run.h"
#include "tests/part_field/part_field.h"
#include "tests/test_program.h"

#include <QtTest>

#include <random>

namespace burin::tst_thin_features {

namespace {

constexpr double voxel = 0.5, length = 24.0;

/// A long bar's outline, corners in order, all of them right angles.
using Outline = std::vector<glm::dvec2>;

/// Signed distance to a bar, far from its ends: closed formula in the plane perpendicular to it.
double barDistance(const Outline& outline, const glm::dvec2& p) {
    double least = 1e300;
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()], way = b - a;
        const double share = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
        least = std::min(least, glm::length(p - a - share * way));
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside ? -least : least;
}

struct Bar {
    TriangleMesh mesh;
    Outline outline;
};

/// A flat top at 10 mm, with a slot or a rib starting at `low`. @param rise mm, negative: a slot
Bar barWith(double low, double width, double rise) {
    const double high = low + width, end = 10.0 + rise;
    if (rise < 0.0)
        return {shapes::cells({0.0, length}, {0.0, low, high, 20.0}, {0.0, end, 10.0},
                              [](int, int j, int k) { return j != 1 || k != 1; }),
                {{0, 0}, {20, 0}, {20, 10}, {high, 10}, {high, end}, {low, end}, {low, 10}, {0, 10}}};
    return {shapes::cells({0.0, length}, {0.0, low, high, 20.0}, {0.0, 10.0, end},
                          [](int, int j, int k) { return j == 1 || k == 0; }),
            {{0, 0}, {20, 0}, {20, 10}, {high, 10}, {high, end}, {low, end}, {low, 10}, {0, 10}}};
}

PartField built(const TriangleMesh& mesh, double edge, double reach) {
    Progress progress;
    Result<PartField> field = PartField::build(mesh, {edge, reach}, progress);
    if (!field) qFatal("no field");
    return std::move(*field);
}

class Random {
public:
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

private:
    std::mt19937_64 engine_{20261123};
};

} // namespace

/// Describes a point where a field's error exceeds its bound, or empty. @param distance the true one there
QString breach(const PartField& field, const glm::dvec3& p, double distance, double tolerance) {
    const double error = std::abs(field.value(p) - distance), bound = field.errorBoundAt(p);
    if (error <= bound + tolerance) return {};
    return QString("off by %1 mm, said %2, at %3 %4 %5").arg(error).arg(bound).arg(p.x).arg(p.y).arg(p.z);
}

/// Features between the samples of a field, at positions unrelated to the part's: no error exceeds the field's bound
/// there, in the band and beyond it. (Slots used to be bridged, by up to two voxels, wherever the samples around lay on
/// the face.)
class ThinFeaturesTest : public QObject {
    Q_OBJECT

private slots:
    void slotsAndRibsKeepTheStatedBound_data() {
        QTest::addColumn<double>("width"); // voxels
        QTest::addColumn<bool>("slot");
        for (const double width : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0})
            for (const bool slot : {true, false})
                QTest::addRow("%s of %g voxels", slot ? "slot" : "rib", width) << width << slot;
    }
    void slotsAndRibsKeepTheStatedBound() {
        QFETCH(const double, width);
        QFETCH(const bool, slot);
        Random random;
        for (int part = 0; part < testing::inLongRun(5, 1); ++part) {
            const double low = random.number(4.0, 12.0), rise = random.number(1.0, 8.0);
            const Bar bar = barWith(low, width * voxel, slot ? -rise : rise);
            const PartField field = built(bar.mesh, voxel, random.number(2.0, 6.0));
            for (int i = 0; i < 2000; ++i) {
                const glm::dvec3 p(random.number(8.0, length - 8.0), low + width * voxel / 2 + random.number(-3.0, 3.0),
                                   10.0 + random.number(-3.0, slot ? 4.0 : rise + 4.0));
                const QString wrong = breach(field, p, barDistance(bar.outline, {p.y, p.z}), 1e-6);
                QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
            }
        }
    }

    /// Positions where the middle of a wall or a gap affects the distance between two samples that lie on the straight
    /// faces next to it: five voxels and more from the surface, because the lines between samples 2 apart miss it.
    void whatLinesPassOverIsSeen_data() {
        QTest::addColumn<double>("width"); // voxels
        QTest::addColumn<double>("low");   // mm, all of these
        QTest::addColumn<double>("rise");
        QTest::addColumn<double>("reach");
        QTest::newRow("slot of 2.5 voxels") << 2.5 << 5.4844831 << -4.3751547 << 5.3849409;
        QTest::newRow("shallower slot of 2.5 voxels") << 2.5 << 5.2593453 << -6.2327467 << 5.6094969;
        QTest::newRow("slot of 2.8 voxels") << 2.8 << 10.6174767 << -3.4967248 << 5.1941391;
        QTest::newRow("rib of 2.5 voxels") << 2.5 << 4.6219192 << 2.3629735 << 4.2618105;
        QTest::newRow("rib of 3 voxels") << 3.0 << 4.5330908 << 3.8706327 << 3.2083039;
    }
    void whatLinesPassOverIsSeen() {
        QFETCH(const double, width);
        QFETCH(const double, low);
        QFETCH(const double, rise);
        QFETCH(const double, reach);
        const Bar bar = barWith(low, width * voxel, rise);
        const PartField field = built(bar.mesh, voxel, reach);
        Random random;
        for (int i = 0; i < testing::inLongRun(20000, 5000); ++i) {
            const glm::dvec3 p(random.number(8.0, length - 8.0), low + width * voxel * random.number(0.0, 1.0),
                               10.0 + std::max(rise, 0.0) + random.number(-8.0, 8.0));
            const QString wrong = breach(field, p, barDistance(bar.outline, {p.y, p.z}), 1e-6);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        }
    }

    /// A moulded part with details of about a voxel, and with facets of many. All of its own triangles, one by one, are
    /// the oracle.
    void aMouldedPartKeepsTheStatedBound_data() {
        QTest::addColumn<double>("voxels"); // along its longest side
        for (const double voxels : {64.0, 200.0})
            if (voxels < 100.0 || testing::longRun()) QTest::addRow("%g voxels", voxels) << voxels;
    }
    void aMouldedPartKeepsTheStatedBound() {
        QFETCH(const double, voxels);
        const TriangleMesh mesh = tests::importedMesh("mouse-cover.stl");
        QVERIFY(!mesh.empty());
        const MeshDistance exact(mesh);
        const Box box = boundingBox(mesh);
        const glm::dvec3 size = box.high - box.low;
        const double edge = std::max({size.x, size.y, size.z}) / voxels;
        const PartField field = built(mesh, edge, 8.0 * edge);
        Random random;
        for (int i = 0; i < testing::inLongRun(60000, 20000); ++i) {
            const auto triangle = std::size_t(random.number(0.0, double(mesh.triangles.size())));
            const auto& [a, b, c] = mesh.triangles[std::min(triangle, mesh.triangles.size() - 1)];
            const double away = i % 2 == 0 ? 4.0 : 12.0; // in the band, and beyond it
            const glm::dvec3 off(random.number(-away, away), random.number(-away, away), random.number(-away, away));
            const glm::dvec3 p =
                glm::mix(mesh.vertices[a], glm::mix(mesh.vertices[b], mesh.vertices[c], 0.5), random.number(0.0, 1.0)) +
                edge * off;
            const QString wrong = breach(field, p, exact.closest(p).signedDistance, 1e-5);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        }
    }
};

BURIN_TEST(ThinFeaturesTest, NoApplication)

} // namespace burin::tst_thin_features

#include "tst_thin_features.moc"
