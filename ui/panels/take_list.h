// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/panel_states.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace burin {

class ElidedLabel;

/// The takes, the newest first, each with a button that asks for its removal.
class TakeList : public QWidget {
    Q_OBJECT
public:
    explicit TakeList(QWidget* parent = nullptr);
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
    Row makeRow(std::int64_t take);
    void show(const Row& row, const TakeRow& take);
    void makeRows(const std::vector<TakeRow>& takes);

    QVBoxLayout* layout_ = nullptr;
    std::vector<Row> rows_;      ///< as takes_
    std::vector<TakeRow> takes_; ///< that are shown
    bool removable_ = true;
};

} // namespace burin
