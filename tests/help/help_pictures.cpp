// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// burin-help-pictures FOLDER [--compare]: takes the pictures of the help pages in each language from the real window
// and writes them to FOLDER/LANGUAGE/TOPIC.png. A picture that hardly differs from the file stays as it is; one that
// differs widely is named, so that somebody looks at it. With --compare nothing is written. Status 1: a picture could
// not be taken, is too large or, with --compare, differs widely.
#include "tests/help/help_scenes.h"
#include "tests/help/picture_file.h"
#include "ui/messages/messages.h"
#include "ui/scene/surface_format.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QTextStream>

using namespace burin;
using namespace burin::testing;

namespace {

constexpr double hardly = 0.004,
                 widely = 0.04; // mean difference of colours; typed values and times change a picture little

QTextStream& out() {
    static QTextStream stream(stdout);
    return stream;
}

bool write(const QString& file, const QByteArray& bytes) {
    QFile target(file);
    return target.open(QIODevice::WriteOnly) && target.write(bytes) == bytes.size();
}

/// Returns false if the picture is too large, can't be written or, when only compared, differs widely.
bool keep(const QDir& folder, const QString& name, const QImage& picture, bool compareOnly) {
    const QString file = folder.filePath(name);
    const QImage before(file);
    const double difference = differenceOf(before, picture);
    if (before.isNull())
        out() << name << ": new\n";
    else if (difference > widely)
        out() << name << ": differs widely from the window, by " << 100.0 * difference << " %; look at it\n";
    out().flush();
    if (compareOnly) return difference <= widely;
    if (difference <= hardly) return true;
    const QByteArray bytes = smallPng(picture);
    if (bytes.isEmpty()) out() << name << ": larger than " << largestHelpPicture << " bytes\n";
    return !bytes.isEmpty() && folder.mkpath(QFileInfo(file).path()) && write(file, bytes);
}

} // namespace

int main(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat());
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
    const QApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    const bool compareOnly = arguments.contains(QStringLiteral("--compare"));
    if (arguments.size() != (compareOnly ? 3 : 2)) {
        out() << "burin-help-pictures FOLDER [--compare]\n";
        return 2;
    }
    bool sound = true;
    for (const char* language : {"en", "de", "zh_CN"}) { // an installed translation stays installed
        const bool translated = QLatin1String(language) != QLatin1String("en");
        const QLocale locale = translated ? QLocale(QLatin1String(language)) : QLocale::c();
        const bool worded = !translated || Messages::install(locale);
        const std::vector<HelpPicture> pictures = worded ? takeHelpPictures(locale) : std::vector<HelpPicture>();
        if (pictures.empty()) out() << language << ": the pictures could not be taken\n";
        sound = sound && !pictures.empty();
        for (const HelpPicture& picture : pictures)
            sound = keep(QDir(arguments[1]), QStringLiteral("%1/%2.png").arg(QLatin1String(language), picture.topic),
                         picture.image, compareOnly) &&
                    sound;
    }
    return sound ? 0 : 1;
}
