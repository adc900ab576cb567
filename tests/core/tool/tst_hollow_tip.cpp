// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/tool/hollow_tip.h"
#include "core/tool/revolution_envelope.h"
#include "core/tool/swept_section.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/tool/fixed_tools.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin::tst_hollow_tip {

using random::real;

namespace {

std::optional<HollowSection> hollowOf(const TriangleMesh& mesh, double tolerance = 0.005) {
    const Progress progress;
    const RevolutionEnvelope envelope = revolutionEnvelope(mesh, tolerance).value();
    return hollowSection(weldIdenticalVertices(mesh), envelope.profile, std::max(tolerance, envelope.excess), progress);
}

/// Teeth around a free middle below a disc; boxes that may overlap.
struct Teeth {
    std::vector<Box> boxes;

    static Teeth any() {
        Teeth teeth;
        for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
            const glm::dvec3 low(real(-4.0, 1.5), real(-4.0, 1.5), i == 1 ? 0.0 : real(0.0, 2.0));
            teeth.boxes.push_back({low, {low.x + real(0.6, 2.5), low.y + real(0.6, 2.5), 4.5}});
        }
        teeth.boxes.push_back({{-5.0, -5.0, 4.0}, {5.0, 5.0, 6.0}});
        return teeth;
    }
    TriangleMesh mesh() const {
        TriangleMesh all;
        for (const Box& box : boxes) append(all, shapes::box(box.low, box.high));
        return weldIdenticalVertices(all);
    }
    /// Smallest distance of a circle about the axis from the boxes, mm; negative where it enters one. By many points.
    double distance(double radius, double height) const {
        constexpr int points = 1440;
        double nearest = 1e9;
        for (int i = 0; i < points; ++i) {
            const double angle = 2.0 * pi * i / points;
            for (const Box& box : boxes)
                nearest = std::min(nearest,
                                   shapes::boxDistance(box.low, box.high,
                                                       {radius * std::cos(angle), radius * std::sin(angle), height}));
        }
        return nearest;
    }
};

} // namespace

/// The section of what a turning tool sweeps, and whether it is hollow.
class HollowTipTest : public QObject {
    Q_OBJECT
private slots:
    /// Circles about the axis are the oracle: one that enters the boxes is in the section, one that is clear of them by
    /// more than the stated excess is not.
    void theSectionIsWhatCirclesMeet() {
        QVERIFY(rc::check([] {
            const Teeth teeth = Teeth::any();
            const Progress progress;
            const PlanRegion section = sweptSection(teeth.mesh(), progress);
            for (int i = 0; i < 60; ++i) {
                const double radius = real(0.01, 7.5), height = real(0.01, 5.99);
                const double distance = teeth.distance(radius, height);
                constexpr double spacing = 7.5 * pi / 1440.0; // mm, half of that of the points
                if (distance < 0.0) RC_ASSERT(holds(section, {radius, height}));
                if (distance > spacing + sweptSectionExcess) RC_ASSERT(!holds(section, {radius, height}));
            }
        }));
    }

    /// A tube: the inner facets come nearest to the axis in their middle, at r cos(pi / n).
    void aTubeIsHollow() {
        for (const std::uint32_t facets : {12U, 96U, 720U}) {
            const TriangleMesh tube = shapes::tube(6.0, 4.0, 60.0, facets);
            const std::optional<HollowSection> hollow = hollowOf(tube);
            QVERIFY(hollow && hollow->excess < 0.006);
            const ToolSolid solid = turningSolid(hollow->section, revolutionEnvelope(tube, 0.005).value().profile);
            const double inner = 4.0 * std::cos(pi / facets);
            QVERIFY2(solid.hollowWidth <= 2.0 * inner + 1e-4 && solid.hollowWidth > 2.0 * inner - 0.005,
                     qPrintable(QString::number(solid.hollowWidth, 'f', 5)));
            QVERIFY(std::abs(solid.hollowDepth - 60.0) < 0.001);
            QVERIFY(countOpenEdges(solid.flutes) == 0 && solid.turns());
            QVERIFY(std::abs(boreAt(solid, 30.0) - inner) < 0.003);
            const double exact = pi * (36.0 - inner * inner) * 60.0; // mm³
            QVERIFY2(std::abs(signedVolume(solid.flutes) / exact - 1.0) < 1e-3,
                     qPrintable(QString::number(signedVolume(solid.flutes))));
        }
    }

    /// A bar, a cylinder and a cone are described by their profile; so are a dent shallower than the tolerance and a
    /// void that nothing can enter.
    void whatAProfileDescribesIsNotHollow() {
        QVERIFY(!hollowOf(shapes::box({-3.0, -4.0, 0.0}, {3.0, 4.0, 10.0})));
        const auto dented = [](double depth) { // a cylinder whose lower face is a cone that points upwards
            return shapes::wrapped(360, 4, [&](std::uint32_t i, std::uint32_t j) {
                const double u = 2.0 * pi * i / 360, r = j == 1 || j == 2 ? 5.0 : 1e-4;
                return glm::dvec3(r * std::cos(u), r * std::sin(u), j == 0 ? depth : j == 1 ? 0.0 : 9.0);
            });
        };
        QVERIFY(!hollowOf(dented(0.0)) && !hollowOf(dented(0.003)));
        const std::optional<HollowSection> cupped = hollowOf(dented(0.5));
        QVERIFY(cupped);
        const ToolSolid solid = turningSolid(cupped->section, std::vector<ProfileElement>{{5.0, 0.0}, {5.0, 9.0}});
        QVERIFY2(std::abs(solid.hollowDepth - 0.5) < 0.02 && std::abs(solid.hollowWidth - 10.0) < 0.2,
                 qPrintable(QStringLiteral("%1 %2").arg(solid.hollowDepth).arg(solid.hollowWidth)));
        TriangleMesh voided = shapes::box({-4.0, -4.0, 0.0}, {4.0, 4.0, 10.0}),
                     inside = shapes::box({-2.0, -2.0, 3.0}, {2.0, 2.0, 7.0});
        for (auto& triangle : inside.triangles) std::swap(triangle[0], triangle[1]);
        append(voided, inside);
        QVERIFY(!hollowOf(voided));
    }

    void aFileKeepsTheHollow() {
        Tool tool;
        tool.id = tool.name = tool.source = "core";
        tool.maximumDepthOfCut = 10.0;
        tool.cutter = cutters::annular();
        QVERIFY(validate(tool));
        const std::string text = toJson(tool);
        const Result<Tool> read = toolFromJson(text, "core.json");
        QVERIFY(read && read->cutter.turns() && read->cutter.isHollow());
        QCOMPARE(toJson(*read), text);
        QVERIFY(read->cutter.solid->section == tool.cutter.solid->section);
        QVERIFY(!checkTilts(tool.cutter) && checkTurns(tool.cutter, "x"));
        ToolSolid wide = *tool.cutter.solid;
        for (glm::dvec2& corner : wide.section.rings.front()) corner.x *= 1.1;
        tool.cutter.solid = std::make_shared<const ToolSolid>(turningSolid(wide.section, tool.cutter.profile));
        QVERIFY(!validate(tool));
        tool.cutter.solid = std::make_shared<const ToolSolid>(turningSolid({{{{1.0, 1.0}, {2.0, 2.0}}}}, {}));
        QVERIFY(!validate(tool));
    }
};

BURIN_TEST(HollowTipTest, NoApplication)

} // namespace burin::tst_hollow_tip

#include "tst_hollow_tip.moc"
