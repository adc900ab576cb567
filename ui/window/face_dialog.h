// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/window/face_table_model.h"

#include <QDialog>
#include <QSortFilterProxyModel>

#include <optional>
#include <string>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace burin {

class Notice;

/// A modeless dialog with a table of the faces of the part and what a program leaves on each. A click on a header sorts
/// the table. Its object name is "faceDialog"; it contains "faceTable", "faceSummary", "faceNotice", "faceProgress",
/// "cancelFacesButton", "copyFacesButton", "exportFacesButton".
class FaceDialog final : public QDialog {
    Q_OBJECT
public:
    explicit FaceDialog(QWidget* parent);

    void setUnit(LengthUnit unit) { model_.setUnit(unit); }
    /// @param faces the worst first; null: none @param problem why there are none; empty: no message
    void setFaces(const FaceTableModel::Faces& faces, const QString& problem);
    /// Sets the progress of the inspection. @param fraction 0 … 1; std::nullopt if none is running
    void setProgress(std::optional<double> fraction);

signals:
    void faceChosen(const burin::FaceQuality& face);
    void cancelRequested();
    void exportRequested(const std::string& table);
    void closed();

protected:
    void done(int result) override;

private:
    void layOut();
    void choose(const QModelIndex& index);
    void copy();
    std::vector<FaceQuality> shownFaces() const; ///< in row order
    QString summary() const;

    FaceTableModel model_;
    QSortFilterProxyModel sorted_;
    bool justChosen_ = false; ///< by the event being handled
    QTableView* table_ = nullptr;
    QLabel* summary_ = nullptr;
    Notice* notice_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton *cancel_ = nullptr, *copy_ = nullptr, *export_ = nullptr;
};

} // namespace burin
