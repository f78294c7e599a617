#ifndef HANDHOLD_H
#define HANDHOLD_H

/* handhold from C: hand-object contact as a middleware in front of any rigid-body engine (Höll et al. 2018,
 * section 3.5).
 *
 * Once a frame: poses of the phalanges, pose and velocity of the object in; force and torque on the object out.
 * Gravity, collisions between objects and the motion itself stay the engine's. Link with the library realtime (Eigen
 * only).
 *
 * SI units and radians. W is the world, O the object's frame, P a phalanx: origin at its centroid, z towards the
 * fingertip, y dorsal. Quaternions are (w, x, y, z), unit to within 1e-3. Matrices are row by row.
 *
 * Functions that can fail give a code (HH_OK is 0) and, if `error` is not null, a sentence. Nothing aborts, nothing
 * prints. One contact serves one thread at a time; a field any number. A step allocates nothing.
 *
 * Two laws: the paper's (its print corrected, or to the letter), and Coulomb's element in explicit form, once a frame.
 * The implicit element that moves bodies by itself (handhold::realtime::World) has no C interface yet.
 */

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

/* "0.1.0" */
const char* hh_version(void);

/* --- Shape -------------------------------------------------------------------------------------------------------- */

/* A solid as voxels: the members of handhold::VoxelField::Data, one by one. They are copied.
 *
 * Making one from a mesh needs the library cases (CGAL, GPL): voxelize(mesh)->data() in C++. No file of it is written
 * yet: store these arrays as your program stores its assets. */
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
} hh_field_data;

typedef struct hh_field hh_field;

int hh_field_create(const hh_field_data* data, hh_field** field, hh_error* error);
void hh_field_destroy(hh_field* field); /* contacts made with it keep what they need; null is allowed */

/* --- Options ------------------------------------------------------------------------------------------------------ */

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

/* Explained one by one in realtime/paper/options.hpp and docs/paper.md. */
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

/* --- Contact ------------------------------------------------------------------------------------------------------ */

typedef struct hh_hand {
  double half_length[15]; /* of the capsules' segments [m] */
  double radius[15];      /* [m] */
  double palm[3];         /* half extents of the palm's box [m] */
} hh_hand;

/* The mean adult hand, all lengths times `scale`. */
void hh_hand_mean(double scale, hh_hand* hand);

typedef struct hh_object {
  double center_of_mass[3]; /* in O [m] */
  double mu_static, mu_dynamic;
} hh_object;

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

typedef struct hh_wrench {
  double force[3];  /* in W [N] */
  double torque[3]; /* about the centre of mass, in W [N m] */
} hh_wrench;

enum { HH_APART = 0, HH_STICK = 1, HH_SLIP = 2 };

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
