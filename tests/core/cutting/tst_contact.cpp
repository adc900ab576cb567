// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/contact.h"
#include "tests/core/cutting/common_surface.h"
#include "tests/core/cutting/sweeping.h"
#include "tests/core/tool/cutters.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <algorithm>
#include <optional>

namespace burin::tst_contact {

using namespace burin::tests;
using random::real;

namespace {

constexpr double edge = 0.25;
constexpr int partLayers = 40; // along z, from below

/// Stock with a part in its lower half, in a grid with any run axis.
RunVolume workpiece(RunAxis runs) {
    RunVolume volume = solid({-15.0, -15.0, -20.0}, edge, {120, 120, 80}, runs);
    const Grid& grid = volume.grid();
    LineIndex high{grid.lineCountU(), grid.lineCountV()};
    RunPosition end = grid.lineEnd();
    if (runs == RunAxis::z) end = partLayers * unitsPerVoxel;
    if (runs == RunAxis::x) high.v = partLayers;
    if (runs == RunAxis::y) high.u = partLayers;
    (void)volume.fillBlock({0, 0}, high, 0, end, part);
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

/// Shank and holder as in their drawing.
struct Frustum {
    double bottom, top, lower, upper; ///< mm: heights above the tip, radii

    /// Negative inside, and convex along any straight line: the largest of the distances from its three faces.
    double beyond(const ToolPose& pose, const glm::dvec3& place) const {
        const glm::dvec3 q = place - pose.tip;
        const double height = glm::dot(q, pose.axis), radius = glm::length(q - height * pose.axis);
        const double length = std::hypot(top - bottom, upper - lower);
        const double beside = ((radius - lower) * (top - bottom) - (height - bottom) * (upper - lower)) / length;
        return std::max({bottom - height, height - top, beside});
    }
};

std::vector<Frustum> guardedOf(const Cutter& cutter) {
    std::vector<Frustum> guarded;
    if (cutter.stickOut > cutter.fluteLength)
        guarded.push_back(
            {cutter.fluteLength, cutter.stickOut, 0.5 * cutter.shankDiameter, 0.5 * cutter.shankDiameter});
    double height = cutter.stickOut;
    for (const HolderSegment& segment : cutter.holder) {
        guarded.push_back({height, height + segment.length, 0.5 * segment.lowerDiameter, 0.5 * segment.upperDiameter});
        height += segment.length;
    }
    return guarded;
}

bool guardedHolds(const std::vector<Frustum>& guarded, const ToolPose& pose, const glm::dvec3& place) {
    return std::ranges::any_of(guarded, [&](const Frustum& piece) { return piece.beyond(pose, place) <= 0.0; });
}

/// The interval of a straight line that a frustum covers, in voxels along it, by search.
std::optional<Span> searched(const Frustum& piece, const ToolPose& pose, const glm::dvec3& start,
                             const glm::dvec3& step, double count) {
    const auto beyond = [&](double t) { return piece.beyond(pose, start + t * step); };
    double low = 0.0, high = count, inside = 0.5 * count;
    while (beyond(inside) >= 0.0) { // towards the deepest point; no distance has a slope above 1
        if (beyond(inside) > 0.5 * (high - low) * glm::length(step) || high - low < 1e-7) return std::nullopt;
        const double third = (high - low) / 3.0;
        if (beyond(low + third) < beyond(high - third))
            high -= third;
        else
            low += third;
        inside = 0.5 * (low + high);
    }
    const auto end = [&](double within, double outside) {
        if (beyond(outside) <= 0.0) return outside;
        while (std::abs(outside - within) > 1e-7)
            (beyond(0.5 * (within + outside)) <= 0.0 ? within : outside) = 0.5 * (within + outside);
        return within;
    };
    return Span{end(inside, 0.0), end(inside, count)};
}

/// The contact expected for `workpiece`, line by line, in run units: ends of intervals are rounded by Grid's single
/// rule. The uncertainty that the search leaves is the tolerance `room`.
struct SearchedContact {
    static constexpr double tolerance = 0.25 * unitsPerVoxel; ///< of a line, permitted overlap of a piece

    std::array<double, 4> units{};  ///< by property
    std::vector<double> byPiece;    ///< units
    double room = 0.0;              ///< units, uncertainty of any of these
    std::array<bool, 4> possible{}; ///< by property: touched, or perhaps touched
    glm::dvec3 moment{0.0};         ///< mm times units

    SearchedContact(const RunVolume& workpiece, const std::vector<Frustum>& guarded, const ToolPose& pose)
        : byPiece(guarded.size()) {
        const Grid& grid = workpiece.grid();
        for (std::size_t piece = 0; piece < guarded.size(); ++piece) {
            const Frustum& frustum = guarded[piece];
            const glm::dvec3 middle = pose.tip + 0.5 * (frustum.bottom + frustum.top) * pose.axis;
            const double reach =
                std::hypot(0.5 * (frustum.top - frustum.bottom), std::max(frustum.lower, frustum.upper));
            const glm::dvec2 centre(inLineFrame(grid, middle));
            for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
                for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                    if (glm::distance(grid.lineCentre(line), centre) < reach) addLine(grid, line, frustum, pose, piece);
        }
    }
    double all() const { return units[part] + units[softStock]; }

private:
    void addLine(const Grid& grid, LineIndex line, const Frustum& piece, const ToolPose& pose, std::size_t number) {
        const glm::dvec3 start = inSetupFrame(grid, {grid.lineCentre(line), grid.toMillimetres(0)});
        const glm::dvec3 step = inSetupFrame(grid, {0.0, 0.0, edge});
        const std::optional<Span> span = searched(piece, pose, start, step, grid.voxelsPerLine());
        if (!span) return;
        double open = 0.0; // ends whose rounding direction the search cannot determine
        const auto rounded = [&](double along) {
            const double exact = along * unitsPerVoxel, whole = std::floor(exact + 0.5);
            if (std::abs(exact + 0.5 - std::round(exact + 0.5)) < 1e-3) open += 1.0;
            return whole;
        };
        const double low = rounded(span->low), high = rounded(span->high);
        if (high - low + open <= tolerance) return;
        const bool counts = high - low - open > tolerance;
        room += counts ? open : high - low + open;
        // The part's border: a position on lines along z; all other lines are on one side of it.
        const bool withinPart = grid.axis() != RunAxis::z && grid.voxel(line, 0).k < partLayers;
        const double border = grid.axis() == RunAxis::z ? partLayers * unitsPerVoxel : withinPart ? grid.lineEnd() : 0;
        for (const PropertyIndex property : {part, softStock}) {
            const double from = property == part ? low : std::max(low, border);
            const double length = (property == part ? std::min(high, border) : high) - from;
            possible[property] = possible[property] || length + open > 0.0;
            if (length <= 0.0 || !counts) continue;
            units[property] += length;
            byPiece[number] += length;
            moment += length * (start + (from + 0.5 * length) / unitsPerVoxel * step);
        }
    }
};

ToolPose leaning(const glm::dvec3& tip, double lean, double turn) {
    return {tip, {std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean)}};
}

} // namespace

class ContactTest : public QObject {
    Q_OBJECT

private slots:
    /// Volume, centre, piece and properties of a contact are compared with a search along every scanline for shank and
    /// holder as drawn, for any axis of tool and runs, run unit by run unit: a tool without contact touches nothing,
    /// and no contact is missed.
    void agreesWithASearchAlongEveryLine() {
        int touching = 0, clear = 0, both = 0;
        const bool held = rc::check("every line", [&] {
            const RunVolume volume = workpiece(static_cast<RunAxis>(*rc::gen::inRange(0, 3)));
            const Cutter cutter = cutters::all()[static_cast<std::size_t>(*rc::gen::inRange(0, 9))].cutter;
            const std::size_t flutes = flutePieces(cutter).size();
            const glm::dvec3 tip(real(-10.0, 10.0), real(-10.0, 10.0), real(-30.0, 24.0));
            const ToolPose pose = leaning(tip, real(0.0, 1.5), real(0.0, 6.28));
            const ShankContact contact = shankContact(volume, toolOf(cutter), flutes, pose);
            const SearchedContact wanted(volume, guardedOf(cutter), pose);
            const double unit = volume.grid().unitVolume(), room = wanted.room * unit + 1e-9;
            RC_ASSERT(std::abs(contact.volume - wanted.all() * unit) <= room);
            RC_ASSERT(contact.touches == (contact.volume > 0.0));
            if (wanted.room == 0.0) RC_ASSERT(contact.touches == (wanted.all() > 0.0));
            std::array<double, 4> found{};
            for (std::size_t i = 0; i < contact.touched.size(); ++i) {
                const TouchedProperty& touched = contact.touched[i];
                if (touched.property == airProperty) continue;
                found.at(touched.property) = touched.volume;
                RC_ASSERT(touched.isProtected == (touched.property == part));
                if (i > 0) RC_ASSERT(touched.volume <= contact.touched[i - 1].volume);
            }
            for (const PropertyIndex property : {part, softStock}) {
                RC_ASSERT(std::abs(found[property] - wanted.units[property] * unit) <= room);
                const bool named = property == part ? contact.touchesProtected : contact.touchesStock;
                RC_ASSERT(named == (found[property] > 0.0));
                if (!wanted.possible[property]) RC_ASSERT(!named);
            }
            if (contact.touches && wanted.all() > 10.0 * wanted.room) {
                const double share = wanted.room / wanted.all(); // of the contact, whose distance may be up to 40 mm
                RC_ASSERT(glm::length(contact.place - wanted.moment / wanted.all()) <= 40.0 * share + 1e-6);
                const double most = *std::ranges::max_element(wanted.byPiece);
                RC_ASSERT(contact.piece >= flutes);
                RC_ASSERT(wanted.byPiece.at(contact.piece - flutes) >= most - 2.0 * wanted.room);
            }
            (contact.touches ? touching : clear) += 1;
            both += contact.touchesStock && contact.touchesProtected ? 1 : 0;
        });
        QVERIFY(held);
        QVERIFY2(touching > 20 && clear > 10 && both > 10,
                 qPrintable(QStringLiteral("%1, %2, %3").arg(touching).arg(clear).arg(both)));
    }

