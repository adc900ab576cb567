// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/dialogs/preferences.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace burin {

/// New, open, import, save, export, close: what the user is asked on the way, and what is done then.
class DocumentFlow final : public QObject {
    Q_OBJECT
public:
    /// All outlive it. @param window parent of the dialogs
    DocumentFlow(Workbench& workbench, UserSettings& settings, QWidget& window);

    void connectActions(const Actions& actions);
    void createNew();
    void open();
    void import();
    void importFile(const QString& file,
                    double fileUnit = 1.0); ///< @param fileUnit mm per unit of a file that states none
    void importAgain(double fileUnit);      ///< the part, whose file meant another unit
    void updatePart();                      ///< from its file, or one that the user chooses where that is gone
    void importFixture();                   ///< that the tool keeps out of
    void importSample();
    void showSample(); ///< imports the sample part and lets the virtual operator mill it
    /// A project or a part, as its content says. The file is looked at, and read as a whole, before anything is asked
    /// or what is open changes; a file that can't be used costs a sentence and nothing else.
    void openAny(const QString& file);
    void save();
    void saveAs();
    void exportProgram();
    void readStock(); ///< from a file
    void shapeTool(); ///< of models
    void exportWorkpiece();
    void exportSheet();
    /// Asks for a file and writes a picture to it.
    void exportPicture(const QImage& picture);
    void addProgramPath(); ///< asks for the program
    /// The rest of the program from a line of its text on; asks for the file once it passed its check.
    void restartProgram(int line);

    /// Asks about unsaved changes and calls `then` unless the user cancels or saving fails.
    /// @param then is told whether the changes are discarded
    void settle(std::function<void(bool abandon)> then);
    /// Ends session and project as `settle` decided, then calls `then`.
    void closeProject(bool abandon, std::function<void()> then);

signals:
    void recentFilesChanged();
    void begun();                          ///< another file is looked at: what was said of the last one is past
    void alreadyOpen();                    ///< what was to be opened is the open project
    void refused(const QString& sentence); ///< a file, and why; nothing has changed
    void programOpened();                  ///< its text is the program's now, unchecked
    void exported(const QString& file);    ///< a program
    void workpieceExported(const QString& file);
    void sheetExported(const QString& file);
    void pictureExported(const QString& file);
    void restartExported(int line, const QString& file);

private:
    void writeSheet(const std::shared_ptr<const SheetContent>& content, const QString& file);
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
    bool asking_ = false; ///< a question stands open
};

/// The part that Burin is shipped with.
QString samplePart();

} // namespace burin
