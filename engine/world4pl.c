/* world4pl.c -- worlds as handles, the current one, transactions.
 *
 * Layer: glue. Doors in rules/store.pl.
 */
#include "edit4pl.h"

#include "install.h"

#include <SWI-Stream.h>

#include <pthread.h>
#include <string.h>

/* ---- handles ----------------------------------------------------------- */

static int
release_handle(atom_t atom)
{
  sg_world_drop(PL_blob_data(atom, NULL, NULL));
  return TRUE;
}

static int
compare_handles(atom_t a, atom_t b)
{
  uint64_t x = sg_world_number(PL_blob_data(a, NULL, NULL));
  uint64_t y = sg_world_number(PL_blob_data(b, NULL, NULL));

  return (x > y) - (x < y);
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  uint64_t number = sg_world_number(PL_blob_data(atom, NULL, NULL));

  (void)flags;
  Sfprintf(out, "<sg_world>(%llu)", (unsigned long long)number);
  return TRUE;
}

static void
acquire_handle(atom_t atom)
{
  sg_world_hold(PL_blob_data(atom, NULL, NULL));
}

static PL_blob_t world_blob = {
    .magic = PL_BLOB_MAGIC,
    .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
    .name = "sg_world",
    .release = release_handle,
    .compare = compare_handles,
    .write = write_handle,
    .acquire = acquire_handle,
};

static int
unify_world(term_t t, sg_world *world)
{
  return PL_unify_blob(t, world, sizeof(world), &world_blob);
}

static int
get_world_ex(term_t t, sg_world **out)
{
  void *data;
  PL_blob_t *type;

  if (PL_get_blob(t, &data, NULL, &type) && type == &world_blob) {
    *out = data;
    return TRUE;
  }
  return PL_is_variable(t) ? PL_instantiation_error(t)
                           : PL_type_error("sg_world", t);
}

/* ---- the current world of a thread ------------------------------------- */

static pthread_key_t current_key;

static void
drop_current(void *world)
{
  sg_world_drop(world);
}

/* Makes it this thread's world, or none (null); holds it itself. */
static void
set_current_world(sg_world *world)
{
  sg_world *old = pthread_getspecific(current_key);

  if (world) {
    sg_world_hold(world);
  }
  pthread_setspecific(current_key, world);
  sg_world_drop(old);
}

sg_world *
sg_current_world(void)
{
  return pthread_getspecific(current_key);
}

sg_world *
sg_edited_world_ex(void)
{
  sg_world *world = pthread_getspecific(current_key);
  term_t culprit;

  if (!world && (culprit = PL_new_term_ref()) &&
      PL_put_atom_chars(culprit, "current")) {
    PL_existence_error("sg_world", culprit);
  }
  return world;
}

/* new_world(-World) is det. */
static foreign_t
new_world(term_t t)
{
  sg_world *world = sg_world_open();
  int done;

  if (!world) {
    return PL_resource_error("memory");
  }
  done = unify_world(t, world);
  sg_world_drop(world); /* the handle holds it */
  return done;
}

/* current_world(-World) is det. */
static foreign_t
current_world(term_t t)
{
  sg_world *world = sg_edited_world_ex();

  return world && unify_world(t, world);
}

/* set_world(+World) is det. */
static foreign_t
set_world(term_t t)
{
  sg_world *world;

  if (!get_world_ex(t, &world)) {
    return FALSE;
  }
  set_current_world(world);
  return TRUE;
}

/* '$world'(-World) is det: none when there is none; for in_world/2. */
static foreign_t
saved_world(term_t t)
{
  sg_world *world = pthread_getspecific(current_key);

  return world ? unify_world(t, world) : PL_unify_atom_chars(t, "none");
}

/* '$set_world'(+World) is det: what '$world'/1 gave. */
static foreign_t
restore_world(term_t t)
{
  PL_blob_t *type;

  if (PL_is_blob(t, &type) && type == &world_blob) {
    return set_world(t);
  }
  set_current_world(NULL);
  return TRUE;
}

/* '$spend'(+World) is det: its rows are not asked for any more. */
static foreign_t
spend(term_t t)
{
  sg_world *world;

  if (!get_world_ex(t, &world)) {
    return FALSE;
  }
  sg_world_spend(world);
  return TRUE;
}

/* ---- waiting, and what went wrong -------------------------------------- */

static bool
ask_prolog(void *unused)
{
  (void)unused;
  return PL_handle_signals() < 0;
}

const sg_cancel sg_prolog_cancel = {.ask = ask_prolog};

