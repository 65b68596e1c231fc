/* text_fuzz_test.c -- texts of every reader and goals, changed at random, in a
 * host, in a thread with a small stack: each ends soon, with a status of its
 * own, and is told of in words of ours, without control characters.
 *
 * covers: journal, visitor_answer
 *
 * TEXT_FUZZ_HOST=N asks for N cases of each kind, TEXT_FUZZ_SEED for others.
 * What fails is left in the folder that is printed; a case that takes more than
 * two seconds of processor is told of while it goes on.
 */
#include "engine/sanggwan.h"
#include "tests/check.h"

#include <ctype.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum {
  CASES = 150,
  MOST = 1 << 18, /* octets of a text */
  NAME = 200,
  STACK = 256 << 10,
  SECOND = 1000, /* ms */
  SHOWN = 20     /* failures of a kind */
};

/* How a text is read: `ending` of its file, and a goal with %s for that, or
 * null: it is loaded; or it is a goal itself. */
typedef struct kind {
  const char *name, *ending, *goal;
  const char *const *seed;
} kind;

static const char *const models[] = {
    "v(1, 1, 0, 0, 0).\nv(1, 2, 1.5, 0, 0).\nv(1, 3, 0, 1, 0).\nv(1, 4, 0, 0, "
    "1).\np(1, 1, [1,3,2]).\np(1, 2, [1,2,4]).\np(1, 3, [2,3,4]).\np(1, 4, "
    "[3,1,4]).\nsegment(1, solid, 'a b').\n",
    "param(w, 3).\nparam_about(w, [min(1), max(50), step(0.1)]).\n"
    "segment(1, solid, named(a, at([translate(1, 2, param(w)/2), "
    "turn(z, 30)], box(size(param(w), 1, 2))))).\nsegment(2, solid, "
    "difference([1, cylinder(radius(0.5), height(4), facets(8))])).\n"
    "view(30, 20, 0).\nprojection(parallel).\ntitle_block(name, \"x\").\n",
    "segment(1, solid, prism(outline([[0,0],[3,0],[0,2]]), height(2))).\n"
    "look(1, colour(rgb(200, 60, 50))).\nlight(1, picture(-5, 6, 8)).\n"
    "curve(2, [1,2,3]).\nv(2, 1, 0, 0, 0).\nv(2, 2, 1, 0, 0).\nv(2, 3, 1, 1, "
    "0).\nquestion(q, 'line(1)').\nunfolding(1, removed(base)).\n",
    NULL};
static const char *const csgs[] = {
    "group(){multmatrix([[1,0,0,1],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube(size=["
    "1,2,3],center=true);}difference(){sphere($fn=8,$fa=12,$fs=2,r=2);"
    "cylinder($fn=6,$fa=12,$fs=2,h=3,r1=1,r2=0.5,center=false);}}\n",
    "linear_extrude(height=2,twist=20,slices=3,scale=[1,2],$fn=0,$fa=12,$fs=2){"
    "polygon(points=[[0,0],[3,0],[0,3]],paths=undef,convexity=1);}\n",
    NULL};
static const char *const cities[] = {
    "{\"type\":\"CityJSON\",\"version\":\"1.1\",\"transform\":{\"scale\":[1,1,1"
    "],\"translate\":[0,0,0]},\"CityObjects\":{\"b\":{\"type\":\"Building\","
    "\"geometry\":[{\"type\":\"Solid\",\"lod\":\"1\",\"boundaries\":[[[[0,2,1]]"
    ",[[0,1,3]],[[1,2,3]],[[2,0,3]]]]}]}},\"vertices\":[[0,0,0],[1,0,0],[0,1,0]"
    ",[0,0,1]]}\n",
    NULL};
static const char *const styles[] = {
    "line(any, crease, any, [width(0.5), colour(red)]).\nline(hidden, any, 1, "
    "[dashes([2,1]), layer(a), pen(3)]).\npaper(white).\n",
    NULL};
static const char *const titles[] = {
    "title_block(name, \"a box\").\ntitle_block(drawn_by, '1:2').\n"
    "title_block(number, 12).\n",
    NULL};
