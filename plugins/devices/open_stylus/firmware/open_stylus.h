/* SPDX-FileCopyrightText: 2026 The Burin authors
 * SPDX-License-Identifier: Apache-2.0 */

/* Reference firmware of the open HID stylus protocol, version 1.1 (protocol.md beside this folder). Portable C11: no
 * allocation, no floating point, no operating system; sizes and byte order of the machine don't matter. What a board
 * has to supply is the table of functions open_stylus_port.
 *
 * Calls must not interrupt each other: make them all from one task, or mask the interrupt that delivers output reports
 * around open_stylus_step. */
#ifndef BURIN_OPEN_STYLUS_H
#define BURIN_OPEN_STYLUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    OPEN_STYLUS_INPUT_ID = 1,
    OPEN_STYLUS_OUTPUT_ID = 2,
    OPEN_STYLUS_FEATURE_ID = 3,
    OPEN_STYLUS_INPUT_SIZE = 48, /* bytes, with the id */
    OPEN_STYLUS_OUTPUT_SIZE = 32,
    OPEN_STYLUS_FEATURE_SIZE = 64,
    OPEN_STYLUS_DESCRIPTOR_SIZE = 42
};

/* What the board may report, and what the firmware finds out by itself. Each bit stays set until the condition is over
 * and the host has switched the motors off. */
enum {
    OPEN_STYLUS_WATCHDOG = 1 << 0, /* no good output report for too long; set by the firmware */
    OPEN_STYLUS_NOT_CALIBRATED = 1 << 1,
    OPEN_STYLUS_OVERHEATED = 1 << 2,
    OPEN_STYLUS_OVERLOADED = 1 << 3,
    OPEN_STYLUS_TOO_FAST = 1 << 4, /* also set by the firmware */
    OPEN_STYLUS_STOPPED = 1 << 5,
    OPEN_STYLUS_MECHANISM = 1 << 6
};
enum { OPEN_STYLUS_HEAT_UNKNOWN = 255 };

/* What the hardware measured. */
typedef struct open_stylus_reading {
    int32_t position[3]; /* x right, y away from the user, z up; 1/65536 mm */
    int32_t rotation[4]; /* unit quaternion w, x, y, z; 2^-30; tool frame to device frame */
    uint32_t buttons;    /* bit 0: the first */
    uint16_t faults;     /* OPEN_STYLUS_… that hold now */
    uint8_t heat;        /* of the hottest motor: 200 is what it bears */
} open_stylus_reading;

/* Units as in the feature report, protocol.md. */
typedef struct open_stylus_limits {
    uint8_t firmware_major, firmware_minor;
    uint16_t firmware_patch;
    uint8_t sensed_translations, sensed_rotations;     /* 0 to 3 each */
    uint8_t actuated_translations, actuated_rotations; /* 0 to 3 each */
    uint8_t buttons;                                   /* 0 to 32 */
    uint8_t source;                     /* 0 not stated, 1 estimated, 2 measured on this design, 3 on this unit */
    uint16_t rate;                      /* Hz: calls of open_stylus_step a second */
    uint16_t watchdog;                  /* ms */
    uint16_t delay;                     /* us from the measured pose to the report being ready */
    uint16_t maximum_speed;             /* mm/s */
    uint32_t maximum_force;             /* 1/65536 N */
    uint32_t continuous_force;          /* 1/65536 N */
    uint32_t maximum_torque;            /* 1/65536 N mm */
    uint32_t maximum_stiffness;         /* 1/256 N/m */
    uint32_t maximum_damping;           /* 1/65536 N s/m */
    uint32_t maximum_turning_stiffness; /* 1/256 N mm/rad */
    uint32_t workspace_radius;          /* 1/65536 mm */
    uint32_t position_step;             /* 2^-24 mm */
    uint32_t rotation_step;             /* 2^-30 rad */
    uint16_t handle_mass;               /* 1/65536 kg that the host shall lift; 0: the board does, or not known */
} open_stylus_limits;

/* What a board supplies. Every function gets `context`. */
typedef struct open_stylus_port {
    void* context;
    uint32_t (*microseconds)(void* context); /* free running, wraps around */
    void (*measure)(void* context, open_stylus_reading* reading);
    /* Both are shortened to the limits already. 1/65536 N and 1/65536 N mm, device frame. */
    void (*drive)(void* context, const int32_t force[3], const int32_t torque[3]);
    void (*motors_off)(void* context);
    /* Hands a report to the transport; false when it has no room: the report is lost, and its number shows it. */
    bool (*send)(void* context, const uint8_t* report, size_t size);
} open_stylus_port;

typedef struct open_stylus {
    open_stylus_limits limits;
    open_stylus_port port;
    int32_t force[3], torque[3]; /* of the newest good output report, shortened to the limits */
    int32_t position[3];         /* of the step before */
    uint32_t stepped;            /* us, time of the step before */
    uint32_t heard;              /* us, time of the newest good output report */
    uint16_t sequence;           /* of the next input report */
    uint16_t echo;               /* number of the newest good output report */
    uint16_t faults;             /* latched */
    bool has_position, has_heard, enabled, disarmed, motors_on, saturated;
} open_stylus;

extern const uint8_t open_stylus_descriptor[OPEN_STYLUS_DESCRIPTOR_SIZE];

/* Motors off. `limits` and `port` are copied. */
void open_stylus_start(open_stylus* stylus, const open_stylus_limits* limits, const open_stylus_port* port);

/* Once a period: watchdog, measurement, motors, one input report. */
void open_stylus_step(open_stylus* stylus);

/* For each output report that arrives, with its id: the motors follow at once. True when it was good. */
bool open_stylus_receive(open_stylus* stylus, const uint8_t* report, size_t size);

/* Answers GET_REPORT (feature). Returns the size, 0 when there is no such report or no room. */
size_t open_stylus_feature(const open_stylus* stylus, uint8_t id, uint8_t* report, size_t room);

/* CRC-16/IBM-3740 ("CCITT-FALSE"); of "123456789" 0x29b1. */
uint16_t open_stylus_crc(const uint8_t* bytes, size_t size);

#ifdef __cplusplus
}
#endif

#endif
