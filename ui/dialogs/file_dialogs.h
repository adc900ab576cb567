// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QWidget;

namespace burin {

// Qt's own file dialogs, the same on every desktop; empty when the user cancels. Object name "fileDialog".

QString askProjectToOpen(QWidget* parent, const QString& folder);
QString askProgramToRead(QWidget* parent, const QString& folder);
QString askPartToImport(QWidget* parent, const QString& folder);
QString askFixtureToImport(QWidget* parent, const QString& folder);
/// A volume file, a voxel array or a model.
QString askStockToRead(QWidget* parent, const QString& folder);
/// DXF or SVG.
QString askDrawingToRead(QWidget* parent, const QString& folder);
/// Burin's own form.
QString askToolToAdd(QWidget* parent, const QString& folder);
/// Where a tool is written to, or the table of all. @param name that is proposed for it
QString askToolExport(QWidget* parent, const QString& folder, const QString& name);
/// A model of flutes or shank. @param title of the dialog
QString askToolModel(QWidget* parent, const QString& folder, const QString& title);
/// What the values of a voxel array mean. @param array name of its file
QString askArrayTable(QWidget* parent, const QString& folder, const QString& array);
/// Burin's own form or a FreeCAD card.
QString askMaterialToAdd(QWidget* parent, const QString& folder);
/// Measured cutting forces, CSV.
QString askForcesToRead(QWidget* parent, const QString& folder);
QString askMachineToAdd(QWidget* parent, const QString& folder);
/// With the ending .burin.
QString askProjectToSave(QWidget* parent, const QString& folder, const QString& name);
/// With the ending .ngc unless the user gave another.
QString askProgramToExport(QWidget* parent, const QString& folder, const QString& name);
/// With the ending .stl unless the user gave another.
/// One page. @param name without its ending; empty: cancelled
QString askSheetToExport(QWidget* parent, const QString& folder, const QString& name);
QString askPictureToExport(QWidget* parent, const QString& folder, const QString& name);
QString askWorkpieceToExport(QWidget* parent, const QString& folder, const QString& name);

} // namespace burin
