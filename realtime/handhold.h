/* SPDX-License-Identifier: Apache-2.0 */
#ifndef HANDHOLD_H
#define HANDHOLD_H

/* handhold from C, in two forms:
 *
 * - a world (hh_world_*): poses of the phalanges in, once a frame; poses of the objects, contacts, events and energy
 *   out. It moves the objects by itself, with the implicit element of docs/contact-law.md.
 * - a middleware in front of any rigid-body engine (hh_contact_*; Höll et al. 2018, section 3.5): poses of the
 *   phalanges, pose and velocity of one object in; force and torque on the object out. Gravity, collisions between
 *   objects and the motion itself stay the engine's.
 *
 * How to link: docs/library.md.
 *
 * SI units and radians. W is the world, O the object's frame, P a phalanx: origin at its centroid, z towards the
 * fingertip, y dorsal. Quaternions are (w, x, y, z), unit to within 1e-3. Matrices are row by row.
 *
 * Functions that can fail give a code (HH_OK is 0) and, if `error` is not null, a sentence. Nothing aborts, nothing
 * prints. One world or contact serves one thread at a time; a field any number. A step allocates nothing.
 */

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HH_PHALANGES 16 /* 3 * finger + bone, thumb 0 to little 4, nearest to the palm first; 15: palm */
#define HH_ERROR_LENGTH 256

enum { HH_OK = 0, HH_WRONG_INPUT = 2, HH_NO_MEMORY = 3, HH_BUG = 4 };

typedef struct hh_error {
  int code;
  char message[HH_ERROR_LENGTH]; /* "<what was given>: <the rule> (<what to do>)" */
} hh_error;

/* "0.1.0": major, minor, patch. Before 1.0 a new minor may change this interface. */
const char* hh_version(void);

/* --- Shape -------------------------------------------------------------------------------------------------------- */

/* A solid as voxels: the members of handhold::VoxelField::Data, one by one. They are copied.
 *
 * `handhold voxelize MESH --out X.hhvox` makes a file of them. All that a program sets to 0 before may stay 0. */
typedef struct hh_field_data {
  const double* vertices; /* x y z each [m], in O */
  int vertex_count;
  const int* triangles; /* 3 vertices each, counter-clockwise seen from outside */
  int triangle_count;
  double grid_origin[3]; /* node (0, 0, 0) [m] */
  double grid_spacing;   /* [m] */
  int grid_size[3];      /* nodes along x, y, z; x runs fastest in the arrays of nodes */
  double band; /* distances are exact up to here, and +-band beyond; the grid reaches that far beyond the solid [m] */
  const float* distances;        /* one a node, < 0 inside [m] */
  const unsigned char* occupied; /* one a node: 1 if it lies inside */
  double cell_size;              /* triangles by cubic cells, for queries; one cell that holds all of them is allowed */
  double cell_origin[3];
  int cell_count[3];
  const unsigned* cell_start; /* cells + 1: cell c holds cell_triangles[cell_start[c]] up to cell_start[c + 1] */
  const unsigned* cell_triangles;
  unsigned cell_triangle_count;
  const double* samples; /* x y z each [m], in O: points of the surface that touch other bodies; null: none */
  int sample_count;      /* at most 255 */
} hh_field_data;

typedef struct hh_field hh_field;

int hh_field_create(const hh_field_data* data, hh_field** field, hh_error* error);

/* Of a .hhvox file (docs/hhvox.md), or of its bytes. Files of strangers are safe. */
int hh_field_load(const char* path, hh_field** field, hh_error* error);
int hh_field_from_bytes(const void* bytes, size_t size, hh_field** field, hh_error* error);

/* Centre of mass, in O [m], and inertia about it [kg m^2], of the solid filled evenly with `mass` [kg]. */
int hh_field_solid(const hh_field* field, double mass, double center_of_mass[3], double inertia[9], hh_error* error);

void hh_field_destroy(hh_field* field); /* worlds and contacts made with it keep what they need; null is allowed */

/* --- Hands and bodies --------------------------------------------------------------------------------------------- */

typedef struct hh_hand {
  double half_length[15]; /* of the capsules' segments [m] */
  double radius[15];      /* [m] */
  double palm[3];         /* half extents of the palm's box [m] */
} hh_hand;

/* The mean adult hand, all lengths times `scale`. */
void hh_hand_mean(double scale, hh_hand* hand);

typedef struct hh_pose {
  double q[4];
  double p[3];
} hh_pose;

typedef struct hh_hand_frame {
  int present;                   /* 0: lost; its contacts go */
  hh_pose phalanx[HH_PHALANGES]; /* in W; one that is not finite makes the hand absent */
} hh_hand_frame;

