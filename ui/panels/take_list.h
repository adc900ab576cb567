// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/panel_states.h"

#include <QWidget>

class QVBoxLayout;

namespace burin {

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
    QWidget* makeRow(const TakeRow& take);

    QVBoxLayout* rows_ = nullptr;
    std::vector<TakeRow> takes_;
    bool removable_ = true;
};

} // namespace burin