static const char *const looks[] = {
    "look(2, colour(rgb(200, 60, 50))).\nlook(1, shine(0.4, 30)).\nlook(1, "
    "opacity(0.5)).\nlight(1, direction(0, 0, -1)).\n",
    NULL};
static const char *const manifests[] = {
    "defaults([time_limit(60), memory(2000), output('%.svg')]).\njob(around("
    "Degrees), draw, ['cube.pl'], [view(Degrees, 30)])\n    @ Degrees in "
    "between(0, 90, 45).\njob(figure(F), draw, [F], [hidden(removed)]) @ F in "
    "glob('cube*.pl').\njob(counts, check, ['cube.pl'], [json, set('w=3')]).\n",
    NULL};
static const char *const job_lines[] = {
    "{\"job\":\"a\\u00e9\",\"verb\":\"check\",\"files\":[\"cube.pl\"]}\n"
    "{\"job\":\"b\",\"verb\":\"draw\",\"files\":[\"cube.pl\"],\"options\":{"
    "\"view\":\"30,60\",\"output\":\"%.svg\",\"hidden\":\"removed\"}}\n",
    NULL};
static const char *const problems[] = {
    "problem(a, 'cube.pl', [ given([front, top]), blank(right), "
    "ask(draw(penetration)), ask(count(loops)), ask(measure(edge(1, 1, 5), mm, "
    "0.1)), text(en, 'Draw it.') ]).\nvariant(a, w, 1..3).\nvariant(a, h, "
    "[2, 4.5]).\nsheet('A4', [a], []).\npupils(['A', 'B c']).\n",
    NULL};
static const char *const reports[] = {
    "{\"job\":\"a\",\"number\":1,\"outcome\":\"done\",\"seconds\":1.5,"
    "\"files\":[],\"said\":[]}\n{\"job\":\"b\",\"number\":2,\"outcome\":"
    "\"failed\",\"seconds\":1,\"files\":[],\"said\":[],\"status\":1,\"error\":{"
    "\"words\":{\"en\":\"x\",\"ko\":\"y\"}}}\n",
    NULL};
static const char *const journals[] = {
    "{\"journal\":1,\"file\":\"a.pl\",\"digest\":\"d\",\"text\":\"v(1,1,0,0,0)."
    "\"}\n{\"do\":\"edit\",\"set\":{\"segment\":1,\"path\":[1,1],\"value\":2}}"
    "\n{\"do\":\"save\",\"digest\":\"d\",\"rules\":\"\"}\n{\"do\":\"undo\"}\n"
    "{\"do\":\"text\",\"text\":\"v(1,1,1,0,0).\"}\n",
    NULL};
static const char *const books[] = {
    "{\"pupil\":\"0af3\",\"name\":\"Kim\",\"turn\":0}\n{\"pupil\":\"0af3\","
    "\"problem\":\"a\",\"number\":1,\"answers\":[\"1\",2.5],\"right\":[true,"
    "false],\"shown\":false}\n{\"pupil\":\"1bf3\",\"name\":\"\\u202eLee\","
    "\"turn\":1}\n{\"pupil\":\"1bf3\",\"problem\":\"b\",\"number\":2,"
    "\"answers\":[],\"right\":[true],\"shown\":true}\n",
    NULL};
static const char *const goals[] = {
    "v(1, V, X, Y, Z), X > 0.5",
    "segment(S, K, N) ; p(1, P, [A|_])",
    "findall(V, v(1,V,_,_,_), Vs), length(Vs, N)",
    "X = f(X), assert_fact(segment(7, solid, X))",
    "X = [a|X], assert_fact(p(1, 9, X))",
    "X = [X|X], assert_fact(p(1, 9, X))",
    "numlist(1, 3000, L), foldl([_,T,f(T)]>>true, L, x, X)",
    "set_view(iso), penetrate, line(L, S, T, A, B, C, D, E, F)",
    "assert_fact(v(9, 1, 0.5, 1, -2)), retract_fact(v(9, _, _, _, _))",
    "parameter_value(w, X) ; model_defect(D), explanation(line(1), E)",
    NULL};

