// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/viewport_fixture.h"

#include <QApplication>
#include <QSignalSpy>

namespace burin::tst_viewport {

using fixture::marksAt;
using fixture::stock;

namespace {

/// Does what it is told and records what it was sent.
class Recorder : public InteractiveTool {
public:
    bool press(const ViewportEvent& event) override { return note("press", event); }
    bool move(const ViewportEvent& event) override { return note("move", event); }
    bool release(const ViewportEvent& event) override { return note("release", event); }
    bool wheel(const ViewportEvent& event) override { return note("wheel", event); }
    bool key(int key, Qt::KeyboardModifiers) override {
        keys.push_back(key);
        return takes;
    }
    void leave() override { ++left; }
    bool note(const char* what, const ViewportEvent& event) {
        seen.push_back(QString::fromLatin1(what));
        last = event;
        return takes;
    }
    QStringList seen;
    std::vector<int> keys;
    ViewportEvent last;
    bool takes = true;
    int left = 0;
};

double pixels(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

/// The camera and the pointer.
class TestViewport : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        rig_ = std::make_unique<fixture::ViewportWindow>();
        viewport_ = rig_->viewport;
        QTRY_VERIFY(rig_->ready());
        rig_->settle();
        QVERIFY(rig_->save("viewport-part"));
    }

    void init() {
        viewport_->setInteractiveTool(nullptr);
        viewport_->setStandardView(StandardView::isometric);
    }

    /// A preview stays until its part can be drawn, and is removed if another part comes first.
    void aPreviewGoesWithItsPart() {
        const std::shared_ptr<const Model> part = fixture::model(fixture::radii);
        ModelPreview coarse;
        for (const Body& body : part->bodies) coarse.bodies.push_back({body.name, {}, {{}, body.mesh.triangles}});
        for (std::size_t i = 0; i < part->bodies.size(); ++i)
            for (const glm::dvec3& vertex : part->bodies[i].mesh.vertices)
                coarse.bodies[i].mesh.vertices.emplace_back(vertex);
        const auto preview = std::make_shared<const ModelPreview>(std::move(coarse));
        viewport_->setPreview(preview);
        QTRY_VERIFY(viewport_->showsPreview());
        viewport_->setPreviewedPart(part);
        QVERIFY(viewport_->showsPreview());
        QTRY_VERIFY(!viewport_->showsPreview());

        viewport_->setPreview(preview);
        QTRY_VERIFY(viewport_->showsPreview());
        viewport_->setPreviewedPart(fixture::model(fixture::radii));
        viewport_->setPart(part); // as when a project is opened meanwhile
        QTRY_VERIFY(!viewport_->showsPreview());
        rig_->settle();
    }

    void sightAndProjectionAreInverse() {
        for (const QPoint& at : {QPoint(10, 10), QPoint(500, 350), QPoint(990, 20), QPoint(333, 600)}) {
            const ViewportEvent event = viewport_->sight(at);
            QVERIFY(std::abs(glm::length(event.rayDirection) - 1.0) < 1e-12);
            QVERIFY(pixels(viewport_->project(event.rayOrigin + 137.0 * event.rayDirection), at) < 1e-6);
        }
    }

    void orbitTurnsWithoutRolling() {
        const glm::dvec3 before = viewport_->sight({500.0, 350.0}).rayDirection;
        rig_->drag(Qt::RightButton, {500, 350}, {620, 300});
        const glm::dvec3 after = viewport_->sight({500.0, 350.0}).rayDirection;
        QVERIFY(glm::distance(before, after) > 0.2);
        // z still points up in the picture: two points above each other have the same column in the middle.
        const glm::dvec3 centre = stock.centre();
        const QPointF low = viewport_->project(centre), high = viewport_->project(centre + glm::dvec3(0.0, 0.0, 1.0));
        QVERIFY(high.y() < low.y());
        const ViewportEvent left = viewport_->sight({0.0, 350.0}), right = viewport_->sight({1000.0, 350.0});
        QVERIFY(std::abs(glm::normalize(left.rayDirection - right.rayDirection).z) < 1e-9);
    }

    void orbitKeepsThePlaceUnderThePointer() {
        const glm::dvec3 summit(0.0, 0.0, 14.0);
        const QPointF at = viewport_->project(summit);
        rig_->drag(Qt::MiddleButton, at.toPoint(), at.toPoint() + QPoint(90, 20));
        QVERIFY(pixels(viewport_->project(summit), at) < 3.0); // the pointer has whole pixels only
    }

    void panMovesThePlaceWithThePointer() {
        const glm::dvec3 summit(0.0, 0.0, 14.0);
        const QPoint at = viewport_->project(summit).toPoint();
        rig_->drag(Qt::MiddleButton, at, at + QPoint(70, -40), Qt::ShiftModifier);
        QVERIFY(pixels(viewport_->project(summit), at + QPoint(70, -40)) <= 2.0);
    }

