// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/checksum.h"
#include "core/volume/packed/volume_file.h"
#include "tests/core/volume/random_volumes.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

#include <fstream>
#include <sstream>

namespace burin::tst_volume_file {

using namespace burin::test;

namespace {

constexpr std::string_view headerMark = "BurinVol", blockMark = "BurinBlk";

std::string fileOf(const VolumeSnapshot& snapshot) {
    std::ostringstream stream;
    Progress progress;
    return writeVolume(stream, "test", snapshot, progress) ? stream.str() : std::string();
}

Result<VolumeFileContent> contentOf(const std::string& bytes, std::size_t reservedBytes = 0) {
    std::istringstream stream(bytes);
    Progress progress;
    return readVolume(stream, "test", progress, reservedBytes);
}

constexpr std::size_t smallReserve = std::size_t{1} << 20; ///< for files that are read thousands of times

bool isLost(const std::vector<VolumeLoss>& losses, LineIndex line) {
    return std::ranges::any_of(losses, [&](const VolumeLoss& loss) {
        return loss.low.u <= line.u && line.u < loss.high.u && loss.low.v <= line.v && line.v < loss.high.v;
    });
}

/// Everything that is not reported as lost is unchanged, and everything reported is air.
bool givesBackTheRest(const LineCopies& copies, const VolumeFileContent& content) {
    const Grid& grid = content.volume.grid();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            if (isLost(content.lost, line)) {
                const auto segments = content.volume.line(line);
                if (segments.size() != 1 || segments[0].property() != airProperty) return false;
            }
    return copies.equalsBut(content.volume, [&](LineIndex line) { return isLost(content.lost, line); });
}

/// Six groups of bricks, most of them narrow, with few scanlines that are not air.
RunVolume volumeOfSixGroups() {
    RunVolume volume = emptyVolume(cubeGrid({260, 136, 16}));
    RandomContent content(11, Content::sheets);
    for (const LineIndex corner : {LineIndex{3, 2}, {140, 100}, {253, 20}, {90, 129}, {200, 126}, {256, 130}})
        for (LineIndex line = corner; line.v < std::min(corner.v + 9, 136); ++line.v)
            for (line.u = corner.u; line.u < std::min(corner.u + 9, 260); ++line.u)
                (void)volume.setLine(line, content.segments(line, 16 * unitsPerVoxel));
    return volume;
}

std::size_t place(const std::string& bytes, std::string_view mark, int which) {
    std::size_t at = bytes.find(mark);
    while (which-- > 0) at = bytes.find(mark, at + 1);
    return at;
}

} // namespace

class TestVolumeFile : public QObject {
    Q_OBJECT

private slots:
    void checksumIsTheStandardOne() { QCOMPARE(checksum("123456789"), std::uint64_t{0x995dc9bbdf1939fa}); }

    void anyVolumeComesBack() {
        QVERIFY(rc::check("written and read", [] {
            const Grid grid = randomGrid(*rc::gen::arbitrary<std::uint32_t>(), 300);
            const Grid small = randomGrid(*rc::gen::arbitrary<std::uint32_t>(), 40);
            const auto content = static_cast<Content>(*rc::gen::inRange(0, contentCount));
            const bool many = content == Content::lattice || content == Content::noise || content == Content::mixed;
            RunVolume volume = emptyVolume(many ? small : grid, std::size_t{16} << 20);
            RandomContent(*rc::gen::arbitrary<std::uint32_t>(), content).fill(volume);
            const LineCopies copies(volume);
            const Result<VolumeFileContent> back = contentOf(fileOf(volume.snapshot()));
            RC_ASSERT(back.hasValue());
            RC_ASSERT(back->lost.empty());
            RC_ASSERT(!back->damage().has_value());
            RC_ASSERT(!back->headerWasDamaged);
            RC_ASSERT(copies.equals(back->volume));
            RC_ASSERT(back->volume.amounts() == copies.amounts());
            const Grid& found = back->volume.grid();
            RC_ASSERT(found.low() == volume.grid().low());
            RC_ASSERT(found.edge() == volume.grid().edge());
            RC_ASSERT(found.count() == volume.grid().count());
            RC_ASSERT(found.axis() == volume.grid().axis());
            RC_ASSERT(back->volume.properties().size() == volume.properties().size());
        }));
    }