static const kind kinds[] = {
    {"model", "pl", NULL, models},
    {"csg", "csg", NULL, csgs},
    {"city", "json", NULL, cities},
    {"style", "pl", "sg_style_file:style_rows('%s', _)", styles},
    {"title", "pl", "sg_title_block:title_block_read('%s', _)", titles},
    {"look", "pl", "sg_look_file:look_file_added('%s', _)", looks},
    {"manifest", "pl",
     "with_output_to(string(_), sg_verbs_batch:batch_run_verb(['%s'], "
     "[list(true)], _))",
     manifests},
    {"job-lines", "jsonl",
     "with_output_to(string(_), sg_verbs_batch:batch_run_verb(['%s'], "
     "[list(true)], _))",
     job_lines},
    {"problems", "pl", "sg_problem_file:problems_read('%s', _, _)", problems},
    {"report", "jsonl",
     "F = '%s', atom_concat(F, '.xml', O), atom_concat(F, '.json', J), "
     "sg_batch_merge:reports_merged([F], [O, J])",
     reports},
    {"journal", "journal",
     "F = '%s', ignore(sg_journal:journal_steps(F, \"d\", _)), "
     "ignore(sg_journal:journal_whole(F, _, _))",
     journals},
    {"book", "answers",
     "F = '%s', sg_visitor_answer:( book_taken(F), class_book(Ps) ), "
     "with_output_to(string(_), json:json_write_dict(current_output, Ps))",
     books},
    {"goal", NULL, NULL, goals},
};

enum { KINDS = sizeof kinds / sizeof *kinds };

static const char *const words[] = {"nan",
                                    "inf",
                                    "1.0Inf",
                                    "-",
                                    "0",
                                    "1e308",
                                    "9999999",
                                    "[]",
                                    "[",
                                    "(",
                                    ")",
                                    "]",
                                    "{",
                                    "}",
                                    "'",
                                    "\"",
                                    "\\",
                                    "\xff",
                                    ",",
                                    ".",
                                    ". ",
                                    "/*",
                                    "%",
                                    "_",
                                    "X",
                                    "union(",
                                    "at([],",
                                    "0.0000001",
                                    "-0.0",
                                    "1r3",
                                    "undef",
                                    "$fn=3",
                                    "solid",
                                    "\x1b[2J",
                                    "\xe2\x80\xae",
                                    "0'",
                                    "$fn=1e9",
                                    "facets(1000000)",
                                    ":- ",
                                    "->",
                                    "\r",
                                    "null",
                                    "true",
                                    "{\"a\":1}",
                                    "\\ud800",
                                    "\\u0000",
                                    "1e400",
                                    "'\\x1b\\[2J'",
                                    "\"\\u001b[2J\"",
                                    "pi",
                                    "param(",
                                    "+",
                                    "_{a:1}",
                                    "..",
                                    " in ",
                                    "@ ",
                                    "|",
                                    "123456789012345678901234567890",
                                    "#",
                                    "''",
                                    "\"\""};

enum { WORDS = sizeof words / sizeof *words };

/* What is repeated, and how often. */
static const char *const piled[] = {
    "[", "(",  "{",       "- ", "f(",   "9",  "[1,", "{\"a\":",
    "a", "1,", "\\x41\\", "a:", "1 + ", "\n", "\"",  "[[],"};

static char folder[] = "/tmp/sanggwan_texts_XXXXXX";
static uint32_t seed;
static long cases = CASES;

typedef struct text {
  char at[MOST + 1];
  size_t n;
} text;

static void
insert(text *t, size_t at, const char *what, size_t n)
{
  if (t->n + n <= MOST) {
    memmove(t->at + at + n, t->at + at, t->n - at);
    memcpy(t->at + at, what, n);
    t->n += n;
  }
}

static void
pile(text *t, size_t at)
{
  static const int often[] = {5, 100, 150, 2000, 12000};
  const char *what = piled[check_below(&seed, sizeof piled / sizeof *piled)];

  for (int i = often[check_below(&seed, 5)]; i > 0; i--) {
    insert(t, at, what, strlen(what));
  }
}

