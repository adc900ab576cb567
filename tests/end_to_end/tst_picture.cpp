// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

/// The picture that a demo leaves, drawn without a display.
class PictureTest : public QObject {
    Q_OBJECT
private slots:
    void showsPartStockAndTool();
};

void PictureTest::showsPartStockAndTool() {
    QTemporaryDir folder;
    const ProgramRun run = runBurin({"demo", "--voxel", "1", "--tool", "ball-10", "--json", "--output", folder.path()});
    QVERIFY2(run.status == 0, run.messages.constData());
    const QImage picture(run.json()["picture"].toString());
    QVERIFY(picture.width() >= 1280 && picture.height() >= 800);
    // Bare part is blue, the stock is pale, the background dark: each fills a good share of the picture.
    int blue = 0, pale = 0, dark = 0;
    for (int y = 0; y < picture.height(); y += 4)
        for (int x = 0; x < picture.width(); x += 4) {
            const QColor colour = picture.pixelColor(x, y);
            if (colour.blue() > colour.red() + 40 && colour.blue() > 70)
                ++blue;
            else if (colour.lightness() > 110)
                ++pale;
            else if (colour.lightness() < 70)
                ++dark;
        }
    const int all = (picture.width() / 4) * (picture.height() / 4);
    QVERIFY2(blue > all / 40, qPrintable(QString::number(blue)));
    QVERIFY2(pale > all / 60, qPrintable(QString::number(pale)));
    QVERIFY2(dark > all / 5, qPrintable(QString::number(dark)));
}

QTEST_GUILESS_MAIN(PictureTest)
#include "tst_picture.moc"
