// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QWidget;

namespace burin {

// Qt's own file dialogs, the same on every desktop; empty if the user cancels. Object name "fileDialog".

QString askProjectToOpen(QWidget* parent, const QString& folder);
QString askProgramToRead(QWidget* parent, const QString& folder);
QString askPartToImport(QWidget* parent, const QString& folder);
QString askFixtureToImport(QWidget* parent, const QString& folder);
/// A volume file, a voxel array or a model.
QString askStockToRead(QWidget* parent, const QString& folder);
/// DXF or SVG.
QString askDrawingToRead(QWidget* parent, const QString& folder);
/// Burin's own format.
QString askToolToAdd(QWidget* parent, const QString& folder);
/// Asks for the file to which a tool, or the table of all tools, is exported. @param name proposed file name
QString askToolExport(QWidget* parent, const QString& folder, const QString& name);
/// A model of flutes or shank. @param title of the dialog
QString askToolModel(QWidget* parent, const QString& folder, const QString& title);
/// The table with the meaning of the values of a voxel array. @param array name of its file
QString askArrayTable(QWidget* parent, const QString& folder, const QString& array);
/// Burin's own format or a FreeCAD card.
QString askMaterialToAdd(QWidget* parent, const QString& folder);
/// Measured cutting forces, CSV.
QString askForcesToRead(QWidget* parent, const QString& folder);
QString askMachineToAdd(QWidget* parent, const QString& folder);
/// With the suffix .burin.
QString askProjectToSave(QWidget* parent, const QString& folder, const QString& name);
/// With the suffix .ngc unless the user entered another.
QString askProgramToExport(QWidget* parent, const QString& folder, const QString& name);
/// One page. @param name without its suffix; empty: cancelled
QString askSheetToExport(QWidget* parent, const QString& folder, const QString& name);
QString askPictureToExport(QWidget* parent, const QString& folder, const QString& name);
/// With the suffix .csv unless the user entered another.
QString askTraceToRecord(QWidget* parent, const QString& folder, const QString& name);
QString askFacesToExport(QWidget* parent, const QString& folder, const QString& name);
/// With the suffix .stl unless the user entered another.
QString askWorkpieceToExport(QWidget* parent, const QString& folder, const QString& name);

} // namespace burin