/* Another value where one stands: the syntax mostly stays. */
static void
change_value(text *t)
{
  static const char *const value[] = {"_",
                                      "[]",
                                      "foo(bar)",
                                      "'\\x1b\\[2J'",
                                      "1.0Inf",
                                      "\"t\"",
                                      "-1",
                                      "X",
                                      "0",
                                      "1e308",
                                      "-0.0",
                                      "2147483648",
                                      "1r3",
                                      "a",
                                      "[1,2]",
                                      "[[]]",
                                      "null",
                                      "true",
                                      "0.1",
                                      "''",
                                      "{\"a\":[1]}",
                                      "\"\\u001b[2J\"",
                                      "1e400",
                                      "f(_)",
                                      "a:b",
                                      "\"\"",
                                      "1000000000000000000000",
                                      "-7.5",
                                      "_{a:1}",
                                      "pi",
                                      "param(w)",
                                      "1 + 2",
                                      "[a|b]",
                                      "\"\\ud83d\"",
                                      "1.5e-320",
                                      "{}",
                                      "nan"};
  size_t at = (size_t)check_below(&seed, (int)t->n + 1), end;

  while (at < t->n && !isalnum((unsigned char)t->at[at])) {
    at++;
  }
  end = at;
  while (end < t->n &&
         (isalnum((unsigned char)t->at[end]) || strchr("._", t->at[end]))) {
    end++;
  }
  memmove(t->at + at, t->at + end, t->n - end);
  t->n -= end - at;
  const char *other = value[check_below(&seed, sizeof value / sizeof *value)];
  insert(t, at, other, strlen(other));
}

static void
change_once(text *t)
{
  size_t at = (size_t)check_below(&seed, (int)t->n + 1), n = t->n - at;
  size_t some = 1 + (size_t)check_below(&seed, 40);
  char copy[40];
  const char *word = words[check_below(&seed, WORDS)];

  some = some < n ? some : n;
  memcpy(copy, t->at + at, some < sizeof copy ? some : sizeof copy);
  switch (check_below(&seed, 10)) {
  case 0:
    t->at[at] = n > 0 ? (char)(1 + check_below(&seed, 255)) : t->at[at];
    break;
  case 1:
    memmove(t->at + at, t->at + at + some, n - some);
    t->n -= some;
    break;
  case 2:
    insert(t, (size_t)check_below(&seed, (int)t->n + 1), copy, some);
    break;
  case 3:
    t->n = check_below(&seed, 3) ? t->n : at;
    break;
  case 4:
    pile(t, at);
    break;
  default:
    insert(t, at, word, strlen(word));
  }
}

static void
make_text(const kind *k, text *t)
{
  int seeds = 0;

  while (k->seed[seeds]) {
    seeds++;
  }
  const char *from = k->seed[check_below(&seed, seeds)];

  t->n = strlen(from);
  memcpy(t->at, from, t->n);
  for (int i = check_below(&seed, 4); i > 0; i--) {
    (check_below(&seed, 3) ? change_value : change_once)(t);
  }
  t->at[t->n] = '\0';
  for (size_t i = 0; !k->ending && i < t->n; i++) {
    t->at[i] = t->at[i] ? t->at[i] : ' ';
  }
}

/* ---- what is said -------------------------------------------------------- */

static bool
has_raw(const char *said)
{
  static const char *const raw[] = {"Unknown procedure", "tack limit",
                                    "I/O error",         "Domain error",
                                    "Type error",        "sg_",
                                    "No permission to",  "Arguments are not",
                                    "unexpectedly",      "error(",
                                    "Unknown message",   "existence_error",
                                    "type_error"};

  for (size_t i = 0; i < sizeof raw / sizeof *raw; i++) {
    if (strstr(said, raw[i])) {
      return true;
    }
  }
  return false;
}

static bool
has_control(const char *said)
{
  const unsigned char *c = (const unsigned char *)said;

  for (; *c; c++) {
    if ((*c < 0x20 && *c != '\n') || *c == 0x7f ||
        (c[0] == 0xc2 && c[1] >= 0x80 && c[1] < 0xa0) ||
        (c[0] == 0xe2 && c[1] == 0x80 &&
         (c[2] == 0x8e || c[2] == 0x8f || (c[2] >= 0xaa && c[2] <= 0xae))) ||
        (c[0] == 0xe2 && c[1] == 0x81 && c[2] >= 0xa6 && c[2] <= 0xa9)) {
      return true;
    }
  }
  return false;
}

