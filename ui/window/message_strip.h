// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/notice.h"

#include <QWidget>

class QToolButton;

namespace burin {

/// One sentence above the top of the work area, which can be dismissed. It never interrupts work: it moves nothing, and
/// covers no field and no view cube.
class MessageStrip final : public QWidget {
    Q_OBJECT
public:
    explicit MessageStrip(QWidget* parent = nullptr);

    /// Sets the widget that it covers; the widget outlives it.
    /// @param freeAtRight  pixels at the right side of the area that are never covered
    void layOver(QWidget* area, int freeAtRight = 0);
    void tell(Notice::Kind kind, const QString& sentence);
    void dismiss();
    QString sentence() const { return notice_->sentence(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fit();

    QWidget* area_ = nullptr;
    int freeAtRight_ = 0; ///< pixels
    Notice* notice_ = nullptr;
    QToolButton* close_ = nullptr;
};

} // namespace burin
