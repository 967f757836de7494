// Steps a world on many processes, with the bits of one: `mpirun -np 4 shares_mpi start 10000 end`.
// Both are directories of shares, of which each process reads and writes its own:
// `halfspace split start.hsw 4 start`, `halfspace join end end.hsw`.
// Zoltan divides the blocks, MPI carries records and loads. See docs/concepts/shares.md.

#include <halfspace/halfspace.h>

#include <cstdlib>

#include "division.h"
#include "files.h"
#include "messages.h"

namespace {

using Keys = std::vector<std::int64_t>;

/// Before the bytes of a block, in a message.
struct Header {
  std::int64_t key;
  std::int32_t role;
  std::int32_t owner;
  std::uint64_t size;  // of its record; 0: the receiver has the block
};

/// The share of this rank. All ranks make the same calls.
class Share {
 public:
  explicit Share(const std::string &start) : copies_here_(rank_count()), copies_there_(rank_count()) {
    if (hs_context_create(nullptr, &context_) != HS_OK) fail("no memory");
    std::vector<hs_world *> sources;
    for (const std::string &name : files_of_rank(start)) sources.push_back(restored(read(name)));
    take_settings(sources);
    assemble(sources);
    for (hs_world *source : sources) hs_world_destroy(source);
    require_all();
    check(hs_world_begin(world_));
    carry_loads();
    check(hs_world_end_begin(world_));
  }
  ~Share() {
    hs_world_destroy(world_);
    hs_context_destroy(context_);
  }
  Share(const Share &) = delete;
  Share &operator=(const Share &) = delete;

  void step() {
    hs_share_plan plan = planned();
    if (plan.needs_list || plan.needs_assembly) {
      assemble({world_});
      const bool needed_list = plan.needs_list;
      plan = planned();
      if (needed_list || plan.needs_list) {
        check(hs_world_renew_list(world_, &plan));
        plan = combined(plan);
      }
    }
    if (plan.refusal != HS_OK) fail(hs_status_string(hs_status(plan.refusal)));
    check(hs_world_move(world_));
    carry_loads();
    check(hs_world_end_step(world_));
  }

  /// A snapshot of this share.
  Bytes saved() const { return saved(world_); }

 private:
  void check(hs_status status) const {
    if (status != HS_OK) fail(hs_context_last_error(context_));
  }

  hs_world *restored(const Bytes &snapshot) const {
    hs_world *world = nullptr;
    check(hs_world_restore(context_, snapshot.data(), snapshot.size(), &world));
    return world;
  }
  Bytes saved(const hs_world *world) const {
    std::size_t size = 0;
    if (hs_world_save(world, nullptr, 0, &size) < 0) fail(hs_context_last_error(context_));
    Bytes bytes(size);
    check(hs_world_save(world, bytes.data(), size, &size));
    return bytes;
  }
  hs_share_info info_of(hs_world *world) const {
    hs_share_info info;
    check(hs_world_get_share_info(world, &info, sizeof info));
    return info;
  }

  /// Begins with a share of what is everywhere, alike on all ranks, and with the losses of the sources here.
  void take_settings(const std::vector<hs_world *> &sources) {
    Bytes settings;
    if (rank() == 0) {
      world_ = sources.front();
      hs_world *const empty = assembled({});
      settings = saved(empty);
      hs_world_destroy(empty);
    }
    broadcast(settings);
    world_ = restored(settings);
    double own[HS_SUM_COUNT], sums[HS_SUM_COUNT] = {};
    for (const hs_world *source : sources) {
      check(hs_world_get_sums(source, own));
      for (int i = 0; i < HS_SUM_COUNT; ++i) sums[i] += own[i];
    }
    check(hs_world_set_sums(world_, sums));
  }

