// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool.h"
#include "tests/core/tool/cutters.h"
#include "tests/core/tool/random_sweeps.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <optional>

namespace burin::tst_flute_form {

namespace {

Tool toolWith(Cutter cutter) {
    Tool tool;
    tool.id = tool.name = tool.source = "example";
    tool.maximumDepthOfCut = 0.5 * cutter.fluteLength;
    tool.cutter = std::move(cutter);
    return tool;
}

/// Largest radius of the pieces at a height; empty where there is no piece.
double piecesRadius(const std::vector<RevolvedPiece>& pieces, double height) {
    double radius = -1.0;
    for (const RevolvedPiece& piece : pieces)
        if (height >= piece.bottom && height <= piece.top) radius = std::max(radius, radiusAt(piece, height));
    return radius;
}

void rowForEveryType() {
    QTest::addColumn<int>("index");
    const std::vector<cutters::Named> all = cutters::all();
    for (int i = 0; i < static_cast<int>(all.size()); ++i) QTest::newRow(all[static_cast<std::size_t>(i)].name) << i;
}

Cutter cutterOf(int index) {
    return cutters::all()[static_cast<std::size_t>(index)].cutter;
}

/// An element of a profile with its construction data; points are (radius, height), mm.
struct Drawn {
    glm::dvec2 from{0.0}, to{0.0};
    double arcRadius = 0.0; ///< 0: a line; negative: concave
    glm::dvec2 centre{0.0}; ///< of an arc

    bool hollow() const { return arcRadius < 0.0; }
    bool isFace() const { return arcRadius == 0.0 && from.y == to.y; }
    /// Distance of a point beyond the element, away from the axis; negative: within the tool.
    double beyond(const glm::dvec2& place) const {
        if (arcRadius != 0.0) {
            const double out = glm::distance(place, centre) - std::abs(arcRadius);
            return hollow() ? -out : out;
        }
        const glm::dvec2 along = glm::normalize(to - from);
        return glm::dot(place - from, glm::dvec2(along.y, -along.x));
    }
    glm::dvec2 at(double angle) const { // of an arc: 0 where it is vertical
        return centre + glm::dvec2(arcRadius * std::cos(angle), std::abs(arcRadius) * std::sin(angle));
    }
};

/// A random element that continues from a point, or empty if it would cross the axis.
std::optional<Drawn> anyElement(const glm::dvec2& from) {
    Drawn element;
    element.from = from;
    const int kind = *rc::gen::inRange(0, 6); // concave ones often cross the axis
    if (kind < 2) {                           // a line, sometimes level
        element.to = {random::real(0.0, 8.0), from.y + (kind == 0 ? random::real(0.01, 4.0) : 0.0)};
        if (std::abs(element.to.x - from.x) < 0.01 && kind == 1) return std::nullopt;
        return element;
    }
    element.arcRadius = (kind == 2 ? 1.0 : -1.0) * random::real(0.05, 4.0);
    const double one = random::real(-1.5, 1.5), two = random::real(-1.5, 1.5);
    if (std::abs(one - two) < 0.05) return std::nullopt;
    element.centre = from - element.at(std::min(one, two));
    element.to = element.at(std::max(one, two));
    const bool crosses = element.hollow() && one * two < 0.0 && element.centre.x + element.arcRadius < 0.01;
    if (element.to.x < 0.0 || crosses) return std::nullopt;
    return element;
}

std::vector<Drawn> anyDrawing() {
    std::vector<Drawn> drawing;
    glm::dvec2 place(0.0);
    for (int throws = *rc::gen::inRange(6, 18); throws > 0; --throws)
        if (const std::optional<Drawn> element = anyElement(place)) {
            if (element->isFace() && !drawing.empty() && drawing.back().isFace()) continue; // out and back: no solid
            drawing.push_back(*element);
            place = element->to;
        }
    Drawn last; // a cylinder ends all of them
    last.from = place;
    last.to = place + glm::dvec2(0.0, 1.0);
    if (place.x < 0.1) last.to.x = 2.0;
    drawing.push_back(last);
    return drawing;
}

Cutter cutterOf(const std::vector<Drawn>& drawing) {
    double widest = 0.0;
    for (const Drawn& element : drawing) {
        widest = std::max({widest, element.from.x, element.to.x});
        // A convex arc that passes its equator is widest there.
        if (element.arcRadius > 0.0 && element.from.y < element.centre.y && element.centre.y < element.to.y)
            widest = std::max(widest, element.centre.x + element.arcRadius);
    }
    Cutter cutter = cutters::make(CutterType::profile, 2.0 * widest, 0.0, drawing.back().to.y);
    for (const Drawn& element : drawing)
        cutter.profile.push_back({element.to.x, element.to.y, std::abs(element.arcRadius), element.hollow()});
    return cutter;
}

} // namespace

/// The forms of flutes: the solid that mills is the one described by the file.
class FluteFormTest : public QObject {
    Q_OBJECT

private slots:
    void everyTypeIsItsDrawing_data() { rowForEveryType(); }
    void everyTypeIsItsDrawing() {
        QFETCH(int, index);
        const Cutter cutter = cutterOf(index);
        const std::vector<RevolvedPiece> pieces = flutePieces(cutter);
        QCOMPARE(pieces.front().bottom, 0.0);
        QCOMPARE(pieces.back().top, cutter.fluteLength);
        for (std::size_t i = 1; i < pieces.size(); ++i) QCOMPARE(pieces[i].bottom, pieces[i - 1].top);
        for (int step = 0; step <= 5000; ++step) {
            const double height = cutter.fluteLength * step / 5000.0;
            const double found = piecesRadius(pieces, height), drawn = cutters::drawnRadius(cutter, height);
            // Concave arcs may protrude by their chord error, but never the other way: the tool is not smaller than the
            // true one. Where the arc is nearly level the radius is not significant: half a micrometre across the arc
            // is more along it.
            const bool hollow = cutter.type == CutterType::profile && height > 1.0 && height < 3.0;
            const double slope = hollow ? std::hypot(1.0, (height - 1.0) / std::max(4.0 - drawn, 0.05)) : 1.0;
            QVERIFY2(found >= drawn - 1e-6 && found <= drawn + (hollow ? profileChord * slope : 0.0) + 1e-6,
                     qPrintable(
                         QStringLiteral("%1: %2, drawn %3").arg(height).arg(found, 0, 'g', 12).arg(drawn, 0, 'g', 12)));
        }
    }

