// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/contact.h"
#include "tests/core/cutting/sweeping.h"
#include "tests/core/tool/cutters.h"
#include "tests/core/tool/random_sweeps.h"

#include <QtTest>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <tuple>

using namespace burin;
using namespace burin::tests;
using random::real;

namespace {

constexpr double edge = 0.25;

/// Stock with a part in its lower third, in a grid with any axis of its runs.
RunVolume workpiece(RunAxis runs) {
    RunVolume volume = solid({-15.0, -15.0, -20.0}, edge, {120, 120, 80}, runs);
    const Grid& grid = volume.grid();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            for (std::int32_t k = 0; k < grid.voxelsPerLine(); ++k) {
                const VoxelIndex voxel = grid.voxel(line, k);
                if (voxel.k < 24)
                    (void)volume.fillSpan(line, static_cast<RunPosition>(k) * 256,
                                          static_cast<RunPosition>(k + 1) * 256, part);
            }
    return volume;
}

std::vector<RevolvedPiece> toolOf(const Cutter& cutter) {
    return pieces(cutter);
}

bool same(const ShankContact& a, const ShankContact& b) {
    bool equal = a.touches == b.touches && a.piece == b.piece && a.property == b.property && a.volume == b.volume &&
                 a.touchesStock == b.touchesStock && a.touchesProtected == b.touchesProtected;
    for (std::size_t i = 0; i < a.touched.size(); ++i)
        equal = equal && a.touched[i].property == b.touched[i].property && a.touched[i].volume == b.touched[i].volume;
    return equal && glm::length(a.place - b.place) < 1e-9;
}

bool guardedHolds(const std::vector<RevolvedPiece>& tool, std::size_t flutes, const ToolPose& pose,
                  const glm::dvec3& place) {
    const glm::dvec3 q = place - pose.tip;
    const double height = glm::dot(q, pose.axis), radius = glm::length(q - height * pose.axis);
    return std::any_of(tool.begin() + static_cast<std::ptrdiff_t>(flutes), tool.end(), [&](const RevolvedPiece& piece) {
        return height >= piece.bottom && height <= piece.top && radius <= radiusAt(piece, height);
    });
}

ToolPose leaning(const glm::dvec3& tip, double lean, double turn) {
    return {tip, {std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean)}};
}

std::tuple<int, int, int> key(VoxelIndex voxel) {
    return {voxel.i, voxel.j, voxel.k};
}

} // namespace

