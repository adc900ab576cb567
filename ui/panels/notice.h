// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

class QLabel;

namespace burin {

/// A sentence with an icon: never told by colour alone. Hidden while it has none.
class Notice : public QFrame {
    Q_OBJECT
public:
    enum class Kind { information, passed, warning, error };
    explicit Notice(QWidget* parent = nullptr);

    void tell(Kind kind, const QString& sentence); ///< an empty one hides it
    void clear() { tell(Kind::information, {}); }
    QString sentence() const;
    Kind kind() const noexcept { return kind_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QLabel* text_ = nullptr;
    Kind kind_ = Kind::information;
};

} // namespace burin
