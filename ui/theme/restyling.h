// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QPointer>
#include <QSet>
#include <QTimer>

#include <vector>

namespace burin {

/// Puts another style sheet in force without a stall: visible widgets are styled at once, hidden ones in pieces between
/// events or when they are shown, whichever comes first. No widget is seen in the old style. GUI thread.
class Restyling final : public QObject {
public:
    explicit Restyling(QApplication& application); ///< its child
    void begin(const QString& sheet);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void collect(QWidget& widget, std::vector<QPointer<QWidget>>& visible);
    void stylePiece();

    QApplication& application_;
    std::vector<QPointer<QWidget>> hidden_; ///< not styled yet, unless shown meanwhile
    QSet<QObject*> pending_;                ///< those of them that were not shown
    QTimer pieces_;
};

} // namespace burin
