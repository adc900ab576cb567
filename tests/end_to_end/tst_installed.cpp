// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/long_run.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMultiHash>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace burin::tst_installed {

namespace {

struct Outcome {
    int status = -1;
    QByteArray out, messages;
};

/// Runs a program in an environment with only the given variables.
Outcome run(const QString& program, const QStringList& arguments, const QStringList& environment = {},
            const QString& folder = {}) {
    QProcess process;
    if (!environment.isEmpty()) {
        QProcessEnvironment bare;
        for (const QString& entry : environment) {
            const qsizetype at = entry.indexOf(QLatin1Char('='));
            bare.insert(entry.left(at), entry.mid(at + 1));
        }
        process.setProcessEnvironment(bare);
    }
    if (!folder.isEmpty()) process.setWorkingDirectory(folder);
    process.start(program, arguments);
    if (!process.waitForFinished(240000)) return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(),
            process.readAllStandardError()};
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

/// Burin as installed from the build tree, moved elsewhere, in an environment without Burin's variables.
class TestInstalled : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(place_.isValid());
        const Outcome installed =
            run(QStringLiteral("cmake"), {QStringLiteral("--install"), BURIN_BUILD_DIRECTORY,
                                          QStringLiteral("--prefix"), path(QStringLiteral("first"))});
        QVERIFY2(installed.status == 0, installed.messages.constData());
        // Files that are looked up by the installation prefix would not be found after this.
        QVERIFY(QDir().rename(path(QStringLiteral("first")), path(QStringLiteral("root"))));
        bare_ = {QStringLiteral("PATH=/usr/bin:/bin"), QStringLiteral("HOME=") + path(QStringLiteral("home"))};
        QVERIFY(QDir().mkpath(path(QStringLiteral("home"))));
    }

    void allFilesAreThere_data() {
        QTest::addColumn<QString>("file");
        for (const char* file :
             {"bin/burin", "lib/burin/burin-import", "lib/burin/plugins/devices/open_stylus/plugin.json",
              "lib/burin/plugins/devices/spacemouse/plugin.json", "lib/burin/plugins/devices/openhaptics/plugin.json",
              "lib/burin/plugins/devices/force_dimension/libforce_dimension.so",
              "share/burin/resources/samples/mouse.step", "share/burin/translations/burin_de.qm",
              "share/applications/org.burin.Burin.desktop", "share/icons/hicolor/scalable/apps/org.burin.Burin.svg",
              "share/mime/packages/org.burin.Burin.xml", "share/metainfo/org.burin.Burin.metainfo.xml",
              "share/man/man1/burin.1.gz", "share/bash-completion/completions/burin",
              "lib/udev/rules.d/70-burin-devices.rules", "share/doc/burin/copyright", "share/doc/burin/changelog.gz"})
            QTest::newRow(file) << QString::fromLatin1(file);
    }
    void allFilesAreThere() {
        QFETCH(QString, file);
        QVERIFY(QFileInfo(path(QStringLiteral("root/")) + file).size() > 0);
    }

    void noFileNamesTheBuildOrTheSources() {
        QDirIterator files(path(QStringLiteral("root")), QDir::Files, QDirIterator::Subdirectories);
        int count = 0;
        while (files.hasNext()) {
            const QByteArray content = bytesOf(files.next());
            ++count;
            QVERIFY2(!content.contains(BURIN_SOURCE_DIRECTORY), qPrintable(files.filePath()));
            QVERIFY2(!content.contains(BURIN_BUILD_DIRECTORY), qPrintable(files.filePath()));
        }
        QVERIFY(count > 50);
    }

    void desktopFilesAreValid() {
        const Outcome entry = run(QStringLiteral("desktop-file-validate"),
                                  {path(QStringLiteral("root/share/applications/org.burin.Burin.desktop"))});
        QVERIFY2(entry.status == 0 && entry.out.isEmpty(), entry.out.constData());
        const Outcome metadata = run(QStringLiteral("appstreamcli"),
                                     {QStringLiteral("validate"), QStringLiteral("--no-net"),
                                      path(QStringLiteral("root/share/metainfo/org.burin.Burin.metainfo.xml"))});
        QVERIFY2(metadata.status == 0, metadata.out.constData());
        const Outcome types = run(QStringLiteral("update-mime-database"),
                                  {QStringLiteral("-V"), path(QStringLiteral("root/share/mime"))});
        QVERIFY2(types.status == 0 && !types.messages.contains("rror"), types.messages.constData());
        const QByteArray globs = bytesOf(path(QStringLiteral("root/share/mime/globs2")));
        for (const char* glob : {"application/x-burin-project:*.burin", "model/step:*.stp", "text/x.gcode:*.ngc"})
            QVERIFY2(globs.contains(glob), glob);
    }

    /// The man page lists every command and its options, as the program itself does.
    void manPageAndCompletionKnowEveryCommand() {
        const QByteArray page =
            run(QStringLiteral("gzip"), {QStringLiteral("-dc"), path(QStringLiteral("root/share/man/man1/burin.1.gz"))})
                .out;
        const Outcome help = run(burin(), {QStringLiteral("--help")}, bare_);
        QCOMPARE(help.status, 0);
        const QStringList lines = QString::fromUtf8(help.out).split(QLatin1Char('\n'));
        QStringList commands;
        for (qsizetype i = lines.indexOf(QStringLiteral("Subcommands:")) + 1; i > 0 && i < lines.size(); ++i)
            if (lines[i].startsWith(QStringLiteral("  ")) && lines[i][2].isLetter())
                commands.append(lines[i].trimmed().section(QLatin1Char(' '), 0, 0));
        QVERIFY(commands.size() >= 12);
        for (const QString& command : commands) QVERIFY2(page.contains(command.toUtf8()), qPrintable(command));
        QVERIFY(page.contains("voxel"));
        const Outcome completed =
            run(QStringLiteral("bash"),
                {QStringLiteral("-c"),
                 QStringLiteral("source '%1'; COMP_WORDS=('%2' ''); COMP_CWORD=1; _burin; "
                                "printf '%s\\n' \"${COMPREPLY[@]}\"; COMP_WORDS=('%2' embed --vo); "
                                "COMP_CWORD=2; _burin; printf '%s\\n' \"${COMPREPLY[@]}\"")
                     .arg(path(QStringLiteral("root/share/bash-completion/completions/burin")), burin())},
                bare_, path(QStringLiteral("home")));
        const QList<QByteArray> offered = completed.out.split('\n');
        for (const QString& command : commands) QVERIFY2(offered.contains(command.toUtf8()), qPrintable(command));
        QVERIFY2(offered.contains("--voxel"), completed.out.constData());
    }

    void pluginsAreFound() {
        const Outcome devices = run(burin(), {QStringLiteral("devices"), QStringLiteral("--json")}, bare_);
        QVERIFY2(devices.status == 0, devices.messages.constData());
        QVERIFY2(devices.messages.isEmpty(), devices.messages.constData());
        const QJsonArray drivers = QJsonDocument::fromJson(devices.out)["drivers"].toArray();
        QStringList ids;
        for (const QJsonValue& driver : drivers) ids << driver["id"].toString();
        QCOMPARE(ids.join(' '),
                 QString("simulated force_dimension haply input open_stylus openhaptics spacemouse spacenav"));
        for (const QJsonValue& driver : drivers) // no vendor's library is in the bare system
            QCOMPARE(driver["ready"].toBool(), !driver["id"].toString().contains(QRegularExpression("^(force|openh)")));
    }

    void itSpeaksTheUsersLanguage() {
        QStringList german = bare_;
        german << QStringLiteral("LANGUAGE=de") << QStringLiteral("LANG=C.UTF-8")
               << QStringLiteral("LC_ALL=de_DE.UTF-8");
        const Outcome missing = run(burin(), {QStringLiteral("info"), QStringLiteral("not-there.burin")}, german,
                                    path(QStringLiteral("home")));
        QCOMPARE(missing.status, 3);
        QVERIFY2(missing.messages.contains("nicht"), missing.messages.constData());
    }

    void theDemoRuns() {
        const Outcome demo = run(burin(),
                                 {QStringLiteral("demo"), QStringLiteral("--json"), QStringLiteral("--voxel"),
                                  QStringLiteral("1"), QStringLiteral("--seconds"), QStringLiteral("20"),
                                  QStringLiteral("--output"), path(QStringLiteral("home/out"))},
                                 bare_, path(QStringLiteral("home")));
        QVERIFY2(demo.status == 0, (demo.messages + demo.out).constData());
        QDirIterator written(path(QStringLiteral("home/out")), QDir::Files);
        QStringList kinds;
        while (written.hasNext()) kinds.append(QFileInfo(written.next()).suffix());
        for (const char* kind : {"burin", "ngc", "png"}) QVERIFY2(kinds.contains(QLatin1String(kind)), kind);
    }

    /// Each library that one of its programs needs comes with a package that it depends on, according to readelf and
    /// dpkg.
    BURIN_ONLY_IN_LONG_RUNS void thePackageDependsOnAllThatItLoads() {
        const Outcome packed =
            run(QStringLiteral("cpack"), {QStringLiteral("-G"), QStringLiteral("DEB"), QStringLiteral("--config"),
                                          QStringLiteral(BURIN_BUILD_DIRECTORY "/CPackConfig.cmake"),
                                          QStringLiteral("-B"), path(QStringLiteral("packed"))});
        QVERIFY2(packed.status == 0, (packed.out + packed.messages).constData());
        const QStringList packages = QDir(path(QStringLiteral("packed"))).entryList({QStringLiteral("burin_*.deb")});
        QCOMPARE(packages.size(), 1);
        const QString package = path(QStringLiteral("packed/")) + packages.first();
        const QString unpacked = path(QStringLiteral("unpacked"));
        QCOMPARE(run(QStringLiteral("dpkg-deb"), {QStringLiteral("-x"), package, unpacked}).status, 0);

        const QSet<QString> libraries =
            librariesOf(unpacked + QStringLiteral("/usr/bin")) + librariesOf(unpacked + QStringLiteral("/usr/lib"));
        QVERIFY(libraries.size() > 20);
        const QStringList depended = dependenciesOf(package);
        const QMultiHash<QString, QString> owned = packagesWith(libraries);
        for (const QString& library : libraries) {
            const QStringList owners = owned.values(library);
            QVERIFY2(std::ranges::any_of(owners, [&](const QString& owner) { return depended.contains(owner); }),
                     qPrintable(library + QStringLiteral(": ") + owners.join(QLatin1Char(' '))));
        }
        const Outcome version = run(unpacked + QStringLiteral("/usr/bin/burin"), {QStringLiteral("--version")}, bare_);
        QCOMPARE(version.status, 0);
        QVERIFY2(packages.first().contains(QString::fromUtf8(version.out.trimmed().split(' ').last())),
                 version.out.constData());
    }

