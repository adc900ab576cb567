// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/notice.h"

#include <QWidget>

namespace burin {

/// One sentence over the top of what the user looks at, which may be put away. It never stops anybody's work: nothing
/// moves for it, and it covers no field and no view cube.
class MessageStrip final : public QWidget {
    Q_OBJECT
public:
    explicit MessageStrip(QWidget* parent = nullptr);

    /// What it lies over from now on. It outlives this.
    /// @param freeAtRight  pixels at the area's right side that it never covers
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
};

} // namespace burin
