/* symbol.c -- one hash table of texts, behind one lock. */
#include "symbol.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef struct entry {
  uint64_t hash;
  size_t length;
  int32_t chained; /* the next symbol in the same bucket, -1: none */
  char text[];
} entry;

static struct {
  pthread_mutex_t lock;
  entry **entries;    /* [room], by symbol */
  int32_t *bucket;    /* [room] */
  size_t count, room; /* room is a power of two, or 0 */
} symbols = {.lock = PTHREAD_MUTEX_INITIALIZER};

static uint64_t
hash_text(const char *text, size_t length)
{
  uint64_t h = 0xcbf29ce484222325u;

  for (size_t i = 0; i < length; i++) {
    h = (h ^ (unsigned char)text[i]) * 0x100000001b3u;
  }
  return h ^ (h >> 32);
}

static int32_t
find(const char *text, size_t length, uint64_t hash)
{
  if (symbols.room == 0) {
    return -1;
  }
  for (int32_t s = symbols.bucket[hash & (symbols.room - 1)]; s >= 0;
       s = symbols.entries[s]->chained) {
    const entry *e = symbols.entries[s];
    if (e->hash == hash && e->length == length &&
        memcmp(e->text, text, length) == 0) {
      return s;
    }
  }
  return -1;
}

static void
chain(int32_t symbol)
{
  entry *e = symbols.entries[symbol];
  int32_t *bucket = &symbols.bucket[e->hash & (symbols.room - 1)];

  e->chained = *bucket;
  *bucket = symbol;
}

static bool
make_room(void)
{
  size_t room = symbols.room ? 2 * symbols.room : 64;
  entry **entries;
  int32_t *bucket;

  if (symbols.count < symbols.room) {
    return true;
  }
  if (!(entries = realloc(symbols.entries, room * sizeof(*entries)))) {
    return false;
  }
  symbols.entries = entries;
  if (!(bucket = realloc(symbols.bucket, room * sizeof(*bucket)))) {
    return false;
  }
  symbols.bucket = bucket;
  symbols.room = room;
  memset(bucket, 0xff, room * sizeof(*bucket));
  for (size_t i = 0; i < symbols.count; i++) {
    chain((int32_t)i);
  }
  return true;
}

static int32_t
intern(const char *text, size_t length)
{
  uint64_t hash = hash_text(text, length);
  int32_t symbol = find(text, length, hash);
  entry *e;

  if (symbol >= 0) {
    return symbol;
  }
  if (symbols.count >= INT32_MAX >> 4 || !make_room() ||
      !(e = malloc(sizeof(*e) + length + 1))) {
    return -1;
  }
  e->hash = hash;
  e->length = length;
  memcpy(e->text, text, length);
  e->text[length] = '\0';
  symbol = (int32_t)symbols.count++;
  symbols.entries[symbol] = e;
  chain(symbol);
  return symbol;
}

/* The known symbols take the first numbers, whoever comes first. */
static void
enter(void)
{
  static const char *const known[] = {
#define KNOWN(ID, text) text,
      SG_SYMBOLS(KNOWN)
#undef KNOWN
  };

  pthread_mutex_lock(&symbols.lock);
  while (symbols.count < SG_KNOWN_SYMBOLS) {
    const char *text = known[symbols.count];
    if (intern(text, strlen(text)) < 0) {
      abort(); /* not even a few dozen words fit in memory */
    }
  }
}

static void
leave(void)
{
  pthread_mutex_unlock(&symbols.lock);
}

int32_t
sg_symbol_intern(const char *text, size_t length)
{
  int32_t symbol;

  enter();
  symbol = intern(text, length);
  leave();
  return symbol;
}

int32_t
sg_symbol_find(const char *text, size_t length)
{
  int32_t symbol;

  enter();
  symbol = find(text, length, hash_text(text, length));
  leave();
  return symbol;
}

const char *
sg_symbol_text(int32_t symbol, size_t *length)
{
  const entry *e;

  enter();
  e = symbols.entries[symbol];
  leave();
  if (length) {
    *length = e->length;
  }
  return e->text;
}
