/* SPDX-FileCopyrightText: 2026 The Burin authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "open_stylus.h"

#include <string.h>

static const uint16_t known_faults = 0x7f; /* each of them keeps the motors off */

enum { flag_motors_on = 1, flag_pose_valid = 2, flag_saturated = 4, flag_heard = 8 };
enum { flag_enable = 1 };

/* clang-format off */
const uint8_t open_stylus_descriptor[] = {
    0x06, 0xb1, 0xff,                   /* usage page: vendor defined, 0xffb1 */
    0x09, 0x01,                         /* usage: open stylus */
    0xa1, 0x01,                         /* collection: application */
    0x15, 0x00,                         /*   logical minimum 0 */
    0x26, 0xff, 0x00,                   /*   logical maximum 255 */
    0x75, 0x08,                         /*   report size 8 bits */
    0x85, OPEN_STYLUS_INPUT_ID,         /*   report id */
    0x09, 0x02,                         /*   usage: reading */
    0x95, OPEN_STYLUS_INPUT_SIZE - 1,   /*   report count */
    0x82, 0x02, 0x01,                   /*   input: data, variable, absolute, buffered bytes */
    0x85, OPEN_STYLUS_OUTPUT_ID,        /*   report id */
    0x09, 0x03,                         /*   usage: wrench */
    0x95, OPEN_STYLUS_OUTPUT_SIZE - 1,  /*   report count */
    0x92, 0x02, 0x01,                   /*   output */
    0x85, OPEN_STYLUS_FEATURE_ID,       /*   report id */
    0x09, 0x04,                         /*   usage: identity and limits */
    0x95, OPEN_STYLUS_FEATURE_SIZE - 1, /*   report count */
    0xb2, 0x02, 0x01,                   /*   feature */
    0xc0                                /* end */
};
/* clang-format on */
_Static_assert(sizeof open_stylus_descriptor == OPEN_STYLUS_DESCRIPTOR_SIZE, "as open_stylus.h says");

uint16_t open_stylus_crc(const uint8_t* bytes, size_t size) {
    uint16_t crc = 0xffff;
    for (size_t i = 0; i < size; ++i) {
        crc = (uint16_t)(crc ^ (uint16_t)((uint16_t)bytes[i] << 8));
        for (int bit = 0; bit < 8; ++bit) crc = (uint16_t)((crc & 0x8000) ? (crc << 1) ^ 0x1021 : crc << 1);
    }
    return crc;
}

static void put16(uint8_t* to, uint16_t value) {
    to[0] = (uint8_t)(value & 0xff);
    to[1] = (uint8_t)(value >> 8);
}

static void put32(uint8_t* to, uint32_t value) {
    put16(to, (uint16_t)(value & 0xffff));
    put16(to + 2, (uint16_t)(value >> 16));
}

static uint16_t get16(const uint8_t* from) {
    return (uint16_t)(from[0] | (uint16_t)((uint16_t)from[1] << 8));
}

static uint32_t get32(const uint8_t* from) {
    return (uint32_t)get16(from) | ((uint32_t)get16(from + 2) << 16);
}

/* Converts from two's complement, independently of how the machine converts unsigned values above INT32_MAX. */
static int32_t signed32(uint32_t value) {
    return value <= INT32_MAX ? (int32_t)value : (int32_t)(value - 0x80000000u) + INT32_MIN;
}

static uint32_t square_root(uint64_t value) { /* rounded up */
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 32; bit != 0; bit >>= 1)
        if ((root + bit) <= UINT32_MAX && (root + bit) * (root + bit) <= value) root += bit;
    return (uint32_t)(root * root < value && root < UINT32_MAX ? root + 1 : root);
}

