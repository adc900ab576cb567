// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <set>

namespace burin::tst_sheet {

/// The setup sheet from the command line. Oracles: the arguments with which the project was made, and the program's own
/// text.
class SheetTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", in("p.burin"), "--voxel", "0.5",
                           "--margin", "4", "--zero", "stock:low,low,high", "--work-offset", "G56", "--keep-out",
                           "20,0,-20,30,5,-10", "--material", "machinable-wax"})
                     .status,
                 0);
    }

    /// Without a program the sheet says so and shows what there is.
    void aSheetWithoutAProgramSaysSo() {
        const QString page = sheet({});
        QVERIFY(page.contains("There is no checked program"));
        QVERIFY(page.contains("G56"));
    }

    void itTellsWhatStandsInTheProject() {
        QCOMPARE(runBurin({"mill", in("p.burin"), "--intent", "scribble", "--seconds", "2"}).status, 0);
        QCOMPARE(runBurin({"path", in("p.burin"), "new"}).status, 0);
        QCOMPARE(runBurin({"setup", in("p.burin"), "--name", "Front & <left>"}).status, 0);
        QCOMPARE(runBurin({"post", in("p.burin"), "-o", in("cube.ngc")}).status, 0);
        const QString page = sheet({});
        QVERIFY(!page.contains("There is no checked program") && !page.contains("has changed since"));
        // A name is plain text, whatever it contains.
        QVERIFY(page.contains("Front &amp; &lt;left&gt;") && !page.contains("<left>"));
        // 10 mm, and 4 mm of stock on each side; zero is at the left front corner of the top of the stock.
        const QStringList cells = cellsOf(page);
        QVERIFY2(cells.contains("18 × 18 × 18 mm"), qPrintable(cells.join(" | ")));
        QVERIFY(cells.contains("0.000 mm, 0.000 mm, 18.000 mm"));
        QVERIFY(cells.contains("18.000 mm, 18.000 mm, 0.000 mm"));
        QVERIFY(cells.contains("X 0.000  Y 0.000  Z -18.000 mm"));
        // The keep-out volume relative to program zero: the stock begins at -4, -4, and its top is at 14.
        QVERIFY2(cells.contains("X 24.000  Y 4.000  Z -34.000 mm"), qPrintable(cells.join(" | ")));
        QVERIFY(cells.contains("passed") && cells.contains("cube.ngc") && cells.contains("G56"));
        // Speeds and the lowest position are those of the text.
        const QString program = contentOf(in("cube.ngc"));
        const QString speed = QRegularExpression("\\bS(\\d+)").match(program).captured(1);
        QVERIFY2(cells.contains(speed) || page.contains(speed + " –") || page.contains("– " + speed),
                 qPrintable(speed));
    }

    void itNeedsNoOtherFileAndItsPicturesShowSomething() {
        const QString page = sheet({});
        QVERIFY(!page.contains("http") && !page.contains("file:"));
        const QRegularExpression picture("src=\"data:image/png;base64,([^\"]+)\"");
        int pictures = 0;
        for (auto each = picture.globalMatch(page); each.hasNext(); ++pictures) {
            const QImage image = QImage::fromData(QByteArray::fromBase64(each.next().captured(1).toLatin1()), "PNG");
            QCOMPARE(image.size(), QSize(1120, 760));
            std::set<QRgb> colours;
            for (int y = 0; y < image.height(); y += 7)
                for (int x = 0; x < image.width(); x += 7) colours.insert(image.pixel(x, y));
            QVERIFY(colours.size() > 50);
        }
        QCOMPARE(pictures, 3);
        QCOMPARE(page.count("<svg class=\"tool\""), 1);
    }

    /// A machinist must not run a program of a job that was changed after the check.
    void aChangeBehindTheCheckIsTold() {
        QCOMPARE(runBurin({"setup", in("p.burin"), "--work-offset", "G57"}).status, 0);
        QVERIFY(sheet({}).contains("has changed since the program was checked"));
    }

    void itIsInInchesAndGermanWhereAsked() {
        QVERIFY(sheet({"--units", "inch"}).contains("0.7087"));
        const ProgramRun run = runBurin({"sheet", in("p.burin"), "-o", in("de.html")}, "de_DE.UTF-8");
        QCOMPARE(run.status, 0);
        QVERIFY(contentOf(in("de.html")).contains("Nullpunktverschiebung"));
    }

    void refusalsLeaveNothing() {
        const ProgramRun none = runBurin({"sheet", in("none.burin"), "-o", in("none.html")});
        QVERIFY(none.status != 0 && none.messages.count('\n') == 1);
        QVERIFY(!QFile::exists(in("none.html")));
        const ProgramRun folder = runBurin({"sheet", in("p.burin"), "-o", in("missing/a.html")});
        QVERIFY(folder.status != 0 && folder.messages.count('\n') == 1);
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }

    QString sheet(const QStringList& more) const {
        const ProgramRun run = runBurin(QStringList{"sheet", in("p.burin"), "-o", in("sheet.html")} + more);
        if (run.status != 0) qWarning("%s", run.messages.constData());
        return run.status == 0 ? contentOf(in("sheet.html")) : QString();
    }

    static QStringList cellsOf(const QString& page) {
        QStringList cells;
        static const QRegularExpression cell("<td>([^<]*)</td>");
        for (auto each = cell.globalMatch(page); each.hasNext();)
            cells << each.next().captured(1).replace(QChar::Nbsp, ' ');
        return cells;
    }

    QTemporaryDir folder_;
};

BURIN_TEST(SheetTest, QCoreApplication)

} // namespace burin::tst_sheet

#include "tst_sheet.moc"
