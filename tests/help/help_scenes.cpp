// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/help/help_scenes.h"

#include "tests/ui/window_steps.h"
#include "ui/panels/timeline_view.h"
#include "ui/theme/theme.h"

#include <QPainter>
#include <QTreeWidget>
#include <QtTest>

#include <algorithm>

namespace burin::testing {

namespace {

constexpr QSize windowSize(1280, 960); // pixels
constexpr int mostHeight = 720, margin = 12;

/// The places, in a panel, of the widgets that show something: those that contain no others.
std::vector<QRect> contentsOf(const QWidget& panel) {
    const auto isVisible = [](const QWidget* widget) { return widget->isVisible(); };
    std::vector<QRect> places;
    for (const QWidget* widget : panel.findChildren<QWidget*>())
        if (isVisible(widget) &&
            std::ranges::none_of(widget->findChildren<QWidget*>(Qt::FindDirectChildrenOnly), isVisible))
            places.emplace_back(widget->mapTo(&panel, QPoint(0, 0)), widget->size());
    return places;
}

/// The lowest pixel row up to which a panel can be shown without cutting one of its widgets in two.
int endOf(const std::vector<QRect>& contents, int most) {
    int end = 0;
    for (const QRect& place : contents)
        if (place.bottom() < most) end = std::max(end, place.bottom() + 1);
    for (const QRect& place : contents)
        if (place.top() < end && place.bottom() >= end) return endOf(contents, place.top());
    return end;
}

/// The height of the part of a panel that is shown: all of it, or as much as fits, with a margin where nothing else
/// begins.
int shownHeight(const QWidget& panel) {
    if (panel.height() <= mostHeight) return panel.height();
    const std::vector<QRect> contents = contentsOf(panel);
    const int end = endOf(contents, mostHeight);
    int next = end + 2 * margin;
    for (const QRect& place : contents)
        if (place.top() >= end) next = std::min(next, place.top());
    return (end + next) / 2;
}

/// The height of a tree's rows.
int rowsHeight(QTreeWidget& tree) {
    int end = 0;
    for (QTreeWidgetItemIterator at(&tree); *at != nullptr; ++at)
        end = std::max(end, tree.visualItemRect(*at).bottom());
    return std::min(tree.height(), end + margin);
}

/// The upper part of a panel, on the colour that is behind it in the window. @param frame  width of that colour around
/// it
QImage pictureOf(QWidget& panel, int height, int frame) {
    const QPixmap shown = panel.grab(QRect(0, 0, panel.width(), height));
    QImage picture(shown.size() + QSize(2 * frame, 2 * frame), QImage::Format_RGB32);
    picture.fill(activePalette().panel);
    QPainter(&picture).drawPixmap(frame, frame, shown);
    return picture;
}

/// Takes the pictures, one after the other, in a window that does the job.
class Scenes {
public:
    explicit Scenes(const QLocale& locale) : driver_(windowSize, locale) {}
    bool run() {
        return welcome() && part() && stock() && tool() && mill() && time() && path() && program() && window();
    }
    std::vector<HelpPicture> pictures;

private:
    /// @param frame  pixels, for a panel without margins of its own
    bool take(const char* topic, QWidget* panel, int frame = 0) {
        if (panel == nullptr) return false;
        QTest::qWait(300); // presenters and painting run after the event
        QTest::mouseMove(&driver_.window(), {2, 2});
        auto* tree = qobject_cast<QTreeWidget*>(panel);
        const int height = tree != nullptr ? rowsHeight(*tree) : shownHeight(*panel);
        pictures.push_back({QLatin1String(topic), pictureOf(*panel, height, frame)});
        return true;
    }
    bool welcome() {
        const auto* offer = driver_.visible("openPartButton");
        return offer != nullptr && take("start", offer->parentWidget()->parentWidget(), margin);
    }
    bool part() {
        const Workbench& workbench = driver_.window().workbench();
        return driver_.clickOn("samplePartButton") &&
               driver_.waitFor([&] { return workbench.model.model() != nullptr; }) && driver_.settle() &&
               driver_.step(JobStep::part) && take("part", driver_.visible("partPanel"));
    }
    bool stock() {
        const Workbench& workbench = driver_.window().workbench();
        return driver_.step(JobStep::stock) && driver_.settle() && driver_.enter("voxelField", QStringLiteral("1")) &&
               driver_.settle() && take("stock", driver_.visible("stockPanel")) && driver_.clickOn("embedButton") &&
               driver_.waitFor([&] { return workbench.workpiece.ready(); }) && driver_.settle();
    }
    bool tool() { return driver_.step(JobStep::tool) && take("tool", driver_.visible("toolPanel")); }
    bool mill() {
        return recordLine(driver_, {-20, -5}, {20, -5}) && driver_.settle() && driver_.step(JobStep::mill) &&
               take("mill", driver_.visible("millPanel"));
    }
    bool time() {
        if (driver_.visible("timelineView") == nullptr) driver_.key(Qt::Key_F9);
        const auto shown = [this] { return driver_.visible<TimelineView>("timelineView") != nullptr; };
        if (!driver_.waitFor(shown, 3000)) return false;
        auto* view = driver_.visible<TimelineView>("timelineView");
        if (!driver_.waitFor([&] { return view->all() > 0.0; })) return false;
        QTest::mouseClick(view, Qt::LeftButton, {}, {qRound(view->placeOf(0.75 * view->all())), view->height() / 2});
        if (!driver_.settle() || !take("time", view)) return false;
        driver_.key(Qt::Key_F9, Qt::ShiftModifier); // back to the current state
        return driver_.settle();
    }
    bool path() { return newPath(driver_) && take("path", driver_.visible("pathPanel")); }
    bool program() {
        return postProgram(driver_) && driver_.settle() && take("program", driver_.visible("programPanel"));
    }
    bool window() {
        if (driver_.visible("projectTree") == nullptr) driver_.key(Qt::Key_F10, Qt::ControlModifier);
        return driver_.waitFor([this] { return driver_.visible("projectTree") != nullptr; }, 3000) &&
               take("window", driver_.visible("projectTree"));
    }

    WindowDriver driver_;
};

} // namespace

std::vector<HelpPicture> takeHelpPictures(const QLocale& locale) {
    Scenes scenes(locale);
    if (!scenes.run()) return {};
    return std::move(scenes.pictures);
}

} // namespace burin::testing
