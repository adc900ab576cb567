// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/core/geometry/shapes.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

namespace burin::tst_part_update {

/// A part that was changed in the CAD system is updated from the command line.
class PartUpdateTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString in(const QString& name) const { return folder_.filePath(name); }
    void write(const QByteArray& content) const {
        QFile file(in("part.stl"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    QByteArray project() const {
        QFile file(in("p.burin"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private slots:
    void whatWasMilledStays() {
        write(testing::stlText(shapes::box(glm::dvec3(0.0), {40.0, 30.0, 10.0})));
        QCOMPARE(runBurin({"embed", in("part.stl"), "-o", in("p.burin"), "--voxel", "1", "--margin", "5"}).status, 0);
        QCOMPARE(runBurin({"mill", in("p.burin"), "--seconds", "4", "--tool", "ball-6"}).status, 0);
        const QJsonObject before = runBurin({"setup", in("p.burin"), "--json"}).json();
        write(testing::stlText(shapes::box(glm::dvec3(0.0), {40.0, 30.0, 8.0})));
        const ProgramRun update = runBurin({"setup", in("p.burin"), "--update-part", in("part.stl"), "--json"});
        QVERIFY2(update.status == 0, update.messages.constData());
        QVERIFY2(update.messages.contains("changed bodies: "), update.messages.constData());
        QVERIFY(update.messages.contains("stock and program zero stay"));
        QCOMPARE(update.json()["work_offset_mm"], before["work_offset_mm"]);
        const QJsonObject info = runBurin({"info", in("p.burin"), "--json"}).json();
        QVERIFY(std::abs(info["model"].toObject()["volume_mm3"].toDouble() - 9600.0) < 1e-6);
        QCOMPARE(info["takes"].toArray().size(), 1);
        // The recording is used for a checked program of the new part.
        QCOMPARE(runBurin({"path", in("p.burin"), "new"}).status, 0);
        const ProgramRun post = runBurin({"post", in("p.burin"), "-o", in("p.ngc")});
        QVERIFY2(post.status == 0, post.messages.constData());
    }

    void nothingChangesWhereItCanNot() {
        const QByteArray before = project();
        for (const QString& part : {in("none.stl"), in("p.ngc"), in("p.burin")}) {
            const ProgramRun run = runBurin({"setup", in("p.burin"), "--update-part", part});
            QVERIFY2(run.status == 3 || run.status == 2, run.messages.constData());
            QCOMPARE(run.messages.count('\n'), 1);
            QVERIFY(project() == before);
        }
        const ProgramRun same = runBurin({"setup", in("p.burin"), "--update-part", in("part.stl")});
        QVERIFY2(same.messages.contains("the part has not changed"), same.messages.constData());
    }
};

BURIN_TEST(PartUpdateTest, QCoreApplication)

} // namespace burin::tst_part_update

#include "tst_part_update.moc"
