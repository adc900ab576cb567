// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/main_window.h"

#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/questions.h"
#include "ui/messages/messages.h"
#include "ui/panels/program_editor.h"
#include "ui/panels/texts.h"
#include "ui/panels/timeline_panel.h"
#include "ui/scene/view_cube_room.h"
#include "ui/theme/without_style_sheet.h"
#include "ui/window/device_dialog.h"
#include "ui/window/machine_dialog.h"
#include "ui/window/material_dialog.h"
#include "ui/window/path_colours.h"
#include "ui/window/program_dock.h"
#include "ui/window/score_dialog.h"
#include "ui/window/tool_dialog.h"

#include <QApplication>
#include <QCloseEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace burin {

namespace {

constexpr QSize smallestWindow(1024, 680);
constexpr QSize firstWindow(1280, 800);
constexpr std::chrono::milliseconds warmUpAfter(300); // after the welcome page is shown, before anyone has read it

/// Actions that switch parts of the view.
constexpr ActionId shownByAction[] = {ActionId::showPart, ActionId::showWorkpiece, ActionId::showTool,
                                      ActionId::showPath, ActionId::showGuides,    ActionId::showOtherPaths,
                                      ActionId::excess};

/// The dragged file if it is only one; empty otherwise.
QString draggedFile(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent), states_(actions_, workbench_, nullptr), flow_(workbench_, settings_, *this) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setMinimumSize(smallestWindow);
    dress(settings_.preferences().theme); // before widgets are created, which take font and style from it
    {
        const WithoutStyleSheet whileLaidOut(*qobject_cast<QApplication*>(QCoreApplication::instance()));
        layOut();
    }
    presenters_ = std::make_unique<Presenters>(
        workbench_, actions_, Stage{*viewport_, *stepBar_, *panels_, *status_, *timeline_, *tree_}, nullptr);
    coach_ = std::make_unique<Coach>(*this, workbench_, actions_);
    new ViewOptions(*viewport_, *viewBar_, actions_, settings_, this);
    new PathColours(workbench_, *viewport_, *viewBar_, actions_, this);
    takeShortcuts();
    connectActions();
    connectWorkbench();
    connectWelcome();
    connectFirstJob();
    viewport_->setPalette3D(activePalette());
    setUnit(settings_.preferences().unit);
    resize(firstWindow);
    restoreGeometry(settings_.windowGeometry());
    firstWork_ = work_->saveState();
    firstDocks_ = view_->saveState();
    work_->restoreState(settings_.panelWidth());
    view_->restoreState(settings_.viewDocks());
    actions_[ActionId::programDock]->setChecked(settings_.programDocked());
    actions_[ActionId::showTimeline]->setChecked(settings_.timelineShown());
    timeline_->setCurves(settings_.timelineCurves());
    panels_->meters->setFolded(settings_.metersFolded());
    connect(panels_->meters, &Meters::foldedChanged, this, [this](bool folded) { settings_.setMetersFolded(folded); });
    showStep(JobStep::part);
    showWelcome();
    updateTitle();
    QTimer::singleShot(warmUpAfter, viewport_, &Viewport::warmUp);
}

MainWindow::~MainWindow() {
    coach_.reset();      // before the widgets and workbench that it observes
    presenters_.reset(); // before the widgets that they fill
}

void MainWindow::layOut() {
    menus_ = new Menus(*menuBar(), actions_);
    status_ = new StatusLine(this);
    setStatusBar(status_);
    viewport_ = new Viewport;
    viewport_->setObjectName(QStringLiteral("viewport"));
    viewport_->setFocusPolicy(Qt::StrongFocus);
    viewport_->setAccessibleName(tr("View of part and workpiece"));
    viewBar_ = new ViewBar(
        {*actions_[ActionId::parallelView], *actions_[ActionId::sectionPlane], *actions_[ActionId::flipSection]});
    stepBar_ = new StepBar;
    stepBar_->setObjectName(QStringLiteral("jobLine"));
    panels_ = new PanelStack;
    message_ = new MessageStrip;
    welcome_ = new WelcomePage;

    work_ = new QSplitter(Qt::Horizontal);
    work_->setObjectName(QStringLiteral("workSplitter"));
    work_->setChildrenCollapsible(false);
    view_ = makeView();
    programDock_ = new ProgramDock(*panels_->program, *actions_[ActionId::programDock], *view_);
    layOutTimeline();
    layOutTree();
    layOutHistory();
    work_->addWidget(view_);
    work_->addWidget(panels_);
    work_->setStretchFactor(0, 1);
    work_->setStretchFactor(1, 0);
    work_->handle(1)->setToolTip(tr("Drag to make the panel wider or narrower"));
    workPage_ = new QWidget;
    workPage_->setObjectName(QStringLiteral("workPage"));
    auto* steps = new QVBoxLayout(workPage_);
    steps->setContentsMargins(0, 0, 0, 0);
    steps->setSpacing(0);
    steps->addWidget(stepBar_);
    steps->addWidget(work_, 1);

    pages_ = new QStackedWidget;
    pages_->setObjectName(QStringLiteral("pages"));
    pages_->addWidget(welcome_);
    pages_->addWidget(workPage_);
    setCentralWidget(pages_);
    connect(pages_, &QStackedWidget::currentChanged, this, &MainWindow::followPage);
    followPage();
}

