// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The device plugins against a real kernel: hidapi, hidraw and the HID core of Debian's kernel, in a virtual machine in
// which a program (guest.cpp) plugs devices in and out. It needs no rights, no KVM and no hardware.
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QProcess>
#include <QRegularExpression>
#include <QtTest>

namespace burin::tst_devices {

namespace {

const QString kernelFolder = QStringLiteral(BURIN_BUILD_DIRECTORY "/hid-guest/kernel");
const QString workFolder = QStringLiteral(BURIN_BUILD_DIRECTORY "/hid-guest");

} // namespace

class TestDevices : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QVERIFY2(run(QStringLiteral(BURIN_SOURCE_DIRECTORY "/tests/hid/fetch-kernel"), {kernelFolder}),
                 "Debian's kernel can't be fetched (network, package lists)");
        QVERIFY2(run(QStringLiteral(BURIN_SOURCE_DIRECTORY "/tests/hid/boot"),
                     {kernelFolder, workFolder, QStringLiteral(BURIN_HID_GUEST),
                      QStringLiteral(BURIN_BUILD_DIRECTORY "/plugins/devices")}),
                 "the virtual machine did not run");
        for (const QString& line : QString::fromUtf8(output_).split(QLatin1Char('\n'))) {
            static const QRegularExpression result(QStringLiteral("^hid (ok|failed) ([^:\r]*)(?:: (.*))?\r?$"));
            const auto match = result.match(line);
            if (match.hasMatch())
                results_.insert(match.captured(2), match.captured(1) + QLatin1Char(' ') + match.captured(3));
            if (line.startsWith(QLatin1String("hid figure ")) || line.startsWith(QLatin1String("hid seconds ")))
                qInfo("%s", qPrintable(line.mid(4).trimmed()));
        }
    }

    void inTheVirtualMachine_data() {
        QTest::addColumn<QString>("fact");
        for (const char* fact : {"3D mice are found and other devices are not",
                                 "a SpaceMouse Compact moves and presses",
                                 "a SpaceMouse Wireless moves and tells its battery",
                                 "a SpaceMouse Enterprise has many buttons",
                                 "the LED of a 3D mouse shines while it is open",
                                 "an unplugged 3D mouse says so and goes on when it is back",
                                 "gamepads and tablets are found",
                                 "the sticks of a gamepad move the tool",
                                 "a pen is where it is, as deep as it is pressed",
                                 "an unplugged tablet says so and goes on when it is back",
                                 "who may not read a tablet is told",
                                 "a stick pushes as it is asked to",
                                 "a pad vibrates as it is asked to",
                                 "a host that hangs or dies pushes nobody",
                                 "an unplugged stick pushes again when it is back",
                                 "who may only read a pad is told",
                                 "an open stylus tells its limits",
                                 "the hand at an open stylus feels the wall",
                                 "an open stylus unplugged in mid stroke goes on when it is back",
                                 "the watchdog cuts the motors of a host that died",
                                 "motors are cut while a tick hangs",
                                 "an open stylus of another version is refused",
                                 "who has no right to a device is told",
                                 "the watch tells of plugging in and out",
                                 "an open stylus pulled out in mid stroke mills on when it is back",
                                 "a 3D mouse pulled out in mid stroke mills on when it is back",
                                 "hostile reports do no harm"})
            QTest::newRow(fact) << QString::fromLatin1(fact);
    }
    void inTheVirtualMachine() {
        QFETCH(QString, fact);
        const QString result = results_.value(fact, QStringLiteral("not reached:\n") + QString::fromUtf8(output_));
        QVERIFY2(result == QLatin1String("ok "), qPrintable(result));
    }

private:
    bool run(const QString& program, const QStringList& arguments) {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(program, arguments);
        const bool ended = process.waitForFinished(280000);
        output_ = process.readAll();
        if (ended && process.exitCode() == 0 && process.exitStatus() == QProcess::NormalExit) return true;
        process.kill();
        process.waitForFinished();
        qWarning("%s", output_.constData());
        return false;
    }

    QByteArray output_;
    QHash<QString, QString> results_; ///< "ok " or "failed why", by name of the check
};

BURIN_TEST(TestDevices, QCoreApplication)

} // namespace burin::tst_devices

#include "tst_devices.moc"
