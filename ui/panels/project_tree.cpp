// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/project_tree.h"

#include "ui/theme/theme.h"

#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QDropEvent>
#include <QHeaderView>
#include <QMimeData>
#include <QPixmap>

#include <algorithm>
#include <map>
#include <utility>

namespace burin {

namespace {

constexpr int kindRole = Qt::UserRole, idRole = Qt::UserRole + 1, foldedRole = Qt::UserRole + 2;
constexpr int swatchSide = 10; // pixels

ProjectRowKind kindOf(const QTreeWidgetItem& item) {
    return static_cast<ProjectRowKind>(item.data(0, kindRole).toInt());
}

qint64 idOf(const QTreeWidgetItem& item) {
    return item.data(0, idRole).toLongLong();
}

/// What is dragged, for this process alone.
QString rowFormat() {
    return QStringLiteral("application/x-burin-row-%1").arg(QCoreApplication::applicationPid());
}

bool hasMovableRows(const ProjectRow& node) {
    return std::ranges::any_of(node.children, &ProjectRow::movable);
}

} // namespace

ProjectTree::ProjectTree(QWidget* parent) : QTreeWidget(parent) {
    setObjectName(QStringLiteral("projectTree"));
    setAccessibleName(tr("Project"));
    setColumnCount(2);
    setHeaderHidden(true);
    setUniformRowHeights(true);
    setExpandsOnDoubleClick(false);
    setTextElideMode(Qt::ElideMiddle);
    setDragDropMode(QAbstractItemView::DragDrop);
    setDefaultDropAction(Qt::MoveAction);
    invisibleRootItem()->setFlags(invisibleRootItem()->flags() & ~Qt::ItemIsDropEnabled);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    connect(this, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        if (kindOf(*item) == ProjectRowKind::group || kindOf(*item) == ProjectRowKind::assembly)
            item->setExpanded(!item->isExpanded());
        else
            emit opened(kindOf(*item), idOf(*item));
    });
    connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!filling_ && item != nullptr) emit chosen(kindOf(*item), idOf(*item));
    });
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (!filling_ && column == 0 && item->data(0, Qt::CheckStateRole).isValid())
            emit switched(kindOf(*item), idOf(*item), item->checkState(0) == Qt::Checked);
    });
}

void ProjectTree::setRows(const std::vector<ProjectRow>& rows) {
    if (rows == rows_) return;
    rows_ = rows;
    filling_ = true;
    std::map<std::pair<int, qint64>, bool> open;
    for (QTreeWidgetItemIterator at(this); *at != nullptr; ++at)
        if ((*at)->childCount() > 0) open[{static_cast<int>(kindOf(**at)), idOf(**at)}] = (*at)->isExpanded();
    const QTreeWidgetItem* chosen = currentItem();
    const auto kind = chosen != nullptr ? kindOf(*chosen) : ProjectRowKind::group;
    const qint64 id = chosen != nullptr ? idOf(*chosen) : -1;
    clear();
    for (const ProjectRow& node : rows_) addTopLevelItem(itemOf(node));
    for (QTreeWidgetItemIterator at(this); *at != nullptr; ++at) {
        (*at)->setFirstColumnSpanned((*at)->text(1).isEmpty());
        if ((*at)->childCount() == 0) continue;
        const auto before = open.find({static_cast<int>(kindOf(**at)), idOf(**at)});
        (*at)->setExpanded(before != open.end() ? before->second : !(*at)->data(0, foldedRole).toBool());
    }
    if (QTreeWidgetItem* again = itemWith(kind, id)) setCurrentItem(again);
    filling_ = false;
}

void ProjectTree::choose(ProjectRowKind kind, qint64 id) {
    QTreeWidgetItem* item = itemWith(kind, id);
    if (item == nullptr || item == currentItem()) return;
    const bool before = std::exchange(filling_, true);
    setCurrentItem(item);
    filling_ = before;
}

