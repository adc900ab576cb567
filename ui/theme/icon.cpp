// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/icon.h"

#include "core/base/file.h"

#include <QDir>
#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QMap>
#include <QPainter>
#include <QSvgRenderer>

#include <tuple>

namespace burin {

namespace {

constexpr double disabledOpacity = 0.4;

QDir iconFolder() {
    return QDir(QString::fromStdString((resourceDirectory() / "icons").string()));
}

/// Renders a drawing with black lines in the current colour of a role.
class ThemedIconEngine : public QIconEngine {
public:
    ThemedIconEngine(QString name, QByteArray drawing, ColourRole role)
        : name_(std::move(name)), drawing_(std::move(drawing)), role_(role) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QByteArray coloured = drawing_;
        coloured.replace("#000000", (activePalette().*role_).name().toLatin1());
        QSvgRenderer renderer(coloured);
        painter->save();
        if (mode == QIcon::Disabled) painter->setOpacity(painter->opacity() * disabledOpacity);
        renderer.setAspectRatioMode(Qt::KeepAspectRatio);
        renderer.render(painter, rect);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        if (size.isEmpty()) return {}; // a button that has no size yet
        const QRgb colour = (activePalette().*role_).rgb();
        const auto key = std::make_tuple(size.width(), size.height(), colour, mode == QIcon::Disabled);
        if (drawn_.contains(key)) return drawn_[key];
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        painter.end();
        drawn_.insert(key, picture);
        return picture;
    }

    QIconEngine* clone() const override { return new ThemedIconEngine(*this); }
    QString key() const override { return QStringLiteral("burin"); }
    QString iconName() override { return name_; }

private:
    using Key = std::tuple<int, int, QRgb, bool>;
    QString name_;
    QByteArray drawing_;
    ColourRole role_;
    QMap<Key, QPixmap> drawn_;
};

/// The content of an icon's file, read only once; empty if there is no such file.
QByteArray drawingOf(const QString& name) {
    static QHash<QString, QByteArray> known;
    if (const auto found = known.constFind(name); found != known.constEnd()) return *found;
    QFile file(iconFolder().filePath(name + QStringLiteral(".svg")));
    return *known.insert(name, file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray());
}

} // namespace

QIcon themedIcon(const QString& name, ColourRole role) {
    const QByteArray drawing = drawingOf(name);
    return drawing.isEmpty() ? QIcon() : QIcon(new ThemedIconEngine(name, drawing, role));
}

QStringList iconNames() {
    QStringList names;
    for (const QString& file : iconFolder().entryList({QStringLiteral("*.svg")}, QDir::Files, QDir::Name))
        names.append(file.chopped(4));
    return names;
}

} // namespace burin
