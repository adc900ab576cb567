// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include <vector>

class QLabel;

namespace burin {

/// A sentence with an icon: never told by colour alone. Hidden while it has none.
class Notice : public QFrame {
    Q_OBJECT
public:
    enum class Kind { information, passed, warning, error };
    explicit Notice(QWidget* parent = nullptr);

    void tell(Kind kind, const QString& sentence); ///< an empty one hides it
    /// A longer sentence ends in "…" and is the tooltip in whole.
    void setMaximumLines(int lines);
    int heightOfLines(int lines) const; ///< pixels
    void clear() { tell(Kind::information, {}); }
    QString sentence() const;
    Kind kind() const noexcept { return kind_; }

signals:
    void told();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showText();

    QLabel* text_ = nullptr;
    QString sentence_;
    Kind kind_ = Kind::information;
    int maximumLines_ = 0; ///< 0: as many as it takes
};

/// Room that is kept for notices which come and go by themselves, so that nothing below moves under the hand. One of
/// them is seen: the first that has a sentence. A button that belongs to a short one may stand below it, in the same
/// room.
class NoticePlace : public QWidget {
    Q_OBJECT
public:
    explicit NoticePlace(QWidget* parent = nullptr);
    Notice* add(const char* name);   ///< after those that matter more; owned by this
    void setFoot(QWidget* foot);     ///< hidden until it is wanted; owned by this
    void setFootWanted(bool wanted); ///< the notice above it has one line then

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {1, sizeHint().height()}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showFirst();

    std::vector<Notice*> notices_;
    QWidget* foot_ = nullptr;
    bool footWanted_ = false;
};

} // namespace burin