void MainWindow::followPage() {
    const bool working = pages_->currentWidget() == workPage_;
    const bool leadsBack = !working && workbench_.document.isOpen();
    constexpr int cube = static_cast<int>(ViewCubeRoom::side + 2.0 * ViewCubeRoom::margin);
    message_->layOver(working ? static_cast<QWidget*>(viewport_) : welcome_, working ? cube : 0);
    followDocks();
    status_->setPageEscape(leadsBack ? tr("Esc: back to the project") : QString(), !working);
}

/// An import from the welcome page shows the preview, and returns to that page if it fails.
void MainWindow::followPreview() {
    const bool shown = workbench_.model.preview() != nullptr;
    if (shown == std::exchange(previewShown_, shown)) return;
    if (shown && pages_->currentWidget() == welcome_) {
        fromWelcome_ = true;
        showWorkSteps(true);
        showStep(JobStep::part);
    } else if (!shown && std::exchange(fromWelcome_, false) && !workbench_.document.isOpen()) {
        showWelcome();
    }
}

QMainWindow* MainWindow::makeView() {
    auto* docks = new QMainWindow;
    docks->setWindowFlags(Qt::Widget);
    docks->setObjectName(QStringLiteral("viewDocks"));
    docks->setContextMenuPolicy(Qt::NoContextMenu); // the menu bar contains these actions
    auto* view = new QWidget;
    docks->setCentralWidget(view);
    auto* layout = new QVBoxLayout(view);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(viewport_, 1);
    layout->addWidget(viewBar_);
    return docks;
}

void MainWindow::showWelcome() {
    lookForLeftWork();
    welcome_->setRecentFiles(settings_.recentFiles());
    welcome_->setProject(workbench_.document.isOpen() ? workbench_.document.title() : QString());
    pages_->setCurrentWidget(welcome_);
    followPage(); // also if it was shown before but the project has changed or was closed
}

/// Repeated if another process has unsaved work open: a killed process may still be ending.
void MainWindow::lookForLeftWork() {
    const FoundWork found = workbench_.document.leftWork();
    if (found.inUse) lookAgain_.start();
    std::vector<LeftWorkRow> rows;
    for (const LeftWork& work : found.left) {
        const QString file = QString::fromStdString(work.file.string());
        const auto time = std::chrono::file_clock::to_sys(work.changed);
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
        rows.push_back({file, QDateTime::fromSecsSinceEpoch(seconds)});
    }
    welcome_->setLeftWork(rows);
}

/// Returns from the welcome page to the project, if one is open.
void MainWindow::goBack() {
    if (!workbench_.document.isOpen()) return;
    showWorkSteps(true);
    if (leftFrom_ && leftFrom_->isVisible()) leftFrom_->setFocus();
}

/// Esc ends the current mode, wherever the focus is; in a field, it ends editing.
void MainWindow::escape() {
    if (auto* list = findChild<KeyList*>()) {
        list->close();
        return;
    }
    if (coach_->hasKeyboard()) return coach_->end();
    if (pages_->currentWidget() == welcome_) return goBack();
    if (workbench_.time.away()) return workbench_.time.backToPresent();
    InteractiveTool* handles = viewport_->handleTool();
    if (handles != nullptr && handles->key(Qt::Key_Escape, Qt::NoModifier)) return;
    InteractiveTool* tool = viewport_->interactiveTool();
    if (tool == nullptr || !tool->key(Qt::Key_Escape, Qt::NoModifier)) {
        activateWindow(); // a floating dock may be the active window
        viewport_->setFocus();
    }
}

void MainWindow::showWorkSteps(bool shown) {
    pages_->setCurrentWidget(shown ? workPage_ : welcome_);
    if (shown) viewport_->setFocus();
}

