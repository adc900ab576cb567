// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QPointer>
#include <QSet>
#include <QTimer>

#include <vector>

namespace burin {

/// Applies another style sheet without a stall: visible widgets are styled at once, hidden ones in small batches
/// between events or when they are shown, whichever comes first. No widget is visible in the old style. GUI thread.
class Restyling final : public QObject {
public:
    explicit Restyling(QApplication& application); ///< becomes a child of `application`
    void begin(const QString& sheet);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void collect(QWidget& widget, std::vector<QPointer<QWidget>>& visible);
    void stylePiece();

    QApplication& application_;
    std::vector<QPointer<QWidget>> hidden_; ///< not styled yet, unless shown in the meantime
    QSet<QObject*> pending_;                ///< widgets of `hidden_` that have not been shown yet
    QTimer pieces_;
};

} // namespace burin
