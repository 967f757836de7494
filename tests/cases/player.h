/* Carries out the statements of case files. C99 that is C++ as well. */
#ifndef HALFSPACE_CASE_PLAYER_H
#define HALFSPACE_CASE_PLAYER_H

#include <halfspace/halfspace.h>

#include "case_file.h"

enum { MOST_NAMES = 32 };

typedef struct NamedShape {
  char name[32];
  hs_shape* shape;
  hs_pose pose;
  hs_motion_def motion; /* but for its start, which is the pose */
} NamedShape;

typedef struct NamedBlock {
  char name[32];
  hs_block block;
} NamedBlock;

/* All that a case has made so far. */
typedef struct Player {
  hs_context* context;
  NamedShape shapes[MOST_NAMES];
  int shape_count;
  int32_t face_sizes[MOST_WORDS], face_vertices[MOST_WORDS];
  int face_count;
  hs_pair_options options;
  hs_world* world;
  NamedBlock blocks[MOST_NAMES];
  int block_count;
  hs_contact contact;
  hs_impact impact;
} Player;

/* Forgets the case before. */
void begin_case(Player* player);

/* Carries out a statement that is a call. */
hs_status call(Player* player, const Statement* statement);

/* Looks at what an `expect` statement is about; returns 0 and prints what differs. */
int meets_expectation(Player* player, const Statement* statement);

NamedShape* shape_named(Player* player, const Statement* statement, int word);
NamedBlock* block_named(Player* player, const Statement* statement, int word);

#endif
