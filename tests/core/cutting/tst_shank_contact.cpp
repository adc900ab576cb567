// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/removal.h"
#include "tests/core/cutting/workpieces.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_shank_contact {

using namespace burin::tests;

namespace {

/// Ball of 6 with 8 mm of flutes, a shank of 6, and a holder of 20 at 20 mm above the tip.
std::vector<RevolvedPiece> tool() {
    Cutter cutter = ball(6.0, 8.0);
    cutter.shankDiameter = 6.0;
    cutter.stickOut = 20.0;
    cutter.holder = {{20.0, 20.0, 10.0}, {20.0, 30.0, 10.0}};
    return pieces(cutter);
}

/// A block with a through shaft of 10 × 10 mm about the origin.
RunVolume shaft(const Grid& grid) {
    RunVolume volume = block(grid);
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
            const glm::dvec2 centre = grid.lineCentre(line);
            if (std::abs(centre.x) < 5.0 && std::abs(centre.y) < 5.0)
                (void)volume.fillSpan(line, 0, grid.lineEnd(), airProperty);
        }
    return volume;
}

const Grid& workGrid() {
    static const Grid grid = tests::grid({-20.0, -20.0, -30.0}, 0.25, {160, 160, 120});
    return grid;
}

} // namespace

class ShankContactTest : public QObject {
    Q_OBJECT

private slots:
    void aFreeToolTouchesNothing() {
        const RunVolume workpiece = shaft(workGrid());
        QVERIFY(!shankContact(workpiece, tool(), {0.0, 0.0, -18.0}).touches);
        QVERIFY(!shankContact(workpiece, tool(), {0.0, 0.0, 5.0}).touches);
        QVERIFY(!shankContact(workpiece, tool(), {500.0, 0.0, -18.0}).touches);
    }

    /// Flutes inside solid material are cutting, not colliding.
    void flutesMayTouch() {
        const RunVolume workpiece = block(workGrid());
        QVERIFY(!shankContact(workpiece, tool(), {0.0, 0.0, -7.9}).touches);
    }

    /// The shank's whole cross-section 2 mm deep in the block.
    void theShankTouchesWhenTheToolGoesDeeperThanItsFlutes() {
        const RunVolume workpiece = block(workGrid());
        const ShankContact contact = shankContact(workpiece, tool(), {0.3, -0.2, -10.0});
        QVERIFY(contact.touches);
        QCOMPARE(int(contact.piece), 1);
        QCOMPARE(int(contact.property), int(softStock));
        QVERIFY(std::abs(contact.volume / (pi * 9.0 * 2.0) - 1.0) < 0.02);
        QVERIFY(glm::length(contact.place - glm::dvec3(0.3, -0.2, -1.0)) < 0.05);
    }

    void theHolderTouchesTheRim() {
        const RunVolume workpiece = shaft(workGrid());
        const ShankContact contact = shankContact(workpiece, tool(), {0.0, 0.0, -21.0}); // holder 1 mm below the rim
        QVERIFY(contact.touches);
        QCOMPARE(int(contact.piece), 2);
        QVERIFY(std::abs(contact.volume / (pi * 100.0 - 100.0) - 1.0) < 0.02);
        QVERIFY(std::abs(contact.place.z + 0.5) < 1e-6);
        QVERIFY(std::abs(contact.place.x) < 1e-6 && std::abs(contact.place.y) < 1e-6);
    }

    void aQuarterOfAVoxelCountsAsTouchingAir() {
        const RunVolume workpiece = shaft(workGrid());
        QVERIFY(!shankContact(workpiece, tool(), {0.0, 0.0, -20.0 - 0.25 * 0.25}).touches);
        QVERIFY(shankContact(workpiece, tool(), {0.0, 0.0, -20.0 - 0.27 * 0.25}).touches);
    }

