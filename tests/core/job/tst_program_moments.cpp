// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_moments.h"
#include "core/machine/machine_library.h"
#include "core/nc/dialect_library.h"
#include "core/nc/parser.h"
#include "core/nc/post.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QCoreApplication>
#include <QtTest>

#include <cmath>

namespace burin::tst_program_moments {

namespace {

const glm::dvec3 zero(12.5, -3.25, 40.0); // mm, program zero in the setup frame

/// A path with winding cuts, alternately of takes and of generated moves, with arcs among them, and links of neither.
Path wanderingPath() {
    Path path;
    path.name = "wandering";
    path.spindleSpeed = 10000.0;
    glm::dvec3 at = zero + glm::dvec3(0.0, 0.0, 5.0);
    path.points.push_back({{at}, MoveKind::rapid, 0.0, 0, -1});
    const int strokes = *rc::gen::inRange(1, 4);
    for (int stroke = 0; stroke < strokes; ++stroke) {
        at.z = zero.z - 1.0;
        path.points.push_back({{at}, MoveKind::plunge, 300.0, 0, -1});
        const int count = *rc::gen::inRange(2, 60);
        for (int i = 0; i < count; ++i) {
            const auto step = [] { return *rc::gen::inRange(-400, 400) / 100.0; };
            PathPoint point{{at + glm::dvec3(step(), step(), 0.01 * step())},
                            MoveKind::cut,
                            1200.0,
                            stroke % 2 == 0 ? stroke + 1 : -stroke,
                            7 * i};
            const glm::dvec2 chord(point.pose.tip - at);
            if (i % 5 == 4 && glm::length(chord) > 0.5) { // a half circle
                point.pose.tip.z = at.z;
                point.arc = PathArc{0.5 * (at + point.pose.tip), 2, i % 2 == 0};
            }
            at = point.pose.tip;
            path.points.push_back(point);
        }
        at.z = zero.z + 5.0;
        path.points.push_back({{at}, MoveKind::retract, 1200.0, 0, -1});
        at += glm::dvec3(3.0, 0.0, 0.0);
        path.points.push_back({{at}, MoveKind::rapid, 0.0, 0, -1});
    }
    return path;
}

Result<ParsedProgram> postedAndRead(const Path& path, const std::string& dialect) {
    const Result<MachineProfile> machine = loadMachine("linuxcnc-mill");
    if (!machine) return machine.error();
    PostRequest request;
    request.programName = path.name;
    request.workOffset = zero;
    request.safeHeight = 20.0;
    const Result<NcProgram> program = toProgram({path}, request, *machine);
    if (!program) return program.error();
    const auto post = loadDialect(dialect);
    if (!post) return post.error();
    Progress progress;
    const Result<std::string> text = writeProgram(*program, *machine, **post, progress);
    if (!text) return text.error();
    return parseProgram(*text, "test", controlOfDialect(dialect));
}

} // namespace

class TestProgramMoments : public QObject {
    Q_OBJECT
private slots:
    void everyBlockLeadsToItsMoment_data();
    void everyBlockLeadsToItsMoment();
};

void TestProgramMoments::everyBlockLeadsToItsMoment_data() {
    QTest::addColumn<QString>("dialect");
    QTest::newRow("arcs whole") << "linuxcnc";
    QTest::newRow("another control") << "grbl";
}

void TestProgramMoments::everyBlockLeadsToItsMoment() {
    QFETCH(QString, dialect);
    QVERIFY(rc::check("the move of a moment ends where the hand, or the planner, was", [&] {
        const Path path = wanderingPath();
        const Result<ParsedProgram> program = postedAndRead(path, dialect.toStdString());
        RC_ASSERT(program.hasValue());
        const std::vector<Moment> moments = momentsOf(*program, path, ThreeAxes(zero));
        RC_ASSERT(moments.size() == program->motions.size());
        std::size_t ofSources = 0;
        for (const PathPoint& point : path.points) {
            if (point.sample < 0) continue;
            ++ofSources;
            // The last motion of this moment ends at the point; none of them belongs to another one.
            bool reached = false;
            for (std::size_t i = 0; i < moments.size(); ++i)
                if (moments[i] == Moment{point.source, point.sample})
                    reached = glm::distance(program->motions[i].to.linear() + zero, point.pose.tip) <= 0.002;
            RC_ASSERT(reached);
        }
        RC_ASSERT(ofSources > 0);
        for (std::size_t i = 0; i < moments.size(); ++i)
            if (program->motions[i].rapid()) RC_ASSERT(moments[i].source == 0);
    }));
}

BURIN_TEST(TestProgramMoments, QCoreApplication)

} // namespace burin::tst_program_moments

#include "tst_program_moments.moc"
