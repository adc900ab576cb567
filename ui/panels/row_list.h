// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <QListWidget>

#include <vector>

namespace burin {

/// One row: a title with a value on the right, and a second line in subdued text.
struct ListRow {
    QString title, value, detail, toolTip;
    QString badge; ///< a word in a frame before the value; empty: none
    QString icon;  ///< name of a themed icon; empty: none
    ColourRole iconRole = &Palette::text;
    QColor swatch; ///< of a material; invalid: none
    bool operator==(const ListRow&) const = default;
};

/// A list whose height follows its number of rows up to a maximum; beyond that it scrolls.
class RowList : public QListWidget {
    Q_OBJECT
public:
    explicit RowList(QWidget* parent = nullptr);
    void setMaximumRows(int rows);
    /// Sets the number of rows that are always shown; more, up to the maximum, are shown if there is room.
    void setLeastRows(int rows);
    void setFillsHeight(bool fills); ///< whether the list fills the available height, regardless of its number of rows
    void setTextsWrap(bool wrap);    ///< titles and details are whole sentences, over several lines
    /// Shows rows without emitting a signal; does nothing if they are unchanged. The current row is kept if possible.
    void setRows(const std::vector<ListRow>& rows);
    void setChosen(int row); ///< emits no signal; -1: none
    const std::vector<ListRow>& rows() const noexcept { return rows_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The user selected a row by mouse or keyboard; also emitted when the selected row is clicked again.
    void rowChosen(int row);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    std::vector<ListRow> rows_;
    int heightOfRows(int rows) const;
    void followRows();

    int maximumRows_ = 6;
    int leastRows_ = 0; ///< 0: as the maximum
    int beforePress_ = -1;
};

} // namespace burin
