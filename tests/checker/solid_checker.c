/* solid_checker -- is a mesh the boundary of a solid? Independent of the
 * engine.
 *
 *   solid_checker [-i] [-q] [-v] FILE...
 *
 * One line for each file, OFF or STL. Points in one place are one; with
 * -i they are what the file says, and the surface must be a 2-manifold. With -q
 * pairs of triangles and turning are left out; with -v the pairs that meet are
 * printed. Exit status: 0 if no file has a
 * fault, 1 if one has, 2 if one cannot be read.
 *
 * A line is FILE: then words KEY=VALUE: counts of triangles, faces, vertices -
 * edges + triangles (euler), components; good=yes if nothing was wrong, then
 * faults by their number (0 is good), volume and area. Pairs of triangles that
 * have more than shared corners and edges in common are crossing=, overlap=,
 * in_line= or in_point=; the last alone, and shared= edges of four triangles
 * and pinched= vertices, are no faults unless -i is given.
 */
#include "faults.h"
#include "meeting.h"

#include <stdio.h>
#include <string.h>

static bool
is_good(const faults *f, bool manifold)
{
  return f->open == 0 && f->unbalanced == 0 && f->zero_area == 0 &&
         f->meeting[CROSSING] == 0 && f->meeting[OVERLAP] == 0 &&
         f->meeting[IN_LINE] == 0 && f->misturned == 0 &&
         (!manifold || (f->shared == 0 && f->pinched == 0));
}

static void
print_line(const char *file, const soup *s, const faults *f, bool good)
{
  printf("%s: good=%s closed=%s triangles=%zu faces=%zu euler=%ld "
         "components=%zu open=%zu unbalanced=%zu shared=%zu pinched=%zu "
         "zero_area=%zu crossing=%zu overlap=%zu in_line=%zu in_point=%zu "
         "misturned=%zu unclear=%zu volume=%.17g area=%.17g\n",
         file, good ? "yes" : "no", f->unbalanced == 0 ? "yes" : "no",
         s->triangles, s->faces, f->euler, f->components, f->open,
         f->unbalanced, f->shared, f->pinched, f->zero_area,
         f->meeting[CROSSING], f->meeting[OVERLAP], f->meeting[IN_LINE],
         f->meeting[IN_POINT], f->misturned, s->unclear, f->volume, f->area);
}

static int
check_file(const char *file, bool by_number, bool quick, FILE *pairs)
{
  soup s;
  faults f = {0};
  const char *problem;
  bool good;

  if (!soup_read(&s, file, &problem)) {
    printf("%s: unreadable: %s\n", file, problem);
    soup_clear(&s);
    return 2;
  }
  if (!by_number) {
    soup_merge(&s);
  }
  faults_of_edges(&f, &s);
  measures_of(&f, &s);
  if (!quick) {
    if (by_number) {
      soup_merge(&s); /* copies of a point are no crossing */
    }
    faults_of_pairs(&f, &s, pairs);
    faults_of_turning(&f, &s);
  }
  good = is_good(&f, by_number);
  print_line(file, &s, &f, good);
  soup_clear(&s);
  return !good;
}

int
main(int argc, char **argv)
{
  bool by_number = false, quick = false;
  FILE *pairs = NULL;
  int worst = 0, first = 1;

  for (; first < argc && argv[first][0] == '-'; first++) {
    by_number = by_number || strcmp(argv[first], "-i") == 0;
    quick = quick || strcmp(argv[first], "-q") == 0;
    pairs = strcmp(argv[first], "-v") == 0 ? stdout : pairs;
  }
  for (int i = first; i < argc; i++) {
    int status = check_file(argv[i], by_number, quick, pairs);

    worst = status > worst ? status : worst;
  }
  return worst;
}
