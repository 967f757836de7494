// The blocks of a world divided among processes, by recursive bisection of Zoltan.
#pragma once

#include <halfspace/world.h>
#include <zoltan.h>

#include <algorithm>
#include <cstring>

#include "messages.h"

/// A block that the coming division may give to another rank.
struct Place {
  std::int64_t key;
  double position[3];
  hs_world *source;  // which has the block as its own
};

/// Recursive bisection by Zoltan: which rank owns a block, and which ranks own blocks near it.
class Division {
 public:
  Division() : zoltan_(Zoltan_Create(MPI_COMM_WORLD)) {
    const char *const parameters[][2] = {{"DEBUG_LEVEL", "0"},     {"LB_METHOD", "RCB"},
                                         {"KEEP_CUTS", "1"},       {"NUM_GID_ENTRIES", "2"},
                                         {"NUM_LID_ENTRIES", "1"}, {"RETURN_LISTS", "PARTS"}};
    for (const auto &[name, value] : parameters) Zoltan_Set_Param(zoltan_, name, value);
    Zoltan_Set_Num_Obj_Fn(zoltan_, count, this);
    Zoltan_Set_Obj_List_Fn(zoltan_, list, this);
    Zoltan_Set_Num_Geom_Fn(zoltan_, dimension, this);
    Zoltan_Set_Geom_Multi_Fn(zoltan_, positions, this);
  }
  ~Division() { Zoltan_Destroy(&zoltan_); }
  Division(const Division &) = delete;
  Division &operator=(const Division &) = delete;

  /// The new owner of each place of this rank. Call on all ranks.
  std::vector<int> divide(const std::vector<Place> &places) {
    places_ = &places;
    int changed = 0, gid_length = 0, lid_length = 0, imported = 0, exported = 0;
    ZOLTAN_ID_PTR import_gids = nullptr, import_lids = nullptr, export_gids = nullptr, lids = nullptr;
    int *import_ranks = nullptr, *import_parts = nullptr, *export_ranks = nullptr, *parts = nullptr;
    if (Zoltan_LB_Partition(zoltan_, &changed, &gid_length, &lid_length, &imported, &import_gids,
                            &import_lids, &import_ranks, &import_parts, &exported, &export_gids, &lids,
                            &export_ranks, &parts) != ZOLTAN_OK)
      fail("Zoltan cannot divide the blocks");
    std::vector<int> owners(places.size());
    for (int i = 0; i < exported; ++i) owners[lids[i]] = parts[i];
    Zoltan_LB_Free_Part(&import_gids, &import_lids, &import_ranks, &import_parts);
    Zoltan_LB_Free_Part(&export_gids, &lids, &export_ranks, &parts);
    return owners;
  }

  /// The ranks that may own a block nearer than so much.
  std::vector<int> ranks_near(const Place &place, double distance) const {
    const double *x = place.position;
    std::vector<int> ranks(rank_count());
    int count = 0;
    if (ranks.size() > 1 &&
        Zoltan_LB_Box_Assign(zoltan_, x[0] - distance, x[1] - distance, x[2] - distance, x[0] + distance,
                             x[1] + distance, x[2] + distance, ranks.data(), &count) != ZOLTAN_OK)
      fail("Zoltan cannot find the ranks near a block");
    ranks.resize(std::size_t(count));
    return ranks;
  }

 private:
  static const std::vector<Place> &places_of(void *self) { return *static_cast<Division *>(self)->places_; }
  static int count(void *self, int *error) { return *error = ZOLTAN_OK, int(places_of(self).size()); }
  static int dimension(void *, int *error) { return *error = ZOLTAN_OK, 3; }
  static void list(void *self, int, int, ZOLTAN_ID_PTR keys, ZOLTAN_ID_PTR indices, int, float *,
                   int *error) {
    const std::vector<Place> &places = places_of(self);
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::memcpy(keys + 2 * i, &places[i].key, sizeof places[i].key);
      indices[i] = ZOLTAN_ID_TYPE(i);
    }
    *error = ZOLTAN_OK;
  }
  static void positions(void *self, int, int, int count, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR indices, int,
                        double *positions, int *error) {
    for (int i = 0; i < count; ++i) std::copy_n(places_of(self)[indices[i]].position, 3, positions + 3 * i);
    *error = ZOLTAN_OK;
  }

  Zoltan_Struct *zoltan_;
  const std::vector<Place> *places_ = nullptr;
};
