// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/take_menu.h"

#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QMenu>

#include <algorithm>

namespace burin {

namespace {

const SampleRange* rangeAt(const std::vector<SampleRange>& ranges, std::uint64_t sample) {
    const auto found =
        std::ranges::find_if(ranges, [sample](const SampleRange& range) { return range.contains(sample); });
    return found == ranges.end() ? nullptr : &*found;
}

/// The words of the menu.
struct TakeMenu {
    Q_DECLARE_TR_FUNCTIONS(TakeMenu)
};

void add(QMenu& menu, const QString& text, const QString& tip, const char* name, const std::function<void()>& use) {
    QAction* action = menu.addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setToolTip(tip);
    QObject::connect(action, &QAction::triggered, &menu, use);
}

/// Empty: none was given.
QString askName(const QString& title, const QString& before, QWidget* parent) {
    bool wanted = false;
    const QString name = QInputDialog::getText(parent, title, TakeMenu::tr("Name"), QLineEdit::Normal, before, &wanted);
    return wanted ? name.trimmed() : QString();
}

QMenu* makeMenu(const char* name, const QString& title, QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->setObjectName(QLatin1String(name));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    menu->addSection(title);
    return menu;
}

} // namespace

void showTakeMenu(Workbench& workbench, std::int64_t take, std::uint64_t sample, const QPoint& globalPosition,
                  QWidget* parent) {
    TimeController& time = workbench.time;
    const TakeTrack* track = time.recorded() ? time.recorded()->trackOf(take) : nullptr;
    if (track == nullptr) return;
    QMenu* menu = makeMenu("takeMenu", takeName(track->info.name), parent);
    const auto switching = [&time, take](const SampleRange& stretch, bool on) {
        return [&time, take, stretch, on] { time.switchStretch(take, stretch, on); };
    };
    const SampleRange whole{0, track->info.sampleCount};
    if (const SampleRange* off = rangeAt(track->switchedOff, sample)) {
        add(*menu, TakeMenu::tr("Switch &on"), TakeMenu::tr("It counts again, milled on top of the current workpiece."),
            "switchOnAction", switching(*off, true));
    } else if (const SampleRange* stroke = rangeAt(track->strokes, sample);
               stroke != nullptr && rangeAt(track->undone, sample) == nullptr) {
        add(*menu, TakeMenu::tr("Switch the &stroke off"),
            TakeMenu::tr("The workpiece and the paths are made without it, until it is switched on again."),
            "strokeOffAction", switching(*stroke, false));
    }
    if (track->switchedOff.empty() || track->switchedOff.front() != whole)
        add(*menu, TakeMenu::tr("Switch the &take off"),
            TakeMenu::tr("The workpiece and the paths are made without it, until it is switched on again."),
            "takeOffAction", switching(whole, false));
    if (!track->switchedOff.empty())
        add(*menu, TakeMenu::tr("Switch &all of the take on"),
            TakeMenu::tr("It counts again, milled on top of the current workpiece."), "takeOnAction",
            switching(whole, true));
    menu->addSeparator();
    add(*menu, TakeMenu::tr("&Rename…"), TakeMenu::tr("Rename the take."), "renameTakeAction",
        [&workbench, info = track->info, parent] {
            workbench.mill.nameTake(info.id, askName(TakeMenu::tr("Rename the take"), takeName(info.name), parent));
        });
    add(*menu, TakeMenu::tr("&Delete"), TakeMenu::tr("The workpiece is milled again without it."), "deleteTakeAction",
        [&workbench, take] { workbench.mill.removeTake(take); });
    menu->popup(globalPosition);
}

void showMarkerMenu(Workbench& workbench, std::size_t marker, const QPoint& globalPosition, QWidget* parent) {
    TimeController& time = workbench.time;
    if (marker >= time.markers().size()) return;
    const QString name = QString::fromStdString(time.markers()[marker].name);
    QMenu* menu = makeMenu("markerMenu", name, parent);
    add(*menu, TakeMenu::tr("&Rename…"), TakeMenu::tr("Rename the marker."), "renameMarkerAction",
        [&time, marker, name, parent] {
            const QString other = askName(TakeMenu::tr("Rename the marker"), name, parent);
            if (!other.isEmpty()) time.changeMarker(marker, other);
        });
    add(*menu, TakeMenu::tr("&Delete"), TakeMenu::tr("Delete the marker."), "deleteMarkerAction",
        [&time, marker] { time.changeMarker(marker, {}); });
    menu->popup(globalPosition);
}

void addMarker(Workbench& workbench, QWidget* parent) {
    const int number = static_cast<int>(workbench.time.markers().size()) + 1;
    workbench.time.addMarker(askName(TakeMenu::tr("Add a marker"), TakeMenu::tr("Marker %1").arg(number), parent));
}

} // namespace burin
