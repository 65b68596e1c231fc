/* refusals.h -- memory that ends where a C test says so.
 *
 *   spare_gmp();                     // first in main()
 *   left = n; living = 0; counting = true;
 *   ...                              // allocation n, from 0, is refused
 *   left = -1; counting = false;     // and living: what was not freed
 *
 * A checker of memory may have its own allocator: ask is_counted() first.
 */
#ifndef SG_REFUSALS_H
#define SG_REFUSALS_H

#include "tests/check.h"

#include <dlfcn.h>
#include <gmp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

/* Of each thread. Volatile: a compiler may think that malloc() does not read
 * them. */
static _Thread_local volatile bool counting;
/* Allocations that will be had; below 0: all. */
static _Thread_local volatile long left = -1;
static _Thread_local volatile long living; /* allocations not yet freed */

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/* refuse.c leaves memory alone then. */
extern const bool refusals_are_counted;
const bool refusals_are_counted = true;

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *old, size_t size);
void __libc_free(void *old);

static bool
is_refused(void)
{
  return counting && left >= 0 && left-- == 0;
}

static void *
counted(void *made)
{
  living += counting && made;
  return made;
}

void *
malloc(size_t size)
{
  return is_refused() ? NULL : counted(__libc_malloc(size));
}

void *
calloc(size_t n, size_t size)
{
  return is_refused() ? NULL : counted(__libc_calloc(n, size));
}

void *
realloc(void *old, size_t size)
{
  if (is_refused()) {
    return NULL;
  }
  return old ? __libc_realloc(old, size) : counted(__libc_malloc(size));
}

/* By its own name, as a checker of leaks may stand before the system. */
void *
aligned_alloc(size_t alignment, size_t size)
{
  static void *(*next)(size_t, size_t);

  if (!next) {
    void *libc = dlopen("libc.so.6", RTLD_LAZY);

    *(void **)&next = dlsym(libc, "aligned_alloc");
  }
  return is_refused() ? NULL : counted(next(alignment, size));
}

void
free(void *old)
{
  living -= counting && old;
  __libc_free(old);
}

/* What the store takes of the system without the heap. It keeps some. */
void *
mmap(void *place, size_t size, int protection, int flags, int file, off_t from)
{
  return is_refused() ? MAP_FAILED
                      : (void *)syscall(SYS_mmap, place, size, protection,
                                        flags, file, from);
}
#endif

/* Whether the functions above are used: a checker may have its own. */
static bool
is_counted(void)
{
  void *(*volatile ask)(size_t size) = malloc; /* else it may be left out */

  counting = true;
  left = 0;
  void *made = ask(1);

  left = -1;
  free(made);
  counting = false;
  return made == NULL;
}

/* What was wrong when allocation n, from 0, was refused; *done: none was. The
 * case is made from a seed. */
typedef long refused_case(uint32_t seed, long n, bool *done);

/* Tries each case with each of its allocations refused; they are more than
 * `least` in all. */
static inline void
check_refusals(refused_case *tried, uint32_t seeds, long least)
{
  long many = 0, bad = 0;

  if (!is_counted()) {
    printf("skipped: allocations that fail: the checker has its own\n");
    return;
  }
  for (uint32_t seed = 0; seed < seeds; seed++) {
    bool done = false;

    for (long n = 0; !done; n++, many++) {
      bad += tried(seed, n, &done);
    }
  }
  CHECK("what is refused is told and nothing leaks", bad == 0);
  CHECK("there were many", many > least);
}

/* GMP ends the program without memory: it is never refused. */
static void *
big_malloc(size_t size)
{
  long kept = left;
  void *made;

  left = -1;
  made = malloc(size);
  left = kept;
  return made;
}

static void *
big_realloc(void *old, size_t before, size_t size)
{
  long kept = left;
  void *made;

  (void)before;
  left = -1;
  made = realloc(old, size);
  left = kept;
  return made;
}

static void
big_free(void *old, size_t size)
{
  (void)size;
  free(old);
}

static void
spare_gmp(void)
{
  mp_set_memory_functions(big_malloc, big_realloc, big_free);
}

#endif