    void propertiesComeBackWithAllTheirValues() {
        PropertyList list;
        Property steel;
        steel.id = "steel";
        steel.name = "Steel";
        steel.colour = {1, 2, 3};
        steel.machinability = Machinability::isProtected;
        steel.values["hardness of the day"] = {0.1, "HB", "a table", true};
        QVERIFY(list.add(steel));
        const RunVolume volume = *RunVolume::make(cubeGrid({9, 9, 9}, RunAxis::y), list);
        RunVolume copy = *RunVolume::make(cubeGrid({9, 9, 9}, RunAxis::y), list);
        const Result<VolumeFileContent> back = contentOf(fileOf(copy.snapshot()));
        QVERIFY(back);
        const Property& found = back->volume.properties()[1];
        QCOMPARE(found.id, steel.id);
        QCOMPARE(found.name, steel.name);
        QVERIFY(found.colour == steel.colour && found.machinability == steel.machinability);
        QVERIFY(back->volume.properties().isProtected(1));
        QCOMPARE(found.valueOr("hardness of the day", 0.0), 0.1);
        QCOMPARE(found.values.at("hardness of the day").source, std::string("a table"));
    }

    /// Every byte in turn, each bit once: nothing is lost silently, and nothing is changed without being reported.
    void everyFlippedByteIsFoundOrHarmless() {
        RunVolume volume = volumeOfSixGroups();
        const LineCopies copies(volume);
        const std::string whole = fileOf(volume.snapshot());
        QVERIFY2(whole.size() < 8192, qPrintable(QString::number(whole.size())));
        int harmless = 0, named = 0;
        for (std::size_t at = 0; at < whole.size(); ++at) {
            std::string bytes = whole;
            bytes[at] ^= static_cast<char>(1 << (at % 8));
            const Result<VolumeFileContent> back = contentOf(bytes, smallReserve);
            QVERIFY2(back, qPrintable(QString("byte %1").arg(at)));
            QVERIFY2(givesBackTheRest(copies, *back), qPrintable(QString("byte %1").arg(at)));
            QCOMPARE(back->damage().has_value(), !back->lost.empty());
            ++(back->lost.empty() ? harmless : named);
            if (back->lost.empty()) continue;
            const VolumeLoss& loss = back->lost.front(); // one of the groups, and no more
            QCOMPARE(back->lost.size(), std::size_t{1});
            QVERIFY(loss.low.u % 128 == 0 && loss.low.v % 128 == 0);
            QVERIFY(loss.high.u == std::min(loss.low.u + 128, 260) && loss.high.v == std::min(loss.low.v + 128, 136));
        }
        QVERIFY(harmless > 0 && named > 0);
    }

    void aFileThatWasCutShortGivesWhatIsThere() {
        RunVolume volume = volumeOfSixGroups();
        const LineCopies copies(volume);
        const std::string whole = fileOf(volume.snapshot());
        const std::size_t afterHeader = whole.find(blockMark);
        std::size_t before = 260 * 136;
        for (std::size_t size = afterHeader; size <= whole.size(); size += 7) {
            const Result<VolumeFileContent> back = contentOf(whole.substr(0, size), smallReserve);
            QVERIFY(back);
            QVERIFY(givesBackTheRest(copies, *back));
            std::size_t lost = 0;
            for (const VolumeLoss& loss : back->lost)
                lost += static_cast<std::size_t>((loss.high.u - loss.low.u) * (loss.high.v - loss.low.v));
            QVERIFY(lost <= before);
            before = lost;
        }
        QCOMPARE(before, std::size_t{0});
        // The front is gone: the header at the end is equivalent.
        const Result<VolumeFileContent> back = contentOf(whole.substr(afterHeader - 5));
        QVERIFY(back && back->headerWasDamaged && back->lost.empty());
        QVERIFY(copies.equals(back->volume));
    }

