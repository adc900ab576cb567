// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/take_menu.h"

#include "ui/panels/texts.h"
#include "ui/window/context_menu.h"

#include <QCoreApplication>
#include <QMenu>

#include <algorithm>

namespace burin {

namespace {

const SampleRange* rangeAt(const std::vector<SampleRange>& ranges, std::uint64_t sample) {
    const auto found =
        std::ranges::find_if(ranges, [sample](const SampleRange& range) { return range.contains(sample); });
    return found == ranges.end() ? nullptr : &*found;
}

/// Translation context of the menu.
struct TakeMenu {
    Q_DECLARE_TR_FUNCTIONS(TakeMenu)
};

/// Adds the actions that switch intervals of a take.
void addSwitches(QMenu& menu, TimeController& time, const TakeTrack& track, std::uint64_t sample) {
    const std::int64_t take = track.info.id;
    const auto switching = [&time, take](const SampleRange& interval, bool on) {
        return [&time, take, interval, on] { time.switchInterval(take, interval, on); };
    };
    const SampleRange whole{0, track.info.sampleCount};
    if (const SampleRange* off = rangeAt(track.switchedOff, sample)) {
        addEntry(menu, TakeMenu::tr("Switch &on"),
                 TakeMenu::tr("It counts again, milled on top of the current workpiece."), "switchOnAction",
                 switching(*off, true));
    } else if (const SampleRange* stroke = rangeAt(track.strokes, sample);
               stroke != nullptr && rangeAt(track.undone, sample) == nullptr) {
        addEntry(menu, TakeMenu::tr("Switch the &stroke off"),
                 TakeMenu::tr("The workpiece and the paths are made without it, until it is switched on again."),
                 "strokeOffAction", switching(*stroke, false));
    }
    if (track.switchedOff.empty() || track.switchedOff.front() != whole)
        addEntry(menu, TakeMenu::tr("Switch the &take off"),
                 TakeMenu::tr("The workpiece and the paths are made without it, until it is switched on again."),
                 "takeOffAction", switching(whole, false));
    if (!track.switchedOff.empty())
        addEntry(menu, TakeMenu::tr("Switch &all of the take on"),
                 TakeMenu::tr("It counts again, milled on top of the current workpiece."), "takeOnAction",
                 switching(whole, true));
    menu.addSeparator();
}

/// Adds the entries that move or copy a whole take and leave the workpiece unchanged.
void addMoves(QMenu& menu, Workbench& workbench, const TakeInfo& info) {
    MillController& mill = workbench.mill;
    const std::int64_t take = info.id;
    const auto enable = [&menu](bool possible) { menu.actions().back()->setEnabled(possible); };
    addEntry(menu, TakeMenu::tr("Move &up"), TakeMenu::tr("Replay it before the take above it."), "moveTakeUpAction",
             [&mill, take] { mill.moveTake(take, -1); });
    enable(mill.canMove(take, -1));
    addEntry(menu, TakeMenu::tr("Move do&wn"), TakeMenu::tr("Replay it after the take below it."), "moveTakeDownAction",
             [&mill, take] { mill.moveTake(take, 1); });
    enable(mill.canMove(take, 1));
    addEntry(menu, TakeMenu::tr("Dupli&cate"),
             TakeMenu::tr("Copy it with its strokes and what is switched off. No path mills the copy until its menu "
                          "adds it."),
             "copyTakeAction", [&mill, take] { mill.duplicateTake(take); });
    enable(mill.canCopy(take));
    if (info.copyOf != 0 && workbench.path.pathFor(take) != nullptr) {
        const bool milled = workbench.path.isMilled(take);
        addEntry(menu, milled ? TakeMenu::tr("Take out of the &path") : TakeMenu::tr("Mill in the &path"),
                 milled ? TakeMenu::tr("The path of its tool mills this copy no longer.")
                        : TakeMenu::tr("The path of its tool mills this copy as well, after its other takes."),
                 "takeInPathAction", [&workbench, take, milled] { workbench.path.millTake(take, !milled); });
    }
    menu.addSeparator();
}

} // namespace

void connectTakeActions(Workbench& workbench, const Actions& actions) {
    MillController& mill = workbench.mill;
    const auto on = [&](ActionId id, auto what) {
        QObject::connect(actions[id], &QAction::triggered, &mill, [&mill, what] { what(mill); });
    };
    on(ActionId::takeUp, [](MillController& chosen) { chosen.moveTake(chosen.chosenTake(), -1); });
    on(ActionId::takeDown, [](MillController& chosen) { chosen.moveTake(chosen.chosenTake(), 1); });
    on(ActionId::duplicateTake, [](MillController& chosen) { chosen.duplicateTake(chosen.chosenTake()); });
}

void showTakeMenu(Workbench& workbench, std::int64_t take, std::uint64_t sample, const QPoint& globalPosition,
                  QWidget* parent) {
    const std::vector<TakeInfo>& takes = workbench.mill.allTakes();
    const auto info = std::ranges::find(takes, take, &TakeInfo::id);
    if (info == takes.end()) return;
    workbench.mill.chooseTake(take);
    QMenu* menu = makeContextMenu("takeMenu", takeName(info->name), parent);
    // With a hidden timeline the take has not been read; in the program step the timeline has other tracks.
    const bool read = workbench.time.recorded() && !workbench.time.showsProgram();
    const TakeTrack* track = read ? workbench.time.recorded()->trackOf(take) : nullptr;
    if (track != nullptr) addSwitches(*menu, workbench.time, *track, sample);
    addMoves(*menu, workbench, *info);
    addEntry(*menu, TakeMenu::tr("&Rename…"), TakeMenu::tr("Rename the take."), "renameTakeAction",
             [&workbench, info = *info, parent] {
                 workbench.mill.nameTake(info.id,
                                         askName(TakeMenu::tr("Rename the take"), takeName(info.name), parent));
             });
    if (workbench.score.possible())
        addEntry(*menu, TakeMenu::tr("Scor&e…"),
                 TakeMenu::tr("State how well the take was milled, and compare it with a reference."), "scoreTakeEntry",
                 [&workbench, take] { workbench.score.ask(take); });
    addEntry(*menu, TakeMenu::tr("&Delete"), TakeMenu::tr("The workpiece is milled again without it."),
             "deleteTakeAction", [&workbench, take] { workbench.mill.removeTake(take); });
    menu->popup(globalPosition);
}

void showMarkerMenu(Workbench& workbench, std::size_t marker, const QPoint& globalPosition, QWidget* parent) {
    TimeController& time = workbench.time;
    if (marker >= time.markers().size()) return;
    const QString name = QString::fromStdString(time.markers()[marker].name);
    QMenu* menu = makeContextMenu("markerMenu", name, parent);
    addEntry(*menu, TakeMenu::tr("&Rename…"), TakeMenu::tr("Rename the marker."), "renameMarkerAction",
             [&time, marker, name, parent] {
                 const QString other = askName(TakeMenu::tr("Rename the marker"), name, parent);
                 if (!other.isEmpty()) time.changeMarker(marker, other);
             });
    addEntry(*menu, TakeMenu::tr("&Delete"), TakeMenu::tr("Delete the marker."), "deleteMarkerAction",
             [&time, marker] { time.changeMarker(marker, {}); });
    menu->popup(globalPosition);
}

void addMarker(Workbench& workbench, QWidget* parent) {
    const int number = static_cast<int>(workbench.time.markers().size()) + 1;
    workbench.time.addMarker(askName(TakeMenu::tr("Add a marker"), TakeMenu::tr("Marker %1").arg(number), parent));
}

} // namespace burin
