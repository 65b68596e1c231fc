/* failing_malloc.c -- an allocator that fails, and a question that is answered
 * with stop, where a test says so.
 *
 * Loaded before all others (LD_PRELOAD), it passes every request on, counts
 * those that one shared object makes itself and remembers what of theirs is
 * still held. Requests of Prolog and of GMP do not count: they are not ours to
 * survive. Prolog loads the same file for the predicates below. In a program
 * that is ours FAILING_REQUEST=N fails all requests of its own from the N-th
 * on.
 */
#include <SWI-Prolog.h>
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <link.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

/* ---- the allocator behind this one ---- */

static void *(*next_malloc)(size_t);
static void *(*next_calloc)(size_t, size_t);
static void *(*next_realloc)(void *, size_t);
static void *(*next_aligned)(size_t, size_t);
static void (*next_free)(void *);

/* What is asked for while the names are looked up; never given back. */
static _Alignas(16) char early[1 << 16];
static size_t early_used;
static bool looking;

static void *
early_malloc(size_t size)
{
  size_t at = early_used;

  early_used += (size + 15) / 16 * 16;
  return early_used <= sizeof early ? early + at : NULL;
}

static bool
is_early(const void *block)
{
  const char *place = block;

  return place >= early && place < early + sizeof early;
}

static void
look_up(void)
{
  looking = true;
  *(void **)&next_malloc = dlsym(RTLD_NEXT, "malloc");
  *(void **)&next_calloc = dlsym(RTLD_NEXT, "calloc");
  *(void **)&next_realloc = dlsym(RTLD_NEXT, "realloc");
  *(void **)&next_aligned = dlsym(RTLD_NEXT, "aligned_alloc");
  *(void **)&next_free = dlsym(RTLD_NEXT, "free");
  looking = false;
}

/* False: only early blocks are there. */
static bool
ready(void)
{
  if (!next_free && !looking) {
    look_up();
  }
  return !looking;
}

/* ---- who asks, and which request fails ---- */

static uintptr_t first_byte, past_last; /* of the code whose requests count */
static atomic_long requests, fails_at;  /* 0: none fails */
static atomic_bool all_after;           /* fail too */
static atomic_int looking_for;          /* new places of these */

enum { NOTHING, QUESTIONS, REQUESTS };

static bool
is_ours(const void *caller)
{
  uintptr_t at = (uintptr_t)caller;

  return at >= first_byte && at < past_last;
}

static void note_place(long number);

/* Counts a request of ours. True: it fails. */
static bool
refused(void)
{
  long number = atomic_fetch_add(&requests, 1) + 1;

  if (atomic_load(&looking_for) == REQUESTS) {
    note_place(number);
  }
  long at = atomic_load(&fails_at);

  if (at != 0 && (number == at || (number > at && atomic_load(&all_after)))) {
    errno = ENOMEM;
    return true;
  }
  return false;
}

/* ---- places: who asks, on behalf of whom ---- */

enum { DEEP = 12, NAMED = 4, SEEN = 1 << 16 };

static uintptr_t seen[SEEN]; /* hashes of places; 0: empty */
static long *first_at;       /* numbers of what came from a new place */
static size_t firsts, first_room;
static _Thread_local bool in_note;

/* The next frames of ours, as many as name a place. */
static uintptr_t
place_here(void)
{
  void *frame[DEEP];
  int n = backtrace(frame, DEEP), named = 0;
  uintptr_t hash = 0;

  for (int i = 2; i < n && named < NAMED; i++) {
    if (is_ours(frame[i])) {
      hash = (hash ^ (uintptr_t)frame[i]) * 0x9E3779B97F4A7C15u;
      named++;
    }
  }
  return hash | 1;
}

/* Keeps the number of a question or a request that comes from a new place. Of
 * one thread only. */
static void
note_place(long number)
{
  if (in_note) {
    return;
  }
  in_note = true;
  uintptr_t place = place_here();
  size_t at = place >> 20 & (SEEN - 1);

  while (seen[at] != 0 && seen[at] != place) {
    at = (at + 1) & (SEEN - 1);
  }
  if (seen[at] == 0) {
    seen[at] = place;
    if (firsts == first_room) {
      first_room = 2 * first_room + 64;
      first_at = next_realloc(first_at, first_room * sizeof *first_at);
    }
    if (first_at) {
      first_at[firsts++] = number;
    }
  }
  in_note = false;
}

/* ---- what of ours is held ---- */