    void lostAddedAndSwappedBytesCostTheirGroupAlone() {
        RunVolume volume = volumeOfSixGroups();
        const LineCopies copies(volume);
        const std::string whole = fileOf(volume.snapshot());
        const std::size_t third = place(whole, blockMark, 2), fourth = place(whole, blockMark, 3);
        std::string without = whole, more = whole, twice = whole;
        without.erase(third + 80, 3);
        more.insert(third + 70, "something else");
        twice.insert(fourth, whole.substr(third, fourth - third));
        for (const std::string& bytes : {without, more}) {
            const Result<VolumeFileContent> back = contentOf(bytes);
            QVERIFY(back);
            QCOMPARE(back->lost.size(), std::size_t{1});
            QVERIFY(givesBackTheRest(copies, *back));
            QVERIFY((back->lost[0].low == LineIndex{256, 0}));
        }
        const Result<VolumeFileContent> back = contentOf(twice); // duplicates are harmless
        QVERIFY(back && back->lost.empty() && copies.equals(back->volume));
        std::string blockless = whole;
        blockless.erase(third, fourth - third);
        const Result<VolumeFileContent> rest = contentOf(blockless);
        QVERIFY(rest && rest->lost.size() == 1 && givesBackTheRest(copies, *rest));
    }

    void randomDamageIsNamed() {
        RunVolume volume = volumeOfSixGroups();
        const LineCopies copies(volume);
        const std::string whole = fileOf(volume.snapshot());
        QVERIFY(rc::check("several damages at once", [&] {
            std::string bytes = whole;
            for (int i = *rc::gen::inRange(1, 12); i > 0; --i) {
                const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
                const auto length = std::min(*rc::gen::inRange<std::size_t>(1, 60), bytes.size() - at);
                switch (*rc::gen::inRange(0, 3)) {
                case 0:
                    bytes.erase(at, length);
                    break;
                case 1:
                    bytes.replace(at, length, std::string(length, '\0'));
                    break;
                default:
                    bytes[at] = static_cast<char>(*rc::gen::inRange(0, 256) - 128);
                }
                if (bytes.empty()) return;
            }
            const Result<VolumeFileContent> back = contentOf(bytes, smallReserve);
            if (back)
                RC_ASSERT(givesBackTheRest(copies, *back));
            else
                RC_ASSERT(back.error().code == ErrorCode::fileDamaged ||
                          back.error().code == ErrorCode::fileFormatUnknown);
        }));
    }

    void theLossIsSaidInMillimetres() {
        const Grid grid = *Grid::make({-10.0, 5.0, 1.0}, 0.5, {200, 300, 40}, RunAxis::z);
        RunVolume volume = emptyVolume(grid);
        RandomContent(2, Content::creases).fill(volume);
        std::string bytes = fileOf(volume.snapshot());
        bytes[place(bytes, blockMark, 1) + 100] ^= 1; // u from 128, v to 128
        const Result<VolumeFileContent> back = contentOf(bytes);
        QVERIFY(back && back->lost.size() == 1);
        QCOMPARE(back->lost[0].box.low, glm::dvec3(54.0, 5.0, 1.0));
        QCOMPARE(back->lost[0].box.high, glm::dvec3(90.0, 69.0, 21.0));
        const std::optional<Error> damage = back->damage();
        QVERIFY(damage && damage->code == ErrorCode::fileDamaged);
        QCOMPARE(damage->place, std::string("144 bricks are lost and read as air: x 54.000 to 90.000, y 5.000 to "
                                            "69.000, z 1.000 to 21.000 mm"));
    }

