// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/action_states.h"
#include "ui/coach/coach.h"
#include "ui/dialogs/preferences.h"
#include "ui/help/welcome_page.h"
#include "ui/window/document_flow.h"
#include "ui/window/left_at.h"
#include "ui/window/menus.h"
#include "ui/window/message_strip.h"
#include "ui/window/presenters.h"
#include "ui/window/view_options.h"

#include <QMainWindow>
#include <QPointer>
#include <QTimer>

class QSplitter;
class QStackedWidget;

namespace burin {

class ProgramDock;
class ProjectTree;
class TimelinePanel;
class ViewDock;

/// The window: lays out its parts and connects them. Presenters set the contents, controllers do the work.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    Workbench& workbench() noexcept { return workbench_; }
    Viewport& viewport() noexcept { return *viewport_; }
    const Coach& coach() const noexcept { return *coach_; }
    /// Opens a project or a part.
    void openFile(const QString& file) { flow_.openAny(file); }
    /// Ends at once without a question: sessions end properly, unsaved work is kept for recovery.
    void endQuietly();

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void layOut();
    void connectActions();
    void connectWorkbench();
    void connectViewDevice();
    void connectPen();
    static QString updateText(const PartUpdate& update);
    QString programPathText(const ProgramPasses& passes) const;
    void connectWelcome();
    void showStep(JobStep step);
    void showWorkSteps(bool shown);
    void showWelcome();
    void followPage();
    void followPreview();
    void goBack();
    void escape();
    void lookForLeftWork();
    void beginFirstJob();
    void connectFirstJob();
    void tellAboutBattery(double share);
    void updateTitle();
    void dress(Theme theme);
    void apply(const Preferences& preferences, const Preferences& before);
    QMainWindow* makeView(); ///< the viewport and the bar below it, surrounded by docks
    void layOutTree();
    void layOutHistory();
    void resetLayout();
    void takeShortcuts(); ///< sets those that the user chose
    void showShortcuts();
    void showHelp();
    void followDocks();
    void layOutTimeline();
    void setUnit(LengthUnit unit);
    void showPreferences();
    void showKeys();
    void removeTake(qint64 take);
    void overrideCheck();
    void showMachines();
    void showTools();
    void showMaterials();
    void showDevices();
    void showScore();
    void followFelt();
    void followStockLayer();
    void tellAboutOpened();
    LeftAt leftAt() const;
    void goTo(const LeftAt& left);
    void end(bool abandon);

    UserSettings settings_;
    Workbench workbench_;
    Actions actions_;
    ActionStates states_;
    DocumentFlow flow_;
    QStackedWidget* pages_ = nullptr;
    WelcomePage* welcome_ = nullptr;
    QSplitter* work_ = nullptr; ///< the view, and the panel next to it
    QWidget* workPage_ = nullptr;
    Viewport* viewport_ = nullptr;
    ViewBar* viewBar_ = nullptr;
    QMainWindow* view_ = nullptr; ///< both, with space for docks
    ProgramDock* programDock_ = nullptr;
    TimelinePanel* timeline_ = nullptr;
    ViewDock* timelineDock_ = nullptr;
    ProjectTree* tree_ = nullptr;
    ViewDock* treeDock_ = nullptr;
    ViewDock* historyDock_ = nullptr;
    QByteArray firstDocks_, firstWork_; ///< initial layout, before the user changed it
    QPointer<QWidget> leftFrom_;        ///< widget that had the focus before the welcome page was shown
    StepBar* stepBar_ = nullptr;
    PanelStack* panels_ = nullptr;
    StatusLine* status_ = nullptr;
    MessageStrip* message_ = nullptr;
    Menus* menus_ = nullptr;
    std::unique_ptr<Presenters> presenters_;
    std::unique_ptr<Coach> coach_;
    QTimer lookAgain_; ///< for unsaved work of ended processes
    /// Whether a preview is shown, and whether it was opened from the welcome page
    bool previewShown_ = false, fromWelcome_ = false;
    bool ending_ = false, ended_ = false;
};

} // namespace burin
