// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/exchange/plan_drawing.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QtTest>

namespace burin::tst_drawings {

namespace {

/// A DXF with the given figures, whose lines are joined by blanks.
std::string dxf(const char* figures, const char* units = "4") {
    std::string text =
        std::string("0 SECTION 2 HEADER 9 $INSUNITS 70 ") + units +
        " 0 ENDSEC 0 SECTION 2 BLOCKS 0 BLOCK 2 HOLE 10 1 20 0 0 CIRCLE 8 0 10 1 20 0 40 1 0 ENDBLK 0 ENDSEC "
        "0 SECTION 2 ENTITIES " +
        figures + " 0 ENDSEC 0 EOF ";
    std::ranges::replace(text, ' ', '\n');
    return text;
}
std::string svg(const char* figures, const char* page = "width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\"") {
    return std::string("<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" ") + page + ">" + figures +
           "</svg>";
}

double signedArea(const PlanRing& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

/// Area of the borders, which run anticlockwise, minus that of the holes, which run clockwise.
double areaOf(const PlanRegion& region) {
    double area = 0.0;
    for (const PlanPiece& piece : piecesOf(region)) {
        area += signedArea(piece.border);
        for (const PlanRing& hole : piece.holes) area += signedArea(hole);
    }
    return area;
}

double areaIn(const std::string& text) {
    const Result<PlanDrawing> drawing = drawingOf(text, "drawing");
    if (!drawing) return -1.0;
    const Result<PlanRegion> region = regionOf(*drawing, "drawing");
    return region ? areaOf(*region) : -2.0;
}

QString faultOf(const std::string& text) {
    const Result<PlanDrawing> drawing = drawingOf(text, "drawing");
    return drawing ? QString() : QString::fromStdString(drawing.error().detail);
}

} // namespace

/// Oracles: the closed formulas of the figures' areas and lengths.
class DrawingsTest final : public QObject {
    Q_OBJECT
private slots:
    void areasAreThoseOfTheFigures_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<double>("area");
        const char* slot = "0 LWPOLYLINE 8 0 90 4 70 1 10 0 20 0 42 0 10 10 20 0 42 1 10 10 20 4 42 0 10 0 20 4 42 1";
        QTest::newRow("DXF: circle") << dxf("0 CIRCLE 8 0 10 5 20 6 40 10") << pi * 100.0;
        QTest::newRow("DXF: inches") << dxf("0 CIRCLE 8 0 10 5 20 6 40 1", "1") << pi * 25.4 * 25.4;
        QTest::newRow("DXF: metres") << dxf("0 CIRCLE 8 0 10 0 20 0 40 0.01", "6") << pi * 100.0;
        QTest::newRow("DXF: slot with bulges") << dxf(slot) << 40.0 + pi * 4.0;
        QTest::newRow("DXF: seen from below")
            << dxf((std::string(slot) + " 210 0 220 0 230 -1").c_str()) << 40.0 + pi * 4.0;
        QTest::newRow("DXF: polyline with vertices")
            << dxf("0 POLYLINE 8 0 66 1 70 1 0 VERTEX 10 0 20 0 0 VERTEX 10 4 20 0 0 VERTEX 10 4 20 3 0 SEQEND") << 6.0;
        QTest::newRow("DXF: ellipse") << dxf("0 ELLIPSE 8 0 10 0 20 0 11 6 21 8 40 0.5 41 0 42 6.283185307179586")
                                      << pi * 50.0;
        QTest::newRow("DXF: half an ellipse and a line") << dxf("0 ELLIPSE 8 0 10 0 20 0 11 10 21 0 40 0.5 41 0 42 "
                                                                "3.141592653589793 0 LINE 8 0 10 -10 20 0 11 10 21 0")
                                                         << pi * 25.0;
        QTest::newRow("DXF: arc and line, joined")
            << dxf("0 ARC 8 0 10 0 20 0 40 5 50 90 51 270 0 LINE 8 0 10 0 20 5 11 0 21 -5") << pi * 12.5;
        QTest::newRow("DXF: circle as a rational spline")
            << dxf("0 SPLINE 8 0 70 1 71 2 40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 3 40 3 40 4 40 4 40 4 "
                   "41 1 41 0.7071067811865476 41 1 41 0.7071067811865476 41 1 41 0.7071067811865476 41 1 "
                   "41 0.7071067811865476 41 1 10 5 20 0 10 5 20 5 10 0 20 5 10 -5 20 5 10 -5 20 0 10 -5 20 -5 10 0 20 "
                   "-5 "
                   "10 5 20 -5 10 5 20 0")
            << pi * 25.0;
        QTest::newRow("DXF: blocks in an array, turned and scaled")
            << dxf("0 INSERT 8 0 2 HOLE 10 3 20 4 41 2 42 3 50 30 70 2 71 3 44 20 45 30") << 6.0 * pi * 6.0;
        QTest::newRow("DXF: a hole in a circle")
            << dxf("0 CIRCLE 8 0 10 0 20 0 40 10 0 CIRCLE 8 0 10 0 20 0 40 5") << pi * 75.0;
        QTest::newRow("SVG: rectangle") << svg("<rect x=\"1\" y=\"2\" width=\"20\" height=\"10\"/>") << 200.0;
        QTest::newRow("SVG: rounded rectangle")
            << svg("<rect x=\"1\" y=\"2\" width=\"20\" height=\"10\" rx=\"2\"/>") << 200.0 - (4.0 - pi) * 4.0;
        QTest::newRow("SVG: scaled page")
            << svg("<circle cx=\"5\" cy=\"5\" r=\"2\"/>", "width=\"20cm\" viewBox=\"0 0 100 50\"") << pi * 16.0;
        QTest::newRow("SVG: pixels") << svg("<rect width=\"96\" height=\"96\"/>", "") << 25.4 * 25.4;
        QTest::newRow("SVG: turned ellipse in a group")
            << svg("<g transform=\"translate(3 4) rotate(30) scale(2,1)\"><ellipse rx=\"2\" ry=\"3\"/></g>")
            << pi * 12.0;
        QTest::newRow("SVG: a circle of two arcs")
            << svg("<path d=\"M10 20A5 5 0 0 1 20 20A5 5 0 01 10 20z\"/>") << pi * 25.0;
        QTest::newRow("SVG: the greater arc") << svg("<path d=\"M15 20A5 5 0 1 1 20 25L20 20z\"/>") << pi * 25.0 * 0.75;
        QTest::newRow("SVG: parabola and line") << svg("<path d=\"M0,0Q5,10,10,0z\"/>") << 2.0 / 3.0 * 50.0;
        QTest::newRow("SVG: cubic that is a parabola")
            << svg("<path d=\"m0 0c3.3333333333,6.6666666667 6.6666666667,6.6666666667 10 0z\"/>") << 2.0 / 3.0 * 50.0;
        QTest::newRow("SVG: short forms") << svg("<path d=\"M1 1h4v3H1zm10 0l2 0 0 2-2 0z\"/>") << 12.0 + 4.0;
        QTest::newRow("SVG: polygon") << svg("<polygon points=\"0,0 4,0 4,3\"/>") << 6.0;
        QTest::newRow("SVG: used twice") << svg("<defs><rect id=\"a\" width=\"2\" height=\"2\"/></defs><use "
                                                "href=\"#a\"/><use href=\"#a\" x=\"10\"/>")
                                         << 8.0;
        QTest::newRow("SVG: hidden things don't count")
            << svg("<rect width=\"2\" height=\"2\"/><rect style=\"display:none\" x=\"9\" width=\"2\" "
                   "height=\"2\"/><clipPath><rect width=\"9\" height=\"9\"/></clipPath>")
            << 4.0;
    }
    void areasAreThoseOfTheFigures() {
        QFETCH(std::string, text);
        QFETCH(double, area);
        const double found = areaIn(text);
        // Chords within 0.002 mm of a border lose at most that much along it.
        QVERIFY2(std::abs(found - area) < 0.002 * std::sqrt(area) * 8.0,
                 qPrintable(QString("%1, not %2").arg(found).arg(area)));
    }

    /// As in exploded outlines: thousands of lines in any order and direction.
    void linesAreJoinedToAnOutline() {
        constexpr int count = 5000;
        std::string figures;
        for (int i = 0; i < count; ++i) {
            const int at = i * 1999 % count; // coprime to their number: each occurs once
            const double first = 2.0 * pi * at / count, last = 2.0 * pi * (at + 1) / count;
            const bool back = i % 3 == 0;
            const auto coordinate = [](double value) { return " " + QString::number(value, 'f', 9).toStdString(); };
            figures += (i > 0 ? " 0 LINE 8 0 10" : "0 LINE 8 0 10") + coordinate(50.0 * std::cos(back ? last : first)) +
                       " 20" + coordinate(50.0 * std::sin(back ? last : first)) + " 11" +
                       coordinate(50.0 * std::cos(back ? first : last)) + " 21" +
                       coordinate(50.0 * std::sin(back ? first : last));
        }
        const double area = 0.5 * count * 2500.0 * std::sin(2.0 * pi / count);
        QVERIFY(std::abs(areaIn(dxf(figures.c_str())) - area) < 0.1);
    }

    void yPointsUp() {
        const Result<PlanDrawing> drawing = drawingOf(svg("<circle cx=\"10\" cy=\"8\" r=\"1\"/>"), "drawing");
        QVERIFY(drawing && drawing->points.size() == 1);
        QVERIFY(glm::distance(drawing->points[0], {10.0, 42.0}) < 1e-9);
    }

    void anUnstatedUnitIsTold() {
        const Result<PlanDrawing> plain = drawingOf(dxf("0 CIRCLE 8 0 10 0 20 0 40 1", "0"), "drawing");
        QVERIFY(plain && !plain->unitStated && plain->unit == 1.0);
        const Result<PlanDrawing> chosen = drawingOf(dxf("0 CIRCLE 8 0 10 0 20 0 40 1", "0"), "drawing", 25.4);
        QVERIFY(chosen && chosen->unitStated && chosen->unit == 25.4);
        const Result<PlanDrawing> pixels = drawingOf(svg("<rect width=\"9\" height=\"9\"/>", ""), "drawing");
        QVERIFY(pixels && !pixels->unitStated);
    }

    void layersAreKeptAndLossesTold() {
        const Result<PlanDrawing> drawing =
            drawingOf(dxf("0 LINE 8 cut 10 0 20 0 11 5 21 5 0 TEXT 8 cut 10 0 20 0 1 hello 0 HATCH 8 x"), "drawing");
        QVERIFY(drawing && drawing->curves.size() == 1);
        QCOMPARE(drawing->curves[0].layer, std::string("cut"));
        QCOMPARE(drawing->notes, (std::vector<std::string>{"TEXT is left out", "HATCH is left out"}));
    }

    void badFilesSayWhatIsWrong() {
        QVERIFY(faultOf("AutoCAD Binary DXF\r\n\x1a").contains("binary"));
        QVERIFY(faultOf("hello").contains("neither"));
        QVERIFY(faultOf("").contains("neither"));
        QVERIFY(faultOf("0\nSECTION\n2\nENTITIES\n0\nLINE\n").contains("EOF"));
        QVERIFY(faultOf("0\nSECTION\n2\nENTITIES\nLINE\n0\n").contains("line 5"));
        QVERIFY(faultOf(dxf("0 TEXT 8 a 1 b")).contains("no curve"));
        QVERIFY(faultOf(dxf("0 LINE 8 0 10 0 20 0 11 1e9 21 0")).contains("1e5 mm"));
        QVERIFY(faultOf(dxf("0 LINE 8 0 10 x 20 0 11 1 21 0")).contains("1e5 mm"));
        QVERIFY(faultOf(dxf("0 CIRCLE 8 0 10 0 20 0 40 1e308")).contains("1e5 mm"));
        QVERIFY(faultOf(dxf("0 ELLIPSE 8 0 10 x 20 0 11 3 21 0 40 0.5")).contains("1e5 mm"));
        QVERIFY(faultOf("<svg><rect width=\"2\"").contains("byte"));
        QVERIFY(faultOf(svg("<path d=\"L 1 2\"/>")).contains("not begin with M"));
        QVERIFY(faultOf(svg("<path d=\"M 1\"/>")).contains("wrong numbers"));
        QVERIFY(faultOf(svg("<rect width=\"2mm2\" height=\"2\"/>")).contains("width"));
        QVERIFY(faultOf(svg("<g transform=\"turn(3)\"><rect width=\"2\" height=\"2\"/></g>")).contains("transform"));
        // A group that uses itself is expanded only finitely.
        QVERIFY(drawingOf(svg("<rect width=\"1\" height=\"1\"/><g id=\"a\"><use href=\"#a\"/><use href=\"#a\"/></g>"),
                          "drawing"));
        const Result<PlanDrawing> open = drawingOf(dxf("0 LINE 8 0 10 0 20 0 11 5 21 5"), "drawing");
        QVERIFY(open && !regionOf(*open, "drawing"));
    }
};

BURIN_TEST(DrawingsTest, QCoreApplication)

} // namespace burin::tst_drawings

#include "tst_drawings.moc"
