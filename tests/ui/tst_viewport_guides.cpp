// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/viewport_fixture.h"

#include <functional>

#include <QApplication>

namespace burin::tst_viewport_guides {

using fixture::marksAt;
using fixture::radii;
using fixture::stock;

namespace {

GuideMark markOf(GuideKind kind) {
    GuideMark mark;
    mark.guide.kind = kind;
    mark.guide.on = true;
    return mark;
}

GuideMarks marksOf(const GuideMark& mark) {
    GuideMarks marks;
    marks.room = stock.grown(2.0);
    marks.guides = {mark};
    return marks;
}

/// The dome as a boundary for tips; the distances are accurate enough for a picture.
class DomeField final : public ClearanceField {
public:
    FieldSample at(const glm::dvec3& tip) const noexcept override {
        const glm::dvec3 p = tip / radii;
        const double k = glm::length(p), slope = glm::length(p / radii);
        if (!(slope > 1e-9)) return {-10.0, {0, 0, 1}, false};
        return {k * (k - 1.0) / slope, glm::normalize(p / radii), std::abs(k - 1.0) < 0.4};
    }
    double errorBound() const noexcept override { return 0.1; }
    double spacing() const noexcept override { return 0.5; }
};

QRect difference(const QImage& one, const QImage& other, int least = 6) {
    const QImage a = one.convertToFormat(QImage::Format_RGB32), b = other.convertToFormat(QImage::Format_RGB32);
    QRect different;
    for (int y = 0; y < a.height(); ++y) {
        const auto* lineA = reinterpret_cast<const QRgb*>(a.constScanLine(y));
        const auto* lineB = reinterpret_cast<const QRgb*>(b.constScanLine(y));
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = lineA[x], q = lineB[x];
            if (std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q)) > least)
                different |= QRect(x, y, 1, 1);
        }
    }
    return different;
}

} // namespace

/// How guides are drawn.
class TestViewportGuides : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        rig_ = std::make_unique<fixture::ViewportWindow>();
        viewport_ = rig_->viewport;
        QTRY_VERIFY(rig_->ready());
        volume_ = std::make_unique<RunVolume>(fixture::milledBlock(stock, 0.25, radii));
        viewport_->setWorkpiece(volume_->snapshot());
        viewport_->setToolMarks(marksAt({-9.0, -7.0, 22.0}));
        QTRY_VERIFY_WITH_TIMEOUT(viewport_->statistics().fullDetail, 8000);
        rig_->settle();
    }
    void init() {
        viewport_->setGuides({});
        rig_->settle();
        plain_ = viewport_->grabFramebuffer();
    }
    void cleanupTestCase() { rig_.reset(); }

    void everyKindIsSeenAndGoesAgain_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("name");
        for (const auto& [kind, name] : {std::pair{GuideKind::plane, "plane"},
                                         {GuideKind::levels, "levels"},
                                         {GuideKind::line, "line"},
                                         {GuideKind::curve, "curve"},
                                         {GuideKind::surface, "surface"},
                                         {GuideKind::stepOver, "step-over"},
                                         {GuideKind::axis, "axis"}})
            QTest::newRow(name) << static_cast<int>(kind) << QString(name);
    }
    void everyKindIsSeenAndGoesAgain() {
        QFETCH(int, kind);
        QFETCH(QString, name);
        const GuideMarks marks = example(static_cast<GuideKind>(kind));
        viewport_->setGuides(marks);
        QImage idle;
        const auto drawn = [&] {
            rig_->settle();
            idle = viewport_->grabFramebuffer();
            return difference(plain_, idle);
        };
        QTRY_VERIFY_WITH_TIMEOUT(drawn().width() > 60, 30000);
        QVERIFY(rig_->save(qPrintable(QStringLiteral("guide-") + name), idle));
        GuideMarks holding = marks;
        holding.guides[0].holds = true;
        viewport_->setGuides(holding);
        rig_->settle();
        const QImage held = viewport_->grabFramebuffer();
        QVERIFY(!difference(idle, held).isEmpty());
        QVERIFY(rig_->save(qPrintable(QStringLiteral("guide-") + name + QStringLiteral("-holds")), held));
        viewport_->setGuides({});
        rig_->settle();
        QVERIFY(difference(plain_, viewport_->grabFramebuffer(), 0).isEmpty());
    }

    /// A level exactly on the face of the stock and one deep inside of it are both drawn in every frame, always alike.
    void whatLiesOnOrInTheWorkpieceDoesNotFlicker() {
        for (const double height : {stock.high.z, 6.0}) {
            GuideMark mark = markOf(GuideKind::plane);
            mark.guide.point = {0.0, 0.0, height};
            viewport_->setGuides(marksOf(mark));
            rig_->settle();
            const QImage first = viewport_->grabFramebuffer();
            QVERIFY(!difference(plain_, first).isEmpty());
            // On the face that it shares with the stock the film is even: one colour or the other, not a pattern.
            if (height == stock.high.z) {
                int changed = 0, seen = 0;
                for (double x = 6.0; x <= 24.0; x += 1.0)
                    for (double y = -15.0; y <= 15.0; y += 1.0) {
                        const QPoint at =
                            (viewport_->project({x, y, height}) * viewport_->devicePixelRatio()).toPoint();
                        if (!first.rect().contains(at)) continue;
                        ++seen;
                        if (first.pixel(at) != plain_.pixel(at)) ++changed;
                    }
                QVERIFY2(seen > 100 && changed > 0.97 * seen,
                         qPrintable(QStringLiteral("%1 of %2").arg(changed).arg(seen)));
            }
            for (int frame = 0; frame < 5; ++frame)
                QVERIFY(difference(first, viewport_->grabFramebuffer(), 0).isEmpty());
        }
    }

    void aHiddenCurveShowsThrough() {
        GuideMark mark = markOf(GuideKind::line);
        mark.guide.point = {0.0, 0.0, 8.0}; // through the part
        mark.guide.direction = {1.0, 0.0, 0.0};
        viewport_->setGuides(marksOf(mark));
        rig_->settle();
        const QImage image = viewport_->grabFramebuffer();
        int seen = 0;
        for (double x = 5.0; x <= 25.0; x += 1.0) {
            const QPoint at = (viewport_->project({x, 0.0, 8.0}) * viewport_->devicePixelRatio()).toPoint();
            bool differs = false;
            for (int dx = -2; dx <= 2; ++dx)
                for (int dy = -2; dy <= 2; ++dy)
                    differs |= image.pixel(at + QPoint(dx, dy)) != plain_.pixel(at + QPoint(dx, dy));
            seen += differs ? 1 : 0;
        }
        QVERIFY(seen > 18);
    }

    void inBothThemes() {
        GuideMarks all = example(GuideKind::levels);
        all.guides.push_back(example(GuideKind::curve).guides[0]);
        all.guides[0].holds = true;
        for (const Theme theme : {Theme::light, Theme::dark}) {
            viewport_->setPalette3D(*loadPalette(theme));
            viewport_->setGuides(all);
            rig_->settle();
            QVERIFY(rig_->save(theme == Theme::light ? "guide-light" : "guide-dark"));
        }
        viewport_->setPalette3D(fixture::palette());
    }

