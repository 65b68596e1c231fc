/* text_limits4pl.c -- texts looked through before they are read.
 *
 * Layer: glue. See rules/limits.pl.
 */
#include <SWI-Stream.h>

#include <SWI-Prolog.h>

#include "glue.h"
#include "model/text_limits4pl.h"
#include <errno.h>
#include <string.h>
#include <unistd.h>

void sg_install_text_limits(void);

enum { CHUNK = 4096 }; /* on the stack, which may be small */

static atom_t kind_atom[3];
static functor_t FUNCTOR_fault3;

static int
get_kind_ex(term_t t, sg_text_kind *out)
{
  atom_t name;

  if (!PL_get_atom_ex(t, &name)) {
    return FALSE;
  }
  for (int k = SG_TEXT_FACTS; k <= SG_TEXT_PROGRAM; k++) {
    if (name == kind_atom[k]) {
      *out = (sg_text_kind)k;
      return TRUE;
    }
  }
  return PL_domain_error("text_kind", t);
}

int
sg_get_text_limits_ex(term_t t, sg_text_limits *out)
{
  uint64_t *const to[] = {&out->depth, &out->blocks, &out->digits,
                          &out->name,  &out->fact,   &out->file};
  term_t a = PL_new_term_ref();

  for (int k = 0; k < 6; k++) {
    int64_t value;
    if (!PL_get_arg(k + 1, t, a) || !PL_get_int64_ex(a, &value)) {
      return FALSE;
    }
    *to[k] = value > 0 ? (uint64_t)value : 0;
  }
  return TRUE;
}

/* What cannot be read here is the reader's to say. */
static int
scan_file_ex(term_t stream, sg_text_scan *scan)
{
  char bytes[CHUNK];
  IOSTREAM *in;
  int fd;
  off_t at = 0;
  ssize_t got;

  if (!PL_get_stream(stream, &in, SIO_INPUT)) {
    return FALSE;
  }
  fd = Sfileno(in);
  while ((got = pread(fd, bytes, sizeof bytes, at)) > 0 ||
         (got < 0 && errno == EINTR)) {
    if (got > 0 && !sg_text_scan_feed(scan, bytes, (size_t)got)) {
      break;
    }
    at += got > 0 ? got : 0;
    if (PL_handle_signals() < 0) {
      PL_release_stream_noerror(in);
      return FALSE;
    }
  }
  return PL_release_stream(in);
}

/* text_fault(+Kind, +Source, +Limits, -Fault) */
static foreign_t
text_fault(term_t kind_term, term_t source, term_t limits, term_t fault)
{
  sg_text_limits most;
  sg_text_kind kind = SG_TEXT_FACTS;
  sg_text_scan scan;
  size_t n;
  char *text;
  int good;

  if (!get_kind_ex(kind_term, &kind) || !sg_get_text_limits_ex(limits, &most)) {
    return FALSE;
  }
  sg_text_scan_open(&scan, kind, &most);
  if (PL_is_string(source)) {
    good =
        PL_get_nchars(source, &n, &text, CVT_STRING | CVT_EXCEPTION | REP_UTF8);
    good = good && (sg_text_scan_feed(&scan, text, n) || true);
  } else {
    good = scan_file_ex(source, &scan);
  }
  sg_text_scan_close(&scan);
  if (good && scan.fault == SG_TEXT_NO_MEMORY) {
    return sg_no_memory();
  }
  return good && scan.fault &&
         PL_unify_term(fault, PL_FUNCTOR, FUNCTOR_fault3, PL_CHARS,
                       sg_text_fault_name(scan.fault), PL_INT64,
                       (int64_t)scan.line, PL_INT64, (int64_t)scan.column);
}

static const PL_extension predicates[] = {
    {"text_fault", 4, text_fault, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_text_limits(void)
{
  static const char *const kind[] = {"facts", "goal", "program"};

  for (int k = 0; k < 3; k++) {
    kind_atom[k] = PL_new_atom(kind[k]);
  }
  FUNCTOR_fault3 = PL_new_functor(PL_new_atom("fault"), 3);
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
