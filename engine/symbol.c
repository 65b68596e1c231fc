/* symbol.c -- one hash table of texts, behind one lock. */
#include "symbol.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef struct entry {
  uint64_t hash;
  size_t length;
  int32_t chained; /* the next symbol in the same bucket, and 1; 0: none */
  const char *text;
} entry;

/* Where the first symbols stand: the known ones need no memory. */
enum { FIRST_ROOM = 64 };
_Static_assert((int)SG_KNOWN_SYMBOLS < (int)FIRST_ROOM,
               "known symbols have room");
static entry known_entry[SG_KNOWN_SYMBOLS];
static entry *first_entries[FIRST_ROOM];
static int32_t first_bucket[FIRST_ROOM];

static struct {
  pthread_mutex_t lock;
  entry **entries;    /* [room], by symbol */
  int32_t *bucket;    /* [room], as entry.chained */
  size_t count, room; /* room is a power of two */
} symbols = {.lock = PTHREAD_MUTEX_INITIALIZER,
             .entries = first_entries,
             .bucket = first_bucket,
             .room = FIRST_ROOM};

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
  for (int32_t s = symbols.bucket[hash & (symbols.room - 1)]; s > 0;
       s = symbols.entries[s - 1]->chained) {
    const entry *e = symbols.entries[s - 1];
    if (e->hash == hash && e->length == length &&
        memcmp(e->text, text, length) == 0) {
      return s - 1;
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
  *bucket = symbol + 1;
}

static int32_t
add(entry *e)
{
  int32_t symbol = (int32_t)symbols.count++;

  symbols.entries[symbol] = e;
  chain(symbol);
  return symbol;
}

static bool
make_room(void)
{
  size_t room = 2 * symbols.room;

  if (symbols.count < symbols.room) {
    return true;
  }
  entry **entries = malloc(room * sizeof(*entries));
  int32_t *bucket = calloc(room, sizeof(*bucket));

  if (!entries || !bucket) {
    free(entries);
    free(bucket);
    return false;
  }
  memcpy(entries, symbols.entries, symbols.count * sizeof(*entries));
  if (symbols.entries != first_entries) {
    free(symbols.entries);
    free(symbols.bucket);
  }
  symbols.entries = entries;
  symbols.bucket = bucket;
  symbols.room = room;
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
  char *copy;

  if (symbol >= 0) {
    return symbol;
  }
  if (symbols.count >= INT32_MAX >> 4 || !make_room() ||
      !(e = malloc(sizeof(*e) + length + 1))) {
    return -1;
  }
  copy = (char *)(e + 1);
  memcpy(copy, text, length);
  copy[length] = '\0';
  *e = (entry){.hash = hash, .length = length, .text = copy};
  return add(e);
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
    size_t length = strlen(text);
    entry *e = &known_entry[symbols.count];

    *e = (entry){
        .hash = hash_text(text, length), .length = length, .text = text};
    add(e);
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
