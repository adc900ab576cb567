// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/tool/tool.h"
#include "tests/core/haptics/tip_proxy.h"
#include "tests/test_program.h"

#include <QtTest>

#include <optional>

namespace burin::tst_proxy_on_part {

using burin::test::TipProxy;

namespace {

constexpr double voxel = 0.5;
constexpr double major = 12.0, minor = 4.0; // mm, of the torus

Cutter cutter(CutterType type) {
    Cutter result;
    result.type = type;
    result.diameter = 6.0;
    result.cornerRadius = type == CutterType::ball ? 3.0 : 0.0;
    result.fluteLength = 15.0;
    result.shankDiameter = 6.0;
    result.stickOut = 25.0;
    return result;
}

/// Around the z axis. Chords below 0.002 mm.
TriangleMesh torusMesh() {
    constexpr std::uint32_t around = 240, about = 120;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < about; ++j) {
            const double a = 2.0 * pi * i / around, b = 2.0 * pi * j / about;
            const double r = major + minor * std::cos(b);
            mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), minor * std::sin(b)});
        }
    const auto vertex = [](std::uint32_t i, std::uint32_t j) { return i % around * about + j % about; };
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < about; ++j) {
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return mesh;
}

/// A box about the origin.
TriangleMesh boxMesh(const glm::dvec3& half) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

struct Part {
    MeshDistance mesh;
    std::vector<RevolvedPiece> tool;
    ToolField field;

    static Part make(const TriangleMesh& triangles, CutterType type) {
        MeshDistance mesh(triangles);
        const std::vector<RevolvedPiece> tool = pieces(cutter(type));
        ToolFieldRequest request;
        request.tool = tool;
        request.tips = mesh.bounds().grown(8.0);
        request.voxel = voxel;
        request.maximumAllowance = 0.5;
        Progress progress;
        ToolField field = *ToolField::build(mesh, request, progress);
        return {std::move(mesh), tool, std::move(field)};
    }
    double clearance(const glm::dvec3& tip) const { return mesh.clearance(tool, {tip, {0, 0, 1}}).clearance; }
    /// Least clearance on the straight segment between two ticks.
    double clearance(const glm::dvec3& from, const glm::dvec3& to) const {
        double least = 1e300;
        for (int i = 0; i <= 4; ++i) least = std::min(least, clearance(glm::mix(from, to, i / 4.0)));
        return least;
    }
};

} // namespace

class TestProxyOnPart : public QObject {
    Q_OBJECT
    std::optional<Part> torus_;
private slots:
    void initTestCase() { torus_.emplace(Part::make(torusMesh(), CutterType::ball)); }

    void pressedIntoAFreeformPartItStaysOnIt() {
        const Part& part = *torus_;
        TipProxy proxy(part.field);
        for (double allowance : {0.0, 0.3}) {
            const double reach = minor + 3.0 + allowance;
            glm::dvec3 tip(major, 0, reach - 3.0 + 0.1);
            double deepest = 1e300, highest = 0.0, farthest = 0.0;
            constexpr int ticks = 1500;
            for (int i = 0; i <= ticks; ++i) {
                // Along the ring and back and forth across its top, with the centre of the ball 2 mm too deep.
                const double around = 6.0 * i / ticks, about = 0.5 * pi + 1.1 * std::sin(30.0 * i / ticks);
                const glm::dvec3 ring = major * glm::dvec3(std::cos(around), std::sin(around), 0.0);
                const glm::dvec3 out(std::cos(about) * std::cos(around), std::cos(about) * std::sin(around),
                                     std::sin(about));
                const glm::dvec3 goal = ring + (reach - 2.0) * out - glm::dvec3(0, 0, 3.0);
                const glm::dvec3 nearest = ring + reach * out - glm::dvec3(0, 0, 3.0);
                const TipProxy::Step step = proxy.advance(tip, goal, allowance, 2.0);
                deepest = std::min(deepest, part.clearance(tip, step.tip) - allowance);
                if (i > 20) highest = std::max(highest, part.clearance(step.tip) - allowance);
                if (i > 20) farthest = std::max(farthest, glm::length(step.tip - nearest));
                tip = step.tip;
            }
            QVERIFY2(deepest >= -0.05 * voxel, qPrintable(QString::number(deepest)));
            QVERIFY2(highest <= 0.1 * voxel, qPrintable(QString::number(highest)));
            // Cells of the field are flat facets: pressed 2 mm deep, the tip rests up to a third of a cell to the side.
            QVERIFY2(farthest <= 0.4 * voxel, qPrintable(QString::number(farthest)));
        }
    }

    void aFlatCutterPressedOverSharpEdgesStaysOut() {
        const glm::dvec3 half(8.0, 6.0, 4.0);
        const Part part = Part::make(boxMesh(half), CutterType::flat);
        TipProxy proxy(part.field);
        glm::dvec3 tip(0, 0, 6);
        double deepest = 1e300;
        constexpr int ticks = 1500;
        for (int i = 0; i <= ticks; ++i) {
            // Around and over the box, always aimed at a point inside the box grown by the tool.
            const double t = 25.0 * i / ticks;
            const glm::dvec3 goal(10.0 * std::cos(t), 8.0 * std::sin(1.3 * t), 1.0 + 2.0 * std::cos(0.7 * t));
            const TipProxy::Step step = proxy.advance(tip, goal, 0.0, 2.0);
            deepest = std::min(deepest, part.clearance(tip, step.tip));
            tip = step.tip;
        }
        QVERIFY2(deepest >= -0.5 * voxel, qPrintable(QString::number(deepest)));
    }

    void steadyContactDoesNotTremble() {
        const Part& part = *torus_;
        TipProxy proxy(part.field);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 goal(11.0 + 0.1 * i, 0.37 * i, 1.0 + 0.05 * i);
            glm::dvec3 tip = glm::dvec3(goal.x, goal.y, 9.0);
            for (int tick = 0; tick < 30; ++tick) tip = proxy.advance(tip, goal, 0.0, 2.0).tip;
            for (int tick = 0; tick < 30; ++tick)
                QVERIFY(glm::length(proxy.advance(tip, goal, 0.0, 2.0).tip - tip) < 1e-6);
        }
    }
};

BURIN_TEST(TestProxyOnPart, NoApplication)

} // namespace burin::tst_proxy_on_part

#include "tst_proxy_on_part.moc"