    void zoomKeepsThePlaceUnderThePointer() {
        const glm::dvec3 summit(0.0, 0.0, 14.0);
        const QPointF at = viewport_->project(summit);
        const double before = pixels(viewport_->project({5.0, 0.0, 0.0}), viewport_->project({0.0, 0.0, 0.0}));
        rig_->wheel(at, 3);
        QVERIFY(pixels(viewport_->project(summit), at) <= 1.0);
        QVERIFY(pixels(viewport_->project({5.0, 0.0, 0.0}), viewport_->project({0.0, 0.0, 0.0})) > 1.3 * before);
        viewport_->fit();
        QVERIFY(std::abs(pixels(viewport_->project({5.0, 0.0, 0.0}), viewport_->project({0.0, 0.0, 0.0})) - before) <
                1e-6);
    }

    void standardViewsLookTheRightWay() {
        const auto along = [this](StandardView view) {
            viewport_->setStandardView(view);
            return viewport_->sight(QPointF(0.5 * viewport_->width(), 0.5 * viewport_->height())).rayDirection;
        };
        QVERIFY(glm::distance(along(StandardView::top), {0.0, 0.0, -1.0}) < 1e-9);
        QVERIFY(glm::distance(along(StandardView::front), {0.0, 1.0, 0.0}) < 1e-9);
        QVERIFY(glm::distance(along(StandardView::right), {-1.0, 0.0, 0.0}) < 1e-9);
        for (const Box& box : {stock})
            for (const glm::dvec3& corner : {box.low, box.high})
                QVERIFY(QRectF(viewport_->rect()).contains(viewport_->project(corner)));
    }

    void aClickOnTheCubeSetsItsView() {
        // The top face of the cube is the upper one in the isometric view.
        const QPoint top(viewport_->width() - 60, 40);
        QTest::mouseMove(viewport_, top);
        QVERIFY(rig_->save("viewport-cube"));
        QTest::mouseClick(viewport_, Qt::LeftButton, Qt::NoModifier, top);
        QVERIFY(glm::distance(viewport_->sight({500.0, 350.0}).rayDirection, glm::dvec3(0.0, 0.0, -1.0)) < 0.05);
    }

    void anActiveToolIsAskedFirst() {
        Recorder tool;
        viewport_->setInteractiveTool(&tool);
        const glm::dvec3 before = viewport_->sight({500.0, 350.0}).rayDirection;
        QTest::mousePress(viewport_, Qt::LeftButton, Qt::ShiftModifier, {400, 300});
        QCOMPARE(tool.last.button, Qt::LeftButton);
        QCOMPARE(tool.last.modifiers, Qt::ShiftModifier);
        QCOMPARE(tool.last.rayDirection, viewport_->sight({400.0, 300.0}).rayDirection);
        QTest::mouseRelease(viewport_, Qt::LeftButton, Qt::NoModifier, {400, 300});
        rig_->wheel({400.0, 300.0}, 2);
        QCOMPARE(tool.last.wheelSteps, 2.0);
        QCOMPARE(viewport_->sight({500.0, 350.0}).rayDirection, before);
        viewport_->setFocus();
        QTest::keyClick(viewport_, Qt::Key_Escape);
        QCOMPARE(tool.keys.back(), static_cast<int>(Qt::Key_Escape));
        tool.takes = false;
        rig_->drag(Qt::RightButton, {500, 350}, {560, 350});
        QVERIFY(viewport_->sight({500.0, 350.0}).rayDirection != before);
        viewport_->setInteractiveTool(nullptr);
        QCOMPARE(tool.left, 1);
    }

    void nothingIsDrawnInVain() {
        viewport_->setToolMarks(marksAt({6.0, -4.0, 20.0}));
        rig_->settle();
        QSignalSpy painted(viewport_, &Viewport::painted);
        for (int i = 0; i < 10; ++i) {
            viewport_->setToolMarks(marksAt({6.0, -4.0, 20.0})); // the same marks again
            QTest::qWait(50);
        }
        QCOMPARE(painted.count(), 0);
    }

    /// As when a notice that covered the view disappears: the picture is shown again.
    void whatWasCoveredForAMomentIsNotDrawnAgain() {
        rig_->settle();
        const QImage before = rig_->window->grab().toImage();
        QSignalSpy painted(viewport_, &Viewport::painted);
        {
            QWidget cover(viewport_);
            cover.setGeometry(300, 200, 300, 200);
            cover.setAutoFillBackground(true);
            cover.show();
            QTest::qWait(50);
            QVERIFY(rig_->window->grab().toImage() != before);
        }
        QTest::qWait(50);
        QCOMPARE(painted.count(), 0);
        QCOMPARE(rig_->window->grab().toImage(), before);
    }

    void manyChangesMakeOnePaint() {
        QSignalSpy painted(viewport_, &Viewport::painted);
        for (int i = 0; i < 50; ++i) viewport_->setToolMarks(marksAt({0.1 * i, -4.0, 20.0}));
        QTRY_VERIFY(painted.count() > 0);
        QVERIFY(painted.count() <= 2);
        rig_->settle();
    }

    void cleanupTestCase() { rig_.reset(); }

private:
    std::unique_ptr<fixture::ViewportWindow> rig_;
    Viewport* viewport_ = nullptr;
};

BURIN_TEST(TestViewport, QApplication)

} // namespace burin::tst_viewport

#include "tst_viewport.moc"