static const char *
fault_of(const kind *k, sanggwan_status status, const char *said, long ms)
{
  if (status != SANGGWAN_DONE && status != SANGGWAN_NO &&
      status != SANGGWAN_USAGE && status != SANGGWAN_INPUT &&
      status != SANGGWAN_IMPOSSIBLE) {
    return "a status";
  }
  if (status == SANGGWAN_NO && k->ending) {
    return "a reader that fails";
  }
  if (status > SANGGWAN_NO && !*said) {
    return "nothing said";
  }
  if (has_raw(said)) {
    return "words of Prolog";
  }
  if (has_control(said)) {
    return "control characters";
  }
  if (strlen(said) > 8000) {
    return "a long message";
  }
  return ms > SECOND ? "a stall" : NULL;
}

/* ---- the cases ----------------------------------------------------------- */

static bool
write_text(const char *path, const text *t)
{
  FILE *out = fopen(path, "w");
  bool good = out && fwrite(t->at, 1, t->n, out) == t->n;

  return out && fclose(out) == 0 && good;
}

/* Some answers, and their texts. */
static sanggwan_status
ask(sanggwan_world *world, const char *goal)
{
  sanggwan_query *q = sanggwan_ask(world, goal);
  sanggwan_status status = q ? SANGGWAN_DONE : SANGGWAN_USAGE;

  for (int i = 0; q && i < 20 && status == SANGGWAN_DONE; i++) {
    status = sanggwan_next(q);
    for (int c = 0; status == SANGGWAN_DONE && c < sanggwan_columns(q); c++) {
      (void)sanggwan_text(q, c);
    }
  }
  sanggwan_query_close(q);
  return status;
}

static sanggwan_status
use(const kind *k, sanggwan_world *world, const text *t, const char *path)
{
  char goal[2 * NAME + 200];

  if (!k->ending) {
    return ask(world, t->at);
  }
  if (!k->goal) {
    return sanggwan_load(world, path);
  }
  snprintf(goal, sizeof goal, k->goal, path);
  return sanggwan_run(world, goal);
}

/* How many were read, and were not right. */
typedef struct counts {
  unsigned read, bad;
} counts;

/* What is under way, for the thread that watches. */
static struct {
  pthread_mutex_t lock;
  clockid_t clock;  /* of the thread that works */
  const kind *kind; /* null between cases */
  const text *text;
  long number, until; /* ms; 0: told already */
} now = {.lock = PTHREAD_MUTEX_INITIALIZER};