    void whatIsNoVolumeIsRefused() {
        RunVolume volume = emptyVolume(cubeGrid({8, 8, 8}));
        std::string bytes = fileOf(volume.snapshot());
        QCOMPARE(contentOf("").error().code, ErrorCode::fileFormatUnknown);
        QCOMPARE(contentOf("G0 X0 Y0\n").error().code, ErrorCode::fileFormatUnknown);
        QCOMPARE(contentOf(std::string(200'000, 'B')).error().code, ErrorCode::fileFormatUnknown);
        bytes[12] ^= 1;
        bytes[bytes.size() - 20] ^= 1;
        const Error both = contentOf(bytes).error();
        QCOMPARE(both.code, ErrorCode::fileDamaged);
        QCOMPARE(both.place, std::string("both copies of the header"));
    }

    void aNewerVersionIsRefused() {
        RunVolume volume = emptyVolume(cubeGrid({8, 8, 8}));
        std::string bytes = fileOf(volume.snapshot());
        const std::size_t end = bytes.find(blockMark);
        bytes[headerMark.size()] = 2;
        const std::uint64_t sum = checksum(std::string_view(bytes).substr(0, end - 8));
        for (std::size_t i = 0; i < 8; ++i) bytes[end - 8 + i] = static_cast<char>((sum >> (8 * i)) & 0xff);
        const Error refused = contentOf(bytes).error();
        QCOMPARE(refused.code, ErrorCode::fileFromNewerBurin);
        QCOMPARE(refused.detail, std::string("2"));
    }

    void filesAreReplacedWholeOrNotAtAll() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("part.volume").toStdString();
        RunVolume volume = volumeOfSixGroups();
        Progress progress, stopped;
        stopped.cancel();
        QVERIFY(writeVolumeFile(file, volume.snapshot(), progress));
        QCOMPARE(progress.fraction(), 1.0);
        const LineCopies copies(volume);
        QVERIFY(volume.fillBlock({0, 0}, {260, 136}, 0, 4096, wax));
        QCOMPARE(writeVolumeFile(file, volume.snapshot(), stopped).error().code, ErrorCode::cancelled);
        const Result<VolumeFileContent> back = readVolumeFile(file, progress);
        QVERIFY(back && copies.equals(back->volume));
        QCOMPARE(readVolumeFile(file, stopped).error().code, ErrorCode::cancelled);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
        QCOMPARE(writeVolumeFile("/proc/none/part.volume", volume.snapshot(), progress).error().code,
                 ErrorCode::fileNotWritable);
        QCOMPARE(readVolumeFile(file / "none", progress).error().code, ErrorCode::fileNotFound);
        QCOMPARE(readVolumeFile(folder.path().toStdString(), progress).error().code, ErrorCode::fileNotReadable);
        std::filesystem::create_symlink("circle", folder.filePath("circle").toStdString());
        QCOMPARE(readVolumeFile(folder.filePath("circle").toStdString(), progress).error().code,
                 ErrorCode::fileNotReadable);
        std::ofstream(file, std::ios::trunc).close();
        QCOMPARE(readVolumeFile(file, progress).error().code, ErrorCode::fileEmpty);
    }

    void aFullDiskIsSaid() {
        if (!std::filesystem::exists("/dev/full")) QSKIP("no /dev/full");
        std::ofstream full("/dev/full", std::ios::binary);
        RunVolume volume = volumeOfSixGroups();
        Progress progress;
        QCOMPARE(writeVolume(full, "full", volume.snapshot(), progress).error().code, ErrorCode::diskFull);
    }

    /// 83,000 segments on a line: counts above 16 bits, in a brick and on a line.
    void aBrickOfManySegmentsComesBack() {
        const Grid grid = cubeGrid({9, 3, 32768});
        RunVolume volume = emptyVolume(grid, std::size_t{64} << 20);
        std::vector<Segment> segments;
        for (RunPosition at = 101; at < grid.lineEnd(); at += 101 + at % 7)
            segments.emplace_back(at, static_cast<PropertyIndex>(segments.size() % 3));
        segments.emplace_back(grid.lineEnd(), part);
        QVERIFY(segments.size() > 65535);
        for (const LineIndex line : {LineIndex{0, 0}, {7, 2}, {8, 1}}) QVERIFY(volume.setLine(line, segments));
        const Result<VolumeFileContent> back = contentOf(fileOf(volume.snapshot()));
        QVERIFY(back && back->lost.empty() && LineCopies(volume).equals(back->volume));
    }

    void tooSmallAReserveIsRefused() {
        RunVolume volume = emptyVolume(cubeGrid({64, 64, 256}));
        RandomContent(1, Content::sheets).fill(volume);
        std::istringstream stream(fileOf(volume.snapshot()));
        Progress progress;
        QCOMPARE(readVolume(stream, "test", progress, 4096).error().code, ErrorCode::volumeOutOfMemory);
    }
};

BURIN_TEST(TestVolumeFile, NoApplication)

} // namespace burin::tst_volume_file

#include "tst_volume_file.moc"