void MainWindow::showStep(JobStep step) {
    // With the mouse, cutting is possible in the mill step only, where it is visible. (The button of a device is
    // independent of this.)
    if (step != JobStep::mill && workbench_.mill.stylus() != nullptr) workbench_.mill.leave();
    presenters_->job.setShown(step);
    presenters_->guideScene.setShown(step);
    presenters_->deviation.setShown(step == JobStep::program);
    // The steps that release the pointer must come before those that take it.
    if (step != JobStep::part) {
        presenters_->setups.leave();
        presenters_->part.setShown(false);
    }
    presenters_->stylusEdit.setShown(step);
    presenters_->zero.setShown(step);
    presenters_->fixtures.setShown(step);
    presenters_->obstacleMove.setShown(step);
    presenters_->gizmo.setShown(step);
    presenters_->holes.setShown(step);
    if (step != JobStep::path) presenters_->area.setShown(step);
    if (step == JobStep::program) presenters_->pathScene.setShown(step);
    presenters_->programScene.setShown(step);
    if (step != JobStep::program) presenters_->pathScene.setShown(step);
    if (step == JobStep::path) presenters_->area.setShown(step);
    if (step == JobStep::part) presenters_->part.setShown(true);
    presenters_->time.setShown(step);
    panels_->showStep(step);
    followDocks();
}

LeftAt MainWindow::leftAt() const {
    LeftAt left;
    left.step = presenters_->job.shown();
    left.embedded = workbench_.workpiece.embedded();
    left.tool = workbench_.tool.current().id;
    left.setup = numberOf(workbench_.setups.used());
    left.mill = presenters_->millMode.settings();
    left.camera = viewport_->cameraView();
    left.area = workbench_.area.area();
    for (const ActionId id : shownByAction) left.shown[actions_[id]->objectName()] = actions_[id]->isChecked();
    left.hidden = presenters_->tree.hiddenBodies();
    return left;
}

void MainWindow::goTo(const LeftAt& left) {
    if (workbench_.model.model()) showStep(left.step);
    const std::vector<SetupName>& setups = workbench_.setups.setups();
    if (SetupId{left.setup} == workbench_.setups.used()) {
        workbench_.area.load(left.area);
    } else if (std::ranges::find(setups, SetupId{left.setup}, &SetupName::id) != setups.end()) {
        connect(
            &workbench_.document, &DocumentController::setupUsed, this,
            [this, area = left.area] { workbench_.area.load(area); }, Qt::SingleShotConnection);
        workbench_.setups.use(SetupId{left.setup});
    }
    workbench_.tool.show(left.tool);
    presenters_->millMode.setSettings(left.mill);
    for (const ActionId id : shownByAction)
        actions_[id]->setChecked(left.shown.value(actions_[id]->objectName(), actions_[id]->isChecked()));
    // Queued: the presenters must show the part first, which adjusts the view to it.
    QMetaObject::invokeMethod(
        this, [this, camera = left.camera] { viewport_->setCameraView(camera); }, Qt::QueuedConnection);
}

void MainWindow::tellAboutOpened() {
    message_->dismiss();
    showWorkSteps(true);
    showStep(workbench_.model.model() ? JobStep::mill : JobStep::part);
    const DocumentController& document = workbench_.document;
    if (!document.keptAside().empty())
        message_->tell(Notice::Kind::warning,
                       tr("Older unsaved work no longer belongs to this file; it was moved to “%1”.")
                           .arg(QString::fromStdString(document.keptAside().filename().string())));
    else if (document.readOnly())
        message_->tell(Notice::Kind::warning,
                       tr("The folder can't be written, so this project is open for reading only; save it elsewhere to "
                          "change it."));
    else if (document.recovered())
        message_->tell(
            Notice::Kind::information,
            tr("Burin ended before this work was saved; everything that was entered and recorded is restored."));
}

void MainWindow::tellAboutBattery(double share) {
    message_->tell(Notice::Kind::warning, tr("The battery of “%1” is down to %2; charge it soon.")
                                              .arg(workbench_.styluses.chosenName(), shareText(share)));
}

void MainWindow::updateTitle() {
    const DocumentController& document = workbench_.document;
    setWindowTitle(document.isOpen() ? tr("%1[*] — Burin").arg(document.title()) : tr("Burin"));
    setWindowModified(document.isOpen() && document.unsaved());
}

void MainWindow::dress(Theme theme) {
    const Result<Palette> palette = loadPalette(theme);
    if (palette)
        applyTheme(*qobject_cast<QApplication*>(QCoreApplication::instance()), *palette);
    else // falls back to Qt's own colours
        QMetaObject::invokeMethod(
            this, [this, error = palette.error()] { message_->tell(Notice::Kind::error, Messages::sentence(error)); },
            Qt::QueuedConnection);
}

