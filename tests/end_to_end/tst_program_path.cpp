// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>

namespace burin::tst_program_path_command {

/// A program of another system becomes a path, from the command line.
class ProgramPathTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const ProgramRun embedded =
            run({"embed", BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", "-o", in("p.burin"), "--voxel", "1"});
        QCOMPARE(embedded.status, 0);
        write("slot.nc", "%\nG21 G90 G17 G94 G54\nM3 S9000 M8\nG0 X-60 Y0\nZ5\nG1 Z-2 F150\nX-40 F480\n"
                         "G2 X-30 Y-10 I0 J-10 F360\nG4 P1\nG1 Y-60 F480\nG0 Z20\nM30\n%\n");
        write("slot.cls", "PARTNO SLOT\nUNITS/MM\nSPINDL/9000,RPM,CLW\nRAPID\nGOTO/-60,0,5\nFEDRAT/150,MMPM\n"
                          "GOTO/-60,0,-2\nFEDRAT/480,MMPM\nGOTO/-40,0,-2\nFINI\n");
    }

    void aProgramBecomesAPathAndComesOutAgain() {
        const ProgramRun made = run({"path", in("p.burin"), "import", in("slot.nc"), "--tool", "flat-6"});
        QVERIFY2(made.status == 0, made.messages.constData());
        const QJsonObject told = made.json();
        QCOMPARE(told["paths"].toArray().size(), 1);
        QCOMPARE(told["arcs_as_chords"].toInt(), 1);
        QCOMPARE(told["dwells_left_out"].toInt(), 1);
        QCOMPARE(told["paths"][0]["name"].toString(), QStringLiteral("slot.nc"));
        const double way = 7.0 + 20.0 + 5.0 * std::acos(-1.0) + 50.0;
        QVERIFY2(std::abs(told["length_mm"].toDouble() - way) < 0.02, made.output.constData());
        const ProgramRun post =
            run({"post", in("p.burin"), "-o", in("out.ngc"), "--override", "the slot is no part of the mouse"});
        QVERIFY2(post.status == 0, post.messages.constData());
        const QString text = read("out.ngc");
        // Feeds, speed, coolant and the arc are taken over from the program.
        for (const char* word : {"S9000", "M8", "F480", "F360"}) QVERIFY2(text.contains(word), word);
        QVERIFY2(text.contains(QRegularExpression("G2 X-30(\\.0+)? Y-10(\\.0+)?")), qPrintable(text));
    }

    /// The last line of the slot is cut slower and dry: speed and coolant change directly before it, nothing else
    /// changes.
    void aPartOfItGetsASpeedOfItsOwn() {
        QVERIFY(QFile::copy(in("p.burin"), in("s.burin")));
        QCOMPARE(run({"path", in("s.burin"), "show", "1", "-o", in("points.csv")}).status, 0);
        QList<QStringList> cuts;
        for (const QString& line : read("points.csv").split('\n'))
            if (line.startsWith("cut,")) cuts.append(line.split(','));
        QVERIFY(cuts.size() > 2);
        QCOMPARE(cuts.last().mid(12), QStringList({"9000", "flood"}));
        const auto apply = [&](double speed) {
            const QString edit = QStringLiteral(R"({"edit": "section", "stretch": {"take": %1, "first": %2, "last": %3},
                                                    "speed_rpm": %4, "coolant": "off"})")
                                     .arg(cuts.last()[5], cuts[cuts.size() - 2][6], cuts.last()[6])
                                     .arg(speed);
            const auto edits = run({"path", in("s.burin"), "list"}).json()["paths"][0]["edits"].toArray().size();
            return run({"path", in("s.burin"), "apply", "1", "--edit", edit, "--place", QString::number(edits)});
        };
        const ProgramRun applied = apply(7000.0);
        QVERIFY2(applied.status == 0, applied.messages.constData());
        QCOMPARE(run({"path", in("s.burin"), "show", "1", "-o", in("changed.csv")}).status, 0);
        QVERIFY2(read("changed.csv").contains(",7000,off\n"), qPrintable(read("changed.csv")));
        const ProgramRun post =
            run({"post", in("s.burin"), "-o", in("section.ngc"), "--override", "the slot is no part of the mouse"});
        QVERIFY2(post.status == 0, post.messages.constData());
        QString text = read("section.ngc");
        const qsizetype change = text.indexOf("\nS7000 M3\nM9\n");
        QVERIFY2(change > 0 && text.indexOf(QRegularExpression("(G1 )?Y-60")) > change, qPrintable(text));
        text.remove(change, QStringLiteral("\nS7000 M3\nM9").size());
        const auto blocks = [](const QString& all) { return all.mid(all.indexOf("\nG17")); }; // after the header
        QCOMPARE(blocks(text), blocks(read("out.ngc")));
        // A speed above the machine's limit is refused with a message.
        QCOMPARE(apply(900000.0).status, 0);
        const ProgramRun refused = run({"path", in("s.burin"), "show", "1"});
        QVERIFY(refused.status != 0 && refused.messages.contains("spindle speed"));
    }