  /// Are all blocks of the world here?
  void require_all() const {
    const hs_share_info info = info_of(world_);
    std::int64_t own = info.own_count;
    MPI_Allreduce(MPI_IN_PLACE, &own, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    if (own + info.everywhere_count != info.whole_count)
      fail("the shares hold " + std::to_string(own + info.everywhere_count) + " of " +
           std::to_string(info.whole_count) + " blocks");
  }

  static hs_share_plan combined(const hs_share_plan &own) {
    const std::int32_t ours[] = {own.needs_list, own.needs_assembly, -own.refusal};
    std::int32_t all[3];
    MPI_Allreduce(ours, all, 3, MPI_INT32_T, MPI_MAX, MPI_COMM_WORLD);
    return {all[0], all[1], -all[2], 0};
  }
  hs_share_plan planned() {
    hs_share_plan own;
    check(hs_world_plan_motion(world_, &own));
    return combined(own);
  }

  /// A value per block, in the order of hs_world_get_blocks().
  template <class T>
  std::vector<T> all(const hs_world *world,
                     hs_status (*get)(const hs_world *, T[], std::int64_t, std::int64_t *)) const {
    std::int64_t count = 0;
    (void)get(world, nullptr, 0, &count);
    std::vector<T> values(static_cast<std::size_t>(count));
    check(get(world, values.data(), count, &count));
    return values;
  }
  /// Adds own blocks of a world.
  void add_places(hs_world *source, std::vector<Place> &places) const {
    const Keys keys = all(source, hs_world_get_keys);
    const std::vector<std::int32_t> roles = all(source, hs_world_get_roles);
    const std::vector<hs_pose> poses = all(source, hs_world_get_poses);
    for (std::size_t i = 0; i < roles.size(); ++i) {
      const double *const x = poses[i].position;
      if (roles[i] == HS_ROLE_OWN) places.push_back({keys[i], {x[0], x[1], x[2]}, source});
    }
  }

  /// Adds a block to a message.
  void append(Bytes &message, hs_world *source, std::int64_t key, std::int32_t role, int owner,
              bool with_record, bool with_shape) {
    std::size_t size = 0;
    if (with_record) {
      hs_status status =
          hs_world_pack(source, &key, 1, with_shape, record_.data(), record_.size(), nullptr, &size);
      if (status == HS_NOTE_TRUNCATED) {
        record_.resize(size);
        status = hs_world_pack(source, &key, 1, with_shape, record_.data(), size, nullptr, &size);
      }
      check(status);
    }
    const Header header{key, role, owner, size};
    const char *const bytes = reinterpret_cast<const char *>(&header);
    message.insert(message.end(), bytes, bytes + sizeof header);
    message.insert(message.end(), record_.begin(), record_.begin() + std::ptrdiff_t(size));
  }

  /// A world of the blocks in the messages, and of what is everywhere.
  hs_world *assembled(const std::vector<Bytes> &messages) {
    std::vector<hs_packed> blocks;
    const Keys keys = all(world_, hs_world_get_keys);
    const std::vector<std::int32_t> roles = all(world_, hs_world_get_roles);
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (roles[i] == HS_ROLE_EVERYWHERE) blocks.push_back({keys[i], nullptr, 0, HS_ROLE_EVERYWHERE, 0});
    for (Keys &copies : copies_here_) copies.clear();
    for (const Bytes &message : messages) {
      for (std::size_t at = 0; at < message.size();) {
        Header header;
        std::memcpy(&header, message.data() + at, sizeof header);
        at += sizeof header;
        blocks.push_back(
            {header.key, header.size > 0 ? message.data() + at : nullptr, header.size, header.role, 0});
        at += header.size;
        if (header.role == HS_ROLE_NEIGHBOR) copies_here_[std::size_t(header.owner)].push_back(header.key);
      }
    }
    std::sort(blocks.begin(), blocks.end(),
              [](const hs_packed &a, const hs_packed &b) { return a.key < b.key; });
    hs_world *made = nullptr;
    check(hs_world_assemble(context_, world_, blocks.data(), std::int64_t(blocks.size()), &made));
    return made;
  }

  /// Divides the own blocks of these worlds anew.
  void assemble(const std::vector<hs_world *> &sources) {
    double halo = 0;
    std::vector<Place> places;
    for (hs_world *source : sources) {
      halo = std::max(halo, info_of(source).halo);
      add_places(source, places);
    }
    MPI_Allreduce(MPI_IN_PLACE, &halo, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    const std::vector<int> owners = division_.divide(places);
    std::vector<Bytes> sent(rank_count());
    const auto send = [&](int to, const Place &place, std::int32_t role, int owner) {
      const Keys &known = copies_there_[std::size_t(to)];
      const bool has_shape = std::binary_search(known.begin(), known.end(), place.key);
      const bool is_here = to == rank() && place.source == world_;
      append(sent[std::size_t(to)], place.source, place.key, role, owner, !is_here, !has_shape);
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
      send(owners[i], places[i], HS_ROLE_OWN, owners[i]);
      for (const int near : division_.ranks_near(places[i], halo))
        if (near != owners[i]) send(near, places[i], HS_ROLE_NEIGHBOR, owners[i]);
    }
    hs_world *const next = assembled(exchanged(sent));
    hs_world_destroy(world_);
    world_ = next;
    load_length_ = std::size_t(info_of(world_).load_length);
    copies_there_ = exchanged(copies_here_);
  }

  /// Carries the loads of own blocks to the ranks that have copies of them.
  void carry_loads() {
    std::vector<std::vector<double>> sent(rank_count()), received(rank_count());
    for (std::size_t r = 0; r < sent.size(); ++r) {
      sent[r].resize(copies_there_[r].size() * load_length_);
      received[r].resize(copies_here_[r].size() * load_length_);
      check(hs_world_get_loads(world_, copies_there_[r].data(), std::int64_t(copies_there_[r].size()),
                               sent[r].data()));
    }
    exchange(sent, received);
    for (std::size_t r = 0; r < sent.size(); ++r)
      check(hs_world_set_loads(world_, copies_here_[r].data(), std::int64_t(copies_here_[r].size()),
                               received[r].data()));
  }

  hs_context *context_ = nullptr;
  hs_world *world_ = nullptr;
  Division division_;
  std::vector<Keys> copies_here_;   // per rank that owns them
  std::vector<Keys> copies_there_;  // per rank that has them: own blocks
  std::size_t load_length_ = 0;
  Bytes record_;
};

void run(const std::string &from, std::int64_t steps, const std::string &to) {
  make_directory(to);
  Share share(from);
  for (std::int64_t i = 0; i < steps; ++i) share.step();
  write(share_name(to, rank()), share.saved());
}

}  // namespace

int main(int argc, char **argv) {
  float version = 0;
  MPI_Init(&argc, &argv);
  Zoltan_Initialize(argc, argv, &version);
  if (argc != 4) fail("call it as shares_mpi START STEPS END; START and END are directories of shares");
  run(argv[1], std::atoll(argv[2]), argv[3]);
  MPI_Finalize();
}