private:
    GuideMarks example(GuideKind kind) {
        GuideMark mark = markOf(kind);
        Guide& guide = mark.guide;
        guide.point = {0.0, 0.0, 10.0};
        if (kind == GuideKind::levels) {
            guide.point.z = stock.high.z;
            guide.distance = 2.0;
            mark.level = -3;
        }
        if (kind == GuideKind::line) {
            guide.point = {0.0, -14.0, 12.0};
            guide.direction = {1.0, 0.0, 0.0};
        }
        if (kind == GuideKind::surface || kind == GuideKind::stepOver) guide.distance = 1.0;
        if (kind == GuideKind::axis) {
            guide.lead = 0.35;
            mark.axis = glm::normalize(glm::dvec3(0.34, 0.1, 0.93));
        }
        if (kind == GuideKind::curve) {
            std::vector<glm::dvec3> points, tangents;
            for (int i = 0; i <= 90; ++i) {
                const double angle = 2.0 * pi * i / 90.0;
                points.push_back({20.0 * std::cos(angle), 13.0 * std::sin(angle), 4.5});
                tangents.push_back(glm::normalize(glm::dvec3(-20.0 * std::sin(angle), 13.0 * std::cos(angle), 0.0)));
            }
            points.back() = points.front();
            if (!curve_) curve_ = std::make_unique<GuideCurve>(*GuideCurve::make(points, tangents));
            guide.curve = curve_.get();
        }
        mark.label = QStringLiteral("○ Guide");
        GuideMarks marks = marksOf(mark);
        marks.tips = stock.grown(6.0);
        marks.field = field_;
        std::vector<glm::dvec3> pass;
        for (int i = 0; i <= 200; ++i) pass.emplace_back(-28.0 + 0.12 * i, -8.0 + 1.5 * std::sin(0.1 * i), 9.0);
        if (kind == GuideKind::stepOver) marks.lastPass = std::make_shared<const std::vector<glm::dvec3>>(pass);
        return marks;
    }

    std::unique_ptr<fixture::ViewportWindow> rig_;
    Viewport* viewport_ = nullptr;
    std::unique_ptr<RunVolume> volume_;
    std::unique_ptr<GuideCurve> curve_;
    std::shared_ptr<const ClearanceField> field_ = std::make_shared<DomeField>();
    QImage plain_;
};

BURIN_TEST(TestViewportGuides, QApplication)

} // namespace burin::tst_viewport_guides

#include "tst_viewport_guides.moc"