    /// While a tool cuts through the stock, the check that remembers bricks gives the same results as one that examines
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
                RC_ASSERT(same(found, check.at(volume, tool, flutes, pose))); // its memory changes nothing
                (found.touches ? touching : free) += 1;
            }
            volume.restore(whole); // undo: stock is back where bricks were empty
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

    /// Eq. 4 by brute force: surface voxels of shank and holder that are surface voxels of the workpiece, in order.
    void collisionAreaIsTheIntersectionOfTheSurfaces() {
        constexpr int side = 24;
        int touching = 0;
        const bool held = rc::check("collision area", [&] {
            const auto runs = static_cast<RunAxis>(*rc::gen::inRange(0, 3));
            RunVolume volume = solid({-6.0, -6.0, -6.0}, 0.5, {side, side, side}, runs);
            const Cutter cutter = cutters::all()[static_cast<std::size_t>(*rc::gen::inRange(0, 9))].cutter;
            const std::vector<RevolvedPiece> tool = toolOf(cutter);
            const std::size_t flutes = flutePieces(cutter).size();
            const ToolPose pose =
                leaning({real(-4.0, 4.0), real(-4.0, 4.0), real(-20.0, -4.0)}, real(0.0, 1.5), real(0.0, 6.28));
            RunAmounts removed;
            sweep(volume, std::span(tool).first(flutes), {pose.tip, pose.tip, pose.axis}, removed);
            const Grid& grid = volume.grid();
            const std::vector<Frustum> guarded = guardedOf(cutter);
            std::array<std::array<std::array<bool, side + 2>, side + 2>, side + 2> tools{}; // plus one voxel around
            for (int i = -1; i <= side; ++i)
                for (int j = -1; j <= side; ++j)
                    for (int k = -1; k <= side; ++k)
                        tools.at(std::size_t(i + 1)).at(std::size_t(j + 1)).at(std::size_t(k + 1)) =
                            guardedHolds(guarded, pose, grid.low() + (glm::dvec3(i, j, k) + 0.5) * grid.edge());
            const auto inTool = [&](int i, int j, int k) {
                return tools.at(std::size_t(i + 1)).at(std::size_t(j + 1)).at(std::size_t(k + 1));
            };
            const std::vector<VoxelIndex> wanted = commonSurface(volume, inTool);
            RC_ASSERT(collisionArea(volume.snapshot(), tool, flutes, pose) == wanted);
            touching += wanted.size() > 20 ? 1 : 0;
        });
        QVERIFY(held);
        QVERIFY2(touching > 30, qPrintable(QString::number(touching)));
    }
};

BURIN_TEST(ContactTest, NoApplication)

} // namespace burin::tst_contact

#include "tst_contact.moc"
