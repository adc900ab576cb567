// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QTreeWidget>

#include <optional>
#include <vector>

namespace burin {

/// The type of object that a row of the project tree represents.
enum class ProjectRowKind { group, setup, assembly, body, fixture, tool, take, path, pass, program };

/// A row with its child rows.
struct ProjectRow {
    ProjectRowKind kind = ProjectRowKind::group;
    qint64 id = 0; ///< unique among rows of its kind; for a group, its index
    QString name, detail, toolTip;
    bool current = false;     ///< in use
    bool dimmed = false;      ///< whether it is no longer in effect, or doesn't exist yet
    bool movable = false;     ///< can be dragged to another position among its siblings
    std::optional<bool> on{}; ///< state of its check box; empty: it has none
    bool partly = false;      ///< whether its check box is half ticked
    bool folded = false;      ///< whether its child rows are closed until the user opens it
    QColor swatch{};          ///< of a material; invalid: none
    std::vector<ProjectRow> children{};
    bool operator==(const ProjectRow&) const = default;
};

/// The contents of a project as a tree; rows in use are bold. A double click or Enter opens a row, its check box
/// switches it, the right button opens its menu. Movable rows are dragged among their siblings; a line shows where a
/// row will be dropped, and on their heading it is dropped at the end.
class ProjectTree final : public QTreeWidget {
    Q_OBJECT
public:
    explicit ProjectTree(QWidget* parent = nullptr);
    /// Does nothing if the rows are unchanged. Groups stay open or closed, and the selected row stays selected.
    void setRows(const std::vector<ProjectRow>& rows);
    void choose(ProjectRowKind kind, qint64 id); ///< selects that row if it exists

signals:
    void chosen(ProjectRowKind kind, qint64 id); ///< its row was selected
    void opened(ProjectRowKind kind, qint64 id);
    void switched(ProjectRowKind kind, qint64 id, bool on);
    void menuRequested(ProjectRowKind kind, qint64 id, const QPoint& globalPosition);
    /// A row was dragged before another one of its kind; `before` -1: to the end.
    void moved(ProjectRowKind kind, qint64 id, qint64 before);

protected:
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    bool dropMimeData(QTreeWidgetItem* parent, int index, const QMimeData* data, Qt::DropAction action) override;
    void dropEvent(QDropEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override; ///< updates the colours of the theme

private:
    QTreeWidgetItem* itemOf(const ProjectRow& node) const;
    void fill(QTreeWidgetItem& item, const ProjectRow& node) const;
    QTreeWidgetItem* itemWith(ProjectRowKind kind, qint64 id);

    std::vector<ProjectRow> rows_;
    bool filling_ = false;
};

} // namespace burin