    void cutterLocationsBecomeAPath() {
        const ProgramRun made =
            run({"path", in("p.burin"), "import", in("slot.cls"), "--tool", "flat-6", "--name", "from CAM"});
        QVERIFY2(made.status == 0, made.messages.constData());
        QCOMPARE(made.json()["paths"][0]["name"].toString(), QStringLiteral("from CAM"));
        QCOMPARE(made.json()["length_mm"].toDouble(), 27.0);
        // It is edited like any other path, but a pass that comes from a program cannot be recomputed.
        const QString id = QString::number(made.json()["paths"][0]["id"].toInt());
        QCOMPARE(run({"path", in("p.burin"), "recompute", id}).status, 2);
        const ProgramRun shown = run({"path", in("p.burin"), "show", id});
        QVERIFY2(shown.status == 0, shown.messages.constData());
    }

    void aPictureIsColouredByAQuantity() {
        QCOMPARE(run({"picture", in("p.burin"), "-o", in("plain.png"), "--path", "1", "--view", "top"}).status, 0);
        for (const char* quantity : {"feed", "force", "deviation"}) {
            const ProgramRun drawn = run({"picture", in("p.burin"), "-o", in("colours.png"), "--path", "1", "--view",
                                          "top", "--colour", quantity});
            QVERIFY2(drawn.status == 0, drawn.messages.constData());
            QVERIFY(QImage(in("colours.png")) != QImage(in("plain.png")));
        }
        QCOMPARE(run({"picture", in("p.burin"), "-o", in("no.png"), "--colour", "feed"}).status, 2);
    }

    void whatIsWrongIsSaidAndNothingIsKept() {
        const QByteArray before = bytes("p.burin");
        write("bad.cls", "FEDRAT/100\nGOTO/0,0,0\nCYCLE/DRILL,5\n");
        write("empty.nc", "");
        write("rapids.nc", "G21 G90\nG0 X1 Y1 Z5\nM2\n");
        write("tools.nc", "G21 G90 G94\nT41 M6\nS9000 M3\nG0 X1 Y1 Z5\nG1 Z1 F100\nT42 M6\nS9000 M3\nG0 X1 Y1 Z5\n"
                          "G1 Z1 F100\nM2\n");
        const auto refused = [&](const char* file, QStringList further, const char* text) {
            const ProgramRun made = run(QStringList{"path", in("p.burin"), "import", in(file)} + further);
            QVERIFY2(made.status != 0, file);
            QVERIFY2(made.messages.contains(text), made.messages.constData());
        };
        refused("bad.cls", {"--tool", "flat-6"}, "line 3");
        refused("empty.nc", {"--tool", "flat-6"}, "empty");
        refused("rapids.nc", {"--tool", "flat-6"}, "no move at feed");
        refused("tools.nc", {}, "T4");
        refused("missing.nc", {"--tool", "flat-6"}, "missing.nc");
        refused("slot.nc", {"--tool", "flat-99"}, "flat-99");
        QCOMPARE(bytes("p.burin"), before);
    }

private:
    QString in(const QString& name) const { return folder_.filePath(name); }
    static ProgramRun run(QStringList arguments) { return runBurin(arguments << "--json"); }
    void write(const QString& name, const QByteArray& text) const {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
    QByteArray bytes(const QString& name) const {
        QFile file(in(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QString read(const QString& name) const { return QString::fromUtf8(bytes(name)); }

    QTemporaryDir folder_;
};

BURIN_TEST(ProgramPathTest, QCoreApplication)

} // namespace burin::tst_program_path_command

#include "tst_program_path.moc"