typedef struct hh_body {
  hh_pose pose;               /* of O in W */
  double velocity[3];         /* of the centre of mass, in W [m/s] */
  double angular_velocity[3]; /* in W [rad/s] */
} hh_body;

enum { HH_APART = 0, HH_STICK = 1, HH_SLIP = 2 }; /* mode of a sample */

/* --- World -------------------------------------------------------------------------------------------------------- */

enum { HH_FREE = 0, HH_TRANSLATION = 1, HH_FIXED = 2 }; /* mobility */

/* Begin with hh_body_def_default(): at rest in the origin, mu 0.5 and 0.4. Field, mass and inertia are yours to set. */
typedef struct hh_body_def {
  int cookie; /* not yours */
  const hh_field* field;
  double mass;              /* [kg], 1e-6 to 1e4; of a fixed body not used */
  double center_of_mass[3]; /* in O [m] */
  double inertia[9];        /* about the centre of mass, axes of O [kg m^2]; used of a free body */
  int mobility;
  double mu_static, mu_dynamic; /* against skin; two bodies have the geometric means of theirs */
  hh_body start;                /* at t = 0 */
  double held_until;            /* a support carries the body until then [s] */
  int touches_bodies;           /* 1: with its field's samples; 0: other bodies may touch it with theirs */
} hh_body_def;

/* Begin with hh_world_def_default(): gravity along -z, no body, no hand. */
typedef struct hh_world_def {
  int cookie;                          /* not yours */
  double gravity[3];                   /* [m/s^2] */
  double stiffness, damping;           /* of a hand's sample [N/m], [N s/m] */
  double body_stiffness, body_damping; /* of a body's sample on another body */
  int samples;                         /* of a phalanx on a body, on a ring, 1 to 32 */
  double finger_radius;                /* of that ring [m] */
  double thumb_radius;
  double palm_radius;
  double contact_offset; /* a phalanx nearer than this gets its samples [m] */
  int substeps;          /* a frame, 1 to 1000 */
  int order;             /* 1: implicit Euler; 2: implicit midpoint where nothing jumps */
  double longest_bridge; /* a hand that is back after no longer than this came straight [s] */
  double longest_turn;   /* of a body in a sub-step; what turns faster is stepped finer [rad] */
  const hh_body_def* bodies;
  int body_count; /* 1 to 255 */
  const hh_hand* hands;
  int hand_count; /* 0 to 254 */
} hh_world_def;

hh_body_def hh_body_def_default(void);
hh_world_def hh_world_def_default(void);

typedef struct hh_world hh_world;

/* Copies all it needs: the definition and its fields may go. */
int hh_world_create(const hh_world_def* def, hh_world** world, hh_error* error);
void hh_world_destroy(hh_world* world); /* null is allowed */

/* One frame of `dt` seconds, at whose end the hands are at `hands`, one frame a hand. The first call only places the
 * hands at t = 0. After HH_NO_MEMORY or HH_BUG the world can only be destroyed; after HH_WRONG_INPUT nothing changed.
 */
int hh_world_step(hh_world* world, double dt, const hh_hand_frame* hands, hh_error* error);

double hh_world_time(const hh_world* world); /* [s] */

int hh_world_body(const hh_world* world, int body, hh_body* state, hh_error* error);

/* Names a sample: of a phalanx of a hand, or of another body (then hand and phalanx are -1, otherwise `of_body` is). */
typedef struct hh_sample_id {
  int hand, phalanx, of_body;
  int body;   /* that it touches */
  int number; /* from 0 */
} hh_sample_id;

/* A sample in contact, as the last step ended. */
typedef struct hh_touch {
  hh_sample_id id;
  int mode;         /* HH_STICK or HH_SLIP */
  double depth;     /* [m] */
  double point[3];  /* of the phalanx or the other body, in W [m] */
  double anchor[3]; /* on the surface of the body, in W [m] */
  double normal[3]; /* outward there, in W */
  double force[3];  /* on the body, in W [N] */
} hh_touch;

/* Write at most `capacity`; give how many there are, or -1 without a world. Events are those of the last step. */
int hh_world_touches(const hh_world* world, hh_touch* touches, int capacity);

enum { HH_TOUCH = 0, HH_BREAKAWAY = 1, HH_RESTICK = 2, HH_RELEASE = 3 }; /* kind */

typedef struct hh_event {
  double t;      /* the change of mode was in [t - window, t] [s] */
  double window; /* [s] */
  int kind;
  hh_sample_id id;
} hh_event;

int hh_world_events(const hh_world* world, hh_event* events, int capacity);

/* kinetic + potential + elastic + dissipated - hand_work is what it was at t = 0 [J]. */
typedef struct hh_energy {
  double kinetic, potential, elastic;
  double dissipated; /* by friction and damping since t = 0 */
  double hand_work;  /* of hands and supports since t = 0 */
} hh_energy;

