// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/face_alignment.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_face_alignment {

namespace {

glm::dvec3 someDirection() {
    const auto number = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
    const glm::dvec3 direction(number(), number(), number());
    return glm::length(direction) > 0.01 ? glm::normalize(direction) : glm::dvec3(0.0, 0.0, -1.0);
}

} // namespace

class TestFaceAlignment : public QObject {
    Q_OBJECT

private slots:
    void aPlaneLooksWhereItIsAsked() {
        QVERIFY(rc::check("planes", [] {
            const PartFace face{PartFace::Kind::plane, {1.0, 2.0, 3.0}, someDirection()};
            const glm::dvec3 wanted = someDirection(), middle(7.0, -8.0, 9.0);
            const Result<Placement> turn = alignedFace(face, wanted, middle);
            RC_ASSERT(turn.hasValue());
            RC_ASSERT(glm::distance(turn->direction(face.direction), wanted) < 1e-9);
            RC_ASSERT(glm::distance(turn->point(middle), middle) < 1e-9);
        }));
    }

    /// An axis has two ends: it is aligned with the direction by the smaller of the two rotations.
    void anAxisLiesAlongItByTheShorterTurn() {
        QVERIFY(rc::check("axes", [] {
            const PartFace face{PartFace::Kind::round, {}, someDirection()};
            const glm::dvec3 wanted = someDirection();
            const Result<Placement> turn = alignedFace(face, wanted, {});
            RC_ASSERT(turn.hasValue());
            const double along = glm::dot(turn->direction(face.direction), wanted);
            RC_ASSERT(std::abs(std::abs(along) - 1.0) < 1e-9);
            RC_ASSERT(glm::dot(turn->direction(face.direction), face.direction) > -1e-9); // a quarter turn at most
        }));
    }

    void aCurvedFaceHasNoDirection() {
        QCOMPARE(alignedFace({PartFace::Kind::other, {}, {0.0, 0.0, 1.0}}, {0.0, 0.0, -1.0}, {}).error().code,
                 ErrorCode::argumentInvalid);
    }
};

BURIN_TEST(TestFaceAlignment, NoApplication)

} // namespace burin::tst_face_alignment

#include "tst_face_alignment.moc"
