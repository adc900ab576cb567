// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/places.h"
#include "tests/test_program.h"
#include "ui/theme/colour.h"
#include "ui/theme/icon.h"
#include "ui/theme/length_unit.h"
#include "ui/theme/number_font.h"
#include "ui/theme/style_sheet.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFontMetricsF>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QVBoxLayout>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace burin::tst_theme {

namespace {

/// WCAG 2.1, implemented a second time: from 0 … 255, per channel.
double oracleLuminance(const QColor& colour) {
    double sum = 0.0;
    const std::array<std::pair<int, double>, 3> channels{
        {{colour.red(), 0.2126}, {colour.green(), 0.7152}, {colour.blue(), 0.0722}}};
    for (const auto& [value, weight] : channels) {
        const double c = value / 255.0;
        sum += weight * (c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return sum;
}

double oracleContrast(const QColor& one, const QColor& other) {
    const double a = oracleLuminance(one), b = oracleLuminance(other);
    return a > b ? (a + 0.05) / (b + 0.05) : (b + 0.05) / (a + 0.05);
}

std::string shippedTheme(const char* id) {
    QFile file(QStringLiteral(BURIN_SOURCE_DIRECTORY "/resources/themes/%1.json").arg(QLatin1String(id)));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

/// CIE 1976 L*a*b*, white point D65.
std::array<double, 3> labOf(const QColor& colour) {
    const auto linear = [](int value) {
        const double c = value / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double r = linear(colour.red()), g = linear(colour.green()), b = linear(colour.blue());
    const auto root = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const double x = root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
    const double y = root(0.2126 * r + 0.7152 * g + 0.0722 * b);
    const double z = root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// CIE 1976: a difference of about 2 is just visible.
double colourDifference(const QColor& one, const QColor& other) {
    const std::array<double, 3> a = labOf(one), b = labOf(other);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The colours of the materials that Burin is shipped with.
std::vector<QColor> stockColours() {
    std::vector<QColor> colours;
    const QDir folder(QStringLiteral(BURIN_SOURCE_DIRECTORY "/resources/materials"));
    for (const QString& name : folder.entryList({QStringLiteral("*.json")})) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::ReadOnly)) continue;
        const QJsonArray rgb =
            QJsonDocument::fromJson(file.readAll()).object().value(QStringLiteral("colour")).toArray();
        if (rgb.size() == 3) colours.emplace_back(rgb[0].toInt(), rgb[1].toInt(), rgb[2].toInt());
    }
    return colours;
}

/// The strongest colour that an icon draws.
QColor inkOf(const QIcon& icon, int size, QIcon::Mode mode = QIcon::Normal) {
    QImage image(size, size, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    icon.paint(&painter, image.rect(), Qt::AlignCenter, mode);
    painter.end();
    QColor ink(0, 0, 0, 0);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (const QColor pixel = image.pixelColor(x, y); pixel.alpha() > ink.alpha()) ink = pixel;
    return ink;
}

/// Nearly equal: colours of a picture are rounded when they are blended.
bool alike(const QColor& one, const QColor& other) {
    return std::abs(one.red() - other.red()) <= 2 && std::abs(one.green() - other.green()) <= 2 &&
           std::abs(one.blue() - other.blue()) <= 2;
}

} // namespace

class TestTheme : public QObject {
    Q_OBJECT
private slots:
    void contrastIsThatOfTheStandard() {
        // Published values: black on white, and the greys just above and below the limit of 4.5.
        QCOMPARE(contrast(Qt::black, Qt::white), 21.0);
        QVERIFY(std::abs(contrast(QColor("#767676"), Qt::white) - 4.54) < 0.005);
        QVERIFY(std::abs(contrast(QColor("#777777"), Qt::white) - 4.48) < 0.005);
        QCOMPARE(contrast(QColor("#a35200"), QColor("#a35200")), 1.0);
    }

    void everyTextIsReadable_data() {
        QTest::addColumn<int>("theme");
        QTest::newRow("dark") << static_cast<int>(Theme::dark);
        QTest::newRow("light") << static_cast<int>(Theme::light);
    }
    void everyTextIsReadable() {
        QFETCH(int, theme);
        const Result<Palette> loaded = loadPalette(static_cast<Theme>(theme));
        QVERIFY(loaded);
        for (const ColourRole ground : {&Palette::window, &Palette::panel, &Palette::field})
            for (const ColourRole text : {&Palette::text, &Palette::quietText, &Palette::accent, &Palette::force,
                                          &Palette::inOrder, &Palette::part}) {
                const double reached = oracleContrast(*loaded.*text, *loaded.*ground);
                QVERIFY2(reached >= 4.5, qPrintable(QStringLiteral("%1 on %2: %3")
                                                        .arg((*loaded.*text).name(), (*loaded.*ground).name())
                                                        .arg(reached)));
            }
        for (const ColourRole fill : {&Palette::accent, &Palette::force}) {
            QVERIFY(oracleContrast(readableOn(*loaded.*fill), *loaded.*fill) >= 4.5);
            QVERIFY(oracleContrast(loaded->field, *loaded.*fill) >= 4.5); // icons on filled buttons
        }
        // Lines that carry information: 3 : 1, as for graphics.
        for (const ColourRole line : {&Palette::coupling, &Palette::guide})
            for (const ColourRole ground : {&Palette::sceneTop, &Palette::sceneBottom})
                QVERIFY2(oracleContrast(*loaded.*line, *loaded.*ground) >= 3.0,
                         qPrintable((*loaded.*line).name() + QStringLiteral(" on ") + (*loaded.*ground).name()));
    }

    void linesOfAPathStandOutFromWhateverTheyLieOn_data() { everyTextIsReadable_data(); }
    /// In light and in shade, either a line or its halo has a contrast of 3 : 1 to what lies below, as required of
    /// graphics (WCAG 2.1, 1.4.11). Their hues differ from the part's and from each other's.
    void linesOfAPathStandOutFromWhateverTheyLieOn() {
        QFETCH(int, theme);
        const Palette palette = *loadPalette(static_cast<Theme>(theme));
        const std::vector<QColor> lines{palette.path,        palette.conventionalPath, palette.rapidPath,
                                        palette.plungePath,  palette.livePath,         palette.chosenPath,
                                        palette.comparedPath};
        std::vector<QColor> grounds = stockColours();
        QVERIFY(grounds.size() >= 3);
        grounds.insert(grounds.end(), {palette.part, palette.sceneTop, palette.sceneBottom});
        for (const QColor& line : lines) {
            for (const QColor& ground : grounds)
                for (int light = 20; light <= 110; light += 5) {
                    const QColor lit = ground.lighter(light);
                    const double best = std::max(oracleContrast(line, lit), oracleContrast(palette.pathHalo, lit));
                    QVERIFY2(best >= 3.0, qPrintable(line.name() + QStringLiteral(" on ") + lit.name()));
                }
            QVERIFY2(colourDifference(line, palette.part) >= 35.0, qPrintable(line.name()));
            for (const QColor& other : lines)
                QVERIFY2(&line == &other || colourDifference(line, other) >= 15.0,
                         qPrintable(line.name() + QStringLiteral(" and ") + other.name()));
        }
    }

    void aThemeFromBeforeTheHaloStillOpens() {
        QString text = QString::fromStdString(shippedTheme("light"));
        const Palette shipped = *paletteFromJson(text.toStdString(), "light.json");
        text.remove(QRegularExpression(QStringLiteral(",\\s*\"(conventional_path|rapid_path|plunge_path|chosen_path|"
                                                      "compared_path|path_halo)\": \"#[0-9a-f]{6}\"")));
        QVERIFY(!text.contains(QStringLiteral("path_halo")));
        const Result<Palette> palette = paletteFromJson(text.toStdString(), "light.json");
        QVERIFY(palette);
        QCOMPARE(palette->livePath, shipped.livePath);
        QVERIFY(oracleContrast(palette->pathHalo, palette->conventionalPath) >= 3.0);
    }

    void bothThemesCarryEveryRole() {
        for (const Theme theme : {Theme::dark, Theme::light}) {
            const Result<Palette> palette = loadPalette(theme);
            QVERIFY(palette);
            for (const auto& [key, role] : colourRoles) QVERIFY2((*palette.*role).isValid(), std::string(key).c_str());
        }
        const Palette dark = *loadPalette(Theme::dark), light = *loadPalette(Theme::light);
        QVERIFY(oracleLuminance(dark.window) < 0.05);
        QVERIFY(oracleLuminance(light.window) > 0.7);
        QCOMPARE(dark.accent.name(), QStringLiteral("#f2a33c")); // as in the file
    }

    void faultyThemesAreRefused_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("place");
        QTest::newRow("a role that nobody knows") << "\"grid\""
                                                  << "\"gird\""
                                                  << "colours.grid";
        QTest::newRow("no colour") << "\"#1b2026\""
                                   << "\"blue\""
                                   << "colours.panel";
        QTest::newRow("with transparency") << "\"#1b2026\""
                                           << "\"#801b2026\""
                                           << "colours.panel";
        QTest::newRow("a number") << "\"#1b2026\""
                                  << "17"
                                  << "colours.panel";
        QTest::newRow("no JSON") << "{"
                                 << ""
                                 << "";
    }
    void faultyThemesAreRefused() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, place);
        QString text = QString::fromStdString(shippedTheme("dark"));
        QVERIFY(text.contains(from));
        QVERIFY(paletteFromJson(text.toStdString(), "dark.json"));
        const Result<Palette> palette = paletteFromJson(text.replace(from, to).toStdString(), "dark.json");
        QVERIFY(!palette);
        QCOMPARE(palette.error().code, ErrorCode::resourceInvalid);
        QCOMPARE(palette.error().subject, std::string("dark.json"));
        if (!place.isEmpty()) QCOMPARE(QString::fromStdString(palette.error().place), place);
    }

    void theUsersThemeComesFirst() {
        const QTemporaryDir home;
        QVERIFY(QDir(home.path()).mkpath(QStringLiteral("burin/themes")));
        QFile file(home.filePath(QStringLiteral("burin/themes/dark.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(shippedTheme("dark")).replace("#f2a33c", "#ffb000"));
        file.close();
        const QByteArray before = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", home.path().toUtf8());
        const Result<Palette> palette = loadPalette(Theme::dark);
        before.isNull() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", before);
        QVERIFY(palette);
        QCOMPARE(palette->accent.name(), QStringLiteral("#ffb000"));
    }

    void theApplicationIsDressed() {
        for (const Theme theme : {Theme::light, Theme::dark}) {
            const Palette palette = *loadPalette(theme);
            applyTheme(*qApp, palette);
            QCOMPARE(activePalette().text, palette.text);
            QCOMPARE(QApplication::palette().color(QPalette::WindowText), palette.text);
            QVERIFY(!qApp->styleSheet().contains(QLatin1Char('@'))); // every name was replaced
            QLabel label(QStringLiteral("████"));
            label.setProperty("look", "force");
            label.ensurePolished();
            QCOMPARE(label.palette().color(QPalette::WindowText), palette.force);
        }
        // Images that the style sheet names exist where it names them.
        auto named = QRegularExpression(QStringLiteral("url\\(\"([^\"]+)\"\\)")).globalMatch(qApp->styleSheet());
        QVERIFY(named.hasNext());
        while (named.hasNext()) {
            const QString file = named.next().captured(1);
            QVERIFY2(QFile::exists(file), qPrintable(file));
        }
    }

    /// Hidden pages are styled later than visible ones, but never after they are shown.
    void hiddenWidgetsFollowTheTheme() {
        applyTheme(*qApp, *loadPalette(Theme::dark));
        QWidget window;
        QVBoxLayout layout(&window);
        std::vector<QLabel*> labels;
        for (int i = 0; i < 3; ++i) {
            labels.push_back(new QLabel(QStringLiteral("████"), &window));
            labels.back()->setProperty("look", "force");
            layout.addWidget(labels.back());
        }
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        labels[1]->hide();
        labels[2]->hide();
        const Palette light = *loadPalette(Theme::light);
        const auto colour = [&](std::size_t label) { return labels[label]->palette().color(QPalette::WindowText); };
        QVERIFY(colour(0) != light.force);
        applyTheme(*qApp, light);
        QCOMPARE(colour(0), light.force);
        labels[1]->show();
        QCOMPARE(colour(1), light.force);
        QTRY_COMPARE(colour(2), light.force);
        QLineEdit edit(&window);
        edit.ensurePolished();
        QCOMPARE(edit.palette().color(QPalette::Highlight), light.accent);
    }

    void iconsFollowTheTheme() {
        const QIcon icon = themedIcon(QStringLiteral("stop")),
                    red = themedIcon(QStringLiteral("stop"), &Palette::force);
        QVERIFY(!icon.isNull());
        for (const Theme theme : {Theme::light, Theme::dark}) {
            const Palette palette = *loadPalette(theme);
            applyTheme(*qApp, palette);
            QVERIFY(alike(inkOf(icon, 32), palette.text));
            QVERIFY(alike(inkOf(red, 32), palette.force));
            QVERIFY(alike(inkOf(QIcon(icon.pixmap(32, 32)), 32), palette.text));
        }
        QVERIFY(inkOf(icon, 32, QIcon::Disabled).alpha() < 160);
        QVERIFY(themedIcon(QStringLiteral("no such icon")).isNull());
        QVERIFY(themedIcon(QStringLiteral("../themes/dark")).isNull());
    }

    void everyIconDrawsSomething() {
        QVERIFY(iconNames().size() >= 30);
        for (const QString& name : iconNames())
            for (const int size : {16, 20, 32, 48})
                QVERIFY2(inkOf(themedIcon(name), size).alpha() > 90, qPrintable(name));
    }

    void lengthsAreRoundedExactly_data() {
        QTest::addColumn<double>("mm");
        QTest::addColumn<QString>("metric");
        QTest::addColumn<QString>("inch");
        QTest::addColumn<QString>("german");
        QTest::newRow("nothing") << 0.0 << "0.000 mm"
                                 << "0.0000 in"
                                 << "0,000 mm";
        QTest::newRow("an inch") << 25.4 << "25.400 mm"
                                 << "1.0000 in"
                                 << "25,400 mm";
        QTest::newRow("the header's example") << 12.5 << "12.500 mm"
                                              << "0.4921 in"
                                              << "12,500 mm";
        QTest::newRow("a thou") << 0.0254 << "0.025 mm"
                                << "0.0010 in"
                                << "0,025 mm";
        QTest::newRow("below what is shown") << 0.0004 << "0.000 mm"
                                             << "0.0000 in"
                                             << "0,000 mm";
        QTest::newRow("no sign before nothing") << -0.0004 << "0.000 mm"
                                                << "0.0000 in"
                                                << "0,000 mm";
        QTest::newRow("negative") << -1.2345 << "-1.234 mm"
                                  << "-0.0486 in"
                                  << "-1,234 mm";
        QTest::newRow("no groups") << 12345.6789 << "12345.679 mm"
                                   << "486.0504 in"
                                   << "12345,679 mm";
    }
    void lengthsAreRoundedExactly() {
        QFETCH(double, mm);
        QFETCH(QString, metric);
        QFETCH(QString, inch);
        QFETCH(QString, german);
        const auto plain = [](QString text) { return text.replace(QChar(QChar::Nbsp), QLatin1Char(' ')); };
        const QLocale english(QStringLiteral("en_US")), de(QStringLiteral("de_DE"));
        QCOMPARE(plain(lengthText(mm, LengthUnit::millimetre, english)), metric);
        QCOMPARE(plain(lengthText(mm, LengthUnit::inch, english)), inch);
        QCOMPARE(plain(lengthText(mm, LengthUnit::millimetre, de)), german);
        QCOMPARE(lengthNumber(mm, LengthUnit::millimetre, QLocale::c()), metric.chopped(3));
    }

    void digitsAreEquallyWide() {
        for (const char* family : {"Roboto", "DejaVu Sans", "DejaVu Serif", "Sans Serif"}) {
            QFont font(QString::fromLatin1(family));
            font.setPointSizeF(11.0);
            const QFont numbers = numberFont(font);
            QCOMPARE(numbers.pointSizeF(), 11.0);
            const QFontMetricsF metrics(numbers);
            for (char digit = '1'; digit <= '9'; ++digit)
                QCOMPARE(metrics.horizontalAdvance(QLatin1Char(digit)), metrics.horizontalAdvance(QLatin1Char('0')));
        }
    }
};

BURIN_TEST(TestTheme, QApplication)

} // namespace burin::tst_theme

#include "tst_theme.moc"
