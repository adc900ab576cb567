// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/notice.h"

#include <QWidget>

namespace burin {

/// One sentence above the viewport that the user may put away; it never stops anybody's work.
class MessageStrip final : public QWidget {
    Q_OBJECT
public:
    explicit MessageStrip(QWidget* parent = nullptr);

    void tell(Notice::Kind kind, const QString& sentence);
    void dismiss();
    QString sentence() const { return notice_->sentence(); }

private:
    Notice* notice_ = nullptr;
};

} // namespace burin