int hh_world_energy(const hh_world* world, hh_energy* energy, hh_error* error);

long hh_world_unconverged(const hh_world* world); /* solves that missed their tolerance, ever; -1 without a world */

/* --- Middleware: options ------------------------------------------------------------------------------------------ */

/* Two laws: the paper's (its print corrected, or to the letter), and Coulomb's element in explicit form, once a frame.
 */
enum { HH_PAPER = 0, HH_PAPER_AS_PRINTED = 1, HH_COULOMB = 2 };                /* law */
enum { HH_SIGN_AS_PRINTED = 0, HH_SIGN_ONTO_OBJECT = 1 };                      /* sign */
enum { HH_POINT_CENTROID = 0, HH_POINT_PER_SAMPLE = 1 };                       /* point */
enum { HH_GATE_NONE = 0, HH_GATE_PUSHING = 1 };                                /* gate */
enum { HH_SLIP_SCALED = 0, HH_SLIP_CAPPED = 1 };                               /* slip_force */
enum { HH_FORCE_FIRST = 0, HH_ANCHOR_FIRST = 1 };                              /* order */
enum { HH_MEMORYLESS = 0, HH_STATEFUL = 1 };                                   /* slip_state */
enum { HH_ANCHOR_RAY = 0, HH_ANCHOR_CONE = 1 };                                /* anchor_update */
enum { HH_APART_STAYS = 0, HH_APART_FOLLOWS = 1 };                             /* apart_anchor */
enum { HH_NORMALS_TRIANGLE = 0, HH_NORMALS_SMOOTH = 1, HH_NORMALS_VOXEL = 2 }; /* normals */

/* Explained one by one in cases/model/printed_law.hpp and docs/paper.md. */
typedef struct hh_options {
  double stiffness;      /* gamma of a sample [N/m], > 0 */
  double damping;        /* of a sample [N s/m], >= 0 */
  double ray_offset;     /* epsilon [m], > 0 */
  double turned_away;    /* cosine at or below which a surface counts as occluded */
  double contact_offset; /* a phalanx nearer than this gets a patch [m] */
  int sign, point, gate, slip_force, order, slip_state, anchor_update, apart_anchor, normals;
  int samples;          /* of a patch, 1 to 32 */
  double finger_radius; /* of a patch's ring [m] */
  double thumb_radius;
  double palm_radius;
} hh_options;

int hh_options_init(int law, hh_options* options, hh_error* error);

/* gamma so that `samples` samples at `depth` carry `margin` times the object's weight; volume 0: not known. */
int hh_auto_stiffness(double mass, double volume, double mu_static, int samples, double depth, double margin,
                      double* stiffness, hh_error* error);

/* --- Middleware: contact ------------------------------------------------------------------------------------------ */

typedef struct hh_object {
  double center_of_mass[3]; /* in O [m] */
  double mu_static, mu_dynamic;
} hh_object;

typedef struct hh_wrench {
  double force[3];  /* in W [N] */
  double torque[3]; /* about the centre of mass, in W [N m] */
} hh_wrench;

typedef struct hh_sample {
  int hand, phalanx, number, mode;
  double anchor[3]; /* on the object, in O [m] */
  double normal[3]; /* outward there, in O */
  double force[3];  /* on the object, in W [N] */
} hh_sample;

typedef struct hh_contact hh_contact;

int hh_contact_create(const hh_field* field, const hh_object* object, const hh_hand* hands, int hand_count,
                      const hh_options* options, hh_contact** contact, hh_error* error);
void hh_contact_destroy(hh_contact* contact); /* null is allowed */

/* Other options from the next step on; contacts start anew. On an error nothing changes. */
int hh_contact_set_options(hh_contact* contact, const hh_options* options, hh_error* error);

/* One frame of `dt` seconds: contacts are found, forces computed, anchors moved. `hands` has one frame a hand. */
int hh_contact_step(hh_contact* contact, double dt, const hh_hand_frame* hands, const hh_body* body, hh_wrench* wrench,
                    hh_error* error);

/* The wrench if the body were there now; no anchor moves: for engines with sub-steps. */
int hh_contact_wrench_at(const hh_contact* contact, const hh_body* body, hh_wrench* wrench, hh_error* error);

/* 6 x 6 derivatives of (force, torque) there: by displacement and small rotation about the centre of mass, and by
 * velocity and angular velocity. For implicit engines. */
int hh_contact_slopes(const hh_contact* contact, const hh_body* body, double by_pose[36], double by_velocity[36],
                      hh_error* error);

/* Writes at most `capacity` samples; gives how many there are, or -1 without a contact. */
int hh_contact_samples(const hh_contact* contact, hh_sample* samples, int capacity);

#ifdef __cplusplus
}
#endif

#endif