/// Applies only what has changed: a theme updates every widget.
void MainWindow::apply(const Preferences& preferences, const Preferences& before) {
    if (preferences.theme != before.theme) {
        dress(preferences.theme);
        viewport_->setPalette3D(activePalette());
    }
    if (preferences.unit != before.unit) setUnit(preferences.unit);
}

void MainWindow::setUnit(LengthUnit unit) {
    presenters_->setUnit(unit);
    viewBar_->setUnit(unit);
    coach_->setUnit(unit);
}

void MainWindow::showPreferences() {
    PreferencesDialog dialog(settings_.preferences(), this);
    connect(&dialog, &PreferencesDialog::preferencesChanged, this, [this](const Preferences& preferences) {
        const Preferences before = settings_.preferences();
        settings_.setPreferences(preferences);
        apply(preferences, before);
    });
    dialog.exec();
}

void MainWindow::showKeys() {
    auto* list = findChild<KeyList*>();
    if (list == nullptr) {
        std::vector<KeySection> sections{{tr("Mouse in the view"), HandKeys::ofTheView()},
                                         {tr("In mill mode"), HandKeys::inMillMode()},
                                         {tr("On the path"), HandKeys::onThePath()},
                                         {tr("Placing a fixture"), HandKeys::ofAFixture()}};
        std::ranges::move(menus_->keys(), std::back_inserter(sections));
        list = new KeyList(sections, this);
        list->setAttribute(Qt::WA_DeleteOnClose);
    }
    list->show();
    list->raise();
    list->activateWindow();
}

void MainWindow::removeTake(qint64 take) {
    workbench_.mill.removeTake(take);
}

void MainWindow::showMachines() {
    MachineDialog dialog(workbench_.target, settings_.preferences().unit, this);
    dialog.exec();
}

void MainWindow::showTools() {
    ToolDialog dialog(workbench_.tool, settings_.preferences().unit, this);
    dialog.exec();
}

void MainWindow::showMaterials() {
    MaterialDialog dialog(workbench_.material, workbench_.setup.setup().stockMaterial, workbench_.setup.locked(), this);
    dialog.exec();
}

void MainWindow::showDevices() {
    DeviceDialog dialog(workbench_.styluses, workbench_.deviceTester, workbench_.axisTuner, workbench_.viewDevice,
                        settings_, this);
    connect(&dialog, &DeviceDialog::feltEdited, this, &MainWindow::followFelt);
    connect(&dialog, &DeviceDialog::gainsEdited, this, &MainWindow::followFelt);
    connect(&dialog, &DeviceDialog::stockLayerEdited, this, &MainWindow::followStockLayer);
    dialog.exec();
}

void MainWindow::showScore() {
    ScoreDialog dialog(workbench_.score, workbench_.mill, workbench_.tasks(), settings_.preferences().unit, this);
    dialog.exec();
}

void MainWindow::followFelt() {
    const std::string& device = workbench_.styluses.choice().id;
    workbench_.mill.setFelt(settings_.felt(device));
    workbench_.mill.setGains(device.empty() ? GainLimits{} : settings_.gains(device).inForce());
}

void MainWindow::followStockLayer() {
    workbench_.mill.setStockLayer(settings_.stockLayer());
}

void MainWindow::overrideCheck() {
    if (!workbench_.program.refused()) return;
    const QString reason = askOverride(this, static_cast<int>(workbench_.program.program()->errorCount()));
    if (!reason.isEmpty()) workbench_.program.overrideCheck(programName(workbench_), reason);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (ended_) {
        event->accept();
        return;
    }
    event->ignore();
    if (ending_) return;
    flow_.whenSheetIsWritten([this] {
        if (!ending_) flow_.settle([this](bool abandon) { end(abandon); }); // endQuietly does not wait
    });
}

void MainWindow::endQuietly() {
    if (!ending_) end(false);
}

void MainWindow::end(bool abandon) {
    ending_ = true;
    settings_.setWindowGeometry(saveGeometry());
    settings_.setPanelWidth(work_->saveState());
    settings_.setViewDocks(view_->saveState());
    settings_.setProgramDocked(actions_[ActionId::programDock]->isChecked());
    settings_.setTimelineShown(actions_[ActionId::showTimeline]->isChecked());
    settings_.setTimelineCurves(timeline_->curves());
    flow_.closeProject(abandon, [this] {
        ended_ = true;
        close();
    });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!draggedFile(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString file = draggedFile(*event->mimeData());
    if (file.isEmpty()) return;
    event->acceptProposedAction();
    // The drop must end first: a question would block the program that the file comes from.
    QMetaObject::invokeMethod(
        this, [this, file] { openFile(file); }, Qt::QueuedConnection);
}

} // namespace burin