enum { PLACES = 1 << 22 };

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static uintptr_t *held; /* [PLACES]: a block, 0: empty, 1: was one */
static long holds;

static size_t
place_of(uintptr_t block)
{
  return (block >> 4) * 0x9E3779B97F4A7C15u >> 42;
}

static void
hold(void *block)
{
  pthread_mutex_lock(&lock);
  if (!held) {
    void *room = mmap(NULL, PLACES * sizeof *held, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);

    held = room == MAP_FAILED ? NULL : room;
  }
  if (held && block && holds < PLACES / 2) {
    size_t at = place_of((uintptr_t)block);

    while (held[at] > 1) {
      at = (at + 1) % PLACES;
    }
    held[at] = (uintptr_t)block;
    holds++;
  }
  pthread_mutex_unlock(&lock);
}

/* True: it was held. */
static bool
let_go(void *block)
{
  bool found = false;

  pthread_mutex_lock(&lock);
  if (held && block) {
    size_t at = place_of((uintptr_t)block);

    while (held[at] != 0 && held[at] != (uintptr_t)block) {
      at = (at + 1) % PLACES;
    }
    found = held[at] != 0;
    if (found) {
      held[at] = held[(at + 1) % PLACES] == 0 ? 0 : 1;
      holds--;
    }
  }
  pthread_mutex_unlock(&lock);
  return found;
}

/* ---- the functions that stand before the others ---- */

void *
malloc(size_t size)
{
  if (!ready()) {
    return early_malloc(size);
  }
  bool ours = is_ours(__builtin_return_address(0));

  if (ours && refused()) {
    return NULL;
  }
  void *block = next_malloc(size);

  if (ours) {
    hold(block);
  }
  return block;
}

void *
calloc(size_t n, size_t size)
{
  if (!ready()) {
    return early_malloc(n * size);
  }
  bool ours = is_ours(__builtin_return_address(0));

  if (ours && refused()) {
    return NULL;
  }
  void *block = next_calloc(n, size);

  if (ours) {
    hold(block);
  }
  return block;
}

void *
realloc(void *old, size_t size)
{
  if (!ready() || is_early(old)) {
    void *block = ready() ? next_malloc(size) : early_malloc(size);

    return old && block ? memcpy(block, old, size) : block;
  }
  bool ours = is_ours(__builtin_return_address(0));

  if (ours && refused()) {
    return NULL;
  }
  bool was_held = let_go(old);
  void *block = next_realloc(old, size);

  if (was_held || ours) {
    hold(block ? block : was_held ? old : NULL);
  }
  return block;
}

void *
aligned_alloc(size_t alignment, size_t size)
{
  bool ours = ready() && is_ours(__builtin_return_address(0));

  if (ours && refused()) {
    return NULL;
  }
  void *block = next_aligned(alignment, size);

  if (ours) {
    hold(block);
  }
  return block;
}

/* What the store takes of the system without the heap. It keeps some. */
void *
mmap(void *place, size_t size, int protection, int flags, int file, off_t from)
{
  if (ready() && is_ours(__builtin_return_address(0)) && refused()) {
    errno = ENOMEM;
    return MAP_FAILED;
  }
  return (void *)syscall(SYS_mmap, place, size, protection, flags, file, from);
}

char *
strndup(const char *text, size_t most)
{
  bool ours = ready() && is_ours(__builtin_return_address(0));
  size_t n = strnlen(text, most);
  char *copy = ours && refused() ? NULL : ready() ? next_malloc(n + 1) : NULL;

  if (!copy) {
    return NULL;
  }
  if (ours) {
    hold(copy);
  }
  copy[n] = '\0';
  return memcpy(copy, text, n);
}

char *
strdup(const char *text)
{
  size_t n = strlen(text);
  bool ours = ready() && is_ours(__builtin_return_address(0));
  char *copy = ours && refused() ? NULL : ready() ? next_malloc(n + 1) : NULL;

  if (copy && ours) {
    hold(copy);
  }
  return copy ? memcpy(copy, text, n + 1) : NULL;
}

void
free(void *block)
{
  if (block && !is_early(block) && ready()) {
    let_go(block);
    next_free(block);
  }
}

/* ---- the question of our kernels whether to stop ---- */

static atomic_long questions, stops_at; /* 0: none is answered with stop */

