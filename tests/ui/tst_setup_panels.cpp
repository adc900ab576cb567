// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/panel_examples.h"
#include "tests/ui/panel_rig.h"
#include "ui/panels/allowance_panel.h"
#include "ui/panels/embedding_findings.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/notice.h"
#include "ui/panels/part_panel.h"
#include "ui/panels/stock_panel.h"
#include "ui/panels/tool_panel.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QToolTip>

#include <functional>

namespace burin::tst_setup_panels {

class TestSetupPanels : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale(QStringLiteral("en_US")));
        applyTheme(*qApp, *loadPalette(Theme::dark));
    }

    void thePartIsShown() {
        PartPanel panel;
        panel.setState({});
        show(panel);
        QSignalSpy asked(&panel, &PartPanel::importRequested);
        click(panel, "importButton");
        QCOMPARE(asked.size(), 1);
        panel.setState({nullptr, true});
        click(panel, "importButton");
        QCOMPARE(asked.size(), 1); // cannot be requested twice at once
        panel.setState(examples::part());
        auto& bodies = child<RowList>(panel, "bodyList");
        QCOMPARE(bodies.count(), 2);
        QCOMPARE(bodies.rows()[0].title, QStringLiteral("Shell"));
        QCOMPARE(plain(bodies.rows()[0].value), QStringLiteral("84.5 cm³"));
        QVERIFY(bodies.rows()[1].detail.contains(QStringLiteral("3 open edges")));
        QCOMPARE(bodies.rows()[1].icon, QStringLiteral("warning"));
        QVERIFY(bodies.item(1)->data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("3 open edges")));
        QCOMPARE(child<RowList>(panel, "noteList").count(), 3);
        panel.setUnit(LengthUnit::inch);
        QCOMPARE(plain(bodies.rows()[0].value), QStringLiteral("5.16 in³"));
    }

    /// The text is elided with "…", so it begins as it would with more room.
    void aSecondLineWithoutRoomIsWholeInTheTooltip() {
        PartPanel panel;
        const auto shown = [&panel](std::uint32_t faces) {
            Model model = *examples::part().model;
            model.bodies[0].openEdges = 12345;
            model.bodies[0].box = {{0.0, 0.0, 0.0}, {1234.567, 2345.678, 345.678}};
            model.bodies[0].faceCount = faces;
            panel.setState({std::make_shared<const Model>(std::move(model)), false});
            return panel.grab().toImage();
        };
        shown(1);
        show(panel);
        auto& list = child<RowList>(panel, "bodyList");
        const QString& detail = list.rows()[0].detail;
        const QRect row = list.visualItemRect(list.item(0));
        QVERIFY(list.fontMetrics().horizontalAdvance(detail) > row.width());
        QHelpEvent rest(QEvent::ToolTip, row.center(), list.viewport()->mapToGlobal(row.center()));
        QApplication::sendEvent(list.viewport(), &rest);
        QVERIFY2(QToolTip::text().contains(detail), qPrintable(QToolTip::text()));
        QToolTip::hideText();
        const QRect begins(list.viewport()->mapTo(&panel, row.topLeft()), QSize(row.width() / 2, row.height()));
        const QImage one = shown(1).copy(begins), many = shown(123456).copy(begins);
        QVERIFY(one == many);
    }

    /// The file's unit, whether stated or not, can be replaced.
    void theUnitOfAFileIsChosen() {
        PartPanel panel;
        auto model = std::make_shared<Model>(*examples::part().model);
        model->format = "STL binary";
        model->lengthUnit = "none";
        panel.setState({model, false});
        show(panel);
        auto& unit = child<QComboBox>(panel, "fileUnit");
        QVERIFY(unit.isVisible());
        QCOMPARE(unit.currentText(), QStringLiteral("mm"));
        std::vector<double> chosen;
        connect(&panel, &PartPanel::fileUnitChosen, this,
                [&chosen](double millimetres) { chosen.push_back(millimetres); });
        unit.setFocus();
        QTest::keyClick(&unit, Qt::Key_Down);
        QCOMPARE(chosen, std::vector<double>{25.4});
        QCOMPARE(unit.currentText(), QStringLiteral("mm")); // until the file has been read again
        model = std::make_shared<Model>(*model);
        model->unitScale = 3.175; // the command line accepts any scale
        panel.setState({model, false});
        QCOMPARE(unit.currentText(), QStringLiteral("3.175 mm"));
        const auto shownTexts = [&] {
            QStringList texts;
            for (const QLabel* label : panel.findChildren<QLabel*>())
                if (label->isVisible()) texts << label->text();
            return texts;
        };
        QVERIFY(!shownTexts().contains("Size as stated"));
        model = std::make_shared<Model>(*model);
        model->format = "STEP AP214";
        model->lengthUnit = "inch";
        model->statedUnit = 25.4;
        model->unitScale = 1.0;
        panel.setState({model, false});
        QCOMPARE(unit.currentText(), QStringLiteral("mm"));
        QVERIFY(unit.findText("inch (stated)") >= 0 && unit.findText("3.175 mm") < 0);
        QVERIFY(shownTexts().contains("Size as stated"));
    }

    void marginsAndVoxelsAreEdited() {
        StockPanel panel;
        panel.setState(examples::stock());
        show(panel);
        std::vector<Setup> setups;
        connect(&panel, &StockPanel::setupEdited, this, [&setups](const Setup& setup) { setups.push_back(setup); });
        type(panel, "sideMarginField", "7,5");
        QCOMPARE(setups.size(), std::size_t{1});
        QCOMPARE(setups[0].marginLow, glm::dvec3(7.5, 7.5, 2.0));
        QCOMPARE(setups[0].marginHigh, glm::dvec3(7.5, 7.5, 1.0));
        type(panel, "topMarginField", "3");
        type(panel, "bottomMarginField", "0.1in");
        type(panel, "voxelField", "0.5");
        QCOMPARE(setups.size(), std::size_t{4});
        // Each entry builds on the previous ones, although setState was not called in between.
        QCOMPARE(setups[3].marginHigh, glm::dvec3(7.5, 7.5, 3.0));
        QCOMPARE(setups[3].marginLow.x, 7.5);
        QVERIFY(std::abs(setups[3].marginLow.z - 2.54) < 1e-9);
        QCOMPARE(setups[3].voxel, 0.5);
        QVERIFY(child<QLabel>(panel, "voxelCount")
                    .accessibleName()
                    .startsWith(QStringLiteral("480 × 280 × 180 voxels = 24.2")));
        QCOMPARE(valueOf(panel, "stockSize"), QStringLiteral("120 × 70 × 45 mm"));
    }

    void embeddingNeedsAReasonNotTo() {
        StockPanel panel;
        QSignalSpy embed(&panel, &StockPanel::embedRequested);
        const StockState ready = examples::stock();
        StockState state = ready;
        panel.setState(state);
        show(panel);
        click(panel, "embedButton");
        QCOMPARE(embed.size(), 1);
        const auto refuses = [&](auto change, const char* reason) {
            state = ready;
            change(state);
            panel.setState(state);
            click(panel, "embedButton");
            auto& button = child<QPushButton>(panel, "embedButton");
            return embed.size() == 1 && !button.isEnabled() && button.toolTip().contains(QLatin1String(reason));
        };
        QVERIFY(refuses([](StockState& s) { s.hasPart = false; }, "Import"));
        QVERIFY(refuses([](StockState& s) { s.busy = true; }, "under way"));
        QVERIFY(refuses([](StockState& s) { s.locked = true; }, "takes"));
        QVERIFY(refuses([](StockState& s) { s.embedded = true; }, "matches"));
        QVERIFY(refuses([](StockState& s) { s.problem = QStringLiteral("Too large."); }, "Too large."));
        QCOMPARE(child<Notice>(panel, "stockNotice").sentence(), QStringLiteral("Too large."));
        QCOMPARE(child<Notice>(panel, "stockNotice").kind(), Notice::Kind::error);
    }

    /// In the displayed unit; if there are hundreds of findings, the first ones.
    void whatEmbeddingFoundIsTold() {
        StockPanel panel;
        EmbeddingFindings whole;
        StockState state = examples::stock();
        state.embedded = true;
        const auto find = [&](std::vector<EmbeddingFinding> findings) {
            state.findings = std::move(findings);
            panel.setState(state);
            whole.setFindings(state.findings);
        };
        find({});
        show(panel);
        auto& notice = child<Notice>(whole, "findingsNotice");
        const auto& summary = child<Notice>(panel, "stockNotice");
        QVERIFY(whole.isHidden());
        QCOMPARE(summary.kind(), Notice::Kind::passed);
        EmbeddingFinding open;
        open.body = "Torn";
        open.count = 1400;
        open.openEdges = 4;
        open.rims = 1;
        open.place = {{0.0, -2.5, 0.0}, {25.4, 10.0, 10.0}};
        EmbeddingFinding tiny;
        tiny.kind = EmbeddingFinding::Kind::tooSmall;
        tiny.body = "Pin";
        find({open, tiny});
        QVERIFY(whole.isVisible());
        QCOMPARE(notice.kind(), Notice::Kind::warning);
        QCOMPARE(plain(notice.sentence()),
                 QStringLiteral("The surface of “Torn” is open (edges: 4, rims: 1), so its inside is uncertain "
                                "there (scanlines: 1,400; X 0.000 to 25.400 mm; Y -2.500 to 10.000 mm; Z 0.000 to "
                                "10.000 mm); close it in the CAD program.\n“Pin” is too small for the voxels, so "
                                "nothing of it is protected; choose smaller voxels."));
        QCOMPARE(summary.kind(), Notice::Kind::warning);
        QVERIFY2(summary.sentence().contains(QStringLiteral("2 findings")), qPrintable(summary.sentence()));
        whole.setUnit(LengthUnit::inch);
        QVERIFY(plain(notice.sentence()).contains(QStringLiteral("X 0.0000 to 1.0000 in;")));
        find(std::vector(300, tiny));
        QCOMPARE(notice.sentence().count(QLatin1Char('\n')), 4);
        QVERIFY(notice.sentence().contains(QStringLiteral("And 296 more")));
        find({tiny});
        QVERIFY2(summary.sentence().contains(QStringLiteral("1 finding.")), qPrintable(summary.sentence()));
    }

    /// Nor does anything below the panel on its page move.
    void whatTheStockPanelTellsMovesNothing() {
        StockPanel panel;
        const StockState quiet = examples::stock();
        panel.setState(quiet);
        show(panel);
        const auto before = controlsOf(panel);
        const int height = panel.heightForWidth(panelWidth);
        QCOMPARE(before.size(), std::size_t{8}); // shape, two switches, three margins, voxel, button
        const std::function<void(StockState&)> changes[] = {
            [](StockState& state) { state.embedded = true; },
            [](StockState& state) {
                state.embedded = true;
                state.findings = std::vector(7, EmbeddingFinding{});
            },
            [](StockState& state) { state.locked = true; },
            [](StockState& state) { state.problem = QStringLiteral("The stock is far too large. ").repeated(9); },
            [](StockState& state) { state.setup.marginLow.x = 1.0; },
            [](StockState& state) { state.size.reset(); },
            [](StockState& state) {
                state.size = EmbeddingSize{{4, 4, 4}, 0.1};
            },
            [](StockState& state) {
                state.size = EmbeddingSize{{20480, 12800, 11800}, 123456.0};
            },
            [](StockState& state) { state.hasPart = false; }};
        for (const auto& change : changes) {
            StockState state = quiet;
            change(state);
            panel.setState(state);
            QVERIFY(controlsOf(panel) == before);
            QCOMPARE(panel.heightForWidth(panelWidth), height);
            const auto& voxels = child<QLabel>(panel, "voxelCount");
            QVERIFY(voxels.heightForWidth(voxels.width()) <= voxels.height());
        }
    }

    void marginsThatDifferAreTold() {
        StockPanel panel;
        StockState state = examples::stock();
        state.setup.marginLow.x = 2.0;
        panel.setState(state);
        show(panel);
        const QString told = plain(child<Notice>(panel, "sideMarginNotice").sentence());
        QVERIFY2(told.contains(QStringLiteral("2.000 mm to 5.000 mm")), qPrintable(told));
        QSignalSpy edited(&panel, &StockPanel::setupEdited);
        type(panel, "sideMarginField", "4");
        QCOMPARE(edited[0][0].value<Setup>().marginLow, glm::dvec3(4.0, 4.0, 2.0));
    }

    void materialsAreChosen() {
        MaterialPanel panel;
        panel.setState(examples::material());
        show(panel);
        QStringList stock, bodies;
        connect(&panel, &MaterialPanel::stockMaterialChosen, this,
                [&stock](const std::string& id) { stock.append(QString::fromStdString(id)); });
        connect(&panel, &MaterialPanel::bodyMaterialChosen, this, [&bodies](std::size_t body, const std::string& id) {
            bodies.append(QString::number(body) + QLatin1Char(' ') + QString::fromStdString(id));
        });
        auto& values = child<RowList>(panel, "materialValues");
        QCOMPARE(static_cast<std::size_t>(values.count()), loadMaterial("aluminium-6061")->values.size());
        const auto figure = [&values](const QString& title) {
            for (const ListRow& row : values.rows())
                if (row.title == title) return row;
            return ListRow{};
        };
        QCOMPARE(QString(figure(QStringLiteral("Density")).value).replace(QChar(QChar::Nbsp), QLatin1Char(' ')),
                 QStringLiteral("2.7 g/cm³"));
        QVERIFY(figure(QStringLiteral("Density")).badge.isEmpty());
        QCOMPARE(figure(QStringLiteral("Plunge feed ratio")).badge, QStringLiteral("estimate"));
        QVERIFY(child<Notice>(panel, "estimateNotice").isVisible());
        clickRow(panel, "materialValues", 1); // its source can be read in full
        QCOMPARE(child<QLabel>(panel, "valueSource").accessibleName(), values.rows()[1].toolTip);

        const auto pick = [&panel](const char* name, int down) {
            auto& choice = child<QComboBox>(panel, name);
            choice.setFocus();
            for (int i = 0; i < std::abs(down); ++i) QTest::keyClick(&choice, down > 0 ? Qt::Key_Down : Qt::Key_Up);
        };
        pick("stockMaterial", 1);
        QCOMPARE(stock, QStringList{"aluminium-7075"}); // the next material in the list
        pick("body", 1);
        QCOMPARE(child<QComboBox>(panel, "bodyMaterial").currentData().toString(), QStringLiteral("machinable-wax"));
        pick("bodyMaterial", -1);
        QTest::keyClick(&child<QComboBox>(panel, "bodyMaterial"), Qt::Key_Home); // "Same as the stock" is the first one
        QCOMPARE(bodies, (QStringList{"1 brass-cuzn39pb3", "1 "}));
        QCOMPARE(stock.size(), 1);
    }

    void toolsThatMilledAreMarked() {
        ToolPanel panel;
        ToolState state = examples::tool();
        state.ofTakes = {"ball-6", "flat-10", "ball-6"};
        panel.setState(state);
        show(panel);
        const auto& rows = child<RowList>(panel, "toolList").rows();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string& id = state.tools[i].id;
            QCOMPARE(rows[i].badge, id == "ball-6" || id == "flat-10" ? QStringLiteral("milled") : QString());
            QCOMPARE(rows[i].toolTip.contains(QStringLiteral("\n2 takes were")), id == "ball-6");
            QCOMPARE(rows[i].toolTip.contains(QStringLiteral("\n1 take was")), id == "flat-10");
        }
    }

    /// A dozen tools in a high window; in a low one some tools and the rest of the panel.
    void theToolListTakesTheRoomThatThereIs() {
        QScrollArea page;
        auto* panel = new ToolPanel;
        page.setWidget(panel);
        page.setWidgetResizable(true);
        ToolState dozen = examples::tool();
        dozen.tools.resize(12);
        panel->setState(dozen);
        auto& list = child<RowList>(*panel, "toolList");
        const auto rowsSeen = [&] {
            int seen = 0;
            for (int i = 0; i < list.count(); ++i)
                seen += list.viewport()->rect().contains(list.visualItemRect(list.item(i))) ? 1 : 0;
            return seen;
        };
        page.resize(344, 1400);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        QTRY_COMPARE(rowsSeen(), list.count());
        QVERIFY(list.count() > 10);
        page.resize(344, 400);
        QTRY_COMPARE(rowsSeen(), 6);
    }

    void aToolIsChosen() {
        ToolPanel panel;
        panel.setState(examples::tool());
        show(panel);
        QStringList chosen;
        connect(&panel, &ToolPanel::toolChosen, this,
                [&chosen](const std::string& id) { chosen.append(QString::fromStdString(id)); });
        QCOMPARE(valueOf(panel, "toolDiameter"), QStringLiteral("10.000 mm"));
        QCOMPARE(valueOf(panel, "feed"), QStringLiteral("1,528 mm/min"));
        auto& list = child<RowList>(panel, "toolList");
        const int first = list.currentRow() + 1;
        clickRow(panel, "toolList", first);
        QTest::keyClick(&list, Qt::Key_Up);
        QCOMPARE(chosen,
                 (QStringList{QString::fromStdString(toolIds()[static_cast<std::size_t>(first)]), "bull-10-r2"}));
        clickRow(panel, "toolList", list.currentRow());
        QCOMPARE(chosen.size(), 2); // it is already the current tool
        ToolState locked = examples::tool();
        locked.locked = true;
        panel.setState(locked);
        clickRow(panel, "toolList", first);
        QCOMPARE(chosen.size(), 2);
    }

    void theAllowanceIsEdited() {
        AllowancePanel panel;
        panel.setState({0.3, 5.0, false});
        show(panel);
        QSignalSpy edited(&panel, &AllowancePanel::allowanceEdited);
        type(panel, "allowanceField", "0.5");
        type(panel, "allowanceField", "9"); // more than is possible: the field refuses it and says so
        QCOMPARE(edited.size(), 1);
        QCOMPARE(edited[0][0].toDouble(), 0.5);
        QCOMPARE(child<QDoubleSpinBox>(panel, "allowanceField").value(), 0.5);
        panel.setState({0.5, 5.0, true});
        QVERIFY(!child<QWidget>(panel, "allowanceField").isEnabled());
    }

    void typingIsLeftAloneByTheState() {
        StockPanel panel;
        panel.setState(examples::stock());
        show(panel);
        auto& field = child<QDoubleSpinBox>(panel, "topMarginField");
        QSignalSpy edited(&panel, &StockPanel::setupEdited);
        field.setFocus(Qt::TabFocusReason);
        field.selectAll();
        QTest::keyClicks(&field, QStringLiteral("1"));
        StockState news = examples::stock();
        for (int i = 0; i < 5; ++i) {
            news.size->megabytes += 1.0;
            panel.setState(news);
            QTest::keyClicks(&field, QString::number(i));
        }
        QVERIFY(field.hasFocus());
        QVERIFY2(field.text().startsWith(QStringLiteral("101234")), qPrintable(field.text()));
        QCOMPARE(edited.size(), 0);
        QTest::keyClick(&field, Qt::Key_Escape);
        QCOMPARE(field.value(), 1.0);
    }

    void tabGoesFromTopToBottom() {
        StockPanel panel;
        panel.setState(examples::stock());
        show(panel);
        child<QWidget>(panel, "sideMarginField").setFocus(Qt::TabFocusReason);
        QStringList passed;
        for (int i = 0; i < 5; ++i) {
            passed.append(QApplication::focusWidget()->objectName());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        QCOMPARE(passed,
                 (QStringList{"sideMarginField", "topMarginField", "bottomMarginField", "voxelField", "embedButton"}));
    }
};

BURIN_TEST(TestSetupPanels, QApplication)

} // namespace burin::tst_setup_panels

#include "tst_setup_panels.moc"