    /// A holder drawn in many short steps equals the holder drawn in one: the tolerance applies to the whole stack. All
    /// pieces have numbers, however many there are.
    void shortStepsOfAHolderTouchAsOneDoes() {
        const RunVolume workpiece = shaft(workGrid());
        const glm::dvec3 tip(0.0, 0.0, -21.0); // holder 1 mm below the rim
        const ShankContact whole = shankContact(workpiece, tool(), tip);
        for (const int steps : {10, 200, 400}) {
            std::vector<RevolvedPiece> stepped = tool();
            const RevolvedPiece holder = stepped[2];
            stepped.erase(stepped.begin() + 2);
            for (int i = steps; i-- > 0;) {
                RevolvedPiece step = holder;
                step.bottom = holder.bottom + (holder.top - holder.bottom) * i / steps;
                step.top = holder.bottom + (holder.top - holder.bottom) * (i + 1) / steps;
                stepped.insert(stepped.begin() + 2, step);
            }
            const ShankContact contact = shankContact(workpiece, stepped, tip);
            QVERIFY(contact.touches);
            QVERIFY(std::abs(contact.volume / whole.volume - 1.0) < 0.02); // ends are rounded at each step
            QVERIFY(glm::length(contact.place - whole.place) < 0.02);
            QVERIFY(contact.piece >= 2 && contact.piece < stepped.size());
            QVERIFY(stepped[contact.piece].bottom < holder.bottom + 1.0); // a piece below the rim
        }
        std::vector<RevolvedPiece> many = tool();
        while (many.size() < 300) many.insert(many.begin() + 1, RevolvedPiece{8.0, 8.001, 3.0, 3.0, 0.0});
        const ShankContact contact = shankContact(workpiece, many, tip);
        QVERIFY(contact.touches);
        QCOMPARE(many[contact.piece].bottom, 20.0); // the holder, not the piece of its number truncated to eight bits
    }

    /// Cuts with pending writes count as removed: a shank that follows its flutes down touches nothing.
    void whatIsOwedIsNotTouched() {
        RunVolume workpiece = block(workGrid());
        Cutter cutter = ball(6.0, 8.0);
        cutter.shankDiameter = 5.0;
        cutter.stickOut = 40.0;
        MaterialRemoval removal(cutter, workGrid(), Writing::deferred);
        const std::vector<RevolvedPiece> all = pieces(cutter);
        const std::size_t flutes = flutePieces(cutter).size();
        ContactCheck check(workGrid());
        glm::dvec3 tip(0.1, 0.2, 1.0);
        int shown = 0;
        for (int tick = 0; tick < 45; ++tick) {
            const glm::dvec3 next = tip - glm::dvec3(0.0, 0.0, 0.6);
            (void)removal.cut(workpiece, tip, next);
            tip = next;
            const ToolPose pose{tip, {0.0, 0.0, 1.0}};
            QVERIFY(!check.at(workpiece, all, flutes, pose, removal.window()).touches);
            shown += ContactCheck(workGrid()).at(workpiece, all, flutes, pose).touches ? 1 : 0;
        }
        QVERIFY(shown > 0); // in the volume as it is, it touched something
    }

    /// The part can be touched like stock; the piece with the largest contact is named.
    void namesWhatIsTouchedMost() {
        RunVolume workpiece = shaft(workGrid());
        const Grid& grid = workGrid();
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
                if (grid.lineCentre(line).x > 5.0) (void)workpiece.fillSpan(line, 0, grid.lineEnd(), part);
        const ShankContact contact = shankContact(workpiece, tool(), {3.0, 0.0, -18.0}); // shank 1 mm into the wall
        QVERIFY(contact.touches);
        QCOMPARE(int(contact.property), int(part));
        QCOMPARE(int(contact.piece), 1);
        QVERIFY(contact.place.x > 5.0 && contact.place.x < 6.0);
    }