    void everyTypeIsValidAndReadsBack_data() { rowForEveryType(); }
    void everyTypeIsValidAndReadsBack() {
        QFETCH(int, index);
        const Tool tool = toolWith(cutterOf(index));
        const Result<void> valid = validate(tool);
        QVERIFY2(valid.hasValue(), valid ? "" : (valid.error().subject + " " + valid.error().detail).c_str());
        const std::string text = toJson(tool);
        const Result<Tool> back = toolFromJson(text, "memory");
        QVERIFY2(back.hasValue(), back ? "" : (back.error().place + " " + back.error().detail).c_str());
        QCOMPARE(toJson(*back), text);
        QVERIFY(back->cutter.type == tool.cutter.type);
        const std::vector<RevolvedPiece> before = flutePieces(tool.cutter), after = flutePieces(back->cutter);
        QCOMPARE(after.size(), before.size());
        for (double height = 0.0; height < tool.cutter.fluteLength; height += 0.01)
            QVERIFY(std::abs(piecesRadius(after, height) - piecesRadius(before, height)) < 1e-9);
    }

    void anglesStandInFilesAsTheyWereWritten() {
        QVERIFY(toJson(toolWith(cutters::drill())).find("\"taper_angle_deg\": 59.0,") != std::string::npos);
    }

    /// Every piece is convex: between two radii it is never below the straight line.
    void piecesAreConvex() {
        for (const cutters::Named& named : cutters::all())
            for (const RevolvedPiece& piece : flutePieces(named.cutter))
                for (int i = 1; i < 50; ++i) {
                    const double step = (piece.top - piece.bottom) / 50.0, height = piece.bottom + i * step;
                    const double chord =
                        0.5 * (radiusAt(piece, height - step) + radiusAt(piece, std::min(height + step, piece.top)));
                    QVERIFY(radiusAt(piece, height) >= chord - 1e-9);
                }
    }

