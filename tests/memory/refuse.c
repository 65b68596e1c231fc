/* refuse.c -- see refuse.h. */
#include "refuse.h"

#include <errno.h>
#include <malloc.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

/* What was not set is no zero and, as an index, is nowhere; so are BEHIND
 * octets after it. */
enum { UNSET = 0xfb, BEHIND = 64, MOST_SET = 1 << 26 };

void *__real_malloc(size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *old, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void __real_free(void *memory);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *old, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);
void __wrap_free(void *memory);

static atomic_long left = -1; /* below 0: none is refused, or it has been */

static bool
is_refused(void)
{
  bool is = atomic_load(&left) >= 0 && atomic_fetch_sub(&left, 1) == 0;

  errno = is ? ENOMEM : errno;
  return is;
}

void
refuse_after(long n)
{
  atomic_store(&left, n);
}

bool
refuse_no_more(void)
{
  return atomic_exchange(&left, -1) < 0;
}

/* Of a test that has an allocator of its own (refusals.h). */
extern const bool refusals_are_counted __attribute__((weak));

/* A checker of memory sees more if it is left alone. */
static bool
is_checked(void)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#else
  static atomic_int is;
  int known = atomic_load(&is);

  if (known == 0) {
    known = getenv("RUN") || &refusals_are_counted ? 2 : 1;
    atomic_store(&is, known);
  }
  return known == 2;
#endif
}

/* The last octets behind, by which memory is known here if its size is told
 * exactly. */
static uint64_t
mark_of(const char *memory)
{
  return UINT64_C(0x5a17ed9b3c6f2481) ^ (uintptr_t)memory;
}

/* Ends the test if something was written behind memory of this size. */
static void
look_behind(const char *memory, size_t size)
{
  uint64_t mark;

  if (size < BEHIND) {
    return;
  }
  memcpy(&mark, memory + size - sizeof mark, sizeof mark);
  for (size_t i = size - BEHIND;
       mark == mark_of(memory) && i < size - sizeof mark; i++) {
    if ((unsigned char)memory[i] != UNSET) {
      static const char what[] = "something is written behind its memory\n";

      (void)!write(2, what, sizeof what - 1);
      abort();
    }
  }
}

/* From `set` on nothing was set; what is very large only behind it. */
static void *
unset(char *memory, size_t set, size_t size)
{
  set = size - set > MOST_SET ? size : set;
  if (memory) {
    uint64_t mark = mark_of(memory);

    memset(memory + set, UNSET, size - set + BEHIND);
    memcpy(memory + size + BEHIND - sizeof mark, &mark, sizeof mark);
  }
  return memory;
}

static bool
has_room_behind(size_t size)
{
  return size < PTRDIFF_MAX - BEHIND && !is_checked();
}

void *
__wrap_malloc(size_t size)
{
  return is_refused() ? NULL
         : !has_room_behind(size)
             ? __real_malloc(size)
             : unset(__real_malloc(size + BEHIND), 0, size);
}

void *
__wrap_calloc(size_t n, size_t size)
{
  size_t all;

  if (is_refused()) {
    return NULL;
  }
  if (__builtin_mul_overflow(n, size, &all) || !has_room_behind(all)) {
    return __real_calloc(n, size);
  }
  return unset(__real_calloc(1, all + BEHIND), all, all);
}

void *
__wrap_realloc(void *old, size_t size)
{
  if (is_refused()) {
    return NULL;
  }
  if (!has_room_behind(size)) {
    return __real_realloc(old, size);
  }
  size_t set = old ? malloc_usable_size(old) : 0;

  look_behind(old, set);
  return unset(__real_realloc(old, size + BEHIND), set < size ? set : size,
               size);
}

void *
__wrap_aligned_alloc(size_t alignment, size_t size)
{
  void *memory = is_refused() ? NULL : __real_aligned_alloc(alignment, size);

  if (memory && size <= MOST_SET && !is_checked()) {
    memset(memory, UNSET, size);
  }
  return memory;
}

void
__wrap_free(void *memory)
{
  size_t size = memory && !is_checked() ? malloc_usable_size(memory) : 0;

  if (size > 0) { /* also its mark is gone */
    size_t from = size > MOST_SET ? size - BEHIND : 0;

    look_behind(memory, size);
    memset((char *)memory + from, UNSET, size - from);
  }
  __real_free(memory);
}
