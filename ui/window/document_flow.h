// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/dialogs/preferences.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QPointer>
#include <QWidget>

#include <memory>

namespace burin {

/// New, open, import, save, export, close: the questions to the user, and the operations.
class DocumentFlow final : public QObject {
    Q_OBJECT
public:
    /// All arguments outlive it. @param window parent of the dialogs
    DocumentFlow(Workbench& workbench, UserSettings& settings, QWidget& window);

    void connectActions(const Actions& actions);
    void createNew();
    void open();
    void import();
    void importFile(const QString& file);
    void importAgain(double unit); ///< the part, in another unit than before. @param unit mm
    void updatePart();             ///< from its file, or one that the user chooses if that no longer exists
    void importFixture();          ///< a fixture that the tool keeps clear of
    void importSample();
    void showSample(); ///< imports the sample part and lets the virtual operator mill it
    /// Opens a project or a part, as its content indicates. The file is read completely before any question is asked or
    /// the open project changes; a file that can't be used only causes a message.
    void openAny(const QString& file);
    void save();
    void saveAs();
    void exportProgram();
    void readStock(); ///< from a file
    void shapeTool(); ///< from models
    void exportWorkpiece();
    void exportSheet();
    /// Records the sessions of mill mode as traces, in a file that it asks for; or records no more.
    void recordTrace(bool on);
    /// Asks for a file and writes a picture to it.
    void exportPicture(const QImage& picture);
    void exportFaces(const std::string& table); ///< asks for a file and writes the table of the part's faces to it
    void addProgramPath();                      ///< asks for the program file
    /// Makes the remaining program from a line of its text on; asks for the file once it passed its check.
    void restartProgram(int line);

    /// Asks about unsaved changes and calls `then` unless the user cancels or saving fails.
    /// @param then its argument tells whether to discard the changes
    void settle(std::function<void(bool abandon)> then);
    /// Calls `then` once no setup sheet is being written: closing the project, which the user asked for later, must not
    /// lose it. The sheet can be cancelled like any task. Does nothing while an earlier call is waiting.
    void whenSheetIsWritten(std::function<void()> then);
    /// Ends session, tasks and project as decided in `settle`, then calls `then`.
    void closeProject(bool abandon, std::function<void()> then);

signals:
    void recentFilesChanged();
    void begun();                          ///< another file is being read: messages about the last one are obsolete
    void alreadyOpen();                    ///< the file to open is the open project
    void refused(const QString& sentence); ///< the file and the reason; nothing has changed
    void programOpened();                  ///< its text is now that of the program, unchecked
    void exported(const QString& file);    ///< a program
    void workpieceExported(const QString& file);
    void pictureExported(const QString& file);
    void facesExported(const QString& file);
    void restartExported(int line, const QString& file);

private:
    void adopt(const std::shared_ptr<const Model>& part);
    void awaitSheet(std::function<void()> then);
    void openProject(const QString& file);
    void openProgram(const QString& file);
    void addProgramPath(const QString& file);
    void refuse(const QString& file, const Error& error);
    void saveThen(std::function<void()> then);
    void saveAsThen(std::function<void()> then);
    void noteSaved();
    QString folder() const;
    void keepFolder(const QString& file);
    void exportRestart(const RestartedProgram& rest);

    Workbench& workbench_;
    UserSettings& settings_;
    QWidget& window_;
    bool asking_ = false;        ///< a question is open
    bool awaitingSheet_ = false; ///< whenSheetIsWritten is waiting
};

/// The part shipped with Burin.
QString samplePart();

} // namespace burin
