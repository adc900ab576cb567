// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/help/help_browser.h"

#include <QDir>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTextDocument>

#include <algorithm>
#include <cmath>

namespace burin {

HelpBrowser::HelpBrowser(QWidget* parent) : QTextBrowser(parent) {
    setOpenLinks(false); // a page has no links
}

void HelpBrowser::showPage(const QString& markdown, const QString& folder) {
    folder_ = folder;
    setMarkdown(markdown);
}

/// A picture as wide as it is, or as the page where that is narrower. Null: there is no such file.
QImage HelpBrowser::fitted(const QUrl& name) const {
    QImage picture(QDir(folder_).filePath(name.path()));
    // With room for the scroll bar, so that its coming and going changes nothing.
    const double room =
        width() - 2.0 * frameWidth() - verticalScrollBar()->sizeHint().width() - 2.0 * document()->documentMargin();
    if (picture.isNull() || room < 1.0 || picture.width() <= room) return picture;
    const double pixels = devicePixelRatioF(); // of the screen per pixel of the window
    picture = picture.scaledToWidth(static_cast<int>(std::lround(std::min(room * pixels, 1.0 * picture.width()))),
                                    Qt::SmoothTransformation);
    picture.setDevicePixelRatio(picture.width() / room);
    return picture;
}

QVariant HelpBrowser::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    if (!pictures_.contains(name)) pictures_.append(name);
    return fitted(name);
}

void HelpBrowser::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    if (event->size().width() == event->oldSize().width()) return;
    for (const QUrl& name : pictures_) document()->addResource(QTextDocument::ImageResource, name, fitted(name));
    document()->markContentsDirty(0, document()->characterCount());
}

} // namespace burin