int
PL_handle_signals(void)
{
  static int (*next)(void);

  if (!next) {
    *(void **)&next = dlsym(RTLD_NEXT, "PL_handle_signals");
  }
  if (is_ours(__builtin_return_address(0))) {
    long number = atomic_fetch_add(&questions, 1) + 1;

    if (atomic_load(&looking_for) == QUESTIONS) {
      note_place(number);
    }
    if (number == atomic_load(&stops_at)) {
      term_t stopped = PL_new_term_ref();

      return PL_put_atom_chars(stopped, "stopped") &&
                     PL_raise_exception(stopped)
                 ? 0
                 : -1;
    }
  }
  return next();
}

/* ---- predicates, and the environment ---- */

/* Where the code of the object with this end of its name lies; the program has
 * no name, and comes first. */
static int
find_code(struct dl_phdr_info *object, size_t size, void *end)
{
  size_t n = strlen(object->dlpi_name), m = strlen(end);

  (void)size;
  if (n < m || strcmp(object->dlpi_name + n - m, end) != 0) {
    return 0;
  }
  for (int i = 0; i < object->dlpi_phnum; i++) {
    const ElfW(Phdr) *part = &object->dlpi_phdr[i];

    if (part->p_type == PT_LOAD && (part->p_flags & PF_X)) {
      first_byte = object->dlpi_addr + part->p_vaddr;
      past_last = first_byte + part->p_memsz;
      return 1;
    }
  }
  return 0;
}

__attribute__((constructor)) static void
listen(void)
{
  const char *number = getenv("FAILING_REQUEST");
  char program[] = "";

  if (number && dl_iterate_phdr(find_code, program) == 1) {
    atomic_store(&all_after, true);
    atomic_store(&fails_at, strtol(number, NULL, 10));
  }
}

/* requests_of(+Name): from now on those of the loaded object Name count. */
static foreign_t
pl_requests_of(term_t name)
{
  char *text;

  return PL_get_chars(name, &text, CVT_ATOM | CVT_EXCEPTION) &&
         dl_iterate_phdr(find_code, text) == 1;
}

/* request_fails(+N, +After): the N-th of the next requests fails, and if After
 * is 1 all after it; 0: none does. */
static foreign_t
pl_request_fails(term_t number, term_t after)
{
  int64_t n;
  int all;

  if (!PL_get_int64_ex(number, &n) || !PL_get_bool_ex(after, &all)) {
    return FALSE;
  }
  atomic_store(&fails_at, 0);
  atomic_store(&requests, 0);
  atomic_store(&all_after, all != 0);
  atomic_store(&fails_at, (long)n);
  return TRUE;
}

/* stops(+N): the N-th of the next questions is answered with stop; 0: none. */
static foreign_t
pl_stops(term_t number)
{
  int64_t n;

  if (!PL_get_int64_ex(number, &n)) {
    return FALSE;
  }
  atomic_store(&questions, 0);
  atomic_store(&stops_at, (long)n);
  return TRUE;
}

/* look_for(+What): new places of what asks from now on: 1, questions, 2,
 * requests, 0, nothing. */
static foreign_t
pl_look_for(term_t what)
{
  int sort;

  if (!PL_get_integer_ex(what, &sort)) {
    return FALSE;
  }
  firsts = 0;
  atomic_store(&looking_for, sort);
  return TRUE;
}

/* new_places(-Numbers): of the questions or requests that came from one. */
static foreign_t
pl_new_places(term_t numbers)
{
  term_t list = PL_copy_term_ref(numbers), head = PL_new_term_ref();

  for (size_t i = 0; i < firsts; i++) {
    if (!PL_unify_list(list, head, list) ||
        !PL_unify_int64(head, first_at[i])) {
      return FALSE;
    }
  }
  return PL_unify_nil(list);
}

/* requests(-Count, -Held): made since request_fails/2; blocks held in all. */
static foreign_t
pl_requests(term_t count, term_t blocks)
{
  return PL_unify_int64(count, atomic_load(&requests)) &&
         PL_unify_int64(blocks, holds);
}

install_t install(void);

install_t
install(void)
{
  PL_register_foreign("requests_of", 1, pl_requests_of, 0);
  PL_register_foreign("request_fails", 2, pl_request_fails, 0);
  PL_register_foreign("stops", 1, pl_stops, 0);
  PL_register_foreign("look_for", 1, pl_look_for, 0);
  PL_register_foreign("new_places", 1, pl_new_places, 0);
  PL_register_foreign("requests", 2, pl_requests, 0);
}
