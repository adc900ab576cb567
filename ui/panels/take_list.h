// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/mill_states.h"

#include <QWidget>

class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace burin {

class ElidedLabel;

/// The takes, the newest first, each with a button that requests its removal. The height is always that of three takes;
/// a longer list scrolls.
class TakeList : public QWidget {
    Q_OBJECT
public:
    /// @param whenEmpty text shown if there are no takes
    explicit TakeList(const QString& whenEmpty, QWidget* parent = nullptr);
    void setTakes(const std::vector<TakeRow>& takes); ///< does nothing if they are unchanged
    void setRemovable(bool removable);

signals:
    void removalRequested(qint64 take);

private:
    struct Row {
        QWidget* widget = nullptr;
        ElidedLabel *name = nullptr, *detail = nullptr;
        QLabel* duration = nullptr;
        QToolButton* remove = nullptr;
    };
    Row makeRow(const TakeRow& take);
    void show(const Row& row, const TakeRow& take);
    void makeRows(const std::vector<TakeRow>& takes);
    void showEmpty(bool empty);

    QVBoxLayout* layout_ = nullptr;
    QLabel* empty_;
    QScrollArea* area_ = nullptr;
    std::vector<Row> rows_;      ///< in the order of takes_
    std::vector<TakeRow> takes_; ///< the takes that are shown
    bool removable_ = true;
};

} // namespace burin
