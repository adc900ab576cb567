// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "tests/test_program.h"
#include "tests/ui/panel_rig.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/guide_panel.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

namespace burin::tst_guide_panel {

namespace {

Guide guideOf(GuideKind kind) {
    Guide guide;
    guide.kind = kind;
    guide.on = true;
    return guide;
}

GuideState threeGuides() {
    GuideState state;
    state.guides = {guideOf(GuideKind::levels), guideOf(GuideKind::plane), guideOf(GuideKind::axis)};
    state.guides[0].distance = 1.5;
    state.guides[0].point = {10, 20, 40};
    state.guides[1].direction = {1, 0, 0};
    state.guides[1].point = {7, 0, 0};
    state.guides[2].lead = 10.0 * pi / 180.0;
    state.zero = {5, 0, 40};
    return state;
}

} // namespace

class TestGuidePanel : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale(QStringLiteral("en_US")));
        applyTheme(*qApp, *loadPalette(Theme::dark));
    }

    void guidesAreAddedSwitchedAndRemoved() {
        GuidePanel panel;
        panel.setState(threeGuides());
        show(panel);
        QSignalSpy wanted(&panel, &GuidePanel::guideRequested), toggled(&panel, &GuidePanel::guidesToggled),
            removed(&panel, &GuidePanel::guideRemovalRequested);
        std::vector<std::pair<std::size_t, Guide>> edits;
        connect(&panel, &GuidePanel::guideEdited, this,
                [&](std::size_t place, const Guide& guide) { edits.emplace_back(place, guide); });
        child<ChoiceBox>(panel, "guideKind").setCurrentIndex(4);
        click(panel, "addGuideButton");
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(qvariant_cast<GuideKind>(wanted[0][0]), GuideKind::surface);
        QTest::mouseClick(&child<QCheckBox>(panel, "guide1Switch"), Qt::LeftButton, {}, QPoint(8, 8));
        QCOMPARE(edits.size(), std::size_t{1});
        QCOMPARE(edits[0].first, std::size_t{1});
        QVERIFY(!edits[0].second.on);
        click(panel, "guide2Remove");
        QCOMPARE(removed.size(), 1);
        QTest::mouseClick(&child<QCheckBox>(panel, "guidesSwitch"), Qt::LeftButton, {}, QPoint(8, 8));
        QCOMPARE(toggled.size(), 1);
        QCOMPARE(toggled[0][0].toBool(), false);
        child<ChoiceBox>(panel, "guideKind").setCurrentIndex(3); // an edge, which a mesh does not have
        QVERIFY(!child<QPushButton>(panel, "addGuideButton").isEnabled());
        GuideState solid = threeGuides();
        solid.edges = true;
        panel.setState(solid);
        click(panel, "addGuideButton");
        QCOMPARE(qvariant_cast<GuideKind>(wanted[1][0]), GuideKind::curve);
        GuideState full = threeGuides();
        full.full = true;
        panel.setState(full);
        QVERIFY(!child<QPushButton>(panel, "addGuideButton").isEnabled());
    }

    void placesAreShownFromProgramZero() {
        GuidePanel panel;
        panel.setState(threeGuides());
        show(panel);
        std::vector<std::pair<std::size_t, Guide>> edits;
        connect(&panel, &GuidePanel::guideEdited, this,
                [&](std::size_t place, const Guide& guide) { edits.emplace_back(place, guide); });
        QCOMPARE(child<QDoubleSpinBox>(panel, "guide0Distance").value(), 1.5);
        QCOMPARE(child<QDoubleSpinBox>(panel, "guide0Z").value(), 0.0);
        QVERIFY(!child<QDoubleSpinBox>(panel, "guide0X").isVisible()); // has no meaning for a level
        QCOMPARE(child<QDoubleSpinBox>(panel, "guide1X").value(), 2.0);
        type(panel, "guide1X", "3.5");
        QCOMPARE(edits.back().first, std::size_t{1});
        QCOMPARE(edits.back().second.point.x, 8.5);
        QCOMPARE(plain(child<QDoubleSpinBox>(panel, "guide2Lead").text()), QStringLiteral("10 °"));
        type(panel, "guide2Tilt", "-5");
        QVERIFY(std::abs(edits.back().second.tilt + 5.0 * pi / 180.0) < 1e-9); // a field keeps nine decimals
        auto& direction = child<ChoiceBox>(panel, "guide1Direction");
        emit direction.activated(1);
        QCOMPARE(edits.back().second.direction, glm::dvec3(0, 1, 0));
        QVERIFY(child<QDoubleSpinBox>(panel, "guide1Y").isVisible());
        QVERIFY(!child<QDoubleSpinBox>(panel, "guide1X").isVisible());
    }

    void whatHoldsIsTold() {
        GuidePanel panel;
        GuideState state = threeGuides();
        panel.setState(state);
        show(panel);
        QVERIFY(child<QLabel>(panel, "guide0News").text().isEmpty());
        QVERIFY(!child<QPushButton>(panel, "levelBelowButton").isEnabled());
        state.live = true;
        state.news[0] = {GuideNews::Is::holding, -2, 0.1};
        state.news[1] = {GuideNews::Is::overruled, 0, 0.0};
        panel.setState(state);
        QCOMPARE(child<QLabel>(panel, "guide0News").text(), QStringLiteral("active on level -2"));
        QCOMPARE(child<QLabel>(panel, "guide1News").text(), QStringLiteral("waits for another"));
        QSignalSpy stepped(&panel, &GuidePanel::levelStepped);
        click(panel, "levelBelowButton");
        click(panel, "levelAboveButton");
        QCOMPARE(stepped.size(), 2);
        QCOMPARE(stepped[0][0].toInt(), -1);
        QCOMPARE(stepped[1][0].toInt(), 1);
    }
};

BURIN_TEST(TestGuidePanel, QApplication)

} // namespace burin::tst_guide_panel

#include "tst_guide_panel.moc"