/* Limits a vector to a length, keeping its direction. Returns whether it had to be shortened. */
static bool shorten(int32_t vector[3], uint32_t length) {
    uint64_t square = 0;
    for (int i = 0; i < 3; ++i) {
        const int64_t value = vector[i];
        square += (uint64_t)(value * value); /* three times 2^62 at most */
    }
    if (square <= (uint64_t)length * length) return false;
    const int64_t norm = (int64_t)square_root(square);
    for (int i = 0; i < 3; ++i) vector[i] = (int32_t)((int64_t)vector[i] * (int64_t)length / norm);
    return true;
}

static void off(open_stylus* stylus) {
    memset(stylus->force, 0, sizeof stylus->force);
    memset(stylus->torque, 0, sizeof stylus->torque);
    stylus->enabled = stylus->disarmed = stylus->motors_on = stylus->saturated = false;
    stylus->port.motors_off(stylus->port.context);
}

/* The motors turn on only if the host has sent "off" since the last fault. */
static void drive(open_stylus* stylus) {
    const bool on = stylus->enabled && stylus->disarmed && stylus->faults == 0;
    if (on)
        stylus->port.drive(stylus->port.context, stylus->force, stylus->torque);
    else if (stylus->motors_on)
        stylus->port.motors_off(stylus->port.context);
    stylus->motors_on = on;
}

void open_stylus_start(open_stylus* stylus, const open_stylus_limits* limits, const open_stylus_port* port) {
    memset(stylus, 0, sizeof *stylus);
    stylus->limits = *limits;
    stylus->port = *port;
    stylus->stepped = port->microseconds(port->context);
    off(stylus);
}

bool open_stylus_receive(open_stylus* stylus, const uint8_t* report, size_t size) {
    if (size != OPEN_STYLUS_OUTPUT_SIZE || report[0] != OPEN_STYLUS_OUTPUT_ID) return false;
    if (get16(report + size - 2) != open_stylus_crc(report, size - 2)) return false;
    const uint16_t number = get16(report + 2);
    if (stylus->has_heard && number == stylus->echo) return false; /* a buffer's repeat is no sign of life */
    stylus->echo = number;
    stylus->has_heard = true;
    stylus->heard = stylus->port.microseconds(stylus->port.context);
    stylus->enabled = (report[1] & flag_enable) != 0;
    if (!stylus->enabled) stylus->disarmed = true;
    for (int i = 0; i < 3; ++i) {
        stylus->force[i] = signed32(get32(report + 4 + 4 * i));
        stylus->torque[i] = signed32(get32(report + 16 + 4 * i));
    }
    const bool force = shorten(stylus->force, stylus->limits.maximum_force);
    const bool torque = shorten(stylus->torque, stylus->limits.maximum_torque);
    stylus->saturated = force || torque;
    drive(stylus);
    return true;
}

static bool too_fast(open_stylus* stylus, const open_stylus_reading* reading, uint32_t elapsed) {
    uint64_t square = 0;
    for (int i = 0; i < 3; ++i) {
        int64_t moved = (int64_t)reading->position[i] - stylus->position[i];
        if (moved > INT32_MAX || moved < INT32_MIN) moved = INT32_MAX;
        square += (uint64_t)(moved * moved);
        stylus->position[i] = reading->position[i];
    }
    const bool known = stylus->has_position;
    stylus->has_position = true;
    /* mm/s times us is nm; 65536 steps are 10^6 nm. Limiting the time to a second keeps it within 64 bits. */
    const uint64_t time = elapsed < 1000000 ? elapsed : 1000000;
    const uint64_t allowed = (uint64_t)stylus->limits.maximum_speed * time * 65536 / 1000000;
    return known && square > allowed * allowed;
}

/* Latches faults; clears those that are no longer present once the host has switched the motors off. */
static void judge(open_stylus* stylus, const open_stylus_reading* reading, uint32_t now) {
    uint16_t present = (uint16_t)(reading->faults & known_faults);
    const uint32_t silence = now - stylus->heard;
    if (stylus->motors_on && silence > (uint32_t)stylus->limits.watchdog * 1000) present |= OPEN_STYLUS_WATCHDOG;
    if (too_fast(stylus, reading, now - stylus->stepped)) present |= OPEN_STYLUS_TOO_FAST;
    stylus->stepped = now;
    if (stylus->disarmed && !stylus->enabled) stylus->faults = 0;
    stylus->faults |= present;
    if (present != 0 || (stylus->faults != 0 && stylus->motors_on)) off(stylus);
}

