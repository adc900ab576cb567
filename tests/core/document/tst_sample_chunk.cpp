// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/compression.h"
#include "core/document/column_codec.h"
#include "core/document/mesh_blob.h"
#include "core/document/sample_chunk.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <rapidcheck.h>
#include <span>
#include <utility>

namespace burin::tst_sample_chunk {

namespace {

/// Any bit pattern, with difficult numbers more often than by chance.
double anyDouble() {
    using Limits = std::numeric_limits<double>;
    return *rc::gen::oneOf(rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                                        [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
                           rc::gen::element(0.0, -0.0, 1.0, -1.0, 0.1, Limits::infinity(), -Limits::infinity(),
                                            Limits::quiet_NaN(), Limits::denorm_min(), Limits::max(),
                                            Limits::lowest()));
}

glm::dvec3 anyVector() {
    const double x = anyDouble(), y = anyDouble(), z = anyDouble();
    return {x, y, z};
}

Sample anySample() {
    Sample sample;
    sample.tick = *rc::gen::arbitrary<std::uint64_t>();
    sample.time = anyDouble();
    sample.device.position = anyVector();
    const glm::dvec3 imaginary = anyVector();
    sample.device.rotation = glm::dquat(anyDouble(), imaginary.x, imaginary.y, imaginary.z);
    sample.stylusTip = anyVector();
    sample.proxy = {anyVector(), anyVector()};
    sample.force = anyVector();
    if (*rc::gen::arbitrary<bool>()) sample.torque = anyVector();
    sample.cuttingForce = anyVector();
    sample.reportedRemoval = anyDouble();
    for (RemovedMaterial& removed : sample.removed)
        removed = {*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint8_t>()};
    sample.buttons = *rc::gen::arbitrary<std::uint32_t>();
    sample.flags = *rc::gen::arbitrary<std::uint32_t>();
    return sample;
}

std::vector<Sample> anySamples() {
    std::vector<Sample> samples(*rc::gen::inRange<std::size_t>(0, 40));
    for (Sample& sample : samples) sample = anySample();
    return samples;
}

} // namespace

class TestSampleChunk : public QObject {
    Q_OBJECT
private slots:
    void everyBitOfASampleComesBack() {
        QVERIFY(rc::check("round trip", [] {
            const std::vector<Sample> samples = anySamples();
            const auto back = decodeSamples(encodeSamples(samples), samples.size());
            RC_ASSERT(back.has_value());
            RC_ASSERT(fixture::identical(*back, samples));
        }));
    }
    void wordsKeepTheOrderOfNumbers() {
        QVERIFY(rc::check("order", [] {
            const double one = anyDouble(), other = anyDouble();
            RC_ASSERT(std::bit_cast<std::uint64_t>(doubleOf(wordOf(one))) == std::bit_cast<std::uint64_t>(one));
            if (one < other) RC_ASSERT(wordOf(one) < wordOf(other));
        }));
    }
    void aDamagedChunkIsRefused() {
        const std::string whole = encodeSamples(fixture::handSamples(0, 60));
        QVERIFY(rc::check("one byte differs", [&] {
            std::string chunk = whole;
            char& byte = chunk[*rc::gen::inRange<std::size_t>(0, chunk.size())];
            byte = static_cast<char>(byte ^ *rc::gen::inRange(1, 256));
            const auto read = decodeSamples(chunk, 60);
            // Zstandard leaves a few bits of its header unused; whatever is read must be what was written.
            RC_ASSERT(!read || fixture::identical(*read, fixture::handSamples(0, 60)));
        }));
        for (std::size_t size = 0; size < whole.size(); ++size)
            QVERIFY(!decodeSamples(std::string_view(whole).substr(0, size), 60));
        QVERIFY(!decodeSamples(whole, 59));
        QVERIFY(!decodeSamples(whole, 61));
        QVERIFY(!decodeSamples(whole, std::numeric_limits<std::size_t>::max()));
    }
    /// 48 bytes for a row of six columns: numbers of rows whose byte count is a small number modulo 2^64.
    void countsThatOverflowAreRefused() {
        const std::string frame = compress(std::string(38, '\0'));
        QVERIFY(!decodeColumns(frame, 6, 384'307'168'202'282'326U));
        QVERIFY(!decodeColumns(compress(std::string(6, '\0')), 6, std::size_t{1} << 61U));
    }
    void noiseIsNeverRead() {
        QVERIFY(rc::check("random bytes", [] {
            const auto bytes = *rc::gen::arbitrary<std::string>();
            RC_ASSERT(!decodeSamples(bytes, *rc::gen::inRange<std::size_t>(0, 100)));
            RC_ASSERT(!decodeMesh(bytes));
        }));
    }
    /// A device without torque is stored as before format 12, to the byte; decoding either form gives the torque.
    void torqueTakesRoomOnlyWhereThereIsAny() {
        std::vector<Sample> samples = fixture::handSamples(0, 60);
        const std::string plain = encodeSamples(samples);
        QCOMPARE(plain.front(), char{1});
        samples[41].torque = {0.0, -12.5, 0.0};
        const std::string turning = encodeSamples(samples);
        QCOMPARE(turning.front(), char{2});
        QCOMPARE((*decodeSamples(plain, 60))[41].torque, glm::dvec3(0.0));
        QCOMPARE((*decodeSamples(turning, 60))[41].torque, glm::dvec3(0.0, -12.5, 0.0));
        QCOMPARE((*decodeSamples(turning, 60))[40].torque, glm::dvec3(0.0));
    }
    void freeMotionIsNotStoredTwice() {
        std::vector<Sample> apart = fixture::handSamples(0, 1000), together = apart;
        for (std::size_t i = 0; i < apart.size(); ++i) {
            together[i].proxy.tip = together[i].stylusTip;
            apart[i].proxy.tip = apart[i].stylusTip * 1.01;
        }
        // Three noisy doubles per sample take at least twelve bytes.
        QVERIFY(encodeSamples(together).size() + 12 * apart.size() < encodeSamples(apart).size());
    }
    void meshesComeBackBitForBit() {
        QVERIFY(rc::check("round trip", [] {
            TriangleMesh mesh;
            mesh.vertices.resize(*rc::gen::inRange<std::size_t>(1, 30));
            for (glm::dvec3& vertex : mesh.vertices) vertex = anyVector();
            mesh.triangles.resize(*rc::gen::inRange<std::size_t>(0, 30));
            for (auto& triangle : mesh.triangles)
                for (std::uint32_t& index : triangle)
                    index = *rc::gen::inRange(0u, static_cast<std::uint32_t>(mesh.vertices.size()));
            const auto back = decodeMesh(encodeMesh(mesh));
            RC_ASSERT(back.has_value());
            Model one, other;
            one.bodies.emplace_back().mesh = mesh;
            other.bodies.emplace_back().mesh = *back;
            RC_ASSERT(fixture::identical(one, other));
        }));
    }
    /// The most regular mesh is compressed ten thousand times.
    void aFinelyMeshedPlateComesBack() {
        constexpr std::uint32_t side = 600;
        TriangleMesh plate;
        for (std::uint32_t row = 0; row < side; ++row)
            for (std::uint32_t column = 0; column < side; ++column) plate.vertices.emplace_back(column, row, 5.0);
        for (std::uint32_t row = 0; row + 1 < side; ++row)
            for (std::uint32_t corner = row * side; corner + 1 < (row + 1) * side; ++corner) {
                plate.triangles.push_back({corner, corner + 1, corner + side});
                plate.triangles.push_back({corner + 1, corner + side + 1, corner + side});
            }
        const std::string blob = encodeMesh(plate);
        const auto back = decodeMesh(blob);
        QVERIFY(back && back->vertices == plate.vertices && back->triangles == plate.triangles);
        MeshesTogether meshes;
        for (int i = 0; i < 100; ++i) QVERIFY(meshes.add(plate, blob.size()));
    }
    void manySmallBlobsThatComeToGigabytesAreRefused() {
        TriangleMesh mesh;
        mesh.vertices.resize(600'000);
        MeshesTogether meshes;
        int taken = 0;
        while (taken < 1000 && meshes.add(mesh, 1000)) ++taken;
        QCOMPARE(taken, 9); // of 14.4 MB each
    }
    void aTriangleWithoutItsVertexIsRefused() {
        TriangleMesh mesh = fixture::model().bodies.front().mesh;
        mesh.triangles.front()[1] = 8;
        QVERIFY(!decodeMesh(encodeMesh(mesh)));
    }
    void anEmptyBoxStaysEmpty() {
        const auto box = decodeBox(encodeBox(Box{}));
        QVERIFY(box && box->empty());
        QVERIFY(!decodeBox("short"));
    }
};

BURIN_TEST(TestSampleChunk, NoApplication)

} // namespace burin::tst_sample_chunk

#include "tst_sample_chunk.moc"