private:
    /// Sonames that the programs and modules below a folder need.
    static QSet<QString> librariesOf(const QString& folder) {
        QSet<QString> libraries;
        QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            const QString content =
                QString::fromUtf8(run(QStringLiteral("readelf"), {QStringLiteral("-d"), files.next()}).out);
            static const QRegularExpression needed(QStringLiteral("\\(NEEDED\\).*\\[(.+)\\]"));
            for (auto matches = needed.globalMatch(content); matches.hasNext();)
                libraries.insert(matches.next().captured(1));
        }
        return libraries;
    }

    /// Package names, without versions and alternatives.
    static QStringList dependenciesOf(const QString& package) {
        const QByteArray field =
            run(QStringLiteral("dpkg-deb"), {QStringLiteral("-f"), package, QStringLiteral("Depends")}).out;
        QStringList names;
        for (const QString& entry : QString::fromUtf8(field).split(QLatin1Char(',')))
            names.append(entry.trimmed().section(QLatin1Char(' '), 0, 0));
        return names;
    }

    /// The packages installed here that contain the libraries, by library.
    static QMultiHash<QString, QString> packagesWith(const QSet<QString>& libraries) {
        QStringList query{QStringLiteral("-S")};
        for (const QString& library : libraries) query.append(QStringLiteral("*/") + library);
        QMultiHash<QString, QString> names;
        for (const QString& line : QString::fromUtf8(run(QStringLiteral("dpkg-query"), query).out)
                                       .split(QLatin1Char('\n'), Qt::SkipEmptyParts))
            names.insert(line.section(QLatin1Char('/'), -1), line.section(QLatin1Char(':'), 0, 0));
        return names;
    }

    QString path(const QString& inside) const { return place_.filePath(inside); }
    QString burin() const { return path(QStringLiteral("root/bin/burin")); }

    QTemporaryDir place_;
    QStringList bare_;
};

BURIN_TEST(TestInstalled, QCoreApplication)

} // namespace burin::tst_installed

#include "tst_installed.moc"
