// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/panel_examples.h"
#include "tests/ui/panel_rig.h"
#include "ui/panels/deviation_card.h"
#include "ui/panels/deviation_legend.h"
#include "ui/panels/edit_parameters.h"
#include "ui/panels/load_chart.h"
#include "ui/panels/notice.h"
#include "ui/panels/path_panel.h"
#include "ui/panels/program_labels.h"
#include "ui/panels/program_panel.h"
#include "ui/panels/program_text.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTextBlock>
#include <QToolButton>

#include <functional>

namespace burin::tst_path_panels {

class TestPathPanels : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale(QStringLiteral("en_US")));
        applyTheme(*qApp, *loadPalette(Theme::dark));
    }

    void editsAreChanged() {
        PathPanel panel;
        panel.setState(examples::path());
        show(panel);
        std::vector<std::pair<std::size_t, Edit>> changed;
        connect(&panel, &PathPanel::editChanged, this,
                [&changed](std::size_t index, const Edit& edit) { changed.emplace_back(index, edit); });
        type(panel, "edit2_tolerance_mm", "0.05");
        QCOMPARE(changed.size(), std::size_t{1});
        QCOMPARE(changed[0].first, std::size_t{2});
        QCOMPARE(std::get<SmoothShape>(changed[0].second.parameters).tolerance, 0.05);
        QCOMPARE(std::get<SmoothShape>(changed[0].second.parameters).wavelength, 3.0);
        QTest::mouseClick(&child<QCheckBox>(panel, "edit1Switch"), Qt::LeftButton, {}, {10, 10});
        QCOMPARE(changed.size(), std::size_t{2});
        QCOMPARE(changed[1].first, std::size_t{1});
        QVERIFY(changed[1].second.enabled);
        QVERIFY(child<QLabel>(panel, "edit2Report").text().contains(QStringLiteral("0.018")));
        QVERIFY(child<QLabel>(panel, "edit1Report").text().trimmed().isEmpty()); // it was switched off
        QCOMPARE(valueOf(panel, "pathErrorBudget"), QStringLiteral("0.033 mm"));
        QCOMPARE(valueOf(panel, "pathSides"), QStringLiteral("62 % / 31 %"));
        QCOMPARE(valueOf(panel, "pathPoints"), QStringLiteral("12,408"));
        QCOMPARE(valueOf(panel, "pathLength"), QStringLiteral("8,422 mm"));
    }

    /// Neither the results of an evaluation nor another tool that has milled moves anything.
    void whatComesOfAPathMovesNothing() {
        PathPanel panel;
        PathState quiet = examples::path();
        quiet.outdated = false;
        quiet.reports.clear();
        quiet.points = 0;
        quiet.milled = {{"ball-6", QStringLiteral("Ball-end mill 6 mm")}};
        quiet.tool = quiet.milled.front();
        panel.setState(quiet);
        show(panel);
        const auto before = controlsOf(panel);
        QVERIFY(before.size() > 20);
        const PathState told = examples::path();
        PathState state = quiet;
        state.milled.push_back({"flat-10", QStringLiteral("Flat end mill 10 mm")});
        panel.setState(state);
        QVERIFY(controlsOf(panel) == before);
        QVERIFY(child<QWidget>(panel, "pathTool").isEnabled());
        state.reports = told.reports;
        state.points = told.points;
        panel.setState(state);
        QVERIFY(controlsOf(panel) == before);
        QVERIFY(child<QLabel>(panel, "edit2Report").text().contains(QStringLiteral("0.018")));
        state.problem = QStringLiteral("Nothing is left of the path. ").repeated(9);
        panel.setState(state);
        QVERIFY(controlsOf(panel) == before);
        // The button that adds edits stays under the pointer that pressed it.
        const QWidget& add = child<QWidget>(panel, "addEditButton");
        state.path.edits.push_back(state.path.edits.front());
        panel.setState(state);
        QCOMPARE(controlsOf(panel)[&add], before.at(&add));
    }

    /// The edit's card says how much was left out, and its tooltip where; the panel says what to do about the longest
    /// part.
    void whatIsLeftOutIsSaidWhereItWasLeftOut() {
        PathPanel panel;
        PathState state = examples::path();
        state.outdated = false;
        state.zero = {10.0, 0.0, 0.0};
        panel.setState(state);
        show(panel);
        const auto before = controlsOf(panel);
        QVERIFY(!child<Notice>(panel, "pathNotice").isVisible());
        EditReport& link = state.reports[4];
        link.omissions = {{OmissionReason::holder, 1, 5, 9, {{1.0, 0.0, 0.0}, {1.5, 0.0, 0.0}}, 0.5},
                          {OmissionReason::shank, 2, 0, 70, {{12.5, -3.0, -8.0}, {14.5, -3.0, -8.0}}, 2.0}};
        panel.setState(state);
        QVERIFY(controlsOf(panel) == before);
        const auto plain = [](QString text) { return text.replace(QChar(QChar::Nbsp), QLatin1Char(' ')); };
        const auto& report = child<QLabel>(panel, "edit5Report");
        QVERIFY2(plain(report.text()).startsWith(QStringLiteral("2.500 mm left out")), qPrintable(report.text()));
        const QStringList lines = plain(report.toolTip()).split(QLatin1Char('\n'));
        QCOMPARE(lines.size(), 2);
        QVERIFY2(lines[0].startsWith(QStringLiteral("2.000 mm from X 2.500, Y -3.000, Z -8.000: The shank")),
                 qPrintable(lines[0]));
        QVERIFY(lines[1].contains(QStringLiteral("The holder")));
        QVERIFY(child<QLabel>(panel, "edit3Report").toolTip().isEmpty());
        const auto& notice = child<Notice>(panel, "pathNotice");
        QCOMPARE(notice.kind(), Notice::Kind::warning);
        QVERIFY2(plain(notice.sentence()).startsWith(QStringLiteral("2.500 mm of the path")) &&
                     notice.sentence().contains(QStringLiteral("longer flutes")),
                 qPrintable(notice.sentence()));
        link.omissions.clear();
        panel.setState(state);
        QVERIFY(notice.sentence().isEmpty());
        QVERIFY(report.toolTip().isEmpty());
    }

    void entriesIntoMaterialAreSaidInTheCard() {
        PathPanel panel;
        PathState state = examples::path();
        state.outdated = false;
        state.zero = {10.0, 0.0, 0.0};
        state.reports[4].entries = {{EntryForm::ramp, 1, 5, {0.0, 0.0, -2.0}, 2.0},
                                    {EntryForm::plunge, 1, 70, {12.5, -3.0, -8.0}, 3.25},
                                    {EntryForm::ramp, 1, 90, {0.0, 5.0, -2.0}, 2.0}};
        panel.setState(state);
        show(panel);
        const auto plain = [](QString text) { return text.replace(QChar(QChar::Nbsp), QLatin1Char(' ')); };
        const auto& report = child<QLabel>(panel, "edit5Report");
        QVERIFY2(plain(report.text()).startsWith(QStringLiteral("plunges 1 · ramps 2")), qPrintable(report.text()));
        QVERIFY2(
            plain(report.toolTip()).startsWith(QStringLiteral("Plunge of 3.250 mm to X 2.500, Y -3.000, Z -8.000")),
            qPrintable(report.toolTip()));
    }

    void aLevelIsMeasuredAsItsGoalIs() {
        PathPanel panel;
        PathState state = examples::path();
        state.path.edits = {Edit{FeedOptimisation{.goal = FeedOptimisation::Goal::force, .target = 40.0}}};
        panel.setState(state);
        show(panel);
        const auto target = [&](const char* name) {
            const auto& field = child<QDoubleSpinBox>(panel, name);
            return field.cleanText() + field.suffix().simplified();
        };
        QCOMPARE(target("edit0_target_n"), QStringLiteral("40N"));
        state.path.edits = {Edit{FeedOptimisation{.goal = FeedOptimisation::Goal::removal, .target = 40.0}}};
        panel.setState(state);
        QCOMPARE(target("edit0_target_n"), QStringLiteral("40mm³/s")); // the field stays, as the user may be in it
        std::vector<Edit> changed;
        connect(&panel, &PathPanel::editChanged, this,
                [&changed](std::size_t, const Edit& edit) { changed.push_back(edit); });
        type(panel, "edit0_target_n", "50");
        QCOMPARE(changed.size(), std::size_t{1});
        QCOMPARE(std::get<FeedOptimisation>(changed[0].parameters).target, 50.0);
    }

    /// Positions are relative to program zero, as for the tip's position and the numbers of the program.
    void placesCountFromProgramZero() {
        PathPanel panel;
        PathState state = examples::path();
        state.zero = {70.0, 16.0, 34.0};
        RemoveArea area;
        area.low = 20.0;
        area.high = 40.0;
        Rotate rotate;
        rotate.centre = {72.0, 15.0, 34.0};
        Mirror mirror;
        mirror.across = Mirror::Across::y;
        mirror.at = 26.0;
        state.path.edits = {Edit{area}, Edit{rotate}, Edit{mirror}};
        panel.setState(state);
        show(panel);
        const auto shown = [&](const char* name) { return child<QDoubleSpinBox>(panel, name).cleanText(); };
        QCOMPARE(shown("edit0_low_mm"), QStringLiteral("-14.000"));
        QCOMPARE(shown("edit0_high_mm"), QStringLiteral("6.000"));
        QCOMPARE(shown("edit1_centre_mmX"), QStringLiteral("2.000"));
        QCOMPARE(shown("edit1_centre_mmY"), QStringLiteral("-1.000"));
        QCOMPARE(shown("edit2_at_mm"), QStringLiteral("10.000"));
        std::vector<Edit> changed;
        connect(&panel, &PathPanel::editChanged, this,
                [&changed](std::size_t, const Edit& edit) { changed.push_back(edit); });
        type(panel, "edit0_low_mm", "-5");
        type(panel, "edit1_centre_mmX", "0");
        type(panel, "edit2_at_mm", "1");
        QCOMPARE(changed.size(), std::size_t{3});
        QCOMPARE(std::get<RemoveArea>(changed[0].parameters).low, 29.0);
        QCOMPARE(std::get<Rotate>(changed[1].parameters).centre, glm::dvec3(70.0, 15.0, 34.0));
        QCOMPARE(std::get<Mirror>(changed[2].parameters).at, 17.0);
    }

    void aPathIsMadeAndUpdated() {
        PathPanel panel;
        QSignalSpy made(&panel, &PathPanel::newPathRequested), update(&panel, &PathPanel::evaluateRequested),
            seen(&panel, &PathPanel::visibilityToggled);
        PathState state;
        panel.setState(state);
        show(panel);
        click(panel, "newPathButton"); // no take yet
        QCOMPARE(made.size(), 0);
        state.milled = {{"flat-10", QStringLiteral("End mill 10 mm")}}; // another tool is in use
        state.someWithoutPath = true;
        panel.setState(state);
        click(panel, "newPathButton");
        QCOMPARE(made.size(), 1);
        state.hasTakes = true;
        panel.setState(state);
        click(panel, "newPathButton");
        QCOMPARE(made.size(), 2);
        panel.setState(examples::path());
        panel.adjustSize();
        click(panel, "updatePathButton");
        QCOMPARE(update.size(), 1);
        click(panel, "pathVisibleButton");
        click(panel, "pathVisibleButton");
        QCOMPARE(seen[0][0].toBool(), false);
        QCOMPARE(seen[1][0].toBool(), true);
        state = examples::path();
        state.outdated = false;
        panel.setState(state);
        click(panel, "updatePathButton");
        QCOMPARE(update.size(), 1); // it is up to date, so the click does nothing
    }

    void everyParameterOfAnEditHasItsField() {
        for (const Edit& edit : everyEdit()) {
            const std::string json = toJson(edit);
            for (const EditParameter& parameter : parametersOf(edit.parameters, {})) {
                const EditField& field = parameter.field;
                const QByteArray key =
                    QByteArray::fromStdString(std::string(idOf(edit.parameters)) + ", " + std::string(field.key));
                QVERIFY2(!parameter.label.isEmpty() && !parameter.toolTip.isEmpty(), key);
                QVERIFY2(json.find('"' + std::string(field.key) + '"') != std::string::npos, json.c_str());
                for (const EditChoice& choice : field.choices) QVERIFY2(*choice.words.text != 0, key);
                if (!std::holds_alternative<double>(field.value)) continue;
                Edit changed = edit;
                const auto accepts = [&](double value) {
                    setField(changed.parameters, field.key, value);
                    return validate(changed).hasValue();
                };
                QVERIFY2(!accepts(field.high * 1.001) && !accepts(field.low - 1e-4), key);
                setField(changed.parameters, field.key,
                         std::get<double>(field.value) == field.high ? field.low : field.high);
                QVERIFY2(toJson(changed) != json, key);
            }
        }
    }

    void noticesMoveNothing() {
        PathPanel panel;
        PathState quiet = examples::path();
        quiet.busy = quiet.outdated = quiet.waiting = false;
        quiet.problem = QString();
        panel.setState(quiet);
        show(panel);
        const auto before = controlsOf(panel);
        QVERIFY(before.size() > 4);
        PathState busy = quiet, outdated = quiet, waiting = quiet, problem = quiet;
        busy.busy = outdated.outdated = waiting.waiting = true;
        problem.problem = QStringLiteral("The path cuts into the part at 17 points by up to 0.31 mm; put another edit "
                                         "behind the one that did it, or take it out.");
        for (const PathState& state : {busy, outdated, waiting, problem}) {
            panel.setState(state);
            QVERIFY(child<Notice>(panel, "pathNotice").isVisible());
            QVERIFY(controlsOf(panel) == before);
        }
    }

    void editsAreAddedMovedAndRemoved() {
        PathPanel panel;
        panel.setState(examples::path());
        show(panel);
        std::vector<std::string> added;
        connect(&panel, &PathPanel::editAdded, this,
                [&added](const Edit& edit) { added.emplace_back(idOf(edit.parameters)); });
        QSignalSpy moved(&panel, &PathPanel::editMoved), removed(&panel, &PathPanel::editRemoved);
        qsizetype offered = 0; // every kind is in one of the groups
        for (const QAction* group : child<QMenu>(panel, "addEditMenu").actions()) {
            QVERIFY(group->menu() != nullptr && !group->menu()->isEmpty());
            offered += group->menu()->actions().size();
        }
        // Earlier versions of edits stay in the paths that have them, but are no longer offered.
        const std::vector<Edit> kinds = everyEdit();
        const auto current = std::ranges::count_if(kinds, [](const Edit& edit) { return !updated(edit); });
        QCOMPARE(offered, static_cast<qsizetype>(current));
        child<QAction>(panel, "add-mirror").trigger();
        QCOMPARE(added, (std::vector<std::string>{"mirror"}));
        click(panel, "edit2Earlier");
        click(panel, "edit2Later");
        click(panel, "edit0Earlier"); // it is already the first
        QCOMPARE(moved.size(), 2);
        QCOMPARE(moved[0], (QVariantList{QVariant::fromValue(std::size_t{2}), QVariant::fromValue(std::size_t{1})}));
        QCOMPARE(moved[1], (QVariantList{QVariant::fromValue(std::size_t{2}), QVariant::fromValue(std::size_t{3})}));
        click(panel, "edit3Remove");
        QCOMPARE(removed.size(), 1);
        QCOMPARE(removed[0][0].value<std::size_t>(), std::size_t{3});
    }

    void theVerdictDecidesOnExport() {
        ProgramPanel panel;
        QSignalSpy post(&panel, &ProgramPanel::postRequested), exported(&panel, &ProgramPanel::exportRequested),
            tolerance(&panel, &ProgramPanel::gougeToleranceEdited),
            excess(&panel, &ProgramPanel::excessToleranceEdited);
        panel.setState(examples::program());
        show(panel);
        click(panel, "postButton");
        click(panel, "exportButton");
        QCOMPARE(post.size(), 1);
        QCOMPARE(exported.size(), 1);
        QCOMPARE(child<Notice>(panel, "verdict").kind(), Notice::Kind::passed);
        QVERIFY(child<Notice>(panel, "verdict").sentence().startsWith(QStringLiteral("Passed: gouge 0.002")));
        QCOMPARE(valueOf(panel, "machiningTime"), QStringLiteral("25:04"));
        QVERIFY(child<ValueRow>(panel, "machiningTime").toolTip().contains(QStringLiteral("tool change")));
        type(panel, "gougeToleranceField", "0,01");
        QCOMPARE(tolerance[0][0].toDouble(), 0.01);
        type(panel, "excessToleranceField", "0");
        QCOMPARE(excess[0][0].toDouble(), 0.0);
        const auto refuses = [&](ProgramState state) {
            panel.setState(state);
            click(panel, "exportButton");
            return exported.size() == 1 &&
                   child<QPushButton>(panel, "exportButton").toolTip().endsWith(QLatin1Char('.'));
        };
        ProgramState state = examples::program();
        state.outdated = true;
        QVERIFY(refuses(state));
        // The program of a project that was just opened is not checked, whether or not its path is unchanged.
        const QString changed = child<QPushButton>(panel, "exportButton").toolTip();
        state.report.reset();
        QVERIFY(refuses(state));
        const QString unchecked = child<QPushButton>(panel, "exportButton").toolTip();
        QVERIFY(unchecked != changed && unchecked.contains(QStringLiteral("not checked")));
        QCOMPARE(child<Notice>(panel, "programNotice").sentence(), unchecked);
        QVERIFY(refuses(examples::failedProgram()));
        QVERIFY(refuses({}));
    }

    /// While the work of a button runs, and after it, the keyboard focus stays where the user left it: the next key
    /// must not change the machine.
    void theKeyboardStaysAtTheButtonThatWorks() {
        ProgramPanel panel;
        ProgramState idle = examples::program(), working = idle;
        working.busy = true;
        panel.setState(idle);
        show(panel);
        auto& post = child<QPushButton>(panel, "postButton");
        post.setFocus();
        panel.setState(working);
        QVERIFY(!post.isEnabled());
        QCOMPARE(panel.window()->focusWidget(), post.parentWidget());
        panel.setState(idle);
        QCOMPARE(panel.window()->focusWidget(), static_cast<QWidget*>(&post));
        // If the user moved the focus meanwhile, it stays there.
        panel.setState(working);
        auto& tolerance = child<QWidget>(panel, "gougeToleranceField");
        tolerance.setFocus();
        panel.setState(idle);
        QCOMPARE(panel.window()->focusWidget(), &tolerance);
    }

    /// As by mouse: the button was pressed and has the focus, its menu is closed, the edits are applied.
    void theKeyboardGoesToTheEditThatWasAdded() {
        PathPanel panel;
        PathState working = examples::path();
        panel.setState(working);
        show(panel);
        connect(&panel, &PathPanel::editAdded, this, [&](const Edit& edit) {
            working.path.edits.push_back(edit);
            working.busy = true;
            panel.setState(working);
        });
        const QString card = QStringLiteral("edit%1Switch").arg(working.path.edits.size());
        child<QWidget>(panel, "addEditButton").setFocus();
        child<QAction>(panel, "add-mirror").trigger();
        QVERIFY(!child<QWidget>(panel, "addEditButton").isEnabled());
        working.busy = false;
        panel.setState(working);
        QVERIFY(panel.window()->focusWidget() != nullptr);
        QCOMPARE(panel.window()->focusWidget()->objectName(), card);
    }

    /// An edit that is moved or changed is evaluated, its card disabled or recreated: the focus stays with the edit.
    void theKeyboardStaysWithTheEditThatIsChanged() {
        PathPanel panel;
        const PathState idle = examples::path();
        panel.setState(idle);
        show(panel);
        const auto focused = [&panel] {
            const QWidget* focus = panel.window()->focusWidget();
            return focus != nullptr ? focus->objectName() : QString();
        };
        PathState working = idle;
        working.busy = true;
        child<QWidget>(panel, "edit2_tolerance_mm").setFocus();
        panel.setState(working);
        QVERIFY(!child<QWidget>(panel, "edit2_tolerance_mm").isEnabled());
        QCOMPARE(focused(), QString());
        panel.setState(idle);
        QCOMPARE(focused(), QStringLiteral("edit2_tolerance_mm"));

        connect(&panel, &PathPanel::editMoved, this, [&](std::size_t from, std::size_t to) {
            std::swap(working.path.edits[from], working.path.edits[to]);
            panel.setState(working);
        });
        const auto finish = [&] {
            PathState done = working;
            done.busy = false;
            panel.setState(done);
        };
        child<QWidget>(panel, "edit2Earlier").setFocus();
        QTest::keyClick(panel.window()->focusWidget(), Qt::Key_Space);
        finish();
        QCOMPARE(focused(), QStringLiteral("edit1Earlier"));
        QTest::keyClick(panel.window()->focusWidget(), Qt::Key_Space);
        finish();
        QCOMPARE(idOf(working.path.edits[0].parameters), idOf(idle.path.edits[2].parameters));
        QCOMPARE(focused(), QString()); // it can go no further, and the next Space must not switch it off
        panel.setState(idle);
        // If the user moved the focus meanwhile, it stays there.
        child<QWidget>(panel, "edit2_tolerance_mm").setFocus();
        panel.setState(working);
        child<QWidget>(panel, "pathVisibleButton").setFocus();
        finish();
        QCOMPARE(focused(), QStringLiteral("pathVisibleButton"));
    }

    /// A user who works far down the list stays there while edits are changed, moved, added and removed.
    void theListOfEditsDoesNotJump() {
        QScrollArea area;
        auto* panel = new PathPanel;
        area.setWidget(panel);
        area.setWidgetResizable(true);
        PathState state = examples::path();
        panel->setState(state);
        area.resize(panelWidth + 24, 400);
        area.show();
        area.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&area));
        QScrollBar* bar = area.verticalScrollBar();
        QVERIFY(bar->maximum() > 500);
        bar->setValue(400);
        std::vector<int> places;
        connect(bar, &QScrollBar::valueChanged, &area, [&places](int place) { places.push_back(place); });
        const auto stays = [&] {
            panel->setState(state);
            QTest::qWait(20);
            return places.empty() && bar->value() == 400;
        };
        child<QWidget>(*panel, "edit2_tolerance_mm").setFocus();
        std::swap(state.path.edits[1], state.path.edits[2]);
        state.busy = true;
        QVERIFY(stays());
        state.busy = false;
        QVERIFY(stays());
        const Edit first = state.path.edits.front();
        state.path.edits.push_back(first);
        QVERIFY(stays());
        state.path.edits.pop_back();
        QVERIFY(stays());
    }

    /// Verdict, notices, tools and findings appear and disappear without moving any control or text field.
    void whatIsToldOfAProgramMovesNothing() {
        QScrollArea page;
        auto* panel = new ProgramPanel;
        page.setWidget(panel);
        page.setWidgetResizable(true);
        ProgramState unchecked = examples::program();
        unchecked.report.reset();
        unchecked.paths = {{1, QStringLiteral("Ball-end mill 6 mm"), true}};
        panel->setState(unchecked);
        page.resize(panelWidth + 24, 700);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        const auto before = controlsOf(*panel);
        for (const char* name : {"postButton", "machineChoice", "gougeToleranceField", "editTextButton"})
            QVERIFY2(before.contains(&child<QWidget>(*panel, name)), name);
        const auto& editor = child<QWidget>(*panel, "programEditor");
        const QRect place = editor.geometry();
        const std::pair<const char*, std::function<void(ProgramState&)>> news[] = {
            {"checked", [](ProgramState& state) { state = examples::program(); }},
            {"busy", [](ProgramState& state) { state.busy = true; }},
            {"a problem", [](ProgramState& state) { state.problem = QStringLiteral("It can't be. ").repeated(20); }},
            {"outdated",
             [](ProgramState& state) {
                 state = examples::program();
                 state.outdated = true;
             }},
            {"refused", [](ProgramState& state) { state = examples::failedProgram(); }},
            {"many findings",
             [](ProgramState& state) {
                 state = examples::failedProgram();
                 VerifyReport report = *state.report;
                 report.findings.resize(40, report.findings.front());
                 state.report = std::make_shared<const VerifyReport>(report);
             }},
            {"wanted all the same",
             [](ProgramState& state) {
                 state = examples::failedProgram();
                 state.released = true;
             }},
            {"edited",
             [](ProgramState& state) {
                 state.edited = true;
                 state.lint = std::vector(1, LintMark());
             }},
            {"more tools", [](ProgramState& state) {
                 for (int i = 2; i < 6; ++i) state.paths.push_back({i, QStringLiteral("Flat end mill 10 mm"), true});
                 state.withoutPath = QStringList{QStringLiteral("Bull-nose end mill 10 mm")};
             }}};
        for (const auto& [name, change] : news) {
            ProgramState state = unchecked;
            change(state);
            panel->setState(state);
            auto after = controlsOf(*panel);
            QCOMPARE(editor.geometry().topLeft(), place.topLeft());
            for (const auto& [control, rect] : before) {
                if (child<QWidget>(*panel, "programPaths").isAncestorOf(control)) continue;
                QVERIFY2(after.contains(control) && after[control] == rect,
                         qPrintable(QLatin1String(name) + QStringLiteral(": ") + control->objectName()));
            }
            QCOMPARE(child<QPushButton>(*panel, "overrideButton").isVisible(),
                     QLatin1String(name) == QLatin1String("refused") ||
                         QLatin1String(name) == QLatin1String("many findings"));
            const auto& text = child<QWidget>(*panel, "programText");
            QVERIFY(text.height() >= 160 && !text.visibleRegion().isEmpty());
            panel->setState(unchecked);
            QVERIFY(controlsOf(*panel) == before);
            QCOMPARE(editor.geometry(), place);
        }
    }

    /// The list of marks that appears below the text while one types makes the text smaller, but the line that is
    /// edited stays visible.
    void theLineThatIsWrittenStaysInSight() {
        ProgramView view;
        view.showProgram(QStringLiteral("G1 X1\n").repeated(200));
        view.setEditable(true);
        show(view);
        view.resize(300, 600);
        QTextCursor cursor = view.textCursor();
        cursor.movePosition(QTextCursor::NextBlock, QTextCursor::MoveAnchor, 100);
        view.setTextCursor(cursor);
        view.resize(300, 200);
        QVERIFY(view.viewport()->rect().contains(view.cursorRect()));
    }

    /// Warnings are in the list and lead to their lines; the program passes nevertheless.
    void nearPassesWarnAndLetThrough() {
        ProgramPanel panel;
        ProgramState state = examples::program();
        auto report = std::make_shared<VerifyReport>(*state.report);
        report->nearPasses = {{ToolSection::shank, NearTo::stock, 30, {}, 0.2, 1200},
                              {ToolSection::holder, NearTo::part, 12, {}, 0.4}};
        state.report = report;
        panel.setState(state);
        show(panel);
        QSignalSpy exported(&panel, &ProgramPanel::exportRequested), line(&panel, &ProgramPanel::lineChosen);
        click(panel, "exportButton");
        QCOMPARE(exported.size(), 1);
        QCOMPARE(child<Notice>(panel, "verdict").kind(), Notice::Kind::passed);
        clickRow(panel, "findingList", 0);
        QCOMPARE(line[0][0].toInt(), 30);
        QVERIFY(nearPassText(report->nearPasses[0], LengthUnit::millimetre).contains(QStringLiteral("1200")));
        QCOMPARE(nearPassText(report->nearPasses[1], LengthUnit::millimetre),
                 QStringLiteral("Holder passes the part at 0.400\u00a0mm"));
    }

    /// A limit that is exceeded is in the list, as an error or a warning, with both values and units.
    void loadsBeyondLimitsAreInTheList() {
        ProgramPanel panel;
        ProgramState state = examples::failedProgram();
        VerifyReport report;
        report.findings = {{FindingKind::spindlePower, 12, {}, 918.0, 900.0, 4}};
        report.warnings = {{FindingKind::toolBending, 21, {}, 0.055, 0.02, 1}};
        state.report = std::make_shared<const VerifyReport>(report);
        panel.setState(state);
        show(panel);
        const std::vector<ListRow>& rows = child<RowList>(panel, "findingList").rows();
        QVERIFY(rows.size() >= 2);
        QVERIFY2(rows[0].title.startsWith(
                     QStringLiteral("The cut takes 918 W, the spindle has 900 W (and on 3 more lines); mill it in")),
                 qPrintable(rows[0].title));
        QCOMPARE(rows[0].icon, QStringLiteral("error"));
        QVERIFY2(rows[1].title.startsWith(QStringLiteral("The tool bends by 0.055")), qPrintable(rows[1].title));
        QCOMPARE(rows[1].icon, QStringLiteral("warning"));
        QSignalSpy line(&panel, &ProgramPanel::lineChosen);
        clickRow(panel, "findingList", 1);
        QCOMPARE(line[0][0].toInt(), 21);
    }

    void findingsLeadToTheirLine() {
        ProgramPanel panel;
        panel.setState(examples::failedProgram());
        show(panel);
        QCOMPARE(child<Notice>(panel, "verdict").kind(), Notice::Kind::error);
        QSignalSpy line(&panel, &ProgramPanel::lineChosen);
        auto& text = child<QPlainTextEdit>(panel, "programText");
        clickRow(panel, "findingList", 2);
        QCOMPARE(line.size(), 1);
        QCOMPARE(line[0][0].toInt(), 33);
        QCOMPARE(text.textCursor().blockNumber(), 32);
        clickRow(panel, "findingList", 2);
        QCOMPARE(line.size(), 2); // repeated
        text.setFocus();
        QTest::keyClick(&text, Qt::Key_Down);
        QCOMPARE(line.size(), 3);
        QCOMPARE(line[2][0].toInt(), 34);
        QTest::keyClick(&text, Qt::Key_A); // the text is read-only
        QCOMPARE(text.toPlainText(), examples::programText());
    }

    void aRefusedProgramIsRequestedOnlyWithAReason() {
        ProgramPanel panel;
        panel.setState(examples::failedProgram());
        show(panel);
        QSignalSpy wanted(&panel, &ProgramPanel::overrideRequested), exported(&panel, &ProgramPanel::exportRequested);
        click(panel, "overrideButton");
        QCOMPARE(wanted.size(), 1);
        ProgramState state = examples::failedProgram();
        state.released = true; // the header of the program now gives the reason
        panel.setState(state);
        QVERIFY(!child<QPushButton>(panel, "overrideButton").isVisible());
        QCOMPARE(child<Notice>(panel, "verdict").kind(), Notice::Kind::warning);
        click(panel, "exportButton");
        QCOMPARE(exported.size(), 1);
        panel.setState(examples::program());
        QVERIFY(!child<QPushButton>(panel, "overrideButton").isVisible());
    }

    void theLoadLeadsToItsLine() {
        LoadChart chart;
        chart.resize(200, chart.sizeHint().height());
        VerifyReport report;
        report.machiningSeconds = 10.0;
        for (std::uint32_t i = 0; i < 10; ++i) {
            MotionLoad load;
            load.line = 20 + i;
            load.start = i;
            load.duration = 1.0;
            load.force = i == 6 ? 42.5 : 10.0;
            report.loads.push_back(load);
            report.loadSteps.push_back({static_cast<float>(i), 1.0F, static_cast<float>(load.force), 0.0F, i});
        }
        chart.setReport(std::make_shared<const VerifyReport>(report));
        chart.show();
        QVERIFY(chart.accessibleDescription().contains(QStringLiteral("42.5")));
        QSignalSpy line(&chart, &LoadChart::lineChosen);
        QTest::mouseClick(&chart, Qt::LeftButton, {}, QPoint(130, 40)); // 6.5 s of 10
        QCOMPARE(line.size(), 1);
        QCOMPARE(line[0][0].toInt(), 26);
        // The column of the peak is higher than the others.
        const QImage picture = chart.grab().toImage();
        const double ratio = picture.devicePixelRatio();
        const auto topOf = [&](int x) {
            for (int y = 18; y < chart.height(); ++y)
                if (picture.pixelColor(QPoint(x, y) * ratio) != activePalette().field) return y;
            return chart.height();
        };
        QVERIFY(topOf(130) < topOf(50) - 10);
    }

    /// Two tools that cut for 10 s each, with a change of 60 s before each: half of the chart belongs to each tool.
    void toolChangesAreNoPartOfTheChart() {
        LoadChart chart;
        chart.resize(200, chart.sizeHint().height());
        VerifyReport report;
        for (std::uint32_t i = 0; i < 20; ++i) {
            const double start = i + (i < 10 ? 60.0 : 120.0);
            MotionLoad load;
            load.motion = i;
            load.line = 20 + i;
            load.start = start;
            load.duration = 1.0;
            load.force = 10.0;
            report.loads.push_back(load);
            report.loadSteps.push_back({static_cast<float>(start), 1.0F, 10.0F, 0.0F, i});
            report.times.push_back({start, 1.0, 20.0});
        }
        report.machiningSeconds = 140.0;
        chart.setReport(std::make_shared<const VerifyReport>(report));
        chart.show();
        QSignalSpy line(&chart, &LoadChart::lineChosen);
        for (const auto& [x, wanted] : {std::pair{5, 20}, {45, 24}, {95, 29}, {105, 30}, {145, 34}, {195, 39}}) {
            QTest::mouseClick(&chart, Qt::LeftButton, {}, QPoint(x, 40));
            QCOMPARE(line.takeLast()[0].toInt(), wanted);
        }
        // No column is empty.
        const QImage picture = chart.grab().toImage();
        for (int x = 1; x < 199; ++x)
            QVERIFY(picture.pixelColor(QPoint(x, chart.height() - 2) * picture.devicePixelRatio()) !=
                    activePalette().field);
    }

    void theDeviationTellsItsFigure() {
        DeviationCard card;
        card.show();
        card.setShares({0.01, 0.7, 0.19, 0.1}, {0.02, 0.1, 0.0});
        QSignalSpy switched(&card, &DeviationCard::switched);
        QVERIFY(!child<QLabel>(card, "deviationUnderPointer").isVisible());
        QTest::mouseClick(&child<QCheckBox>(card, "deviationSwitch"), Qt::LeftButton, {}, {10, 10});
        QCOMPARE(switched.size(), 1);
        const auto& rows = child<RowList>(card, "deviationBands").rows();
        QCOMPARE(rows.size(), std::size_t{4});
        // The legend has evenly spaced values, each with the colour that rows and surface have.
        auto& legend = child<DeviationLegend>(card, "deviationLegend");
        QVERIFY(legend.isVisible());
        for (const char* value : {"+0.1 mm", "+0.5 mm", "+2 mm", "−0.02 mm", "−0.4 mm"})
            QVERIFY2(legend.accessibleDescription().contains(
                         QString::fromUtf8(value).replace(QLatin1Char(' '), QChar(QChar::Nbsp))),
                     value);
        QVERIFY(std::abs(legend.heightOf(-0.4) - legend.heightOf(-0.2) - legend.heightOf(0.1) + legend.heightOf(0.2)) <
                1e-9);
        const QImage picture = legend.grab().toImage();
        const auto at = [&](double deviation) {
            return picture.pixelColor(
                (QPointF(20.0, legend.heightOf(deviation)) * picture.devicePixelRatio()).toPoint());
        };
        QVERIFY(at(1.5).blue() > at(1.5).red() + 60 && at(-0.3).red() > at(-0.3).blue() + 60);
        QVERIFY(at(0.0).lightness() > 235 && at(0.7).lightness() < at(0.15).lightness());
        QVERIFY(rows[1].value.startsWith(QStringLiteral("70.0")));
        DeviationSample sample;
        sample.gouge = 0.034;
        card.showUnderPointer(sample);
        // The pointer of the legend is at the value.
        const QImage pointed = legend.grab().toImage();
        QRect changed;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (pointed.pixel(x, y) != picture.pixel(x, y)) changed |= QRect(x, y, 1, 1);
        QVERIFY(!changed.isEmpty());
        QVERIFY(std::abs(changed.center().y() / pointed.devicePixelRatio() - legend.heightOf(-0.034)) < 2.0);
        QVERIFY(child<QLabel>(card, "deviationUnderPointer").text().contains(QStringLiteral("0.034")));
        QVERIFY(child<QLabel>(card, "deviationUnderPointer").text().contains(QStringLiteral("too deep")));
        card.setUnit(LengthUnit::inch);
        QVERIFY(child<QLabel>(card, "deviationUnderPointer").text().contains(QStringLiteral("0.0013")));
    }

    void aSearchGoesRoundAndRound() {
        ProgramText view;
        view.resize(320, 400);
        view.showProgram(QStringLiteral("G1 X1\nM3\nG1 X2\nm30\nG0 Z5"));
        view.show();
        auto& text = child<QPlainTextEdit>(view, "programText");
        auto& search = child<QLineEdit>(view, "programSearch");
        QSignalSpy line(&view, &ProgramText::lineChosen);
        view.startSearch();
        QTest::keyClicks(&search, "m3");
        QCOMPARE(child<QLabel>(view, "searchFound").text(), QStringLiteral("2"));
        std::vector<int> lines;
        for (const Qt::KeyboardModifiers keys : {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier}) {
            QTest::keyClick(&search, Qt::Key_Return, keys);
            lines.push_back(text.textCursor().blockNumber() + 1);
        }
        QCOMPARE(lines, (std::vector{2, 4, 2, 4}));
        QCOMPARE(line.size(), 4);
        view.showProgram(QStringLiteral("G0"));
        QCOMPARE(child<QLabel>(view, "searchFound").text(), QStringLiteral("none"));
        QVERIFY(!child<QToolButton>(view, "searchNextButton").isEnabled());
    }

    void aLongProgramComesInPiecemeal() {
        ProgramView view;
        view.resize(320, 400);
        view.show();
        QString text;
        for (int i = 1; i <= 50000; ++i) text += QStringLiteral("N%1 G1 X12.345 Y-3.456\n").arg(i);
        QSignalSpy line(&view, &ProgramView::lineChosen);
        view.showProgram(text);
        QVERIFY(!view.complete());
        view.showLine(30000); // a line that is not loaded yet
        QCOMPARE(view.textCursor().block().text(), QStringLiteral("N30000 G1 X12.345 Y-3.456"));
        QTRY_VERIFY(view.complete());
        QCOMPARE(view.toPlainText(), text);
        QCOMPARE(view.textCursor().blockNumber(), 29999);
        view.showProgram(text + QStringLiteral("M30"));
        view.showProgram(QStringLiteral("M5\nM30")); // the next program, before that one is loaded
        QTest::qWait(50);
        QCOMPARE(view.toPlainText(), QStringLiteral("M5\nM30"));
        QCOMPARE(view.textCursor().blockNumber(), 0);
        view.showProgram({});
        QCOMPARE(view.toPlainText(), QString());
        QCOMPARE(line.size(), 0);
    }

    void wordsAreTold_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("kinds"); // one letter per character
        QTest::newRow("a move") << "G1 X-1.5 Y+2 F1400"
                                << "cc aaaaa aaa sssss";
        QTest::newRow("no spaces") << "N10G0X1M3"
                                   << "nnnccaacc";
        QTest::newRow("comments") << "G4 (X1 (G0) P0.5 ; G1"
                                  << "cc //////// nnnn ////";
        QTest::newRow("lower case") << "g1 z-.5"
                                    << "cc aaaa";
        QTest::newRow("no words") << "% L X"
                                  << "     ";
        QTest::newRow("an open comment") << "M5 (end"
                                         << "cc ////";
    }
    void wordsAreTold() {
        QFETCH(QString, line);
        QFETCH(QString, kinds);
        QString told(line.size(), QLatin1Char(' '));
        for (const ProgramWord& word : programWords(line))
            for (int i = 0; i < word.length; ++i)
                told[word.start + i] = QLatin1Char("cas/n"[static_cast<int>(word.kind)]);
        QCOMPARE(told, kinds);
    }
};

BURIN_TEST(TestPathPanels, QApplication)

} // namespace burin::tst_path_panels

#include "tst_path_panels.moc"
