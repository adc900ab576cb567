// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QTreeWidget>

#include <optional>
#include <vector>

namespace burin {

/// What a row of the project's tree stands for.
enum class ProjectRowKind { group, setup, body, fixture, tool, take, path, pass, program };

/// A row with those below it.
struct ProjectRow {
    ProjectRowKind kind = ProjectRowKind::group;
    qint64 id = 0; ///< among those of its kind; of a group its place
    QString name, detail, toolTip;
    bool current = false;     ///< in use
    bool dimmed = false;      ///< it counts no more, or is not there yet
    std::optional<bool> on{}; ///< a box to be ticked; nothing: it has none
    QColor swatch{};          ///< of a material; invalid: none
    std::vector<ProjectRow> children{};
    bool operator==(const ProjectRow&) const = default;
};

/// All that a project holds, as a tree: what is in use in bold. A double click or Enter opens a row, a box switches it,
/// the right button offers more.
class ProjectTree final : public QTreeWidget {
    Q_OBJECT
public:
    explicit ProjectTree(QWidget* parent = nullptr);
    /// Nothing is done where it shows them. Groups stay open or closed, and the selected row stays selected.
    void setRows(const std::vector<ProjectRow>& rows);

signals:
    void opened(ProjectRowKind kind, qint64 id);
    void switched(ProjectRowKind kind, qint64 id, bool on);
    void menuWanted(ProjectRowKind kind, qint64 id, const QPoint& globalPosition);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override; ///< colours are the theme's

private:
    QTreeWidgetItem* itemOf(const ProjectRow& node) const;
    void fill(QTreeWidgetItem& item, const ProjectRow& node) const;
    QTreeWidgetItem* itemWith(ProjectRowKind kind, qint64 id);

    std::vector<ProjectRow> rows_;
    bool filling_ = false;
};

} // namespace burin