class ContactTest : public QObject {
    Q_OBJECT

private slots:
    /// Volume, centre and properties of a contact against points counted in all voxels, any axis of tool and runs.
    void agreesWithCountedPoints() {
        int touching = 0;
        const bool held = rc::check("counted points", [&] {
            const RunVolume volume = workpiece(static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
            const Cutter cutter = cutters::all()[static_cast<std::size_t>(*rc::gen::inRange(0, 9))].cutter;
            const std::vector<RevolvedPiece> tool = toolOf(cutter);
            const std::size_t flutes = flutePieces(cutter).size();
            const glm::dvec3 tip(real(-10.0, 10.0), real(-10.0, 10.0), real(-25.0, 4.0));
            const ToolPose pose = leaning(tip, real(0.0, 1.5), real(0.0, 6.28));
            const ShankContact contact = shankContact(volume, tool, flutes, pose);
            const Grid& grid = volume.grid();
            std::array<double, 4> counted{};
            for (int i = 0; i < grid.count().x; ++i)
                for (int j = 0; j < grid.count().y; ++j)
                    for (int k = 0; k < grid.count().z; ++k) {
                        const glm::dvec3 centre = grid.low() + (glm::dvec3(i, j, k) + 0.5) * edge;
                        if (guardedHolds(tool, flutes, pose, centre))
                            counted[k < 24 ? part : softStock] += edge * edge * edge;
                    }
            const double all = counted[part] + counted[softStock], room = 0.06 * all + 3.0;
            RC_ASSERT(std::abs(contact.volume - all) < room);
            for (const TouchedProperty& touched : contact.touched) {
                if (touched.property == airProperty) continue;
                RC_ASSERT(touched.isProtected == (touched.property == part));
                RC_ASSERT(std::abs(touched.volume - counted[touched.property]) < room);
            }
            if (counted[part] > 1.0) RC_ASSERT(contact.touchesProtected);
            if (counted[softStock] > 1.0) RC_ASSERT(contact.touchesStock);
            if (counted[part] == 0.0 && counted[softStock] == 0.0) RC_ASSERT(contact.volume < 3.0);
            touching += contact.touches ? 1 : 0;
        });
        QVERIFY(held);
        QVERIFY(touching > 20);
    }

    /// A tool that cuts its way through the stock: the check that remembers bricks never differs from one that looks at
    /// every scanline.
    void rememberedBricksChangeNothing() {
        int free = 0, touching = 0;
        const bool held = rc::check("a walk", [&] {
            RunVolume volume = workpiece(static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
            const RunAmounts before = volume.amounts();
            const VolumeSnapshot whole = volume.snapshot();
            const Cutter cutter = cutters::all()[static_cast<std::size_t>(*rc::gen::inRange(0, 9))].cutter;
            const std::vector<RevolvedPiece> tool = toolOf(cutter);
            const std::size_t flutes = flutePieces(cutter).size();
            ContactCheck check(volume.grid());
            ToolPose pose =
                leaning({real(-8.0, 8.0), real(-8.0, 8.0), real(-12.0, 2.0)}, real(0.0, 0.6), real(0.0, 6.28));
            for (int step = 0; step < 12; ++step) {
                const glm::dvec3 next = pose.tip + glm::dvec3(real(-2.0, 2.0), real(-2.0, 2.0), real(-1.5, 1.0));
                RunAmounts removed;
                sweep(volume, std::span(tool).first(flutes), {pose.tip, next, pose.axis}, removed);
                pose.tip = next;
                const ShankContact found = check.at(volume, tool, flutes, pose);
                RC_ASSERT(same(found, shankContact(volume, tool, flutes, pose)));
                RC_ASSERT(same(found, check.at(volume, tool, flutes, pose))); // what it has seen now changes nothing
                (found.touches ? touching : free) += 1;
            }
            volume.restore(whole); // undo: stock stands again where bricks were empty
            check.forget();
            RC_ASSERT(volume.amounts() == before);
            RC_ASSERT(same(check.at(volume, tool, flutes, pose), shankContact(volume, tool, flutes, pose)));
        });
        QVERIFY(held);
        QVERIFY2(free > 50 && touching > 50,
                 qPrintable(QStringLiteral("%1 free, %2 touching").arg(free).arg(touching)));
    }

    void flutesOfSeveralPiecesMayTouch() {
        const RunVolume volume = workpiece(RunAxis::z);
        const Cutter cutter = cutters::taperBall();
        const std::size_t flutes = flutePieces(cutter).size();
        QVERIFY(flutes > 1);
        const ToolPose deep{{0.0, 0.0, -0.95 * cutter.fluteLength}, {0.0, 0.0, 1.0}};
        QVERIFY(!shankContact(volume, pieces(cutter), flutes, deep).touches);
        const ShankContact contact =
            shankContact(volume, pieces(cutter), flutes, {{0.0, 0.0, -1.2 * cutter.fluteLength}, {0.0, 0.0, 1.0}});
        QVERIFY(contact.touches && contact.touchesStock && !contact.touchesProtected);
        QVERIFY(sectionOf(cutter, contact.piece) == ToolSection::shank);
    }

    void aPoseThatIsNotFiniteTouchesNothing() {
        const RunVolume volume = workpiece(RunAxis::z);
        const std::vector<RevolvedPiece> tool = toolOf(cutters::ball());
        QVERIFY(!shankContact(volume, tool, 1, {{std::nan(""), 0.0, 0.0}, {0.0, 0.0, 1.0}}).touches);
        QVERIFY(!shankContact(volume, tool, 1, {{0.0, 0.0, 0.0}, {0.0, 0.0, INFINITY}}).touches);
        QVERIFY(collisionArea(RunVolume(workpiece(RunAxis::z)).snapshot(), tool, 1, {{std::nan(""), 0.0, 0.0}, {}})
                    .empty());
    }

    /// Eq. 4 by brute force: surface voxels of the shank that are surface voxels of the workpiece.
    void collisionAreaIsTheIntersectionOfTheSurfaces() {
        for (const RunAxis runs : {RunAxis::z, RunAxis::x}) {
            RunVolume volume = solid({-10.0, -10.0, -10.0}, 0.5, {40, 40, 24}, runs); // up to z = 2
            const Cutter cutter = cutters::make(CutterType::ball, 6.0, 3.0, 5.0);
            const std::vector<RevolvedPiece> tool = pieces(cutter);
            const ToolPose pose = leaning({1.0, -0.5, -7.0}, 0.2, 1.0);
            RunAmounts removed;
            sweep(volume, std::span(tool).first(1), {pose.tip, pose.tip, pose.axis}, removed);
            const Grid& grid = volume.grid();
            const auto inTool = [&](int i, int j, int k) {
                return guardedHolds(tool, 1, pose, grid.low() + (glm::dvec3(i, j, k) + 0.5) * grid.edge());
            };
            const auto inStock = [&](int i, int j, int k) {
                return grid.contains(VoxelIndex{i, j, k}) && volume.belongs({i, j, k});
            };
            const auto onSurface = [](const auto& holds, int i, int j, int k) {
                if (!holds(i, j, k)) return false;
                for (int a = -1; a <= 1; ++a)
                    for (int b = -1; b <= 1; ++b)
                        for (int c = -1; c <= 1; ++c)
                            if (!holds(i + a, j + b, k + c)) return true;
                return false;
            };
            std::set<std::tuple<int, int, int>> wanted;
            for (int i = 0; i < 40; ++i)
                for (int j = 0; j < 40; ++j)
                    for (int k = 0; k < 24; ++k)
                        if (onSurface(inTool, i, j, k) && onSurface(inStock, i, j, k)) wanted.insert({i, j, k});
            std::set<std::tuple<int, int, int>> found;
            for (const VoxelIndex voxel : collisionArea(volume.snapshot(), tool, 1, pose)) found.insert(key(voxel));
            QVERIFY(wanted.size() > 20);
            QVERIFY(found == wanted);
        }
    }
};

QTEST_APPLESS_MAIN(ContactTest)
#include "tst_contact.moc"
