// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QFileInfo>
#include <QHash>
#include <QProcess>
#include <QtTest>

#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#include <vector>

namespace burin::tst_definitions {

namespace {

/// What `nm --format=posix` prints of a library.
struct Listing {
    QString library;
    QByteArray symbols;
};

QString readable(const QByteArray& symbol) {
    const std::unique_ptr<char, decltype(&std::free)> name(
        abi::__cxa_demangle(symbol.constData(), nullptr, nullptr, nullptr), &std::free);
    return QString::fromUtf8(name ? name.get() : symbol.constData());
}

/// Functions that more than one library defines, with those libraries. Of such a pair the linker takes one for both,
/// without a word. Inline functions and templates don't count, they are the same everywhere.
QStringList definedTwice(const std::vector<Listing>& listings) {
    QHash<QByteArray, QString> first;
    QStringList twice;
    for (const Listing& listing : listings)
        for (const QByteArray& line : listing.symbols.split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            if (words.size() < 2 || words[1] != "T" || !words[0].startsWith("_ZN")) continue;
            const auto known = first.constFind(words[0]);
            if (known == first.constEnd())
                first.insert(words[0], listing.library);
            else
                twice << QStringLiteral("%1: %2, %3").arg(readable(words[0]), *known, listing.library);
        }
    return twice;
}

} // namespace

class DefinitionsTest : public QObject {
    Q_OBJECT
private slots:
    void noFunctionIsDefinedTwice() {
        std::vector<Listing> listings;
        QDirIterator libraries(QStringLiteral(BURIN_BUILD_DIRECTORY), {QStringLiteral("libburin_*.a")}, QDir::Files,
                               QDirIterator::Subdirectories);
        while (libraries.hasNext()) {
            const QFileInfo library(libraries.next());
            QProcess nm;
            nm.start(QStringLiteral("nm"),
                     {QStringLiteral("--defined-only"), QStringLiteral("--format=posix"), library.filePath()});
            QVERIFY2(nm.waitForFinished(60000) && nm.exitCode() == 0, qPrintable(library.filePath()));
            listings.push_back({library.fileName(), nm.readAllStandardOutput()});
        }
        QVERIFY(listings.size() > 20);
        const QStringList twice = definedTwice(listings);
        QVERIFY2(twice.isEmpty(), qPrintable(QLatin1Char('\n') + twice.join(QLatin1Char('\n'))));
    }

    void aPairIsSeen() {
        const QByteArray symbol = "_ZN5burin6turnedEd";
        const QStringList twice = definedTwice({{"liba.a", symbol + " T 0 10\n"}, {"libb.a", symbol + " T 0 20\n"}});
        QCOMPARE(twice, QStringList{QStringLiteral("burin::turned(double): liba.a, libb.a")});
        QVERIFY(definedTwice({{"liba.a", symbol + " T 0 10\n"}, {"libb.a", symbol + " W 0 20\n"}}).isEmpty());
    }
};

BURIN_TEST(DefinitionsTest, QCoreApplication)

} // namespace burin::tst_definitions

#include "tst_definitions.moc"
