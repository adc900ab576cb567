// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/setup.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_program_zero {

namespace {

/// A box of 40 x 30 x 20 mm at 10, 20, 30, as a model of one body.
Model block() {
    Model model;
    Body body;
    body.name = "block";
    for (int corner = 0; corner < 8; ++corner)
        body.mesh.vertices.emplace_back(10.0 + (corner & 1 ? 40.0 : 0.0), 20.0 + (corner & 2 ? 30.0 : 0.0),
                                        30.0 + (corner & 4 ? 20.0 : 0.0));
    body.box = {{10.0, 20.0, 30.0}, {50.0, 50.0, 50.0}};
    model.bodies.push_back(std::move(body));
    return model;
}

/// With 1 mm of stock below it along each axis and 2 mm above.
Result<Setup> placed(const ProgramZero& zero, BodyRole role = BodyRole::part) {
    Setup setup;
    setup.voxel = 1.0;
    setup.marginLow = glm::dvec3(1.0);
    setup.marginHigh = glm::dvec3(2.0);
    setup.roles = {role};
    setup.freeCarving = role != BodyRole::part;
    setup.zero = zero;
    return placeStock(block(), setup);
}

ProgramZero on(ZeroReference reference, BoxSide x, BoxSide y, BoxSide z) {
    return {54, reference, {x, y, z}, {}};
}

} // namespace

class TestProgramZero : public QObject {
    Q_OBJECT
private slots:
    void itStandsOnTheMiddleOfTheStocksTopUnlessAsked() {
        QCOMPARE(placed({})->workOffset, glm::dvec3(30.5, 35.5, 52.0));
    }

    void everyPlaceOfABoxIsOne() {
        for (const bool part : {false, true}) {
            const glm::dvec3 low = part ? glm::dvec3(10.0, 20.0, 30.0) : glm::dvec3(9.0, 19.0, 29.0),
                             high = part ? glm::dvec3(50.0, 50.0, 50.0) : glm::dvec3(52.0, 52.0, 52.0);
            const auto wanted = [&](BoxSide side, int axis) {
                return side == BoxSide::low    ? low[axis]
                       : side == BoxSide::high ? high[axis]
                                               : 0.5 * (low[axis] + high[axis]);
            };
            for (const BoxSide x : boxSides)
                for (const BoxSide y : boxSides)
                    for (const BoxSide z : boxSides) {
                        const auto setup = placed(on(part ? ZeroReference::part : ZeroReference::stock, x, y, z));
                        QVERIFY(setup);
                        QCOMPARE(setup->workOffset, glm::dvec3(wanted(x, 0), wanted(y, 1), wanted(z, 2)));
                    }
        }
    }

    void aPointStaysWhereItIsStated() {
        QCOMPARE(placed({55, ZeroReference::point, {}, {1.0, -2.0, 3.5}})->workOffset, glm::dvec3(1.0, -2.0, 3.5));
        const double none = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(placed({54, ZeroReference::point, {}, {0.0, none, 0.0}}).error().code, ErrorCode::stockInvalid);
    }

    /// A picked vertex belongs to the part and moves with it. A point on a box is determined again on the new one.
    void aPointGoesWithThePart() {
        const Placement turn = turnedAbout({0.0, 0.0, 1.0}, 0.5 * M_PI, {0.0, 0.0, 0.0});
        const ProgramZero point{59, ZeroReference::point, {}, {10.0, 20.0, 30.0}};
        QVERIFY(glm::distance(moved(point, turn).point, {-20.0, 10.0, 30.0}) < 1e-12);
        QCOMPARE(moved(point, turn).workOffset, 59);
        const ProgramZero corner = on(ZeroReference::part, BoxSide::low, BoxSide::high, BoxSide::low);
        QVERIFY(moved(corner, turn) == corner);
    }

    void thereIsNoPlaceOnAPartWhereThereIsNone() {
        const auto carved = placed(on(ZeroReference::part, BoxSide::low, BoxSide::low, BoxSide::low), BodyRole::insert);
        QCOMPARE(carved.error().code, ErrorCode::stockInvalid);
    }
};

BURIN_TEST(TestProgramZero, NoApplication)

} // namespace burin::tst_program_zero

#include "tst_program_zero.moc"
