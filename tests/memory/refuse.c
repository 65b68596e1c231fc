/* refuse.c -- see refuse.h. */
#include "refuse.h"

#include <errno.h>
#include <stdatomic.h>
#include <stddef.h>

void *__real_malloc(size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *old, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *old, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);

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

void *
__wrap_malloc(size_t size)
{
  return is_refused() ? NULL : __real_malloc(size);
}

void *
__wrap_calloc(size_t n, size_t size)
{
  return is_refused() ? NULL : __real_calloc(n, size);
}

void *
__wrap_realloc(void *old, size_t size)
{
  return is_refused() ? NULL : __real_realloc(old, size);
}

void *
__wrap_aligned_alloc(size_t alignment, size_t size)
{
  return is_refused() ? NULL : __real_aligned_alloc(alignment, size);
}