    /// A volume may contain fixtures as materials of their own: contacts with each are distinguished from stock and
    /// part.
    void stockPartAndFixtureAreToldApart() {
        PropertyList properties = materials();
        const PropertyIndex fixture = properties.add(material("fixture", 1.0, 0.4, Machinability::isProtected)).value();
        const Grid& grid = workGrid();
        RunVolume workpiece = RunVolume::make(grid, properties).value();
        // Stock on one side of a shaft, part and fixture on the other; their tops are at -1, the fixture's at -0.5 mm.
        const auto heightOf = [&](double top) { return grid.toRunPosition(top); };
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                const glm::dvec2 centre = grid.lineCentre(line);
                if (std::abs(centre.x) < 5.0 && std::abs(centre.y) < 5.0) continue;
                const PropertyIndex property = centre.x < 0.0 ? softStock : centre.y > 0.0 ? part : fixture;
                QVERIFY(workpiece.fillSpan(line, 0, heightOf(property == fixture ? -0.5 : -1.0), property));
            }
        const glm::dvec3 tip(0.0, 0.0, -22.0); // the holder's end face, a disc of radius 10, at -2
        const double quarter = 0.25 * (pi * 100.0 - 100.0);
        const auto touched = [&](const ShankContact& contact, PropertyIndex property) {
            for (const TouchedProperty& entry : contact.touched)
                if (entry.property == property) return entry;
            return TouchedProperty{};
        };
        const ShankContact contact = shankContact(workpiece, tool(), tip);
        QVERIFY(contact.touches && contact.touchesStock && contact.touchesProtected);
        QCOMPARE(int(contact.property), int(softStock));
        QVERIFY(std::abs(touched(contact, softStock).volume / (2.0 * quarter) - 1.0) < 0.02);
        QVERIFY(std::abs(touched(contact, fixture).volume / (1.5 * quarter) - 1.0) < 0.02);
        QVERIFY(std::abs(touched(contact, part).volume / quarter - 1.0) < 0.02);
        QVERIFY(!touched(contact, softStock).isProtected);
        QVERIFY(touched(contact, fixture).isProtected && touched(contact, part).isProtected);
        QCOMPARE(int(touched(contact, hardStock).property), int(airProperty));
        // Above stock and part only the fixture, and above that nothing.
        const ShankContact above = shankContact(workpiece, tool(), tip + glm::dvec3(0.0, 0.0, 1.25));
        QVERIFY(above.touches && !above.touchesStock && above.touchesProtected);
        QCOMPARE(int(above.property), int(fixture));
        QVERIFY(std::abs(above.volume / (0.25 * quarter) - 1.0) < 0.02);
        QVERIFY(!shankContact(workpiece, tool(), tip + glm::dvec3(0.0, 0.0, 1.51)).touches);
    }

    /// A cone touches where it is wide enough: dense sampling of its overlap gives the same volume.
    void aConicalHolderIsMetExactly() {
        const RunVolume workpiece = shaft(workGrid());
        const glm::dvec3 tip(0.0, 0.0, -38.0); // cone from r 10 at -8 to r 15 at 2: both holder pieces in
        const ShankContact contact = shankContact(workpiece, tool(), tip);
        const Grid& grid = workGrid();
        double expected = 0.0;
        for (int i = 0; i < 160; ++i)
            for (int j = 0; j < 160; ++j) {
                const glm::dvec2 centre = grid.lineCentre({i, j});
                if (std::abs(centre.x) < 5.0 && std::abs(centre.y) < 5.0) continue;
                const double r = std::hypot(centre.x, centre.y);
                for (double z = -18.0 + 0.005; z < 0.0; z += 0.01)
                    if (r < (z < -8.0 ? 10.0 : 10.0 + 0.5 * (z + 8.0))) expected += 0.01 * 0.25 * 0.25;
            }
        QVERIFY2(std::abs(contact.volume / expected - 1.0) < 1e-3,
                 qPrintable(QString::number(contact.volume / expected)));
    }
};

BURIN_TEST(ShankContactTest, NoApplication)

} // namespace burin::tst_shank_contact

#include "tst_shank_contact.moc"