int
sg_claim_ex(sg_world *world)
{
  return sg_world_claim(world, &sg_prolog_cancel);
}

static int
put_indicator(term_t t, sg_relation relation)
{
  const sg_relation_info *info = &sg_relation_table[relation];

  return PL_unify_term(t, PL_FUNCTOR_CHARS, "/", 2, PL_CHARS, info->name,
                       PL_INT, (int)info->arity);
}

static int
raise_dangling(const sg_fault *fault)
{
  const char *name = sg_relation_table[fault->to].name;
  term_t t = PL_new_term_ref();

  return t &&
         PL_unify_term(t, PL_FUNCTOR_CHARS, "-", 2, PL_INT, (int)fault->s,
                       PL_INT, (int)fault->id) &&
         PL_existence_error(name, t);
}

int
sg_raise_status(sg_status status, sg_relation relation, const sg_fault *fault)
{
  term_t t = PL_new_term_ref();

  if (status == SG_OK) {
    return TRUE;
  }
  if (status == SG_NO_MEMORY) {
    return PL_resource_error("memory");
  }
  if (status == SG_DANGLING) {
    return raise_dangling(fault);
  }
  if (!t || !put_indicator(t, relation)) {
    return FALSE;
  }
  if (status == SG_EXISTS) {
    return PL_permission_error("assert", "fact", t);
  }
  return PL_domain_error("fact", t);
}

int32_t
sg_fresh_ex(sg_world *world, sg_relation relation, int32_t s)
{
  int32_t id = sg_world_fresh(world, relation, s);

  if (id <= 0) {
    PL_resource_error(id == 0 ? "fresh_ids" : "memory");
    return 0;
  }
  return id;
}

/* ---- transactions ------------------------------------------------------ */

/* '$begin'(-World, -Depth) is det. */
static foreign_t
begin(term_t world_term, term_t depth)
{
  sg_world *world = sg_edited_world_ex();
  sg_status status;

  if (!world || !unify_world(world_term, world) || !sg_claim_ex(world)) {
    return FALSE;
  }
  status = sg_world_begin(world);
  sg_world_release(world); /* the transaction keeps the turn */
  return sg_raise_status(status, SG_NONE, NULL) &&
         PL_unify_uint64(depth, sg_world_depth(world));
}

static int
get_open_ex(term_t world_term, term_t depth, sg_world **world, size_t *out)
{
  return get_world_ex(world_term, world) && PL_get_size_ex(depth, out);
}

/* '$commit'(+World, +Depth, +Cascade) is det: the outermost transaction leaves
 * the world whole, and so does one that cascades. */
static foreign_t
commit(term_t world_term, term_t depth_term, term_t cascade_term)
{
  sg_world *world;
  size_t depth;
  int cascade;

  if (!get_open_ex(world_term, depth_term, &world, &depth) ||
      !PL_get_bool_ex(cascade_term, &cascade)) {
    return FALSE;
  }
  if (sg_world_depth(world) != depth) {
    return PL_permission_error("commit", "facts_transaction", world_term);
  }
  if ((depth == 1 || cascade) && !sg_make_whole_ex(world, cascade)) {
    return FALSE;
  }
  return sg_raise_status(sg_world_commit(world), SG_NONE, NULL);
}

/* '$end'(+World, +Depth) is det: rolls back what was not committed. */
static foreign_t
end(term_t world_term, term_t depth_term)
{
  sg_world *world;
  size_t depth;

  if (!get_open_ex(world_term, depth_term, &world, &depth)) {
    return FALSE;
  }
  while (sg_world_depth(world) >= depth) {
    sg_world_rollback(world);
  }
  return TRUE;
}

static int
step(sg_status (*go)(sg_world *), const char *name)
{
  sg_world *world = sg_edited_world_ex();
  sg_status status;
  term_t t = PL_new_term_ref();

  if (!world || !t || !sg_claim_ex(world)) {
    return FALSE;
  }
  if (sg_world_depth(world) > 0) {
    sg_world_release(world);
    return unify_world(t, world) &&
           PL_permission_error(name, "open_transaction", t);
  }
  status = go(world);
  sg_world_release(world);
  return status == SG_NO_STEP ? FALSE : sg_raise_status(status, SG_NONE, NULL);
}

/* facts_undo is semidet. */
static foreign_t
undo(void)
{
  return step(sg_world_undo, "undo");
}

/* facts_redo is semidet. */
static foreign_t
redo(void)
{
  return step(sg_world_redo, "redo");
}