static long
on_clock(clockid_t clock)
{
  struct timespec t;

  clock_gettime(clock, &t);
  return t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

static void
under_way(const kind *k, long number, const text *t)
{
  pthread_mutex_lock(&now.lock);
  now.kind = k;
  now.number = number;
  now.text = t;
  pthread_getcpuclockid(pthread_self(), &now.clock);
  now.until = on_clock(now.clock) + 2 * SECOND;
  pthread_mutex_unlock(&now.lock);
}

static void *
watch(void *unused)
{
  for (;;) {
    usleep(200000);
    pthread_mutex_lock(&now.lock);
    if (now.kind && now.until > 0 && on_clock(now.clock) > now.until) {
      fprintf(stderr, "%s: case %ld takes over 2 s: %.2000s\n", now.kind->name,
              now.number, now.text->at);
      now.until = 0;
    }
    pthread_mutex_unlock(&now.lock);
  }
  return unused;
}

static void
run_case(const kind *k, long number, text *t, counts *count)
{
  char path[NAME];
  sanggwan_world *world = sanggwan_open();

  make_text(k, t);
  snprintf(path, sizeof path, "%s/%s.%s", folder, k->name,
           k->ending ? k->ending : "txt");
  if (!CHECK("a file", write_text(path, t) && world)) {
    return;
  }
  if (!k->ending || k->seed == looks) {
    sanggwan_load(world, "facts/two_cubes.pl");
  }
  long before = on_clock(CLOCK_THREAD_CPUTIME_ID);
  under_way(k, number, t);
  sanggwan_status status = use(k, world, t, path);
  under_way(NULL, number, t);
  long ms = on_clock(CLOCK_THREAD_CPUTIME_ID) - before;
  const char *said = sanggwan_message(world);
  const char *fault = fault_of(k, status, said, ms);

  count->read += status == SANGGWAN_DONE || !k->ending;
  if (getenv("TEXT_FUZZ_SAID")) {
    printf("%s %d: %s\n", k->name, (int)status, said);
  }
  if (fault && ++count->bad <= SHOWN) {
    char keep[NAME];

    snprintf(keep, sizeof keep, "%s/case-%s-%ld", folder, k->name, number);
    write_text(keep, t);
    fprintf(stderr, "%s: %s (status %d, %ld ms): %.300s\n", keep, fault,
            (int)status, ms, said);
  }
  sanggwan_close(world);
}

/* Texts of long and of deep answers, in a thread with a small stack. */
static void
long_texts(void)
{
  sanggwan_world *world = sanggwan_open();
  sanggwan_query *q = sanggwan_ask(
      world, "numlist(1, 20000, L), foldl([_,T,f(T)]>>true, L, x, Deep), "
             "length(P, 90), foldl([_,T,f(T)]>>true, P, x, Flat)");

  CHECK("an answer", sanggwan_next(q) == SANGGWAN_DONE);
  const char *all = sanggwan_text(q, sanggwan_column(q, "L"));
  const char *flat = sanggwan_text(q, sanggwan_column(q, "Flat"));

  CHECK("a long list", all && strlen(all) == 108895);
  CHECK("a term that is not deep", flat && strlen(flat) == 3 * 90 + 1);
  CHECK("a deep one", !sanggwan_text(q, sanggwan_column(q, "Deep")));
  sanggwan_query_close(q);
  sanggwan_close(world);
}

static void *
run_kind(void *which)
{
  const kind *k = which;
  text *t = malloc(sizeof *t);
  counts count = {0};

  CHECK("a thread", t && sanggwan_attach() == SANGGWAN_DONE);
  if (!k->ending) {
    long_texts();
  }
  for (long i = 0; t && i < cases; i++) {
    run_case(k, i, t, &count);
  }
  sanggwan_detach();
  free(t);
  CHECK(k->name, count.bad == 0);
  CHECK("some are read", count.read > 0);
  printf("counted: %ld of %s, %u read, %u at fault\n", cases, k->name,
         count.read, count.bad);
  return NULL;
}

static bool
in_thread(const kind *k)
{
  pthread_t thread;
  pthread_attr_t small;

  return pthread_attr_init(&small) == 0 &&
         pthread_attr_setstacksize(&small, STACK) == 0 &&
         pthread_create(&thread, &small, run_kind, (void *)k) == 0 &&
         pthread_join(thread, NULL) == 0;
}

int
main(int argc, char **argv)
{
  const char *wanted = getenv("TEXT_FUZZ_HOST"),
             *other = getenv("TEXT_FUZZ_SEED");
  char command[2 * NAME];

  cases = wanted ? strtol(wanted, NULL, 10) : CASES;
  if (!mkdtemp(folder) || sanggwan_start() != SANGGWAN_DONE) {
    return 1;
  }
  sanggwan_world *world = sanggwan_open();
  pthread_t watcher;

  CHECK("a watcher", pthread_create(&watcher, NULL, watch, NULL) == 0);
  CHECK("all rules",
        sanggwan_run(world, "sg_part:whole_program") == SANGGWAN_DONE);
  CHECK("few jobs",
        sanggwan_run(world, "set_limit(values, 1000)") == SANGGWAN_DONE);
  sanggwan_close(world);
  snprintf(command, sizeof command, "cp facts/cube.pl %s", folder);
  CHECK("a model", system(command) == 0);
  for (int i = 0; i < KINDS; i++) {
    if (argc < 2 || strcmp(argv[1], kinds[i].name) == 0) {
      seed = (uint32_t)(other ? strtol(other, NULL, 10) : 16) + (uint32_t)i;
      CHECK("in a thread", in_thread(&kinds[i]));
    }
  }
  if (check_failed == 0) {
    snprintf(command, sizeof command, "rm -r %s", folder);
    CHECK("nothing left", system(command) == 0);
  }
  return check_report();
}
