// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/file_dialogs.h"

#include "core/cad/import_formats.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QStringList>

namespace burin {

namespace {

/// Translation context of this file.
struct FileDialogs {
    Q_DECLARE_TR_FUNCTIONS(FileDialogs)
};

QStringList modelGlobs() {
    QStringList globs;
    for (const std::string_view suffix : importSuffixes()) {
        const QString glob = QStringLiteral("*.") + QString::fromUtf8(suffix.data(), qsizetype(suffix.size()));
        globs << glob << glob.toUpper(); // file names are compared case-sensitively
    }
    return globs;
}

QString models() {
    return FileDialogs::tr("Parts (%1);;All files (*)").arg(modelGlobs().join(QLatin1Char(' ')));
}

QString ask(QFileDialog& dialog, const QString& folder) {
    dialog.setObjectName(QStringLiteral("fileDialog"));
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.setDirectory(folder);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
    return dialog.selectedFiles().constFirst();
}

QString askToOpen(QWidget* parent, const QString& title, const QString& folder, const QString& filter) {
    QFileDialog dialog(parent, title);
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setOption(QFileDialog::DontUseNativeDialog); // before its widgets are asked for
    // A list of suffixes is longer than the field that shows it.
    dialog.setOption(QFileDialog::HideNameFilterDetails);
    dialog.setNameFilter(filter);
    if (auto* kinds = dialog.findChild<QComboBox*>(QStringLiteral("fileTypeCombo")))
        kinds->setToolTip(dialog.nameFilters().constFirst());
    return ask(dialog, folder);
}

QString askToSave(QWidget* parent, const QString& title, const QString& folder, const QString& name,
                  const QString& ending, const QString& filter) {
    QFileDialog dialog(parent, title);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setDefaultSuffix(ending);
    dialog.setNameFilter(filter);
    dialog.setDirectory(folder);
    dialog.selectFile(name);
    return ask(dialog, folder);
}

} // namespace

QString askProjectToOpen(QWidget* parent, const QString& folder) {
    return askToOpen(
        parent, FileDialogs::tr("Open a project"), folder,
        FileDialogs::tr("Burin projects (*.burin)") + QStringLiteral(";;") +
            FileDialogs::tr("NC programs (%1)").arg(QStringLiteral("*.ngc *.nc *.tap *.gcode *.cnc *.mpf *.txt")) +
            QStringLiteral(";;") + FileDialogs::tr("All files (*)"));
}

QString askProgramToRead(QWidget* parent, const QString& folder) {
    return askToOpen(parent, FileDialogs::tr("Path from a program"), folder,
                     FileDialogs::tr("Programs and cutter locations (%1);;All files (*)")
                         .arg(QStringLiteral("*.ngc *.nc *.tap *.gcode *.cnc *.mpf *.txt *.cls *.ncl *.cl *.apt "
                                             "*.aptsource")));
}

QString askPartToImport(QWidget* parent, const QString& folder) {
    return askToOpen(parent, FileDialogs::tr("Import a part"), folder, models());
}

QString askFixtureToImport(QWidget* parent, const QString& folder) {
    return askToOpen(parent, FileDialogs::tr("Import a fixture"), folder, models());
}

QString askStockToRead(QWidget* parent, const QString& folder) {
    const QStringList volumes{QStringLiteral("*.srle"), QStringLiteral("*.nrrd"), QStringLiteral("*.nhdr"),
                              QStringLiteral("*.json")};
    return askToOpen(parent, FileDialogs::tr("Stock from a file"), folder,
                     FileDialogs::tr("Volumes, voxel arrays and models (%1);;All files (*)")
                         .arg((volumes + modelGlobs()).join(QLatin1Char(' '))));
}

QString askDrawingToRead(QWidget* parent, const QString& folder) {
    return askToOpen(parent, FileDialogs::tr("Drawing"), folder,
                     FileDialogs::tr("Drawings (*.dxf *.svg *.DXF *.SVG);;All files (*)"));
}

QString askToolToAdd(QWidget* parent, const QString& folder) {
    return askToOpen(parent, FileDialogs::tr("Add a tool"), folder,
                     FileDialogs::tr("Tools (*.json *.tools *.fctb *.fctl *.ctbl *.tbl);;All files (*)"));
}

QString askToolModel(QWidget* parent, const QString& folder, const QString& title) {
    return askToOpen(parent, title, folder,
                     FileDialogs::tr("Models (%1);;All files (*)").arg(modelGlobs().join(QLatin1Char(' '))));
}

QString askArrayTable(QWidget* parent, const QString& folder, const QString& array) {
    return askToOpen(parent, FileDialogs::tr("Materials of the values in %1").arg(array), folder,
                     FileDialogs::tr("Tables (*.json);;All files (*)"));
}

QString askMaterialToAdd(QWidget* parent, const QString& folder) {
    return askToOpen(parent, FileDialogs::tr("Add a material"), folder,
                     FileDialogs::tr("Materials (*.json *.FCMat);;All files (*)"));
}

QString askForcesToRead(QWidget* parent, const QString& folder) {
    return askToOpen(parent, FileDialogs::tr("Measured forces"), folder,
                     FileDialogs::tr("Tables (*.csv);;All files (*)"));
}

QString askMachineToAdd(QWidget* parent, const QString& folder) {
    return askToOpen(parent, FileDialogs::tr("Add a machine"), folder, FileDialogs::tr("Machines (*.json)"));
}

QString askProjectToSave(QWidget* parent, const QString& folder, const QString& name) {
    return askToSave(parent, FileDialogs::tr("Save the project"), folder, name, QStringLiteral("burin"),
                     FileDialogs::tr("Burin projects (*.burin)"));
}

QString askProgramToExport(QWidget* parent, const QString& folder, const QString& name) {
    return askToSave(parent, FileDialogs::tr("Export the program"), folder, name, QFileInfo(name).suffix(),
                     FileDialogs::tr("Programs (*.ngc *.nc *.tap);;All files (*)"));
}

QString askToolExport(QWidget* parent, const QString& folder, const QString& name) {
    return askToSave(parent, FileDialogs::tr("Export tools"), folder, name, QStringLiteral("fctb"),
                     FileDialogs::tr("Tools for other programs (*.fctl *.fctb *.tbl *.tools *.ctbl *.json)"));
}

QString askPictureToExport(QWidget* parent, const QString& folder, const QString& name) {
    return askToSave(parent, FileDialogs::tr("Export a picture"), folder, name, QStringLiteral("png"),
                     FileDialogs::tr("Pictures (*.png)"));
}

QString askTraceToRecord(QWidget* parent, const QString& folder, const QString& name) {
    return askToSave(parent, FileDialogs::tr("Record a session trace"), folder, name, QStringLiteral("csv"),
                     FileDialogs::tr("Traces (*.csv)"));
}

QString askFacesToExport(QWidget* parent, const QString& folder, const QString& name) {
    return askToSave(parent, FileDialogs::tr("Export the table of faces"), folder, name, QStringLiteral("csv"),
                     FileDialogs::tr("Tables (*.csv)"));
}

QString askSheetToExport(QWidget* parent, const QString& folder, const QString& name) {
    return askToSave(parent, FileDialogs::tr("Export the setup sheet"), folder, name, QStringLiteral("html"),
                     FileDialogs::tr("Web pages (*.html)"));
}

QString askWorkpieceToExport(QWidget* parent, const QString& folder, const QString& name) {
    return askToSave(parent, FileDialogs::tr("Export the workpiece"), folder, name, QStringLiteral("stl"),
                     FileDialogs::tr("Surfaces and voxels (*.stl *.ply *.3mf *.srle *.nrrd)"));
}

} // namespace burin