/* facts_undo_limit(+Steps) is det. */
static foreign_t
undo_limit(term_t steps)
{
  sg_world *world = sg_edited_world_ex();
  size_t n;

  if (!world || !PL_get_size_ex(steps, &n) || !sg_claim_ex(world)) {
    return FALSE;
  }
  sg_world_undo_limit(world, n > 1000000 ? 1000000 : (unsigned)n);
  sg_world_release(world);
  return TRUE;
}

/* ---- stamps ------------------------------------------------------------ */

/* segment_stamp(+S, -Stamp) is det. */
static foreign_t
segment_stamp(term_t s, term_t t)
{
  sg_world *world = sg_edited_world_ex();
  int n;

  if (!world || !PL_get_integer_ex(s, &n)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  uint64_t stamp = sg_segment_stamp(version, n);

  sg_version_drop(version);
  return PL_unify_uint64(t, stamp);
}

/* Each of a list, into `out`. */
static int
unify_stamps_ex(const sg_version *version, term_t list, term_t out)
{
  functor_t pair = PL_new_functor(PL_new_atom("-"), 2);
  term_t rest = PL_copy_term_ref(list), tail = PL_copy_term_ref(out),
         s = PL_new_term_ref(), head = PL_new_term_ref();
  int n;

  while (PL_get_list_ex(rest, s, rest)) {
    if (!PL_get_integer_ex(s, &n) || !PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, pair, PL_INT, n, PL_INT64,
                       (int64_t)sg_segment_stamp(version, n))) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(rest) && PL_unify_nil(tail);
}

/* segment_stamps(+Ss, -Stamps) is det. */
static foreign_t
segment_stamps(term_t list, term_t out)
{
  sg_world *world = sg_edited_world_ex();

  if (!world) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int good = unify_stamps_ex(version, list, out);

  sg_version_drop(version);
  return good;
}

/* Bytes of a key: of each segment its number and its stamp. */
typedef struct key_part {
  uint64_t stamp;
  int64_t s;
} key_part;

static int
get_key_ex(const sg_version *version, term_t list, size_t n, key_part *out)
{
  term_t rest = PL_copy_term_ref(list), head = PL_new_term_ref();
  int s;

  for (size_t i = 0; i < n; i++) {
    if (!PL_get_list_ex(rest, head, rest) || !PL_get_integer_ex(head, &s)) {
      return FALSE;
    }
    out[i] = (key_part){sg_segment_stamp(version, s), s};
  }
  return TRUE;
}

/* segments_key(+Ss, -Key) is det. */
static foreign_t
segments_key(term_t list, term_t key)
{
  sg_world *world = sg_edited_world_ex();
  size_t n;

  if (!world) {
    return FALSE;
  }
  if (PL_skip_list(list, 0, &n) != PL_LIST) {
    return PL_type_error("list", list);
  }
  key_part *part = malloc((n + 1) * sizeof *part);

  if (!part) {
    return PL_resource_error("memory");
  }
  const sg_version *version = sg_world_version(world);
  int good = get_key_ex(version, list, n, part) &&
             PL_unify_string_nchars(key, n * sizeof *part, (const char *)part);

  sg_version_drop(version);
  free(part);
  return good;
}

/* ---- installing -------------------------------------------------------- */

static const PL_extension predicates[] = {
    {"new_world", 1, new_world, 0},
    {"segments_key", 2, segments_key, 0},
    {"current_world", 1, current_world, 0},
    {"set_world", 1, set_world, 0},
    {"$world", 1, saved_world, 0},
    {"$set_world", 1, restore_world, 0},
    {"$spend", 1, spend, 0},
    {"$begin", 2, begin, 0},
    {"$commit", 3, commit, 0},
    {"$end", 2, end, 0},
    {"facts_undo", 0, undo, 0},
    {"facts_redo", 0, redo, 0},
    {"facts_undo_limit", 1, undo_limit, 0},
    {"segment_stamp", 2, segment_stamp, 0},
    {"segment_stamps", 2, segment_stamps, 0},
    {NULL, 0, NULL, 0},
};

/* The thread that loads the library gets a world. */
void
sg_install_world(void)
{
  static bool installed;

  if (!installed) {
    sg_world *world = sg_world_open();
    installed = true;
    pthread_key_create(&current_key, drop_current);
    if (world) {
      set_current_world(world);
      sg_world_drop(world);
    }
  }
  PL_register_extensions_in_module("sg_store", predicates);
}
