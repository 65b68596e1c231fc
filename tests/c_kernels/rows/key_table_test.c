/* Key tables: round coordinates, as keys, are spread over the table. */
#include "rows/key_table.h"
#include "tests/check.h"

#include <string.h>

/* The longest run of slots that are taken, one after another: what a search
 * goes through at most. */
static size_t
longest_run(const sg_key_table *table)
{
  size_t run = 0, longest = 0;

  for (size_t i = 0; i < table->room; i++) {
    bool taken =
        table->slot[i * (table->words + 1) + table->words] != SG_NO_KEY;

    run = taken ? run + 1 : 0;
    longest = run > longest ? run : longest;
  }
  return longest;
}

/* That of a table of a grid of n[0] * n[1] * n[2] points; 0: it is wrong. */
static size_t
run_of_grid(const int n[3], double step)
{
  sg_key_table table;
  uint32_t count = 0, key[6];
  bool good = true;

  sg_key_table_init(&table, 6);
  for (int i = 0; i < n[0] * n[1] * n[2]; i++) {
    double at[3] = {i % n[0] * step, i / n[0] % n[1] * step,
                    i / n[0] / n[1] * step};
    memcpy(key, at, sizeof at);
    uint32_t *number = sg_key_table_put(&table, key);
    good = good && number && *number == SG_NO_KEY;
    *number = count++;
  }
  size_t run = good && table.n == count ? longest_run(&table) : 0;

  sg_key_table_clear(&table);
  return run;
}

/* A table that is used again forgets its keys, and gives back much memory. */
static void
empties(void)
{
  sg_key_table table;
  uint32_t count = 100;
  bool gone = true;

  sg_key_table_init(&table, 1);
  sg_key_table_empty(&table, 0);
  for (uint32_t k = 0; k < count; k++) {
    sg_key_table_add(&table, &k);
  }
  size_t room = table.room;

  sg_key_table_empty(&table, room);
  for (uint32_t k = 0; k < count; k++) {
    gone = gone && sg_key_table_get(&table, &k) == SG_NO_KEY;
  }
  CHECK("empty", gone && table.n == 0 && table.room == room);
  CHECK("used again", sg_key_table_add(&table, &count) && table.n == 1);
  sg_key_table_empty(&table, room - 1);
  CHECK("memory given back", table.room == 0 && table.words == 1);
  sg_key_table_clear(&table);
}

int
main(void)
{
  empties();
  static const int grid[][3] = {
      {1, 1, 2000}, {2000, 1, 1}, {10, 10, 200}, {30, 30, 30}, {100, 1, 100}};
  static const double step[] = {1, 0.0625, 0.1};

  for (size_t i = 0; i < 15; i++) {
    size_t run = run_of_grid(grid[i / 3], step[i % 3]);

    CHECK("every point is there, and soon found", run > 0 && run < 100);
  }
  return check_report();
}
