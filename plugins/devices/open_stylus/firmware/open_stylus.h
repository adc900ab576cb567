/* SPDX-FileCopyrightText: 2026 The Burin authors
 * SPDX-License-Identifier: Apache-2.0 */

/* Reference firmware of the open HID stylus protocol, version 1.1 (protocol.md next to this folder). Portable C11: no
 * allocation, no floating point, no operating system, independent of the machine's type sizes and byte order. A board
 * has to supply the functions of open_stylus_port.
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

/* Faults reported by the board, or detected by the firmware itself. Each bit stays set until the condition is over and
 * the host has switched the motors off. */
enum {
    OPEN_STYLUS_WATCHDOG = 1 << 0, /* no valid output report for too long; set by the firmware */
    OPEN_STYLUS_NOT_CALIBRATED = 1 << 1,
    OPEN_STYLUS_OVERHEATED = 1 << 2,
    OPEN_STYLUS_OVERLOADED = 1 << 3,
    OPEN_STYLUS_TOO_FAST = 1 << 4, /* also set by the firmware */
    OPEN_STYLUS_STOPPED = 1 << 5,
    OPEN_STYLUS_MECHANISM = 1 << 6
};
enum { OPEN_STYLUS_HEAT_UNKNOWN = 255 };

/* A measurement of the hardware. */
typedef struct open_stylus_reading {
    int32_t position[3]; /* x right, y away from the user, z up; 1/65536 mm */
    int32_t rotation[4]; /* unit quaternion w, x, y, z; 2^-30; tool frame to device frame */
    uint32_t buttons;    /* bit 0: the first */
    uint16_t faults;     /* OPEN_STYLUS_… conditions that are present now */
    uint8_t heat;        /* of the hottest motor; 200 is its limit */
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
    uint16_t handle_mass;               /* 1/65536 kg, lifted by the host; 0: lifted by the board, or not known */
} open_stylus_limits;

/* Functions supplied by a board. Every function gets `context`. */
typedef struct open_stylus_port {
    void* context;
    uint32_t (*microseconds)(void* context); /* free running, wraps around */
    void (*measure)(void* context, open_stylus_reading* reading);
    /* Both vectors are already limited. 1/65536 N and 1/65536 N mm, device frame. */
    void (*drive)(void* context, const int32_t force[3], const int32_t torque[3]);
    void (*motors_off)(void* context);
    /* Passes a report to the transport; false if it has no room: the report is lost, which its number reveals. */
    bool (*send)(void* context, const uint8_t* report, size_t size);
} open_stylus_port;

typedef struct open_stylus {
    open_stylus_limits limits;
    open_stylus_port port;
    int32_t force[3], torque[3]; /* of the newest valid output report, limited */
    int32_t position[3];         /* in the previous step */
    uint32_t stepped;            /* us, time of the previous step */
    uint32_t heard;              /* us, time of the newest valid output report */
    uint16_t sequence;           /* number of the next input report */
    uint16_t echo;               /* number of the newest valid output report */
    uint16_t faults;             /* latched */
    bool has_position, has_heard, enabled, disarmed, motors_on, saturated;
} open_stylus;

extern const uint8_t open_stylus_descriptor[OPEN_STYLUS_DESCRIPTOR_SIZE];

/* Initialises, with the motors off. `limits` and `port` are copied. */
void open_stylus_start(open_stylus* stylus, const open_stylus_limits* limits, const open_stylus_port* port);

/* To be called once per period: watchdog, measurement, motors, one input report. */
void open_stylus_step(open_stylus* stylus);

/* To be called for each output report that arrives, including its id: the motors follow at once. Returns true if the
 * report was valid. */
bool open_stylus_receive(open_stylus* stylus, const uint8_t* report, size_t size);

/* Answers GET_REPORT (feature). Returns the size; 0 if there is no such report or no room. */
size_t open_stylus_feature(const open_stylus* stylus, uint8_t id, uint8_t* report, size_t room);

/* CRC-16/IBM-3740 ("CCITT-FALSE"); check value for "123456789": 0x29b1. */
uint16_t open_stylus_crc(const uint8_t* bytes, size_t size);

#ifdef __cplusplus
}
#endif

#endif
