// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/mill_states.h"

#include <QWidget>

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace burin {

class ElidedLabel;

/// The takes, the newest first, each with a button that asks for its removal. As high as three of them, whether they
/// are there or not: more are scrolled to.
class TakeList : public QWidget {
    Q_OBJECT
public:
    /// @param whenEmpty what is said where there are none
    explicit TakeList(const QString& whenEmpty, QWidget* parent = nullptr);
    void setTakes(const std::vector<TakeRow>& takes); ///< nothing is done when it shows them
    void setRemovable(bool removable);

signals:
    void removalRequested(qint64 take);

private:
    struct Row {
        QWidget* widget = nullptr;
        ElidedLabel *name = nullptr, *detail = nullptr;
        QLabel* duration = nullptr;
    };
    Row makeRow(const TakeRow& take);
    void show(const Row& row, const TakeRow& take);
    void makeRows(const std::vector<TakeRow>& takes);
    void showEmpty(bool empty);

    QVBoxLayout* layout_ = nullptr;
    QLabel* empty_;
    QScrollArea* area_ = nullptr;
    std::vector<Row> rows_;      ///< as takes_
    std::vector<TakeRow> takes_; ///< that are shown
    bool removable_ = true;
};

} // namespace burin