QTreeWidgetItem* ProjectTree::itemOf(const ProjectRow& node) const {
    auto* item = new QTreeWidgetItem; // owned by the tree or by its parent item
    fill(*item, node);
    for (const ProjectRow& child : node.children) item->addChild(itemOf(child));
    return item;
}

void ProjectTree::fill(QTreeWidgetItem& item, const ProjectRow& node) const {
    item.setText(0, node.name);
    item.setText(1, node.detail);
    item.setToolTip(0, node.toolTip);
    item.setToolTip(1, node.toolTip);
    item.setData(0, kindRole, static_cast<int>(node.kind));
    item.setData(0, idRole, node.id);
    item.setData(0, foldedRole, node.folded);
    item.setFlags((item.flags() & ~(Qt::ItemIsDragEnabled | Qt::ItemIsDropEnabled)) |
                  (node.movable ? Qt::ItemIsDragEnabled : Qt::NoItemFlags) |
                  (hasMovableRows(node) ? Qt::ItemIsDropEnabled : Qt::NoItemFlags));
    QFont own = font();
    own.setBold(node.current);
    item.setFont(0, own);
    item.setForeground(1, activePalette().quietText);
    if (node.dimmed) item.setForeground(0, activePalette().quietText);
    if (node.on) item.setCheckState(0, node.partly ? Qt::PartiallyChecked : *node.on ? Qt::Checked : Qt::Unchecked);
    if (node.swatch.isValid()) {
        QPixmap swatch(swatchSide, swatchSide);
        swatch.fill(node.swatch);
        item.setIcon(0, swatch);
    }
}

QTreeWidgetItem* ProjectTree::itemWith(ProjectRowKind kind, qint64 id) {
    for (QTreeWidgetItemIterator at(this); *at != nullptr; ++at)
        if (kindOf(**at) == kind && idOf(**at) == id) return *at;
    return nullptr;
}

QStringList ProjectTree::mimeTypes() const {
    return {rowFormat()};
}

QMimeData* ProjectTree::mimeData(const QList<QTreeWidgetItem*>& items) const {
    if (items.isEmpty()) return nullptr;
    auto* dragged = new QMimeData; // owned by the drag
    dragged->setData(rowFormat(), QByteArray::number(static_cast<int>(kindOf(*items.front()))) + ' ' +
                                      QByteArray::number(idOf(*items.front())));
    return dragged;
}

/// The presenter moves the row. @return false, so that the view does not remove it
bool ProjectTree::dropMimeData(QTreeWidgetItem* parent, int index, const QMimeData* dragged, Qt::DropAction) {
    const QList<QByteArray> row = dragged->data(rowFormat()).split(' ');
    if (row.size() != 2 || parent == nullptr || index < 0) return false;
    const auto kind = static_cast<ProjectRowKind>(row[0].toInt());
    const qint64 id = row[1].toLongLong();
    const QTreeWidgetItem *item = itemWith(kind, id), *before = parent->child(index); // null: to the end
    if (item == nullptr || item->parent() != parent || item == before) return false;
    emit moved(kind, id, before != nullptr ? idOf(*before) : -1);
    return false;
}

/// Without that of QTreeWidget, which moves the row by itself.
void ProjectTree::dropEvent(QDropEvent* event) {
    QTreeView::dropEvent(event);
}

void ProjectTree::changeEvent(QEvent* event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange && !filling_) setRows(std::exchange(rows_, {}));
}

void ProjectTree::contextMenuEvent(QContextMenuEvent* event) {
    // When requested by keyboard, the menu is that of the selected row.
    QTreeWidgetItem* item = event->reason() == QContextMenuEvent::Keyboard
                                ? currentItem()
                                : itemAt(viewport()->mapFromGlobal(event->globalPos()));
    if (item == nullptr) return;
    const QPoint place = event->reason() == QContextMenuEvent::Keyboard
                             ? viewport()->mapToGlobal(visualItemRect(item).center())
                             : event->globalPos();
    emit menuRequested(kindOf(*item), idOf(*item), place);
}

} // namespace burin