static void send(open_stylus* stylus, const open_stylus_reading* reading, uint32_t measured) {
    uint8_t report[OPEN_STYLUS_INPUT_SIZE] = {0};
    const bool calibrated = (stylus->faults & (OPEN_STYLUS_NOT_CALIBRATED | OPEN_STYLUS_MECHANISM)) == 0;
    report[0] = OPEN_STYLUS_INPUT_ID;
    report[1] =
        (uint8_t)((stylus->motors_on ? flag_motors_on : 0) | (calibrated ? flag_pose_valid : 0) |
                  (stylus->motors_on && stylus->saturated ? flag_saturated : 0) | (stylus->has_heard ? flag_heard : 0));
    put16(report + 2, stylus->sequence++);
    put32(report + 4, measured);
    for (int i = 0; i < 3; ++i) put32(report + 8 + 4 * i, (uint32_t)reading->position[i]);
    for (int i = 0; i < 4; ++i) put32(report + 20 + 4 * i, (uint32_t)reading->rotation[i]);
    put32(report + 36, reading->buttons);
    put16(report + 40, stylus->faults);
    put16(report + 42, stylus->echo);
    report[44] = reading->heat;
    put16(report + 46, open_stylus_crc(report, 46));
    (void)stylus->port.send(stylus->port.context, report, sizeof report);
}

void open_stylus_step(open_stylus* stylus) {
    open_stylus_reading reading = {{0, 0, 0}, {INT32_C(1) << 30, 0, 0, 0}, 0, 0, OPEN_STYLUS_HEAT_UNKNOWN};
    const uint32_t now = stylus->port.microseconds(stylus->port.context);
    stylus->port.measure(stylus->port.context, &reading);
    judge(stylus, &reading, now);
    drive(stylus);
    send(stylus, &reading, now);
}

size_t open_stylus_feature(const open_stylus* stylus, uint8_t id, uint8_t* report, size_t room) {
    const open_stylus_limits* limits = &stylus->limits;
    if (id != OPEN_STYLUS_FEATURE_ID || room < OPEN_STYLUS_FEATURE_SIZE) return 0;
    memset(report, 0, OPEN_STYLUS_FEATURE_SIZE);
    report[0] = OPEN_STYLUS_FEATURE_ID;
    report[1] = 1; /* protocol 1.1 */
    report[2] = 1;
    report[3] = 1; /* units of protocol.md */
    memcpy(report + 4, "OSTY", 4);
    report[8] = limits->firmware_major;
    report[9] = limits->firmware_minor;
    put16(report + 10, limits->firmware_patch);
    report[12] = (uint8_t)(limits->sensed_translations | (limits->sensed_rotations << 4));
    report[13] = (uint8_t)(limits->actuated_translations | (limits->actuated_rotations << 4));
    report[14] = limits->buttons;
    report[15] = limits->source;
    put16(report + 16, limits->rate);
    put16(report + 18, limits->watchdog);
    put16(report + 20, limits->delay);
    put16(report + 22, limits->maximum_speed);
    put32(report + 24, limits->maximum_force);
    put32(report + 28, limits->continuous_force);
    put32(report + 32, limits->maximum_torque);
    put32(report + 36, limits->maximum_stiffness);
    put32(report + 40, limits->maximum_damping);
    put32(report + 44, limits->maximum_turning_stiffness);
    put32(report + 48, limits->workspace_radius);
    put32(report + 52, limits->position_step);
    put32(report + 56, limits->rotation_step);
    put16(report + 60, limits->handle_mass);
    put16(report + 62, open_stylus_crc(report, 62));
    return OPEN_STYLUS_FEATURE_SIZE;
}