    void whatDoesNotFitIsNamed_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<QString>("key");
        const char* keys[] = {
            "cutter.corner_radius_mm",     "cutter.corner_radius_mm",         "cutter.corner_radius_mm",
            "cutter.diameter_mm",          "cutter.taper_angle_deg",          "cutter.tip_diameter_mm",
            "cutter.tip_diameter_mm",      "cutter.flute_length_mm",          "cutter.profile",
            "cutter.profile[1].height_mm", "cutter.profile[1].arc_radius_mm", "cutter.profile[2].arc_radius_mm",
            "cutter.diameter_mm",          "cutter.flute_length_mm",          "cutter.profile",
            "cutter.taper_angle_deg"};
        for (int i = 0; i < static_cast<int>(std::size(keys)); ++i) QTest::addRow("%d", i) << i << keys[i];
    }
    void whatDoesNotFitIsNamed() {
        QFETCH(int, index);
        QFETCH(QString, key);
        std::vector<Cutter> wrong{cutters::ball(),    cutters::taper(),   cutters::taperBall(), cutters::taperBall(),
                                  cutters::drill(),   cutters::drill(),   cutters::chamfer(),   cutters::lollipop(),
                                  cutters::profile(), cutters::profile(), cutters::profile(),   cutters::profile(),
                                  cutters::profile(), cutters::profile(), cutters::flat(),      cutters::ball()};
        wrong[0].cornerRadius = 2.9;
        wrong[1].cornerRadius = 2.0; // the tip is too small for the rounding
        wrong[2].cornerRadius = 2.5; // larger than the cutter
        wrong[3].fluteLength = 5.0;  // the cone never becomes that wide
        wrong[4].taperAngle = 0.0;
        wrong[5].tipDiameter = 0.1; // a drill has a point
        wrong[6].tipDiameter = 6.0;
        wrong[7].fluteLength = 2.5; // below the ball's equator
        wrong[8].profile.clear();
        wrong[9].profile[1].height = -1.0;
        wrong[10].profile[1].arcRadius = 0.6;  // too small to reach
        wrong[11].profile[2].arcRadius = 1.45; // would have to turn back on its way
        wrong[12].diameter = 9.0;
        wrong[13].fluteLength = 8.0;
        wrong[14].profile = cutters::profile().profile;
        wrong[15].taperAngle = 0.1;
        const Result<void> valid = validate(toolWith(wrong[static_cast<std::size_t>(index)]));
        QVERIFY(!valid.hasValue());
        QVERIFY(valid.error().code == ErrorCode::argumentInvalid);
        QCOMPARE(QString::fromStdString(valid.error().subject), key);
        QVERIFY(!valid.error().detail.empty());
    }

    void aCuppedTipIsRefusedInWords() {
        Cutter cutter = cutters::make(CutterType::profile, 6.0, 0.0, 6.0);
        cutter.profile = {{1.0, 1.0}, {3.0, 0.5}, {3.0, 6.0}}; // concave about the axis, so that the rim is lowest
        const Result<void> valid = validate(toolWith(cutter));
        QVERIFY(!valid);
        QCOMPARE(valid.error().subject, std::string("cutter.profile[1].height_mm"));
        QVERIFY(valid.error().detail.find("a cupped tip can't be drawn") != std::string::npos);
    }

    /// Random profiles of lines and arcs, convex and concave, given by their centres and angles: each is valid, and its
    /// pieces coincide with each line and convex arc, and deviate from a concave one by at most the stated chord error,
    /// outwards.
    void anyProfileIsItsDrawing() {
        int lines = 0, bulging = 0, hollow = 0;
        const bool held = rc::check("profiles", [&] {
            const std::vector<Drawn> drawing = anyDrawing();
            const Cutter cutter = cutterOf(drawing);
            const Result<void> valid = validate(toolWith(cutter));
            if (!valid) RC_FAIL(valid.error().subject + " " + valid.error().place + " " + valid.error().detail);
            const std::vector<RevolvedPiece> pieces = flutePieces(cutter);
            for (std::size_t i = 1; i < pieces.size(); ++i)
                RC_ASSERT(std::abs(pieces[i].bottom - pieces[i - 1].top) < 1e-12);
            for (const Drawn& element : drawing) {
                if (element.isFace()) continue;
                for (int step = 1; step < 40; ++step) {
                    const double height = glm::mix(element.from.y, element.to.y, step / 40.0);
                    const double out = element.beyond({piecesRadius(pieces, height), height});
                    RC_ASSERT(out > -1e-7 && out < (element.hollow() ? profileChord : 0.0) + 1e-7);
                }
                (element.arcRadius == 0.0 ? lines : element.hollow() ? hollow : bulging) += 1;
            }
        });
        QVERIFY(held);
        QVERIFY2(lines > 50 && bulging > 50 && hollow > 50,
                 qPrintable(QStringLiteral("%1, %2, %3").arg(lines).arg(bulging).arg(hollow)));
    }

    /// A sphere drawn as two arcs about a point on the axis is a sphere, with a bitwise equal centre.
    void arcsAboutTheAxisAreSpheres() {
        Cutter cutter = cutters::make(CutterType::profile, 6.0, 0.0, 6.0);
        cutter.profile = {{3.0, 3.0, 3.0}, {0.0, 6.0, 3.0}};
        QVERIFY(validate(toolWith(cutter)).hasValue());
        for (const RevolvedPiece& piece : flutePieces(cutter)) {
            QCOMPARE(piece.bulgeCentreRadius, 0.0);
            QVERIFY(std::abs(piece.bulgeCentreHeight - 3.0) < 1e-12);
        }
    }
};

BURIN_TEST(FluteFormTest, NoApplication)

} // namespace burin::tst_flute_form

#include "tst_flute_form.moc"
